//! The arguments of `--vary` and `--part`: the values of a constant, and a part of a family.

use std::fmt::{self, Display};
use std::str::FromStr;

use grazing_unfold::family::Varied;
use serde::{Deserialize, Serialize};

/// The most members of a family: more make tables that nobody reads and files that fill a disk.
pub(crate) const MOST_MEMBERS: usize = 1_000_000;

/// A constant with the values that it takes: `zeta=0.01:0.1:10`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Variation(pub(crate) Varied);

impl FromStr for Variation {
    type Err = String;

    fn from_str(written: &str) -> Result<Self, String> {
        let form =
            "write NAME=FROM:TO:COUNT, such as zeta=0.01:0.1:10 for ten values of zeta from 0.01 to 0.1";
        let (name, range) = written.split_once('=').ok_or(form)?;
        let parts: Vec<&str> = range.split(':').map(str::trim).collect();
        let [from, to, count] = parts[..] else { return Err(form.to_owned()) };
        let number = |text: &str| {
            let value: f64 = text.parse().map_err(|_| format!("{text} is not a number: {form}"))?;
            if value.is_finite() { Ok(value) } else { Err(format!("{text} is not a finite number")) }
        };
        let (from, to) = (number(from)?, number(to)?);
        let count: usize = count.parse().map_err(|_| format!("{count} is not a whole number: {form}"))?;
        if !(2..=MOST_MEMBERS).contains(&count) {
            return Err(format!("{count} values: COUNT must be from 2 to {MOST_MEMBERS}"));
        }
        if from == to {
            return Err(format!("FROM and TO are both {from}: set a constant that does not vary with --set"));
        }
        let last = (count - 1) as f64;
        let value = |index: usize| match index as f64 {
            share if share == last => to,
            share => from + (to - from) * (share / last),
        };
        let values = (0..count).map(value).collect();
        Ok(Self(Varied { name: name.trim().to_owned(), values }))
    }
}

impl TryFrom<String> for Variation {
    type Error = String;

    fn try_from(written: String) -> Result<Self, String> {
        written.parse()
    }
}

impl From<Variation> for String {
    fn from(Variation(Varied { name, values }): Variation) -> Self {
        let [from, to] = [values.first(), values.last()].map(|end| end.copied().unwrap_or(f64::NAN));
        format!("{name}={from}:{to}:{}", values.len())
    }
}

/// A part of a family: `7/200` is the seventh of two hundred.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct PartNumber {
    pub(crate) part: usize,
    pub(crate) parts: usize,
}

impl FromStr for PartNumber {
    type Err = String;

    fn from_str(written: &str) -> Result<Self, String> {
        let form = "write K/N with K from 1 to N, such as 7/200";
        let (part, parts) = written.split_once('/').ok_or(form)?;
        let number = |text: &str| text.trim().parse::<usize>().map_err(|_| form.to_owned());
        let (part, parts) = (number(part)?, number(parts)?);
        if (1..=parts).contains(&part) { Ok(Self { part, parts }) } else { Err(form.to_owned()) }
    }
}

impl TryFrom<String> for PartNumber {
    type Error = String;

    fn try_from(written: String) -> Result<Self, String> {
        written.parse()
    }
}

impl From<PartNumber> for String {
    fn from(part: PartNumber) -> Self {
        part.to_string()
    }
}

impl Display for PartNumber {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}/{}", self.part, self.parts)
    }
}
