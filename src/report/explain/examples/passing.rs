//! Examples of claims that hold, and of definitions.

use super::example::Example;

pub(super) const PASSING: &[Example] = &[
    Example {
        word: "holds",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ (a + b)^2 = a^2 + 2ab + b^2 \tag{1} $$"),
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
        word: "true-by-definition",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ K = 2T \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "T": "> 0" },
  "define": { "K": "2T" }
}"#,
            ),
        ],
    },
    Example {
        word: "definition-unused",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ p = m v \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "m, v": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "definition-users-fail",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ p = m v \tag{1} $$

$$ p (v + m) = m v^2 - m^2 v \tag{2} $$",
            ),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "m, v": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "definition-not-tested",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ p = m v \tag{1} $$

$$ p v = m v^2 \tag{2} $$",
            ),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "m": "> 0", "v": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "definition-zero",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ a = x - x \tag{1} $$

$$ a y = 0 \tag{2} $$",
            ),
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
        word: "definition-up-to-sign",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ \omega = \sqrt{g/l} \tag{1} $$

$$ \ddot\theta = -\omega^2 \sin\theta \tag{2} $$",
            ),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "system": "simple_pendulum",
  "coordinates": { "\\theta": "angle" },
  "constants": { "m, l, g": "> 0" }
}"#,
            ),
        ],
    },
    Example {
        word: "lagrangian-defined",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ L = \frac12 m \dot x^2 - \frac12 k x^2 \tag{1} $$

$$ m \ddot x = -k x \tag{2} $$",
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
    Example { word: "introduced", command: "onshell check notes.md", files: &[("notes.md", r"$$ E = T + U $$")] },
    Example {
        word: "not-always",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"In general, $a - b$ is not $b - a$."),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "a, b": "any" },
  "sentences": [{ "quote": "is not", "not always": "a - b = b - a" }]
}"#,
            ),
        ],
    },
];
