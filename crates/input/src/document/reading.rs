//! Reading a file, or a table of it: TOML, with settings applied, and no unknown keys.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::{SourceError, SourcePlace};
use super::keys::Requirements;
use super::section::Section;
use super::setting::Setting;
use super::source::Source;
use super::text::Text;
use super::words::{SHOWN, joined, shortened};

impl Source<'_> {
    /// The file's content, with the settings applied.
    fn document<T, E: From<SourceError>>(
        &self,
        read: impl FnOnce(Spanned<DeTable<'_>>) -> Result<T, E>,
    ) -> Result<T, E> {
        let Text { whole, end, settings } = self.text;
        let assigned: Vec<String> = settings.iter().map(|(_, setting)| setting.assigned()).collect();
        let mut document = DeTable::parse(&whole[..*end]).map_err(|error| self.syntax(&error))?;
        for ((position, setting), assigned) in settings.iter().zip(&assigned) {
            self.must_be_there(setting, *position, document.get_ref())?;
            setting.apply(document.get_mut(), *position, assigned).map_err(|refusal| {
                let SourcePlace { file, line, .. } = self.place(*position);
                let [key, value] = [setting.key(), setting.value()].map(|text| shortened(text, SHOWN));
                let allowed = format!("{}: {}", refusal.key, refusal.allowed);
                SourceError::Forbidden { file, line, key, value, allowed }
            })?;
        }
        read(document)
    }

    /// Rejects a setting for a name that the file would have to introduce: any name may stand in
    /// its table, and this one does not.
    fn must_be_there(
        &self,
        setting: &Setting,
        position: usize,
        document: &DeTable<'_>,
    ) -> Result<(), SourceError> {
        let Some((table, name)) =
            setting.key().rsplit_once('.').filter(|(table, _)| self.requirements.any_key(table))
        else {
            return Ok(());
        };
        let names = document.get(table).and_then(|value| value.get_ref().as_table());
        let names: Vec<&str> = names.into_iter().flatten().map(|(key, _)| key.get_ref().as_ref()).collect();
        if names.contains(&name) {
            return Ok(());
        }
        Err(self.unknown(position, shortened(setting.key(), SHOWN), name, &names))
    }

    /// The whole file, read by `read`, whether its keys are known or not.
    pub(super) fn unchecked<T, E: From<SourceError>>(
        &self,
        read: impl FnOnce(Section<'_>) -> Result<T, E>,
    ) -> Result<T, E> {
        self.document(|document| read(Section::whole(self, document.get_ref())))
    }

    /// The whole file, read by `read`.
    ///
    /// # Errors
    /// [`SourceError`]: no TOML, or an unknown key; and any error returned by `read`.
    pub fn whole<T, E: From<SourceError>>(
        &self,
        read: impl FnOnce(Section<'_>) -> Result<T, E>,
    ) -> Result<T, E> {
        self.document(|document| {
            self.refuse_unknown(document.get_ref(), "", true)?;
            read(Section::whole(self, document.get_ref()))
        })
    }

    /// Checks that the file is TOML and that its top level has known keys only.
    ///
    /// # Errors
    /// [`SourceError`]: no TOML, or an unknown key.
    pub fn check_top_level(&self) -> Result<(), SourceError> {
        self.document(|document| self.refuse_unknown(document.get_ref(), "", false))
    }

    /// One table of the top level, read by `read`; the other tables are ignored.
    ///
    /// # Errors
    /// [`SourceError`]: no TOML, no such table, or an unknown key in it; and any error returned by
    /// `read`.
    pub fn section<T, E: From<SourceError>>(
        &self,
        name: &str,
        read: impl FnOnce(Section<'_>) -> Result<T, E>,
    ) -> Result<T, E> {
        self.document(|document| {
            let Some(value) = document.get_ref().get(name) else {
                return Err(self.missing("", name, 0).into());
            };
            let section = Section::of(self, name.to_owned(), value)?;
            if let Some(table) = value.get_ref().as_table() {
                self.refuse_unknown(table, name, true)?;
            }
            read(section)
        })
    }

    /// Rejects an unknown key of the table or, if `deep`, of the tables in it.
    fn refuse_unknown(&self, table: &DeTable<'_>, path: &str, deep: bool) -> Result<(), SourceError> {
        let Some(unknown) = first_unknown_key(table, path, self.requirements, deep) else { return Ok(()) };
        let UnknownKey { position, table, name } = unknown;
        let key = joined(&table, &shortened(&name, SHOWN));
        Err(self.unknown(position, key, &name, &self.requirements.known_keys(&table)))
    }
}

/// A key that has no meaning in its table.
struct UnknownKey {
    position: usize,
    table: String,
    name: String,
}

/// The unknown key that comes first in the text. The reader would find it as well, but only after a
/// missing one: for a table with a misspelt name it would report a missing table.
fn first_unknown_key(
    table: &DeTable<'_>,
    path: &str,
    requirements: &Requirements,
    deep: bool,
) -> Option<UnknownKey> {
    let known = requirements.known_keys(path);
    let any = requirements.any_key(path);
    table
        .iter()
        .filter_map(|(key, value)| {
            let name = key.get_ref().to_string();
            if !any && !known.contains(&name.as_str()) {
                return Some(UnknownKey { position: key.span().start, table: path.to_owned(), name });
            }
            let path = joined(path, &name);
            if !deep || requirements.known_keys(&path).is_empty() {
                // A value that should not be a table is rejected as a whole.
                return None;
            }
            match value.get_ref() {
                DeValue::Table(inner) => first_unknown_key(inner, &path, requirements, deep),
                DeValue::Array(members) => members
                    .iter()
                    .zip(1..)
                    .filter_map(|(member, number)| Some((member.get_ref().as_table()?, number)))
                    .find_map(|(inner, number)| {
                        first_unknown_key(inner, &format!("{path}[{number}]"), requirements, deep)
                    }),
                _ => None,
            }
        })
        .min_by_key(|unknown| unknown.position)
}
