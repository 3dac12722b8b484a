//! Forms of lecture notes that were read as something else: each stands beside a form that differs little and has another reading.

use super::*;

#[test]
fn an_angle_before_the_time_may_end_the_argument() {
    are_refused(&["x = v\\cos\\theta t", "x = v\\cos\\alpha t", "x = v\\cos\\theta\\Delta t", "x = v\\cos\\psi t"]);
    are_read(&[
        ("x = A\\cos\\omega t", "x = A·cos(ω·t)"),
        ("x = A\\cos\\beta t", "x = A·cos(β·t)"),
        ("x = v\\cos\\theta\\,t", "x = v·cos(θ)·t"),
    ]);
}

#[test]
fn a_difference_stays_one_symbol_after_a_refusal() {
    let found = statements_of("a = \\sin\\omega\\Delta t").unwrap_or_default();
    assert!(!found.contains('Δ') || found.contains("ω·Δt"), "{found}");
}

#[test]
fn whole_numbers_are_factors_of_the_argument() {
    are_read(&[
        ("a = \\cos n\\pi", "a = cos(n·π)"),
        ("a = \\sin n\\pi x", "a = sin(n·π·x)"),
        ("a = \\cos nx\\,dx", "a = cos(n·x)·dx"),
        ("a = \\sin m\\phi", "a = sin(m·φ)"),
        ("a = \\sin n\\pi x/L", "a = sin((n·π·x)/L)"),
        ("a = \\cos 2\\pi t/T", "a = cos((2·π·t)/T)"),
    ]);
    are_refused(&[
        "a = \\cos ax",
        "a = \\cos n\\pi xy",
        "a = \\cos np",
        "a = \\sin n\\pi x/2",
        "a = \\sin 2\\pi x/Lb",
        "a = \\sin\\omega t/T",
        "a = \\cos n\\pi m\\pi",
    ]);
}

#[test]
fn numbers_before_a_display_are_no_part_of_it() {
    for number in ["(1)", "(2.4)", "[3]", "1.", "(a)"] {
        are_read(&[(&format!("{number}\\quad a = b"), "a = b")]);
    }
    are_refused(&["(1)\\; a = b", "(1) a = b"]);
    are_read(&[("(2)(x) = a", "2·x = a"), ("(2) + a = b", "2 + a = b"), ("(x)\\, y = a", "x·y = a")]);
}

#[test]
fn remarks_in_brackets_are_left_out_and_concentrations_are_not() {
    are_read(&[
        ("a = b \\quad [\\text{law of reflection}]", "a = b"),
        ("a = b \\quad [\\text{Snell's law}]\\\\ c = f", "a = b ¦ c = f"),
    ]);
    let found = statements_of("a = k\\,[\\text{NaCl}]").unwrap_or_default();
    assert!(found.is_empty() || found.contains("NaCl"), "{found}");
}

#[test]
fn decibels_are_a_unit() {
    are_read(&[
        ("a = 30\\text{ dB}", "a = 30·dB"),
        ("a = 10\\log_{10} x \\text{ dB}", "a = 10·log_{10}(x)·dB"),
        ("a = 30 \\quad \\text{loud}", "a = 30 ¦ loud"),
    ]);
}

#[test]
fn short_forms_are_no_products() {
    are_refused(&["y = 0.1API", "y = a ROC", "V = a SOC"]);
    are_read(&[
        ("SWR = a", "SWR = a"),
        ("BIL = mg", "B·I·L = m·g"),
        ("PVT = a", "P·V·T = a"),
        ("A = U S V^T U", "A = U·S·V^{T}·U"),
    ]);
}

#[test]
fn j_is_imaginary_before_an_impedance_in_a_sum_and_in_a_phase() {
    are_read(&[
        ("Z = R + jX", "Z = R + i·X"),
        ("V = V_0 e^{-j\\beta z}", "V = V_0·e^(−i·β·z)"),
        ("a = e^{j\\pi/3}", "a = e^((i·π)/3)"),
        ("J = j E", "J = j·E"),
    ]);
    are_refused(&["a = jX", "a = e^{jx}"]);
    let found = statements_of("Z_j = R + jX").unwrap_or_default();
    assert!(!found.contains("i·X"), "{found}");
}

#[test]
fn letters_of_units_after_a_number_are_no_quantities() {
    are_refused(&[
        "a = \\frac{26 mV}{1 mA}",
        "a = 3 mm",
        "R = 26 \\Omega",
        "R = 50\\ \\Omega",
        "R = 10 k\\Omega",
        "c = 3\\times10^8 m/s",
    ]);
    are_read(&[
        ("a = 2\\Omega v", "a = 2·Ω·v"),
        ("a = 2\\Omega", "a = 2·Ω"),
        ("\\rho = 2\\,\\Omega\\,\\mathrm{m}", "ρ = 2·(Ω·m)"),
        ("a = 2mv", "a = 2·m·v"),
    ]);
}

#[test]
fn differentials_behind_several_signs_have_one_order() {
    are_refused(&[
        "M = \\int_0^R\\int_0^\\pi r^2 dr\\sin\\theta d\\theta",
        "V = \\int_0^R\\int_0^\\pi\\int_0^{2\\pi} r^2\\sin\\theta\\,dr\\,d\\theta\\,d\\phi",
        "A = \\int_0^1\\int_0^x f\\,dx\\,dy",
        "M = \\int_0^{2\\pi}\\int_0^\\pi f\\,d\\phi\\,d\\theta",
    ]);
    are_read(&[
        ("A = \\int_0^{2\\pi}\\int_0^R r\\,dr\\,d\\theta", "A = ∫_{0}^{2π}(∫_{0}^{R}(r·dr)·dθ)"),
        ("A = \\int_0^1\\int_0^x f\\,dy\\,dx", "A = ∫_{0}^{1}(∫_{0}^{x}(f·dy)·dx)"),
        ("A = \\int_0^a\\int_0^b f\\,dx\\,dy", "A = ∫_{0}^{a}(∫_{0}^{b}(f·dx)·dy)"),
    ]);
}

#[test]
fn groups_frames_and_lists_are_no_products_and_powers() {
    are_read(&[("x \\in \\mathbb{SE}(2)", "x ∈ SE(2)"), ("k = 2\\pi(a, b)", "k = 2·π·(a, b)")]);
    let found = statements_of("T_i^{i-1} = a").unwrap_or_default();
    assert!(!found.contains("^("), "{found}");
    are_read(&[("x_n^{k-1} = a", "x_n^(k − 1) = a")]);
    are_refused(&["u_{xx} + u_{yy} = 0"]);
}

#[test]
fn primes_beside_dots_and_in_products_of_two_name_quantities() {
    are_read(&[
        ("y' = y + h \\Rightarrow \\ddot y' = a", "y' = y + h ¦ y'̈ = a"),
        ("I\\omega = I'\\omega'", "I·ω = I'·ω'"),
        ("n\\sin\\theta = n'\\sin\\theta'", "n·sin(θ) = n'·sin(θ')"),
    ]);
    are_refused(&["a + T' = \\kappa T", "\\frac{T'}{T} = \\frac{X'}{X}"]);
}

#[test]
fn a_current_is_differentiated() {
    are_read(&[("v = L\\frac{di}{dt} + Ri", "v = L·d/dt(i) + R·i"), ("v = L di/dt + Ri", "v = L·d/dt(i) + R·i")]);
    are_refused(&["v = Ri", "v = L\\frac{dx}{dt} + Ri"]);
}

#[test]
fn fields_at_two_places_are_functions_and_springs_are_not() {
    are_read(&[
        ("F = u(x-b) - u(x+b)", "F = u(x − b) − u(x + b)"),
        ("F = -k(x-b) - k(x+b)", "F = −k·(x − b) − k·(x + b)"),
        ("Z = \\frac{V(-b)}{I(-b)}", "Z = V(−b)/I(−b)"),
    ]);
    are_refused(&["F = u(x-b)", "Z = \\frac{V(-b)}{I(-c)}"]);
}

#[test]
fn resistances_divide_a_voltage() {
    are_read(&[
        ("V_{out} = V_{in}\\left(1 + \\frac{R_2}{R_1}\\right)", "V_{out} = V_{in}·(1 + R_2/R_1)"),
        ("a = v_{be}\\left(\\frac{R}{R + r}\\right)", "a = v_{be}·(R/(R + r))"),
        ("A = x\\left[\\begin{matrix} 0 & 1 \\\\ 1 & 0 \\end{matrix}\\right]", "A = x·[0, 1; 1, 0]"),
    ]);
    are_refused(&["a = V_{in}(1 + x)", "a = V(1 + \\frac{R_2}{R_1})"]);
}

#[test]
fn a_d_before_logarithms_is_a_differential() {
    are_read(&[
        ("\\mathrm{d}\\ln p = \\mathrm{d}\\ln T", "d(ln(p)) = d(ln(T))"),
        ("dS = C d\\ln T", "dS = C·d(ln(T))"),
    ]);
    are_refused(&["a = d\\ln 2"]);
}

#[test]
fn what_holds_for_all_is_a_condition() {
    are_read(&[("\\forall x,\\; f(x) = 0", "f(x) = 0")]);
    are_refused(&["\\forall x"]);
}

#[test]
fn a_variable_in_a_fraction_is_all_of_the_argument() {
    are_refused(&["y = \\sin\\frac{\\pi x}{L}(1 - \\sin\\frac{\\pi x}{L})", "y = \\sin\\frac{\\pi x}{L}(1 - a)"]);
    are_read(&[
        ("y = \\sin\\frac{2\\pi}{\\lambda}(x - ct)", "y = sin(((2·π)/λ)·(x − c·t))"),
        ("y = \\sin\\tfrac12(\\alpha + \\beta)", "y = sin((1/2)·(α + β))"),
        ("x = v\\cos\\theta\\cdot t", "x = v·cos(θ)·t"),
    ]);
    are_refused(&["x = v\\cos\\omega\\cdot t"]);
}

#[test]
fn a_thickness_before_an_integral_is_no_variation() {
    are_refused(&[
        "a = \\int_0^\\delta f\\,dy = \\delta\\int_0^1 f\\,d\\eta",
        "\\frac{a}{\\delta} + \\delta\\int f\\,dt = 0",
    ]);
    are_read(&[("\\delta\\int L\\,dt = 0", "δ(∫(L·dt)) = 0")]);
}

#[test]
fn a_flux_has_primes_and_is_no_derivative() {
    let said = |latex: &str| {
        let mut symbols = Symbols::for_reading();
        read_display(latex, &mut symbols, &Macros::default());
        symbols.inferred.said.join(", ")
    };
    assert!(!said("q''_s = h a").contains("derivative"));
    assert!(said("y'' = h a").contains("derivative"));
}

#[test]
fn i_is_a_current_or_an_angle_beside_what_has_no_imaginary_part() {
    are_read(&[
        ("B = \\frac{\\mu_0 i}{2\\pi r}", "B = (μ_0·i)/(2·π·r)"),
        ("n = \\frac{\\sin i}{\\sin r}", "n = sin(i)/sin(r)"),
        ("a^\\dagger = x - ip", "a^{†} = x − i·p"),
    ]);
    are_refused(&["B = \\frac{\\mu i}{2\\pi r}", "n = \\frac{\\sin ir}{r}", "a = x - ip"]);
}

#[test]
fn a_power_before_a_quotient_is_a_factor() {
    are_read(&[("P = I^2\\left(\\frac{a b}{c}\\right)", "P = I^2·((a·b)/c)")]);
    are_refused(&["P = V^2\\left(\\frac{x}{c}\\right)", "P = I\\left(\\frac{a b}{c}\\right)"]);
    are_read(&[("a = \\frac{b}{(1.6\\times10^{-19})(0.5)}", "a = b/((1.6·10^(−19))·0.5)")]);
    are_refused(&["y = f(x) (3.1)"]);
}

#[test]
fn units_beside_a_result_are_no_statements() {
    are_read(&[
        ("q = h a \\quad \\text{W/m}", "q = h·a"),
        ("a = 174\\,\\text{W/per stream}", "a = 174·W/perstream"),
        ("a = b \\quad \\text{loud}", "a = b ¦ loud"),
    ]);
    are_refused(&["P = \\frac{1}{f(\\text{in m})}"]);
    are_read(&[("P = f(\\text{max})", "P = f(max)")]);
}

#[test]
fn numbers_of_a_flow_have_a_length_below_them() {
    are_read(&[("a = \\sqrt{Re_D} b", "a = √(Re_D)·b")]);
    are_refused(&["a = Re_t b", "a = 2Re b"]);
}

#[test]
fn a_slash_before_a_power_of_ten_may_divide_by_both() {
    are_refused(&[
        "a = 2.8\\times10^{-32}/1.05\\times10^{-34}",
        "a = 3\\times10^8/2\\times10^6",
        "a = b/1.5\\times10^6",
    ]);
    are_read(&[
        ("a = 1/2\\times10^3", "a = (1/2)·10^3"),
        ("a = 2.8\\times10^{-32}/1.05", "a = 2.8·(10^(−32)/1.05)"),
        ("a = 0.5/60\\times4180", "a = (0.5/60)·4180"),
    ]);
}

#[test]
fn a_divergence_before_a_number_is_that_of_its_product_with_a_vector() {
    are_read(&[("\\nabla\\cdot\\rho\\mathbf u = 0", "∇·(ρ·u) = 0")]);
    are_refused(&["\\nabla\\cdot\\mathbf u\\rho = 0", "\\nabla\\rho\\mathbf u = 0", "\\nabla\\cdot\\rho u = 0"]);
}

#[test]
fn a_vector_in_another_frame_makes_all_primes_names() {
    are_read(&[("\\vec p = \\vec p' + M\\vec V, \\quad E = E' + a", "p⃗ = p⃗' + M·V⃗ ¦ E = E' + a")]);
    are_refused(&["y = y' + b"]);
}

#[test]
fn a_logarithm_before_a_slash_or_of_a_power_may_reach_on() {
    are_refused(&[
        "y = \\log a/b",
        "y = 10\\log_{10} P/P_0",
        "y = \\arg z/2",
        "S = -\\sum_i p_i\\log p_i/q_i",
        "y = \\log x^2",
        "y = \\log_2 x^2",
    ]);
    are_read(&[
        ("y = \\log(a)/b", "y = log(a)/b"),
        ("y = \\log\\frac{a}{b}", "y = log(a/b)"),
        ("y = \\log |x|/2", "y = log(|x|)/2"),
        ("y = \\log x/\\log 2", "y = log(x)/log(2)"),
        ("y = \\log 10^3", "y = log(10^3)"),
        ("y = \\log x_2", "y = log(x_2)"),
    ]);
}

#[test]
fn italic_units_in_fractions_and_with_negative_powers_are_no_quantities() {
    are_refused(&[
        "g = 9.8\\frac{m}{s^2}",
        "v = 72\\frac{km}{h}",
        "g = 9.8 m s^{-2}",
        "g = 9.8\\,m\\,s^{-2}",
        "v = 20 km/h",
        "p = 2 atm",
        "h = 6.63\\times10^{-34} J\\cdot s",
        "k = 8.99\\times10^9\\frac{N m^2}{C^2}",
    ]);
    are_read(&[
        ("K = 0.5 m v^2", "K = 0.5·m·v^2"),
        ("a = 2\\frac{m}{s}", "a = 2·(m/s)"),
        ("a = 0.5\\frac{m}{r}", "a = 0.5·(m/r)"),
        ("h = 0.5 L", "h = 0.5·L"),
        ("a = 0.5 C\\cdot V^2", "a = 0.5·C·V^2"),
        ("a = 0.5\\frac{m V^2}{T}", "a = 0.5·((m·V^2)/T)"),
    ]);
}

#[test]
fn an_upright_d_behind_a_space_in_its_braces_is_a_differential() {
    are_read(&[
        ("y = \\int f \\mathrm{~d} x", "y = ∫(f·dx)"),
        ("y = \\int f \\text d \\mu", "y = ∫(f·dμ)"),
        ("\\frac{\\mathrm{d} P}{\\mathrm{~d} r} = -a", "∂P/∂r = −a"),
        ("L = 5 \\mathrm{~m}", "L = 5·m"),
        ("y = \\mathrm{~d} + x", "y = d + x"),
    ]);
}

#[test]
fn numbers_as_in_programs_are_refused() {
    are_refused(&["k = 8.62e-5", "k = 8.62 e\\text{-}5", "k = 8.62\\text{e-5}", "k = 8.62E-5"]);
    are_read(&[("k = 2e - x", "k = 2·e − x"), ("k = -5 + 8.62e", "k = −5 + 8.62·e"), ("F = k\\text{x}", "F = k·x")]);
    are_read(&[("\\text{dU} = Q - p\\text{dV}", "dU = Q − p·dV"), ("a = n\\,\\text{do}", "a = n ¦ do")]);
}

#[test]
fn words_behind_a_comparison_are_no_factor_of_it() {
    are_read(&[
        (
            "v = \\begin{cases} \\mu E & E < E_c \\text{ [low field]} \\\\ u & E \\ge E_c\\end{cases}",
            "v = {μ·E if E<E_{c} lowfield; u if E ≥ E_c}",
        ),
        (
            "v = \\begin{cases} a & x < 1 \\text{ and even} \\\\ b & \\text{otherwise}\\end{cases}",
            "v = {a if x<1 andeven; b otherwise}",
        ),
    ]);
}
