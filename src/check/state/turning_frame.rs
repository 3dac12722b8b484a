//! The turning frame of a document at a sampled state: its axes and angular velocity, computed on demand.

use std::cell::OnceCell;

use nalgebra::{Matrix3, Vector3};

use crate::check::model::meaning;
use crate::check::state::numbers::Base;
use crate::mechanics::{Frame, rotations};
use crate::scalar::{Number, Primal, Series, TERMS};

/// The angular velocity of the frame, if there is one.
type AngularVelocity<B> = Option<Box<Vector3<Series<B>>>>;

/// The series coefficients of the axes of the frame, if there is one.
type Axes<B> = Option<Box<Matrix3<Primal<B>>>>;

/// The turning frame, with as many terms as were needed. All components are along the space axes.
pub(crate) struct TurningFrame<B: Number> {
    kind: Option<meaning::Frame>,
    /// The number of terms of drawn functions.
    terms: usize,
    /// The frame; the place in the array is the number of terms.
    frames: [OnceCell<Option<Box<Frame<B>>>>; TERMS + 2],
    /// The series coefficients of the axes, by order.
    axes: [OnceCell<Axes<B>>; TERMS],
    /// The angular velocity at the instant.
    angular_velocity_now: OnceCell<Option<Vector3<Primal<B>>>>,
    /// The angular velocity; the place in the array is the number of terms.
    angular_velocities: [OnceCell<AngularVelocity<B>>; TERMS + 1],
}

impl<B: Number> TurningFrame<B> {
    /// A frame before any computation.
    pub(crate) fn new(kind: Option<meaning::Frame>, terms: usize) -> Self {
        TurningFrame {
            kind,
            terms,
            frames: std::array::from_fn(|_| OnceCell::new()),
            axes: std::array::from_fn(|_| OnceCell::new()),
            angular_velocity_now: OnceCell::new(),
            angular_velocities: std::array::from_fn(|_| OnceCell::new()),
        }
    }

    /// The frame, to at least this number of terms.
    pub(crate) fn frame(&self, base: &Base<B>, terms: usize) -> Option<&Frame<B>> {
        let terms = terms.min(self.terms + 1);
        let known = || self.frames.get(terms..)?.iter().find_map(OnceCell::get);
        let compute = || base.frame(self.kind?, terms).map(Box::new);
        match known() {
            Some(known) => known.as_deref(),
            None => self.frames.get(terms)?.get_or_init(compute).as_deref(),
        }
    }

    /// The series coefficients of one order of the axes, as rows: for order 0 the axes at the instant.
    pub(crate) fn axes(&self, base: &Base<B>, order: usize) -> Option<&Matrix3<Primal<B>>> {
        let known = || self.frames[1..].iter().find_map(|frame| frame.get()?.as_ref());
        let compute = || {
            let frame = match order {
                0 if known().is_none() => return base.axes(self.kind?).map(Box::new),
                0 => known()?,
                order if order < self.terms => self.frame(base, order + 1)?,
                _ => return None,
            };
            let all = frame.orientation();
            let is_there = all.iter().all(|entry| entry.coefficient(order).is_some());
            is_there.then(|| Box::new(all.map(|entry| Primal(entry.coefficient(order).unwrap_or(B::zero())))))
        };
        self.axes.get(order)?.get_or_init(compute).as_deref()
    }

    /// The angular velocity at the instant.
    pub(crate) fn angular_velocity_now(&self, base: &Base<B>) -> Option<Vector3<Primal<B>>> {
        let compute = || {
            let frame = self.frame(base, 2)?;
            let rate = self.axes(base, 1)?.map(|entry| Primal(Series::rate_of(entry.0, 1)));
            Some(rotations::angular_velocity(&frame.orientation().map(|entry| Primal(entry.value())), &rate))
        };
        *self.angular_velocity_now.get_or_init(compute)
    }

    /// The angular velocity, to at least this number of terms.
    pub(crate) fn angular_velocity(&self, base: &Base<B>, terms: usize) -> Option<Vector3<Series<B>>> {
        let terms = terms.min(self.terms);
        let compute = || self.frame(base, terms + 1).map(|frame| Box::new(frame.angular_velocity()));
        self.angular_velocities.get(terms)?.get_or_init(compute).as_deref().copied()
    }
}
