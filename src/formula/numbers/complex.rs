//! Complex numbers as pairs of a real and an imaginary part, over any number.
//!
//! Over a prime field too: i is a formal root of −1, and two complex numbers are equal if both parts are. So an identity
//! such as e^{iθ} = cos θ + i sin θ is decided by its parts. Functions with branches, roots and logarithms, have no
//! complex value here.

use crate::scalar::Number;

use super::super::tree::{ComplexPart, Function};

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex<D> {
    /// The real part.
    pub re: D,
    /// The imaginary part.
    pub im: D,
}

impl<D: Number> Complex<D> {
    /// √−1
    pub fn i() -> Self {
        Complex { re: D::zero(), im: D::one() }
    }

    /// A real number.
    pub fn real(re: D) -> Self {
        Complex { re, im: D::zero() }
    }

    /// The conjugate.
    pub fn conjugate(self) -> Self {
        Complex { re: self.re, im: -self.im }
    }

    /// The square of the absolute value.
    pub fn square(self) -> D {
        self.re * self.re + self.im * self.im
    }

    /// The product.
    pub fn times(self, other: Self) -> Self {
        Complex { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }

    /// The quotient.
    pub fn over(self, other: Self) -> Self {
        let (above, below) = (self.times(other.conjugate()), other.square());
        Complex { re: above.re / below, im: above.im / below }
    }

    /// A whole power.
    pub fn power(self, exponent: i32) -> Self {
        let product = (0..exponent.unsigned_abs()).fold(Self::real(D::one()), |product, _| product.times(self));
        if exponent < 0 { Self::real(D::one()).over(product) } else { product }
    }

    /// The exponential.
    pub fn exp(self) -> Self {
        let length = self.re.exp();
        Complex { re: length * self.im.cos(), im: length * self.im.sin() }
    }

    /// An entire function; `None` for one with branches.
    pub fn call(self, function: Function) -> Option<Self> {
        let Complex { re: x, im: y } = self;
        Some(match function {
            Function::Exp => self.exp(),
            Function::Sin => Complex { re: x.sin() * y.cosh(), im: x.cos() * y.sinh() },
            Function::Cos => Complex { re: x.cos() * y.cosh(), im: -(x.sin() * y.sinh()) },
            Function::Sinh => Complex { re: x.sinh() * y.cos(), im: x.cosh() * y.sin() },
            Function::Cosh => Complex { re: x.cosh() * y.cos(), im: x.sinh() * y.sin() },
            Function::Tan => self.call(Function::Sin)?.over(self.call(Function::Cos)?),
            Function::Tanh => self.call(Function::Sinh)?.over(self.call(Function::Cosh)?),
            _ => return None,
        })
    }

    /// Whether [`Complex::call`] knows a function.
    pub fn knows(function: Function) -> bool {
        use Function::{Cos, Cosh, Exp, Sin, Sinh, Tan, Tanh};
        matches!(function, Exp | Sin | Cos | Sinh | Cosh | Tan | Tanh)
    }

    /// One part; the conjugate is complex.
    pub fn part(self, part: ComplexPart) -> Result<D, Self> {
        match part {
            ComplexPart::Conjugate => Err(self.conjugate()),
            ComplexPart::Real => Ok(self.re),
            ComplexPart::Imaginary => Ok(self.im),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const Z: Complex<f64> = Complex { re: 0.7, im: -1.3 };

    fn near(a: Complex<f64>, b: Complex<f64>) -> bool {
        (a.re - b.re).abs() < 1e-12 && (a.im - b.im).abs() < 1e-12
    }

    #[test]
    fn functions_agree_with_their_exponentials() {
        let i = Complex::i();
        let (plus, minus) = (i.times(Z).exp(), i.power(3).times(Z).exp());
        let half = |a: Complex<f64>, b: Complex<f64>| Complex { re: (a.re + b.re) / 2.0, im: (a.im + b.im) / 2.0 };
        assert!(near(Z.call(Function::Cos).unwrap(), half(plus, minus)));
        assert!(!near(Z.call(Function::Cos).unwrap(), half(plus, plus)));
        let sine = half(plus, Complex { re: -minus.re, im: -minus.im }).over(i);
        assert!(near(Z.call(Function::Sin).unwrap(), sine));
        assert!(near(Z.call(Function::Sinh).unwrap(), i.times(Z).call(Function::Sin).unwrap().over(i)));
        assert_eq!(Z.call(Function::Ln), None);
    }

    #[test]
    fn powers_are_products_and_quotients() {
        assert!(near(Z.power(3).over(Z), Z.times(Z)));
        assert!(near(Z.power(-2).times(Z.power(2)), Complex::real(1.0)));
        assert!(!near(Z.power(2), Complex::real(Z.square())));
    }
}
