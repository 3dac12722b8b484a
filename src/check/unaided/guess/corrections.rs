//! What the author of notes changed in a claims file that was inferred.
//!
//! The file declares each name once, for all of the notes. Where letters have other meanings in other sections, the names are
//! inferred for each part of the notes, and what the author changed is put in there. So a file that nobody changed says what
//! is inferred without it.

use std::path::Path;
use std::sync::Arc;

use serde_json::{Map, Value};

use crate::Result;
use crate::notes::{Claims, Notes};
use crate::source::Source;

use super::inference;
use crate::check::document::setup::Run;

/// The keys that say nothing about the names in the displays.
const BESIDE: [&str; 5] = ["notes", "guesses", "equations", "sentences", "rubric"];

/// The keys that an inferred file may have, each with names and what they are.
const INFERRED: [&str; 7] =
    ["coordinates", "varies with time", "constants", "functions", "formulas as names", "means", "define"];

/// The declarations that differ from the inferred ones.
pub(crate) struct Corrections {
    /// Each with its key, its name and what is said of it.
    changed: Vec<(String, String, Value)>,
    /// Names that are declared no more.
    removed: Vec<String>,
}

impl Corrections {
    /// The corrections in a claims file; `None`, if it says more than an inferred one can.
    ///
    /// # Errors
    /// When no claims file makes sense of the notes.
    pub fn of(run: &Run<'_>, claims: &Claims, notes: &Notes) -> Result<Option<Corrections>> {
        let own = keys(claims);
        let is_known = |key: &String| BESIDE.contains(&key.as_str()) || INFERRED.contains(&key.as_str());
        if !own.keys().all(is_known) {
            return Ok(None);
        }
        let inferred = keys(&inference::claims(run, notes)?);
        let entries = |keys: &Map<String, Value>| -> Vec<(String, String, Value)> {
            let groups = INFERRED.iter().filter_map(|role| Some((*role, keys.get(*role)?.as_object()?)));
            groups
                .flat_map(|(role, group)| {
                    group.iter().map(move |(name, value)| (role.to_owned(), name.clone(), value.clone()))
                })
                .collect()
        };
        let (own, inferred) = (entries(&own), entries(&inferred));
        let changed = own.iter().filter(|entry| !inferred.contains(entry)).cloned().collect();
        let is_gone = |name: &String| !own.iter().any(|(_, other, _)| other == name);
        let removed = inferred.into_iter().map(|(_, name, _)| name).filter(is_gone).collect();
        Ok(Some(Corrections { changed, removed }))
    }

    /// The claims that were inferred for a part of the notes, with the corrections.
    ///
    /// # Errors
    /// For a declaration that is none.
    pub fn applied(&self, inferred: Claims) -> Result<Claims> {
        if self.changed.is_empty() && self.removed.is_empty() {
            return Ok(inferred);
        }
        let mut keys = keys(&inferred);
        let replaced = self.changed.iter().map(|(_, name, _)| name).chain(&self.removed);
        for name in replaced {
            keys.values_mut().filter_map(Value::as_object_mut).for_each(|group| drop(group.remove(name)));
        }
        for (role, name, value) in &self.changed {
            let group = keys.entry(role.clone()).or_insert_with(|| Value::Object(Map::new()));
            if let Some(group) = group.as_object_mut() {
                group.insert(name.clone(), value.clone());
            }
        }
        let path = inferred.source.path.clone();
        let beside = path.trim_end_matches(" (inferred)").to_owned();
        Claims::parse(Arc::new(Source::new(path, format!("{:#}\n", Value::Object(keys)))), Path::new(&beside))
    }
}

fn keys(claims: &Claims) -> Map<String, Value> {
    serde_json::from_str(&claims.source.text).unwrap_or_default()
}
