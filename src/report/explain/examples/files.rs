//! Examples of what the notes, the claims file or the command line say wrong, and of what a claims file leaves out.

use super::example::Example;

pub(super) const FILES: &[Example] = &[
    Example {
        word: "invalid-unit",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ M = F l \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "M, F, l": "> 0" },
  "units": { "M": "Nm" }
}"#,
            ),
        ],
    },
    Example {
        word: "claims-file",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ a = b \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constant": { "a, b": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "json",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \theta = 2 x \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x": "any", "\theta": "angle" }
}"#,
            ),
        ],
    },
    Example {
        word: "equation-address",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ (a + b)^2 = a^2 + 2ab + b^2 \tag{6.73} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "a, b": "any" },
  "equations": { "6.74": { "holds": "always" } }
}"#,
            ),
        ],
    },
    Example {
        word: "notes-file",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ a = b \tag{1} $$

$$ b = a \tag{1} $$",
            ),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "a, b": "any" }
}"#,
            ),
        ],
    },
    Example { word: "input", command: "onshell check nots.md", files: &[] },
    Example {
        word: "no-claims-file",
        command: "onshell check notes.md --claims clams.json",
        files: &[("notes.md", r"$$ a = b \tag{1} $$")],
    },
    Example {
        word: "lost-in-print",
        command: "onshell check print.md --claims notes.json",
        files: &[
            ("notes.md", r"$$ (a + b)^2 = a^2 + 2ab + b^2 = (b + a)^2 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "a, b": "any" }
}"#,
            ),
            ("print.md", r"$$ (a + b)^2 = a^2 + 2ab + b^2 \tag{1} $$"),
        ],
    },
    Example {
        word: "no-claim",
        command: "onshell check print.md --claims notes.json",
        files: &[
            ("notes.md", r"$$ (a + b)^2 = a^2 + 2ab + b^2 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "a, b": "any" }
}"#,
            ),
            (
                "print.md",
                r"$$ (a + b)^2 = a^2 + 2ab + b^2 \tag{1} $$

$$ a = b \tag{2} $$",
            ),
        ],
    },
    Example {
        word: "skipped",
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
        word: "claim-does-not-fit",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \sin x = x \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x": "any" },
  "equations": { "1": { "small": "x" } }
}"#,
            ),
        ],
    },
    Example {
        word: "needs-limit-or-small",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \sin\theta \approx \theta \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "\\theta": "angle" }
}"#,
            ),
        ],
    },
    Example {
        word: "wrong-reference",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ T = \frac12 m v^2 \tag{1} $$

The force is that of (1).",
            ),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "m": "> 0", "v, F": "any" },
  "sentences": [{
    "quote": "The force is that of (1)",
    "refers to": "1",
    "containing": "F"
  }]
}"#,
            ),
        ],
    },
];
