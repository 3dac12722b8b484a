//! Formulas put together from parts, without zeros, ones and sums of numbers. Every node has one place.

use crate::scalar::Ratio;
use crate::source::Span;

use super::super::tree::{Branch, Condition, Expr, Function, Node, Relation, Sign, Term};

/// The maker of formulas at one place.
#[derive(Clone, Copy)]
pub(super) struct Build {
    pub span: Span,
}

impl Build {
    pub fn node(self, node: Node) -> Expr {
        Expr::new(node, self.span)
    }

    pub fn whole(self, value: u32) -> Expr {
        Expr::integer(value, self.span)
    }

    /// A fraction of whole numbers.
    pub fn ratio(self, value: Ratio) -> Expr {
        let digits = |n: u64| self.node(Node::Number(n.to_string()));
        let above = digits(value.numerator.unsigned_abs());
        let size = match value.denominator {
            1 => above,
            below => self.node(Node::Quotient(Box::new(above), Box::new(digits(below)))),
        };
        if value.numerator < 0 { size.negated() } else { size }
    }

    pub fn sum(self, terms: Vec<Expr>) -> Expr {
        let (mut known, mut kept): (Ratio, Vec<Term>) = (Ratio::whole(0), Vec::new());
        for term in terms {
            if let Some(total) = rational(&term).and_then(|value| known.plus(value)) {
                known = total;
                continue;
            }
            let (sign, expr) = match term.node {
                Node::Sum(mut inner) if inner.len() == 1 => {
                    let only = inner.remove(0);
                    (only.sign, only.expr)
                }
                node => (Sign::Plus, Expr::new(node, term.span)),
            };
            match kept.iter().position(|other| other.expr == expr && other.sign != sign) {
                Some(opposite) => {
                    kept.remove(opposite);
                }
                None => kept.push(Term { sign, sign_span: None, expr }),
            }
        }
        if known.numerator != 0 {
            let size = Ratio { numerator: known.numerator.abs(), ..known };
            let sign = if known.numerator < 0 { Sign::Minus } else { Sign::Plus };
            kept.push(Term { sign, sign_span: None, expr: self.ratio(size) });
        }
        match kept.len() {
            0 => self.whole(0),
            1 if kept[0].sign == Sign::Plus => kept.remove(0).expr,
            _ => self.node(Node::Sum(kept)),
        }
    }

    pub fn minus(self, a: Expr, b: Expr) -> Expr {
        let b = self.negative(b);
        self.sum(vec![a, b])
    }

    pub fn negative(self, a: Expr) -> Expr {
        match rational(&a).and_then(Ratio::negated) {
            Some(value) => self.ratio(value),
            None => match a.node {
                Node::Sum(mut terms) => {
                    terms.iter_mut().for_each(|term| term.sign = term.sign.flipped());
                    match terms.len() {
                        1 if terms[0].sign == Sign::Plus => terms.remove(0).expr,
                        _ => self.node(Node::Sum(terms)),
                    }
                }
                _ => a.negated(),
            },
        }
    }

    pub fn product(self, factors: Vec<Expr>) -> Expr {
        let (mut known, mut kept): (Ratio, Vec<Expr>) = (Ratio::whole(1), Vec::new());
        for factor in factors {
            match rational(&factor).and_then(|value| known.times(value)) {
                Some(product) => known = product,
                None => kept.push(factor),
            }
        }
        if known.numerator == 0 || kept.is_empty() {
            return self.ratio(known);
        }
        let size = Ratio { numerator: known.numerator.abs(), ..known };
        if size != Ratio::whole(1) {
            kept.insert(0, self.ratio(size));
        }
        let product = if kept.len() == 1 { kept.remove(0) } else { self.node(Node::Product(kept)) };
        if known.numerator < 0 { self.negative(product) } else { product }
    }

    pub fn quotient(self, a: Expr, b: Expr) -> Expr {
        match (rational(&a), rational(&b)) {
            (Some(above), Some(below)) if below.numerator != 0 => {
                above.over(below).map_or_else(|| self.node(Node::Quotient(Box::new(a), Box::new(b))), |r| self.ratio(r))
            }
            (Some(zero), _) if zero.numerator == 0 => a,
            (_, Some(one)) if one == Ratio::whole(1) => a,
            _ => self.node(Node::Quotient(Box::new(a), Box::new(b))),
        }
    }

    pub fn power(self, base: Expr, exponent: Expr) -> Expr {
        match rational(&exponent) {
            Some(zero) if zero.numerator == 0 => self.whole(1),
            Some(one) if one == Ratio::whole(1) => base,
            _ => self.node(Node::Power(Box::new(base), Box::new(exponent))),
        }
    }

    pub fn whole_power(self, base: &Expr, exponent: u32) -> Expr {
        self.power(base.clone(), self.whole(exponent))
    }

    pub fn root(self, of: Expr) -> Expr {
        match rational(&of) {
            Some(known) if known == Ratio::whole(1) || known.numerator == 0 => of,
            _ => self.node(Node::Root(2, Box::new(of))),
        }
    }

    /// A formula of sums, products and powers put together anew, after a letter in it got a value.
    pub fn again(self, expr: &Expr) -> Expr {
        match &expr.node {
            Node::Sum(terms) => self.sum(
                terms
                    .iter()
                    .map(|term| match term.sign {
                        Sign::Plus => self.again(&term.expr),
                        Sign::Minus => self.negative(self.again(&term.expr)),
                    })
                    .collect(),
            ),
            Node::Product(factors) => self.product(factors.iter().map(|factor| self.again(factor)).collect()),
            Node::Quotient(a, b) => self.quotient(self.again(a), self.again(b)),
            Node::Power(base, exponent) => {
                let base = self.again(base);
                let is_even = exponent.as_digits().is_some_and(|digits| digits.ends_with(['0', '2', '4', '6', '8']));
                match base.node {
                    // (−x)² is x².
                    Node::Sum(mut terms) if is_even && terms.len() == 1 => {
                        self.power(terms.remove(0).expr, exponent.as_ref().clone())
                    }
                    node => match rational(&Expr::new(node.clone(), base.span)) {
                        Some(zero) if zero.numerator == 0 && exponent.as_digits().is_some() => self.whole(0),
                        _ => self.power(Expr::new(node, base.span), exponent.as_ref().clone()),
                    },
                }
            }
            _ => expr.clone(),
        }
    }

    pub fn call(self, function: Function, of: Expr) -> Expr {
        self.node(Node::Call(function, Box::new(of)))
    }

    pub fn exp(self, of: Expr) -> Expr {
        if of.is_zero() {
            self.whole(1)
        } else {
            self.node(Node::Power(Box::new(self.node(Node::Euler)), Box::new(of)))
        }
    }

    /// A value where conditions hold, and no value elsewhere. Conditions between numbers are decided here.
    pub fn guarded(self, value: Expr, conditions: Vec<Guard>) -> Option<Expr> {
        let mut open = Vec::new();
        for Guard { above, below } in conditions {
            match rational(&above).zip(rational(&below)) {
                Some((a, b)) if a.value() > b.value() => {}
                Some(_) => return None,
                None => open.push(Condition { members: vec![above, below], relations: vec![Relation::Greater] }),
            }
        }
        Some(match open.is_empty() {
            true => value,
            false => self.node(Node::Cases(vec![Branch { value, conditions: open }])),
        })
    }
}

/// A condition: `above` > `below`.
pub(super) struct Guard {
    pub above: Expr,
    pub below: Expr,
}

/// The value of a formula of numbers, where it is a fraction of whole numbers.
pub(super) fn rational(expr: &Expr) -> Option<Ratio> {
    match &expr.node {
        Node::Number(digits) => Ratio::from_decimal(digits),
        Node::Sum(terms) => terms.iter().try_fold(Ratio::whole(0), |sum, term| {
            let value = rational(&term.expr)?;
            sum.plus(if term.sign == Sign::Plus { value } else { value.negated()? })
        }),
        Node::Product(factors) => {
            factors.iter().try_fold(Ratio::whole(1), |product, factor| product.times(rational(factor)?))
        }
        Node::Quotient(a, b) => {
            let below = rational(b).filter(|below| below.numerator != 0)?;
            rational(a)?.over(below)
        }
        Node::Power(base, exponent) => {
            let (base, exponent) = (rational(base)?, exponent.as_digits()?.parse::<u32>().ok().filter(|n| *n <= 20)?);
            (0..exponent).try_fold(Ratio::whole(1), |product, _| product.times(base))
        }
        _ => None,
    }
}

/// Whether a formula is certainly 0.
pub(super) fn is_zero(expr: &Expr) -> bool {
    rational(expr).is_some_and(|value| value.numerator == 0)
}
