//! Notes without a claims file that state special cases, in sentences and in displays.

use crate::support::verdicts;

fn found(name: &str, notes: &str) -> Vec<String> {
    verdicts(&format!("unaided-special-{name}"), notes)
}

const LENS: &str = r"The focal length of a thin lens is given by

$$ \frac{1}{f} = (n-1)\left(\frac{1}{R_1} - \frac{1}{R_2}\right) $$

For a symmetric lens $R_1 = R$ and $R_2 = -R$, so that

$$ \frac{1}{f} = \frac{2(n-1)}{R} $$
";

const PULLEY: &str = r"The acceleration of the masses is

$$ a = \frac{(m_1 - m_2) g}{m_1 + m_2 + I/R^2} $$

For a massless pulley, $I = 0$, this becomes

$$ a = \frac{(m_1 - m_2) g}{m_1 + m_2} $$
";

#[test]
fn a_case_in_a_sentence_is_a_premise_of_what_follows() {
    assert_eq!(found("lens", LENS)[1], "certified");
    assert_eq!(found("pulley", PULLEY)[1], "certified");
    let wrong = PULLEY.replace(r"{(m_1 - m_2) g}{m_1 + m_2} $$", r"{(m_1 - m_2) g}{m_1 - m_2} $$");
    assert_ne!(wrong, PULLEY);
    assert_eq!(found("pulley-slip", &wrong)[1], "refuted");
    // What fails in the case makes no law wrong.
    for slip in ["(n-1)}{R}", "2(n+1)}{R}"] {
        let wrong = LENS.replace("2(n-1)}{R}", slip);
        let verdicts = found("lens-slip", &wrong);
        assert!(verdicts[0] != "refuted" && !["certified", "verified"].contains(&verdicts[1].as_str()), "{verdicts:?}");
    }
    // At a place other things hold than elsewhere.
    let place =
        PULLEY.replace("For a massless pulley, $I = 0$, this becomes", "At the top $I = 0$. The acceleration is");
    assert_ne!(found("place", &place)[1], "certified");
}

/// After other words, and after a heading, the case holds no more: nothing false follows from it.
#[test]
fn a_case_in_a_display_ends_with_other_words() {
    let collision = |end: &str| {
        format!(
            r"# Elastic collision

$$ m_1 v_1 + m_2 v_2 = p $$

$$ V = \frac{{p}}{{m_1+m_2}} $$

For equal masses,

$$ m_1 = m_2 $$

$$ V = \frac{{v_1+v_2}}{{2}} $$

{end}"
        )
    };
    let false_result = r"$$ V = \frac{m_2 v_1+m_1 v_2}{m_1+m_2} $$";
    assert_eq!(found("in-the-case", &collision(""))[3], "certified");
    for words in ["In general again,", "# Other masses"] {
        let verdicts = found("ended", &collision(&format!("{words}\n\n{false_result}\n")));
        assert!(!["certified", "verified"].contains(&verdicts[4].as_str()), "{words}: {verdicts:?}");
    }
    // In the case itself it is right.
    assert_eq!(found("goes-on", &collision(&format!("so that\n\n{false_result}\n")))[4], "certified");
    let number = r"$$ E_n = n\epsilon $$

$$ n = 1 $$

# Another chapter

$$ E_n = n^3\epsilon $$
";
    assert_ne!(found("number", number)[2], "certified");
}

/// In the ground state n is 1, which the notes do not say: no equation is wrong for want of it.
#[test]
fn names_that_a_case_drops_may_have_a_value_in_it() {
    let atom = |case: &str| {
        format!("$$ L = m v r = n\\hbar $$\n\n$$ r = n^2 a_0 $$\n\n{case}$$ v = \\frac{{\\hbar}}{{m a_0}} $$\n")
    };
    let in_case = found("ground-state", &atom("For the ground state\n\n$$ r = a_0 $$\n\n"));
    assert_eq!(in_case[3], "assumed", "{in_case:?}");
    assert_eq!(found("every-state", &atom("Hence\n\n"))[2], "refuted");
}

/// What the words say of one case is no premise in another one.
#[test]
fn a_relation_of_one_case_does_not_hold_in_another() {
    let circuit = |words: &str| {
        format!(
            "$$ I = \\frac{{U}}{{R}} $$\n\nTwo resistors in series,\n\n$$ R = R_1 + R_2 $$\n\n{words}\n\n\
             $$ I = \\frac{{U}}{{R_1+R_2}} $$\n"
        )
    };
    assert_eq!(found("series", &circuit("Then"))[2], "certified");
    assert_ne!(found("parallel", &circuit("Two in parallel:"))[2], "certified");
    // In a sentence a case may hold for what follows, or at one place alone; so nothing is called wrong beside it.
    let same = LENS
        .replace(r"R_1 = R$ and $R_2 = -R$, so that", r"R_1 = R_2$, so that")
        .replace(r"\frac{2(n-1)}{R}", r"(n-1)\left(\frac{1}{R_2} - \frac{1}{R_1}\right)");
    assert_eq!(found("same", &same)[1], "assumed");
    // Where the words speak of both, and where they cite the relation, it may be used.
    assert_eq!(found("both", &circuit("In parallel it is less than in series, which gives"))[2], "certified");
}

/// The verdict on a display about a case that the sentence before it states by values.
fn stated(name: &str, law: &str, words: &str, result: &str) -> String {
    let notes = format!("$$ {law} $$\n\n{words}\n\n$$ {result} $$\n");
    found(&format!("stated-{name}"), &notes).pop().expect("a verdict")
}

#[test]
fn a_value_in_the_sentence_decides_what_a_law_says_there() {
    let compton = r"\lambda' - \lambda = \frac{h}{mc} (1 - \cos\theta)";
    let film = r"2 n d = \left(m + \frac12\right)\lambda";
    let height = r"p = p_0 e^{-z/H}";
    let gamma = r"\gamma = \frac{1}{\sqrt{1-\beta^2}}";
    let grating = r"a \sin\theta = k \lambda";
    for (law, words, right, wrong) in [
        (
            compton,
            r"Backwards scattering, $\theta = \pi$:",
            r"\lambda' - \lambda = \frac{2h}{mc}",
            r"\lambda' - \lambda = \frac{h}{mc}",
        ),
        (film, "The thinnest bright film ($m = 0$):", r"d = \frac{\lambda}{4n}", r"d = \frac{\lambda}{2n}"),
        (
            grating,
            "The first maximum ($k = 1$) is at",
            r"\sin\theta = \frac{\lambda}{a}",
            r"\sin\theta = \frac{2\lambda}{a}",
        ),
        (height, r"The pressure is $p = \frac12p_0$ at", r"z = H\ln 2", r"z = \frac H2"),
        (gamma, r"At $\beta = \frac35$ we have", r"\gamma = \frac54", r"\gamma = \frac53"),
    ] {
        let passes = stated("right", law, words, right);
        assert!(["certified", "verified"].contains(&passes.as_str()), "{right}: {passes}");
        assert_eq!(stated("wrong", law, words, wrong), "refuted", "{wrong}");
    }
    // A value of what the law does not contain says nothing about it, nor does a sentence before the last one.
    assert_ne!(stated("other", film, "For a thick film ($k = 0$):", r"d = \frac{\lambda}{2n}"), "refuted");
    assert_ne!(stated("before", film, "We had $m = 0$. The next film has", r"d = \frac{3\lambda}{2n}"), "refuted");
    // Another quantity of the case is none of the law.
    assert_ne!(stated("new", height, r"The pressure is $p = \frac12p_0$ at", r"z_1 = \frac H2"), "refuted");
}
