//! Examples of formulas that are not read, or have no value.

use super::example::Example;

pub(super) const READING: &[Example] = &[
    Example {
        word: "ambiguous",
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
        word: "undeclared-name",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ F + R = m a \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "F, m, a": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "syntax",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ x = \frac{a}{b \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x, a, b": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "unknown-command",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ T = \myhalf m v^2 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "T, m, v": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "not-supported",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ F \propto r^{-2} \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "F, r": "> 0" }
}"#,
            ),
        ],
    },
    Example {
        word: "shape-mismatch",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \vec v = 3 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "\\vec v": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "index-mismatch",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ L_a = I_{ab} \omega_c \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "indices": { "a, b, c": "1..3" },
  "constants": { "L_a, I_{ab}, \\omega_c": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "unit-mismatch",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ E = m v \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "E, m, v": "> 0" },
  "units": { "E": "J", "m": "kg", "v": "m/s" }
}"#,
            ),
        ],
    },
    Example {
        word: "too-large",
        command: "onshell check notes.md",
        files: &[(
            "notes.md",
            r"$$
a = {{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{
a
}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}}
$$",
        )],
    },
    Example {
        word: "unclear-name",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \dot m = 0 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "m": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "no-value",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ M = \int_V \rho(\vec r) \, d^3r \tag{1} $$

$$ M = \rho_0 V \tag{2} $$",
            ),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "\\rho_0": "> 0" },
  "continua": { "V": { "mass per volume": "\\rho(\\vec r)" } }
}"#,
            ),
        ],
    },
    Example {
        word: "no-relation",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \frac12 m v^2 \tag{1} $$"),
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
        word: "depends-on-unreadable",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ p = \frac{m v \tag{1} $$

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
        word: "definition-contradicted",
        command: "onshell check notes.md",
        files: &[(
            "notes.md",
            r"$$ t_1 = \frac{v}{7 a} $$

$$ v_1 = v - a t_1 = \frac57 v $$

$$ s_1 = v t_1 - \frac12 a t_1^2 = \frac{12 v^2}{49 a} $$",
        )],
    },
    Example {
        word: "dimensions-conflict",
        command: "onshell check notes.md",
        files: &[(
            "notes.md",
            r"$$ E = \gamma m c^2 $$

$$ p = \gamma m v $$

$$ \gamma = \frac{1}{\sqrt{1 - v^2/c^2}} $$

$$ T = E - m c^2 $$

Let the energy and the momentum be related by

$$ E^2 = p^2c^2 + m^2c^2 $$",
        )],
    },
];
