//! Statements under claims, true or false by the way they are made: branches of definitions, functions of several arguments,
//! limits, narrow dips of inequalities, hypotheses, chains.

use serde_json::{Value as Json, json};

use super::draw::Draw;
use super::tree::smooth;

/// A display with its claims.
pub struct Statement {
    pub display: String,
    pub claims: Json,
}

fn under(display: String, claim: Json, more: Json) -> Statement {
    let mut claims = json!({
        "notes": "notes.md",
        "constants": { "x, y, z": "any", "p, q": "> 0", "u": "(1, 2)" },
        "equations": { "1": claim }
    });
    if let Some(more) = more.as_object() {
        for (key, value) in more {
            claims[key] = value.clone();
        }
    }
    Statement { display, claims }
}

/// A number whose inverse is large, as it is printed: 10⁻³ to 10⁻¹².
fn small(draw: &mut Draw) -> String {
    format!("0.{}1", "0".repeat(draw.whole(2, 11) as usize))
}

/// A statement, true as it stands or off by little; the same numbers give the two.
pub fn statement(draw: &mut Draw, is_true: bool) -> Statement {
    let (a, b, n) = (draw.whole(1, 9), draw.whole(1, 9), draw.whole(2, 5));
    let off = small(draw);
    let factor = if is_true { "1".to_owned() } else { format!("(1 + {off})") };
    match draw.below(8) {
        // A branch: the sign beyond the angle's range is the author's, the factor is not.
        0 => {
            let (name, formula) = draw.one(&[
                (r"x = \sqrt{x^2 + y^2}\cos\varphi", r"\arctan\frac{y}{x}"),
                (r"y = \sqrt{x^2 + y^2}\sin\varphi", r"\arctan\frac{y}{x}"),
                (r"x = \sqrt{x^2 + y^2}\cos\varphi", r"\arcsin\frac{y}{\sqrt{x^2 + y^2}}"),
                (r"y = \sqrt{x^2 + y^2}\sin\varphi", r"\arccos\frac{x}{\sqrt{x^2 + y^2}}"),
            ]);
            under(format!("{name} \\cdot {factor}"), json!({}), json!({ "define": { r"\varphi": formula } }))
        }
        // A function of two arguments.
        1 => under(
            format!(
                "\\frac{{\\partial}}{{\\partial x}} \\left( x^{n} \\frac{{\\partial V}}{{\\partial y}} \\right) = \
                 {n} x^{{{}}} \\frac{{\\partial V}}{{\\partial y}} + {factor} x^{n} \\frac{{\\partial^2 V}}{{\\partial y \\partial x}}",
                n - 1
            ),
            json!({}),
            json!({ "functions": { "V": "of x, y" } }),
        ),
        // Limits.
        2 => under(
            format!("\\frac{{\\sin {a} x}}{{x}} \\approx {a} \\cdot {factor}"),
            json!({ "limit": "x \\to 0" }),
            json!({}),
        ),
        3 => under(
            format!("\\frac{{{a} p^{n} + {b}}}{{p^{n} + 1}} \\approx {a} \\cdot {factor}"),
            json!({ "limit": "p \\to \\infty" }),
            json!({}),
        ),
        // A dip below 0, as narrow as it is deep.
        4 => {
            let sign = if is_true { "+" } else { "-" };
            under(format!("(x - {a}.{b})^2 (x^2 + {n}) {sign} {off} > 0"), json!({}), json!({}))
        }
        // Hypotheses.
        5 => {
            let inner = smooth(draw, 1).latex();
            under(
                format!(
                    "\\left(z - {a} y\\right)\\left({inner}\\right)^2 = {factor} \\cdot {b} x \\left({inner}\\right)^2"
                ),
                json!({ "assume": format!("z = {a} y + {b} x") }),
                json!({}),
            )
        }
        6 => under(
            format!("x^2 + {a} x y = {factor} \\cdot {b} + {a} x y"),
            json!({ "assume": format!("x^2 = {b}") }),
            json!({}),
        ),
        // A chain with one wrong link.
        _ => under(
            format!("(x + {a})^2 - x^2 = {a} (2 x + {a}) = {} x + {factor} \\cdot {}", 2 * a, a * a),
            json!({}),
            json!({}),
        ),
    }
}
