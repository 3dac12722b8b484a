//! Marks for hand-ins: each line judged against a problem and against the lines before it.
//!
//! The problem is a claims file and its notes, the model solution. A hand-in is divided into lines ([`written`]): each
//! statement, and each row of a chain. The lines and the displays of the problem make one document ([`world`]), in which
//! the names of the problem mean what the problem says. A line that holds there is right, whatever way it was found. A
//! false line is compared with the false lines before it ([`carried`]): if it follows from one of them, the step is right
//! and the line is marked as such. Where letters differ from those of the problem, they are sought ([`letters`]). The
//! wanted results are recognised by what they say, not by numbers ([`results`]), and get points ([`credit`]).
//!
//! # Why a line is not compared with the model solution
//!
//! There are many right ways, and a line that stands on none of them may be right. So truth is decided as for notes, from
//! the Lagrangian or the laws, and only the wanted results are compared with the model solution.
//!
//! Offers [`Problem`] and [`Marked`]. Knows all other folders of `check`.

mod carried;
mod credit;
mod given;
mod hand_in;
mod judge;
mod judged;
mod letters;
mod marked;
mod motion;
mod names;
mod near_rest;
mod problem;
mod results;
mod rounded;
mod slip;
mod special;
mod status;
mod world;
mod written;

pub use marked::{Because, Derived, Line, Mark, Marked, Reached, ResultMark};
pub use problem::Problem;
