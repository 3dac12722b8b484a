//! Other letters: which names of a hand-in stand for which names of the problem.
//!
//! Declared letters come first. If the hand-in then has a false line or lacks a result, and names of its own, the ways to
//! take them for unused names of the problem, or for rates of its coordinates, are tried, the likeliest first. The best one
//! counts, if it makes more true than none. First come the ways by which a line is one of the problem ([`matching`]). A way is likely
//! if a letter differs only in its case or its subscript, if angles stand for angles, and if v and a are a velocity and an
//! acceleration. A letter that the problem uses has another meaning only where several lines support that ([`supported`]). Where a
//! hand-in says nothing in the letters of the problem, a line may be an equation of the problem with a slip ([`with_slips`]).
//!
//! Offers `best`, the hand-in judged with the letters that fit best. Knows `judge` and `written` of `mark`, `usage`, and `document` and
//! below.

mod likeness;
mod matching;
mod supported;
mod ways;
mod with_slips;

pub(super) use likeness::head;
pub(in crate::check::mark) use ways::best;
