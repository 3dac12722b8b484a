//! Statements that hold where constants are positive, such as A = √(2E/k) after E = kA²/2.
//!
//! Nobody writes that an amplitude is positive. A root, a modulus or an inverse function depends on it, so a statement that has
//! one and fails is judged once more at positive values. The finding says so. What stands between bars, as E in |E| = −E, is
//! negative: of a positive number nobody prints the modulus.

use crate::check::model::Model;
use crate::check::verdict::report::Equation;
use crate::formula::{Function, Node, SymbolId, text};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Range, Spanned};
use crate::source::Span;

/// The most constants that are taken to be positive.
const MOST: usize = 6;

/// Constants that are taken to be positive, and those that are taken to be negative.
pub(super) struct Positive {
    names: Vec<String>,
    negative: Vec<String>,
}

/// The constants of a display that may have either sign, if it has a formula for which the sign matters.
pub(super) fn positive(reading: &Reading, symbols: &[SymbolId], model: &Model) -> Option<Positive> {
    let (mut matters, mut between_bars) = (false, Vec::new());
    for member in reading.statements.iter().flatten().flat_map(|statement| &statement.members) {
        member.walk(&mut |part| {
            if let Node::Norm(inner) = &part.node {
                between_bars.extend(inner.as_plain_symbol());
            }
            let inverse = [Function::Arcsin, Function::Arccos, Function::Arctan, Function::Ln];
            matters |= match &part.node {
                Node::Root(..) | Node::Norm(_) => true,
                Node::Call(function, _) => inverse.contains(function),
                Node::Power(_, exponent) => matches!(exponent.node, Node::Quotient(..)),
                _ => false,
            };
        });
    }
    let free = symbols.iter().filter(|id| is_free(**id, model));
    let (negative, positive): (Vec<SymbolId>, Vec<SymbolId>) = free.partition(|id| between_bars.contains(id));
    let named = |ids: Vec<SymbolId>| ids.into_iter().map(|id| model.name(id)).collect::<Vec<String>>();
    let (names, negative) = (named(positive), named(negative));
    let count = names.len() + negative.len();
    (matters && count > 0 && count <= MOST).then_some(Positive { names, negative })
}

/// Whether a symbol is a constant that may have either sign.
fn is_free(id: SymbolId, model: &Model) -> bool {
    let entry = model.symbols.entry(id);
    let is_one = model.constants.iter().any(|constant| constant.symbol == id && constant.numbers == 1);
    is_one && entry.coefficient.is_none() && model.range(id) == Range::Any
}

impl Positive {
    /// The same, with the constants of premises, on which the sign of a root may depend as well.
    pub fn with(&self, symbols: impl Iterator<Item = SymbolId>, model: &Model) -> Positive {
        let mut names = self.names.clone();
        for id in symbols.filter(|id| is_free(*id, model)) {
            let name = model.name(id);
            if !names.contains(&name) && !self.negative.contains(&name) {
                names.push(name);
            }
        }
        if names.len() + self.negative.len() > MOST {
            names.clone_from(&self.names);
        }
        Positive { names, negative: self.negative.clone() }
    }

    /// The claim with these constants positive, or negative.
    pub fn added_to(&self, claim: &Claim) -> Claim {
        let mut claim = claim.clone();
        claim.assume.extend(self.conditions(Clone::clone).map(|condition| Spanned::new(condition, Span::default())));
        claim
    }

    /// What is assumed of each constant, whose name is printed as `shown`.
    fn conditions<'p>(&'p self, shown: impl Fn(&String) -> String + Copy + 'p) -> impl Iterator<Item = String> + 'p {
        let positive = self.names.iter().map(move |name| format!("{} > 0", shown(name)));
        positive.chain(self.negative.iter().map(move |name| format!("{} < 0", shown(name))))
    }

    /// The finding, with what was assumed.
    pub fn found(&self, mut found: Equation) -> Equation {
        found.finding.message = match self.negative.as_slice() {
            [] => {
                let names: Vec<String> = self.names.iter().map(|name| text::plain(name)).collect();
                format!("holds where {} > 0", names.join(", "))
            }
            _ => {
                let conditions: Vec<String> = self.conditions(|name| text::plain(name)).collect();
                format!("holds where {}", conditions.join(", "))
            }
        };
        found
    }
}
