//! The number of family sizes that decides for all sizes, found from the formulas.
//!
//! SumHypotheses over labels, multiplied and added, are sums over tuples of labels, and so is a difference A − B of
//! such formulas over one denominator. Of what each tuple gives nothing is known but which members it looks at. Let all
//! members but k be alike. Then the difference depends on n as a polynomial, of a degree of at most the number of
//! labels in the longest tuple, counting explicit powers of n: the *growth*. If it vanishes at one more number n ≥ k
//! than the growth says, it vanishes for all n ≥ k; and a sum over tuples is put together from its values where all
//! members but few are alike, k of them being told apart at most, k not above the growth. With `j < i` the polynomial
//! is one in the gaps between the k labels, and vanishes likewise. Members that are named, `m_1`, labels that are free
//! and ends that a Σ leaves out are told apart from the others in any case. So N + 1 numbers of members, from these on,
//! tell for a growth of N.
//!
//! # How many numbers of particles decide for all
//!
//! n(n − 1) is 6n − 12 for three and for four, so trying some numbers proves nothing without a bound. Sums over
//! labels are sums over tuples of labels. The value of such a sum is put together from its values where all members
//! but k are alike, for k up to the number N of labels in the tuple. There it counts tuples, and that is a
//! polynomial in n of degree at most N − k, for n ≥ k. So what vanishes for N + 1 consecutive numbers of members
//! vanishes for all. N is the depth of the sums, with powers of n and sums in denominators included. Members with a
//! name, free labels and ends that a Σ leaves out are told apart anyway, and the numbers begin there. A hypothesis
//! with one sum over members, Σ m_i r_i = 0, makes one member a sum over the others. The field is asked for these
//! numbers from 1 on.

use rustc_hash::FxHashMap;

use crate::formula::evaluate::constant_exponent;
use crate::formula::tree::MatrixFunction;
use crate::formula::{Expr, Index, IndexId, Node, SymbolId};

use crate::check::certificate::growth::Growth;
use crate::check::certificate::named_members::NamedMembers;
use crate::check::certificate::solved::SumHypotheses;
use crate::check::hypotheses::rule::{Action, Rule};
use crate::check::model::Model;
use crate::check::model::claim::Hypothesis;
use crate::check::model::meaning::{Meaning, ParticleQuantity};
use crate::check::sample::projection::Projection;

/// The depth to which definitions and laws are inserted.
const DEEPEST: usize = 64;

/// The number of derivatives of a hypothesis under `throughout` that are considered.
const DERIVATIVES: u8 = 3;

/// The growth of formulas under rules and hypotheses.
pub(crate) struct GrowthAnalysis<'a> {
    model: &'a Model,
    rules: &'a [Rule],
    /// The families of which one member is the solution of a hypothesis about a sum.
    solved: Vec<SymbolId>,
    known: FxHashMap<(SymbolId, u8), Option<Growth>>,
    depth: usize,
    /// The formulas that hypotheses set to 0, and whether at all times.
    zeros: Vec<(Expr, bool)>,
    /// Whether the current formula is a part of a joined family. In it the name means the family without the other
    /// parts.
    in_parts: bool,
}

impl<'a> GrowthAnalysis<'a> {
    /// An analysis under these rules, without other hypotheses.
    pub fn new(model: &'a Model, rules: &'a [Rule]) -> Self {
        let (solved, zeros) = (Vec::new(), Vec::new());
        GrowthAnalysis { model, rules, solved, known: FxHashMap::default(), depth: 0, zeros, in_parts: false }
    }

    /// Adds hypotheses that are solved for numbers of the state, and returns those of them that are sums over members.
    /// Returns `None` if the growth of the solutions is not known.
    ///
    /// One hypothesis may be a single sum over members. It is solved for a number of one member, and the solution is
    /// such a sum. All others must be about each member by itself, or about no member.
    pub fn obeys(&mut self, projection: &Projection<'_>) -> Option<SumHypotheses> {
        let mut sums = Vec::new();
        for (at, hypothesis) in projection.equalities() {
            let growth = self.of_hypothesis(hypothesis).filter(|growth| growth.denominators.is_empty())?;
            match (growth.numerator[0], self.free_labels(&hypothesis.free)) {
                (0, 0 | 1) => {}
                (1, 0) if sums.is_empty() => sums.push(at),
                _ => return None,
            }
        }
        if !sums.is_empty() {
            let symbols = projection.record.plan.iter().filter_map(|(_, slot)| projection.slots[*slot].symbol);
            self.solved = symbols.filter(|id| self.is_counted(*id)).collect();
            for (_, Hypothesis { lhs, rhs, throughout, .. }) in projection.equalities() {
                self.zeros.extend(
                    [(lhs, rhs), (rhs, lhs)]
                        .into_iter()
                        .filter(|(_, other)| other.is_null())
                        .map(|(side, _)| (side.clone(), *throughout)),
                );
            }
            self.known.clear();
        }
        Some(SumHypotheses { hypotheses: sums, families: self.solved.clone() })
    }

    /// Whether a symbol is a family whose members are counted.
    fn is_counted(&self, id: SymbolId) -> bool {
        self.model.symbols.entry(id).slots.iter().any(|(_, letter)| self.counts(*letter))
    }

    fn of_hypothesis(&mut self, hypothesis: &Hypothesis) -> Option<Growth> {
        let derivatives = if hypothesis.throughout { 0..=DERIVATIVES } else { 0..=0 };
        derivatives
            .map(|dots| self.of_sum([&hypothesis.lhs, &hypothesis.rhs].into_iter(), dots))
            .try_fold(Growth::default(), |all, growth| Some(all.plus(growth?)))
    }

    /// The growth of the difference of two formulas over their common denominator; `None` if that is not known.
    pub fn of_difference(&mut self, sides: &[&Expr]) -> Option<u32> {
        Some(self.of_sum(sides.iter().copied(), 0)?.numerator[0])
    }

    /// The number of members that are distinguished from the others: those of free letters, those from the first to the
    /// last that is named, those that a Σ leaves out at the end, and one for which a hypothesis is solved.
    pub fn distinguished_members(&self, formulas: &[&Expr], free: &[IndexId]) -> u32 {
        let named = NamedMembers::of(formulas, self.model, self.rules);
        let solved = u32::from(!self.solved.is_empty());
        u32::from(named.first) + u32::from(named.last) + self.free_labels(free) as u32 + solved
    }

    fn free_labels(&self, free: &[IndexId]) -> usize {
        free.iter().filter(|letter| self.counts(**letter)).count()
    }

    fn counts(&self, letter: IndexId) -> bool {
        self.model.symbols.indices[letter.0].count.is_some()
    }

    /// Whether a formula under this number of dots is 0 by a hypothesis.
    fn vanishes(&self, expr: &Expr, dots: u8) -> bool {
        self.zeros.iter().any(|(zero, throughout)| (dots == 0 || *throughout) && zero == expr)
    }

    /// The growth of a formula under this number of dots.
    fn of(&mut self, expr: &Expr, dots: u8) -> Option<Growth> {
        let plain = |inner: Growth| inner.is_none().then_some(inner);
        match &expr.node {
            Node::Number(_)
            | Node::Pi
            | Node::Euler
            | Node::Unit(_)
            | Node::Identity
            | Node::Imaginary
            | Node::Epsilon(_)
            | Node::Letter(_)
            | Node::Delta(_) => Growth::of([0; 2]),
            // A family without an index has no value.
            Node::Symbol { id, indices, .. } if indices.is_empty() && self.is_counted(*id) => None,
            Node::Symbol { id, dots: own, .. } => self.of_symbol(*id, own.checked_add(dots)?),
            Node::Sum(terms) => self.of_sum(terms.iter().map(|term| &term.expr), dots),
            Node::Matrix(rows) => self.of_sum(rows.iter().flatten(), dots),
            Node::Product(factors) => self.of_product(&factors.iter().collect::<Vec<_>>(), dots),
            Node::Cross(a, b) | Node::Dot(a, b) => self.of_product(&[a, b], dots),
            Node::Quotient(a, b) => {
                let above = self.of(a, dots)?;
                self.divided(above, b, dots, 1)
            }
            Node::Power(base, exponent) => match constant_exponent(exponent) {
                Some(n) if n.is_whole() && n.numerator.abs() <= 16 => {
                    let base = match &self.opened(base).node {
                        Node::Norm(inner) if n.numerator % 2 == 0 => inner,
                        _ => base,
                    };
                    let times = n.numerator.unsigned_abs() as u32;
                    if n.numerator < 0 {
                        return self.divided(Growth::default(), base, dots, times);
                    }
                    let once = self.of(base, dots)?;
                    Some((0..times).fold(Growth::default(), |all, _| all.times(once.clone())))
                }
                _ => {
                    let growth = self.of(base, dots)?.plus(self.of(exponent, dots)?);
                    plain(growth)
                }
            },
            Node::Root(_, inner) | Node::Call(_, inner) | Node::Norm(inner) => plain(self.of(inner, dots)?),
            Node::Apply(_, arguments) => plain(self.of_sum(arguments.iter(), dots)?),
            Node::TimeDerivative(order, inner) => self.of(inner, dots.checked_add(*order)?),
            Node::Transpose(inner) | Node::Entry(inner, ..) | Node::Component(inner, _) => self.of(inner, dots),
            Node::Commutator(a, b) => self.of_product(&[a, b], dots),
            Node::Complex(_, inner) | Node::OfMatrix(MatrixFunction::Trace, inner) => self.of(inner, dots),
            Node::OfMatrix(_, inner) => plain(self.of(inner, dots)?),
            Node::Cases(_) => None,
            Node::Inverse(inner) => plain(self.of(inner, dots)?),
            Node::SumOver { index, within: None, body, .. } => {
                let growth = self.of(body, dots)?;
                Some(if self.counts(*index) { growth.summed(is_closed(expr)) } else { growth })
            }
            Node::Rest(_) | Node::SumOver { .. } | Node::Integral(..) | Node::Shrinking(..) | Node::Definite(_) => None,
        }
    }

    fn of_sum<'e>(&mut self, mut terms: impl Iterator<Item = &'e Expr>, dots: u8) -> Option<Growth> {
        terms.try_fold(Growth::default(), |all, term| Some(all.plus(self.of(term, dots)?)))
    }

    /// The growth of a product. A single dot acts on one factor at a time.
    fn of_product(&mut self, factors: &[&Expr], dots: u8) -> Option<Growth> {
        if factors.iter().any(|factor| (0..=dots).all(|dots| self.vanishes(factor, dots))) {
            return Some(Growth::default());
        }
        let mut product = |dotted: Option<usize>| {
            factors.iter().enumerate().try_fold(Growth::default(), |all, (at, factor)| {
                let dots = if dotted.is_none_or(|dotted| dotted == at) { dots } else { 0 };
                Some(all.times(self.of(factor, dots)?))
            })
        };
        match dots {
            1 => (0..factors.len()).try_fold(Growth::default(), |all, at| Some(all.plus(product(Some(at))?))),
            _ => product(None),
        }
    }

    /// The growth of a quotient. The rate of a quotient has a further factor of a divisor that varies. A divisor that
    /// is a sum must not contain free letters.
    fn divided(&mut self, above: Growth, divisor: &Expr, dots: u8, times: u32) -> Option<Growth> {
        let growth = self.of(divisor, 0)?;
        let dots = if self.varies(divisor) { u32::from(dots) } else { 0 };
        if !growth.is_none() && !is_closed(divisor) {
            return None;
        }
        let mut above = above;
        for _ in 0..dots {
            above = above.times(self.of(divisor, dots as u8)?);
        }
        Some(above.over(self.opened(divisor), growth, times + dots))
    }

    /// The formula of a defined name, so that equal divisors are recognised.
    fn opened<'e>(&self, expr: &'e Expr) -> &'e Expr
    where
        'a: 'e,
    {
        match expr.as_plain_symbol().and_then(|id| self.model.meaning(id)) {
            Some(Meaning::Defined(formula)) if is_closed(formula) => self.opened(formula),
            _ => expr,
        }
    }

    fn varies(&self, expr: &Expr) -> bool {
        expr.symbols().iter().any(|(id, _)| match self.model.meaning(*id) {
            _ if self.rules.iter().any(|rule| rule.symbol == *id) => true,
            Some(Meaning::Constant(_) | Meaning::FixedAxis(_)) => false,
            Some(Meaning::Defined(formula)) => self.varies(formula),
            _ => true,
        })
    }

    fn of_symbol(&mut self, id: SymbolId, dots: u8) -> Option<Growth> {
        if let Some(known) = self.known.get(&(id, dots)).filter(|_| !self.in_parts) {
            return known.clone();
        }
        if self.depth == DEEPEST {
            return None;
        }
        self.depth += 1;
        let found = self.of_opened(id, dots);
        self.depth -= 1;
        if !self.in_parts {
            self.known.insert((id, dots), found.clone());
        }
        found
    }

    fn of_opened(&mut self, id: SymbolId, dots: u8) -> Option<Growth> {
        let model = self.model;
        let entry = model.symbols.entry(id);
        if model.symbols.indices.iter().any(|index| index.count == Some(id)) {
            return Growth::of([1; 2]);
        }
        let mut all = Growth::of([0, u32::from(self.solved.contains(&id))])?;
        for member in &entry.members {
            all = all.plus(self.of_symbol(*member, dots)?);
        }
        for rule in self.rules.iter().filter(|rule| rule.symbol == id) {
            all = all.plus(match &rule.action {
                Action::Equals(formula) if dots == 0 || rule.throughout => self.of(formula, dots)?,
                Action::Equals(_) | Action::Symmetric { .. } => Growth::default(),
                Action::Parallel(along) => self.of(along, dots).filter(Growth::is_none)?,
                Action::EquationOfMotion { order, formula } if dots >= *order => self.of(formula, dots - order)?,
                Action::EquationOfMotion { .. } => Growth::default(),
                Action::Union(_) if self.in_parts => Growth::default(),
                Action::Union(parts) => {
                    self.in_parts = true;
                    let growth = self.of_sum(parts.iter(), dots);
                    self.in_parts = false;
                    growth?
                }
                Action::Coupled(_) => return None,
            });
        }
        let own = match model.meaning(id) {
            Some(Meaning::Defined(formula)) => self.of(formula, dots)?,
            Some(Meaning::Particles(ParticleQuantity::InertiaTensor, label, masses, positions)) => {
                let moment = self.of_product(&[masses, positions, positions], dots)?;
                if self.counts(*label) { moment.summed(true) } else { moment }
            }
            Some(Meaning::Rigid(at)) => match model.rigid[*at].about {
                Some(about) => self.of_symbol(about, dots)?,
                None => Growth::default(),
            },
            Some(Meaning::Region(_) | Meaning::Density(_) | Meaning::Point) => return None,
            // Over a field, axes and moments are those of a generic body.
            _ => Growth::default(),
        };
        Some(all.plus(own))
    }
}

/// Whether each letter in a formula is summed over in it.
fn is_closed(expr: &Expr) -> bool {
    let (mut letters, mut summed) = (Vec::new(), Vec::new());
    expr.walk(&mut |inner| match &inner.node {
        Node::Symbol { indices, .. } => letters.extend(indices),
        Node::Component(_, a) => letters.push(*a),
        Node::Entry(_, a, b) | Node::Delta([a, b]) => letters.extend([*a, *b]),
        Node::Epsilon(indices) => letters.extend(indices),
        Node::SumOver { index, .. } => summed.push(*index),
        _ => {}
    });
    letters.iter().all(|index| match index {
        Index::Letter(letter) => summed.contains(letter),
        Index::Fixed(_) => true,
    })
}
