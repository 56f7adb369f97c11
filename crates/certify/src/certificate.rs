//! The certificate as text: the statement, and a row for each interval with its witnesses. The README in
//! `expected/certificate/` explains the columns.

use crate::resonance::{EnclosedResonance, NAMES};
use crate::row::{Block, CertificateRow, Clearance, IntervalVerdict, Witness};
use crate::statement::{Statement, WIDTH_PLACES};

/// The columns of `rows.csv`.
pub const COLUMNS: &str = "p,left,level,base,verdict,lower_0,lower_1,lower_2,upper_0,upper_1,upper_2,\
    touch_0,touch_1,cells,start,end,blocks,reason";

/// Lines under a heading.
fn lines(heading: &str, lines: impl Iterator<Item = String>) -> String {
    lines.fold(format!("{heading}\n"), |text, line| text + &line + "\n")
}

/// The cells of a witness, empty if there is none.
fn cells<const N: usize>(witness: Option<Witness<N>>) -> String {
    witness.map_or_else(|| [""; N].join(","), |numbers| numbers.map(|number| number.to_string()).join(","))
}

/// The cells of a proof that motion does not touch the wall.
fn clearance(Clearance { cells, start, end, blocks, .. }: &Clearance) -> String {
    let block =
        |Block { first, last, nearest: [time, slope], .. }: &Block| format!("{first}:{last}:{time}:{slope}");
    format!("{cells},{start},{end},{}", blocks.iter().map(block).collect::<Vec<_>>().join(";"))
}

/// The text of `rows.csv`.
pub fn rows(rows: &[CertificateRow]) -> String {
    let line =
        |CertificateRow { interval, verdict, lower, upper, touch, clearance: clear }: &CertificateRow| {
            let (word, reason) = match *verdict {
                IntervalVerdict::Stable => ("stable", String::new()),
                IntervalVerdict::None => ("none", String::new()),
                IntervalVerdict::Thin => ("thin", String::new()),
                IntervalVerdict::Point(name) => (name, String::new()),
                IntervalVerdict::Undecided(reason) => ("undecided", reason.to_string()),
            };
            let place = [interval.p, interval.left, interval.level.into(), interval.base as i64];
            let place = place.map(|number| number.to_string()).join(",");
            let witnesses = [cells(*lower), cells(*upper), cells(*touch)].join(",");
            let clear = clear.as_ref().map_or_else(|| ",,,".to_owned(), clearance);
            [&place, word, &witnesses, &clear, &reason].join(",")
        };
    lines(COLUMNS, rows.iter().map(line))
}

/// A checksum that changes whenever one byte changes: the bytes as digits in base 257, modulo 2⁶¹ − 1.
fn checksum(text: &str) -> u64 {
    let prime = (1_u128 << 61) - 1;
    text.bytes().fold(0, |sum, byte| (sum * 257 + u128::from(byte)) % prime) as u64
}

/// The text of `statement.csv`: constants and window, the number of points in the window
/// ([`points`](crate::summary::points)), and a checksum of the contents of the three files.
pub fn statement(statement: &Statement, points: usize, resonances: &str, rows: &str) -> String {
    let Statement { zeta, epsilon, frequency, amplitude, loops, .. } = statement;
    let ([lowest, highest], [low, high]) = (frequency, amplitude);
    let loops: Vec<String> = loops.iter().map(u32::to_string).collect();
    let stated = format!(
        "name,value\nzeta,{zeta}\nepsilon,{epsilon}\nomega_lowest,{lowest}\nomega_highest,{highest}\n\
         amplitude_lowest,{low}\namplitude,{high}\nwidth,1e-{WIDTH_PLACES}\nloops,{}\npoints,{points}\n",
        loops.join(" "),
    );
    format!("{stated}checksum,{}\n", checksum(&(stated.clone() + resonances + rows)))
}

/// The text of `resonances.csv`: the certain digits of each number, at most twenty.
pub fn resonances(resonances: &[EnclosedResonance]) -> String {
    let line = |found: &EnclosedResonance| {
        let numbers = found.numbers.map(|number| number.to_string()).join(",");
        format!("{},{},{numbers},{}", found.p, found.n, found.missing.join("; "))
    };
    lines(&format!("p,n,{},not_shown", NAMES.join(",")), resonances.iter().map(line))
}
