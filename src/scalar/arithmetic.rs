//! The functions that a new number must have ([`Arithmetic`]), and the macro `dual_number!` that derives all operators
//! and traits of a [`num_dual::DualNum`] from them.

use std::cmp::Ordering;
use std::fmt::Debug;

use num_dual::DualNum;

use super::number::Number;
use super::rational::Ratio;

/// The elementary functions of one variable that a number must know.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)] // each is the function it is named after
pub enum Function {
    Sqrt,
    Cbrt,
    Exp,
    ExpM1,
    Ln,
    Ln1p,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Asinh,
    Acosh,
    Atanh,
}

impl Function {
    /// The function's value at `x`, over any number.
    pub fn of<D: DualNum>(self, x: D) -> D {
        match self {
            Function::Sqrt => x.sqrt(),
            Function::Cbrt => x.cbrt(),
            Function::Exp => x.exp(),
            Function::ExpM1 => x.exp_m1(),
            Function::Ln => x.ln(),
            Function::Ln1p => x.ln_1p(),
            Function::Sin => x.sin(),
            Function::Cos => x.cos(),
            Function::Tan => x.tan(),
            Function::Asin => x.asin(),
            Function::Acos => x.acos(),
            Function::Atan => x.atan(),
            Function::Sinh => x.sinh(),
            Function::Cosh => x.cosh(),
            Function::Tanh => x.tanh(),
            Function::Asinh => x.asinh(),
            Function::Acosh => x.acosh(),
            Function::Atanh => x.atanh(),
        }
    }
}

/// What a `Copy` type must be able to do to become a number; `dual_number!` derives the rest.
///
/// The order (and with it equality, sign and absolute value) is that of [`real`](Arithmetic::real) unless a type says
/// otherwise: code that branches then takes the path that real-valued code would take.
pub trait Arithmetic: Copy + Debug + Send + Sync + 'static {
    /// The number this one is built over; `f64` when it is built over nothing.
    type Inner: Number;
    /// The highest derivative that the number carries.
    const DERIVATIVES: usize = 0;

    /// The number that does not vary.
    fn constant(value: Self::Inner) -> Self;
    /// The constant that decimal digits write.
    fn decimal(digits: &str) -> Option<Self> {
        Self::Inner::decimal(digits).map(Self::constant)
    }
    /// The constant π.
    fn pi() -> Self {
        Self::constant(Self::Inner::pi())
    }
    /// A number that is 0 up to this error; `None` for numbers that must be exact.
    fn uncertain(error: f64) -> Option<Self> {
        Self::Inner::uncertain(error).map(Self::constant)
    }
    /// The real value, on which branches are decided.
    fn real(self) -> f64;
    /// The real value, if it has one: what is traced has none but for constants.
    fn known_value(self) -> Option<f64> {
        Some(self.real())
    }
    /// Sum.
    fn plus(self, other: Self) -> Self;
    /// Difference.
    fn minus(self, other: Self) -> Self;
    /// Product.
    fn times(self, other: Self) -> Self;
    /// Quotient.
    fn over(self, other: Self) -> Self;
    /// The opposite.
    fn negated(self) -> Self;
    /// Power with an integer exponent; must have finite derivatives at 0 for n ≥ 0.
    fn power(self, n: i32) -> Self;
    /// Power with a real exponent.
    fn real_power(self, n: f64) -> Self;
    /// Power with a rational exponent.
    fn rational_power(self, n: Ratio) -> Self {
        self.real_power(n.value())
    }
    /// An elementary function of this number.
    fn apply(self, function: Function) -> Self;
    /// The angle of the point (x, self), in (−π, π].
    fn angle_from(self, x: Self) -> Self;
    /// Sine and cosine together, where that is cheaper.
    fn sine_cosine(self) -> (Self, Self) {
        (self.apply(Function::Sin), self.apply(Function::Cos))
    }
    /// The order of two numbers, `None` where there is none.
    fn order(self, other: Self) -> Option<Ordering> {
        self.real().partial_cmp(&other.real())
    }
    /// Whether two numbers are the same, for numbers that can tell this and have no order.
    fn same(self, other: Self) -> bool {
        self.order(other) == Some(Ordering::Equal)
    }
}

/// Integer power by squaring, for the numbers whose product is all they need.
pub(crate) fn power_by_squaring<D: Arithmetic>(base: D, n: i32) -> D {
    let one = D::constant(1.0.into());
    let (mut result, mut square, mut left) = (None, base, n.unsigned_abs());
    while left > 0 {
        if left & 1 == 1 {
            result = Some(result.map_or(square, |r: D| r.times(square)));
        }
        left >>= 1;
        if left > 0 {
            square = square.times(square);
        }
    }
    match result {
        None => one,
        Some(r) if n < 0 => one.over(r),
        Some(r) => r,
    }
}

/// Makes a type with [`Arithmetic`] a [`num_dual::DualNum`]: `dual_number!(RunningError)`, `dual_number!(Series<B:
/// Number>)`.
macro_rules! dual_number {
    ($name:ident $(<$b:ident: $bound:path>)?) => {
        const _: () = {
            use $crate::scalar::{Arithmetic, Function};
            use num_dual::{DualNum, DualStruct, Mappable};
            use num_traits::{FromPrimitive, Inv, Num, One, Signed, Zero};
            use std::cmp::Ordering;
            use std::iter::{Product, Sum};
            use std::ops::*;

            dual_number!(@operator [$name $(<$b: $bound>)?] Add add plus AddAssign add_assign);
            dual_number!(@operator [$name $(<$b: $bound>)?] Sub sub minus SubAssign sub_assign);
            dual_number!(@operator [$name $(<$b: $bound>)?] Mul mul times MulAssign mul_assign);
            dual_number!(@operator [$name $(<$b: $bound>)?] Div div over DivAssign div_assign);
            dual_number!(@operator [$name $(<$b: $bound>)?] Rem rem remainder RemAssign rem_assign);

            impl$(<$b: $bound>)? $name$(<$b>)? {
                fn remainder(self, other: Self) -> Self {
                    self - other * (self.real() / other.real()).trunc()
                }
            }
            impl$(<$b: $bound>)? Neg for $name$(<$b>)? {
                type Output = Self;
                fn neg(self) -> Self {
                    self.negated()
                }
            }
            impl$(<$b: $bound>)? Inv for $name$(<$b>)? {
                type Output = Self;
                fn inv(self) -> Self {
                    self.recip()
                }
            }
            impl$(<$b: $bound>)? From<f64> for $name$(<$b>)? {
                fn from(value: f64) -> Self {
                    Self::constant(<Self as Arithmetic>::Inner::from(value))
                }
            }
            impl$(<$b: $bound>)? FromPrimitive for $name$(<$b>)? {
                fn from_i64(n: i64) -> Option<Self> {
                    f64::from_i64(n).map(Self::from)
                }
                fn from_u64(n: u64) -> Option<Self> {
                    f64::from_u64(n).map(Self::from)
                }
                fn from_f64(n: f64) -> Option<Self> {
                    Some(Self::from(n))
                }
            }
            impl$(<$b: $bound>)? PartialEq for $name$(<$b>)? {
                fn eq(&self, other: &Self) -> bool {
                    self.same(*other)
                }
            }
            impl$(<$b: $bound>)? PartialEq<f64> for $name$(<$b>)? {
                fn eq(&self, other: &f64) -> bool {
                    *self == Self::from(*other)
                }
            }
            impl$(<$b: $bound>)? PartialOrd for $name$(<$b>)? {
                fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                    self.order(*other)
                }
            }
            impl$(<$b: $bound>)? PartialOrd<f64> for $name$(<$b>)? {
                fn partial_cmp(&self, other: &f64) -> Option<Ordering> {
                    self.order(Self::from(*other))
                }
            }
            impl$(<$b: $bound>)? Zero for $name$(<$b>)? {
                fn zero() -> Self {
                    Self::from(0.0)
                }
                fn is_zero(&self) -> bool {
                    *self == 0.0
                }
            }
            impl$(<$b: $bound>)? One for $name$(<$b>)? {
                fn one() -> Self {
                    Self::from(1.0)
                }
            }
            impl$(<$b: $bound>)? Num for $name$(<$b>)? {
                type FromStrRadixErr = <f64 as Num>::FromStrRadixErr;
                fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
                    f64::from_str_radix(text, radix).map(Self::from)
                }
            }
            impl$(<$b: $bound>)? Signed for $name$(<$b>)? {
                fn abs(&self) -> Self {
                    if *self < 0.0 { self.negated() } else { *self }
                }
                fn abs_sub(&self, other: &Self) -> Self {
                    if self <= other { Self::zero() } else { *self - *other }
                }
                fn signum(&self) -> Self {
                    if *self < 0.0 { -Self::one() } else if *self > 0.0 { Self::one() } else { Self::zero() }
                }
                fn is_positive(&self) -> bool {
                    *self > 0.0
                }
                fn is_negative(&self) -> bool {
                    *self < 0.0
                }
            }
            impl$(<$b: $bound>)? Sum for $name$(<$b>)? {
                fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
                    terms.fold(Self::zero(), |sum, term| sum + term)
                }
            }
            impl$(<$b: $bound>)? Product for $name$(<$b>)? {
                fn product<I: Iterator<Item = Self>>(factors: I) -> Self {
                    factors.fold(Self::one(), |product, factor| product * factor)
                }
            }
            impl$(<$b: $bound>)? DualStruct for $name$(<$b>)? {
                type Real = f64;
                type Inner = <Self as Arithmetic>::Inner;
                fn re(&self) -> f64 {
                    self.real()
                }
                fn from_inner(inner: &<Self as Arithmetic>::Inner) -> Self {
                    Self::constant(inner.clone())
                }
            }
            impl$(<$b: $bound>)? Mappable<Self> for $name$(<$b>)? {
                type Output<O> = O;
                fn map_dual<M: Fn(Self) -> O, O>(self, f: M) -> O {
                    f(self)
                }
            }
            impl$(<$b: $bound>)? $crate::scalar::Number for $name$(<$b>)? {
                fn decimal(digits: &str) -> Option<Self> {
                    <Self as Arithmetic>::decimal(digits)
                }
                fn pi() -> Self {
                    <Self as Arithmetic>::pi()
                }
                fn uncertain(error: f64) -> Option<Self> {
                    <Self as Arithmetic>::uncertain(error)
                }
                fn rational_power(self, exponent: $crate::scalar::Ratio) -> Self {
                    Arithmetic::rational_power(self, exponent)
                }
                fn known_value(&self) -> Option<f64> {
                    Arithmetic::known_value(*self)
                }
            }
            impl$(<$b: $bound>)? DualNum for $name$(<$b>)? {
                type Primitive = f64;
                const NDERIV: usize = <Self as Arithmetic>::DERIVATIVES;
                type InnerDual = <Self as Arithmetic>::Inner;

                fn from_re(re: Self::InnerDual) -> Self {
                    Self::constant(re)
                }
                fn scale(self, factor: &Self::InnerDual) -> Self {
                    self * Self::constant(factor.clone())
                }
                fn recip(&self) -> Self {
                    Self::one().over(*self)
                }
                fn powi(&self, n: i32) -> Self {
                    self.power(n)
                }
                fn powf(&self, n: f64) -> Self {
                    self.real_power(n)
                }
                fn sin_cos(&self) -> (Self, Self) {
                    self.sine_cosine()
                }
                fn atan2(&self, x: Self) -> Self {
                    self.angle_from(x)
                }
                fn exp2(&self) -> Self {
                    (*self * std::f64::consts::LN_2).exp()
                }
                fn log(&self, base: f64) -> Self {
                    self.ln() / base.ln()
                }
                fn log2(&self) -> Self {
                    self.ln() / std::f64::consts::LN_2
                }
                fn log10(&self) -> Self {
                    self.ln() / std::f64::consts::LN_10
                }
                // near 0 the quotients lose everything; the first terms of the series do not
                fn sph_j0(&self) -> Self {
                    if self.abs() < f64::EPSILON { Self::one() - *self * *self / 6.0 } else { self.sin() / *self }
                }
                fn sph_j1(&self) -> Self {
                    if self.abs() < f64::EPSILON {
                        return *self / 3.0;
                    }
                    let (sine, cosine) = self.sin_cos();
                    (sine / *self - cosine) / *self
                }
                fn sph_j2(&self) -> Self {
                    if self.abs() < f64::EPSILON {
                        return *self * *self / 15.0;
                    }
                    let (sine, cosine) = self.sin_cos();
                    let square = *self * *self;
                    ((Self::from(3.0) - square) * sine - *self * cosine * 3.0) / (*self * square)
                }
                dual_number!(@functions sqrt Sqrt, cbrt Cbrt, exp Exp, exp_m1 ExpM1, ln Ln, ln_1p Ln1p, sin Sin,
                    cos Cos, tan Tan, asin Asin, acos Acos, atan Atan, sinh Sinh, cosh Cosh, tanh Tanh,
                    asinh Asinh, acosh Acosh, atanh Atanh);
            }
        };
    };
    (@functions $($method:ident $function:ident),*) => {
        $(fn $method(&self) -> Self {
            self.apply(Function::$function)
        })*
    };
    (@operator [$name:ident $(<$b:ident: $bound:path>)?] $trait:ident $method:ident $core:ident $assign:ident $in_place:ident) => {
        impl$(<$b: $bound>)? $trait for $name$(<$b>)? {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                self.$core(other)
            }
        }
        impl$(<$b: $bound>)? $trait<&Self> for $name$(<$b>)? {
            type Output = Self;
            #[inline]
            fn $method(self, other: &Self) -> Self {
                self.$core(*other)
            }
        }
        impl$(<$b: $bound>)? $trait<f64> for $name$(<$b>)? {
            type Output = Self;
            #[inline]
            fn $method(self, other: f64) -> Self {
                self.$core(Self::from(other))
            }
        }
        impl$(<$b: $bound>)? $assign for $name$(<$b>)? {
            #[inline]
            fn $in_place(&mut self, other: Self) {
                *self = self.$core(other);
            }
        }
        impl$(<$b: $bound>)? $assign<&Self> for $name$(<$b>)? {
            #[inline]
            fn $in_place(&mut self, other: &Self) {
                *self = self.$core(*other);
            }
        }
        impl$(<$b: $bound>)? $assign<f64> for $name$(<$b>)? {
            #[inline]
            fn $in_place(&mut self, other: f64) {
                *self = self.$core(Self::from(other));
            }
        }
    };
}
pub(crate) use dual_number;
