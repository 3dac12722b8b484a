//! Texts that nobody would write: tokens at random, and documents with random damage.

use super::draw::Draw;

const TOKENS: [&str; 64] = [
    "x",
    "y",
    "\\theta",
    "1",
    "2",
    "0.5",
    "10^{99}",
    "+",
    "-",
    "=",
    "\\cdot",
    "\\times",
    "/",
    "^",
    "_",
    "{",
    "}",
    "(",
    ")",
    "[",
    "]",
    "|",
    "\\|",
    "\\left(",
    "\\right)",
    "\\left|",
    "\\right|",
    "\\left.",
    "\\right.",
    "\\frac",
    "\\sqrt",
    "\\sqrt[3]",
    "\\dot",
    "\\ddot",
    "\\vec",
    "\\hat",
    "\\sin",
    "\\cos",
    "\\ln",
    "\\exp",
    "\\sum_{n=1}^{N}",
    "\\int_0^1",
    "\\prod",
    "\\partial",
    "\\frac{d}{dt}",
    "\\begin{pmatrix}",
    "\\end{pmatrix}",
    "\\begin{cases}",
    "\\end{cases}",
    "&",
    "\\\\",
    ",",
    "\\quad",
    "\\text{if}",
    "\\mathrm{d}",
    "'",
    "!",
    "\\to",
    "\\infty",
    "\\ne",
    "\\le",
    "\\approx",
    "\u{3b8}",
    "\u{0}",
];

/// A text of tokens at random.
pub fn soup(draw: &mut Draw) -> String {
    let count = draw.whole(1, 40);
    let mut text = String::new();
    for _ in 0..count {
        text.push_str(draw.one(&TOKENS));
        text.push_str(draw.one(&["", " ", ""]));
    }
    // And some bytes that are no tokens.
    for _ in 0..draw.below(3) {
        let at = draw.below(text.chars().count() + 1);
        let stray = char::from_u32(draw.below(0x2_0000) as u32).unwrap_or('\u{fffd}');
        text = text.chars().take(at).chain([stray]).chain(text.chars().skip(at)).collect();
    }
    text
}

const NOTES: &str = "# Pendulum\n\nThe energy is conserved.\n\n$$ T = \\frac12 m l^2 \\dot\\theta^2 \\tag{1} $$\n\n\
    $$ U = -m g l \\cos\\theta, \\quad E = T + U \\tag{2} $$\n\n$$ \\ddot\\theta = -\\frac{g}{l} \\sin\\theta \\tag{3} $$\n\n\
    $$\\begin{aligned} \\ddot\\theta &\\approx -\\omega^2 \\theta \\\\ \\omega &= \\sqrt{g/l} \\end{aligned} \\tag{4} $$\n";

const CLAIMS: &str = "{ \"notes\": \"notes.md\", \"system\": \"simple_pendulum\", \"coordinates\": { \"\\\\theta\": \"angle\" },\n\
    \"constants\": { \"m, l, g\": \"> 0\" }, \"means\": { \"T\": \"kinetic energy\", \"U\": \"potential energy\" },\n\
    \"define\": { \"\\\\omega\": \"\\\\sqrt{g/l}\" },\n\
    \"equations\": { \"4\": { \"small\": \"\\\\theta\", \"order\": 2 } },\n\
    \"sentences\": [{ \"quote\": \"The energy is conserved.\", \"conserved\": \"E\" }] }\n";

/// A document with its claims file, either or both with some damage.
pub fn document(draw: &mut Draw) -> (String, String) {
    let (mut notes, mut claims) = (NOTES.to_owned(), CLAIMS.to_owned());
    let which = draw.below(3);
    for _ in 0..draw.whole(1, 4) {
        if which != 1 {
            notes = damaged(&notes, draw);
        }
        if which != 0 {
            claims = damaged(&claims, draw);
        }
    }
    (notes, claims)
}

fn damaged(text: &str, draw: &mut Draw) -> String {
    let chars: Vec<char> = text.chars().collect();
    let at = draw.below(chars.len().max(1));
    let end = (at + draw.whole(1, 12) as usize).min(chars.len());
    let piece: String = chars[at.min(end)..end].iter().collect();
    let (before, after): (String, String) = (chars[..at.min(end)].iter().collect(), chars[end..].iter().collect());
    match draw.below(5) {
        0 => before + &after,
        1 => format!("{before}{piece}{piece}{after}"),
        2 => format!("{before}{}{piece}{after}", draw.one(&TOKENS)),
        3 => {
            format!("{before}{}{after}", draw.one(&["\"", "{", "}", "$", "$$", "\\", "[", ":", "9e999", "-1", "null"]))
        }
        _ => format!("{before}{}{after}", piece.chars().rev().collect::<String>()),
    }
}
