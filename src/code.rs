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

            /// What the code means, why, and what to do: Markdown, a line each.
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
    /// For example, `\cos\theta p_\psi` may be cos(θ)·p_ψ or cos(θ·p_ψ).
    /// Write parentheses or a thin space, `\cos\theta\,p_\psi`, so that one reading is left.
    Ambiguous = "ambiguous",
    /// A name is used that nothing declares or defines.
    ///
    /// For example, `F + R = m a` in a document whose claims file declares m, a and F only.
    /// Declare the name under `constants`, `varies with time` or `coordinates`, or define it in the notes.
    UndeclaredName = "undeclared-name",
    /// The text is not well-formed LaTeX mathematics.
    ///
    /// For example, `\frac{a}{b` lacks a closing brace. Complete the formula at the place that is shown.
    Syntax = "syntax",
    /// A LaTeX command is unknown, or a macro cannot be expanded.
    ///
    /// For example, `\myhalf m v^2` where nothing defines `\myhalf`, or a macro that calls itself.
    /// Define the command in the notes with `\newcommand`, or under `macros` in the claims file.
    UnknownCommand = "unknown-command",
    /// The notation is well-formed, and onshell does not support it.
    ///
    /// For example, `F \propto r^{-2}` in a numbered display. State the equation in another way, or leave it out with
    /// `skip`.
    NotSupported = "not-supported",
    /// Two sides or terms have different shapes: a number, a vector and a matrix cannot be equal or be added.
    ///
    /// For example, `\vec v = 3`. Write the missing arrow, index or norm.
    ShapeMismatch = "shape-mismatch",
    /// The indices of two sides or terms differ, or an index occurs too often.
    ///
    /// For example, `L_a = I_{ab} \omega_c` leaves a on the left and a, b and c on the right.
    /// An index that a term repeats is summed over. Correct the index that differs.
    IndexMismatch = "index-mismatch",
    /// Two sides or terms have different units.
    ///
    /// For example, `E = m v` with E declared as an energy. Correct the term, or the declaration under `units`.
    UnitMismatch = "unit-mismatch",
    /// The dimensions in this display do not fit those of all other displays, and they would fit with one other
    /// exponent.
    ///
    /// For example, `E^2 = p^2c^2 + m^2c^2` beside `E = \gamma m c^2` and `p = \gamma m v`: c would be a pure number.
    /// Correct the exponent that the suggestion shows. This code is given only in notes without a claims file.
    DimensionsConflict = "dimensions-conflict",
    /// Several displays contradict a definition that they use, and one edit of the definition makes all of them pass.
    ///
    /// The Lagrangian can be contradicted so too, and so can a relation that notes without a claims file take for granted.
    /// With a claims file, at least one of the displays must have no edit of its own that corrects it. For example,
    /// `t_1 = \frac{v}{7 a}` before `v_1 = v - a t_1 = \frac57 v` and another display that needs twice that time.
    /// Correct the definition.
    DefinitionContradicted = "definition-contradicted",
    /// The text is not a unit of the SI.
    ///
    /// For example, `Nm` for `N m`. Write factors with a space between them and one
    /// slash at most: `kg m^2/s^2`.
    InvalidUnit = "invalid-unit",
    /// The claims file says something that cannot be used.
    ///
    /// For example, an unknown key, or the number of an equation that is not in the notes.
    /// The message names the place in the claims file.
    ClaimsFile = "claims-file",
    /// The claims file is not valid JSON.
    ///
    /// For example, `"\theta"`, which JSON reads as a tab and "heta". Write each backslash twice: `"\\theta"`.
    Json = "json",
    /// The claims file names an equation that is not in the notes, or a name that fits several.
    ///
    /// For example, `"6.74"` where the notes number their equations up to (6.73).
    /// Use a printed number, a label, or a piece of the equation's LaTeX in backticks.
    EquationAddress = "equation-address",
    /// The notes cannot be read as a document.
    ///
    /// For example, a display that is never closed, or a number that is used twice.
    NotesFile = "notes-file",
    /// A text exceeds a fixed limit of size or of nesting.
    ///
    /// For example, a formula with more than 64 groups inside one another. Divide the formula or the file.
    TooLarge = "too-large",
    /// A file, an argument or an option cannot be used.
    ///
    /// For example, a file is not there. The message says what cannot be used, and why.
    Input = "input",
    /// The claim holds at every sampled state that can decide it.
    ///
    /// `verified` rests on numbers: the states are drawn at random, obey the hypotheses, and tell the claim from
    /// each mutant of it. `certified` adds an exact test modulo a prime, with the probability of a false pass.
    /// For example, `(a + b)^2 = a^2 + 2ab + b^2` holds always. An equation of motion holds on shell.
    Holds = "holds",
    /// The two sides of an equation differ at a sampled state, which is given.
    ///
    /// For example, `(a + b)^2 = a^2 + b^2` differs wherever ab is not 0. The counterexample lists the values.
    /// With laws in the claims file the message is: this does not follow from the law.
    /// Compare the two values, look at the suggestion, and correct the equation or the claims file.
    SidesDiffer = "sides-differ",
    /// The printed result of numbers is not what the numbers give, or its unit is another one.
    ///
    /// For example, `9.8\,\text{m/s}^2 \times 2.0\,\text{s} = 196\,\text{m/s}`. No numbers that are rounded to the
    /// printed ones give the result. Correct the number, the power of ten or the unit that slipped.
    NumbersDiffer = "numbers-differ",
    /// An inequality, or `\neq`, fails at a state that obeys all hypotheses.
    ///
    /// For example, `x^2 > 0` fails at x = 0. States are drawn at random, at the boundary of the inequality, and by
    /// a search for the smallest margin. Correct the inequality, or state the range in which it holds.
    InequalityFails = "inequality-fails",
    /// Exact arithmetic shows that the two sides differ, although floating-point numbers agree.
    ///
    /// For example, `(1 + 10^{-16}) x = x` agrees to 16 digits. The equation is evaluated modulo a prime, where nothing
    /// is rounded. If the equation is an approximation, write `\approx` and name what is small in the claims file.
    DiffersAsIdentity = "differs-as-identity",
    /// A claim about families holds for some numbers of members, and fails for another one, which is given.
    ///
    /// For example, `\sum_i \sum_{j \neq i} k = (6n - 12) k` holds for 3 and 4 members and fails for 5.
    /// Check the limits of the sums and the factors of `n`.
    FailsForFamilySize = "fails-for-family-size",
    /// The two sides agree where both are defined, but one of them is not defined everywhere.
    ///
    /// For example, in `\ln(x^2) = 2 \ln x` the right side has no value where x is negative. Restrict the range of the
    /// symbol in the claims file, or write the condition under which the equation holds.
    DomainDiffers = "domain-differs",
    /// The equation holds on one branch of an inverse function or of a root, and on no other.
    ///
    /// For example, `\varphi = \arctan(y/x)` and `x = r \cos\varphi` hold together for positive x only, since the
    /// arctangent lies between −π/2 and π/2. Restrict the range in the claims file (for example, assume `x > 0`), or
    /// define the angle by its cosine and its sine.
    OneBranch = "one-branch",
    /// No state was found that obeys the hypotheses.
    ///
    /// The hypotheses may contradict each other or the declared ranges, for example `x > 1` and `x < 0`. Or they are
    /// too hard for the numerical solver. Check the hypotheses, write them explicitly (`x = …`), or widen the ranges.
    NoState = "no-state",
    /// Too few sampled states gave a number on both sides.
    ///
    /// For example, `\sqrt{1 - v^2/c^2}` has no value where v is above c. Narrow the ranges in the claims file (for
    /// example, assume `v < c`).
    TooFewStates = "too-few-states",
    /// At some states the sides differ by more than rounding error and by less than a clear difference.
    ///
    /// Most such claims are decided with more digits; an integral over a body is not. For example, the factor in
    /// `= 0.4000000000001 M R^2` is 2/5 to twelve digits. Correct the number, or choose ranges in which the terms are
    /// of similar size.
    WithinRounding = "within-rounding",
    /// A term is so small beside the others that no sampled state shows it: a mistake in it would not be found.
    ///
    /// For example, in `10^{20} + x` the sixteen digits of a number do not show x. Choose ranges or constants for which
    /// the term matters.
    TermTooSmall = "term-too-small",
    /// The sampled states do not distinguish the claim from the same claim with one mistake in it: a mutant.
    ///
    /// For example, for small a the claim `\sqrt{1 + a} \approx 1 + a/3` is as good as the claim with 1 − a/3: in both
    /// the difference of the sides falls as the same power of a. Correct the claim, widen the ranges, or remove a
    /// hypothesis that makes the claim and its mutant equal.
    MutantPasses = "mutant-passes",
    /// A side is 0 at all states, so that a wrong factor or sign in it would not be noticed.
    ///
    /// For example, `\frac{d}{dt}(\vec r \times \vec r) = \vec 0`, where a dot was lost.
    /// Check the side for a lost symbol; if it is 0, print it as 0.
    SideAlwaysZero = "side-always-zero",
    /// The claim is one of its hypotheses, or says the same as them in other words.
    ///
    /// For example, `x = 2y` under the hypothesis `y = x/2`. Such a claim is not tested.
    /// Remove the hypothesis from `assume` or `where`, or declare the equation under `laws`.
    RestatesHypothesis = "restates-hypothesis",
    /// The claim follows from its own hypotheses, whatever the system does.
    ///
    /// For example, `\dot x = 0` under the hypothesis that x is constant throughout.
    /// Remove hypotheses until the claim says something about the motion.
    FollowsFromHypotheses = "follows-from-hypotheses",
    /// Both sides are the same formula, so that nothing is compared.
    ///
    /// For example, `a + b = a + b`. Print the step that leads from one side to the other.
    SameFormula = "same-formula",
    /// The hypotheses together leave a symbol only one value.
    ///
    /// For example, `x + y = 0` and `x - y = 0` force x to be 0, where `x^2 = x^3` holds as well.
    /// A test at one value shows too little. Remove a hypothesis, or state the value directly (`x = 0`).
    ForcedValue = "forced-value",
    /// It is not clear what a name means at this place.
    ///
    /// For example, a dot on a symbol that is declared constant, or on the point that an integral runs over. If the
    /// symbol moves, declare it under `varies with time`. Under an integral, write the velocity at that point as a
    /// formula. Otherwise use another name.
    UnclearName = "unclear-name",
    /// A formula has no value, because a symbol in it has none.
    ///
    /// For example, `M = \rho_0 V` where V is the region of an integral, which is not a number. Use another name for
    /// the number, and declare it, define it in the notes, or say under `means` what it is.
    NoValue = "no-value",
    /// The claims file itself defines the symbol by this formula, so that the display is true by definition.
    ///
    /// For example, `K = 2T` where the claims file has the same formula under `define`. Nothing needs to be done.
    TrueByDefinition = "true-by-definition",
    /// The display defines a name, and other equations test the definition.
    Definition = "definition",
    /// The claims file declares this display to be a law, so it is taken for granted and not checked.
    Law = "law",
    /// Nothing could be decided: there are no states, too few, or none that tell the claim from a wrong one.
    ///
    /// For example, in `x + \sqrt{x^3} \approx x` to first order in x, the error falls as the power 1.5 of x. The
    /// message says why nothing was decided, and what to change.
    NotDecided = "not-decided",
    /// A display contradicts a definition or a relation that was taken for granted, and one slip in either explains it.
    ///
    /// This code is given only in notes without a claims file. For example, `t_1 = \frac{v}{7 a}` and
    /// `v_1 = v - a t_1 = \frac57 v`: one of them is wrong, and no other display says which. An edit of each is shown.
    /// Correct the one that is wrong.
    Contradiction = "contradiction",
    /// Nothing is claimed of the display.
    ///
    /// For example, a second print has a number that the notes of the claims file lack. Correct the number.
    NoClaim = "no-claim",
    /// A quantity that is claimed to be constant changes along the motion.
    ///
    /// For example, `p = m \dot\theta` of a pendulum is claimed to be conserved. The counterexample gives its rate.
    /// Correct the formula, or add under `assume` what keeps it constant.
    NotConserved = "not-conserved",
    /// A quantity that is claimed to be conserved is constant for any motion, so the claim tests nothing.
    ///
    /// For example, a formula of constants alone. State the claim of a quantity that changes off shell.
    AlwaysConstant = "always-constant",
    /// The claim is about the motion, and nothing determines the motion.
    ///
    /// For example, `conserved` in a document without a system. Name a `system`, or give `laws`, in the claims file.
    NoMotion = "no-motion",
    /// The two sides of ≈ do not approach each other in the limit that the claims file names.
    ///
    /// For example, `\tanh a \approx a` with `"limit": "a \\to \\infty"`.
    /// Correct the formula, or the limit. The counterexample is the last step towards the limit.
    LimitNotReached = "limit-not-reached",
    /// The two sides of ≈ differ at an order that the claim includes.
    ///
    /// For example, `\cos x \approx 1 + x^2/2` with x small and order 2: the sides differ at order 2.
    /// Correct the term of that order, or lower `order`.
    OrderDiffers = "order-differs",
    /// A term is smaller than the order that is claimed, so any other factor in it would pass as well.
    ///
    /// For example, `\sin x \approx x + 5x^3` with order 2. Remove the term, or raise `order`.
    TermBeyondOrder = "term-beyond-order",
    /// A formula that is claimed to solve an equation does not satisfy it.
    ///
    /// For example, `x = 2` for `x^2 = 9`. The counterexample gives both sides of the equation with the formula put in.
    /// Correct the solution, or the equation that it solves.
    NotASolution = "not-a-solution",
    /// Two of the given solutions are the same number.
    ///
    /// For example, both branches of a root are printed as `\sqrt k`. Correct the sign of one of them.
    RepeatedSolution = "repeated-solution",
    /// An equation has more real solutions than the notes give.
    ///
    /// For example, only `x = 3` is given for `x^2 = 9`. Give the other solutions, or exclude them by the range of the
    /// unknown.
    MissingSolutions = "missing-solutions",
    /// The variable that the claim is about does not occur in the formula.
    ///
    /// For example, minima along θ of a function of φ. Correct the name in the claims file.
    VariableAbsent = "variable-absent",
    /// A hypothesis fixes the variable that should run through its range.
    ///
    /// For example, minima along θ while θ = 0 is assumed. Remove the hypothesis, or state it as an inequality.
    VariableFixed = "variable-fixed",
    /// A formula must have independent variables only, and a name in it depends on the others.
    ///
    /// A Hamiltonian is a formula of coordinates and momenta; a function whose shape is claimed has no rates in it. For
    /// example, `\frac12 m\dot x^2` is claimed to be positive as x runs over its range, and the rate of x is not free.
    /// Write a formula without this name.
    NotIndependent = "not-independent",
    /// A sum over smaller and smaller cells does not become the integral.
    ///
    /// For example, there is a 2 too many in `2 \int_V \rho(\vec r) \, d^3r`. Correct the integral, or the sum over
    /// particles that it replaces.
    IntegralDiffers = "integral-differs",
    /// The claim asks for something that the display does not have.
    ///
    /// For example, `"small": "x"` is written for `\sin x = x`, which has no ≈.
    /// Correct the display, or remove the key from the claims file.
    ClaimDoesNotFit = "claim-does-not-fit",
    /// A formula stands alone, without a relation, so it claims nothing.
    ///
    /// For example, `\frac12 m v^2` as a display. Write an equation, or leave the display out with `skip`.
    NoRelation = "no-relation",
    /// ≈ says that two sides are nearly equal, and the claims file does not say when.
    ///
    /// For example, `\sin\theta \approx \theta` holds for small θ. Add a `limit` or a `small` quantity.
    NeedsLimitOrSmall = "needs-limit-or-small",
    /// No other equation uses a defined name, so the definition was not tested.
    ///
    /// A definition cannot be false by itself. It is tested by the equations that use the name. For a last result this
    /// is only a warning. Use the name in another equation, or put the definition under `define`.
    DefinitionUnused = "definition-unused",
    /// Other equations use a defined name, and none of them passes, so the definition was not tested.
    ///
    /// The mistake may be in the definition. Correct the equations that use the name, or the definition. If edits of
    /// those equations correct them, this does not count as a failure.
    DefinitionUsersFail = "definition-users-fail",
    /// The words before an equation say that its solutions are sought, and nothing says what solves it.
    ///
    /// For example, "the distances are the roots of" stands before `E - \frac12 k x^2 = 0`, which holds at these
    /// distances and not in general. So it is no mistake that the equation fails elsewhere. State where it holds, with
    /// `where` or `assume`, or claim `secular equation for`.
    EquationForUnknown = "equation-for-unknown",
    /// Other equations use a defined name, and a wrong definition would not make any of them fail.
    ///
    /// For example, `p v = m v^2` only repeats the definition `p = m v`, so it does not test it. The message names the
    /// change that no equation detects. Use the name once more, or put the definition under `define`.
    DefinitionNotTested = "definition-not-tested",
    /// A defined name is always 0 as printed.
    ///
    /// For example, `a = x - x`. Such a definition is correct for any use, and is probably a misprint. Correct the
    /// definition.
    DefinitionZero = "definition-zero",
    /// The display defines a name, and other equations test the definition except for its sign or its factor.
    ///
    /// For example, the root `\omega = \sqrt{g/l}` is only used squared. Another
    /// example is a normal coordinate, whose double has the same linear equation of motion.
    /// This is a pass. Use the name once where its sign or factor matters.
    DefinitionUpToSign = "definition-up-to-sign",
    /// The display defines the Lagrangian, or a name that the Lagrangian contains.
    ///
    /// For example, `L = \frac12 m \dot x^2 - \frac12 k x^2` with `"means": { "L": "Lagrangian" }`. This is a pass: the
    /// equations of motion follow from the Lagrangian as it is printed, and the other displays are checked with them.
    LagrangianDefined = "lagrangian-defined",
    /// A display gives a name a formula, in notes without a claims file.
    ///
    /// For example, `E = T + U`. Nothing is checked: the name means this from here on. Write a claims file to have the
    /// definition tested by the displays that use the name.
    Introduced = "introduced",
    /// A display does not follow from the others, and is taken for granted, in notes without a claims file.
    ///
    /// For example, `F = m a` where F, m and a stand in other displays: a law, a condition or a value. It would be
    /// called wrong if one likely slip could turn a certified equation into it. A claims file can say what must be
    /// checked.
    Assumed = "assumed",
    /// A sentence refers to an equation that does not contain the formula that it should contain.
    ///
    /// For example, a sentence refers to (1) for a force, and (1) contains none. Correct the number.
    WrongReference = "wrong-reference",
    /// A function does not have the shape that a sentence states: its sign, its minima, its limits, its solutions.
    ///
    /// For example, “the potential has one minimum”, and two were found at the state that is given.
    /// Correct the sentence, or add a hypothesis under which it is true.
    FunctionShapeFails = "function-shape-fails",
    /// What is counted along a variable lies too close together to be counted.
    ///
    /// For example, `\sin 100x` has more maxima on a finer grid. Narrow the range of the variable, or of the constants.
    TooClose = "too-close",
    /// A claim and its `true exactly when` conditions disagree at a sampled state.
    ///
    /// For example, `x^2 > a^2` exactly when `x > a` fails at x = −2, a = 1. Correct the conditions or the claim.
    ExactlyWhenFails = "exactly-when-fails",
    /// Hamilton's equations from the printed formula do not give the motion of the system.
    ///
    /// For example, `+ m g l \cos\theta` has the wrong sign for a pendulum. The counterexample names the rate that
    /// differs. Correct the formula.
    NotTheHamiltonian = "not-the-hamiltonian",
    /// The claims file says that a claim does not always hold, and a counterexample confirms this.
    ///
    /// For example, `a - b = b - a` stands under `not always`, and it fails at a sampled state. This is a pass.
    NotAlways = "not-always",
    /// The claims file says that a claim does not always hold, but it holds at every sampled state.
    ///
    /// For example, `a + b = b + a` stands under `not always`. Correct the sentence, or widen the ranges in which it
    /// is tested.
    HoldsAlways = "holds-always",
    /// The claim is one of its own conditions, or repeats them, so that nothing is tested.
    ///
    /// For example, `dropping` with a formula that contains the left side. Write the claim without the repetition.
    Circular = "circular",
    /// A display that is called a law can be checked, so it is not a hypothesis.
    ///
    /// For example, `\dot p = m \ddot x` follows from the definition `p = m \dot x`. Another is a law beside a system,
    /// which determines the motion. Remove it from `laws`; it is then checked like any other display.
    NotALaw = "not-a-law",
    /// No sampled state satisfies all laws, or the laws allow only one value of a quantity that varies.
    ///
    /// For example, `F = m \ddot x` and `F = 2 m \ddot x` leave only F = 0. Then nothing can be tested at sampled
    /// states. Check the laws against each other.
    LawsTooStrong = "laws-too-strong",
    /// The claim needs a display that cannot be read.
    ///
    /// For example, p is defined by `p = \frac{m v`, which has an unmatched brace. Correct that display first.
    DependsOnUnreadable = "depends-on-unreadable",
    /// A second print of an equation lacks a relation or a whole display that the first one has.
    ///
    /// For example, the link `= (b + a)^2` is missing. Restore what the message names.
    LostInPrint = "lost-in-print",
    /// A step of a derivation is false only because it builds on a false step before it.
    ///
    /// For example, the next step repeats the wrong sign of `m \ddot x = k x`. Correct the display that the message
    /// names.
    FollowsFromMistake = "follows-from-mistake",
    /// The claims file leaves this display out with `skip`.
    ///
    /// For example, a path integral, which is not supported. Remove `skip` to have the display checked.
    Skipped = "skipped",
    /// The claims file that `--claims` names is not there.
    ///
    /// For example, `onshell check notes.md --claims clams.json`. Correct the name. Or leave out `--claims`: then the
    /// notes are checked without a claims file.
    NoClaimsFile = "no-claims-file",
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
