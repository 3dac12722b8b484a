//! The meaning of a typeset formula: layout to [`Expr`], with the help of the symbol table.
//!
//! | file | what is read there |
//! | --- | --- |
//! | `terms` | sums, terms, factors, products |
//! | `atoms` | one item: a number, a fraction, a root, a matrix |
//! | `algebra` | matrices, complex numbers, cases, brackets |
//! | `superscripts` | powers, transposes, and what looks like a power and is none |
//! | `symbols` | a name |
//! | `applications` | a name before a parenthesis: a product, or a function |
//! | `words` | letters that spell a function or a word |
//! | `vector_names` | the norm, the unit vector and the components of a declared vector |
//! | `functions` | `\sin` and the like, and where an argument ends |
//! | `declared_functions` | `V(r)`, `V'(r)`: functions that are declared or that a display defines |
//! | `derivatives` | `\frac{d}{dt}`, `dx/dt`; overdots such as `\dot x` are in `latex::overdots` |
//! | `partial_derivatives` | `\frac{\partial L}{\partial \dot q}` and other derivatives by a symbol |
//! | `held_derivatives` | `(\partial p/\partial V)_T` |
//! | `sums` | `\sum` |
//! | `integrals` | `\int` over a declared continuum, and `\lim` |
//! | `state` | the reader itself: symbol table, branch of ±, open sums |
//! | `items` | predicates on layout items |
//! | `values` | sums, integrals and bars that have a value |
//! | `undeclared` | in formulas without declarations: functions, sums, integrals, ∇, bars |
//! | `structure` | in displays with operators, tensors or states: what has no value |
//!
//! The grammar is recursive, hence all of them are methods of one `Reader`; each file imports only `state` and `items`.
//!
//! Offers `Reader`, and [`read_formula`] for a formula alone.
//!
//! # The rules
//!
//! *Products.* Letters side by side are factors, `MgR` is three; a declared name is always one symbol, with its accents
//! and its subscript. A parenthesis after a symbol is a factor too, `\lambda_1(…)`, unless it may be an argument:
//! `f(x)` and `x(0)` are rejected. So are letters that spell a function, `sin x`.
//!
//! *Functions.* `\sin(…)` and `\sin{…}` take what is enclosed. Otherwise the argument is what follows at once; it ends at a
//! typeset space, another function, a dotted symbol, a sign, a relation. Of several symbols (`\cos\theta p_\psi`,
//! `\cos\omega t`) the argument is as far as the first one declared to be an angle; where none is, only a
//! frequency times the time is read (`\omega t`), and everything else is rejected.
//!
//! *Sums, limits, integrals.* Σ and lim reach to the end of the term that they stand in, an integral to its differential.
//!
//! *Rejected as ambiguous:* `a/bc`, `a/b/c`, `\cos\theta/2`, `\sin\theta^2`, `\cot^{-1}x`,
//! `\log x`, `e^2`, a differential `dx` outside of `\frac{d}{dt}`.
//!
//! *One meaning by convention:* `-x^2` is −(x²); `\dot x^2` is (ẋ)²; `\Delta x` is one symbol; `\frac{d}{dt}` acts on
//! the parenthesis, the one factor or the sum after it, and on a whole product if it begins with a constant or has one
//! factor that varies; `\vec v^2` is **v**·**v**; e with a symbolic exponent is exp.
//!
//! # Why ambiguous formulas are rejected
//!
//! A formula that is silently read wrong gets a verdict about something that nobody wrote. So symbols must be
//! declared: then `MgR` is three symbols and `\lambda_1(…)` is a product. What people read in two ways is rejected,
//! and the message says how to write it. The list is in `docs/notation.md`. The tests have some 375 short formulas,
//! each with the value that a person would compute or the word that it must be rejected.

pub(super) mod algebra;
mod applications;
mod atoms;
mod declared_functions;
mod derivatives;
mod functions;
mod held_derivatives;
mod integrals;
pub(super) mod items;
mod partial_derivatives;
mod products;
mod slashes;
mod state;
pub(super) mod structure;
mod sums;
mod superscripts;
mod symbols;
mod terms;
pub(super) mod undeclared;
mod values;
mod vector_names;
pub(super) mod words;

use crate::formula::shape;
use crate::formula::symbols::Symbols;
use crate::formula::tree::Expr;
use crate::source::{Fault, Span};

use super::layout::{Layout, typeset_items};
use super::macros::Macros;
#[cfg(feature = "notes")]
pub use algebra::has_imaginary_unit;
pub use algebra::pairs_by_name;
pub use partial_derivatives::derivative_name;
pub(super) use state::Reader;

/// Whether δ before a letter is a factor in a display, as in −δ v − α x, and no variation.
pub fn has_coefficient(text: &str, macros: &Macros) -> bool {
    typeset_items(text, macros).is_ok_and(|items| undeclared::has_coefficient(&items))
}

/// Reads one formula, without relations, and checks its type.
pub fn read_formula(text: &str, symbols: &mut Symbols, macros: &Macros) -> Result<Expr, Fault> {
    let mut items = typeset_items(text, macros)?;
    while items.last().is_some_and(|item| matches!(item.layout, Layout::Space(_) | Layout::Other('.' | ',' | ';'))) {
        items.pop();
    }
    algebra::evidence::note(&items, symbols);
    let mut reader = Reader::new(symbols, None);
    let expr = reader.sum(&items, Span::at(text.len()))?;
    shape::bind(expr, symbols).map(|(expr, _)| expr)
}
