//! References in the prose to numbered equations.

use super::*;

const NOTES: &str = "$$a = b$$\n(2.1)\n\nBy (2.1), and $x (2.3)$ with `(2.4)`, eq. (2.2) and\n(2.26),(2.28b) follow (see\n\
                     equation (2.2)). The mass (0.35), the part (3), the set (a.1).\n\n$$c = d (2.2)$$\n\n```\n(2.5)\n```\n\
                     <!-- (2.6) --> \\(f (2.7)\\) (2.9\n";

fn cited(notes: &Notes) -> Vec<(&str, usize)> {
    notes.references.iter().map(|reference| (reference.number.as_str(), reference.line)).collect()
}

#[test]
fn in_the_prose_alone() {
    let notes = parse(NOTES, Kind::Markdown).unwrap();
    assert_eq!(cited(&notes), [("2.1", 4), ("2.2", 4), ("2.26", 5), ("2.28b", 5), ("2.2", 6)]);
    for reference in &notes.references {
        assert_eq!(&NOTES[reference.span.range()], format!("({})", reference.number));
    }
    let dangling: Vec<_> = notes.dangling_references().map(|reference| reference.number.as_str()).collect();
    assert_eq!(dangling, ["2.26", "2.28b"]);
}

#[test]
fn in_tex() {
    let text = "% (1.3)\n\\verb|(1.4)| \\[a \\tag{1.1}\\] As (1.1), $p(1.5)$ and (1.2).\n\\end{document}\n(1.6)\n";
    let notes = parse(text, Kind::Tex).unwrap();
    assert_eq!(cited(&notes), [("1.1", 2), ("1.2", 2)]);
    assert_eq!(notes.dangling_references().count(), 1);
}

#[test]
fn as_the_document_numbers() {
    let cite = |number: &str, prose: &str| {
        let notes = parse(&format!("$$x \\tag{{{number}}}$$\n\n{prose}\n"), Kind::Markdown).unwrap();
        notes.references.iter().map(|reference| reference.number.clone()).collect::<Vec<_>>()
    };
    // Without a point, only after a word for equations: a list is numbered so, too.
    assert_eq!(cite("7", "(1) first, (2) second; Eq.~(7) and equations (8), the sequence (9)"), ["7", "8"]);
    assert_eq!(cite("A.3", "by (A.1), (B.12), (2.1)"), ["A.1", "B.12"]);
    assert_eq!(cite("10.12", "by (2.1), (2.1.3), (2.10)"), ["2.1", "2.10"]);
    // What has no numbers cites none of its own.
    assert!(parse("$$x$$\n\nby eq. (2.1)\n", Kind::Markdown).unwrap().references.is_empty());
}
