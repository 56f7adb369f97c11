//! Values on the command line, read from their text.

use grazing_continuation::bifurcation::Bifurcation;

/// Two parameters.
pub(super) fn place(text: &str) -> Result<[f64; 2], String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|number| number.trim().parse()).collect();
    let numbers = numbers.ok().and_then(|numbers| <[f64; 2]>::try_from(numbers).ok());
    let finite = numbers.filter(|numbers| numbers.iter().all(|number| number.is_finite()));
    finite.ok_or_else(|| "write two numbers with a comma between them, such as 0.9,0.8".to_owned())
}

/// A name, and a column in which it stands.
pub(super) fn column(text: &str) -> Result<(String, String), String> {
    let parts = text.split_once('=').map(|(name, column)| (name.trim(), column.trim()));
    let named = parts.filter(|(name, column)| !name.is_empty() && !column.is_empty());
    let (name, column) = named.ok_or_else(|| {
        "write a name and a column, such as omega=freq, or omega=2 in a file without a header".to_owned()
    })?;
    Ok((name.to_owned(), column.to_owned()))
}

/// A kind of curve, with the number of loops if there is one.
pub(super) fn curve(text: &str) -> Result<(Bifurcation, Option<u32>), String> {
    let (word, loops) = text.split_once(':').map_or((text, None), |(word, loops)| (word, Some(loops)));
    let loops = loops.map(str::parse).transpose().ok();
    let both = Bifurcation::understood(word).zip(loops);
    both.ok_or_else(|| format!("write {}, and a number of loops, such as SN:2", Bifurcation::NAMES))
}

/// A date.
pub(super) fn date(text: &str) -> Result<String, String> {
    let parts: Vec<u16> = text.split('-').filter_map(|part| part.parse().ok()).collect();
    let is_date = text.len() == 10 && matches!(parts[..], [1900..=9999, 1..=12, 1..=31]);
    if is_date { Ok(text.to_owned()) } else { Err("write a date, such as 2027-01-31".to_owned()) }
}

/// Places across and up.
pub(super) fn size(text: &str) -> Result<[u32; 2], String> {
    let numbers: Result<Vec<u32>, _> = text.split('x').map(|number| number.trim().parse()).collect();
    let numbers = numbers.ok().and_then(|numbers| <[u32; 2]>::try_from(numbers).ok());
    numbers.ok_or_else(|| "write two whole numbers with an x between them, such as 1000x1000".to_owned())
}

/// A limit.
pub(super) fn positive(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(value) if f64::is_finite(value) && value > 0.0 => Ok(value),
        _ => Err("write a positive number".to_owned()),
    }
}
