//! What each verdict, and each outcome of a mutant, means. The examples are in [`super::examples`].

use crate::check::Verdict;
use crate::check::mutation::MutantOutcome;

/// What an outcome of a mutant means.
pub(super) fn of_outcome(outcome: MutantOutcome) -> &'static str {
    match outcome {
        MutantOutcome::Refuted => of_verdict(Verdict::Refuted),
        MutantOutcome::Refused => {
            r"The mutant was detected, because it cannot be read or claims too little.

The equation with this mistake in it is ambiguous, has units or shapes that do not fit, or is the same on both sides.

There is nothing to do."
        }
        MutantOutcome::Equivalent => {
            r"The mutant is as true as the original, so no check could detect it.

It reads the same, or exact arithmetic shows that both are equal.

There is nothing to do."
        }
        MutantOutcome::Survived => {
            r"The mutant passes: a mistake like this in the equation would not be detected.

The report gives the place of the mistake, the change, and why it passes.

Widen the ranges or remove hypotheses; for a definition, use the defined name in one more equation."
        }
    }
}

/// What a verdict means.
pub(super) fn of_verdict(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Certified => {
            r"The equation holds, and exact arithmetic confirms it.

The equation was `verified` first. Then it was tested again over a prime field, where nothing is rounded.
The report gives a bound on the probability that the equation is false all the same: at most 2^-80.

There is nothing to do."
        }
        Verdict::Verified => {
            r"The equation holds at every sampled state.

With one mistake in it, the same equation fails at one of these states. So the test would have found the mistake.
Exact arithmetic cannot decide the equation; `onshell check --verbose` says why.

There is nothing to do."
        }
        Verdict::Definition => {
            r"The equation defines a symbol that other equations use.

A definition cannot be wrong by itself. It passes if each mistake in it makes another checked equation fail,
or if the claims file lists the symbol under `define`.

There is nothing to do."
        }
        Verdict::Law => {
            r#"The claims file declares that the equation is a law.

A law is taken for granted and not checked. The equations that need it are checked with it, and say so.

Check by eye that a law is printed correctly."#
        }
        Verdict::Assumed => {
            r"The display does not follow from the others, and it is taken for granted.

This verdict is given in notes without a claims file. A law, a condition or a value cannot follow from anything.
The display would be called wrong if one likely slip could turn a certified equation into it.

Check by eye that it is printed correctly, or write a claims file that says what must be checked."
        }
        Verdict::Unclaimed => {
            r#"The equation has a number, and the claims file leaves it out with `skip`.

Remove `skip` to have it checked."#
        }
        Verdict::Undecided => {
            r"The equation could not be decided.

Too few sampled states gave a number, or the states cannot tell the equation from a wrong one.
A definition that no other equation uses is undecided too.

Narrow the ranges in the claims file, add a condition under `assume`, or use the defined symbol once more."
        }
        Verdict::Domain => {
            r"The two sides agree, but only one is defined everywhere.

State where the equation holds: narrow the range of a symbol, or add a condition under `assume`."
        }
        Verdict::Unreadable => {
            r"The equation could not be read.

The formula is ambiguous, is not well-formed, uses a name that is not declared, or has shapes that do not fit.
The message gives the place and the reason.

Correct the formula, or declare the name in the claims file."
        }
        Verdict::Refuted => {
            r"The equation is wrong: it fails at a state that is shown.

The report gives the values of both sides there, their difference where it is short, and likely corrections.

Correct the equation. If the mistake is known and stays, write `expect` and `because` in the claims file."
        }
    }
}
