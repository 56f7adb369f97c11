//! Files with one mistake each.

use toml::{Table, Value};

/// A file without one of its keys, or with another value for it, for each of its keys, with the path of the key.
pub(crate) fn variants(file: &Table) -> Vec<(String, Table)> {
    let mut all = Vec::new();
    for (key, value) in file {
        let with = |other: Option<Value>| {
            let mut file = file.clone();
            match other {
                Some(other) => file.insert(key.clone(), other),
                None => file.remove(key),
            };
            file
        };
        let list = |members: &[f64]| Value::from(members.to_vec());
        let others = [true.into(), (-1).into(), 7.into(), 0.5.into(), f64::NAN.into(), "words".into()];
        let others =
            others.into_iter().chain([list(&[]), list(&[0.5]), list(&[0.5, 0.5]), list(&[-1.5, 2.0, 0.5])]);
        all.push((key.clone(), with(None)));
        all.extend(others.chain([Table::new().into()]).map(|other| (key.clone(), with(Some(other)))));
        let deeper = |inner: Vec<(String, Table)>, whole: &dyn Fn(Table) -> Value| -> Vec<(String, Table)> {
            inner
                .into_iter()
                .map(|(path, table)| (format!("{key}.{path}"), with(Some(whole(table)))))
                .collect()
        };
        match value {
            Value::Table(table) => all.extend(deeper(variants(table), &Value::Table)),
            Value::Array(tables) => {
                for (place, table) in
                    tables.iter().enumerate().filter_map(|(k, one)| Some((k, one.as_table()?)))
                {
                    let whole = |table: Table| {
                        let mut tables = tables.clone();
                        tables[place] = table.into();
                        tables.into()
                    };
                    all.extend(deeper(variants(table), &whole));
                }
            }
            _ => {}
        }
        let unknown = [(key.clone(), value.clone()), (format!("{key}s"), value.clone())];
        let unknown: Table = file.clone().into_iter().chain(unknown).collect();
        all.push((format!("{key}s"), unknown));
    }
    all
}
