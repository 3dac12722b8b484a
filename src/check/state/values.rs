//! Conversions between values at the instant and series in time.

use nalgebra::{DMatrix, Matrix3};

use crate::Result;
use crate::formula::Value;
use crate::formula::evaluate::Unavailable;
use crate::scalar::{Number, Primal, Series};

/// The values of all members of a family, in order.
pub(crate) type MemberValues<B> = Vec<Value<Series<B>>>;

/// A value, or the reason why there is none.
pub(crate) type Valued<B> = Result<Value<Series<B>>, Unavailable>;

/// A 3 × 3 matrix as a value.
pub(crate) fn matrix<D: Number>(m: &Matrix3<D>) -> Value<D> {
    Value::Matrix(DMatrix::from_fn(3, 3, |i, j| m[(i, j)]))
}

/// The value of a series at the instant.
pub(crate) fn first<B: Number>(value: &Value<Series<B>>) -> Value<Primal<B>> {
    value.each(|x| Primal(x.value()))
}

/// A value as a series with one term.
pub(crate) fn lifted<B: Number>(value: &Value<Primal<B>>) -> Value<Series<B>> {
    value.each(|x| Series::of_value(x.0))
}
