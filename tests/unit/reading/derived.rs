//! Names that are understood without a declaration, and those that are put together.

use super::*;

#[test]
fn a_declared_vector_gives_its_norm_its_direction_and_its_components() {
    for (latex, words) in [
        (r"r_i", "|r\u{20d7}_i|"),
        (r"|r_i|^2", "|r\u{20d7}_i|^2"),
        (r"r_2^2", "|r\u{20d7}_2|^2"),
        (r"\omega", "|ω\u{20d7}|"),
        (r"\dot\omega", "d/dt(|ω\u{20d7}|)"),
        (r"r_\perp", "|r\u{20d7}_⊥|"),
        (r"(r_\perp)^2", "|r\u{20d7}_⊥|^2"),
        (r"\bar r_i", "|r\u{304}\u{20d7}_i|"),
        (r"\hat r_i", "r\u{20d7}_i/|r\u{20d7}_i|"),
        (r"\hat\omega \cdot \vec v", "(ω\u{20d7}/|ω\u{20d7}|) • v\u{20d7}"),
        (r"\sum_i m_i r_{ia} r_{ib}", "Σ_i m_i·(r\u{20d7}_i)_a·(r\u{20d7}_i)_b"),
        (r"\dot v_a", "d/dt((v\u{20d7})_a)"),
        (r"(\vec\omega \times \vec v)_a", "(ω\u{20d7} × v\u{20d7})_a"),
        (r"(\vec\omega \times \vec v)_1", "(ω\u{20d7} × v\u{20d7})_1"),
        (r"\vec 0", "[0; 0; 0]"),
        (r"M \vec{0} - M \mathbf 0", "M·[0; 0; 0] − M·[0; 0; 0]"),
    ] {
        assert_eq!(read(latex), words, "{latex}");
    }
    for (latex, place) in [
        (r"r_k", "r_k"),
        (r"r_{i\perp}", r"r_{i\perp}"),
        (r"\omega_1", r"\omega_1"),
        (r"\omega_4", r"\omega_4"),
        (r"\hat \omega_1", r"\hat \omega_1"),
        (r"\hat q", r"\hat q"),
        (r"\hat M", r"\hat M"),
        (r"q_a", "q_a"),
        (r"m_{ia}", "m_{ia}"),
        (r"(M)_a", "a"),
        (r"(\vec v)_i", "i"),
        (r"\vec 1", r"\vec 1"),
        (r"\vec v + 0_a", "a"),
        (r"v(R)", "v(R)"),
    ] {
        assert_eq!(refused(latex), place, "{latex}");
    }
}

#[test]
fn a_length_is_not_crossed_with_a_vector() {
    for (lost, place) in [
        (r"r_i \times \vec v", "r_i"),
        (r"\vec r_i \times m_i v", "v"),
        (r"\vec r_i \times \dot r_i", r"\dot r_i"),
        (r"M v \times \vec r_i", "v"),
    ] {
        assert_eq!(refused(lost), place, "{lost}");
    }
    for plain in
        [r"2 \times \vec v", r"M \times \vec v", r"r_i \times v", r"r_i \cdot \vec v", r"r_i \hat r_i \times \vec v"]
    {
        assert!(!read(plain).is_empty(), "{plain}");
    }
}

#[test]
fn a_declared_name_comes_first() {
    let mut symbols = particles();
    add(&mut symbols, "r_i", Kind::Scalar);
    add(&mut symbols, r"\omega_a", Kind::Scalar);
    assert_eq!(read_with("r_i + \\omega_1", &mut symbols), "r_i + ω_1");
    assert!(symbols.derived.is_empty());
    assert_eq!(read_with(r"v", &mut symbols), "|v\u{20d7}|");
    assert_eq!(symbols.derived.iter().collect::<Vec<_>>(), [(&"v".to_owned(), &"|v\u{20d7}|".to_owned())]);
}

#[test]
fn components_are_taken_along_what_was_declared() {
    let mut symbols = particles();
    let (omega, axes) = (find(&symbols, r"\vec\omega"), find(&symbols, r"\hat e_a"));
    symbols.entry_mut(omega).components = Some(Components::Along(axes));
    assert_eq!(read_with(r"\omega_a", &mut symbols), "ω\u{20d7} • e\u{302}_a");
    assert_eq!(read_with(r"\dot\omega_3", &mut symbols), "d/dt(ω\u{20d7} • e\u{302}_3)");
    assert_eq!(refused_with(r"(\vec\omega)_a", &mut symbols), r"(\vec\omega)_a", "along which axes?");
    symbols.entry_mut(omega).components = Some(Components::Fixed);
    assert_eq!(read_with(r"\omega_1 \omega_2", &mut symbols), "(ω\u{20d7})_1·(ω\u{20d7})_2");
    assert_eq!(refused_with(r"\omega_4", &mut symbols), r"\omega_4");
    assert_eq!(read_with("v_1", &mut symbols), "|v\u{20d7}_1|", "of the first particle");
    let v = find(&symbols, r"\vec v");
    symbols.entry_mut(v).components = Some(Components::Fixed);
    assert_eq!(refused_with("v_1", &mut symbols), "v_1", "or the first component of another vector");
}

#[test]
fn vectors_in_bold_have_norms_too() {
    let mut symbols = Symbols::new();
    add(&mut symbols, r"\mathbf{q}", Kind::Vector);
    add(&mut symbols, r"\mathbf{R}", Kind::Matrix(3, 3));
    assert_eq!(read_with(r"q^2 - \hat q \cdot \hat{\mathbf q}", &mut symbols), "|q|^2 − (q/|q|) • (q/|q|)");
    assert_eq!(refused_with("R", &mut symbols), "R", "a matrix has no norm here");
}

#[test]
fn a_name_may_be_declared_with_its_dots() {
    let mut symbols = particles();
    let rate = onshell::latex::name_search::parse_decorated(r"\dot{\vec v}").unwrap();
    symbols.add(rate, Kind::Vector).unwrap();
    let (rate, v) = (r"\dot{\vec v}", r"\frac{d \vec v}{dt}");
    let read = |latex: &str, symbols: &mut Symbols| read_formula(latex, symbols, &Macros::default()).unwrap();
    assert_ne!(read(rate, &mut symbols), read(v, &mut symbols));
    assert_eq!(read_with(&format!("{v} - {rate}"), &mut symbols), "d/dt(v\u{20d7}) − v\u{20d7}\u{307}");
    assert_eq!(refused_with(r"\ddot{\vec v}", &mut symbols), r"\ddot{\vec v}");
    assert_eq!(read_with(r"\ddot{\vec r}", &mut symbols), "r\u{20d7}\u{308}");
    assert_eq!(
        onshell::latex::name_search::parse_decorated(r"\hat e_a"),
        names::parse(r"\hat e_a").map(|(name, _)| name)
    );
}

#[test]
fn a_family_is_put_together_from_all_its_members() {
    let mut symbols = particles();
    assert_eq!(read_with(r"\sum_{a=1}^3 \lambda_a \dot\lambda_a", &mut symbols), "Σ_a λ_a·λ\u{307}_a");
    let family = find(&symbols, r"\lambda_a");
    let members = [r"\lambda_1", r"\lambda_2", r"\lambda_3"].map(|name| find(&symbols, name));
    assert_eq!(symbols.entry(family).members, members);
    let known = symbols.len();
    assert_eq!(read_with(r"\sum_b \lambda_b", &mut symbols), "Σ_b λ_b");
    assert_eq!(symbols.len(), known, "once");
    add(&mut symbols, "I_1", Kind::Scalar);
    add(&mut symbols, "I_2", Kind::Scalar);
    assert_eq!(refused_with(r"\sum_a I_a", &mut symbols), "I_a", "one is missing");
    add(&mut symbols, "I_3", Kind::Vector);
    assert_eq!(refused_with(r"\sum_a I_a", &mut symbols), "I_a", "one is of another kind");
    for at in 1..=4 {
        add(&mut symbols, &format!("M_{at}"), Kind::Scalar);
    }
    assert_eq!(refused_with(r"\sum_i M_i", &mut symbols), "M_i", "there are n of them, not four");
}

#[test]
fn labels_of_a_fixed_number_of_things_make_families_too() {
    let mut symbols = Symbols::new();
    symbols.add_label("i", 2, None);
    add(&mut symbols, r"\vec r_1", Kind::Vector);
    add(&mut symbols, r"\vec r_2", Kind::Vector);
    assert_eq!(read_with(r"\sum_{i=1}^2 \vec r_i", &mut symbols), "Σ_i r\u{20d7}_i");
    assert_eq!(read_with(r"\sum_i r_i", &mut symbols), "Σ_i |r\u{20d7}_i|");
}

#[test]
fn a_name_without_its_index_stands_for_each() {
    let mut symbols = particles();
    assert_eq!(refused_with(r"\vec p", &mut symbols), r"\vec p");
    symbols.for_each = symbols.index("i");
    let both = "r\u{20d7}_i × p\u{20d7}_i";
    assert_eq!(read_with(r"\vec r \times \vec p", &mut symbols), both, "of each, though r alone is declared too");
    assert_eq!(read_with("m p", &mut symbols), "m_i·|p\u{20d7}_i|");
}

#[test]
fn a_letter_inside_of_a_word_is_no_index() {
    let symbols = particles();
    let slots = |latex: &str| symbols.entry(find(&symbols, latex)).slots.len();
    assert_eq!(slots(r"\vec r_{cm}"), 0);
    assert_eq!(slots(r"\vec F_{(ext)i}"), 1);
    assert_eq!(slots(r"\vec F_{ij}"), 2);
    let all = |subscript: &str| {
        let (name, _) = names::parse(&format!("x_{{{subscript}}}")).unwrap();
        symbols.slots(&name.subscript).into_iter().map(|(at, _)| at).collect::<Vec<_>>()
    };
    assert!(all("orb").is_empty());
    assert!(all("spin").is_empty());
    assert_eq!(all("1i"), [1]);
    assert_eq!(all("Ai"), [1]);
    assert_eq!(all(r"i\perp"), [0]);
    assert_eq!(all("a(0)"), [0]);
    assert_eq!(all("ab"), [0, 1]);
}
