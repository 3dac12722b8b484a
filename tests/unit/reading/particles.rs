//! Sums over particles, integrals over continua.

use super::*;

#[test]
fn sums_run_over_the_declared_values() {
    for (latex, words) in [
        (r"\sum_{i=1}^{n} m_i", "Σ_i m_i"),
        (r"\sum_i m_i", "Σ_i m_i"),
        (r"\sum_{a=1}^3 \hat e_a", "Σ_a e\u{302}_a"),
        (r"\sum_{i}^n m_i \vec r_i", "Σ_i m_i·r\u{20d7}_i"),
        (r"\sum_{j \neq i}^{n} \vec F_{ij}", "Σ_j≠i F\u{20d7}_{ij}"),
        (r"\sum_{j\ne i} \vec F_{ij}", "Σ_j≠i F\u{20d7}_{ij}"),
        (r"\sum_{j = 1,\, j \neq i}^n \vec F_{ij}", "Σ_j≠i F\u{20d7}_{ij}"),
        (r"\sum_{i=1}^{n}\sum_{j \neq i}^{n} \vec r_i \times \vec F_{ij}", "Σ_i Σ_j≠i r\u{20d7}_i × F\u{20d7}_{ij}"),
        (r"\sum_{\vec r_i \in V(\vec r)} m_i", "Σ_i∈V m_i"),
        (r"\sum_{i \in V} m_i", "Σ_i∈V m_i"),
    ] {
        assert_eq!(read(latex), words, "{latex}");
    }
    for (latex, place) in [
        (r"\sum m_i", r"\sum"),
        (r"\sum_{k=1}^n m_i", "k"),
        (r"\sum_{i=1}^{3} m_i", "{3}"),
        (r"\sum_{i=1}^{N} m_i", "{N}"),
        (r"\sum_{a=1}^{n} \hat e_a", "{n}"),
        (r"\sum_{a=1}^{2} \hat e_a", "{2}"),
        (r"\sum_{i=0}^{n} m_i", "0"),
        (r"\sum_{i=5}^{n} m_i", "5"),
        (r"\sum_{i=1}^{n-j} m_i", "{n-j}"),
        (r"\sum_{i=1}^{3-1} m_i", "{3-1}"),
        (r"\sum_{i<j}^{n} m_i", "i<j"),
        (r"\sum_{i<a} m_i", "a"),
        (r"\sum_{a<b} v_a \omega_b", "a<b"),
        (r"\sum_i \sum_j \sum_{i<j} \vec F_{ij}", "{i<j}"),
        (r"\sum_{j \neq a} \vec r_j", "a"),
        (r"\sum_{j \neq j} \vec r_j", "j"),
        (r"\sum_{j < i} \vec r_j", "j < i"),
        (r"\sum_{i,i} m_i", "{i,i}"),
        (r"\sum_i \sum_i m_i", "i"),
        (r"\sum_{\vec r_i \in R} m_i", "R"),
        (r"\sum_{\vec r \in V(\vec r)} m_i", r"\vec r"),
        (r"\sum_{i \in V(\vec v)} m_i", r"V(\vec v)"),
        (r"\sum_{i}^n", r"\sum_{i}^n"),
    ] {
        assert_eq!(refused(latex), place, "{latex}");
    }
}

#[test]
fn sums_leave_out_what_they_say() {
    for (latex, words) in [
        (r"\sum_{i=2}^{n} m_i", "Σ_i>1 m_i"),
        (r"\sum_{i=1}^{n-1} m_i", "Σ_i…−1 m_i"),
        (r"\sum_{i=2}^{n-1} m_i", "Σ_i>1…−1 m_i"),
        (r"\sum_i \sum_{j<i} \vec F_{ij}", "Σ_i Σ_j<i F\u{20d7}_{ij}"),
        (r"\sum_i \sum_{j>i}^n \vec F_{ij}", "Σ_i Σ_j>i F\u{20d7}_{ij}"),
        (r"\sum_i \sum_{i<j} \vec F_{ij}", "Σ_i Σ_j>i F\u{20d7}_{ij}"),
        (r"\sum_i \sum_{i \neq j} \vec F_{ij}", "Σ_i Σ_j≠i F\u{20d7}_{ij}"),
        (r"\sum_{i<j} \vec F_{ij}", "Σ_j Σ_i<j F\u{20d7}_{ij}"),
        (r"\sum_{j>i}^n \vec F_{ij}", "Σ_i Σ_j>i F\u{20d7}_{ij}"),
        (r"\sum_{i,j,\, i \neq j} \vec F_{ij}", "Σ_i Σ_j≠i F\u{20d7}_{ij}"),
        (r"\sum_{i,j=1,\, i<j}^{n} \vec F_{ij}", "Σ_i Σ_j>i F\u{20d7}_{ij}"),
    ] {
        assert_eq!(read(latex), words, "{latex}");
    }
}

#[test]
fn a_sum_reaches_to_the_end_of_its_term() {
    for (latex, words) in [
        (r"\sum_{i} \vec r_i \times \vec p_i", "Σ_i r\u{20d7}_i × p\u{20d7}_i"),
        (r"\sum_i \frac12 m_i \vec v_i \cdot \vec v_i", "Σ_i ((1/2)·m_i·v\u{20d7}_i) • v\u{20d7}_i"),
        (
            r"\sum_{i=1}^{n} m_i (\vec v + \vec v_i) \cdot (\vec v - \vec v_i)",
            "Σ_i (m_i·(v\u{20d7} + v\u{20d7}_i)) • (v\u{20d7} − v\u{20d7}_i)",
        ),
        (r"\sum_i m_i \vec r_i + \vec r", "Σ_i m_i·r\u{20d7}_i + r\u{20d7}"),
        (r"\frac{\sum_i m_i \vec r_i}{\sum_i m_i}", "(Σ_i m_i·r\u{20d7}_i)/(Σ_i m_i)"),
        (r"\sum_a \lambda \cdot (\vec\omega \cdot \hat e_a)^2", "Σ_a λ·(ω\u{20d7} • e\u{302}_a)^2"),
    ] {
        assert_eq!(read(latex), words, "{latex}");
    }
    assert_eq!(refused(r"\sum_i \vec r_i + m_i"), "m_i", "a sum ends where its term ends");
}

#[test]
fn a_field_may_carry_its_place() {
    assert_eq!(read(r"\rho(\vec r) M"), "ρ·M");
    assert_eq!(read(r"\rho(\vec{r})"), read(r"\rho"));
    for (latex, place) in [
        (r"\rho(\vec v)", r"\rho(\vec v)"),
        (r"\rho(R)", r"\rho(R)"),
        (r"M(\vec r)", r"M(\vec r)"),
        (r"\rho(\vec r_i)", r"\rho(\vec r_i)"),
    ] {
        assert_eq!(refused(latex), place, "{latex}");
    }
}

#[test]
fn integrals_end_with_the_differential_of_their_continuum() {
    for (latex, words) in [
        (r"\int_V \rho(\vec r)\,\vec r\, d^3r", "∫_V ρ·r\u{20d7}"),
        (r"\int_{V} \rho(\vec{r}) \vec{r} d^{3}r", "∫_V ρ·r\u{20d7}"),
        (r"\int_V \rho(\vec r)\,\mathrm{d}^3 r", "∫_V ρ"),
        (r"\int_A \sigma \vec r d^2 r", "∫_A σ·r\u{20d7}"),
        (r"\int_L \lambda(\vec r) \vec r dr", "∫_L λ·r\u{20d7}"),
        (r"\frac{\int_L \lambda(\vec r)\vec r\, dr}{M}", "(∫_L λ·r\u{20d7})/M"),
        (r"\int_V \rho(\vec{r}) |\vec{r}_{\perp}|^2 d^3r", "∫_V ρ·|r\u{20d7}_⊥|^2"),
        (r"\int_V \int_A \rho \sigma\, d^2r\, d^3r", "∫_V ∫_A ρ·σ"),
        (r"\int_V (\rho + \rho) d^3r\, \vec v", "(∫_V (ρ + ρ))·v\u{20d7}"),
    ] {
        assert_eq!(read(latex), words, "{latex}");
    }
    for (latex, place) in [
        (r"\int_V \rho", r"\int_V"),
        (r"\int \rho\, d^3r", r"\int"),
        (r"\int_0^1 \rho\, d^3r", r"\int_0^1"),
        (r"\int_M \rho\, d^3r", "M"),
        (r"\int_V \rho\, d^2r", "d^2r"),
        (r"\int_V \rho\, dr", "dr"),
        (r"\int_A \sigma\, d^3r", "d^3r"),
        (r"\int_L \lambda\, d^3r", "d^3r"),
        (r"\int_V \rho\, d^3x", "d^3x"),
        (r"\int_V d^3r", r"\int_V d^3r"),
        (r"\int_V \rho + \rho\, d^3r", r"\int_V"),
        (r"\int_V \int_A \rho \sigma\, d^2r", r"\int_V"),
        (r"\int_V \int_A \rho \sigma\, d^3r\, d^2r", "d^2r"),
        (r"\int_V \vec r \vec r d^3 r", r"\vec r"),
    ] {
        assert_eq!(refused(latex), place, "{latex}");
    }
}

#[test]
fn elements_of_volume_of_area_and_of_mass() {
    for (latex, words) in [
        (r"\int_V \rho \vec r\, dV", "∫_V ρ·r\u{20d7}"),
        (r"\int_A \sigma\, dA", "∫_A σ"),
        (r"\int_A \sigma\, \mathrm{d}S", "∫_A σ"),
        (r"\int_V \vec r\, dm", "∫_V ρ·r\u{20d7}"),
        (r"\int_L r^2 dm", "∫_L λ·|r\u{20d7}|^2"),
        (r"\int_A dm", "∫_A σ"),
        (r"\int_V d^3r\, \rho(\vec r) \vec r", "∫_V ρ·r\u{20d7}"),
        (r"\int_V dV \rho \vec r + \vec r", "∫_V ρ·r\u{20d7} + r\u{20d7}"),
        (r"\int_V dm\, \vec r", "∫_V ρ·r\u{20d7}"),
        (r"\int_V d^3r \int_A d^2r\, \rho \sigma", "∫_V ∫_A ρ·σ"),
        (r"\frac1M \int_V dm\, r^2", "(1/M)·(∫_V ρ·|r\u{20d7}|^2)"),
    ] {
        assert_eq!(read(latex), words, "{latex}");
    }
    for (latex, place) in [
        (r"\int_A \sigma\, dV", "dV"),
        (r"\int_V \rho\, dA", "dA"),
        (r"\int_V \rho\, dS", "dS"),
        (r"\int_L \lambda\, dA", "dA"),
        (r"\int_V \rho\, d^3V", "d^3V"),
        (r"\int_V \rho\, d^3m", "d^3m"),
        (r"\int_V dV", r"\int_V dV"),
        (r"\int_V d^2r\, \rho", "d^2r"),
        (r"\int_V dM\, \vec r", "dM"),
    ] {
        assert_eq!(refused(latex), place, "{latex}");
    }
}

#[test]
fn a_continuum_shrinks_to_a_point() {
    let density = r"\lim_{V(\vec{r}) \to 0} \frac{\sum_{\vec{r}_i \in V(\vec{r})} m_i}{V(\vec{r})}";
    assert_eq!(read(density), "lim_{V → 0} (Σ_i∈V m_i)/V");
    assert_eq!(read(r"\lim_{A(\vec r) \rightarrow 0} \frac{M}{A(\vec r)}"), "lim_{A → 0} M/A");
    for (latex, place) in [
        (r"\lim_{V(\vec r) \to 1} M", r"\lim_{V(\vec r) \to 1}"),
        (r"\lim_{M \to 0} M", "M"),
        (r"\lim_{V(\vec v) \to 0} M", r"V(\vec v)"),
        (r"\lim M", r"\lim"),
        (r"\lim_{V \to 0}", r"\lim_{V \to 0}"),
    ] {
        assert_eq!(refused(latex), place, "{latex}");
    }
}
