//! Derivatives that print as differences or labels, and vectors that print as matrices. Beside each stands what is read.

use super::{are_read, are_refused};

#[test]
fn a_laplacian_is_no_difference() {
    are_refused(&[
        "\\frac{\\partial u}{\\partial t} = D \\Delta u",
        "\\partial_t c = \\Delta c + f",
        "-\\Delta u = f",
        "\\Delta\\psi + k^2 \\psi = 0",
        "\\mu\\Delta\\mathbf{v} = \\nabla p",
    ]);
    are_read(&[
        ("\\Delta\\phi = \\phi_2 - \\phi_1", "Δφ = φ_2 − φ_1"),
        ("y = \\cos(\\phi + \\Delta\\phi)", "y = cos(φ + Δφ)"),
        ("\\Delta T = \\frac{\\partial T}{\\partial x} \\Delta x", "ΔT = ∂T/∂x·Δx"),
        ("\\Delta U = Q - W", "ΔU = Q − W"),
    ]);
}

#[test]
fn a_second_difference_is_no_square() {
    are_refused(&["f = a \\Delta^2 y_0", "f = \\frac{\\Delta^{2} y_{0}}{h}"]);
    are_read(&[("E = \\sqrt{\\Delta^2 + b^2}", "E = √(Δ^2 + b^2)"), ("f = \\Delta y^2", "f = Δy^2")]);
}

#[test]
fn a_subscript_that_differentiates_is_no_label() {
    are_refused(&[
        "u_t = u_{xx}",
        "u_t + u u_x = 0",
        "h_t + (u h)_x = 0",
        "\\rho_t + \\nabla\\cdot(\\rho \\mathbf{v}) = 0",
        "w_{xx} + w = 0",
    ]);
    are_read(&[
        ("v_x = v \\cos\\theta, \\quad v_t = 3", "v_x = v·cos(θ) ¦ v_t = 3"),
        ("\\sigma_x \\sigma_t = c", "σ_x·σ_t = c"),
        ("\\sigma_{xx} = \\sigma + p", "σ_{xx} = σ + p"),
        ("W_t = c W_{t-1}", "W_t = c·W_{t-1}"),
    ]);
}

#[test]
fn a_letter_beside_a_cross_is_a_vector() {
    are_read(&[(
        "\\mathbf g = \\mathbf E \\times \\mathbf B, \\quad \\mathsf T = \\mathbf E \\mathbf E",
        "g = E × B ¦ T = E·E",
    )]);
    let inertia =
        "\\mathbf I \\dot{\\boldsymbol\\omega} + \\boldsymbol\\omega \\times \\mathbf I \\boldsymbol\\omega = 0";
    are_read(&[(inertia, "I·ω\u{307} + ω × (I·ω) = 0")]);
    are_refused(&["\\mathbf a \\times \\mathbf b \\times \\mathbf c = 0"]);
}
