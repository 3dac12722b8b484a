//! Quadrature over bodies: points and weights whose weighted sums are integrals over volumes, surfaces and lines.
//!
//! A [`Body`] is a uniform ball, box, shell, disc, lamina or rod. Its [`Nodes`] are a quadrature rule that is exact for
//! polynomials up to a chosen degree. With masses as weights, nodes are also a set of particles.
//!
//! This folder knows numbers only.
//!
//! Offers both.

pub mod bodies;
mod rules;

pub use bodies::{Body, Nodes};
