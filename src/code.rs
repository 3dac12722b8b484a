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
    /// A LaTeX command is unknown, or a macro cannot be expanded.
    ///
    /// For example, `\half m v^2` where nothing defines `\half`, or a macro that calls itself.
    /// Define the command in the notes with `\newcommand`, or under `macros` in the claims file.
    UnknownCommand = "unknown-command",
    /// The notation is well-formed, and onshell does not support it.
    ///
    /// For example, `\begin{cases}`. State the equation in another way, or leave it out with `skip`.
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
    /// The text is not a unit of the SI.
    ///
    /// For example, `Nm` for `N m`, or `m/s/s`, which is ambiguous.
    /// Write factors with a space between them and one slash at most: `kg m^2/s^2`.
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
    Input = "input",
    /// The claim holds at every sampled state that can decide it.
    Holds = "holds",
    /// The two sides of an equation differ at a sampled state, which is given.
    SidesDiffer = "sides-differ",
    /// The two sides agree where both are defined, but one of them is not defined everywhere.
    DomainDiffers = "domain-differs",
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
