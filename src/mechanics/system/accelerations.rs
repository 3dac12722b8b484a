//! Fast accelerations: for one state after another without allocation, and for many states in blocks. Simulations, pictures and
//! benchmarks use them; a check takes the motion of `traced_system`.
//!
//! Both run a [`Program`] compiled from the tape of the accelerations, which solves for them without exchange of rows.
//! Its pivots show whether that lost digits. If so, the state is computed again with partial pivoting and a check of
//! the condition number.

use fearless_simd::Level;

use super::layout::Layout;
use super::traced_system::System;
use crate::mechanics::linear_solver;
use crate::mechanics::tape::blocks::{Block, LANES, Registers, Values};
use crate::mechanics::tape::program::Program;
use crate::mechanics::tape::single::Single;
use crate::{Error, Result};

/// A pivot that is smaller than this share of the diagonal entry it came from may have lost its digits.
const SMALL_PIVOT: f64 = 1e-9;

/// The accelerations of one state after another, for given parameters; made by [`System::acceleration_evaluator`].
pub struct AccelerationEvaluator<'a> {
    system: &'a System,
    parameters: Vec<f64>,
    coordinates: usize,
    single: Single,
    /// The outputs of pivots that have to be looked at; their diagonal entries come after them. Not those that no state
    /// changes and that are sound.
    pivots: Vec<usize>,
    /// Of states that needed an exchange of rows.
    with_exchange: Vec<f64>,
}

impl AccelerationEvaluator<'_> {
    /// The accelerations on shell, one a coordinate; overwritten by the next call.
    ///
    /// # Errors
    /// When there are not as many coordinates and velocities as the system has, or the mass matrix is singular, or so
    /// ill-conditioned that digits are lost.
    pub fn accelerations(&mut self, time: f64, q: &[f64], v: &[f64]) -> Result<&[f64]> {
        if q.len() != self.coordinates || v.len() != self.coordinates {
            let (name, n) = (self.system.name(), self.coordinates);
            return Err(Error::new(format!(
                "a state of \"{name}\" needs {n} coordinates and {n} velocities, but has {} and {}",
                q.len(),
                v.len()
            ))
            .help("give one entry for each name in coordinates()"));
        }
        self.single.run(time, q, v);
        if self.pivots.iter().all(|&pivot| is_sound(self.single.output(pivot), self.single.output(pivot + 1))) {
            return Ok(self.single.first_outputs());
        }
        self.with_exchange = self.system.accelerations(time, q, v, &self.parameters)?;
        Ok(&self.with_exchange)
    }
}

/// Whether a pivot kept its digits; one that is NaN did not.
fn is_sound(pivot: f64, diagonal: f64) -> bool {
    pivot.abs() > SMALL_PIVOT * diagonal.abs()
}

impl System {
    fn layout(&self) -> Layout {
        Layout { coordinates: self.coordinates().len(), parameters: self.parameters().len() }
    }

    fn program(&self, uniform_parameters: bool) -> &Program {
        self.programs.of(&self.traced.accelerations, self.layout(), uniform_parameters)
    }

    /// How many operations the accelerations take: the length of the tape behind [`System::accelerations_of_many`].
    pub fn operations(&self) -> usize {
        self.traced.accelerations.ops().len()
    }

    /// How many operations the mass matrix M and the residuals h at zero acceleration take, before M a = −h is solved.
    /// For n coordinates solving takes n³/6 products and as many sums; what comes before grows no faster than L and the
    /// n² entries of M.
    pub fn operations_before_solving(&self) -> usize {
        self.traced.dynamics.ops().len()
    }

    /// How many steps a state takes on the fast path, with the same parameters for all states. A step may be a product
    /// and a sum.
    pub fn steps(&self) -> usize {
        self.program(true).steps()
    }

    /// The accelerations of one state after another with the same parameters, as an integrator needs them: what depends
    /// on the parameters alone is computed here, and nothing is allocated afterwards.
    ///
    /// ```
    /// use onshell::mechanics::System;
    /// use onshell::systems::Pendulum;
    ///
    /// let system = System::new(&Pendulum::<1>::new())?;
    /// let (mass, length, gravity) = (1.0, 2.0, 9.8);
    /// let mut accelerator = system.acceleration_evaluator(&[mass, length, gravity]);
    /// let a = accelerator.accelerations(0.0, &[0.1], &[0.0])?[0];
    /// assert!((a + gravity / length * 0.1_f64.sin()).abs() < 1e-14);
    /// # Ok::<(), onshell::Error>(())
    /// ```
    pub fn acceleration_evaluator(&self, parameters: &[f64]) -> AccelerationEvaluator<'_> {
        let (layout, program) = (self.layout(), self.program(true));
        let mut inputs = vec![f64::NAN; layout.inputs()];
        inputs[layout.v(layout.coordinates)..].iter_mut().zip(parameters).for_each(|(input, &value)| *input = value);
        let single = Single::new(program, &inputs, layout.coordinates);
        let pivots = (0..layout.coordinates).map(|k| layout.coordinates + 2 * k);
        let is_settled = |&pivot: &usize| {
            let uniform = program.is_uniform(pivot) && program.is_uniform(pivot + 1);
            uniform && is_sound(single.output(pivot), single.output(pivot + 1))
        };
        AccelerationEvaluator {
            system: self,
            parameters: parameters.to_vec(),
            coordinates: layout.coordinates,
            pivots: pivots.filter(|pivot| !is_settled(pivot)).collect(),
            single,
            with_exchange: Vec::new(),
        }
    }

    /// The accelerations of many states, in blocks.
    ///
    /// `columns` are the inputs in the order time, coordinates, velocities, parameters: each with one entry a state, or
    /// with a single one for all. The result has one column a coordinate.
    ///
    /// # Errors
    /// When a column is missing or has another length, or a mass matrix is singular, or so ill-conditioned that digits
    /// are lost: the message says which state's.
    pub fn accelerations_of_many(&self, columns: &[&[f64]]) -> Result<Vec<Vec<f64>>> {
        let states = columns.iter().map(|column| column.len()).find(|&len| len != 1).unwrap_or(1);
        let mut result = vec![vec![0.0; states]; self.coordinates().len()];
        let mut places: Vec<&mut [f64]> = result.iter_mut().map(Vec::as_mut_slice).collect();
        self.write_accelerations_of_many(columns, &mut places)?;
        Ok(result)
    }

    /// [`System::accelerations_of_many`], written to columns that are there already: one a coordinate, with one entry a
    /// state.
    ///
    /// # Errors
    /// As there, and when the columns of the result are not as many or as long as they must be.
    pub fn write_accelerations_of_many(&self, columns: &[&[f64]], result: &mut [&mut [f64]]) -> Result<()> {
        self.write_with(Level::new(), columns, result)
    }

    /// With these vector instructions.
    fn write_with<'a>(&self, level: Level, columns: &[&'a [f64]], result: &mut [&mut [f64]]) -> Result<()> {
        let (layout, n) = (self.layout(), self.coordinates().len());
        let states = columns.iter().map(|column| column.len()).find(|&len| len != 1).unwrap_or(1);
        if columns.len() != layout.inputs() || columns.iter().any(|column| column.len() != 1 && column.len() != states)
        {
            return Err(Error::new(format!(
                "the states of \"{}\" need {} columns of one length, or with a single entry; {} columns were given",
                self.name(),
                layout.inputs(),
                columns.len()
            ))
            .help("the columns are: the time, the coordinates, their velocities, the parameters"));
        }
        if result.len() != n || result.iter().any(|column| column.len() != states) {
            return Err(Error::new(format!(
                "the accelerations of {states} states of \"{}\" need {n} columns with {states} entries each",
                self.name()
            ))
            .help("give one column for each coordinate"));
        }
        let parameters = &columns[layout.v(n)..];
        let program = self.program(parameters.iter().all(|column| column.len() == 1));
        let first: Vec<f64> = columns.iter().map(|column| column.first().copied().unwrap_or(f64::NAN)).collect();
        let uniform = program.uniform(&first);
        let mut registers = Registers::new(program, level);
        // blocks of the inputs that are the same for all states, and of the last states, which do not fill a block
        let mut blocks: Vec<Box<Block>> = first.iter().map(|&value| Box::new([value; LANES])).collect();
        for start in (0..states).step_by(LANES) {
            let block = LANES.min(states - start);
            if block < LANES {
                for (padded, column) in blocks.iter_mut().zip(columns).filter(|(_, column)| column.len() > 1) {
                    padded[..block].copy_from_slice(&column[start..start + block]);
                }
            }
            let whole = |column: &&'a [f64]| -> Option<&'a Block> { column.get(start..start + LANES)?.try_into().ok() };
            let block_of = |(padded, column)| whole(column).unwrap_or(padded);
            let inputs: Vec<&Block> = blocks.iter().map(Box::as_ref).zip(columns).map(block_of).collect();
            program.run_block(&mut registers, &inputs, &uniform);
            let output = |n: usize| program.output_of_block(n, &registers, &inputs, &uniform);
            for (i, column) in result.iter_mut().enumerate() {
                match output(i) {
                    Values::Each(values) => column[start..start + block].copy_from_slice(&values[..block]),
                    Values::All(value) => column[start..start + block].fill(value),
                }
            }
            if !(0..n).all(|k| output(n + 2 * k).exceed(SMALL_PIVOT, output(n + 2 * k + 1), &registers)) {
                self.redo(columns, start..start + block, result)?;
            }
        }
        Ok(())
    }

    /// States whose elimination met a small pivot, once more with exchange of rows and a look at the condition number.
    fn redo(&self, columns: &[&[f64]], states: std::ops::Range<usize>, result: &mut [&mut [f64]]) -> Result<()> {
        for state in states {
            let inputs: Vec<f64> =
                columns.iter().map(|column| column[if column.len() == 1 { 0 } else { state }]).collect();
            let (mass, bias) = self.dynamics(&inputs);
            let a = linear_solver::solve("mass matrix", mass, bias.iter().map(|&h| -h).collect()).map_err(|error| {
                let advice = error.advice().unwrap_or_default();
                Error::new(format!("state {state} (counted from 0): {}", error.message())).help(advice)
            })?;
            for (column, a) in result.iter_mut().zip(a) {
                column[state] = a;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::tape::blocks::tests::levels;
    use crate::systems::Registry;

    /// One whole block, and another that is not full.
    const STATES: usize = LANES + 44;

    /// Columns of states away from 0 and π; the parameters are the same for all, or not.
    fn columns(system: &System, uniform: bool) -> Vec<Vec<f64>> {
        let layout = system.layout();
        let share = |i: usize, k: usize| (0.137 + 0.618_033_988_749_895 * (i * (k + 1)) as f64).fract();
        let entry = |k: usize, i: usize| match k {
            0 => share(i, k),
            k if k < layout.v(0) => 0.3 + 2.5 * share(i, k),
            k if k < layout.v(layout.coordinates) => 0.4 * share(i, k) - 0.2,
            k => 1.0 + if uniform { 0.1 * k as f64 } else { share(i, k) },
        };
        let states = |k: usize| if uniform && k >= layout.v(layout.coordinates) { 1 } else { STATES };
        (0..layout.inputs()).map(|k| (0..states(k)).map(|i| entry(k, i)).collect()).collect()
    }

    fn agree(a: &[f64], b: &[f64]) -> bool {
        let scale = b.iter().fold(1e-3, |scale: f64, b| scale.max(b.abs()));
        a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-12 * scale)
    }

    /// The closed form that follows from (6.72) and (6.73), with what the parameters alone make taken out, is a sine
    /// with its cosine and 17 sums, products and quotients; two or three of these are one step.
    #[test]
    fn the_top_takes_no_more_steps_than_by_hand() {
        let system = System::new(&crate::systems::HeavyTop).unwrap();
        assert!(system.steps() <= 11, "{}", system.steps());
        // must-fail case: with parameters that vary there is more to do.
        assert!(system.program(false).steps() > 11, "{}", system.program(false).steps());
    }

    /// The pivot of the top, λ₁ sin²θ, is a product and keeps its digits where the mass matrix is nearly singular.
    #[test]
    fn a_product_is_a_sound_pivot_until_it_vanishes() {
        let system = System::new(&crate::systems::HeavyTop).unwrap();
        let [lambda_1, lambda_3, mass, g, distance] = [1.2, 0.7, 0.9, 9.8, 0.4];
        let mut accelerator = system.acceleration_evaluator(&[lambda_1, lambda_3, mass, g, distance]);
        for theta in [1.3, 1e-3, 1e-6_f64] {
            let [phi_rate, theta_rate, psi_rate] = [0.3, theta / 2.0, 5.0];
            let a = accelerator.accelerations(0.0, &[0.2, theta, 0.4], &[phi_rate, theta_rate, psi_rate]).unwrap();
            // ṗ_φ = 0 of (6.71), ṗ_ψ being 0 as well
            let p_psi = lambda_3 * (psi_rate + phi_rate * theta.cos());
            let terms = [
                lambda_1 * a[0] * theta.sin(),
                2.0 * lambda_1 * phi_rate * theta_rate * theta.cos(),
                -p_psi * theta_rate,
            ];
            let size = terms.iter().fold(0.0, |size: f64, term| size.max(term.abs()));
            assert!(terms.iter().sum::<f64>().abs() < 1e-14 * size, "{theta}");
            assert!((terms[0] - terms[1] - terms[2]).abs() > 1e-2 * size, "{theta}");
        }
        assert!(accelerator.accelerations(0.0, &[0.2, 0.0, 0.4], &[0.3, 0.1, 5.0]).is_err());
    }

    #[test]
    fn a_state_has_as_many_velocities_as_coordinates() {
        let system = System::new(&crate::systems::HeavyTop).unwrap();
        let mut accelerator = system.acceleration_evaluator(&[1.0; 5]);
        assert!(accelerator.accelerations(0.0, &[1.0; 3], &[1.0; 3]).is_ok());
        for (q, v) in [(2, 3), (3, 2), (4, 3), (3, 4)] {
            let error = accelerator.accelerations(0.0, &vec![1.0; q], &vec![1.0; v]).unwrap_err();
            assert_eq!(
                error.message(),
                &format!("a state of \"heavy_top\" needs 3 coordinates and 3 velocities, but has {q} and {v}")
            );
        }
    }

    #[test]
    fn every_way_gives_what_elimination_with_exchange_gives() {
        let registry = Registry::standard();
        for (name, uniform) in registry.names().flat_map(|name| [(name, false), (name, true)]) {
            let system = registry.get(name).unwrap().trace().unwrap();
            let (columns, n) = (columns(&system, uniform), system.coordinates().len());
            let columns: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
            let state = |i: usize| -> Vec<f64> { columns.iter().map(|column| column[i % column.len()]).collect() };
            let (q, v, p) = (1..1 + n, 1 + n..1 + 2 * n, 1 + 2 * n..columns.len());
            let expected: Vec<Vec<f64>> = (0..STATES)
                .map(state)
                .map(|x| system.accelerations(x[0], &x[q.clone()], &x[v.clone()], &x[p.clone()]).unwrap())
                .collect();
            for level in levels() {
                let mut result = vec![vec![0.0; STATES]; n];
                let mut places: Vec<&mut [f64]> = result.iter_mut().map(Vec::as_mut_slice).collect();
                system.write_with(level, &columns, &mut places).unwrap();
                let of = |i: usize| result.iter().map(|column| column[i]).collect::<Vec<_>>();
                assert!((0..STATES).all(|i| agree(&of(i), &expected[i])), "{name}, {level:?}");
                // must-fail case: one lane too far
                assert!(!(0..STATES).all(|i| agree(&of((i + 1) % STATES), &expected[i])), "{name}");
            }
            for (i, expected) in expected.iter().enumerate() {
                let x = state(i);
                let mut accelerator = system.acceleration_evaluator(&x[p.clone()]);
                assert!(
                    agree(accelerator.accelerations(x[0], &x[q.clone()], &x[v.clone()]).unwrap(), expected),
                    "{name}"
                );
            }
        }
    }
}
