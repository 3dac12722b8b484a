//! Examples of claims that are false.

use super::example::Example;

pub(super) const FAILING: &[Example] = &[
    Example {
        word: "sides-differ",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ (a + b)^2 = a^2 + b^2 \tag{1} $$"),
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
        word: "numbers-differ",
        command: "onshell check notes.md",
        files: &[("notes.md", r"$$ v = 9.8\,\text{m/s}^2 \times 2.0\,\text{s} = 196\,\text{m/s} $$")],
    },
    Example {
        word: "inequality-fails",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ x^2 > 0 \tag{1} $$"),
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
        word: "differs-as-identity",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ (1 + 10^{-16}) x = x \tag{1} $$"),
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
        word: "fails-for-family-size",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \sum_i \sum_{j \neq i} k = (6n - 12) k \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "indices": { "i, j": "1..n" },
  "constants": { "k": "any" }
}"#,
            ),
        ],
    },
    Example {
        word: "domain-differs",
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
        word: "one-branch",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ r = \sqrt{x^2 + y^2} \tag{1} $$

$$ \varphi = \arctan(y/x) \tag{2} $$

$$ x = r \cos\varphi \tag{3} $$",
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
        word: "not-conserved",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ p = m \dot\theta \tag{1} $$"),
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
        word: "limit-not-reached",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \tanh a \approx a \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "a": "> 0" },
  "equations": { "1": { "limit": "a \\to \\infty" } }
}"#,
            ),
        ],
    },
    Example {
        word: "order-differs",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \cos x \approx 1 + x^2/2 \tag{1} $$"),
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
        word: "not-a-solution",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ x^2 = 9 \tag{1} $$

$$ x = 2 \tag{2} $$",
            ),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x": "> 0" },
  "equations": { "2": { "solves": "1", "for": "x" } }
}"#,
            ),
        ],
    },
    Example {
        word: "repeated-solution",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ x^2 = k \tag{1} $$

$$ x_\pm = \sqrt k, \quad x_\pm = \sqrt k \tag{2} $$",
            ),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "k": "> 0", "x": "any" },
  "equations": { "2": { "solves": "1", "for": "x" } }
}"#,
            ),
        ],
    },
    Example {
        word: "missing-solutions",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ x^2 = 9 \tag{1} $$

$$ x = 3 \tag{2} $$",
            ),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x": "any" },
  "equations": { "2": { "solves": "1", "for": "x" } }
}"#,
            ),
        ],
    },
    Example {
        word: "integral-differs",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ \sum_i m_i = 2 \int_V \rho(\vec r) \, d^3r \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "indices": { "i": "1..n" },
  "constants": { "m_i": "> 0", "\\vec r_i": "any" },
  "continua": {
    "V": {
      "mass per volume": "\\rho(\\vec r)",
      "particles": "m_i at \\vec r_i"
    }
  },
  "equations": { "1": { "continuum limit of": "1" } }
}"#,
            ),
        ],
    },
    Example {
        word: "function-shape-fails",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"The potential $x^4 - x^2$ has one minimum."),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x": "any" },
  "sentences": [{
    "quote": "has one minimum",
    "of": "x^4 - x^2",
    "minima": 1,
    "against": "x"
  }]
}"#,
            ),
        ],
    },
    Example {
        word: "exactly-when-fails",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ x^2 > a^2 \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "x, a": "any" },
  "equations": { "1": { "true exactly when": "x > a" } }
}"#,
            ),
        ],
    },
    Example {
        word: "not-the-hamiltonian",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"$$ H = \frac{p_\theta^2}{2 m l^2} + m g l \cos\theta \tag{1} $$"),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "system": "simple_pendulum",
  "coordinates": { "\\theta": "angle" },
  "constants": { "m, l, g": "> 0" },
  "equations": { "1": { "generates": "the motion" } }
}"#,
            ),
        ],
    },
    Example {
        word: "holds-always",
        command: "onshell check notes.md",
        files: &[
            ("notes.md", r"In general, $a + b$ is not $b + a$."),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "constants": { "a, b": "any" },
  "sentences": [{ "quote": "is not", "not always": "a + b = b + a" }]
}"#,
            ),
        ],
    },
    Example {
        word: "follows-from-mistake",
        command: "onshell check notes.md",
        files: &[
            (
                "notes.md",
                r"$$ L = \frac12 m \dot x^2 - \frac12 k x^2 \tag{1} $$

$$ m \ddot x = k x \tag{2} $$

$$ \ddot x = \frac km x \tag{3} $$",
            ),
            (
                "notes.json",
                r#"{
  "notes": "notes.md",
  "coordinates": { "x": "any" },
  "constants": { "m, k": "> 0" },
  "means": { "L": "Lagrangian" },
  "steps": ["2, 3"]
}"#,
            ),
        ],
    },
];
