//! Blank lines inside a display: between rows they break, elsewhere they are space.

use super::*;

const EULER: [&str; 3] = [
    r"\lambda_1 \dot\omega_1 + (\lambda_3 - \lambda_2) \omega_2 \omega_3 = N_1",
    r"\lambda_2 \dot\omega_2 + (\lambda_1 - \lambda_3) \omega_1 \omega_3 = N_2",
    r"\lambda_3 \dot\omega_3 + (\lambda_2 - \lambda_1) \omega_1 \omega_2 = N_3",
];

#[test]
fn rows_of_a_display() {
    let rows = EULER.join(" \\\\ ");
    for (text, expected) in [
        // Each row its own display, as one number holds them together.
        (format!("$${}$$\n\n$$(4.59)$$\n", EULER.join("$$\n\n$$")), EULER.join("\\\\ ")),
        (format!("$$\n{}\n\n(4.59)\n$$\n", EULER.join("\n\n")), EULER.join("\\\\")),
        (format!("$${}\n\n\\tag{{4.59}}$$\n", EULER.join("\n \n")), EULER.join("\\\\ ")),
        (format!("$${}$$\r\n(4.59)\r\n", EULER.join("\r\n\r\n")), EULER.join("\\\\ ")),
        (format!("$$\n{}\n$$\n(4.59)\n", EULER.join("\n\n\n\n")), EULER.join("\\\\ ")),
        // What is broken already is not broken twice.
        (format!("$${}$$\n(4.59)\n", EULER.join(" \\\\\n\n")), rows.clone()),
        (format!("$${}$$\n(4.59)\n", EULER.join("\n\n\\\\ ")), rows),
    ] {
        let found = md(&text);
        assert_eq!(numbers(&found), ["4.59"], "{text}");
        let squeeze = |text: &str| text.split_whitespace().collect::<String>();
        assert_eq!(squeeze(&found[0].text), squeeze(&expected), "{text}");
    }
    assert_eq!(texts(&tex("$$a = b\n\nc = d$$")), ["a = b\\\\c = d"]);
}

#[test]
fn a_chain_goes_on() {
    let text = "$$\\vec N = \\sum_i \\vec r_i \\times \\vec F_i\n\n= \\vec r \\times \\vec F\n\n\\equiv \\vec N_{orb}$$\n(2.31)\n";
    let found = md(text);
    assert_eq!(
        texts(&found),
        ["\\vec N = \\sum_i \\vec r_i \\times \\vec F_i\\\\= \\vec r \\times \\vec F\\\\\\equiv \\vec N_{orb}"]
    );
    // The place of a row is the place in the file.
    let at = found[0].text.find("\\equiv").unwrap() + found[0].body.start;
    assert!(text[at..].starts_with("\\equiv \\vec N_{orb}"));
}

#[test]
fn elsewhere_they_are_space() {
    for text in [
        "$$\n\na = b\n\n$$",
        "$$\\frac{a\n\n}{b} = c$$",
        "$$\\begin{aligned} a &= b \\\\\n\n c &= d \\end{aligned}$$",
        "$$\\left( a\n\n + b \\right) = c$$",
        // Neither a comment nor a number alone in a line makes it blank.
        "$$a\n% why\n= b$$",
        "$$a = b\n\\tag{1}\n+ c$$",
        "$$a = b\n\n\\tag{1}\n$$",
        "$$a = b\n\n% the end\n$$",
    ] {
        let own = |text: &str| text.matches("\\\\").count();
        assert_eq!(own(&md(text)[0].text), own(text), "{text}");
    }
    // In a quote a line with nothing but its marker is blank; outside of one, it holds a relation.
    assert_eq!(texts(&md("> $$a = b\n>\n> c = d$$\n")), ["a = b\\\\ c = d"]);
    assert_eq!(texts(&md("$$a\n>\nb$$\n")), ["a > b"]);
}

#[test]
fn many() {
    let started = Instant::now();
    assert_eq!(md(&format!("$$a{}b$$", "\n".repeat(1 << 20))).len(), 1);
    assert_eq!(md(&format!("$${}$$", "a\n\n".repeat(1 << 18))).len(), 1);
    assert_eq!(md(&format!("$${}$$", "a".repeat(1 << 20))).len(), 1);
    assert!(started.elapsed() < Duration::from_secs(60));
}
