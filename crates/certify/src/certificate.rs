//! The certificate as text: what is stated, and a row for each interval with its witnesses. Its
//! README, in `certificate/`, has the columns.

use core::fmt::Write;

use crate::WIDTH_PLACES;
use crate::resonance::Resonance;
use crate::row::{Clearance, Row, Verdict};
use crate::statement::Statement;

/// The columns of `rows.csv`.
pub const COLUMNS: &str = "p,left,level,base,verdict,turn,lower_0,lower_1,lower_2,upper_0,upper_1,upper_2,\
    touch_0,touch_1,cells,start,end,blocks,reason";

/// Numbers separated by commas; as many empty cells if there are none.
fn cells<const N: usize>(numbers: Option<&[i128; N]>) -> String {
    let cells: [String; N] =
        core::array::from_fn(|i| numbers.map(|numbers| numbers[i].to_string()).unwrap_or_default());
    cells.join(",")
}

/// The columns of how it is shown that the wall is not touched.
fn clearance(clearance: Option<&Clearance>) -> String {
    let Some(Clearance { cells, start, end, blocks }) = clearance else { return ",,,".to_owned() };
    let blocks: Vec<String> = blocks
        .iter()
        .map(|block| format!("{}:{}:{}:{}", block.first, block.last, block.nearest[0], block.nearest[1]))
        .collect();
    format!("{cells},{start},{end},{}", blocks.join(";"))
}

/// `rows.csv`.
pub fn rows(rows: &[Row]) -> String {
    let mut text = format!("{COLUMNS}\n");
    for Row { interval, verdict } in rows {
        let (mut turn, mut reason) = (String::new(), "");
        let (mut lower, mut upper, mut touch, mut clear) = (None, None, None, None);
        match verdict {
            Verdict::Tube { lower: a, upper: b, touch: time, clearance, .. } => {
                (lower, upper, touch, clear) = (Some(a), Some(b), Some(time), Some(clearance));
            }
            Verdict::Edge { lower: a, clearance } => (lower, clear) = (Some(a), Some(clearance)),
            Verdict::Empty { upper: b, touch: time } => (upper, touch) = (Some(b), Some(time)),
            Verdict::Blocked { turn: whole } => turn = whole.to_string(),
            Verdict::Crossing { clearance } => clear = Some(clearance),
            Verdict::Undecided(why) => reason = why,
        }
        let _ = writeln!(
            text,
            "{},{},{},{},{},{turn},{},{},{},{},{reason}",
            interval.p,
            interval.left,
            interval.level,
            interval.base as i64,
            verdict.name(),
            cells(lower),
            cells(upper),
            cells(touch),
            clearance(clear),
        );
    }
    text
}

/// A checksum that any change of one byte changes: the bytes as digits in base 257, modulo 2⁶¹ − 1.
pub fn checksum(text: &str) -> u64 {
    let prime = (1_u128 << 61) - 1;
    text.bytes().fold(0, |sum, byte| (sum * 257 + u128::from(byte)) % prime) as u64
}

/// `statement.csv`: constants and window, how many points are proved to exist where GZ curves end or
/// meet, and a checksum of all that is in the three files.
pub fn statement(statement: &Statement, points: usize, resonances: &str, rows: &str) -> String {
    let Statement { zeta, epsilon, frequency: [lowest, highest], amplitude, loops } = statement;
    let loops: Vec<String> = loops.iter().map(u32::to_string).collect();
    let stated = format!(
        "name,value\nzeta,{zeta}\nepsilon,{epsilon}\nomega_lowest,{lowest}\nomega_highest,{highest}\n\
         amplitude,{amplitude}\nwidth,1e-{WIDTH_PLACES}\nloops,{}\npoints,{points}\n",
        loops.join(" "),
    );
    format!("{stated}checksum,{}\n", checksum(&(stated.clone() + resonances + rows)))
}

/// `resonances.csv`: the digits of each number that are certain, and no more than twenty.
pub fn resonances(resonances: &[Resonance]) -> String {
    let mut text =
        "p,n,omega_star,amplitude_graz,s_plus,s_minus,c_sn,c_pd,criticality,not_shown\n".to_owned();
    for found in resonances {
        let numbers = found.numbers().map(|(_, number)| number.to_string()).join(",");
        let _ = writeln!(text, "{},{},{numbers},{}", found.p, found.n, found.missing.join("; "));
    }
    text
}
