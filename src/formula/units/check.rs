//! The dimensional analysis of a formula: its dimension, or the term whose dimension does not fit.
//!
//! Equal dimensions are required of the terms of a sum, the members of a chain, and the entries of a matrix.
//! Dimensionless are the argument of a function, the angle of a rotation, an exponent, and the base of a power whose
//! exponent is no literal. A dot divides by the dimension of the independent variable. All members of a family have one
//! dimension, and so have all components of a vector or a matrix. The literal 0 has any dimension; every other number
//! is dimensionless. An integral multiplies by the dimension of its region: a length, an area or a volume.

use std::collections::BTreeSet;

use crate::formula::shape::{Shape, shape_of};
use crate::formula::tree::{Branch, Definite, MatrixFunction};
use crate::formula::{Expr, Kind, Node, Relation, Sign, Statement, SymbolId, Symbols, text};
use crate::source::Span;

use super::{Affine, Dimension, Inference, Ratio};

/// A term that does not fit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mismatch {
    /// The place of the term in the text of the formula.
    pub span: Span,
    /// What is wrong, naming the term.
    pub message: String,
    /// The [`Inference::origin`] of every requirement that the dimensions in the message were inferred from.
    pub origins: BTreeSet<usize>,
}

/// The analysis of a document, with the dimensions known so far.
#[derive(Clone, Debug)]
pub struct UnitCheck<'a> {
    symbols: &'a Symbols,
    time: Affine,
    /// The known dimensions.
    pub inference: Inference,
}

/// The dimension of a formula; `None` for a zero, which has any.
type Found = Result<Option<Affine>, Mismatch>;

/// Things that must have one dimension.
struct Pooled<'e> {
    expr: &'e Expr,
    found: Affine,
    /// The member of the chain that it is in.
    member: usize,
    /// Whether it is all of that member.
    whole: bool,
}

/// Why the things in a pool must agree.
#[derive(Clone, Copy)]
enum Pool<'r> {
    Terms,
    Entries,
    Cases,
    Members(&'r [(Relation, Span)]),
}

/// Votes are counted among so many terms; a longer sum blames the first term that does not fit.
const VOTERS: usize = 64;

impl<'a> UnitCheck<'a> {
    /// An analysis without known dimensions.
    pub fn new(symbols: &'a Symbols) -> Self {
        let time = symbols.time.as_ref().and_then(|name| symbols.find(name));
        let time = time.map_or(Affine::known(Dimension::TIME), |(id, _)| Affine::of(id));
        UnitCheck { symbols, time, inference: Inference::default() }
    }

    /// The independent variable, if it is a symbol of the table.
    pub fn time(&self) -> Option<SymbolId> {
        self.time.unknowns().next().map(|(symbol, _)| symbol)
    }

    /// A dimension as text, with all known dimensions inserted.
    pub fn words(&self, found: &Affine) -> String {
        self.show(&self.inference, found)
    }

    /// Checks a statement against the known dimensions, and infers further ones from the terms that fit. Returns the
    /// terms that do not fit.
    pub fn statement(&mut self, statement: &Statement) -> Vec<Mismatch> {
        let mut mismatches = Vec::new();
        let mut pool: Vec<Pooled<'_>> = Vec::new();
        for (at, member) in statement.members.iter().enumerate() {
            // Things in proportion may have any two dimensions.
            if at > 0 && statement.relations[at - 1].0 == Relation::Proportional {
                mismatches.extend(self.agree(&pool, Pool::Members(&statement.relations)).err());
                pool.clear();
            }
            match self.terms(member, at) {
                Ok(terms) => pool.extend(terms),
                Err(mismatch) => mismatches.push(mismatch),
            }
        }
        mismatches.extend(self.agree(&pool, Pool::Members(&statement.relations)).err());
        mismatches
    }

    /// The dimension of a formula.
    ///
    /// # Errors
    /// The first term inside it that does not fit.
    pub fn dimension(&mut self, expr: &Expr) -> Found {
        let none = || Ok(Some(Affine::known(Dimension::NONE)));
        match &expr.node {
            Node::Number(_) if expr.is_zero() => Ok(None),
            Node::Rest(_) | Node::Letter(_) => Ok(None),
            Node::Unit(unit) => Ok(Some(Affine::known(unit.dimension()))),
            Node::Number(_)
            | Node::Pi
            | Node::Euler
            | Node::Identity
            | Node::Imaginary
            | Node::Epsilon(_)
            | Node::Delta(_) => none(),
            Node::Symbol { id, dots, .. } => Ok(Some(self.per_time(Affine::of(*id), *dots))),
            Node::Sum(_) => {
                let terms = self.terms(expr, 0)?;
                self.agree(&terms, Pool::Terms)
            }
            Node::Matrix(rows) => {
                let mut entries = Vec::new();
                for entry in rows.iter().flatten() {
                    entries.extend(self.pooled(entry, 0, false)?);
                }
                self.agree(&entries, Pool::Entries)
            }
            Node::Product(factors) => {
                let mut product = Some(Affine::known(Dimension::NONE));
                for factor in factors {
                    let found = self.dimension(factor)?;
                    product = product.zip(found).map(|(product, found)| product.times(&found));
                }
                Ok(product)
            }
            Node::Cross(a, b) | Node::Dot(a, b) | Node::Commutator(a, b) => {
                let (a, b) = (self.dimension(a)?, self.dimension(b)?);
                Ok(a.zip(b).map(|(a, b)| a.times(&b)))
            }
            Node::Quotient(a, b) => {
                let (a, b) = (self.dimension(a)?, self.dimension(b)?);
                Ok(a.zip(b).map(|(a, b)| a.over(&b)))
            }
            Node::Power(base, exponent) => match literal(exponent) {
                Some(exponent) => Ok(self.dimension(base)?.map(|base| base.power(exponent))),
                None => {
                    self.dimensionless(exponent, "an exponent")?;
                    self.dimensionless(base, "the base of a power whose exponent is not a number")?;
                    none()
                }
            },
            Node::Root(n, a) => Ok(self.dimension(a)?.map(|a| a.power(Ratio::new(1, i64::from(*n))))),
            Node::Call(function, a) => {
                self.dimensionless(a, &format!("the argument of {}", function.name()))?;
                none()
            }
            Node::Apply(id, arguments) => self.applied(*id, arguments),
            Node::TimeDerivative(n, a) => Ok(self.dimension(a)?.map(|a| self.per_time(a, *n))),
            Node::OfMatrix(MatrixFunction::Determinant, a) => {
                let found = self.dimension(a)?;
                match shape_of(a, self.symbols) {
                    Ok(Shape::Matrix(rows @ 1.., _)) => Ok(found.map(|a| a.power(Ratio::whole(rows as i64)))),
                    _ => Ok(None),
                }
            }
            Node::Cases(branches) => self.cases(branches),
            Node::Inverse(a) => Ok(self.dimension(a)?.map(|a| a.power(Ratio::whole(-1)))),
            Node::Definite(of) => self.definite(of),
            Node::Integral(region, a) => Ok(self.dimension(a)?.map(|a| a.times(&Affine::of(*region)))),
            Node::Norm(a)
            | Node::OfMatrix(MatrixFunction::Trace, a)
            | Node::Complex(_, a)
            | Node::Transpose(a)
            | Node::Entry(a, _, _)
            | Node::Component(a, _)
            | Node::Shrinking(_, a)
            | Node::SumOver { body: a, .. } => self.dimension(a),
        }
    }

    /// The dimension of a function without a formula, or of a rotation, with its arguments.
    fn applied(&mut self, id: SymbolId, arguments: &[Expr]) -> Found {
        let turns = self.symbols.entry(id).kind == Kind::Rotation;
        for argument in arguments {
            match turns {
                true => self.dimensionless(argument, "the angle of a rotation")?,
                false => drop(self.dimension(argument)?),
            }
        }
        if turns { Ok(Some(Affine::known(Dimension::NONE))) } else { Ok(Some(Affine::of(id))) }
    }

    fn cases(&mut self, branches: &[Branch]) -> Found {
        let mut values = Vec::new();
        for branch in branches {
            values.extend(self.pooled(&branch.value, 0, false)?);
            for condition in &branch.conditions {
                let mut compared = Vec::new();
                for member in &condition.members {
                    compared.extend(self.pooled(member, 0, false)?);
                }
                self.agree(&compared, Pool::Cases)?;
            }
        }
        self.agree(&values, Pool::Cases)
    }

    fn definite(&mut self, of: &Definite) -> Found {
        let mut places = Vec::new();
        for end in of.lower.iter().chain(&of.upper) {
            places.extend(self.pooled(end, 0, false)?);
        }
        self.agree(&places, Pool::Cases)?;
        // What the letter is, nobody says, so it fits everything.
        self.dimension(&of.integrand)?;
        Ok(None)
    }

    fn per_time(&self, a: Affine, times: u8) -> Affine {
        a.over(&self.time.clone().power(Ratio::whole(times.into())))
    }

    /// The terms of a sum, or the formula as the only term; those that are zero are left out.
    fn terms<'e>(&mut self, expr: &'e Expr, member: usize) -> Result<Vec<Pooled<'e>>, Mismatch> {
        let Node::Sum(terms) = &expr.node else { return Ok(self.pooled(expr, member, true)?.into_iter().collect()) };
        let mut pool = Vec::new();
        for term in terms {
            pool.extend(self.pooled(&term.expr, member, terms.len() == 1)?);
        }
        Ok(pool)
    }

    fn pooled<'e>(&mut self, expr: &'e Expr, member: usize, whole: bool) -> Result<Option<Pooled<'e>>, Mismatch> {
        Ok(self.dimension(expr)?.map(|found| Pooled { expr, found, member, whole }))
    }

    fn dimensionless(&mut self, expr: &Expr, what: &str) -> Result<(), Mismatch> {
        let Some(found) = self.dimension(expr)? else { return Ok(()) };
        self.inference.require_equal(&found, &Affine::known(Dimension::NONE)).map_err(|conflict| {
            let message = format!("{}, but {what} must be dimensionless", self.says(&self.inference, expr, &found));
            Mismatch { span: expr.span, message, origins: conflict.origins }
        })
    }

    /// The one dimension of a pool; `None` for an empty one.
    fn agree(&mut self, pool: &[Pooled<'_>], why: Pool<'_>) -> Found {
        let Some((first, rest)) = pool.split_first() else { return Ok(None) };
        if rest.is_empty() {
            return Ok(Some(first.found.clone()));
        }
        let before = self.inference.clone();
        let fault = rest
            .iter()
            .position(|other| self.inference.require_equal(&first.found, &other.found).is_err())
            .map(|k| k + 1);
        let Some(late) = fault else { return Ok(Some(first.found.clone())) };
        let (culprit, partner, inference) = match odd_one(pool, &before) {
            Some((culprit, partner)) => (culprit, partner, &before),
            // Each pair could be one, and all together cannot.
            None => (late, 0, &self.inference),
        };
        let mismatch = self.mismatch(pool, culprit, partner, why, inference);
        self.inference = before;
        let mut others = pool.iter().enumerate().filter(|(at, _)| *at != culprit).map(|(_, pooled)| &pooled.found);
        if let Some(one) = others.next() {
            // The rest may hold a second mismatch; one to a sum is told.
            others.for_each(|other| drop(self.inference.require_equal(one, other)));
        }
        Err(mismatch)
    }

    fn mismatch(
        &self,
        pool: &[Pooled<'_>],
        culprit: usize,
        partner: usize,
        why: Pool<'_>,
        known: &Inference,
    ) -> Mismatch {
        let (a, b) = (&pool[culprit.min(partner)], &pool[culprit.max(partner)]);
        let verb = match why {
            Pool::Entries => "be entries of one matrix",
            Pool::Cases => "stand in one condition, one list of cases or one pair of limits",
            Pool::Members(relations) if a.member != b.member => match a.whole && b.whole {
                true if relations[a.member..b.member].iter().all(|(relation, _)| is_equality(*relation)) => "be equal",
                true => "be compared",
                false => "stand in one equation",
            },
            Pool::Terms | Pool::Members(_) => "be added",
        };
        let [first, second] = [a, b].map(|pooled| self.says(known, pooled.expr, &pooled.found));
        let origins = [a, b].into_iter().flat_map(|pooled| known.reduce(&pooled.found).1).collect();
        let message = format!("{first} and {second}, so they cannot {verb}");
        Mismatch { span: pool[culprit].expr.span, message, origins }
    }

    /// `“M·g” is in kg m s⁻²`.
    fn says(&self, known: &Inference, expr: &Expr, found: &Affine) -> String {
        const LONGEST: usize = 60;
        let mut quote = text::formula(expr, self.symbols);
        if let Some((end, _)) = quote.char_indices().nth(LONGEST) {
            quote.truncate(end);
            quote.push('…');
        }
        let unit = self.show(known, found);
        match unit.as_str() {
            "dimensionless" => format!("“{quote}” is {unit}"),
            _ => format!("“{quote}” is in {unit}"),
        }
    }

    fn show(&self, known: &Inference, found: &Affine) -> String {
        known.reduce(found).0.show(|symbol| text::plain(&self.symbols.entry(symbol).name.to_string()))
    }
}

/// The term that agrees with the fewest others, the last of several, and the nearest that it disagrees with: one of
/// its own sum, if there is one.
fn odd_one(pool: &[Pooled<'_>], known: &Inference) -> Option<(usize, usize)> {
    let voters = &pool[..pool.len().min(VOTERS)];
    let against = |at: usize| -> Vec<usize> {
        let differs = |other: &usize| !known.may_be_equal(&voters[at].found, &voters[*other].found);
        (0..voters.len()).filter(differs).collect()
    };
    let (culprit, against) = (0..voters.len()).map(|at| (at, against(at))).max_by_key(|(_, against)| against.len())?;
    let distance = |other: &usize| (voters[*other].member != voters[culprit].member, other.abs_diff(culprit));
    let partner = against.into_iter().min_by_key(distance)?;
    Some((culprit, partner))
}

fn is_equality(relation: Relation) -> bool {
    matches!(relation, Relation::Equal | Relation::Identical | Relation::Approximately)
}

/// The value of an exponent that is made of numbers alone.
fn literal(expr: &Expr) -> Option<Ratio> {
    let value = match &expr.node {
        Node::Number(text) => {
            let (whole, decimals) = text.split_once('.').unwrap_or((text, ""));
            let digits = format!("{whole}{decimals}").parse().ok()?;
            Ratio::new(digits, 10_i64.checked_pow(decimals.len().try_into().ok()?)?)
        }
        Node::Sum(terms) => terms.iter().try_fold(Ratio::ZERO, |sum, term| {
            let value = literal(&term.expr)?;
            Some(if term.sign == Sign::Minus { sum - value } else { sum + value })
        })?,
        Node::Product(factors) => {
            factors.iter().try_fold(Ratio::ONE, |product, factor| Some(product * literal(factor)?))?
        }
        Node::Quotient(a, b) => literal(a)? * literal(b)?.inverse(),
        _ => return None,
    };
    (!value.is_lost()).then_some(value)
}
