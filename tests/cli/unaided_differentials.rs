//! Notes without a claims file: differentials, chains over several rows, and quantities that are constant.

use serde_json::Value;

use crate::support::Desk;

/// The verdicts on the displays of a page in LaTeX or Markdown.
fn verdicts(name: &str, file: &str, notes: &str) -> Vec<String> {
    let desk = Desk::new(&format!("differentials-{name}"));
    desk.write(file, notes);
    let run = desk.onshell(&["check", file, "--format", "json"]);
    let report: Value = serde_json::from_str(&run.out).unwrap_or_else(|_| panic!("{}{}", run.out, run.err));
    let equations = report["documents"][0]["equations"].as_array().expect("a list");
    equations.iter().map(|equation| equation["verdict"].as_str().unwrap_or_default().to_owned()).collect()
}

#[test]
fn differentials_of_a_relation_follow_from_it() {
    let gas = |differential: &str| {
        format!("For a gas\n\n$$ pV = nRT \\tag{{1}} $$\n\nHence\n\n$$ {differential} \\tag{{2}} $$\n")
    };
    for (name, right) in [
        ("sum", r"p\,dV + V\,dp = nR\,dT"),
        ("upright", r"p\,\mathrm{d}V + V\,\mathrm{d}p = nR\,\mathrm{d}T"),
        ("quotients", r"\frac{dp}{p} + \frac{dV}{V} = \frac{dT}{T}"),
    ] {
        assert!(["certified", "verified"].contains(&verdicts(name, "notes.md", &gas(right))[1].as_str()), "{name}");
    }
    for (name, wrong) in
        [("sign", r"p\,dV - V\,dp = nR\,dT"), ("factor", r"\frac{dp}{p} + 2\frac{dV}{V} = \frac{dT}{T}")]
    {
        assert!(!["certified", "verified"].contains(&verdicts(name, "notes.md", &gas(wrong))[1].as_str()), "{name}");
    }
}

#[test]
fn a_line_element_follows_from_the_coordinates() {
    let element = |formula: &str| {
        format!(
            "$$ x = r\\cos\\theta \\tag{{1}} $$\n\n$$ y = r\\sin\\theta \\tag{{2}} $$\n\nso that\n\n$$ dx^2 + dy^2 = {formula} \\tag{{3}} $$\n"
        )
    };
    assert_eq!(verdicts("element", "notes.md", &element(r"dr^2 + r^2 d\theta^2"))[2], "certified");
    assert_ne!(verdicts("element-slip", "notes.md", &element(r"dr^2 + r\, d\theta^2"))[2], "certified");
}

#[test]
fn what_is_constant_follows_from_a_relation_between_rates() {
    let adiabat = |exponent: &str| {
        format!(
            "Without heat\n\n$$ \\frac{{dT}}{{T}} = -(\\gamma-1)\\frac{{dV}}{{V}} \\tag{{1}} $$\n\nand therefore\n\n\
             $$ T V^{{{exponent}}} = \\text{{const}} \\tag{{2}} $$\n"
        )
    };
    assert_eq!(verdicts("adiabat", "notes.md", &adiabat(r"\gamma-1"))[1], "verified");
    for (name, wrong) in [("sign", r"1-\gamma"), ("power", r"\gamma"), ("sum", r"\gamma+1")] {
        let found = verdicts(&format!("adiabat-{name}"), "notes.md", &adiabat(wrong));
        assert!(["refuted", "undecided"].contains(&found[1].as_str()), "{name}: {found:?}");
    }
}

#[test]
fn a_row_that_begins_with_a_relation_goes_on_from_the_row_before() {
    let rows = |last: &str| {
        format!(
            "The energy is\n\\begin{{align}}\n  U &= \\frac{{3Q}}{{R^3}}\\int_0^R\\left(3-\\frac{{r^2}}{{R^2}}\\right)r^2\\,dr, \\notag\\\\\n    \
             &= \\frac{{3Q}}{{R^3}}\\left[R^3 - \\frac{{R^3}}{{5}}\\right] \\label{{eq:b}}\\\\\n    &= {last}. \\label{{eq:u}}\n\\end{{align}}\n"
        )
    };
    assert_eq!(verdicts("rows", "notes.tex", &rows(r"\frac{12Q}{5}")), ["certified", "certified"]);
    assert_eq!(verdicts("rows-slip", "notes.tex", &rows(r"\frac{12Q}{7}")), ["certified", "refuted"]);
    // The slip is corrected in its own row, and a row may end with what follows from it.
    let slip = rows(r"\frac{12Q}{7}");
    let desk = Desk::new("differentials-own-row");
    desk.write("notes.tex", &slip);
    let report = desk.onshell(&["check", "notes.tex", "--format", "json"]).json();
    let own = slip.find("12Q").expect("the last row");
    for repair in report["documents"][0]["equations"][1]["repairs"].as_array().expect("a list") {
        assert!(repair["start"].as_u64().expect("a place") + 10 >= own as u64, "{repair}");
    }
    let arrow = rows(r"\frac{12Q}{5} \quad\Rightarrow\quad Q = \frac{5U}{12}");
    assert_eq!(verdicts("rows-arrow", "notes.tex", &arrow).len(), 3);
}

/// A derivative of what no formula gives is a quotient of rates along the way.
#[test]
fn a_derivative_of_an_unknown_function_is_a_quotient_of_rates() {
    let beam =
        |shear: &str| format!("For an element of the beam\n\n$$ \\frac{{dM}}{{dx}} = Q $$\n\nHence\n\n$$ {shear} $$\n");
    let found = verdicts("beam", "notes.md", &beam("dM = Q\\,dx"));
    assert!(matches!(found[1].as_str(), "verified" | "certified"), "{found:?}");
    let found = verdicts("beam-slip", "notes.md", &beam("dM = -Q\\,dx"));
    assert!(!matches!(found[1].as_str(), "verified" | "certified"), "{found:?}");
}

#[test]
fn a_derivative_of_a_printed_formula_is_wrong_where_one_slip_separates_it_from_its_value() {
    let desk = Desk::new("unaided-derivatives");
    let verdict = |formula: &str, derivative: &str| {
        desk.write("notes.md", format!("Let\n\n$$ {formula} $$\n\nThen\n\n$$ {derivative} $$\n"));
        let run = desk.onshell(&["check", "notes.md", "--format", "json"]);
        run.json()["documents"][0]["equations"][1]["verdict"].as_str().unwrap_or_default().to_owned()
    };
    let wave = r"y(x) = A \sin(k x)";
    for (formula, right, wrong) in [
        (wave, r"\frac{dy}{dx} = A k \cos(k x)", r"\frac{dy}{dx} = A k \sin(k x)"),
        (wave, r"y'(x) = A k \cos(k x)", r"y'(x) = A k^2 \cos(k x)"),
        (wave, r"\frac{d^2 y}{dx^2} = -A k^2 \sin(k x)", r"\frac{d^2 y}{dx^2} = -A k \sin(k x)"),
        (
            r"N(t) = N_0 e^{-\gamma t}",
            r"\frac{dN}{dt} = -\gamma N_0 e^{-\gamma t}",
            r"\frac{dN}{dt} = \gamma N_0 e^{-\gamma t}",
        ),
        (r"V(r) = \frac{a}{r^2}", r"\partial_r V = -\frac{2 a}{r^3}", r"\partial_r V = -\frac{2 a}{r^2}"),
    ] {
        assert_eq!(verdict(formula, right), "certified", "{right}");
        assert_eq!(verdict(formula, wrong), "refuted", "{wrong}");
    }
    // what no slip separates from the derivative is something else
    assert_eq!(verdict(wave, r"\frac{dy}{dx} = B + C x"), "assumed");
}
