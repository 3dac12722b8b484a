//! Printed numbers, wherever an author puts them.

use super::*;

#[test]
fn by_tag() {
    for text in
        [r"$$a = b \tag{6.73}$$", r"$$a = b \tag{(6.73)}$$", r"$$a = b \tag*{(6.73)}$$", r"$$a = b \eqno(6.73)$$"]
    {
        let found = md(text);
        assert_eq!((numbers(&found), texts(&found)), (vec!["6.73"], vec!["a = b".to_owned()]), "{text}");
    }
}

#[test]
fn a_tag_in_a_comment_is_none() {
    assert_eq!(numbers(&md("$$a = b % \\tag{6.73}\n$$")), [""]);
    assert_eq!(numbers(&tex("$$a = b % \\tag{6.73}\n$$")), [""]);
    assert_eq!(texts(&md("$$a = 5\\% \\tag{6.73}$$")), ["a = 5\\%"]);
}

#[test]
fn two_tags_in_one_display_are_refused() {
    let error = parse(r"$$a = b \tag{1} c = d \tag{2}$$", Kind::Markdown).unwrap_err();
    assert_eq!(pointed(&error), r"\tag{2}");
}

#[test]
fn on_a_line_of_its_own() {
    for text in [
        "$$a = b$$\n (2.1)\n",
        "$$a = b$$\n(2.1)",
        "$$a = b$$\n\n(2.1)  \n",
        "$$a = b$$ (2.1)\n",
        "$$a = b$$\r\n (2.1)\r\n",
    ] {
        let found = md(text);
        assert_eq!((numbers(&found), texts(&found)), (vec!["2.1"], vec!["a = b".to_owned()]), "{text:?}");
    }
}

#[test]
fn a_reference_is_no_number() {
    for text in ["$$a = b$$\n(2.1) shows that", "$$a = b$$\nby (2.1)\n", "$$a = b$$\n(see 2.1)\n", "$$a = b$$\n(x)\n"] {
        assert_eq!(numbers(&md(text)), [""], "{text:?}");
    }
}

#[test]
fn in_a_display_of_its_own() {
    let found = md("$$a = b$$\n\n$$(2.2)$$\n\n$$c = d$$\n");
    assert_eq!((numbers(&found), texts(&found)), (vec!["2.2", ""], vec!["a = b".to_owned(), "c = d".to_owned()]));
    // Without an equation before it, it is still in the list.
    assert_eq!(numbers(&md("prose\n\n$$(2.2)$$\n")), ["2.2"]);
    assert_eq!(numbers(&md("$$a \\tag{1}$$\n\n$$(2.2)$$\n")), ["1", "2.2"]);
}

#[test]
fn at_the_end_inside() {
    let found = md("$$m = 0 (2.8)$$\n\n$$I = m(r)^2 (2.44)$$\n\n$$a = b\\quad(2.9)$$");
    assert_eq!(numbers(&found), ["2.8", "2.44", "2.9"]);
    assert_eq!(texts(&found), ["m = 0", "I = m(r)^2", "a = b\\quad"]);
}

#[test]
fn a_factor_is_no_number() {
    assert_eq!(numbers(&md("$$a = f(2.8)$$\n\n$$b = c (3)$$\n\n$$b = c (x.y)$$")), ["", "", ""]);
    // No other equation is of chapter 9: this is a product.
    let found = md("$$a = b \\tag{2.1}$$\n\n$$w = 2 (9.81)$$");
    assert_eq!(numbers(&found), ["2.1", ""]);
    assert_eq!(squeezed(&found[1]), "w = 2 (9.81)");
}

#[test]
fn a_wide_space_parts_a_number_from_the_formula() {
    let found = md("$$a = b \\qquad (1)$$\n\n$$c = d$$\n\n$$x = y, \\quad(2)$$\n\n$$x = z \\hfill (2a)$$");
    assert_eq!(numbers(&found), ["1", "", "2", "2a"]);
    // A part of longer notes may begin with another number than 1, and tags count too.
    assert_eq!(numbers(&md("$$a = b \\qquad (7)$$\n\n$$c = d \\qquad (8)$$")), ["7", "8"]);
    assert_eq!(numbers(&md("$$a = b \\tag{3}$$\n\n$$c = d \\qquad (4)$$")), ["3", "4"]);
    // One number alone, one out of order, and one without a wide space may be factors.
    assert_eq!(numbers(&md("$$a = b \\qquad (7)$$\n\n$$c = d$$")), ["", ""]);
    assert_eq!(numbers(&md("$$a = b \\qquad (1)$$\n\n$$c = d \\qquad (5)$$")), ["1", ""]);
    assert_eq!(numbers(&md("$$a = b (1)$$\n\n$$c = d (2)$$")), ["", ""]);
}

#[test]
fn after_an_inline_tail() {
    let found = md("$$r = x$$\n , $M = \\int \\lambda$ (2.7)\n\nwhere");
    assert_eq!((numbers(&found), texts(&found)), (vec!["2.7"], vec!["r = x , M = \\int \\lambda".to_owned()]));
    let found = md("$$r_1 = x$$\n , $r_2 = y$, $r_3 = z$ $r_4 = w$ (3.52)\n");
    assert_eq!(texts(&found), ["r_1 = x , r_2 = y , r_3 = z ,r_4 = w"]);
    assert_eq!(numbers(&md("$$r = x$$ ,\n(2.7)\n")), ["2.7"]);
}

#[test]
fn a_tail_without_a_number_is_prose() {
    let found = md("$$r = x$$\n , $M = 1$ as in (2.7)\n");
    assert_eq!((numbers(&found), texts(&found)), (vec![""], vec!["r = x".to_owned()]));
    assert_eq!(numbers(&md("$$r = x$$\n\n , $M = 1$\n\n (2.7)\n")), [""]);
}

#[test]
fn neighbours_share_the_number_printed_after_them() {
    let found = md("$$a = b$$\n\n$$c = d$$\n\n$$e = f$$\n\n$$(4.59)$$\n");
    assert_eq!((numbers(&found), texts(&found)), (vec!["4.59"], vec!["a = b\\\\ c = d\\\\ e = f".to_owned()]));
    assert_eq!(found[0].parts.len(), 3);
    let found = md("$$a = b$$\n\n$$c = d$$\n(6.72)\n");
    assert_eq!((numbers(&found), found[0].parts.len()), (vec!["6.72"], 2));
}

#[test]
fn prose_between_parts_them() {
    let found = md("$$a = b$$\n\nand\n\n$$c = d$$\n(6.72)\n");
    assert_eq!(numbers(&found), ["", "6.72"]);
    // A number inside belongs to its own display.
    assert_eq!(numbers(&md("$$a = b$$\n\n$$c = d \\tag{6.72}$$\n")), ["", "6.72"]);
    assert_eq!(numbers(&md("$$a = b$$\n<!-- x -->\n$$c = d$$\n(6.72)\n")), ["", "6.72"]);
    assert_eq!(numbers(&md("$$a = b$$\n`code`\n$$c = d$$\n(6.72)\n")), ["", "6.72"]);
}

#[test]
fn a_relation_continues() {
    let found = md("$$N = x$$\n\n$$= y$$\n\n$$\\equiv z \\tag{2.31}$$\n\n$$\\Rightarrow w$$");
    assert_eq!(numbers(&found), ["2.31", ""]);
    assert_eq!(squeezed(&found[0]), "N = x\\\\ = y\\\\ \\equiv z");
    assert_eq!(numbers(&md("$$N = x$$\n\n$$\\equality y \\tag{2.31}$$")), ["", "2.31"]);
}

#[test]
fn all_78() {
    // The forms of the notes, in their proportions, with their chapters.
    let mut text = String::new();
    let mut expected = Vec::new();
    for (chapter, range) in [(2, 1..33), (3, 33..57), (4, 57..63), (5, 63..71), (6, 71..79)] {
        for n in range {
            let id = format!("{chapter}.{n}");
            text.push_str("Prose with $x$ and (2.14), at $5.\n\n");
            text.push_str(&match n {
                2 | 59 => format!("$$a$$\n\n$$b$$\n\n$$({id})$$\n"),
                8 | 44 => format!("$$\\frac{{a}}{{b}} = 0 ({id})$$\n"),
                7 | 52 => format!("$$a = b$$\n , $c = d$ ({id})\n"),
                31 | 63 => format!("$$a$$\n\n$$= b$$\n\n$$\\equiv c$$\n({id})\n"),
                _ if n % 3 == 0 => format!("$$a_{{{n}}} = b \\tag{{{id}}}$$\n"),
                _ if n % 3 == 1 => format!("$$a_{{{n}}} = b$$\n ({id})\n"),
                _ => format!("$$a_{{{n}}} = b$$\n({id})\n"),
            });
            text.push('\n');
            expected.push(id);
        }
    }
    let found = md(&text);
    assert_eq!(numbers(&found), expected);
    assert_eq!(found.len(), 78);
}
