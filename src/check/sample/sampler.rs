//! The sampler: random numbers for a state, independent and away from special values, where false claims may hold.
//!
//! Angles stay away from the multiples of π/2, numbers from zero, and similar symbols from each other. The random
//! stream depends on the seed and the claim only, so that `--only` and the number of threads do not change it.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

use crate::notes::claims::{Count, Range};

use crate::check::model::meaning::is_angle;
use crate::check::model::sampling::Spread;
use crate::check::state::numbers::Slot;

/// The smallest |sin| and |cos| of a drawn angle.
const MARGIN: f64 = 0.1;

/// The largest number of turns of an angle, in either direction.
const TURNS: f64 = 8.0;

/// A seeded stream of numbers.
pub struct Sampler {
    generator: Pcg64Mcg,
}

impl Sampler {
    /// The stream of a claim, named by `topic`.
    pub fn new(seed: u64, topic: &str) -> Self {
        // FNV-1a: any fixed mixing of the name into the seed will do.
        let mix = topic
            .bytes()
            .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3));
        Sampler { generator: Pcg64Mcg::seed_from_u64(seed ^ mix) }
    }

    /// A seed for another stream.
    pub fn seed(&mut self) -> u64 {
        self.generator.next_u64()
    }

    /// A uniform number between 0 and 1.
    pub fn unit(&mut self) -> f64 {
        (self.generator.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A number between `low` and `high`, both positive, uniform in its logarithm.
    fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    /// A random value of a range.
    pub fn value(&mut self, range: &Range, spread: Spread) -> f64 {
        let (small, large) = match spread {
            Spread::Declared | Spread::OrderOne => (0.3, 3.0),
            Spread::BeyondRanges => (0.1, 10.0),
            Spread::WithEnds if self.unit() < 0.5 => (0.3, 3.0),
            Spread::WithEnds | Spread::AllMagnitudes => (1e-4, 1e4),
        };
        let relaxed = spread == Spread::BeyondRanges;
        match range {
            Range::Positive => self.magnitude(small, large),
            Range::Negative => -self.magnitude(small, large),
            Range::Any => {
                let size = self.magnitude(small, large);
                if self.unit() < 0.5 { -size } else { size }
            }
            Range::Angle => {
                let turns = if spread == Spread::AllMagnitudes { TURNS } else { 0.5 };
                self.angle(-turns * std::f64::consts::TAU, turns * std::f64::consts::TAU)
            }
            Range::Interval { low, high, low_open, high_open } => {
                let width = high - low;
                if relaxed && !is_angle(range) {
                    // A little beyond or far beyond the range, so that a narrow range does not hide a difference.
                    let far = self.magnitude(0.1, 10.0) * low.abs().max(high.abs());
                    let near = self.between(low - width, high + width);
                    let side = if *high <= 0.0 || *low < 0.0 && self.unit() < 0.5 { -1.0 } else { 1.0 };
                    return if self.unit() < 0.5 { near } else { side * far };
                }
                if spread == Spread::WithEnds && self.unit() < 0.2 {
                    let end = if self.unit() < 0.5 { (low, low_open) } else { (high, high_open) };
                    if !end.1 {
                        return *end.0;
                    }
                }
                let margin = if spread == Spread::AllMagnitudes { 1e-3 } else { 0.05 };
                let keep = |open: bool| if open { margin * width } else { 0.0 };
                let (mut low, mut high) = (low + keep(*low_open), high - keep(*high_open));
                if spread == Spread::OrderOne && low < large && high > -large {
                    (low, high) = (low.max(-large), high.min(large));
                }
                if is_angle(range) { self.angle(low, high) } else { self.between(low, high) }
            }
            // Vectors and indices are drawn elsewhere.
            Range::Rigid { .. }
            | Range::Of(_)
            | Range::FixedDirection
            | Range::Labels { .. }
            | Range::Matrix(..)
            | Range::Complex
            | Range::ImaginaryUnit
            | Range::Rate
            | Range::Given => self.value(&Range::Any, spread),
            Range::Integer { low, high } => {
                let high = last(high, *low);
                (*low as f64 + (self.unit() * (high - low + 1) as f64).floor()).min(high as f64)
            }
        }
    }

    fn angle(&mut self, low: f64, high: f64) -> f64 {
        let mut angle = self.between(low, high);
        for _ in 0..32 {
            if angle.sin().abs() >= MARGIN && angle.cos().abs() >= MARGIN {
                break;
            }
            angle = self.between(low, high);
        }
        angle
    }

    /// A random base: a value for each slot, with similar numbers apart from each other.
    pub fn draw_base(&mut self, slots: &[Slot], spread: Spread) -> Vec<f64> {
        let mut base: Vec<f64> = Vec::with_capacity(slots.len());
        for slot in slots {
            // Numbers of a large group need not be apart from each other, nor uniform in their logarithm.
            if slot.one_of_many && slot.range == Range::Any && spread == Spread::Declared {
                let value = self.between(-2.5, 2.5);
                base.push(value + 0.3_f64.copysign(value));
                continue;
            }
            let mut value = self.value(&slot.range, spread);
            let tries = if slot.one_of_many { 0 } else { 16 };
            for _ in 0..tries {
                let near = |other: &f64| (value - other).abs() < 0.05 * value.abs().max(other.abs());
                let alike =
                    slots.iter().zip(&base).filter(|(other, _)| other.order == slot.order && !other.one_of_many);
                if !alike.map(|(_, other)| other).any(near) {
                    break;
                }
                value = self.value(&slot.range, spread);
            }
            base.push(value);
        }
        base
    }
}

/// The last number of an integer range.
pub fn last(high: &Count, low: i64) -> i64 {
    match high {
        Count::Number(high) => *high,
        Count::Symbol(_) => low + 3,
    }
}

/// The distance from an end of an interval, in units of its length, at which a number may be the end but for rounding.
const ROUNDING: f64 = 1e-9;

/// Whether a value lies in a range.
pub fn contains(range: &Range, value: f64) -> bool {
    match range {
        Range::Positive => value > 0.0,
        Range::Negative => value < 0.0,
        Range::Any
        | Range::Angle
        | Range::Rigid { .. }
        | Range::Of(_)
        | Range::FixedDirection
        | Range::Labels { .. }
        | Range::Matrix(..)
        | Range::Complex
        | Range::ImaginaryUnit
        | Range::Rate
        | Range::Given => value.is_finite(),
        Range::Interval { low, high, low_open, high_open } => {
            // An excluded end that a solver reaches to rounding is excluded.
            let rounding = ROUNDING * (high - low);
            let above = if *low_open { value - low > rounding } else { value >= *low };
            let below = if *high_open { high - value > rounding } else { value <= *high };
            above && below
        }
        Range::Integer { low, high } => {
            value.fract() == 0.0 && (*low as f64..=last(high, *low) as f64).contains(&value)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_drawn_lies_in_its_range() {
        let pi = std::f64::consts::PI;
        let ranges = [
            Range::Positive,
            Range::Negative,
            Range::Any,
            Range::Interval { low: 0.0, high: pi, low_open: true, high_open: true },
            Range::Interval { low: 0.2, high: 0.3, low_open: false, high_open: false },
            Range::Integer { low: 2, high: Count::Number(5) },
        ];
        let mut draw = Sampler::new(1, "test");
        for range in &ranges {
            for _ in 0..200 {
                assert!(contains(range, draw.value(range, Spread::Declared)), "{range:?}");
            }
        }
    }

    #[test]
    fn the_stream_depends_on_seed_and_topic_alone() {
        let first = |seed, topic| Sampler::new(seed, topic).unit();
        assert_eq!(first(1, "6.73"), first(1, "6.73"));
        assert_ne!(first(1, "6.73"), first(2, "6.73"));
        assert_ne!(first(1, "6.73"), first(1, "6.74"));
    }
}
