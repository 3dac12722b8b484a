//! The stable name of every class of message, with what it means and what to do about it.
//!
//! A [`Code`] stands in every finding and every error, in all forms of output, and does not change when a message is
//! reworded. `onshell explain CODE` prints its explanation, which is the doc comment of the variant.

use std::fmt;

/// Makes the enumeration, the list of all codes, their names and their explanations from one table.
macro_rules! codes {
    ($($(#[doc = $line:literal])+ $name:ident = $word:literal,)+) => {
        /// The stable name of a class of messages. The doc comment of each variant is what `onshell explain` prints.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum Code {
            $($(#[doc = $line])+ $name,)+
        }

        impl Code {
            /// Every code, in the order of this table.
            pub const ALL: &[Code] = &[$(Code::$name),+];

            /// The name as it stands in reports and on the command line: lower case, with hyphens.
            pub fn word(self) -> &'static str {
                match self {
                    $(Code::$name => $word,)+
                }
            }

            /// What the code means, why, an example, and what to do: Markdown, a line each.
            pub fn explanation(self) -> &'static str {
                match self {
                    $(Code::$name => concat!($($line, "\n"),+),)+
                }
            }
        }
    };
}

codes! {
    /// The formula can be read in more than one way.
    ///
    /// onshell does not guess. For example, `\cos\theta p_\psi` may be cos(θ)·p_ψ or cos(θ·p_ψ).
    /// Write parentheses or a thin space, `\cos\theta\,p_\psi`, so that one reading is left.
    Ambiguous = "ambiguous",
    /// A name is used that nothing declares or defines.
    ///
    /// For example, `F = m a` in a document whose claims file declares m and a only.
    /// Declare the name under `constants`, `varies with time` or `coordinates`, or define it in the notes.
    UndeclaredName = "undeclared-name",
    /// The text is not well-formed LaTeX mathematics.
    ///
    /// For example, `\frac{a}{b` lacks a closing brace. Complete the formula at the place that is shown.
    Syntax = "syntax",
    /// The notation is well-formed, and onshell does not support it.
    ///
    /// For example, `\begin{cases}`. State the equation in another way, or leave it out with `skip`.
    NotSupported = "not-supported",
    /// Two sides or terms have different shapes: a number, a vector and a matrix cannot be equal or be added.
    ///
    /// For example, `\vec v = 3`. Write the missing arrow, index or norm.
    ShapeMismatch = "shape-mismatch",
    /// Two sides or terms have different units.
    ///
    /// For example, `E = m v` with E declared as an energy. Correct the term, or the declaration under `units`.
    UnitMismatch = "unit-mismatch",
    /// The claims file says something that cannot be used.
    ///
    /// For example, an unknown key, or the number of an equation that is not in the notes.
    /// The message names the place in the claims file.
    ClaimsFile = "claims-file",
    /// The notes cannot be read as a document.
    ///
    /// For example, a display that is never closed, or a number that is used twice.
    NotesFile = "notes-file",
    /// A file, an argument or an option cannot be used.
    Input = "input",
    /// The claim holds at every sampled state that can decide it.
    ///
    /// `verified` rests on numbers: the states are drawn at random, obey the hypotheses, and tell the claim from
    /// each mutant of it. `certified` adds an exact test modulo a prime, with the probability of a false pass.
    /// For example, `(a + b)^2 = a^2 + 2ab + b^2` holds always, and `\ddot\theta = -(g/l)\sin\theta` on shell.
    Holds = "holds",
    /// The two sides of an equation differ at a sampled state, which is given.
    ///
    /// For example, `(a + b)^2 = a^2 + b^2` differs wherever `ab` is not 0. The counterexample lists the values.
    /// With laws in the claims file the message is: this does not follow from the law.
    /// Compare the two values, look at the suggestion, and correct the equation or the claims file.
    SidesDiffer = "sides-differ",
    /// An inequality, or `\neq`, fails at a state that obeys all hypotheses.
    ///
    /// For example, `x^2 > 0` fails at `x = 0`. States are drawn at random, at the boundary of the inequality, and by
    /// a search for the smallest margin. Correct the inequality, or state the range in which it holds.
    InequalityFails = "inequality-fails",
    /// Exact arithmetic shows that the two sides differ, although floating-point numbers agree.
    ///
    /// For example, `x + 10^{-20} = x` agrees to 16 digits. The equation is evaluated modulo a prime, where nothing is
    /// rounded. If the equation is an approximation, write `\approx` and name what is small in the claims file.
    DiffersAsIdentity = "differs-as-identity",
    /// A claim about families holds for some numbers of members, and fails for another one, which is given.
    ///
    /// For example, `\sum_{i<j} 1 = 3n - 6` holds for 3 and 4 members and fails for 5.
    /// Check the limits of the sums and the factors of `n`.
    FailsForFamilySize = "fails-for-family-size",
    /// The two sides agree where both are defined, but one of them is not defined everywhere.
    ///
    /// For example, `x^2/x = x` has no left side at `x = 0`.
    /// Restrict the range of the symbol in the claims file, or write the condition under which the equation holds.
    DomainDiffers = "domain-differs",
    /// No state was found that obeys the hypotheses.
    ///
    /// The hypotheses may contradict each other or the declared ranges, for example `x > 1` and `x < 0`. Or they are
    /// too hard for the numerical solver. Check the hypotheses, write them explicitly (`x = …`), or widen the ranges.
    NoState = "no-state",
    /// Too few sampled states gave a number on both sides.
    ///
    /// For example, `\sqrt{1 - v^2/c^2}` has no value where `v > c`.
    /// Narrow the ranges in the claims file (for example, assume `v < c`).
    TooFewStates = "too-few-states",
    /// At some states the sides differ by more than rounding error and by less than a clear difference.
    ///
    /// This happens where large terms cancel, for example in `(x + 10^{12}) - 10^{12} = x`.
    /// Choose ranges in which the terms are of similar size.
    WithinRounding = "within-rounding",
    /// A term is so small beside the others that no sampled state shows it: a mistake in it would not be found.
    ///
    /// For example, `10^{20} + x`. Choose ranges or constants for which the term matters.
    TermTooSmall = "term-too-small",
    /// The sampled states do not distinguish the claim from the same claim with one mistake in it: a mutant.
    ///
    /// For example, under the hypothesis `x = 0` the claim `y = y + x` also holds with `2x` for `x`.
    /// Widen the ranges, or remove the hypothesis that makes the two equal.
    MutantPasses = "mutant-passes",
    /// A side is 0 at all states, so that a wrong factor or sign in it would not be noticed.
    ///
    /// For example, `\frac{d}{dt}(\vec r \times \vec r) = 0`, where a dot was lost.
    /// Check the side for a lost symbol; if it is 0, print it as 0.
    SideAlwaysZero = "side-always-zero",
    /// The claim is one of its hypotheses, or says the same as them in other words.
    ///
    /// For example, `x = 2y` under the hypothesis `y = x/2`. Such a claim is not tested.
    /// Remove the hypothesis from `assuming` or `where`, or mark the equation as a law.
    RestatesHypothesis = "restates-hypothesis",
    /// The claim follows from its own hypotheses, whatever the system does.
    ///
    /// For example, `\dot x = 0` under the hypothesis that `x` is constant throughout.
    /// Remove hypotheses until the claim says something about the motion.
    FollowsFromHypotheses = "follows-from-hypotheses",
    /// Both sides are the same formula, so that nothing is compared.
    ///
    /// For example, `a + b = a + b`. Print the step that leads from one side to the other.
    SameFormula = "same-formula",
    /// The hypotheses together leave a symbol only one value.
    ///
    /// For example, `x + y = 0` and `x - y = 0` force `x = 0`, where `x^2 = x^3` holds as well.
    /// A test at one value shows too little. Remove a hypothesis, or state the value directly (`x = 0`).
    ForcedValue = "forced-value",
    /// It is not clear what a name means at this place.
    ///
    /// For example, a dot on a symbol that is declared constant, or on the point that an integral runs over.
    /// Declare the symbol under `varies with time`, write the velocity, or use another name.
    UnclearName = "unclear-name",
    /// A formula has no value, because a symbol in it has none.
    ///
    /// For example, a momentum without a system that determines it.
    /// Declare the symbol, define it in the notes, or say under `means` what it is.
    NoValue = "no-value",
    /// The claims file itself defines the symbol by this formula, so that the display is true by definition.
    ///
    /// For example, `K = 2T` where the claims file has the same formula under `define`. Nothing needs to be done.
    TrueByDefinition = "true-by-definition",
    /// The display defines a name, and other equations test the definition.
    Definition = "definition",
    /// The display is a law: a hypothesis by the word of the claims file, not checked here.
    Law = "law",
    /// No statement could be made: there are no states, too few, or none that can tell.
    NotDecided = "not-decided",
    /// Nothing is claimed of the display.
    NoClaim = "no-claim",
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

#[cfg(test)]
mod tests {
    use super::Code;
    use std::collections::HashSet;

    #[test]
    fn names_are_unique_lower_case_and_explained() {
        let words: HashSet<&str> = Code::ALL.iter().map(|code| code.word()).collect();
        assert_eq!(words.len(), Code::ALL.len());
        for code in Code::ALL {
            assert!(code.word().chars().all(|c| c.is_ascii_lowercase() || c == '-'), "{code}");
            assert!(code.explanation().trim_end().ends_with('.'), "{code}: {}", code.explanation());
        }
    }
}
