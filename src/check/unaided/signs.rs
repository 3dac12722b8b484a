//! Statements that hold where constants are positive, such as A = √(2E/k) after E = kA²/2.
//!
//! Nobody writes that an amplitude is positive. A root, a modulus or an inverse function depends on it, so a statement that has
//! one and fails is judged once more at positive values. The finding says so.

use crate::check::model::Model;
use crate::check::verdict::report::Equation;
use crate::formula::{Function, Node, SymbolId, text};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Range, Spanned};
use crate::source::Span;

/// The most constants that are taken to be positive.
const MOST: usize = 6;

/// Constants that are taken to be positive.
pub(super) struct Positive {
    names: Vec<String>,
}

/// The constants of a display that may have either sign, if it has a formula for which the sign matters.
pub(super) fn positive(reading: &Reading, symbols: &[SymbolId], model: &Model) -> Option<Positive> {
    let mut matters = false;
    for member in reading.statements.iter().flatten().flat_map(|statement| &statement.members) {
        member.walk(&mut |part| {
            let inverse = [Function::Arcsin, Function::Arccos, Function::Arctan, Function::Ln];
            matters |= match &part.node {
                Node::Root(..) | Node::Norm(_) => true,
                Node::Call(function, _) => inverse.contains(function),
                Node::Power(_, exponent) => matches!(exponent.node, Node::Quotient(..)),
                _ => false,
            };
        });
    }
    let is_free = |id: &&SymbolId| {
        let entry = model.symbols.entry(**id);
        let is_one = model.constants.iter().any(|constant| constant.symbol == **id && constant.numbers == 1);
        is_one && entry.coefficient.is_none() && model.range(**id) == Range::Any
    };
    let names: Vec<String> = symbols.iter().filter(is_free).map(|id| model.name(*id)).collect();
    (matters && !names.is_empty() && names.len() <= MOST).then_some(Positive { names })
}

impl Positive {
    /// The claim with these constants positive.
    pub fn added_to(&self, claim: &Claim) -> Claim {
        let mut claim = claim.clone();
        claim.assume.extend(self.names.iter().map(|name| Spanned::new(format!("{name} > 0"), Span::default())));
        claim
    }

    /// The finding, with what was assumed.
    pub fn found(&self, mut found: Equation) -> Equation {
        let names: Vec<String> = self.names.iter().map(|name| text::plain(name)).collect();
        found.finding.message = format!("holds where {} > 0", names.join(", "));
        found
    }
}
