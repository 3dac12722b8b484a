//! Displays in TeX.

use super::*;

#[test]
fn displays() {
    let text = "\\newcommand{\\be}{\\begin{equation}}\n\\begin{document}\n$x$ \\$ $$a$$ % $$no$$\n\\[b\\]\\\\[2pt]\n\
                \\begin{equation*}c\\end{equation*}\n\\begin{verbatim}$$no$$\\end{verbatim} \\verb|$$no|\n\
                \\begin{alignat}{2}d\\end{alignat}\n\\begin{math}no\\end{math}\\begin{multline}e\\end{multline}\n\
                \\begin{displaymath}f\\end{displaymath}\n\\end{document}\n$$no$$";
    assert_eq!(texts(&tex(text)), ["a", "b", "c", "d", "e", "f"]);
}

#[test]
fn never_closed() {
    for text in ["$$a", "\\[a", "\\begin{equation}a", "\\begin{verbatim}a", "\\begin{align}a % \\end{align}"] {
        let error = parse(text, Kind::Tex).unwrap_err();
        assert!(text.starts_with(pointed(&error)), "{text}");
    }
}

#[test]
fn comments_and_labels_are_overwritten() {
    let found =
        tex("% onshell: veff\n\\begin{equation}\n a % é a comment\n = b \\label{eq:x}\\nonumber\n\\end{equation}");
    assert_eq!(texts(&found), ["a = b"]);
    let ids: Vec<_> = found[0].labels.iter().map(|label| label.id.as_str()).collect();
    assert_eq!(ids, ["eq:x", "#veff"]);
    // Inside of the display it names it, too.
    assert_eq!(tex("$$ % onshell: in\na$$")[0].labels[0].id, "#in");
}

#[test]
fn rows_are_parted_at_their_numbers() {
    let text = "\\begin{align}\n a &= b \\\\\n &= c \\label{x} \\\\[2pt]\n &= d \\nonumber \\\\\n\
                e &= \\begin{pmatrix}1\\\\2\\end{pmatrix} {f\\\\g} \\tag{7} \\\\* h &= i\n\\end{align}";
    let found = tex(text);
    assert_eq!(
        texts(&found),
        ["a &= b \\\\ &= c \\\\[2pt] &= d", "e &= \\begin{pmatrix}1\\\\2\\end{pmatrix} {f\\\\g}", "h &= i"]
    );
    assert_eq!(numbers(&found), ["", "7", ""]);
    assert_eq!(found[0].labels[0].id, "x");
}

#[test]
fn one_number_holds_all_rows() {
    let found = tex("\\begin{align}a &= b \\\\ c &= d \\label{x}\\end{align}");
    assert_eq!(texts(&found), ["a &= b \\\\ c &= d"]);
    assert_eq!(tex("\\begin{align}a % \\\\ \\label{no}\n = b\\label{x}\\\\ c\\label{y}\\end{align}").len(), 2);
}
