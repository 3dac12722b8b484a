//! The keys that a claim gives, and what each of them does. A new key starts as a field of [`Claim`] in `claim.rs`. This file then does
//! not compile until it says what the key does.

use super::claim::Claim;
use crate::source::Span;

/// A key of a claim that is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Key {
    Holds,
    Assume,
    Throughout,
    Where,
    AlsoEquals,
    Conserved,
    Solves,
    Limit,
    Dropping,
    Erratum,
    Expect,
    Skip,
    Generates,
    ForEach,
    Small,
    ContinuumLimitOf,
    ExactlyWhen,
    SameMotionAs,
    Symmetry,
    Equilibrium,
    At,
    SecularFor,
    Units,
}

/// What a key does to the claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// It says how the formula is read, or where it holds.
    Reading,
    /// It says what happens with the verdict.
    Verdict,
    /// The relations of the print are tested, and something else beside them.
    Beside,
    /// The relations of the print are tested as an approximation or as a solution.
    Instead,
    /// The relations of the print need not hold at a state.
    NotAtStates,
}

impl Key {
    /// Its spelling in a claims file.
    pub(crate) fn text(self) -> &'static str {
        match self {
            Key::Holds => "holds",
            Key::Assume => "assume",
            Key::Throughout => "throughout",
            Key::Where => "where",
            Key::AlsoEquals => "also equals",
            Key::Conserved => "conserved",
            Key::Solves => "solves",
            Key::Limit => "limit",
            Key::Dropping => "dropping",
            Key::Erratum => "erratum",
            Key::Expect => "expect",
            Key::Skip => "skip",
            Key::Generates => "generates",
            Key::ForEach => "for each",
            Key::Small => "small",
            Key::ContinuumLimitOf => "continuum limit of",
            Key::ExactlyWhen => "true exactly when",
            Key::SameMotionAs => "same motion as",
            Key::Symmetry => "symmetry",
            Key::Equilibrium => "equilibrium",
            Key::At => "at",
            Key::SecularFor => "secular equation for",
            Key::Units => "units",
        }
    }

    fn role(self) -> Role {
        match self {
            Key::Holds | Key::Assume | Key::Throughout | Key::Where | Key::ForEach | Key::Units => Role::Reading,
            Key::Erratum | Key::Expect => Role::Verdict,
            Key::AlsoEquals | Key::Conserved | Key::Generates | Key::SameMotionAs | Key::Symmetry => Role::Beside,
            Key::Solves | Key::Limit | Key::Dropping | Key::Small => Role::Instead,
            Key::Skip | Key::ContinuumLimitOf | Key::ExactlyWhen | Key::Equilibrium | Key::At | Key::SecularFor => {
                Role::NotAtStates
            }
        }
    }

    /// Whether it has a meaning for a sentence that states a formula.
    pub(crate) fn fits_a_sentence(self) -> bool {
        match self.role() {
            Role::Reading => self != Key::ForEach,
            Role::Verdict => self == Key::Expect,
            Role::Beside | Role::Instead | Role::NotAtStates => {
                matches!(self, Key::Limit | Key::Small | Key::ContinuumLimitOf | Key::ExactlyWhen)
            }
        }
    }

    /// Whether it has a meaning for a sentence whose test is another one than a formula.
    pub(crate) fn fits_a_property(self) -> bool {
        self.fits_a_sentence() && matches!(self.role(), Role::Reading | Role::Verdict)
    }
}

impl Claim {
    /// The keys that are given, each with its place.
    pub(crate) fn keys(&self) -> impl Iterator<Item = (Key, Span)> {
        let Claim {
            span: _,
            holds,
            assume,
            throughout,
            meanings,
            also_equals,
            conserved,
            solves,
            limit,
            dropping,
            errata,
            expect,
            skip,
            generates,
            for_each,
            small,
            // It stands beside `small`.
            order: _,
            continuum_limit_of,
            exactly_when,
            same_motion_as,
            symmetry,
            equilibrium,
            at,
            secular_for,
            units_off,
            // No key makes it.
            implied: _,
            implied_throughout: _,
        } = self;
        let solved = solves.as_ref().and_then(|solves| solves.unknowns.first());
        [
            (Key::Holds, holds.as_ref().map(|it| it.span)),
            (Key::Assume, assume.first().map(|it| it.span)),
            (Key::Throughout, throughout.first().map(|it| it.span)),
            (Key::Where, meanings.first().map(|(name, _)| name.span)),
            (Key::AlsoEquals, also_equals.as_ref().map(|it| it.span)),
            (Key::Conserved, conserved.as_ref().map(|it| it.span)),
            (Key::Solves, solves.as_ref().map(|_| solved.map_or(self.span, |it| it.span))),
            (Key::Limit, limit.as_ref().map(|it| it.span)),
            (Key::Dropping, dropping.as_ref().map(|it| it.span)),
            (Key::Erratum, errata.first().map(|it| it.printed.span)),
            (Key::Expect, expect.as_ref().map(|it| it.verdict.span)),
            (Key::Skip, skip.as_ref().map(|it| it.span)),
            (Key::Generates, generates.as_ref().map(|it| it.span)),
            (Key::ForEach, for_each.as_ref().map(|it| it.span)),
            (Key::Small, small.first().map(|it| it.span)),
            (Key::ContinuumLimitOf, continuum_limit_of.as_ref().map(|it| it.span)),
            (Key::ExactlyWhen, exactly_when.first().map(|all| all.first().map_or(self.span, |it| it.span))),
            (Key::SameMotionAs, same_motion_as.as_ref().map(|it| it.span)),
            (Key::Symmetry, symmetry.first().map(|(name, _)| name.span)),
            (Key::Equilibrium, equilibrium.as_ref().map(|it| it.span)),
            (Key::At, at.first().map(|(name, _)| name.span)),
            (Key::SecularFor, secular_for.as_ref().map(|it| it.span)),
            (Key::Units, *units_off),
        ]
        .into_iter()
        .filter_map(|(key, span)| Some((key, span?)))
    }

    /// Whether it says only that the equation holds.
    pub(crate) fn is_plain(&self) -> bool {
        self.keys().all(|(key, _)| matches!(key.role(), Role::Reading | Role::Verdict))
    }

    /// Whether the equalities and inequalities of the print must hold at each state.
    pub(crate) fn holds_at_states(&self) -> bool {
        self.keys().all(|(key, _)| key.role() != Role::NotAtStates) && !self.is_near_by_prose()
    }

    /// Whether words of the notes, and no claims file, say in which limit an equation holds, or to which order, so that = stands for ≈.
    pub(crate) fn is_near_by_prose(&self) -> bool {
        self.limit.iter().chain(&self.small).any(|said| said.span == Span::default())
    }

    /// Whether it says more of a name that the equation defines, so that the definition is tested.
    pub(crate) fn tests_a_definition(&self) -> bool {
        self.keys().any(|(key, _)| key.role() == Role::Beside || key == Key::Solves)
    }
}
