//! Typed access to a JSON object. Unknown keys and wrong types are faults at their places.

use crate::notes::json::{Json, Spanned, Value, place_in_string};
use crate::source::{Fault, Source, Span};
use crate::suggest::nearest;

/// LaTeX or another text, with its place.
pub(super) type Text = Spanned<String>;

/// An object whose keys are known to be allowed.
pub(super) struct Fields<'a> {
    entries: &'a [(Text, Json)],
    /// The whole object.
    pub span: Span,
}

impl<'a> Fields<'a> {
    /// The object `json`, called `what` in messages.
    ///
    /// # Errors
    /// A key that is not in `known`; a key in `later` is reported as not supported yet.
    pub fn new(json: &'a Json, what: &str, known: &[&[&str]], later: &[&str]) -> Result<Self, Fault> {
        let entries = object(json, what)?;
        let known = || known.iter().flat_map(|list| list.iter().copied());
        for (key, _) in entries {
            let name = key.value.as_str();
            if known().any(|word| word == name) {
                continue;
            }
            if later.contains(&name) {
                return Err(Fault::unsupported(key.span, format!("\"{name}\" is not supported yet"))
                    .help("remove this key; nothing would be checked for it"));
            }
            let fault = Fault::claims(key.span, format!("{what} has no key \"{name}\""));
            let list = || known().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ");
            return Err(match nearest(name, known().chain(later.iter().copied())) {
                Some(word) => fault.help(format!("did you mean \"{word}\"? The keys are {}", list())),
                None => fault.help(format!("the keys are {}", list())),
            });
        }
        Ok(Fields { entries, span: json.span })
    }

    /// The entry with key `name`.
    pub fn entry(&self, name: &str) -> Option<(&'a Text, &'a Json)> {
        self.entries.iter().find(|(key, _)| key.value == name).map(|(key, value)| (key, value))
    }

    /// The key whose value stands around a place.
    pub fn key_at(&self, place: Span) -> Option<&'a str> {
        let found = self.entries.iter().find(|(_, value)| value.span.contains(place));
        found.map(|(key, _)| key.value.as_str())
    }

    pub fn get(&self, name: &str) -> Option<&'a Json> {
        self.entry(name).map(|(_, value)| value)
    }

    pub fn text(&self, name: &str) -> Result<Option<Text>, Fault> {
        self.get(name).map(|json| text(json, name)).transpose()
    }

    pub fn texts(&self, name: &str) -> Result<Vec<Text>, Fault> {
        self.get(name).map_or(Ok(Vec::new()), |json| texts(json, name))
    }

    pub fn pairs(&self, name: &str) -> Result<Vec<(Text, Text)>, Fault> {
        let Some(json) = self.get(name) else { return Ok(Vec::new()) };
        let entries = object(json, &format!("\"{name}\""))?;
        entries.iter().map(|(key, value)| Ok((key.clone(), text(value, &key.value)?))).collect()
    }

    /// As [`Fields::pairs`], one for each of the names that a key lists.
    pub fn declared(&self, name: &str, source: &Source) -> Result<Vec<(Text, Text)>, Fault> {
        let mut declared = Vec::new();
        for (key, value) in self.pairs(name)? {
            declared.extend(names(&key, source)?.into_iter().map(|name| (name, value.clone())));
        }
        Ok(declared)
    }

    /// A count, from 0.
    pub fn count(&self, name: &str) -> Result<Option<Spanned<usize>>, Fault> {
        self.get(name).map(|json| count(json, name)).transpose()
    }

    /// The place of a key whose only value is `true`.
    pub fn on(&self, name: &str) -> Result<Option<Span>, Fault> {
        match self.get(name) {
            None => Ok(None),
            Some(Json { value: Value::Bool(true), span }) => Ok(Some(*span)),
            Some(Json { value: Value::Bool(false), span }) => {
                Err(Fault::claims(*span, format!("the only value of \"{name}\" is true"))
                    .help("remove the key, or write true"))
            }
            Some(json) => Err(wrong(json, name, "true")),
        }
    }

    /// Checks that two keys that need each other are both given or both absent.
    pub fn together(&self, one: &str, other: &str, why: &str) -> Result<(), Fault> {
        let (a, b) = (self.entry(one), self.entry(other));
        let (present, missing) = match (a, b) {
            (Some((key, _)), None) => (key, other),
            (None, Some((key, _))) => (key, one),
            _ => return Ok(()),
        };
        Err(Fault::claims(present.span, format!("\"{}\" needs \"{missing}\" beside it", present.value)).help(why))
    }
}

pub(super) fn wrong(json: &Json, name: &str, expected: &str) -> Fault {
    let fault = Fault::claims(json.span, format!("\"{name}\" must be {expected}, not {}", json.value.kind()));
    match (name, expected) {
        ("skip" | "because", _) => fault.help(format!("write the reason, as in \"{name}\": \"a picture shows it\"")),
        ("generates", _) => fault.help("write \"generates\": \"the motion\""),
        ("holds", _) => fault.help("write \"holds\": \"always\" or \"holds\": \"on shell\""),
        (_, "a string") => fault.help(format!("write it in quotation marks, as in \"{name}\": \"…\"")),
        (_, "a number") => fault.help(format!("write digits, as in \"{name}\": 2")),
        _ => fault,
    }
}

/// A value of a key that holds names, for the help of an error.
fn example(what: &str) -> Option<&'static str> {
    const EXAMPLES: [(&str, &str); 13] = [
        ("coordinates", "{ \"\\\\theta\": \"angle\" }"),
        ("constants", "{ \"m, k\": \"> 0\" }"),
        ("varies with time", "{ \"x\": \"any\" }"),
        ("define", "{ \"\\\\omega_0\": \"\\\\sqrt{k/m}\" }"),
        ("units", "{ \"m\": \"kg\" }"),
        ("means", "{ \"L\": \"Lagrangian\" }"),
        ("functions", "{ \"V\": \"of r\" }"),
        ("an erratum", "{ \"for\": \"\\\\cos\", \"read\": \"\\\\sin\" }"),
        ("symmetry", "{ \"x\": \"-y\", \"y\": \"x\" }"),
        ("where", "{ \"m\": \"m_1 + m_2\" }"),
        ("at", "{ \"\\\\theta\": \"\\\\theta_0\" }"),
        ("laws", "{ \"Newton's second law\": \"1\" }"),
        ("equations", "{ \"2\": { \"small\": \"\\\\theta\" } }"),
    ];
    EXAMPLES.iter().find(|(key, _)| what.trim_matches('"') == *key).map(|(_, example)| *example)
}

pub(super) fn object<'a>(json: &'a Json, what: &str) -> Result<&'a [(Text, Json)], Fault> {
    match &json.value {
        Value::Object(entries) => Ok(entries),
        other => {
            let fault = Fault::claims(json.span, format!("{what} must be an object, {{ … }}, not {}", other.kind()));
            Err(match example(what) {
                Some(example) => {
                    let key = what.strip_prefix("an ").map_or_else(|| what.to_owned(), |key| format!("\"{key}\""));
                    fault.help(format!("for example, {key}: {example}"))
                }
                None => fault,
            })
        }
    }
}

pub(super) fn text(json: &Json, name: &str) -> Result<Text, Fault> {
    match &json.value {
        Value::String(text) if text.trim().is_empty() => {
            Err(Fault::claims(json.span, format!("\"{name}\" is empty")).help("write a text, or remove the key"))
        }
        Value::String(text) => Ok(Text::new(text.clone(), json.span)),
        _ => Err(wrong(json, name, "a string")),
    }
}

/// One string, or a list of them.
pub(super) fn texts(json: &Json, name: &str) -> Result<Vec<Text>, Fault> {
    match &json.value {
        Value::String(_) => Ok(vec![text(json, name)?]),
        Value::Array(items) if !items.is_empty() => items.iter().map(|item| text(item, name)).collect(),
        Value::Array(_) => Err(Fault::claims(json.span, format!("\"{name}\" is an empty list"))
            .help("put a text in the list, or remove the key")),
        _ => Err(wrong(json, name, "a string or a list of strings")),
    }
}

pub(super) fn count(json: &Json, name: &str) -> Result<Spanned<usize>, Fault> {
    match &json.value {
        Value::Number(raw) => raw
            .parse()
            .map(|count| Spanned::new(count, json.span))
            .map_err(|_| Fault::claims(json.span, format!("\"{name}\" must be a whole number, 0 or more"))),
        _ => Err(wrong(json, name, "a number")),
    }
}

/// One of a closed list of words.
pub(super) fn word<T: Copy>(written: &Text, name: &str, words: &[(&str, T)]) -> Result<Spanned<T>, Fault> {
    if let Some((_, meaning)) = words.iter().find(|(word, _)| *word == written.value) {
        return Ok(Spanned::new(*meaning, written.span));
    }
    let fault = Fault::claims(written.span, format!("\"{name}\" cannot be \"{}\"", written.value));
    let list = words.iter().map(|(word, _)| format!("\"{word}\"")).collect::<Vec<_>>().join(", ");
    Err(match nearest(&written.value, words.iter().map(|(word, _)| *word)) {
        _ if words.len() == 1 => fault.help(format!("the only value is {list}")),
        Some(word) => fault.help(format!("did you mean \"{word}\"? Use one of {list}")),
        None => fault.help(format!("use one of {list}")),
    })
}

/// The bytes `part` of a text, without the space around them, at their own place.
pub(super) fn piece(text: &Text, part: std::ops::Range<usize>, source: &Source) -> Text {
    let inside = &text.value[part.clone()];
    let start = part.start + inside.len() - inside.trim_start().len();
    let inside = inside.trim();
    let span = place_in_string(&source.text, text.span, Span::new(start, start + inside.len()));
    Text::new(inside.to_owned(), span)
}

/// The names in a text such as `M, g, R`, separated at commas outside of brackets, each with its own place.
pub(super) fn names(list: &Text, source: &Source) -> Result<Vec<Text>, Fault> {
    let text = &list.value;
    let mut depth = 0usize;
    let mut chars = text.char_indices();
    let mut ends = Vec::new();
    while let Some((at, c)) = chars.next() {
        match c {
            // `\,` is a space.
            '\\' => drop(chars.next()),
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            ',' if depth == 0 => ends.push(at),
            _ => {}
        }
    }
    ends.push(text.len());
    let (mut names, mut start) = (Vec::new(), 0);
    for end in ends {
        let name = piece(list, start..end, source);
        if name.value.is_empty() {
            return Err(Fault::claims(list.span, format!("a name is missing in \"{text}\""))
                .help("write names between commas, as in \"M, g, R\""));
        }
        names.push(name);
        start = end + 1;
    }
    Ok(names)
}
