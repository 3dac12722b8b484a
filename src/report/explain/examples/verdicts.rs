//! Examples of verdicts and of outcomes of mutants.

use super::example::Example;

pub(super) const VERDICTS: &[Example] = &[
    Example {
        word: "certified",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \sin 2x = 2 \sin x \cos x \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "verified",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \ln(a^7) = 7 \ln a \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "a": "> 0" }
}"#,
            ),
        ],
    },
    Example {
        word: "definition",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ p = m l^2 \dot\theta \tag{1} $$

$$ \dot p = -m g l \sin\theta \tag{2} $$",
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
        word: "law",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ F = m \ddot x \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "m": "> 0" },
  "varies with time": { "x, F": "any" },
  "laws": { "Newton's second law": "1" }
}"#,
            ),
        ],
    },
    Example {
        word: "assumed",
        command: "onshell check notes.md",
        files: &[(
            "notes.md",
            r"$$ E = \frac12 m v^2 $$

$$ a = \frac{v^2}{r} $$

$$ F = m a $$

$$ E = \frac12 F R $$",
        )],
    },
    Example {
        word: "unclaimed",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ Z = \int \mathcal{D}x \, e^{S} \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "equations": { "1": { "skip": "a path integral" } }
}"#,
            ),
        ],
    },
    Example {
        word: "undecided",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \ln(x - 5000) = \ln(x - 5000) + 1 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x": "> 0" }
}"#,
            ),
        ],
    },
    Example {
        word: "domain",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \ln(x^2) = 2 \ln x \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "unreadable",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ a = \cos\theta p_\psi \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "a, \\theta, p_\\psi": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "refuted",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \ddot\theta = \frac{g}{l} \sin\theta \tag{1} $$"),
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
        word: "refused",
        command: "onshell mutate notes.md",
        files: &[
            (
                "notes.md",
                r"$$ p = m l^2 \dot\theta \tag{1} $$

$$ \dot p = -m g l \sin\theta \tag{2} $$",
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
        word: "equivalent",
        command: "onshell mutate notes.md",
        files: &[
            ("notes.md", r"$$ \cos(-x) = 1 - 2 \sin^2 \frac x2 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "survived",
        command: "onshell mutate notes.md",
        files: &[
            ("notes.md", r"$$ x^2 \geq 0 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x": "> 0" }
}"#,
            ),
        ],
    },
];
