//! What people read in two ways is refused at its place; what has one reading beside it is read.

use super::{read, refused};

#[test]
fn a_number_in_parentheses_is_an_argument() {
    for (latex, place) in [
        ("M(0)", "M(0)"),
        ("R + M(-1)^2", "M(-1)^2"),
        (r"\lambda_1(1.5) R", r"\lambda_1(1.5)"),
        ("M(0, 1)", "M(0, 1)"),
        (r"R(M)^2", "R(M)^2"),
    ] {
        assert_eq!(refused(latex), place, "{latex}");
    }
    // must-fail cases: a sum in parentheses is a factor
    assert_eq!(read("M(R + 1)"), read(r"M \cdot (R + 1)"));
    assert_eq!(read("2(M + R)^2"), read(r"2 \cdot (M + R)^2"));
}

#[test]
fn a_function_without_its_backslash_is_no_product() {
    for (latex, place) in [("sin M", "sin"), ("2 cos^2 M", "cos^2"), (r"R \frac{exp(M)}{2}", "exp")] {
        assert_eq!(refused(latex), place, "{latex}");
    }
    assert!(!read(r"\sin M").is_empty());
}
