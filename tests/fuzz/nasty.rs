//! Formulas of at most 200 bytes that cost as much as possible: functions within functions, towers of powers, products of
//! sums, roots within roots, sums and derivatives within each other.

use super::draw::Draw;

/// The most bytes of a formula.
const LONGEST: usize = 200;

/// A formula that is hard for its length.
pub fn formula(draw: &mut Draw) -> String {
    loop {
        let mut text = draw.one(&["x", "y", "x + y", "x y", "x + 2"]).to_owned();
        let shape = draw.below(5);
        for _ in 0..draw.whole(3, 16) {
            let next = grown(&text, shape, draw);
            if next.len() > LONGEST {
                break;
            }
            text = next;
        }
        if text.len() <= LONGEST {
            return text;
        }
    }
}

/// The formula within another. In a `shape` of one kind the same step comes often.
fn grown(text: &str, shape: usize, draw: &mut Draw) -> String {
    let letter = draw.one(&["x", "y", "z"]);
    let n = draw.whole(2, 9);
    let step = if draw.below(3) == 0 { draw.below(16) } else { [0, 3, 6, 8, 12][shape] + draw.below(2) };
    match step {
        0 => format!("\\sin({text})"),
        1 => format!("\\cos({text} + {letter})"),
        2 => format!("e^{{\\sin({text})}}"),
        3 => format!("({text} + {letter})^{{{n}}}"),
        4 => format!("({text})^2 + {letter}"),
        5 => format!("({text})^{{{}}}", draw.one(&["12", "40", "-7", "\\frac13", "x", "99"])),
        6 => format!("\\sqrt{{{text} + {n}}}"),
        7 => format!("\\sqrt{{({text})^2 + {letter}^2}}"),
        8 => format!("\\frac{{{letter}}}{{{n} + {text}}}"),
        9 => format!("\\frac{{{text} + {letter}}}{{{text} - {n}}}"),
        10 => format!("|{letter} - {text}|"),
        11 => format!("\\arctan({text})"),
        12 => format!("\\frac{{\\partial}}{{\\partial {letter}}}\\left({text}\\right)"),
        13 => format!("\\left({text}\\right)\\left({letter}^{n} + 1\\right)"),
        14 => format!("\\sum_{{n=1}}^{{9}} \\left({text} + n\\right)^n"),
        _ => format!("\\ln\\left({n} + ({text})^2\\right)"),
    }
}

/// Two hard formulas: the same one twice, written in another way or off by little, or two different ones.
pub fn pair(draw: &mut Draw) -> (String, String) {
    let a = formula(draw);
    let b = match draw.below(5) {
        0 => formula(draw),
        1 => format!("{a} + 10^{{-{}}}", draw.whole(1, 30)),
        2 => format!("-\\left({a}\\right)"),
        3 => format!("\\left({a}\\right) \\cdot 1.{}1", "0".repeat(draw.below(20))),
        _ => format!("{a} + x - x"),
    };
    (a, b)
}
