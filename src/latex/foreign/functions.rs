//! The functions as other languages write them: `\operatorname{sen}`, `\tg`, `\mathrm{argth}`.

use crate::source::Span;

use super::units::skipped;

/// The words for functions, each with the command that is read.
pub const WORDS: [(&str, &str); 32] = [
    ("sen", "\\sin"),
    ("sin", "\\sin"),
    ("cos", "\\cos"),
    ("tan", "\\tan"),
    ("tg", "\\tan"),
    ("ctg", "\\cot"),
    ("cotg", "\\cot"),
    ("cotan", "\\cot"),
    ("arcsen", "\\arcsin"),
    ("arctg", "\\arctan"),
    ("sh", "\\sinh"),
    ("ch", "\\cosh"),
    ("th", "\\tanh"),
    ("cth", "\\coth"),
    ("senh", "\\sinh"),
    ("tgh", "\\tanh"),
    ("ctgh", "\\coth"),
    ("argsh", "\\operatorname{arsinh}"),
    ("argch", "\\operatorname{arcosh}"),
    ("argth", "\\operatorname{artanh}"),
    ("argsinh", "\\operatorname{arsinh}"),
    ("argcosh", "\\operatorname{arcosh}"),
    ("argtanh", "\\operatorname{artanh}"),
    ("arsh", "\\operatorname{arsinh}"),
    ("arch", "\\operatorname{arcosh}"),
    ("arth", "\\operatorname{artanh}"),
    ("Arsinh", "\\operatorname{arsinh}"),
    ("Arcosh", "\\operatorname{arcosh}"),
    ("Artanh", "\\operatorname{artanh}"),
    ("Argsh", "\\operatorname{arsinh}"),
    ("Argch", "\\operatorname{arcosh}"),
    ("Argth", "\\operatorname{artanh}"),
];

/// The commands that set a word upright.
const UPRIGHT: [&str; 3] = ["\\operatorname{", "\\mathrm{", "\\text{"];

/// The edits that put the command that is read in the place of a word with an argument after it. In a subscript a word is a
/// part of a name.
pub(super) fn words(text: &str) -> Vec<(Span, String)> {
    let mut edits = Vec::new();
    for style in UPRIGHT {
        for (at, _) in text.match_indices(style) {
            let inside = &text[at + style.len()..];
            let Some(close) = inside.find('}') else { continue };
            let own = WORDS.iter().find(|(word, _)| *word == &inside[..close]).map(|(_, own)| *own);
            let end = at + style.len() + close + 1;
            let before = text[..at].trim_end_matches('{');
            let is_subscript = before.ends_with(['_', '^'])
                || before.ends_with(',') && !before.ends_with("\\,") && before.contains("_{");
            let next = text[skipped(text, end)..].trim_start();
            let has_argument =
                !next.is_empty() && !next.starts_with(['=', '+', '-', '}', ')', ',', '.', '_', '/', '&']);
            if let Some(own) = own.filter(|_| !is_subscript && has_argument) {
                edits.push((Span::new(at, end), own.to_owned()));
            }
        }
    }
    edits
}

#[cfg(test)]
mod tests {
    use crate::latex::Macros;
    use crate::latex::rename::renamed;

    fn plain(text: &str) -> String {
        renamed(text, &Macros::default(), &std::collections::HashMap::new()).text
    }

    #[test]
    fn the_words_of_other_languages_are_functions() {
        assert_eq!(plain(r"\operatorname{th} (x)"), r"\tanh (x)");
        assert_eq!(plain(r"\mathrm{argth} \frac{v}{u}"), r"\operatorname{artanh} \frac{v}{u}");
        assert_eq!(plain(r"\operatorname{cotg}^2 x"), r"\cot^2 x");
        assert_eq!(plain(r"v_{1y} = u \,\text{sen}\,\chi"), r"v_{1y} = u \,\sin\,\chi");
        // The twins: a part of a name, and a name.
        for text in [r"v_{\mathrm{th}} t", r"v_\mathrm{ch} x", r"\mathrm{th} = 1", r"v_{1,\mathrm{sh}} x"] {
            assert_eq!(plain(text), text);
        }
    }
}
