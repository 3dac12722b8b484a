//! Notes without a claims file that print a Lagrangian: in a chain after T − V, with its derivatives and momenta.

use crate::support::verdicts;
use crate::unaided::page;

fn last(name: &str, displays: &[&str]) -> String {
    verdicts(&format!("unaided-lagrangians-{name}"), &page(displays)).pop().unwrap_or_default()
}

const OSCILLATOR: &str = r"L = \frac12 m \dot x^2 - \frac12 k x^2";

/// The formula at the end of the chain is that of L, where no display says what T and V are.
#[test]
fn a_lagrangian_may_stand_at_the_end_of_a_chain() {
    for chain in
        [r"L = T - V = \frac12 m \dot x^2 - \frac12 k x^2", r"\mathcal{L} = K - U = \frac12 m \dot x^2 - \frac12 k x^2"]
    {
        let name = chain.split_once(' ').map_or("L", |(name, _)| name);
        let derivative = |value: &str| format!(r"\frac{{\partial {name}}}{{\partial x}} = {value}");
        assert_eq!(
            verdicts("unaided-lagrangians-chain", &page(&[chain, r"m\ddot x = -k x"])),
            ["definition", "certified"]
        );
        assert_eq!(last("chain-slip", &[chain, r"m\ddot x = k x"]), "refuted", "{chain}");
        assert_eq!(last("chain-derivative", &[chain, &derivative("-k x")]), "certified", "{chain}");
        assert_ne!(last("chain-zero", &[chain, &derivative("0")]), "certified", "{chain}");
    }
    // T has a formula, and V has none but this one.
    let given = [r"T = \frac12 m \dot x^2", r"L = T - V = \frac12 m \dot x^2 - \frac12 k x^2"];
    assert_eq!(last("chain-with-T", &[given[0], given[1], r"m\ddot x = -k x"]), "certified");
    assert_eq!(last("chain-with-T-slip", &[given[0], given[1], r"m\ddot x = k x"]), "refuted");
    assert_ne!(last("chain-with-T-zero", &[given[0], given[1], r"\frac{\partial L}{\partial x} = 0"]), "certified");
}

#[test]
fn a_kinetic_energy_in_two_forms_is_the_one_with_the_rates() {
    let notes = |motion: &str| {
        let energies = page(&[r"T = \frac12 m v^2 = \frac12 m l^2\dot\theta^2", r"V = -m g l\cos\theta"]);
        format!("{energies}\nThe Lagrangian is\n{}", page(&["L = T - V", motion]))
    };
    let last = |name: &str, motion: &str| verdicts(name, &notes(motion)).pop().unwrap_or_default();
    assert_eq!(last("unaided-lagrangians-forms", r"m l^2\ddot\theta + m g l\sin\theta = 0"), "certified");
    assert_eq!(last("unaided-lagrangians-forms-slip", r"m l^2\ddot\theta - m g l\sin\theta = 0"), "refuted");
}

/// A derivative of L stands for a formula, so one beside it is no definition.
#[test]
fn a_slip_in_a_derivative_or_a_momentum_of_a_lagrangian_is_found() {
    for (right, wrong) in [
        (r"\frac{\partial L}{\partial x} = -k x", r"\frac{\partial L}{\partial x} = k x"),
        (r"\frac{\partial L}{\partial \dot x} = m\dot x", r"\frac{\partial L}{\partial \dot x} = 2m\dot x"),
        (r"\frac{\partial L}{\partial x} = -k x", r"\frac{\partial L}{\partial x} = -k x^2"),
        (r"p_x = m\dot x", r"p_x = 2m\dot x"),
    ] {
        assert_eq!(last("derivative", &[OSCILLATOR, right]), "certified", "{right}");
        assert_eq!(last("derivative-slip", &[OSCILLATOR, wrong]), "refuted", "{wrong}");
    }
    // It may be a condition.
    assert_eq!(last("condition", &[OSCILLATOR, r"\frac{\partial L}{\partial x} = 0"]), "assumed");
}
