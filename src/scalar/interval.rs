//! Interval arithmetic in doubles: the bounds of a formula while its numbers run over whole ranges.
//!
//! Each result contains all values that the operation has on the intervals that go in. Ends are rounded outwards: by one
//! step for the four operations and the square root, which IEEE 754 rounds correctly, and by [`STEPS`] for the
//! elementary functions, of which C libraries keep within one (R. E. Moore, *Interval Analysis*, 1966). Ends may be
//! infinite. Where an operation has no value at any point, the interval is empty.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The number of doubles by which an elementary function may be off.
const STEPS: u32 = 4;

/// The largest angle whose sine is bounded by more than ±1.
const LARGEST_ANGLE: f64 = 1e9;

/// All numbers between two ends, with both; none, if the lower end is above the upper one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

fn down(x: f64, steps: u32) -> f64 {
    (0..steps).fold(x, |x, _| x.next_down())
}

fn up(x: f64, steps: u32) -> f64 {
    (0..steps).fold(x, |x, _| x.next_up())
}

/// The product of two ends, of which 0 times infinity is 0. It is 0 only if one of them is.
fn times(a: f64, b: f64) -> f64 {
    match a * b {
        _ if a == 0.0 || b == 0.0 => 0.0,
        0.0 => f64::from_bits(1).copysign(a * b),
        product => product,
    }
}

impl Interval {
    /// The interval without a number.
    pub const EMPTY: Self = Interval { low: f64::INFINITY, high: f64::NEG_INFINITY };
    /// All real numbers.
    pub const ALL: Self = Interval { low: f64::NEG_INFINITY, high: f64::INFINITY };
    /// All numbers that are not negative.
    pub const POSITIVE: Self = Interval { low: 0.0, high: f64::INFINITY };
    /// All that are not positive.
    pub const NEGATIVE: Self = Interval { low: f64::NEG_INFINITY, high: 0.0 };

    /// The numbers from `low` to `high`; all numbers, if one of them is no number.
    pub fn new(low: f64, high: f64) -> Self {
        if low.is_nan() || high.is_nan() { Self::ALL } else { Interval { low, high } }
    }

    /// The number `x` alone.
    pub fn point(x: f64) -> Self {
        Self::new(x, x)
    }

    /// What is between `low` and `high` that were rounded to the nearest doubles.
    fn rounded(low: f64, high: f64) -> Self {
        Self::new(down(low, 1), up(high, 1))
    }

    fn of_function(low: f64, high: f64) -> Self {
        Self::new(down(low, STEPS), up(high, STEPS))
    }

    /// π.
    pub fn pi() -> Self {
        Interval { low: PI, high: PI.next_up() }
    }

    /// The bounds of what a decimal writes.
    pub fn decimal(digits: &str) -> Option<Self> {
        let x: f64 = digits.parse().ok()?;
        let is_exact = x.fract() == 0.0 && x.abs() < 1e15 && digits.bytes().all(|b| b.is_ascii_digit());
        Some(if is_exact { Self::point(x) } else { Self::rounded(x, x) })
    }

    /// Whether there is no number in it.
    pub fn is_empty(self) -> bool {
        self.low > self.high
    }

    /// Whether a number is in it.
    pub fn contains(self, x: f64) -> bool {
        self.low <= x && x <= self.high
    }

    /// The numbers of both.
    pub fn intersection(self, other: Self) -> Self {
        Interval { low: self.low.max(other.low), high: self.high.min(other.high) }
    }

    /// The distance of the ends.
    pub fn width(self) -> f64 {
        self.high - self.low
    }

    /// A number well inside, of moderate size if an end is infinite.
    pub fn middle(self) -> f64 {
        match (self.low.is_finite(), self.high.is_finite()) {
            (true, true) if self.low > 0.0 && self.high > 4.0 * self.low => (self.low * self.high).sqrt(),
            (true, true) if self.high < 0.0 && self.low < 4.0 * self.high => -(self.low * self.high).sqrt(),
            (true, true) => 0.5 * self.low + 0.5 * self.high,
            (true, false) if self.low > 0.0 => 4.0 * self.low,
            (true, false) => (self.low / 4.0).max(1.0),
            (false, true) if self.high < 0.0 => 4.0 * self.high,
            (false, true) => (self.high / 4.0).min(-1.0),
            (false, false) => 0.0,
        }
    }

    /// The two parts on either side of [`Interval::middle`].
    pub fn halves(self) -> [Self; 2] {
        let middle = self.middle();
        [Interval { high: middle, ..self }, Interval { low: middle, ..self }]
    }

    /// The sum.
    pub fn plus(self, other: Self) -> Self {
        if self.is_empty() || other.is_empty() {
            return Self::EMPTY;
        }
        match (self, other) {
            (a, Interval { low: 0.0, high: 0.0 }) | (Interval { low: 0.0, high: 0.0 }, a) => a,
            (a, b) => {
                let (low, high) = (a.low + b.low, a.high + b.high);
                // Ends that cancel do so exactly.
                let is_exact = |sum: f64, one: f64| sum == 0.0 && one.is_finite();
                Self::new(
                    if is_exact(low, a.low) { low } else { down(low, 1) },
                    if is_exact(high, a.high) { high } else { up(high, 1) },
                )
            }
        }
    }

    /// The opposite numbers.
    pub fn negated(self) -> Self {
        Interval { low: -self.high, high: -self.low }
    }

    /// The difference.
    pub fn minus(self, other: Self) -> Self {
        self.plus(other.negated())
    }

    /// The product.
    pub fn times(self, other: Self) -> Self {
        if self.is_empty() || other.is_empty() {
            return Self::EMPTY;
        }
        let ends = [
            times(self.low, other.low),
            times(self.low, other.high),
            times(self.high, other.low),
            times(self.high, other.high),
        ];
        let (low, high) = ends.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(*x), h.max(*x)));
        // A sign is exact: a product of numbers that are not negative is not negative.
        let keep = |end: f64, rounded: f64| if end == 0.0 { 0.0 } else { rounded };
        Self::new(keep(low, low.next_down()), keep(high, high.next_up()))
    }

    /// The quotient: all numbers, where the divisor may be 0 on both sides.
    pub fn over(self, other: Self) -> Self {
        if self.is_empty() || other.is_empty() || other == Self::point(0.0) {
            return Self::EMPTY;
        }
        if other.low < 0.0 && other.high > 0.0 {
            return Self::ALL;
        }
        let inverse = |x: f64, open: f64| if x == 0.0 { open } else { 1.0 / x };
        let reciprocal = match other.low >= 0.0 {
            true => Interval {
                low: inverse(other.high, 0.0).next_down().max(0.0),
                high: inverse(other.low, f64::INFINITY).next_up(),
            },
            false => Interval {
                low: inverse(other.high, f64::NEG_INFINITY).next_down(),
                high: inverse(other.low, 0.0).next_up().min(0.0),
            },
        };
        self.times(reciprocal)
    }

    /// The absolute values.
    pub fn abs(self) -> Self {
        match (self.is_empty(), self.low >= 0.0, self.high <= 0.0) {
            (true, ..) | (_, true, _) => self,
            (_, _, true) => self.negated(),
            _ => Interval { low: 0.0, high: self.high.max(-self.low) },
        }
    }

    /// A whole power.
    pub fn power(self, n: i32) -> Self {
        if n < 0 {
            return n.checked_neg().map_or(Self::ALL, |n| Self::point(1.0).over(self.power(n)));
        }
        if n % 2 == 0 {
            return self.abs().grown(n);
        }
        // An odd power rises everywhere.
        let end = |x: f64| if x < 0.0 { Self::point(-x).grown(n).negated() } else { Self::point(x).grown(n) };
        if self.is_empty() { self } else { Interval { low: end(self.low).low, high: end(self.high).high } }
    }

    /// A power of numbers that are not negative.
    fn grown(self, n: i32) -> Self {
        let (mut result, mut square, mut left) = (Self::point(1.0), self, n);
        while left > 0 {
            if left % 2 == 1 {
                result = result.times(square);
            }
            left /= 2;
            if left > 0 {
                square = square.times(square);
            }
        }
        result
    }

    /// The square roots of what is not negative.
    pub fn sqrt(self) -> Self {
        let Interval { low, high } = self.intersection(Self::POSITIVE);
        if low > high { Self::EMPTY } else { Self::new(low.sqrt().next_down().max(0.0), high.sqrt().next_up()) }
    }

    /// A power with any exponent, of what is not negative.
    pub fn real_power(self, exponent: Self) -> Self {
        let base = self.intersection(Self::POSITIVE);
        if base.is_empty() || exponent.is_empty() {
            return Self::EMPTY;
        }
        exponent.times(base.ln()).exp()
    }

    /// The exponentials.
    pub fn exp(self) -> Self {
        if self.is_empty() {
            return self;
        }
        Self::new(down(self.low.exp(), STEPS).max(0.0), up(self.high.exp(), STEPS))
    }

    /// The natural logarithms of what is positive.
    pub fn ln(self) -> Self {
        let part = self.intersection(Self::POSITIVE);
        if part.is_empty() || part.high == 0.0 { Self::EMPTY } else { Self::of_function(part.low.ln(), part.high.ln()) }
    }

    /// The sines.
    pub fn sin(self) -> Self {
        if self.is_empty() {
            return self;
        }
        if self.width() >= TAU || self.low.abs().max(self.high.abs()) > LARGEST_ANGLE {
            return Interval { low: -1.0, high: 1.0 };
        }
        let (a, b) = (self.low.sin(), self.high.sin());
        let mut found = Self::of_function(a.min(b), a.max(b)).intersection(Interval { low: -1.0, high: 1.0 });
        // The extrema are at π/2 + kπ. Where rounding leaves open whether one is inside, it is.
        let part = |x: f64, outward: f64| x / PI - 0.5 + outward * 1e-15 * (1.0 + x.abs());
        let (first, last) = (part(self.low, -1.0).ceil() as i64, part(self.high, 1.0).floor() as i64);
        for k in first..=last {
            match k.rem_euclid(2) {
                0 => found.high = 1.0,
                _ => found.low = -1.0,
            }
        }
        // The double next to π is below π.
        if self.low >= 0.0 && self.high <= PI {
            found.low = found.low.max(0.0);
        }
        if self.low >= -PI && self.high <= 0.0 {
            found.high = found.high.min(0.0);
        }
        found
    }

    /// The cosines.
    pub fn cos(self) -> Self {
        let quarter = Interval { low: FRAC_PI_2, high: FRAC_PI_2.next_up() };
        let found = self.plus(quarter).sin();
        // The double next to π/2 is below π/2.
        let is_right = self.low >= -FRAC_PI_2 && self.high <= FRAC_PI_2 && !found.is_empty();
        if is_right { Interval { low: found.low.max(0.0), ..found } } else { found }
    }

    /// The angles between −π/2 and π/2 with these sines.
    pub fn asin(self) -> Self {
        self.within_one(f64::asin)
    }

    /// The angles between 0 and π with these cosines.
    pub fn acos(self) -> Self {
        self.within_one(|x| -x.acos()).negated()
    }

    fn within_one(self, rising: impl Fn(f64) -> f64) -> Self {
        let part = self.intersection(Interval { low: -1.0, high: 1.0 });
        if part.is_empty() { part } else { Self::of_function(rising(part.low), rising(part.high)) }
    }

    /// A function that rises everywhere, such as arctan, sinh or tanh.
    pub fn rising(self, function: impl Fn(f64) -> f64) -> Self {
        if self.is_empty() { self } else { Self::of_function(function(self.low), function(self.high)) }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    type Operation = (&'static str, fn(Interval, Interval) -> Interval, fn(f64, f64) -> f64);

    const OPERATIONS: [Operation; 17] = [
        ("+", Interval::plus, |a, b| a + b),
        ("−", Interval::minus, |a, b| a - b),
        ("×", Interval::times, |a, b| a * b),
        ("÷", Interval::over, |a, b| a / b),
        ("|·|", |a, _| a.abs(), |a, _| a.abs()),
        ("^2", |a, _| a.power(2), |a, _| a * a),
        ("^3", |a, _| a.power(3), |a, _| a * a * a),
        ("^-3", |a, _| a.power(-3), |a, _| 1.0 / (a * a * a)),
        ("√", |a, _| a.sqrt(), |a, _| a.sqrt()),
        ("exp", |a, _| a.exp(), |a, _| a.exp()),
        ("ln", |a, _| a.ln(), |a, _| a.ln()),
        ("sin", |a, _| a.sin(), |a, _| a.sin()),
        ("cos", |a, _| a.cos(), |a, _| a.cos()),
        ("asin", |a, _| a.asin(), |a, _| a.asin()),
        ("acos", |a, _| a.acos(), |a, _| a.acos()),
        ("atan", |a, _| a.rising(f64::atan), |a, _| a.atan()),
        ("power", Interval::real_power, |a, b| if a > 0.0 { a.powf(b) } else { f64::NAN }),
    ];

    proptest! {
        #[test]
        fn the_value_at_a_point_is_within_the_bounds(
            a in -8.0..8.0_f64, b in -8.0..8.0_f64, wa in 0.0..5.0_f64, wb in 0.0..5.0_f64, s in 0.0..1.0_f64, t in 0.0..1.0_f64,
        ) {
            let (x, y) = (Interval::new(a, a + wa), Interval::new(b, b + wb));
            let (p, q) = ((a + s * wa).clamp(x.low, x.high), (b + t * wb).clamp(y.low, y.high));
            for (name, bounds, value) in OPERATIONS {
                let (value, bounds) = (value(p, q), bounds(x, y));
                // The value itself is rounded.
                let slack = 1e-13 * value.abs().max(1.0);
                let is_within = bounds.low - slack <= value && value <= bounds.high + slack;
                prop_assert!(value.is_nan() || is_within, "{name} of {p}, {q}: {value} in {bounds:?}");
            }
        }
    }

    #[test]
    fn bounds_are_sharp_where_a_sign_depends_on_them() {
        assert_eq!(Interval::new(-1.0, 2.0).power(2).low, 0.0);
        assert_eq!(Interval::new(0.0, PI).sin().low, 0.0);
        assert_eq!(Interval::new(-FRAC_PI_2, FRAC_PI_2).cos().low, 0.0);
        assert_eq!(Interval::POSITIVE.times(Interval::POSITIVE), Interval::POSITIVE);
        assert_eq!(Interval::POSITIVE.plus(Interval::point(1.0)).low, 1.0_f64.next_down());
        assert!(Interval::new(-2.0, -1.0).sqrt().is_empty());
        assert!(Interval::new(3.0, 4.0).sin().low < -0.75, "no minimum inside");
    }
}
