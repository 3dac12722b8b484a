//! A prime field as a number: where it holds, an identity is not near, it *is*.
//!
//! A rational identity that fails as an identity holds at a random point of a large field with a tiny probability, which
//! its degree bounds (Schwartz, Zippel; for formulas, Gonnet). [`Modular`] is a full [`num_dual::DualNum`] over the field
//! of p = 861·2¹¹⁷ − 1 elements, so that printed formulas and Lagrangians in Rust run over it unchanged. It carries
//!
//! - its value, and as an *angle* a label on the unit circle over the field, which has a cyclic part of 2¹¹⁷ points: sines and
//!   cosines of sums, halves and multiples of angles, and shifts by parts of a turn, are exact;
//! - an honest bound on itself: the degree of its numerator, were it written as one fraction, and the sum of the magnitudes
//!   of the numerator's coefficients, which must stay below p lest one of them vanish in the field. Sine and cosine count
//!   as the Laurent polynomials in e^{iθ} that they are.
//!
//! Exponentials and logarithms are free numbers, related as their arguments are (`exponentials.rs`).
//!
//! What a field cannot do (a sign, an order, an arc) is noted, and nothing is concluded. A square root exists at
//! half of the points; its sign is free, so an identity with roots must hold for all choices of them. Until more than its
//! square is asked for, neither matters.
//!
//! Numbers live within [`at_a_point`] only, on one thread. Nothing here knows of formulas.

mod circle;
mod denominators;
mod exponentials;
mod prime;
mod session;
#[cfg(test)]
mod tests;

use std::any::Any;
use std::cell::RefCell;
use std::cmp::Ordering;
use std::fmt;

use super::arithmetic::{dual_number, power_by_squaring};
use super::rational::Ratio;
use super::{Arithmetic, Function};
use circle::drawn_bits;
use denominators::{Bottom, Size, accidents};
use prime::Residue;
use session::{Angle, Found, Session};

pub use prime::{Large, Modulus, Second};
pub use session::Account;

/// A number of the field: see the [module](self).
#[derive(Clone, Copy, Debug)]
pub struct Modular<F: Modulus = Large> {
    value: Residue<F>,
    size: Size,
    bottom: Bottom,
    kind: Kind,
    /// The square roots in it that are irrational, a bit each.
    roots: u32,
}

/// What else is known of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// Nothing but its value.
    Rest,
    /// A small whole number.
    Whole(i32),
    /// A fraction, by its place in the session.
    Ratio(u32),
    /// An angle, by its place in the session.
    Angle(u32),
    /// A square root whose value was not needed yet, by its place in the session. The number has the size of the root; its
    /// value is 0 where the radicand is, else 1.
    Root(u32),
}

/// Numbers with smaller coefficients than this are simple enough to be remembered.
const SIMPLE_NORM: f64 = 64.0;

/// Above this a difference of two numbers could vanish in the field without being zero: they are not compared.
const SETTLED_NORM: f64 = (1_u128 << 100) as f64;

thread_local! {
    static SESSION: RefCell<Option<Box<dyn Any>>> = const { RefCell::new(None) };
}

/// Evaluates `f` at the point of the field that `seed` names. The n-th bit of `signs` is the sign of the n-th square root;
/// `finest` is the least common denominator of multiples of angles, as far as it is known.
///
/// The account tells whether the result means anything. Where its `finest` is larger than what was given, the degrees are
/// too small, and the evaluation must be repeated with that.
pub fn at_a_point<F: Modulus, R>(seed: u64, signs: u32, finest: u64, f: impl FnOnce() -> R) -> (R, Account) {
    /// Puts the interrupted session back, also when `f` panics.
    struct Interrupted(Option<Box<dyn Any>>);
    impl Drop for Interrupted {
        fn drop(&mut self) {
            SESSION.replace(self.0.take());
        }
    }
    let interrupted = Interrupted(SESSION.replace(Some(Box::new(Session::<F>::new(seed, signs, finest)))));
    let result = f();
    let session = SESSION.take().and_then(|session| session.downcast::<Session<F>>().ok());
    drop(interrupted);
    let account = session.map(|session| {
        let coincidences = session.account.coincidences + session.denominators.coincidences();
        let compared_bits = session.account.compared_bits.max(session.denominators.compared_bits());
        Account { coincidences, compared_bits, ..session.account }
    });
    (result, account.unwrap_or_default())
}

/// Runs `f` on the session of the thread; outside of one, on a scratch session of which nothing is ever read.
fn session<F: Modulus, R>(f: impl FnOnce(&mut Session<F>) -> R) -> R {
    SESSION.with_borrow_mut(|open| match open.as_mut().and_then(|session| session.downcast_mut()) {
        Some(session) => f(session),
        None => f(&mut Session::new(0, 0, 1)),
    })
}

/// The bound on the probability that two different sides agree at a random point, as a power of two.
///
/// `differences` are left side minus right side, entry by entry; `attempts` is how many points could have been tried.
/// `None` where coefficients may have more than `most_bits` bits, those of the prime or of the product of several, so that they
/// could vanish without being zero; or where what was compared on the way has more than those of this prime.
pub fn false_accept_log2<F: Modulus>(
    differences: &[Modular<F>],
    account: &Account,
    attempts: u32,
    most_bits: f64,
) -> Option<f64> {
    if account.compared_bits >= Modular::<F>::most_bits() {
        return None;
    }
    let mut degree = 1.0_f64;
    for difference in differences {
        // with k roots of free sign the norm is a product of 2ᵏ conjugates
        let conjugates = f64::from(difference.roots.count_ones()).exp2();
        let bits = difference.size.norm.max(1.0).log2() * conjugates;
        if bits.is_nan() || bits >= most_bits {
            return None;
        }
        degree = degree.max(accidents(difference.size.degree) * conjugates);
    }
    let accidents = (degree + account.coincidences) * f64::from(attempts.max(1));
    if !accidents.is_finite() {
        return None;
    }
    Some((accidents.log2() - f64::from(drawn_bits::<F>())).min(0.0))
}

impl<F: Modulus> Modular<F> {
    const ZERO: Self = Modular { value: Residue::ZERO, size: Size::ZERO, bottom: 0, kind: Kind::Whole(0), roots: 0 };
    const ONE: Self = Modular { value: Residue::ONE, size: Size::ONE, bottom: 0, kind: Kind::Whole(1), roots: 0 };

    /// How many bits a coefficient can have that is not 0 and vanishes in no such field.
    pub fn most_bits() -> f64 {
        f64::from(F::PRIME.ilog2())
    }

    /// A random number, which may also be an angle.
    pub fn drawn() -> Self {
        let (value, place) = session::<F, _>(Session::drawn);
        Modular { kind: Kind::Angle(place), ..Self::rest(value, Size::VARIABLE, 0) }.kept()
    }

    /// A random number that is no angle.
    pub fn drawn_plain() -> Self {
        let value = session::<F, _>(Session::drawn_plain);
        Self::rest(value, Size::VARIABLE, 0).kept()
    }

    /// Whether it is 0 at this point.
    pub fn vanishes(self) -> bool {
        self.value.is_zero()
    }

    /// Nothing but a value.
    fn rest(value: Residue<F>, size: Size, bottom: Bottom) -> Self {
        Modular { value, size, bottom, kind: Kind::Rest, roots: 0 }
    }

    /// Remembers a simple number, for others to turn out to be it.
    pub fn kept(self) -> Self {
        session(|session| session.keep(self));
        self
    }

    /// What is as large as a polynomial, and has the value of a simple number here, is that number: that it is not is an
    /// accident, and counted as one.
    fn settled(self) -> Self {
        if self.roots != 0 || !(SIMPLE_NORM..SETTLED_NORM).contains(&self.size.norm) {
            return self;
        }
        session(|session| session.settle(self))
    }

    fn is_literally_zero(self) -> bool {
        self.size.norm == 0.0
    }

    fn ratio(self, session: &Session<F>) -> Option<Ratio> {
        match self.kind {
            Kind::Whole(n) => Some(Ratio::whole(n.into())),
            Kind::Ratio(place) => session.ratios.get(place as usize).copied(),
            Kind::Rest | Kind::Angle(_) | Kind::Root(_) => None,
        }
    }

    /// The number with the value that it has: that of a root is needed from here on.
    fn used(self) -> Self {
        match self.kind {
            Kind::Root(place) if !self.value.is_zero() => {
                let (value, roots) = session(|session: &mut Session<F>| session.value_of_root(place as usize));
                Modular { value, kind: Kind::Rest, roots: self.roots | roots, ..self }
            }
            _ => self,
        }
    }

    /// The kind of a fraction.
    fn of_ratio(ratio: Option<Ratio>, session: &mut Session<F>) -> Kind {
        match ratio {
            None => Kind::Rest,
            Some(Ratio { numerator, denominator: 1 }) if i32::try_from(numerator).is_ok() => {
                Kind::Whole(numerator as i32)
            }
            Some(ratio) => {
                session.ratios.push(ratio);
                Kind::Ratio(session.ratios.len() as u32 - 1)
            }
        }
    }

    /// As an angle: what is nothing else is a rest.
    fn angle(self, session: &Session<F>) -> Angle<F> {
        match self.kind {
            Kind::Angle(place) => session.angles[place as usize],
            _ => Angle { rest: self.value, ..Angle::NONE },
        }
    }

    /// Times a fraction, as an angle.
    fn scaled_angle(self, ratio: Ratio, value: Residue<F>, session: &mut Session<F>) -> Kind {
        match self.kind {
            Kind::Angle(_) => {
                let angle = self.angle(session).scaled(ratio, value);
                Kind::Angle(session.angle(angle))
            }
            _ => Kind::Rest,
        }
    }

    fn sum(self, other: Self, value: Residue<F>, negated: bool) -> Self {
        let constant = |x: Self| matches!(x.kind, Kind::Whole(_) | Kind::Ratio(_));
        let kind = match (self.kind, other.kind) {
            (Kind::Rest | Kind::Root(_), Kind::Rest | Kind::Root(_)) => Kind::Rest,
            (Kind::Whole(a), Kind::Whole(b)) if a.checked_add(if negated { -b } else { b }).is_some() => {
                Kind::Whole(a + if negated { -b } else { b })
            }
            _ if constant(self) && constant(other) => session(|session| {
                let second = other.ratio(session).and_then(|r| if negated { r.negated() } else { Some(r) });
                let ratio = self.ratio(session).zip(second).and_then(|(a, b)| a.plus(b));
                Self::of_ratio(ratio, session)
            }),
            (Kind::Angle(_), _) | (_, Kind::Angle(_)) => session(|session| {
                let second = other.angle(session);
                let second = if negated { second.scaled(Ratio::whole(-1), Residue::whole(-1)) } else { second };
                let angle = self.angle(session).plus(second);
                Kind::Angle(session.angle(angle))
            }),
            _ => Kind::Rest,
        };
        let roots = self.roots | other.roots;
        if self.bottom == other.bottom {
            return Modular { value, size: self.size.plus(other.size), bottom: self.bottom, kind, roots }.settled();
        }
        let common = session(|session: &mut Session<F>| session.denominators.common(self.bottom, other.bottom));
        let size = self.size.times(common.first).plus(other.size.times(common.second));
        Modular { value, size, bottom: common.bottom, kind, roots }.settled()
    }

    /// Cosine and sine.
    fn circular(self) -> (Self, Self) {
        if self.is_literally_zero() {
            return (Self::ONE, Self::ZERO);
        }
        let number = self.used();
        let (point, degree, bottom) = session(|session| {
            let angle = number.angle(session);

            let (point, degree) = session.point(angle, number);
            // (e^{iθ} ± e^{−iθ})/2
            (point, degree, session.denominators.whole(2))
        });
        let number = |value| Self::rest(value, Size { degree, norm: 2.0 }, bottom);
        (number(point.cosine), number(point.sine))
    }

    fn root(self) -> Self {
        if self.is_literally_zero() {
            return Self::ZERO;
        }
        let exact = |n: u128| (n.isqrt() * n.isqrt() == n).then(|| n.isqrt() as f64);
        let ratio = session(|session| self.ratio(session)).filter(|ratio| ratio.numerator > 0);
        if let Some(ratio) = ratio
            && let (Some(n), Some(d)) = (exact(ratio.numerator.unsigned_abs().into()), exact(ratio.denominator.into()))
        {
            return Self::constant(n).over(Self::constant(d));
        }
        let number = self.used();
        let found = session(|session| session.root(number));
        let root = |place, value, size, bottom| {
            let root = Modular { value, size, bottom, kind: Kind::Root(place), roots: number.roots };
            session(|session: &mut Session<F>| session.taken.insert(place, (root, number)));
            root
        };
        match found {
            Found::Ratio(ratio) => Self::constant(ratio.value()),
            Found::Again(place) => {
                session(|session: &mut Session<F>| session.taken.get(&place).map(|(root, _)| *root)).unwrap_or(number)
            }
            Found::Magnitude(place) => root(place, Residue::ONE, Size::VARIABLE, 0),
            Found::Root(place) => {
                // √(X/Y) = √(XY)/Y
                let below = session(|session: &mut Session<F>| session.denominators.size(number.bottom));
                let degree = number.size.degree.saturating_add(below.degree).div_ceil(2);
                let size = Size { degree, norm: (number.size.norm * below.norm).sqrt().max(1.0) };
                root(place, if number.value.is_zero() { Residue::ZERO } else { Residue::ONE }, size, number.bottom)
            }
        }
    }

    /// The product of two numbers with their values.
    fn product(self, other: Self) -> Self {
        let (value, size) = (self.value.times(other.value), self.size.times(other.size));
        let kind = match (self.kind, other.kind) {
            (Kind::Rest | Kind::Root(_), _) | (_, Kind::Rest | Kind::Root(_)) | (Kind::Angle(_), Kind::Angle(_)) => {
                Kind::Rest
            }
            _ => session(|session| match (self.ratio(session), other.ratio(session)) {
                (Some(a), Some(b)) => Self::of_ratio(a.times(b), session),
                (Some(a), None) => other.scaled_angle(a, self.value, session),
                (None, Some(b)) => self.scaled_angle(b, other.value, session),
                (None, None) => Kind::Rest,
            }),
        };
        let bottom = match (self.bottom, other.bottom) {
            (0, bottom) | (bottom, 0) => bottom,
            (a, b) => session(|session: &mut Session<F>| session.denominators.product(a, b)),
        };
        Modular { value, size, bottom, kind, roots: self.roots | other.roots }
    }

    /// The quotient of two numbers with their values.
    fn quotient(self, other: Self) -> Self {
        if other.value.is_zero() {
            // a quotient by what is literally 0 has no value anywhere
            if other.is_literally_zero() {
                return Self::refused("a quotient by 0");
            }
            session(|session: &mut Session<F>| session.account.elsewhere = Some("a denominator that vanishes"));
            return Self::ZERO;
        }
        if other.kind == Kind::Whole(1) || self.is_literally_zero() {
            return self;
        }
        let quotient = session(|session| {
            // (a/A)/(b/B) = (a·B)/(A·b), without what A and B share
            let (above, below) = session.denominators.reduced(other.bottom, self.bottom);
            let reciprocal = session.reciprocal(other.value);
            let inverse = match other.ratio(session).and_then(Ratio::inverse) {
                // a whole number divides prime by prime
                Some(_) if other.bottom == 0 => {
                    let size = other.size.norm as u64;
                    session.denominators.whole(size)
                }
                _ => {
                    let numerator = other.value.times(session.denominators.value(other.bottom));
                    session.denominators.factor(numerator, other.size)
                }
            };
            let (value, bottom) = (self.value.times(reciprocal), session.denominators.product(below, inverse));
            let size = self.size.times(session.denominators.size(above));
            let kind = match (self.kind, other.ratio(session).and_then(Ratio::inverse)) {
                (_, None) => Kind::Rest,
                (Kind::Angle(_), Some(ratio)) => self.scaled_angle(ratio, reciprocal, session),
                (_, Some(ratio)) => {
                    let quotient = self.ratio(session).and_then(|own| own.times(ratio));
                    Self::of_ratio(quotient, session)
                }
            };
            Modular { value, size, bottom, kind, roots: self.roots | other.roots }
        });
        if quotient.size.norm < SIMPLE_NORM { quotient.kept() } else { quotient.settled() }
    }

    /// What has no meaning in a field.
    fn refused(why: &'static str) -> Self {
        session(|session: &mut Session<F>| session.fault(why));
        Self::ZERO
    }
}

impl<F: Modulus> Arithmetic for Modular<F> {
    type Inner = f64;

    fn constant(value: f64) -> Self {
        if value == 0.0 {
            return Self::ZERO;
        }
        if value == 1.0 {
            return Self::ONE;
        }
        if value.fract() == 0.0 && value.abs() < 1e9 {
            let size = Size { degree: 0, norm: value.abs() };
            let value_in_the_field = Residue::whole(value as i64);
            return Modular { kind: Kind::Whole(value as i32), ..Self::rest(value_in_the_field, size, 0) };
        }
        session(|session| {
            let known = session.constant(value);
            let kind = match known.angle {
                Some(place) => Kind::Angle(place),
                None => Self::of_ratio(known.ratio, session),
            };
            Modular { kind, ..Self::rest(known.value, known.size, known.bottom) }
        })
    }

    fn real(self) -> f64 {
        match session(|session| self.ratio(session)) {
            Some(ratio) => ratio.value(),
            None => {
                Self::refused("an absolute value, or an exponent that varies");
                f64::NAN
            }
        }
    }

    fn plus(self, other: Self) -> Self {
        if self.is_literally_zero() {
            return other;
        }
        if other.is_literally_zero() {
            return self;
        }
        let (a, b) = (self.used(), other.used());
        a.sum(b, a.value.plus(b.value), false)
    }

    fn minus(self, other: Self) -> Self {
        if other.is_literally_zero() {
            return self;
        }
        if self.is_literally_zero() {
            return other.negated();
        }
        let (a, b) = (self.used(), other.used());
        a.sum(b, a.value.minus(b.value), true)
    }

    fn times(self, other: Self) -> Self {
        if self.is_literally_zero() || other.is_literally_zero() {
            return Self::ZERO;
        }
        if let (Kind::Root(place), Kind::Root(other)) = (self.kind, other.kind)
            && place == other
            && let Some((_, radicand)) = session(|session: &mut Session<F>| session.taken.get(&place).copied())
        {
            return Modular { kind: Kind::Rest, ..radicand };
        }
        let (this, other) = match (self.kind, other.kind) {
            (Kind::Whole(1), _) => return other,
            (_, Kind::Whole(1)) => return self,
            _ => (self.used(), other.used()),
        };
        this.product(other)
    }

    fn over(self, other: Self) -> Self {
        if other.kind == Kind::Whole(1) {
            return self;
        }
        self.used().quotient(other.used())
    }

    fn negated(self) -> Self {
        let number = self.used();
        let kind = match number.kind {
            Kind::Rest | Kind::Root(_) => Kind::Rest,
            Kind::Whole(n) if n != i32::MIN => Kind::Whole(-n),
            Kind::Whole(_) | Kind::Ratio(_) => session(|session| {
                let ratio = self.ratio(session).and_then(Ratio::negated);
                Self::of_ratio(ratio, session)
            }),
            Kind::Angle(_) => session(|session| self.scaled_angle(Ratio::whole(-1), Residue::whole(-1), session)),
        };
        Modular { value: number.value.negated(), kind, ..number }
    }

    fn power(self, n: i32) -> Self {
        power_by_squaring(self, n)
    }

    fn real_power(self, n: f64) -> Self {
        if n.fract() == 0.0 && n.abs() <= 1024.0 {
            return self.power(n as i32);
        }
        if (2.0 * n).fract() == 0.0 && n.abs() <= 512.0 {
            return self.root().power((2.0 * n) as i32);
        }
        Self::refused("a power that is neither whole nor half")
    }

    fn apply(self, function: Function) -> Self {
        match function {
            Function::Sqrt => self.root(),
            Function::Sin => self.circular().1,
            Function::Cos => self.circular().0,
            Function::Tan => {
                let (cosine, sine) = self.circular();
                sine.over(cosine)
            }
            Function::Cbrt => Self::refused("a cube root"),
            Function::Exp => self.exponential(),
            Function::ExpM1 => self.exponential().minus(Self::ONE),
            Function::Sinh | Function::Cosh | Function::Tanh => {
                let (up, down) = (self.exponential(), self.negated().exponential());
                match function {
                    Function::Sinh => up.minus(down).over(Self::constant(2.0)),
                    Function::Cosh => up.plus(down).over(Self::constant(2.0)),
                    _ => up.minus(down).over(up.plus(down)),
                }
            }
            Function::Ln => self.logarithm(),
            Function::Ln1p => self.plus(Self::ONE).logarithm(),
            Function::Asin | Function::Acos | Function::Atan | Function::Asinh | Function::Acosh | Function::Atanh => {
                Self::refused("an inverse function")
            }
        }
    }

    fn angle_from(self, _: Self) -> Self {
        Self::refused("the angle of a point")
    }

    fn sine_cosine(self) -> (Self, Self) {
        let (cosine, sine) = self.circular();
        (sine, cosine)
    }

    fn order(self, other: Self) -> Option<Ordering> {
        let (this, other) = (self.used(), other.used());
        if this.value == other.value {
            return Some(Ordering::Equal);
        }
        match session(|session| this.ratio(session).zip(other.ratio(session))) {
            Some((a, b)) => a.value().partial_cmp(&b.value()),
            None => {
                Self::refused("an absolute value, or which of two numbers is larger");
                None
            }
        }
    }

    fn same(self, other: Self) -> bool {
        // whether a root is 0, or the same root, is known without its value
        if other.is_literally_zero() || self.is_literally_zero() || self.kind == other.kind {
            return self.value == other.value;
        }
        self.used().value == other.used().value
    }
}

impl<F: Modulus> fmt::Display for Modular<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} (mod {}·2^{} − 1)", self.value.value(), F::ODD, F::BITS)
    }
}

dual_number!(Modular<F: Modulus>);
