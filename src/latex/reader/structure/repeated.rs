//! Letters that two factors of a term have as an index, without a Σ: they may mean a sum, and are refused where a value is
//! needed.

use std::collections::{HashMap, HashSet};

use crate::formula::tree::{Expr, Node};
use crate::source::Fault;

use super::super::state::{Read, Reader};

impl Reader<'_> {
    /// Without declarations: rejects `P_{ij} d_j`, where the repeated letter may mean a sum.
    pub(in super::super) fn has_no_implied_sum(&self, product: &Expr) -> Read<()> {
        let Node::Product(factors) = &product.node else { return Ok(()) };
        if !self.symbols.open || self.is_abstract() {
            return Ok(());
        }
        let letters = |factor: &Expr| -> Vec<String> {
            match &factor.node {
                Node::Symbol { id, .. } => index_letters(&self.symbols.entry(*id).name.subscript),
                _ => Vec::new(),
            }
        };
        let of_each: Vec<Vec<String>> = factors.iter().map(letters).collect();
        // In one pass, since a product may be long.
        let mut factors_with: HashMap<&String, usize> = HashMap::new();
        for letters in &of_each {
            for letter in letters.iter().collect::<HashSet<_>>() {
                *factors_with.entry(letter).or_default() += 1;
            }
        }
        let is_shared = |letter: &String| factors_with[letter] > 1 && !self.bound.contains(letter);
        // `A^k B_k`: the letter above may be an index, unless a Σ is over it.
        let above = |factor: &Expr| match &factor.node {
            Node::Power(base, exponent) if matches!(base.node, Node::Symbol { .. }) => {
                let id = exponent.as_plain_symbol()?;
                let name = &self.symbols.entry(id).name;
                // Of a rate or a variation any letter: `\dot q^n p_n`.
                let is_rate = matches!(base.node, Node::Symbol { dots: 1.., .. });
                let is_letter =
                    (is_rate || ["i", "j", "k", "l"].contains(&name.base.as_str())) && name.subscript.is_empty();
                (is_letter && !self.bound.contains(&name.base)).then(|| name.base.clone())
            }
            _ => None,
        };
        for factor in factors {
            let Some(letter) = above(factor) else { continue };
            if of_each.iter().any(|letters| letters.contains(&letter)) {
                return Err(Fault::ambiguous(
                    factor.span,
                    format!("the superscript {letter} may be an index or a power"),
                )
                .help("upper indices are not supported; write the index below, with \\sum for a sum; for a power, use a letter that is not an index elsewhere"));
            }
        }
        let implied = of_each.iter().position(|letters| letters.len() > 1 && letters.iter().any(is_shared));
        match implied {
            Some(at) => Err(Fault::ambiguous(factors[at].span, "an index that two factors share may mean a sum")
                .help("write \\sum for a sum, and declare the indices in a claims file")),
            None => Ok(()),
        }
    }
}

/// The letters of a subscript of two or three that are usual as indices: `ij`, `\\mu\\nu`, `abc`.
fn index_letters(subscript: &[String]) -> Vec<String> {
    const USUAL: [&str; 16] = [
        "a", "b", "c", "i", "j", "k", "l", "m", "n", "\\alpha", "\\beta", "\\mu", "\\nu", "\\rho", "\\sigma",
        "\\lambda",
    ];
    let all_usual = subscript.len() <= 4 && subscript.iter().all(|token| USUAL.contains(&token.as_str()));
    if all_usual { subscript.to_vec() } else { Vec::new() }
}
