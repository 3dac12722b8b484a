//! Letters above other letters that are indices, and those that may be indices as well as powers.
//!
//! | evidence | letters above |
//! | --- | --- |
//! | two Greek letters or more, `F^{\beta\alpha}`; three of i to s or more, `A^{ijkl}` | indices |
//! | two of i to s, of which one stands below a letter too, or which stand above another letter too | indices |
//! | a letter that stands below a letter, ∂ or ∇ in the same display, and is bound by no Σ | may be an index |
//! | the same beside letters with two indices above | indices |
//! | a Greek letter above two letters, beside one that stands above and below | indices |
//! | a Greek letter that stands below a letter too, or above one that equals a list, `A^\alpha = (\phi, \vec A)` | indices |
//!
//! What may be an index is no power where nobody has declared it.

use crate::formula::symbols::Inferred;

use super::super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::super::names;
use super::super::super::rows::relation;

/// Greek letters that are indices where two of them stand side by side.
const GREEK: [&str; 12] = [
    "\\mu", "\\nu", "\\rho", "\\sigma", "\\lambda", "\\alpha", "\\beta", "\\gamma", "\\delta", "\\kappa", "\\tau",
    "\\eta",
];

/// Letters that name a place or the time below a letter, and are no indices there.
const PLACES: [&str; 6] = ["x", "y", "z", "t", "r", "T"];

/// Records the letters above that are indices, for a display that is read for its structure.
pub(in super::super::super) fn note_indices(items: &[Item], inferred: &mut Inferred) {
    let found = Found::of(items);
    let certain = found.certain();
    inferred.has_tensors |= !certain.is_empty();
    let is_indexed = |(_, run): &&(String, Vec<String>)| found.is_run_of_indices(run);
    inferred.tensor_letters.extend(found.tensors.iter().filter(is_indexed).map(|(base, _)| base.clone()));
    inferred.index_letters.extend(certain);
}

/// Records the letters above that may be indices, where nobody has declared the letters.
pub(in super::super::super) fn note_possible_indices(items: &[Item], inferred: &mut Inferred) {
    let found = Found::of(items);
    let both = found.alone.iter().filter(|letter| found.is_below(letter)).cloned();
    let in_runs = found.runs.iter().filter(|run| found.is_run_of_indices(run)).flatten().cloned();
    inferred.unclear_letters = both.chain(in_runs).collect();
}

#[derive(Default)]
struct Found {
    /// The letters that stand alone above a letter, and those that do so above the left side of a list.
    alone: Vec<String>,
    of_a_list: Vec<String>,
    /// Two letters or more above a letter.
    runs: Vec<Vec<String>>,
    /// The same with the letter below them.
    tensors: Vec<(String, Vec<String>)>,
    /// The letters below letters, ∂ and ∇.
    below: Vec<String>,
    /// The letters that stand alone above a parenthesis, `(x^\alpha)^\beta`, and are powers.
    powers: Vec<String>,
    /// The letters below a Σ or a ∏.
    bound: Vec<String>,
}

impl Found {
    fn of(items: &[Item]) -> Found {
        let mut found = Found::default();
        found.list(items);
        found
    }

    fn is_below(&self, letter: &String) -> bool {
        self.below.contains(letter) && !self.bound.contains(letter) && !PLACES.contains(&letter.as_str())
    }

    fn is_run_of_indices(&self, run: &[String]) -> bool {
        let is_greek = |letter: &String| GREEK.contains(&letter.as_str());
        let is_latin = |letter: &String| matches!(letter.as_bytes(), [b'i'..=b's']);
        let is_usual = |letter: &String| matches!(letter.as_bytes(), [b'i'..=b'l']);
        // `R^{ij} R^{jk} = S^{ik}`, `\delta^{ij} dx^i dx^j`: each letter stands above another letter too.
        let is_again = || {
            run.iter().all(|letter| {
                self.runs.iter().filter(|other| other.contains(letter)).count() > 1 || self.alone.contains(letter)
            })
        };
        let are_letters = run.iter().all(|letter| is_greek(letter) || is_latin(letter));
        let is_free = !run.iter().any(|letter| self.bound.contains(letter) || self.powers.contains(letter));
        are_letters
            && is_free
            && (run.iter().all(is_greek)
                || run.len() > 2
                || run.iter().any(is_usual) && (is_again() || run.iter().any(|letter| self.is_below(letter))))
    }

    /// The letters that are indices.
    fn certain(&self) -> Vec<String> {
        let runs: Vec<&Vec<String>> = self.runs.iter().filter(|run| self.is_run_of_indices(run)).collect();
        let is_greek = |letter: &&String| GREEK.contains(&letter.as_str());
        let below: Vec<&String> = self.alone.iter().filter(|letter| self.is_below(letter)).collect();
        let mut certain: Vec<String> = below.iter().copied().filter(is_greek).cloned().collect();
        if !runs.is_empty() {
            certain.extend(below.into_iter().cloned());
            // `\partial_\alpha F^{\beta\alpha} = \mu_0 j^\beta`
            let in_a_run = |letter: &&String| runs.iter().any(|run| run.contains(letter));
            certain.extend(self.alone.iter().filter(in_a_run).cloned());
        }
        // `W^\alpha = J^\alpha{}_\beta V^\beta`: beside a letter that stands above and below, another one above two letters.
        if !certain.is_empty() {
            let is_again = |letter: &&String| self.alone.iter().filter(|other| other == letter).count() > 1;
            let is_free = |letter: &&String| !self.bound.contains(*letter) && !self.powers.contains(*letter);
            certain.extend(self.alone.iter().filter(is_greek).filter(is_again).filter(is_free).cloned());
        }
        certain.extend(self.of_a_list.iter().cloned());
        certain.extend(runs.into_iter().flatten().cloned());
        certain
    }

    fn list(&mut self, items: &[Item]) {
        let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        for (at, item) in solid.iter().enumerate() {
            let is_list = || match (solid.get(at + 1), solid.get(at + 2)) {
                (Some(equal), Some(Item { layout: Layout::Fence(Delimiter::Round, inside), .. })) => {
                    relation(equal).is_some() && inside.iter().any(|item| item.layout == Layout::Other(','))
                }
                _ => false,
            };
            if let Some([letter]) = letters_above(item).as_deref()
                && is_list()
            {
                self.of_a_list.push(letter.clone());
            }
            self.one(item);
        }
    }

    fn one(&mut self, item: &Item) {
        if let Some(above) = letters_above(item) {
            match above.as_slice() {
                [only] => self.alone.push(only.clone()),
                _ => {
                    let base = if let Layout::Scripts { nucleus, .. } = &item.layout {
                        names::printed(nucleus, None)
                    } else {
                        None
                    };
                    self.tensors.extend(base.map(|found| (found.name.base, above.clone())));
                    self.runs.push(above);
                }
            }
        }
        match &item.layout {
            Layout::Scripts { nucleus, sub, sup, .. } => {
                let is_bound = matches!(&nucleus.layout, Layout::Command(name) if name == "\\sum" || name == "\\prod");
                if let Some(sub) = sub {
                    let letters = contents(sub).iter().filter_map(|item| names::printed(item, None));
                    let letters = letters.map(|found| found.name.base);
                    match is_bound {
                        true => self.bound.extend(letters),
                        false => self.below.extend(letters),
                    }
                }
                self.one(nucleus);
                if let (Layout::Fence(..), Some(sup)) = (&nucleus.layout, sup)
                    && let Some(found) = names::printed(sup, None)
                {
                    self.powers.push(found.name.base);
                }
                if let Some(sup) = sup {
                    self.list(contents(sup));
                }
            }
            Layout::Group(items) | Layout::Fence(_, items) => self.list(items),
            Layout::Fraction(a, b) => {
                self.list(contents(a));
                self.list(contents(b));
            }
            Layout::Root(_, a) | Layout::Accent(_, a) | Layout::Style(_, a) => self.list(contents(a)),
            Layout::Environment(_, rows) => rows.iter().flatten().for_each(|cell| self.list(cell)),
            _ => {}
        }
    }
}

/// The letters above a letter, if there is nothing else; of e they are exponents.
fn letters_above(item: &Item) -> Option<Vec<String>> {
    let Layout::Scripts { nucleus, sup: Some(sup), .. } = &item.layout else { return None };
    let base = names::printed(nucleus, None).filter(|found| found.sup.is_none())?;
    let is_letter = |item: &Item| {
        let found = names::printed(item, None)?;
        (found.sup.is_none() && found.dots == 0 && found.name.subscript.is_empty()).then_some(found.name.base)
    };
    let solid = contents(sup).iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
    let letters: Option<Vec<String>> = solid.map(is_letter).collect();
    letters.filter(|letters| !letters.is_empty() && base.name.base != "e" && base.name.base != "\\mathrm{e}")
}
