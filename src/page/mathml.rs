//! MathML as browsers lay it out: what the typesetter writes, with accents of a legible size and functions that keep their size.

/// Accents of mechanics, each with the character that is shown: `^` is too large and hangs too high.
const ACCENTS: [(&str, &str); 8] =
    [("˙", "˙"), ("¨", "¨"), ("⃛", "⃛"), ("→", "→"), ("^", "ˆ"), ("‾", "¯"), ("¯", "¯"), ("~", "˜")];

/// The MathML of the typesetter with these changes: operators such as < are escaped; dots, hats and arrows are operators of a class;
/// a thin space before a function with an exponent stands before both; aligned rows are as large as displays.
pub(super) fn tidied(mathml: &str) -> String {
    let text = escaped(mathml);
    let text = spaces_before_scripts(&text);
    let text = text.replace("<mtable class=\"menv-alignlike", "<mtable displaystyle=\"true\" class=\"menv-alignlike");
    accents(&text)
}

/// The typesetter writes an operator such as < as it is; in HTML it is the start of a tag.
fn escaped(mathml: &str) -> String {
    mathml.replace("><</", ">&lt;</").replace(">></", ">&gt;</").replace(">&</", ">&amp;</")
}

/// `\phi \sin^2`: the typesetter gives the space to the exponent as its base.
fn spaces_before_scripts(mathml: &str) -> String {
    const SPACE: &str = "<mspace width=\"0.1667em\" />";
    ["msup", "msub", "msubsup"].iter().fold(mathml.to_owned(), |text, tag| {
        text.replace(&format!("<{tag}>{SPACE}<mi>"), &format!("{SPACE}<{tag}><mi>"))
    })
}

/// Marks of one character over a symbol as operators with a class, to which the style sheet gives a legible size. They are
/// no `accent` in the sense of MathML: without a font for mathematics, browsers set accents into the letter.
fn accents(mathml: &str) -> String {
    let mut out = String::with_capacity(mathml.len());
    let mut rest = mathml;
    while let Some(at) = rest.find('<') {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        let end = rest.find('>').map_or(rest.len(), |end| end + 1);
        let tag = &rest[..end];
        let accent = ACCENTS.iter().find(|(mark, _)| out.ends_with(&format!("<mi>{mark}</mi>")));
        if let (Some((mark, shown)), "</mover>") = (accent, tag) {
            out.truncate(out.len() - format!("<mi>{mark}</mi>").len());
            out.push_str(&format!("<mo stretchy=\"false\" class=\"accent\">{shown}</mo>"));
        }
        out.push_str(tag);
        rest = &rest[end..];
    }
    out.push_str(rest);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dot_is_an_accent_and_a_bar_over_a_sum_is_not() {
        let dotted = "<mover><mrow><mover><mi>r</mi><mi>→</mi></mover></mrow><mi>˙</mi></mover>";
        let expected = "<mover><mrow><mover><mi>r</mi><mo stretchy=\"false\" class=\"accent\">→</mo></mover></mrow>\
                        <mo stretchy=\"false\" class=\"accent\">˙</mo></mover>";
        assert_eq!(tidied(dotted), expected);
        let sum = "<mover><mo>Σ</mo><mi>n</mi></mover>";
        assert_eq!(tidied(sum), sum);
    }

    #[test]
    fn a_function_with_an_exponent_keeps_its_size() {
        let printed = "<mi>ϕ</mi><msup><mspace width=\"0.1667em\" /><mi>sin</mi><mn>2</mn></msup>";
        let tidy = "<mi>ϕ</mi><mspace width=\"0.1667em\" /><msup><mi>sin</mi><mn>2</mn></msup>";
        assert_eq!(tidied(printed), tidy);
    }

    #[test]
    fn an_operator_is_no_tag() {
        assert_eq!(tidied("<mo><</mo>"), "<mo>&lt;</mo>");
    }
}
