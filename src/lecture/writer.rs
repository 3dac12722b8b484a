//! Notes and their claims, written side by side.

use serde_json::{Map, Value, json};

use super::passage::{Line, NOTES, Passage};
use super::sample::Sample;
use crate::Result;
use crate::derive::Derivation;
use crate::formula::{Expr, Node};
use crate::mechanics::System;

/// A lecture that is being written.
pub(super) struct Writer<'a> {
    pub system: &'a System,
    pub derivation: &'a Derivation,
    sample: &'a Sample,
    passages: Vec<Passage>,
    notes: String,
    claims: Map<String, Value>,
    lines: usize,
    /// The number of the line that gives L.
    pub lagrangian: String,
}

impl<'a> Writer<'a> {
    pub fn new(system: &'a System, derivation: &'a Derivation, sample: &'a Sample) -> Result<Self> {
        let mut writer = Writer {
            system,
            derivation,
            sample,
            passages: Vec::new(),
            notes: String::new(),
            claims: Map::new(),
            lines: 0,
            lagrangian: String::new(),
        };
        writer.claims.insert("notes".to_owned(), json!(NOTES));
        for (i, name) in system.coordinates().iter().enumerate() {
            let range = match (derivation.is_angle(i), derivation.has_pole(i)?) {
                (true, _) if derivation.is_polar(i) => "(0, \\pi)",
                (true, _) => "angle",
                (false, true) => "> 0",
                (false, false) => "any",
            };
            writer.claim("coordinates", name, json!(range));
        }
        for name in system.parameters() {
            writer.claim("constants", name, json!("> 0"));
        }
        Ok(writer)
    }

    /// Adds an entry to a table of the claims file.
    pub fn claim(&mut self, table: &str, key: &str, value: Value) {
        let table = self.claims.entry(table).or_insert_with(|| json!({}));
        if let Some(table) = table.as_object_mut() {
            table.insert(key.to_owned(), value);
        }
    }

    pub fn heading(&mut self, text: impl Into<String>) {
        let text = text.into();
        self.notes.push_str(&format!("## {text}\n\n"));
        self.passages.push(Passage::Heading(text));
    }

    pub fn say(&mut self, sentence: impl Into<String>) {
        let sentence = sentence.into();
        self.notes.push_str(&format!("{sentence}\n\n"));
        self.passages.push(Passage::Sentence(sentence));
    }

    /// Prints a line that is taken for granted; gives its number.
    pub fn given(&mut self, latex: &str, right: &[&Expr]) -> String {
        self.line(latex, &[], right)
    }

    /// Prints a line that follows from others; gives its number.
    pub fn line(&mut self, latex: &str, from: &[&str], right: &[&Expr]) -> String {
        self.lines += 1;
        let number = self.lines.to_string();
        self.notes.push_str(&format!("$$\n{latex}\n\\tag{{{number}}}\n$$\n\n"));
        let values = right.iter().filter_map(|expr| self.sample.value(self.derivation, expr)).collect();
        let from = from.iter().map(|&number| number.to_owned()).collect();
        self.passages.push(Passage::Line(Line { number: number.clone(), from, values }));
        number
    }

    /// A formula as LaTeX.
    pub fn latex(&self, formula: &Expr) -> String {
        self.derivation.typeset(formula)
    }

    /// A formula as a factor: a sum in parentheses.
    pub fn factor(&self, formula: &Expr) -> String {
        match formula.node {
            Node::Sum(_) => format!("\\left({}\\right)", self.latex(formula)),
            _ => self.latex(formula),
        }
    }

    /// The first of some names that the system does not have.
    pub fn free(&self, names: &[&str]) -> String {
        let taken =
            |name: &str| self.system.coordinates().iter().chain(self.system.parameters()).any(|own| own == name);
        let free = names.iter().find(|name| !taken(name)).or(names.last());
        free.map_or_else(String::new, |&name| name.to_owned())
    }

    /// The coordinates that occur in L, and those that do not.
    pub fn sorted(&self) -> (Vec<usize>, Vec<usize>) {
        (0..self.system.coordinates().len()).partition(|&i| !self.system.is_certainly_cyclic(i))
    }

    pub fn finished(self) -> (Vec<Passage>, String, String) {
        let claims = format!("{:#}\n", Value::Object(self.claims));
        (self.passages, format!("{}\n", self.notes.trim_end()), claims)
    }
}
