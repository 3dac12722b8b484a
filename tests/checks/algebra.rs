//! Matrices, complex numbers and cases in documents: each identity beside a false one.

use onshell::check::Verdict;
use onshell::check::Verdict::{Certified, Definition, Refuted, Unreadable, Verified};
use onshell::systems::Registry;
use serde_json::{Value as Json, json};

use crate::support::{document, numbered};

/// The verdict on each display.
fn verdicts(claims: &Json, displays: &[&str]) -> Vec<Verdict> {
    let checked = document(claims, &numbered(displays), &Registry::standard(), None).unwrap();
    checked.equations.iter().map(|equation| equation.finding.verdict).collect()
}

fn matrices() -> Json {
    json!({ "constants": {
        "A, B": "3x3 matrix", "C, D": "2x2 matrix", "u, v": "2x1 matrix", r"k, m, \omega": "> 0",
    } })
}

#[test]
fn matrices_do_not_commute() {
    let pairs = [
        (r"\operatorname{tr}(A B) = \operatorname{tr}(B A)", "A B = B A"),
        (r"(A B)^T = B^T A^T", "(A B)^T = A^T B^T"),
        (r"\det(A B) = \det A \, \det B", r"\det(A + B) = \det A + \det B"),
        (r"\det(A^{-1}) \det A = 1", r"\det(A^{-1}) = \det A"),
        ("(A B)^{-1} = B^{-1} A^{-1}", "(A B)^{-1} = A^{-1} B^{-1}"),
        ("[A, B] = A B - B A", "[A, B] = B A - A B"),
        ("(A + B)^2 = A^2 + A B + B A + B^2", "(A + B)^2 = A^2 + 2 A B + B^2"),
        (r"u^T C v = v^T C^T u", "u^T C v = v^T C u"),
        (r"\det(2 C) = 4 \det C", r"\det(2 C) = 2 \det C"),
        ("C_{11} + C_{22} = \\operatorname{tr} C", "C_{12} + C_{21} = \\operatorname{tr} C"),
        (r"C^2 - \operatorname{tr}(C) \, C + \det(C) \, I = 0", r"C^2 - \operatorname{tr}(C) \, C - \det(C) \, I = 0"),
    ];
    // All in one document, which is made ready once.
    let displays: Vec<&str> = pairs.iter().flat_map(|(right, wrong)| [*right, *wrong]).collect();
    for (found, pair) in verdicts(&matrices(), &displays).chunks(2).zip(pairs) {
        assert_eq!(found, [Certified, Refuted], "{pair:?}");
    }
}

#[test]
fn a_display_can_define_a_matrix() {
    let displays = [
        r"K = \begin{pmatrix} 2k & -k \\ -k & 2k \end{pmatrix}",
        r"M = \operatorname{diag}(m, m)",
        r"\det(K - \omega^2 M) = (k - m \omega^2) (3 k - m \omega^2)",
        r"K \begin{pmatrix} 1 \\ -1 \end{pmatrix} = 3 k \begin{pmatrix} 1 \\ -1 \end{pmatrix}",
        r"\begin{vmatrix} 2k & -k \\ -k & 2k \end{vmatrix} = 3 k^2",
        r"\det(K - \omega^2 M) = (k - m \omega^2) (2 k - m \omega^2)",
        r"K \begin{pmatrix} 1 \\ -1 \end{pmatrix} = k \begin{pmatrix} 1 \\ -1 \end{pmatrix}",
        r"\begin{vmatrix} 2k & -k \\ -k & 2k \end{vmatrix} = 5 k^2",
    ];
    let found = verdicts(&matrices(), &displays);
    assert_eq!(found[2..], [Certified, Certified, Certified, Refuted, Refuted, Refuted]);
    assert_eq!(found[0], Definition);
}

#[test]
fn shapes_that_do_not_fit_are_refused() {
    for latex in ["A C = B", "u v = k", r"\det u = 0", "A + k = B", "A^{1/2} = B"] {
        assert_eq!(verdicts(&matrices(), &[latex]), [Unreadable], "{latex}");
    }
}

fn complex() -> Json {
    json!({ "constants": {
        r"\theta, \phi": "angle", "x, y, a": "any", r"z, w": "complex", "i": "imaginary unit",
    } })
}

#[test]
fn complex_numbers_are_decided_by_their_parts() {
    let pairs = [
        (r"e^{i\theta} = \cos\theta + i\sin\theta", r"e^{i\theta} = \cos\theta - i\sin\theta"),
        (r"e^{i\theta} e^{i\phi} = e^{i(\theta + \phi)}", r"e^{i\theta} e^{-i\phi} = e^{i(\theta + \phi)}"),
        (r"\sin\theta = \frac{e^{i\theta} - e^{-i\theta}}{2i}", r"\sin\theta = \frac{e^{i\theta} - e^{-i\theta}}{2}"),
        ("|z|^2 = z z^*", "|z|^2 = z^2"),
        (r"(z w)^* = z^* w^*", "(z w)^* = z w^*"),
        (r"\frac{1}{x + i y} = \frac{x - i y}{x^2 + y^2}", r"\frac{1}{x + i y} = \frac{x + i y}{x^2 + y^2}"),
        (r"\operatorname{Re}(z) = \frac{z + \bar z}{2}", r"\operatorname{Im}(z) = \frac{z - \bar z}{2}"),
        ("i^2 = -1", "i^2 = 1"),
        (r"(\cos\theta + i\sin\theta)^3 = e^{3 i\theta}", r"(\cos\theta + i\sin\theta)^3 = e^{2 i\theta}"),
    ];
    for (right, wrong) in pairs {
        let found = verdicts(&complex(), &[right, wrong]);
        assert!(matches!(found[0], Certified | Verified), "{right}: {:?}", found[0]);
        assert_eq!(found[1], Refuted, "{wrong}");
    }
    // Over a prime field too.
    let certified = [r"e^{i\theta} = \cos\theta + i\sin\theta", "|z|^2 = z z^*", "i^2 = -1"];
    assert_eq!(verdicts(&complex(), &certified), [Certified; 3]);
    for latex in [r"\sqrt{z} = w", r"\ln z = w", r"z < w"] {
        assert_eq!(verdicts(&complex(), &[latex]), [Unreadable], "{latex}");
    }
}

#[test]
fn cases_are_judged_on_each_branch() {
    let claims = json!({ "constants": { "x": "any", "a": "> 0" } });
    let pairs = [
        (
            r"|x| = \begin{cases} x & x \ge 0 \\ -x & x < 0 \end{cases}",
            r"|x| = \begin{cases} x & x \ge 0 \\ x & x < 0 \end{cases}",
        ),
        (
            r"\sqrt{(x - a)^2} = \begin{cases} x - a & x > a \\ a - x & \text{otherwise} \end{cases}",
            r"\sqrt{(x - a)^2} = \begin{cases} x - a & x > a \\ a + x & \text{otherwise} \end{cases}",
        ),
        (r"\sqrt{x^2} = x \quad \text{for } x > 0", r"\sqrt{x^2} = x \quad \text{for } x < 0"),
        (r"\sqrt{x^2} = -x, \qquad (x < 0)", r"\sqrt{x^2} = -x, \qquad (x > 0)"),
    ];
    for (right, wrong) in pairs {
        let found = verdicts(&claims, &[right, wrong]);
        assert!(matches!(found[0], Certified | Verified), "{right}: {:?}", found[0]);
        assert_eq!(found[1], Refuted, "{wrong}");
    }
}
