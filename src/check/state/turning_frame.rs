//! The frame of a document that turns, at a sampled state: its axes and its angular velocity, computed when asked for.

use std::cell::OnceCell;

use nalgebra::{Matrix3, Vector3};

use crate::check::model::meaning;
use crate::check::state::numbers::Base;
use crate::mechanics::{Frame, rotations};
use crate::scalar::{Number, Primal, Series, TERMS};

/// How fast the frame turns, if there is one.
type AngularVelocity<B> = Option<Box<Vector3<Series<B>>>>;

/// Coefficients of the axes of a frame, if there is one.
type Axes<B> = Option<Box<Matrix3<Primal<B>>>>;

/// The frame that turns, in as many terms as were needed. All components are along the space axes.
pub(crate) struct TurningFrame<B: Number> {
    kind: Option<meaning::Frame>,
    /// How many coefficients are known of what is drawn.
    terms: usize,
    /// The frame, known to so many terms as its place here says.
    frames: [OnceCell<Option<Box<Frame<B>>>>; TERMS + 2],
    /// Its axes' coefficients of each order.
    axes: [OnceCell<Axes<B>>; TERMS],
    /// Its angular velocity at the instant.
    angular_velocity_now: OnceCell<Option<Vector3<Primal<B>>>>,
    /// Its angular velocity, known to so many terms as its place here says.
    angular_velocities: [OnceCell<AngularVelocity<B>>; TERMS + 1],
}

impl<B: Number> TurningFrame<B> {
    /// A frame of which nothing was computed.
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

    /// The frame, of which so many terms are used; there may be more.
    pub(crate) fn frame(&self, base: &Base<B>, terms: usize) -> Option<&Frame<B>> {
        let terms = terms.min(self.terms + 1);
        let known = || self.frames.get(terms..)?.iter().find_map(OnceCell::get);
        let compute = || base.frame(self.kind?, terms).map(Box::new);
        match known() {
            Some(known) => known.as_deref(),
            None => self.frames.get(terms)?.get_or_init(compute).as_deref(),
        }
    }

    /// The coefficients, of an order, of the axes, as rows: of order 0 the axes at the instant.
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

    /// The angular velocity, of which so many terms are used; there may be more.
    pub(crate) fn angular_velocity(&self, base: &Base<B>, terms: usize) -> Option<Vector3<Series<B>>> {
        let terms = terms.min(self.terms);
        let compute = || self.frame(base, terms + 1).map(|frame| Box::new(frame.angular_velocity()));
        self.angular_velocities.get(terms)?.get_or_init(compute).as_deref().copied()
    }
}
