//! The mutants of a claim: the same claim with one mistake in it, such as authors make.
//!
//! A check that accepts a mutant has not tested much. Every claim that passes is compared with its mutants at the same
//! states. A mutant of a refuted claim that holds is what its author may have meant.
//!
//! # What mutants of a claim are for
//!
//! A state can be too special, a range too narrow, a tolerance too wide. So each equality that passes is tested on
//! its own sensitivity: every claim that differs by one common slip must fail at the same states. One that does not
//! fail may be *equivalent*, as true as the claim (λ₂ for λ₁ where λ₁ = λ₂ is assumed), or a *survivor*. To decide,
//! states are drawn from wider ranges under the same hypotheses. A mutant that holds and fails with the claim is
//! taken for equivalent; no proof is needed, and there is no false `undecided`. One that differs at any state is a
//! survivor. If a claim is refuted and a mutant holds, the report suggests the mutant. These mutants change
//! formulas, because a sentence in a claims file has no bytes in the notes; `latex::slips` changes the text.

use std::cell::Cell;

use crate::formula::tree::{ComplexPart, Function, Index, Sign, Term};
use crate::formula::{Expr, Kind, Node, SymbolId, text};

use crate::check::model::Model;
use crate::check::model::claim::Link;
use crate::check::model::meaning::Meaning;

/// A claim with one mistake.
#[derive(Clone, Debug)]
pub struct Mutant {
    /// The claim.
    pub link: Link,
    /// The kind of mistake.
    pub slip: Slip,
    /// The change, as a phrase after "with".
    pub change: String,
}

/// The kinds of mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Slip {
    /// A sign flipped.
    Sign,
    /// A term or factor left out.
    Omission,
    /// Factors in another order.
    Order,
    /// Another number.
    Number,
    /// Another power, or none.
    Power,
    /// Sine for cosine.
    Function,
    /// A dot more or less.
    Dot,
    /// Another index, or two swapped.
    Index,
    /// One symbol for another.
    Symbol,
    /// Numerator and denominator exchanged, a transpose or inverse lost.
    Structure,
}

/// The mutants of a link. A literal zero has none.
pub fn mutants_of(link: &Link, model: &Model) -> Vec<Mutant> {
    let mut present: Vec<SymbolId> = Vec::new();
    for side in [&link.lhs, &link.rhs] {
        present.extend(side.symbols().into_iter().map(|(id, _)| id));
    }
    present.sort();
    present.dedup();
    // What was derived and is printed nowhere has no place, and its mutants say nothing of what is printed.
    let count = |side: &Expr, wanted: &dyn Fn(&Expr) -> bool| {
        let mut nodes = 0;
        side.walk(&mut |part| nodes += usize::from(wanted(part)));
        nodes
    };
    let printed = count(&link.lhs, &is_printed) + count(&link.rhs, &is_printed);
    let nodes = match printed {
        0 => count(&link.lhs, &|_| true) + count(&link.rhs, &|_| true),
        printed => printed,
    };
    // A formula with too many possible mistakes gets a sample of them at even distances.
    let stride = (4 * nodes / MOST.min(LARGEST / nodes.max(1)).max(1)).max(1);
    let slips = Slips { model, present, only_printed: printed > 0, stride, met: Cell::new(0) };
    // The whole right side with the other sign, and multiplied by 2.
    let whole =
        [(Slip::Sign, "−"), (Slip::Number, "2 ")].into_iter().filter(|_| !link.rhs.is_null()).map(|(slip, sign)| {
            let words = text::formula(&link.rhs, &model.symbols);
            let rhs = match slip {
                Slip::Sign => link.rhs.clone().negated(),
                _ => Expr::new(Node::Product(vec![Expr::integer(2, link.rhs.span), link.rhs.clone()]), link.rhs.span),
            };
            Mutant { link: Link { rhs, ..link.clone() }, slip, change: instead(&format!("{sign}({words})"), &words) }
        });
    let left = slips.of(&link.lhs).into_iter().map(|(lhs, slip, change)| (Link { lhs, ..link.clone() }, slip, change));
    let right = slips.of(&link.rhs).into_iter().map(|(rhs, slip, change)| (Link { rhs, ..link.clone() }, slip, change));
    left.chain(right).map(|(link, slip, change)| Mutant { link, slip, change }).chain(whole).collect()
}

/// Whether a part of a formula stands in a text.
fn is_printed(part: &Expr) -> bool {
    part.span.start < part.span.end
}

/// The approximate largest number of mutants of one claim.
const MOST: usize = 2_000;

/// The approximate largest number of nodes in all mutants of one claim together.
const LARGEST: usize = 1_000_000;

/// The phrase for a change of one text into another.
fn instead(new: &str, old: &str) -> String {
    format!("“{new}” in place of “{old}”")
}

/// The root of a formula with one mistake, the kind of mistake, and the change in words.
type Changed = (Node, Slip, String);

/// A generator of formulas with one mistake.
struct Slips<'a> {
    model: &'a Model,
    /// Whether mistakes are made only in what stands in a text.
    only_printed: bool,
    /// The distance between mistakes that are made: 1 for all.
    stride: usize,
    /// The number of possible mistakes so far.
    met: Cell<usize>,
    /// The symbols of the claim.
    present: Vec<SymbolId>,
}

impl Slips<'_> {
    /// The copies of a formula with one mistake anywhere in it. Each is copied once, however deep the mistake is.
    fn of(&self, expr: &Expr) -> Vec<(Expr, Slip, String)> {
        let mut slips = Vec::new();
        self.within((expr, &mut Vec::new()), expr, 0, &mut slips);
        slips
    }

    /// The copies of a whole formula with one mistake in the part at the end of a path. `wide` counts the formulas around it
    /// with so many parts that a sample of the mistakes in each is enough.
    fn within(
        &self,
        (whole, path): (&Expr, &mut Vec<usize>),
        part: &Expr,
        wide: usize,
        slips: &mut Vec<(Expr, Slip, String)>,
    ) {
        let here = if self.only_printed && !is_printed(part) { Vec::new() } else { self.here(part) };
        for (changed, slip, change) in here {
            if (0..wide).all(|_| self.is_wanted()) {
                let mut copy = whole.clone();
                let mut place = &mut copy;
                for at in path.iter() {
                    place = place.children_mut().swap_remove(*at);
                }
                *place = changed;
                slips.push((copy, slip, change));
            }
        }
        let children = part.children();
        let wide = wide + usize::from(self.stride > 1 && children.len() >= MOST / 8);
        for (at, child) in children.into_iter().enumerate() {
            if matches!(&part.node, Node::Power(..)) && at == 1 {
                continue;
            }
            path.push(at);
            self.within((whole, path), child, wide, slips);
            path.pop();
        }
    }

    /// Whether the next possible mistake is made.
    fn is_wanted(&self) -> bool {
        self.met.set(self.met.get() + 1);
        self.met.get().is_multiple_of(self.stride)
    }

    fn words(&self, expr: &Expr) -> String {
        text::formula(expr, &self.model.symbols)
    }

    /// The copies of a formula with one mistake at its root.
    fn here(&self, expr: &Expr) -> Vec<(Expr, Slip, String)> {
        let span = expr.span;
        let mut slips: Vec<Changed> = Vec::new();
        match &expr.node {
            Node::Sum(terms) => self.sum_slips(terms, &mut slips),
            Node::Product(factors) => self.product_slips(factors, &mut slips),
            Node::Number(digits) => {
                if let Some(n) = digits.parse::<f64>().ok().filter(|n| *n != 0.0) {
                    let double = (2.0 * n).to_string();
                    let change = instead(&double, digits);
                    slips.push((Node::Number(double), Slip::Number, change));
                }
            }
            Node::Power(base, exponent) => self.power_slips(expr, base, exponent, &mut slips),
            Node::Call(function, argument) => self.function_slips(expr, *function, argument, &mut slips),
            Node::Symbol { id, indices, dots } => self.symbol_slips(*id, indices, *dots, &mut slips),
            Node::Apply(id, arguments) => {
                for other in self.present.iter().filter(|other| self.alike(**other, *id)) {
                    let name = |id| text::plain(&self.model.name(id));
                    let change = instead(&name(*other), &name(*id));
                    slips.push((Node::Apply(*other, arguments.clone()), Slip::Symbol, change));
                }
            }
            Node::Quotient(a, b) => {
                if self.is_scalar(a) {
                    slips.push((
                        Node::Quotient(b.clone(), a.clone()),
                        Slip::Structure,
                        format!("“{}” inverted", self.words(expr)),
                    ));
                }
            }
            Node::Cross(a, b) => {
                slips.push((Node::Cross(b.clone(), a.clone()), Slip::Order, format!("“{}” swapped", self.words(expr))));
            }
            Node::Matrix(rows) => self.entry_slips(rows, &mut slips),
            Node::Commutator(a, b) => {
                let change = format!("“{}” swapped", self.words(expr));
                slips.push((Node::Commutator(b.clone(), a.clone()), Slip::Order, change));
            }
            Node::Complex(ComplexPart::Conjugate, inner) => {
                let change = instead(&self.words(inner), &self.words(expr));
                slips.push((inner.node.clone(), Slip::Structure, change));
            }
            Node::Complex(part, inner) => {
                let other = match part {
                    ComplexPart::Real => ComplexPart::Imaginary,
                    _ => ComplexPart::Real,
                };
                let change = instead(other.name(), part.name());
                slips.push((Node::Complex(other, inner.clone()), Slip::Structure, change));
            }
            Node::Imaginary => {
                let change = instead("−i", "i");
                slips.push((Node::Product(vec![Expr::integer(1, span).negated(), expr.clone()]), Slip::Sign, change));
            }
            Node::Transpose(inner) | Node::Inverse(inner) => {
                let change = instead(&self.words(inner), &self.words(expr));
                slips.push((inner.node.clone(), Slip::Structure, change));
            }
            Node::Entry(inner, i, j) if i != j => {
                slips.push((
                    Node::Entry(inner.clone(), *j, *i),
                    Slip::Index,
                    format!("the indices of {} swapped", self.words(expr)),
                ));
            }
            Node::Epsilon([a, b, c]) => {
                slips.push((
                    Node::Epsilon([*b, *a, *c]),
                    Slip::Index,
                    format!("the indices of {} swapped", self.words(expr)),
                ));
            }
            Node::Entry(..)
            | Node::Pi
            | Node::Identity
            | Node::OfMatrix(..)
            | Node::Cases(_)
            | Node::Euler
            | Node::Unit(_)
            | Node::Root(..)
            | Node::TimeDerivative(..)
            | Node::Norm(_)
            | Node::Dot(..)
            | Node::Delta(_)
            | Node::Integral(..)
            | Node::Definite(_)
            | Node::Letter(_)
            | Node::Rest(_)
            | Node::Shrinking(..)
            | Node::Component(..)
            | Node::SumOver { .. } => {}
        }
        slips.into_iter().map(|(node, slip, change)| (Expr::new(node, span), slip, change)).collect()
    }

    /// A term with the other sign, or left out.
    fn sum_slips(&self, terms: &[Term], slips: &mut Vec<Changed>) {
        for (at, term) in terms.iter().enumerate() {
            if !self.is_wanted() {
                continue;
            }
            let words = self.words(&term.expr);
            let mut flipped = terms.to_vec();
            flipped[at].sign = term.sign.flipped();
            let (new, old) = if term.sign == Sign::Plus { ("−", "+") } else { ("+", "−") };
            let change = instead(&format!("{new} {words}"), &format!("{old} {words}"));
            slips.push((Node::Sum(flipped), Slip::Sign, change));
            if terms.len() > 1 {
                let mut fewer = terms.to_vec();
                fewer.remove(at);
                slips.push((Node::Sum(fewer), Slip::Omission, format!("“{words}” left out")));
            }
        }
    }

    /// A factor left out, or two matrices exchanged.
    fn product_slips(&self, factors: &[Expr], slips: &mut Vec<Changed>) {
        for at in 0..factors.len() {
            if !self.is_wanted() {
                continue;
            }
            let mut fewer = factors.to_vec();
            let gone = fewer.remove(at);
            let rest = if fewer.len() == 1 { fewer.remove(0).node } else { Node::Product(fewer) };
            slips.push((rest, Slip::Omission, format!("the factor “{}” left out", self.words(&gone))));
        }
        for at in 1..factors.len() {
            // The order matters for matrices only.
            if [at - 1, at].iter().all(|k| self.is_matrix(&factors[*k])) {
                let mut swapped = factors.to_vec();
                swapped.swap(at - 1, at);
                let words = self.words(&factors[at]);
                slips.push((Node::Product(swapped), Slip::Order, format!("“{words}” moved one place to the left")));
            }
        }
    }

    /// Another power, or none.
    fn power_slips(&self, expr: &Expr, base: &Expr, exponent: &Expr, slips: &mut Vec<Changed>) {
        if let Some(n) = exponent.as_digits().and_then(|n| n.parse::<u32>().ok()) {
            let higher = Box::new(Expr::integer(n + 1, exponent.span));
            let higher = Expr::new(Node::Power(Box::new(base.clone()), higher), expr.span);
            let words = self.words(expr);
            let change = instead(&self.words(&higher), &words);
            slips.push((higher.node, Slip::Power, change));
            slips.push((base.node.clone(), Slip::Power, instead(&self.words(base), &words)));
        }
    }

    /// A cosine for a sine, and the like.
    fn function_slips(&self, expr: &Expr, function: Function, argument: &Expr, slips: &mut Vec<Changed>) {
        let other = match function {
            Function::Sin => Some(Function::Cos),
            Function::Cos => Some(Function::Sin),
            Function::Tan => Some(Function::Cot),
            _ => None,
        };
        if let Some(other) = other {
            let other = Expr::new(Node::Call(other, Box::new(argument.clone())), expr.span);
            let change = instead(&self.words(&other), &self.words(expr));
            slips.push((other.node, Slip::Function, change));
        }
    }

    /// An entry of a matrix with the other sign.
    fn entry_slips(&self, rows: &[Vec<Expr>], slips: &mut Vec<Changed>) {
        for (i, row) in rows.iter().enumerate() {
            for (j, entry) in row.iter().enumerate().filter(|(_, entry)| !entry.is_zero()) {
                let mut changed = rows.to_vec();
                changed[i][j] = entry.clone().negated();
                let words = self.words(entry);
                let change = instead(&format!("−({words})"), &words);
                let change = format!("{change} in row {}, column {}", i + 1, j + 1);
                slips.push((Node::Matrix(changed), Slip::Sign, change));
            }
        }
    }

    fn symbol_slips(&self, id: SymbolId, indices: &[Index], dots: u8, slips: &mut Vec<Changed>) {
        let entry = self.model.symbols.entry(id);
        let symbol = |id, indices: &[Index], dots| Node::Symbol { id, indices: indices.to_vec(), dots };
        let name = text::with_dots(&entry.name.to_string(), dots);
        if dots > 0 {
            slips.push((symbol(id, indices, dots - 1), Slip::Dot, format!("one dot fewer on {name}")));
        }
        if entry.varies {
            slips.push((symbol(id, indices, dots + 1), Slip::Dot, format!("one dot more on {name}")));
        }
        if let [i, j] = indices
            && i != j
        {
            slips.push((symbol(id, &[*j, *i], dots), Slip::Index, format!("the indices of {name} swapped")));
        }
        if let [Index::Fixed(value)] = indices {
            for other in (1..=self.model.symbols.extents(id)[0]).filter(|other| other != value) {
                slips.push((
                    symbol(id, &[Index::Fixed(other)], dots),
                    Slip::Index,
                    format!("the index {other} in place of {value} on {name}"),
                ));
            }
        }
        for other in self.present.iter().filter(|other| self.alike(**other, id)) {
            let change = instead(&text::with_dots(&self.model.name(*other), dots), &name);
            slips.push((symbol(*other, indices, dots), Slip::Symbol, change));
        }
    }

    /// Whether an author could confuse two symbols.
    fn alike(&self, a: SymbolId, b: SymbolId) -> bool {
        let (x, y) = (self.model.symbols.entry(a), self.model.symbols.entry(b));
        let coordinates = [a, b].iter().all(|id| matches!(self.model.meaning(*id), Some(Meaning::Coordinate(_))));
        a != b && x.kind == y.kind && x.slots.len() == y.slots.len() && (coordinates || x.name.base == y.name.base)
    }

    fn is_scalar(&self, expr: &Expr) -> bool {
        crate::formula::shape::shape_of(expr, &self.model.symbols)
            .is_ok_and(|s| s == crate::formula::shape::Shape::Scalar)
    }

    fn is_matrix(&self, expr: &Expr) -> bool {
        match &expr.node {
            Node::Matrix(_) | Node::Apply(..) | Node::Transpose(_) | Node::Inverse(_) => true,
            Node::Symbol { id, .. } => matches!(self.model.symbols.entry(*id).kind, Kind::Matrix(..)),
            _ => false,
        }
    }
}
