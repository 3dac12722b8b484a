//! Displays, and the names that they introduce.

use onshell::latex::{Reading, read_display};

use super::*;

fn display(latex: &str, symbols: &mut Symbols) -> Reading {
    read_display(latex, symbols, &Macros::default())
}

/// Each introduced name, with what defines it, in plain words without accents.
fn introduced(latex: &str) -> Vec<String> {
    introduced_with(latex, &mut particles())
}

fn introduced_with(latex: &str, symbols: &mut Symbols) -> Vec<String> {
    let known = symbols.len();
    let reading = display(latex, symbols);
    for statement in &reading.statements {
        if let Err(fault) = statement {
            panic!("{latex} is refused: {} at {}", fault.message, &latex[fault.span.range()]);
        }
    }
    let words = |new: &onshell::latex::DefinedSymbol| {
        assert!(new.symbol.0 >= known);
        let name = &symbols.entry(new.symbol).name;
        format!("{name}: {}", text::formula(&new.formula, symbols)).replace('\u{20d7}', "")
    };
    reading.introduced.iter().map(words).collect()
}

/// Where the statements of a display that are refused are at fault.
fn faults(latex: &str) -> Vec<String> {
    let mut symbols = particles();
    let known = symbols.len();
    let reading = display(latex, &mut symbols);
    assert!(reading.introduced.is_empty(), "{latex}");
    assert_eq!(symbols.len(), known, "{latex}");
    let places = reading.statements.iter().filter_map(|statement| statement.as_ref().err());
    places.map(|fault| latex[fault.span.range()].to_owned()).collect()
}

#[test]
fn a_name_on_the_left_is_introduced() {
    assert_eq!(introduced(r"\vec P_{tot} = \sum_i \vec p_i"), [r"\vec{P}_{tot}: Σ_i p_i"]);
    assert_eq!(
        introduced(r"\vec F_i = \vec F_{(ext)i} + \sum_{j \neq i}^n \vec F_{ij}"),
        [r"\vec{F}_i: F_{(ext)i} + Σ_j≠i F_{ij}"]
    );
    assert_eq!(
        introduced(r"\mathbb{I}_{ab} = \sum_i m_i (|r_i|^2 \delta_{ab} - r_{ia} r_{ib})"),
        [r"\mathbb{I}_{ab}: Σ_i m_i·(|r_i|^2·δ_ab − (r_i)_a·(r_i)_b)"]
    );
    for (latex, place) in [
        (r"\vec Q = \vec p_i", r"\vec Q"),
        (r"\vec Q_j = \vec p_i", r"\vec Q_j"),
        (r"Q_a = R", "Q_a"),
        (r"Q = v_a", "Q"),
        (r"Q_{ab} = v_a v_c", "Q_{ab}"),
        (r"Q_{aa} = v_a v_a", "Q_{aa}"),
        (r"Q = S", "Q"),
        (r"Q > R", "Q"),
        (r"Q \approx R", "Q"),
        (r"M Q = R", "Q"),
        (r"-2 Q = R", "Q"),
        (r"0 Q = R", "Q"),
        (r"2 Q > R", "Q"),
        (r"2 Q_a = R", "2 Q_a"),
        (r"2 \vec Q = \vec r", r"\vec Q"),
        (r"\dot Q = R", r"\dot Q"),
        (r"t = R", "t"),
    ] {
        assert_eq!(faults(latex), [place], "{latex}");
    }
}

/// `2 Q = R` says what Q is; after another factor Q is still unknown, which the test above holds.
#[test]
fn a_multiple_of_a_name_on_the_left_introduces_the_name() {
    assert_eq!(introduced(r"2 Q = R"), ["Q: R/2"]);
    assert_eq!(introduced(r"3 Q = M R + 1"), ["Q: (M·R + 1)/3"]);
}

#[test]
fn a_sum_over_pairs_has_no_free_letter() {
    assert_eq!(introduced(r"\vec Q = \sum_{i<j} \vec F_{ij}"), [r"\vec{Q}: Σ_j Σ_i<j F_{ij}"]);
    assert_eq!(introduced(r"\vec Q_j = \sum_{i} \vec F_{ij}"), [r"\vec{Q}_j: Σ_i F_{ij}"]);
    let pairs = r"\sum_{i<j} \vec F_{ij}";
    assert_eq!(faults(&format!(r"\vec Q_j = {pairs}")), [pairs]);
    assert_eq!(faults(&format!(r"m_i \vec v_i = {pairs}")), [pairs]);
}

#[test]
fn a_family_may_have_more_labels_than_its_definition() {
    assert_eq!(introduced(r"\vec Q_i = M \vec v"), [r"\vec{Q}_i: M·v"]);
    assert_eq!(introduced(r"\vec Q_{ji} = \vec r_j - \vec r_i"), [r"\vec{Q}_{ji}: r_j − r_i"]);
}

#[test]
fn a_name_is_printed_as_what_it_is() {
    assert_eq!(introduced(r"\vec Q \equiv M \vec v"), [r"\vec{Q}: M·v"]);
    assert_eq!(introduced(r"Q \equiv M v"), ["Q: M·|v|"]);
    for (latex, place) in [
        (r"Q \equiv M \vec v", "Q"),
        (r"Q_{tot} = \sum_i \vec p_i", "Q_{tot}"),
        (r"\bar Q = M \vec v", r"\bar Q"),
        (r"M \vec v \equiv Q", "Q"),
        (r"\vec Q \equiv M v", r"\vec Q"),
        (r"\mathbf Q = M", r"\mathbf Q"),
        (r"\vec r + \vec v \equiv \vec A + B", "B"),
    ] {
        assert_eq!(faults(latex), [place], "{latex}");
    }
}

#[test]
fn a_name_at_the_end_of_a_chain_is_introduced() {
    let chain = r"\vec P_{tot} = \sum_i m_i \vec v_i = M \vec v = \vec P_{cm}";
    assert_eq!(introduced(chain), [r"\vec{P}_{tot}: Σ_i m_i·v_i", r"\vec{P}_{cm}: M·v"]);
    let places: Vec<usize> = display(chain, &mut particles()).introduced.iter().map(|new| new.member).collect();
    assert_eq!(places, [0, 3]);
    assert_eq!(introduced(r"\sum_i \vec r_i \times \vec F_{(ext)i} \equiv \vec N"), [r"\vec{N}: Σ_i r_i × F_{(ext)i}"]);
    assert_eq!(faults(r"M < Q"), ["Q"]);
    assert_eq!(faults(r"\sum_i m_i \equiv 2 Q"), ["Q"]);
}

#[test]
fn the_terms_of_a_sum_are_named_one_by_one() {
    let orbit =
        r"\vec L_{tot} = \vec r \times \vec v - \sum_i \vec r_i \times \vec p_i \equiv \vec L_{orb} + \vec L_{spin}";
    assert_eq!(
        introduced(orbit),
        [r"\vec{L}_{tot}: r × v − Σ_i r_i × p_i", r"\vec{L}_{orb}: r × v", r"\vec{L}_{spin}: −Σ_i r_i × p_i"]
    );
    for (latex, place) in [
        (r"\vec r + \vec v \equiv \vec A + \vec B + \vec C", r"\vec A + \vec B + \vec C"),
        (r"\vec r \equiv \vec A + \vec B", r"\vec A"),
        (r"\vec r + \vec v \equiv \vec A - \vec B", r"\vec A"),
        (r"\vec r + \vec v \equiv \vec A + 2\vec B", r"\vec A"),
        (r"\vec r + \vec v \equiv \vec A + \vec A", r"\vec A"),
        (r"\vec r + \vec v = \vec A + \vec B", r"\vec A"),
    ] {
        assert_eq!(faults(latex), [place], "{latex}");
    }
}

#[test]
fn a_symbol_may_be_introduced_by_its_square() {
    let mut symbols = particles();
    assert_eq!(introduced_with(r"\omega_{eff}^2 = \frac{\lambda_1}{M} > 0", &mut symbols), [r"\omega_{eff}: λ_1/M"]);
    assert!(symbols.entry(find(&symbols, r"\omega_{eff}")).squared);
    for (latex, words) in [
        (r"\omega_{eff}^2", "ω_{eff}^2"),
        (r"\omega_{eff}", "√(ω_{eff}^2)"),
        (r"M \omega_{eff}^{2}", "M·ω_{eff}^2"),
        (r"(\omega_{eff}^2)^2", "(ω_{eff}^2)^2"),
        (r"\omega_{eff}^3", "√(ω_{eff}^2)^3"),
        (r"\dot\omega_{eff}", "d/dt(√(ω_{eff}^2))"),
    ] {
        assert_eq!(read_with(latex, &mut symbols), words, "{latex}");
    }
    // Of a higher power it is the root.
    let roots = introduced_with(r"Q^3 = M", &mut particles());
    assert!(matches!(roots.as_slice(), [only] if only.starts_with("Q: ") && only.contains('M')), "{roots:?}");
    assert_eq!(faults(r"Q^{12} = M"), ["Q^{12}"]);
    assert_eq!(faults(r"Q^2 = \vec v"), ["Q^2"]);
    assert_eq!(faults(r"M = Q^2"), ["Q^2"]);
}

#[test]
fn names_may_be_used_before_the_display_says_what_they_are() {
    let mut symbols = particles();
    let reading =
        display(r"\vec Q = \frac1S \sum_{i=1}^n m_i \vec r_i \quad , \quad S = \sum_{i=1}^n m_i", &mut symbols);
    assert!(reading.statements.iter().all(Result::is_ok));
    assert_eq!(reading.statements[1].as_ref().unwrap().members[0].as_plain_symbol(), Some(find(&symbols, "S")));
    let order: Vec<usize> = reading.introduced.iter().map(|new| new.statement).collect();
    assert_eq!(order, [1, 0], "in the order in which they can be known");
    assert!(reading.introduced.windows(2).all(|pair| pair[0].symbol < pair[1].symbol));
    assert_eq!(faults(r"Q = 2 S, \quad S = 2 Q"), ["S", "Q"]);
}

#[test]
fn matrices_are_set_against_entries() {
    let matrix = r"\begin{pmatrix} 1 & 0 & 0 \\ 0 & 2 & 0 \\ 0 & 0 & 3 \end{pmatrix}";
    let entries = "([1, 0, 0; 0, 2, 0; 0, 0, 3])_ab";
    let mut symbols = particles();
    assert_eq!(
        introduced_with(&format!(r"R_{{ab}} = \frac{{1}}{{\sqrt6}} {matrix}"), &mut symbols),
        ["R_{ab}: ((1/√(6))·[1, 0, 0; 0, 2, 0; 0, 0, 3])_ab"]
    );
    assert_eq!(
        introduced_with(&format!(r"\mathbb{{I}}_{{ab}} = {matrix}"), &mut symbols),
        [format!(r"\mathbb{{I}}_{{ab}}: {entries}")]
    );
    assert_eq!(introduced_with(&format!(r"R_{{ab}}\mathbb{{I}}_{{bc}}R^T_{{cd}} = M{matrix}"), &mut symbols), [""; 0]);
    let many = format!(r"\mathbb{{J}}_{{ab}} = \sum_i m_i {matrix} = \sum_i m_i {matrix}");
    assert_eq!(introduced_with(&many, &mut symbols), [r"\mathbb{J}_{ab}: (Σ_i m_i·[1, 0, 0; 0, 2, 0; 0, 0, 3])_ab"]);
    assert_eq!(faults(&format!("Q_a = {matrix}")), ["Q_a"]);
    assert_eq!(faults(&format!("Q_{{ia}} = {matrix}")), ["Q_{ia}"]);
}

#[test]
fn said_for_each_an_introduced_name_has_the_index() {
    let mut symbols = particles();
    symbols.for_each = symbols.index("i");
    assert_eq!(introduced_with(r"\vec L_{orb} = \vec r_i \times \vec p", &mut symbols), [r"\vec{L}_{orbi}: r_i × p_i"]);
    assert_eq!(read_with(r"\vec L_{orb}", &mut symbols), "L\u{20d7}_{orbi}");
}

#[test]
fn vectors_are_proportional() {
    assert_eq!(introduced(r"\vec F_{ij} \propto \vec r_{ij}"), [""; 0]);
    assert_eq!(faults(r"\vec F_{ij} \propto M").len(), 1);
    assert_eq!(faults(r"\vec v < \vec r"), ["<"]);
}

#[test]
fn vectors_differ() {
    assert_eq!(introduced(r"\vec v \neq \vec r"), [""; 0]);
    assert_eq!(introduced(r"\vec v \neq 0, \quad \vec v \neq \vec 0"), [""; 0]);
    assert_eq!(faults(r"\vec v \neq M").len(), 1);
    assert_eq!(faults(r"\delta_{ab} \neq \begin{pmatrix} 1 & 0 & 0 \\ 0 & 1 & 0 \\ 0 & 0 & 2 \end{pmatrix}").len(), 1);
}

#[test]
fn the_spellings_of_a_lecture_are_read() {
    for latex in [
        r"\vec{r_i}",
        r"\dot{\vec{p_i}}",
        r"\vec{F}_{(ext)i}",
        r"\vec{\bar r}_i",
        r"\dot{\vec{\bar r}}_i",
        r"\frac{d\vec v}{dt}",
        r"\frac{d}{dt}\vec{r}_{cm}",
        r"(r_\perp)^2",
        r"\hat{\omega}\cdot\vec v",
        r"\hat e_a",
        r"\sum_{a,b=1}^3 v_a v_b \omega_a \omega_b",
    ] {
        assert!(!read(latex).is_empty());
    }
}
