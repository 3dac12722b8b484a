//! Which slips a formula has room for, that each is undone, and that an edit leaves the rest of the text as it is.

use std::collections::HashSet;
use std::path::Path;

use super::super::lexer::{TokenKind, tokens};
use super::super::names;
use super::finder::last_script;
use super::*;
use crate::formula::Kind;
use crate::source::Span;

/// Numbers, angles that vary, vectors with and without a label, matrices; indices i, j of particles and a, b of axes.
fn symbols() -> Symbols {
    let mut symbols = Symbols::new();
    let mut add = |latex: &str, kind: Kind, varies: bool, angle: bool| {
        let (name, _) = names::parse(latex).expect("it is a name");
        let id = symbols.add(name, kind).expect("it is new");
        symbols.entry_mut(id).varies = varies;
        symbols.entry_mut(id).angle = angle;
    };
    for number in ["m", "M", "g", "l", "n", "\\bar\\lambda", "\\lambda_1", "\\lambda_2", "\\lambda_3"] {
        add(number, Kind::Scalar, false, false);
    }
    for angle in ["\\theta", "\\phi", "\\psi"] {
        add(angle, Kind::Scalar, true, true);
    }
    add("x", Kind::Scalar, true, false);
    for vector in ["\\vec\\omega", "\\vec v", "\\vec L"] {
        add(vector, Kind::Vector, true, false);
    }
    for matrix in ["\\mathbf{R}", "\\mathbf{S}"] {
        add(matrix, Kind::Matrix(3, 3), true, false);
    }
    let n = symbols.find(&names::parse("n").expect("it is a name").0).map(|(id, _)| id);
    for label in ["i", "j"] {
        symbols.add_label(label, 4, n);
    }
    for axis in ["a", "b"] {
        symbols.add_index(axis, 3);
    }
    for (family, kind) in [("m_i", Kind::Scalar), ("\\vec r_i", Kind::Vector), ("I_{ab}", Kind::Scalar)] {
        let (name, _) = names::parse(family).expect("it is a name");
        let slots = symbols.slots(&name.subscript);
        let id = symbols.add_family(name, kind, slots).expect("it is new");
        symbols.entry_mut(id).varies = kind == Kind::Vector;
    }
    symbols
}

/// A text without what does not print: spaces, and braces around one thing or many.
fn bare(text: &str) -> String {
    text.replace("\\,", "").chars().filter(|c| !c.is_whitespace() && !matches!(c, '{' | '}')).collect()
}

/// The texts with one slip of a kind.
fn of_kind(slip: Slip, text: &str) -> Vec<String> {
    let all = slips(text, &symbols(), &Macros::default());
    all.iter().filter(|edit| edit.slip == slip).map(|edit| bare(&edit.applied(text))).collect()
}

/// A slip, a formula, and what the slip makes of it.
const OCCUR: [(Slip, &str, &str); 44] = [
    (Slip::Parenthesis, "(m) x^2 + l M", "(m x^2 + l) M"),
    (Slip::Sign, "m + M", "m - M"),
    (Slip::Sign, "m - M", "m + M"),
    (Slip::Sign, "m + M", "-m + M"),
    (Slip::Sign, "-m + M", "m + M"),
    (Slip::Sign, "m \\pm M", "m \\mp M"),
    (Slip::Sign, "\\frac{m - M}{2}", "\\frac{m + M}{2}"),
    (Slip::Symbol, "\\lambda_1 \\theta", "\\lambda_3 \\theta"),
    (Slip::Symbol, "\\dot\\theta^2", "\\dot\\phi^2"),
    (Slip::Symbol, "m g l", "M g l"),
    (Slip::Index, "m_i \\vec r_i", "m_i \\vec r_j"),
    (Slip::Index, "I_{ab}", "I_{ba}"),
    (Slip::Index, "m_1 x", "m_2 x"),
    (Slip::Index, "I_{12} x", "I_{21} x"),
    (Slip::Index, "I_{12} x", "I_{13} x"),
    (Slip::Dot, "m x", "m \\dot x"),
    (Slip::Dot, "m \\dot x", "m x"),
    (Slip::Dot, "m \\dot x", "m \\ddot x"),
    (Slip::Dot, "m \\ddot{\\vec r}_i", "m \\dot{\\vec r}_i"),
    (Slip::Number, "2 m", "3 m"),
    (Slip::Number, "\\frac12 m", "\\frac14 m"),
    (Slip::Exponent, "x^2", "x"),
    (Slip::Exponent, "x^2", "x^3"),
    (Slip::Exponent, "\\sin^2\\theta", "\\sin\\theta^2"),
    (Slip::Exponent, "(m + M)^2", "m + M^2"),
    (Slip::Exponent, "\\sqrt{m}", "(m)"),
    (Slip::Function, "\\sin\\theta", "\\cos\\theta"),
    (Slip::Function, "\\cosh x", "\\sinh x"),
    (Slip::Accent, "\\bar\\lambda x", "\\lambda x"),
    (Slip::Accent, "\\vec v", "v"),
    (Slip::Order, "\\vec\\omega \\times \\vec v", "\\vec v \\times \\vec\\omega"),
    (Slip::Order, "\\vec\\omega \\cdot \\vec v", "\\vec\\omega \\times \\vec v"),
    (Slip::Order, "\\mathbf{R} \\mathbf{S}", "\\mathbf{S} \\mathbf{R}"),
    (Slip::Fraction, "\\frac{g}{l} x", "\\frac{l}{g} x"),
    (Slip::Parenthesis, "2 (m + M)", "2 m + M"),
    (Slip::Parenthesis, "(m + M x) l", "(m + M) x l"),
    (Slip::Parenthesis, "(m + M) x l", "(m + M x) l"),
    (Slip::Relation, "m < M", "m > M"),
    (Slip::Relation, "m \\leq M", "m \\geq M"),
    (Slip::Factor, "m g x", "m x"),
    (Slip::Doubled, "m g x", "m g g x"),
    (Slip::Factor, "\\vec\\omega \\cdot \\vec v", "\\vec v"),
    (Slip::Term, "m + M - x", "m - x"),
    (Slip::Doubled, "m + M", "m + M + M"),
];

#[test]
fn each_kind_of_slip_occurs_where_there_is_room_for_it() {
    for (slip, formula, wrong) in OCCUR {
        let found = of_kind(slip, formula);
        assert!(found.contains(&bare(wrong)), "{slip:?} makes of {formula}: {found:?}, and not {wrong}");
        // No slip says what was there.
        assert!(!found.contains(&bare(formula)), "{slip:?} of {formula} is none");
    }
}

#[test]
fn no_slip_leaves_two_scripts_in_one_place() {
    for (formula, script) in [("\\lambda_1", '_'), ("\\lambda_{cm}", '_'), ("v^2", '^'), ("x_1^{-1}", '^')] {
        assert_eq!(last_script(formula), Some(script), "{formula}");
    }
    for formula in ["\\Omega", "\\mathbb{I}", "\\frac{a}{b_1}", "(r_1)", ""] {
        assert_eq!(last_script(formula), None, "{formula}");
    }
}

#[test]
fn and_does_not_where_there_is_none() {
    for (slip, formula) in [
        (Slip::Sign, "0"),
        (Slip::Sign, "\\vec 0"),
        (Slip::Symbol, "g"),
        (Slip::Index, "m_{cm}"),
        (Slip::Dot, "m"),
        (Slip::Number, "m"),
        (Slip::Exponent, "2 m"),
        (Slip::Function, "\\theta"),
        (Slip::Accent, "v"),
        (Slip::Order, "m M"),
        (Slip::Fraction, "m M"),
        (Slip::Parenthesis, "m + M"),
        (Slip::Relation, "m = M"),
        (Slip::Factor, "0"),
        (Slip::Term, "0"),
    ] {
        assert_eq!(of_kind(slip, formula), Vec::<String>::new(), "{slip:?} of {formula}");
    }
}

#[test]
fn a_slip_is_undone_by_a_correction_of_the_wrong_text() {
    let (symbols, macros) = (symbols(), Macros::default());
    let (mut undone, mut not_undone) = (HashSet::new(), Vec::new());
    for text in [
        "m + M = \\lambda_1 - \\lambda_2",
        "\\frac{1}{2} m l^2 \\dot\\theta^2 - m g l \\cos\\theta",
        "\\vec L = \\sum_i m_i \\vec r_i \\times \\dot{\\vec r}_i",
        "\\lambda_3 (\\dot\\psi + \\dot\\phi \\cos\\theta)^2",
        "\\mathbf{R} \\mathbf{S} = \\mathbf{S}",
        "\\frac{g}{l} \\sin^2\\theta < 4 m",
        "(m + M) x \\leq M + m",
        "I_{ab} = 3 I_{ba}",
        "\\begin{pmatrix} \\cos\\phi & \\sin\\phi \\\\ -\\sin\\phi & \\cos\\phi \\end{pmatrix}",
    ] {
        let pool = Pool::of([text].into_iter(), &symbols, &macros, 48);
        for slip in slips(text, &symbols, &macros) {
            if is_lost(&slip, text) {
                continue;
            }
            let wrong = slip.applied(text);
            let corrected = corrections(&wrong, &symbols, &macros, &pool);
            let is_undone = corrected.iter().any(|edit| is_the_same(&edit.applied(&wrong), text));
            if !is_undone {
                not_undone.push(format!("{:?}: nothing makes of {wrong} {text} again", slip.slip));
            }
            undone.insert(slip.slip);
        }
    }
    assert!(not_undone.is_empty(), "{}", not_undone.join("\n"));
    assert!(undone.len() >= 12, "only of {undone:?}");
}

#[test]
fn what_authors_do_and_no_slip_of_one_kind_undoes_is_undone() {
    let (symbols, macros) = (symbols(), Macros::default());
    let pool = |text: &str| Pool::of([text].into_iter(), &symbols, &macros, 48);
    for (wrong, right) in [
        ("\\frac{2}{3} m", "\\frac{2}{5} m"),
        ("\\frac{1}{2} m", "\\frac{2}{3} m"),
        ("\\frac12 m", "\\frac{2}{3} m"),
        ("\\frac{m l}{2 M}", "\\frac{2 m l}{3 M}"),
        ("\\frac{3 m}{2 (m + M)} x", "\\frac{2 m}{3 (m + M)} x"),
        ("\\frac{x}{m + M}", "\\frac{x}{m^2 + M^2}"),
        ("M \\sum_i m_i x", "\\frac{1}{M} \\sum_i m_i x"),
        ("\\frac{m}{M} x", "m M x"),
        ("\\frac{1}{m + M} x", "(m + M) x"),
        ("\\sum_i m_i x + m_i", "\\sum_i m_i x + \\sum_i m_i"),
        ("M (m + l x", "M (m + l) x"),
        ("M (m + l x", "M m + l x"),
        ("M m + l) x", "M (m + l) x"),
        ("\\left( m + l x", "\\left( m + l x\\right)"),
        ("\\frac{M (m + l}{x}", "\\frac{M (m + l)}{x}"),
        ("\\theta - \\phi x", "\\phi - \\theta x"),
        ("\\frac{2 m}{M} x", "\\frac{2 M}{m} x"),
        ("\\vec v (\\vec\\omega \\cdot \\vec r)", "\\vec\\omega (\\vec v \\cdot \\vec r)"),
        ("m x l \\sin\\theta", "m x - l \\sin\\theta"),
        ("m \\vec\\omega \\times \\vec v", "m |\\vec\\omega \\times \\vec v|"),
        ("m \\omega \\cdot \\vec v", "m \\hat\\omega \\cdot \\vec v"),
        ("\\mathbf{R} \\theta", "\\mathbf{R} (\\theta)"),
        ("\\mathbf{R} \\mathbf{S}", "\\mathbf{R} \\mathbf{S}^{-1}"),
        ("m^2 x", "m^{-2} x"),
        ("m^2 x", "m^4 x"),
        ("2 m", "\\sqrt{2} m"),
        ("x = m l", "x = 0"),
        ("x \\dot\\theta", "\\theta \\dot x"),
        ("m \\Omega_3", "m \\omega_3"),
        ("m \\ddot\\theta x", "m \\dot\\theta^2 x"),
        ("m \\cos 2\\theta", "m 2 \\cos\\theta"),
        ("2 \\cos\\theta x", "\\cos 2\\theta x"),
        ("m \\sin\\theta", "m \\sin 2 \\theta"),
        ("m \\sin 2\\theta", "m \\sin \\theta"),
        ("e^{-x m l}", "e^{-\\frac{x}{m l}}"),
        ("m \\vec v \\vec\\omega", "m \\vec v \\times \\vec\\omega"),
        ("M m_i + \\vec v \\vec r_i", "M m_i + \\vec v \\times m_i \\vec r_i"),
        ("\\vec v \\times \\vec\\omega \\times \\vec v", "\\vec v \\times (\\vec\\omega \\times \\vec v)"),
        ("\\int M \\, dx", "\\int M \\, d^3x"),
        ("\\int M \\, x", "\\int M \\, d^3 x"),
        ("M x + \\int l \\, d", "M x + \\int l \\, d x"),
        ("\\int M d x + l d x", "\\int M d x + \\int l d x"),
    ] {
        let corrected = corrections(wrong, &symbols, &macros, &pool(wrong));
        let texts: Vec<String> = corrected.iter().map(|edit| bare(&edit.applied(wrong))).collect();
        assert!(texts.contains(&bare(right)), "nothing makes of {wrong} {right}");
        // Where slips are made, nothing is put in that an author would not lose.
        assert!(!slips(wrong, &symbols, &macros).iter().any(|edit| bare(&edit.applied(wrong)) == bare(right)));
    }
    // A parenthesis that has its partner stays as it is.
    let closed = "M (m + l x) \\left( m \\right) \\frac{(m + l)}{x}";
    assert_eq!(balanced(closed), Vec::new());
}

#[test]
fn a_lost_term_may_be_like_one_that_stands_there() {
    let (symbols, macros) = (symbols(), Macros::default());
    let text = "\\lambda_1 \\dot\\theta + \\lambda_2 \\dot\\phi";
    let like = Pool::of([text].into_iter(), &symbols, &macros, 48).of_like_terms(&symbols, &macros);
    let corrected = corrections(text, &symbols, &macros, &like);
    let texts: Vec<String> = corrected.iter().map(|edit| bare(&edit.applied(text))).collect();
    assert!(texts.contains(&bare(&format!("{text} + \\lambda_3 \\dot\\phi"))));
    assert!(!texts.contains(&bare(&format!("{text} + \\lambda_2 \\dot\\phi"))), "it stands there");
}

/// Whether a slip loses what no other place of the text has: an accent, a function, a number, Σ, or a parenthesis together
/// with its power.
fn is_lost(slip: &Edit, text: &str) -> bool {
    let old = &text[slip.span.range()];
    let is_bare = old.chars().all(|c| c.is_ascii_digit()) || ["\\sin", "\\cos", "\\sin^2", "\\sum_i"].contains(&old);
    match slip.slip {
        Slip::Accent => true,
        Slip::Factor => !old.is_empty() && slip.replacement.trim().is_empty() && is_bare,
        Slip::Exponent => old.starts_with('(') || slip.replacement.starts_with('('),
        _ => false,
    }
}

/// Whether two texts are typeset alike, but for the order of their factors and terms.
fn is_the_same(a: &str, b: &str) -> bool {
    let sorted = |text: &str| {
        let mut letters: Vec<char> = bare(text).chars().filter(|c| *c != '+').collect();
        letters.sort_unstable();
        letters
    };
    bare(a) == bare(b) || sorted(a) == sorted(b)
}

#[test]
fn what_a_macro_stands_for_is_edited_as_a_whole_or_not_at_all() {
    let mut macros = Macros::default();
    macros.define("\\half", 0, "\\frac{1}{2} m");
    macros.define("\\rate", 1, "\\dot{#1}^2");
    let text = "\\half \\rate{\\theta} + \\half x";
    let calls: Vec<Span> = ["\\half", "\\rate"]
        .into_iter()
        .flat_map(|call| text.match_indices(call).map(|(at, call)| Span::new(at, at + call.len())))
        .collect();
    assert_eq!(calls.len(), 3);
    let all = slips(text, &symbols(), &macros);
    assert!(all.iter().any(|edit| edit.span == calls[0] && edit.slip == Slip::Factor), "it can be left out: {all:?}");
    for edit in all.iter().chain(&corrections(text, &symbols(), &macros, &Pool::empty())) {
        for call in &calls {
            let apart = edit.span.end <= call.start || call.end <= edit.span.start;
            assert!(apart || edit.span.contains(*call), "{edit:?} is inside of {call:?}");
        }
    }
    // must-fail case: what the macro says, written out, is edited inside.
    let written_out = "\\frac{1}{2} m \\dot{\\theta}^2";
    assert!(slips(written_out, &symbols(), &Macros::default()).iter().any(|edit| edit.slip == Slip::Number));
}

/// What stands in a macro's body comes before its arguments in the text, wherever it is typeset.
#[test]
fn a_macro_may_put_its_argument_anywhere() {
    for body in ["#1^2", "#1_1", "\\left(#1\\right)", "#1 + #1^3", "\\frac{#1}{#1}", "2 #1 - #1"] {
        let mut macros = Macros::default();
        macros.define("\\twice", 1, body);
        for text in ["\\twice{\\theta} = m", "m + \\twice\\theta", "\\twice{m + \\twice{\\theta}} m"] {
            let pool = Pool::of([text].into_iter(), &symbols(), &macros, 8);
            let all = [slips(text, &symbols(), &macros), corrections(text, &symbols(), &macros, &pool)].concat();
            assert!(all.iter().all(|edit| text.get(edit.span.range()).is_some()), "{body}, {text}: {all:?}");
            assert!(!all.is_empty(), "{body}, {text}");
        }
    }
}

/// The commands of a text.
fn commands(text: &str) -> HashSet<String> {
    let name = |kind| match kind {
        TokenKind::Command(name) => Some(name),
        _ => None,
    };
    tokens(text).into_iter().filter_map(|token| name(token.kind)).collect()
}

/// The commands that an edit may bring into a text.
fn known(symbols: &Symbols) -> HashSet<String> {
    let own = "\\sin \\cos \\tan \\cot \\sinh \\cosh \\tanh \\frac \\dot \\ddot \\pm \\mp \\times \\cdot \\, \
               \\lt \\gt \\le \\ge \\leq \\geq \\leqslant \\geqslant \\sqrt \\hat \\left \\right";
    let names = symbols.iter().map(|(_, entry)| entry.name.to_string());
    names.flat_map(|name| commands(&name)).chain(own.split_whitespace().map(str::to_owned)).collect()
}

/// Whether the edits of a text are such that an author could have made them.
fn are_sound(text: &str, symbols: &Symbols) -> Result<usize, String> {
    let macros = Macros::default();
    let pool = Pool::of([text].into_iter(), symbols, &macros, 12);
    let mut known = known(symbols);
    known.extend(commands(text));
    let all = slips(text, symbols, &macros).into_iter().chain(corrections(text, symbols, &macros, &pool));
    let mut count = 0;
    for edit in all {
        let Span { start, end } = edit.span;
        if start > end || !text.is_char_boundary(start) || !text.is_char_boundary(end) {
            return Err(format!("{edit:?} is not between letters"));
        }
        let changed = edit.applied(text);
        if changed == text {
            return Err(format!("{edit:?} changes nothing"));
        }
        if let Some(new) = commands(&changed).difference(&known).next() {
            return Err(format!("{edit:?} makes {new}"));
        }
        count += 1;
    }
    Ok(count)
}

#[test]
fn a_command_and_a_letter_never_run_together() {
    let symbols = symbols();
    for text in [
        "\\theta x",
        "x\\theta x",
        "\\sin x",
        "\\cos\\theta x l",
        "-\\theta x",
        "\\dot\\theta x",
        "\\bar\\lambda x",
        "\\theta m M",
        "m (|x|^2 l - x)",
    ] {
        assert!(are_sound(text, &symbols).expect(text) > 0);
    }
    // must-fail case: where they do, it is seen.
    let known: HashSet<String> = known(&symbols).into_iter().chain(commands("\\theta x")).collect();
    assert_eq!(commands("\\thetax").difference(&known).collect::<Vec<_>>(), ["\\thetax"]);
}

/// The displays of the project's own notes.
fn displays() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations");
    let files =
        std::fs::read_dir(folder).expect("derivations/ can be read").map(|entry| entry.expect("it can be read").path());
    let mut notes: Vec<_> = files.filter(|file| file.extension().is_some_and(|extension| extension == "md")).collect();
    notes.sort();
    let texts = notes.iter().map(|file| std::fs::read_to_string(file).expect("it can be read"));
    texts.flat_map(|text| text.split("$$").skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>()).collect()
}

/// A generator that repeats itself: xorshift.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % n as u64) as usize
    }
}

#[test]
fn an_edit_of_a_display_or_of_any_piece_of_it_is_between_letters_and_makes_no_new_command() {
    let symbols = symbols();
    let all = displays();
    assert!(all.len() > 50, "{} displays", all.len());
    let mut edits = 0;
    for seed in 1..=3 {
        let mut random = Random(seed);
        for display in &all {
            let ends: Vec<usize> = display.char_indices().map(|(at, _)| at).collect();
            let (a, b) = (ends[random.below(ends.len())], ends[random.below(ends.len())]);
            let text = if seed == 1 { display.as_str() } else { &display[a.min(b)..a.max(b)] };
            // Half a command would take what comes after it for its other half.
            let text = text.trim_end_matches('\\');
            edits += are_sound(text, &symbols).unwrap_or_else(|error| panic!("seed {seed}: {error} in\n{text}"));
        }
    }
    assert!(edits > 10_000, "only {edits} edits");
}
