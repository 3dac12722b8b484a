//! Examples of claims that are not decided.

use super::example::Example;

pub(super) const UNDECIDED: &[Example] = &[
    Example {
        word: "equation-for-unknown",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"With
$$ L = \frac12 m \dot x^2 - \frac12 k x^2, \quad E = \frac12 m \dot x^2 + \frac12 k x^2 \tag{1} $$
the distances are the roots of
$$ E - \frac12 k x^2 = 0 . \tag{2} $$",
            ),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "coordinates": { "x": "any" },
  "constants": { "m, k": "> 0" },
  "means": { "L": "Lagrangian" }
}"#,
            ),
        ],
    },
    Example {
        word: "no-state",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ 2x = x + 1 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x": "any" },
  "equations": { "1": { "assume": ["x > 1", "x < 0"] } }
}"#,
            ),
        ],
    },
    Example {
        word: "too-few-states",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \sqrt{1 - v^2/c^2} \, \sqrt{1 + v^2/c^2} = \sqrt{1 - v^4/c^4} \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "v": "[3, 9]", "c": "[1, 2]" }
}"#,
            ),
        ],
    },
    Example {
        word: "within-rounding",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ M = \int_V \rho(\vec r) \, d^3r \, , \quad
\int_V \rho(\vec r) (x^2 + y^2) \, d^3r = 0.4000000000001 M R^2 \tag{1} $$",
            ),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "R": "> 0" },
  "axes": { "\\hat x, \\hat y, \\hat z": "fixed" },
  "define": {
    "x": "\\vec r \\cdot \\hat x",
    "y": "\\vec r \\cdot \\hat y"
  },
  "continua": {
    "V": {
      "mass per volume": "\\rho(\\vec r)",
      "uniform": true,
      "made of": [{ "ball": "R" }]
    }
  }
}"#,
            ),
        ],
    },
    Example {
        word: "term-too-small",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ y + 10^{20} = 10^{20} + x + y - x \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x, y": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "mutant-passes",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \sqrt{1 + a} \approx 1 + a/3 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "a": "> 0" },
  "equations": { "1": { "limit": "a \\to 0" } }
}"#,
            ),
        ],
    },
    Example {
        word: "side-always-zero",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \frac{d}{dt}(\vec r \times \vec r) = \vec 0 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "varies with time": { "\\vec r": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "restates-hypothesis",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ x = 2y \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x, y": "any" },
  "equations": { "1": { "assume": "y = x/2" } }
}"#,
            ),
        ],
    },
    Example {
        word: "follows-from-hypotheses",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \dot x = 0 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "varies with time": { "x": "any" },
  "constants": { "x_0": "any" },
  "equations": { "1": { "throughout": "x = x_0" } }
}"#,
            ),
        ],
    },
    Example {
        word: "same-formula",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ a + b = a + b \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "a, b": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "forced-value",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ x^2 = x^3 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x, y": "any" },
  "equations": { "1": { "assume": ["x + y = 0", "x - y = 0"] } }
}"#,
            ),
        ],
    },
    Example {
        word: "not-decided",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ x + \sqrt{x^3} \approx x \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x": "> 0" },
  "equations": { "1": { "small": "x", "order": 1 } }
}"#,
            ),
        ],
    },
    Example {
        word: "contradiction",
        command: "onshell check notes.md",
        files: &[(
            "notes.md",
            r"$$ t_1 = \frac{v}{7 a} $$

$$ v_1 = v - a t_1 = \frac57 v $$",
        )],
    },
    Example {
        word: "always-constant",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ Q = m l^2 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "system": "simple_pendulum",
  "coordinates": { "\\theta": "angle" },
  "constants": { "m, l, g": "> 0" },
  "equations": { "1": { "conserved": true } }
}"#,
            ),
        ],
    },
    Example {
        word: "no-motion",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ p = m \dot x \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "varies with time": { "x": "any" },
  "constants": { "m": "> 0" },
  "equations": { "1": { "conserved": true } }
}"#,
            ),
        ],
    },
    Example {
        word: "term-beyond-order",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \sin x \approx x + 5x^3 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x": "any" },
  "equations": { "1": { "small": "x", "order": 2 } }
}"#,
            ),
        ],
    },
    Example {
        word: "variable-absent",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"The function $\cos\phi$ has one minimum."),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "\\theta, \\phi": "angle" },
  "sentences": [{
    "quote": "has one minimum",
    "of": "\\cos\\phi",
    "minima": 1,
    "against": "\\theta"
  }]
}"#,
            ),
        ],
    },
    Example {
        word: "variable-fixed",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"The function $\cos\theta$ has one minimum."),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "\\theta": "angle" },
  "sentences": [{
    "quote": "has one minimum",
    "of": "\\cos\\theta",
    "minima": 1,
    "against": "\\theta",
    "assume": "\\theta = 0"
  }]
}"#,
            ),
        ],
    },
    Example {
        word: "not-independent",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"The energy $\frac12 m\dot x^2$ is positive."),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "varies with time": { "x": "any" },
  "constants": { "m": "> 0" },
  "sentences": [{
    "quote": "is positive",
    "of": "\\frac12 m\\dot x^2",
    "sign": "positive",
    "against": "x"
  }]
}"#,
            ),
        ],
    },
    Example {
        word: "too-close",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"The function $\sin 100x$ has two maxima."),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x": "any" },
  "sentences": [{
    "quote": "has two maxima",
    "of": "\\sin(100x)",
    "maxima": 2,
    "against": "x"
  }]
}"#,
            ),
        ],
    },
    Example {
        word: "circular",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ y = x \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x, y": "any" },
  "equations": { "1": { "dropping": "y - x" } }
}"#,
            ),
        ],
    },
    Example {
        word: "not-a-law",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ p = m \dot x \tag{1} $$

$$ \dot p = m \ddot x \tag{2} $$",
            ),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "m": "> 0" },
  "varies with time": { "x": "any" },
  "laws": { "Newton's second law": "2" }
}"#,
            ),
        ],
    },
    Example {
        word: "laws-too-strong",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ F = m \ddot x \tag{1} $$

$$ F = 2 m \ddot x \tag{2} $$",
            ),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "m": "> 0" },
  "varies with time": { "x, F": "any" },
  "laws": { "the first law": "1", "the second law": "2" }
}"#,
            ),
        ],
    },
];
