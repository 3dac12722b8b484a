//! Constraints with Lagrange multipliers among the coordinates, normal coordinates, and what else authors print beside L.

use serde_json::{Value, json};

use crate::printed_lagrangian::{are, verdicts};
use crate::support::Desk;

fn on_a_sphere() -> Value {
    json!({
        "coordinates": { "r": "> 0", "\\theta": "angle", "\\lambda": "any" },
        "constants": { "m, g, a": "> 0" },
        "means": { "L": "Lagrangian" },
    })
}

const SPHERE: (&str, &str) =
    (r"L = \frac12 m\left(\dot r^2+r^2\dot\theta^2\right) - m g r\cos\theta + \lambda(r-a)", "definition");

#[test]
fn a_multiplier_and_the_motion_follow_from_its_constraint() {
    are(
        "multiplier",
        &on_a_sphere(),
        &[
            SPHERE,
            (r"m\ddot r - m r\dot\theta^2 + m g\cos\theta = \lambda", "passes"),
            (r"r - a = 0", "passes"),
            (r"\ddot\theta = \frac{g}{a}\sin\theta", "passes"),
            (r"\lambda = m g\cos\theta - m a\dot\theta^2", "passes"),
            (r"\dot\lambda = -3 m g\dot\theta\sin\theta", "passes"),
            (r"\ddot\theta = -\frac{g}{a}\sin\theta", "refuted"),
            (r"\lambda = m g\cos\theta + m a\dot\theta^2", "refuted"),
            (r"\dot\lambda = -2 m g\dot\theta\sin\theta", "refuted"),
            (r"m\ddot r - m r\dot\theta^2 + m g\cos\theta = -\lambda", "refuted"),
            (r"r - 2 a = 0", "refuted"),
        ],
    );
}

#[test]
fn two_multipliers_and_a_rolling_hoop() {
    let claims = json!({
        "coordinates": { "x, y, \\lambda, \\mu": "any", "\\theta": "angle" },
        "constants": { "M, g, R": "> 0", "\\phi": "(0.1, 1.4)" },
        "means": { "L": "Lagrangian" },
    });
    let lagrangian = r"L = \frac12 M(\dot x^2 + \dot y^2) + \frac12 M R^2\dot\theta^2 + M g(x\sin\phi - y\cos\phi) + \lambda(R\theta - x) + \mu(y - R)";
    are(
        "hoop",
        &claims,
        &[
            (lagrangian, "definition"),
            (r"\dot x = R\dot\theta", "passes"),
            (r"\ddot x = \frac12 g\sin\phi", "passes"),
            (r"\lambda = \frac12 M g\sin\phi", "passes"),
            (r"\mu = M g\cos\phi", "passes"),
            (r"\ddot x = g\sin\phi", "refuted"),
            (r"\mu = -M g\cos\phi", "refuted"),
        ],
    );
}

#[test]
fn a_coordinate_that_is_no_multiplier_still_has_no_acceleration() {
    // L is quadratic in λ, so ∂L/∂λ = 0 is no constraint on the motion alone.
    let lagrangian = SPHERE.0.replace(r"\lambda(r-a)", r"\lambda^2(r-a)");
    let found = verdicts("no-multiplier", on_a_sphere(), &[&lagrangian, r"\ddot\theta = \frac{g}{a}\sin\theta"]);
    assert_eq!(found[1], "undecided");
}

#[test]
fn a_normal_coordinate_may_have_any_factor_and_a_name_may_have_a_number_before_it() {
    let claims = json!({
        "coordinates": { "x_1, x_2": "any" },
        "constants": { "m, k, \\kappa": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let lagrangian = r"L = \frac12 m(\dot x_1^2+\dot x_2^2) - \frac12 k(x_1^2+x_2^2) - \frac12\kappa(x_1-x_2)^2";
    are(
        "normal",
        &claims,
        &[
            (lagrangian, "definition"),
            (r"\eta = x_1 - x_2", "definition"),
            (r"2\beta = \frac{k + 2\kappa}{m}", "definition"),
            (r"\ddot\eta + 2\beta\eta = 0", "passes"),
            (r"\ddot\eta + \beta\eta = 0", "refuted"),
        ],
    );
    // What is no normal coordinate is not tested by an equation that it does not obey.
    let wrong =
        verdicts("normal-wrong", claims, &[lagrangian, r"\eta = x_1 + 2 x_2", r"\ddot\eta + \frac{k}{m}\eta = 0"]);
    assert_eq!((wrong[1].as_str(), wrong[2].as_str()), ("undecided", "refuted"));
}

#[test]
fn approximations_keep_the_order_that_they_print() {
    let claims = json!({
        "coordinates": { "\\theta": "angle" }, "constants": { "m, g, l": "> 0" }, "means": { "L": "Lagrangian" }
    });
    let pendulum = (r"L = \frac12 m l^2\dot\theta^2 + m g l\cos\theta", "definition");
    are(
        "orders",
        &claims,
        &[
            pendulum,
            (r"\cos\theta \approx 1 - \frac12\theta^2", "passes"),
            (r"L \approx \frac12 m l^2\dot\theta^2 - \frac12 m g l\theta^2 + m g l", "passes"),
        ],
    );
    let slip = verdicts("orders-slip", claims, &[pendulum.0, r"\cos\theta \approx 1 - \frac13\theta^2"]);
    assert_ne!(slip[1], "verified");
}

#[test]
fn a_disc_that_rolls_upright_obeys_constraints_that_cannot_be_integrated() {
    let claims = json!({
        "coordinates": { "x, y, \\lambda, \\mu": "any", "\\theta, \\phi": "angle" },
        "constants": { "m, R, I, J": "> 0" },
        "means": { "L": "Lagrangian" },
        "constraints": {
            "\\lambda": "\\dot x - R\\dot\\theta\\cos\\phi",
            "\\mu": "\\dot y - R\\dot\\theta\\sin\\phi",
        },
    });
    are(
        "disc",
        &claims,
        &[
            (r"L = \frac12 m(\dot x^2 + \dot y^2) + \frac12 I\dot\theta^2 + \frac12 J\dot\phi^2", "definition"),
            (r"m\ddot x = \lambda", "passes"),
            (r"\ddot\theta = 0", "passes"),
            (r"\lambda = -m R\dot\theta\dot\phi\sin\phi", "passes"),
            (r"\mu = m R\dot\theta\dot\phi\cos\phi", "passes"),
            (r"\lambda = m R\dot\theta\dot\phi\sin\phi", "refuted"),
            (r"m\ddot x = -\lambda", "refuted"),
            (r"\ddot x = 0", "refuted"),
        ],
    );
}

#[test]
fn a_constraint_beside_the_lagrangian_leaves_the_derivatives_of_l_as_they_are() {
    let claims = json!({
        "coordinates": { "x, \\lambda": "any", "\\theta": "angle" },
        "constants": { "M, g, R": "> 0", "\\phi": "(0.1, 1.4)" },
        "means": { "L": "Lagrangian" },
        "constraints": { "\\lambda": "x - R\\theta" },
    });
    are(
        "beside",
        &claims,
        &[
            (r"L = \frac12 M\dot x^2 + \frac12 M R^2\dot\theta^2 + M g x\sin\phi", "definition"),
            (r"\frac{d}{dt}\frac{\partial L}{\partial\dot x} - \frac{\partial L}{\partial x} = \lambda", "passes"),
            (r"M R^2\ddot\theta = -\lambda R", "passes"),
            (r"\lambda = -\frac12 M g\sin\phi", "passes"),
            (r"\frac{d}{dt}\frac{\partial L}{\partial\dot x} - \frac{\partial L}{\partial x} = 0", "refuted"),
            (r"\lambda = \frac12 M g\sin\phi", "refuted"),
        ],
    );
}

#[test]
fn a_slip_in_the_lagrangian_is_corrected_there_when_all_other_lines_agree() {
    let claims = json!({
        "coordinates": { "r": "> 0", "\\theta": "angle" },
        "constants": { "M, m, g": "> 0" },
        "means": { "L": "Lagrangian" },
    });
    let document = |name: &str, swing: &str, second: &str| {
        let lagrangian = format!(
            r"L = \frac12 M\dot r^2 + \frac12 m\left(\dot r^2 + r^2\dot\theta^2\right) - M g r {swing} m g r\cos\theta"
        );
        let first = r"(M+m)\ddot r = m r\dot\theta^2 - g(M - m\cos\theta)";
        let desk = Desk::new(&format!("slip-in-l-{name}"));
        desk.write(
            "notes.md",
            format!("$$ {lagrangian} \\tag{{1}} $$\n\n$$ {first} \\tag{{2}} $$\n\n$$ {second} \\tag{{3}} $$\n"),
        );
        let mut claims = claims.clone();
        claims["notes"] = json!("notes.md");
        desk.write("notes.json", format!("{claims:#}"));
        let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
        let report: Value = serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err));
        let equation = |at: usize| report["documents"][0]["equations"][at].clone();
        (equation(1), equation(2))
    };
    let right = r"r\ddot\theta + 2\dot r\dot\theta + g\sin\theta = 0";
    let (first, second) = document("shared", "-", right);
    for equation in [&first, &second] {
        let repair = &equation["repairs"][0];
        assert_eq!((&repair["of"], &repair["replacement"]), (&json!("1"), &json!("+")), "{equation}");
    }
    // One wrong line is corrected where it stands.
    let (first, second) = document("own", "+", &right.replace("+ g", "- g"));
    assert_eq!(first["verdict"], "certified");
    assert_eq!((&second["verdict"], &second["repairs"][0]["of"]), (&json!("refuted"), &Value::Null));
}
