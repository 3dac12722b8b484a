//! Linear equations between fractions, solved by determinants.
//!
//! Coordinates that the matrix does not connect are solved separately, so that denominators get no needless factors.

use num_traits::One;

use super::algebra::{Algebra, Fraction};
use super::polynomial::Polynomial;
use super::rational::Exact;
use crate::{Error, Result};

/// The largest number of rows of a determinant that is expanded.
const ROWS: usize = 6;

impl Algebra {
    /// The x with Σⱼ matrixᵢⱼ xⱼ = rightᵢ.
    ///
    /// # Errors
    /// When the matrix is singular, or too large.
    pub fn solve(&mut self, matrix: &[Vec<Fraction>], right: &[Fraction]) -> Result<Vec<Fraction>> {
        let mut solution = vec![Fraction::default(); right.len()];
        for block in blocks(matrix) {
            if block.len() > ROWS {
                return Err(Error::new(format!(
                    "the equations couple {} coordinates, and they are solved as formulas for at most {ROWS}",
                    block.len()
                ))
                .help("ask for the equations of motion or the mass matrix; these need no solution"));
            }
            let inner: Vec<Vec<Fraction>> =
                block.iter().map(|&i| block.iter().map(|&j| matrix[i][j].clone()).collect()).collect();
            let determinant = self.determinant(&inner)?;
            let determinant = self.presented(&determinant)?;
            if determinant.top.is_zero() {
                return Err(Error::new(
                    "the mass matrix is singular, so no formula gives the accelerations and velocities",
                )
                .help("check that L depends on every velocity"));
            }
            let inverse = self.reciprocal(&determinant)?;
            for (column, &unknown) in block.iter().enumerate() {
                let mut sum = Fraction::default();
                for (row, &equation) in block.iter().enumerate() {
                    let cofactor = self.cofactor(&inner, row, column)?;
                    let part = self.times(&cofactor, &inverse)?;
                    let part = self.times(&part, &right[equation])?;
                    sum = self.plus(&sum, &part, Exact::one())?;
                }
                solution[unknown] = self.presented(&sum)?;
            }
        }
        Ok(solution)
    }

    fn cofactor(&mut self, matrix: &[Vec<Fraction>], row: usize, column: usize) -> Result<Fraction> {
        let without = |entries: &Vec<Fraction>| -> Vec<Fraction> {
            entries.iter().enumerate().filter(|(j, _)| *j != column).map(|(_, entry)| entry.clone()).collect()
        };
        let minor: Vec<_> = matrix.iter().enumerate().filter(|(i, _)| *i != row).map(|(_, row)| without(row)).collect();
        let value = self.determinant(&minor)?;
        let value = self.presented(&value)?;
        let sign = if (row + column).is_multiple_of(2) { Exact::one() } else { -Exact::one() };
        self.plus(&Fraction::default(), &value, sign)
    }

    fn determinant(&mut self, matrix: &[Vec<Fraction>]) -> Result<Fraction> {
        let Some(first) = matrix.first() else { return Ok(Polynomial::one().into()) };
        let mut sum = Fraction::default();
        for (j, entry) in first.iter().enumerate().filter(|(_, entry)| !entry.top.is_zero()) {
            let minor: Vec<Vec<Fraction>> = matrix[1..]
                .iter()
                .map(|row| row.iter().enumerate().filter(|(k, _)| *k != j).map(|(_, entry)| entry.clone()).collect())
                .collect();
            let inner = self.determinant(&minor)?;
            let part = self.times(entry, &inner)?;
            sum = self.plus(&sum, &part, if j % 2 == 0 { Exact::one() } else { -Exact::one() })?;
        }
        Ok(sum)
    }
}

/// The indices that the entries of a symmetric matrix connect, each block in order.
fn blocks(matrix: &[Vec<Fraction>]) -> Vec<Vec<usize>> {
    let mut blocks: Vec<Vec<usize>> = Vec::new();
    for (i, row) in matrix.iter().enumerate() {
        let (connected, apart): (Vec<_>, Vec<_>) =
            blocks.into_iter().partition(|block| block.iter().any(|&j| !row[j].top.is_zero()));
        let mut joined: Vec<usize> = connected.into_iter().flatten().chain([i]).collect();
        joined.sort_unstable();
        blocks = apart;
        blocks.push(joined);
    }
    blocks
}
