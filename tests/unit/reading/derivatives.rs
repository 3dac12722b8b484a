//! What `\frac{d}{dt}` acts on where no parenthesis says it: all that follows, if nothing else can be meant.

use super::*;

#[test]
fn a_derivative_reaches_to_the_end_of_its_term() {
    for (without, with) in [
        (r"\frac{d}{dt} \sum_i m_i \vec v_i", r"\frac{d}{dt}\left(\sum_i m_i \vec v_i\right)"),
        (r"\frac{d}{dt} \int_V \rho \vec r\, d^3r", r"\frac{d}{dt}\left(\int_V \rho \vec r\, d^3r\right)"),
        (r"\frac{d}{dt} \frac12 M \vec v^2", r"\frac{d}{dt}\left(\frac12 M \vec v^2\right)"),
        (r"\frac{d}{dt} M \vec v", r"\frac{d}{dt}(M \vec v)"),
        (r"\frac{d}{dt}\, M R^2 \dot{\vec v}", r"\frac{d}{dt}(M R^2 \dot{\vec v})"),
        (r"\frac{d^2}{dt^2} M \vec r", r"\frac{d^2}{dt^2}(M \vec r)"),
        (r"\frac{d}{dt} M \vec r \times \vec v", r"\frac{d}{dt}(M \vec r \times \vec v)"),
        (r"\frac{d}{dt} \vec v M", r"\frac{d}{dt}(\vec v M)"),
        (r"\frac{d}{dt} \frac{d}{dt} M \vec r", r"\frac{d}{dt}\left(\frac{d}{dt}(M \vec r)\right)"),
    ] {
        assert_eq!(read(without), read(with), "{without}");
        // A sign at the same level ends it.
        assert_eq!(read(&format!("{without} + {with}")), read(&format!("{with} + {with}")), "{without}");
    }
    assert_ne!(read(r"\frac{d}{dt} M \vec v + \vec r"), read(r"\frac{d}{dt}(M \vec v + \vec r)"));
}

#[test]
fn a_derivative_before_several_things_that_vary_is_read_in_two_ways() {
    for (latex, place) in [
        (r"\frac{d}{dt} \vec r \times \vec v", r"\frac{d}{dt} \vec r"),
        (r"\frac{d}{dt} v \vec r", r"\frac{d}{dt} v"),
        (r"\frac{d}{dt} \dot v M v", r"\frac{d}{dt} \dot v"),
        (r"\frac{d}{dt} M / R", r"\frac{d}{dt} M"),
        (r"\frac{d}{dt} \frac{d}{dt} v \vec r", r"\frac{d}{dt} v"),
    ] {
        assert_eq!(refused(latex), place, "{latex}");
    }
    let many = r"\frac{d}{dt}".repeat(9000);
    assert_eq!(refused(&format!("{many} v")), r"\frac{d}{dt}");
}

/// A function with its argument is one factor, however deep the argument is, and a derivative before it has one reading.
#[test]
fn a_derivative_before_one_function_is_that_of_the_function() {
    for (without, with) in [
        (r"\frac{d}{dt} \sin(R)", r"\frac{d}{dt}\left(\sin(R)\right)"),
        (r"\frac{d}{dt} \ln|R|", r"\frac{d}{dt}\left(\ln|R|\right)"),
        (r"\frac{d}{dt} \sin(\sin(\sin(R)))", r"\frac{d}{dt}\left(\sin(\sin(\sin(R)))\right)"),
    ] {
        assert_eq!(read(without), read(with), "{without}");
    }
    for (latex, words) in [
        (r"\frac{d}{dx}\sin x", "cos(x)"),
        (r"\frac{d}{dx}\sin(\sin(\sin(x)))", "cos(sin(sin(x)))·(cos(sin(x))·cos(x))"),
        (r"\frac{d}{dx}\ln|x|", "(1/|x|)·(x/|x|)"),
        (r"\frac{\partial}{\partial x}\exp(2x)", "exp(2·x)·2"),
    ] {
        // A derivative is carried out while it is read, so its text is not read back.
        let mut symbols = Symbols::open();
        let formula = read_formula(latex, &mut symbols, &Macros::default()).expect(latex);
        assert_eq!(text::formula(&formula, &symbols), words, "{latex}");
    }
    assert_eq!(refused(r"\frac{d}{dt} \sin(R) \cos(v)"), r"\frac{d}{dt} \sin");
    for latex in [
        r"\frac{d}{dx}\sin(x) \cos(x)",
        r"\frac{d}{dx}\ln|x| x",
        r"\frac{d}{dx} x \sin(x)",
        r"\frac{d}{dx} \sin(x)/x",
        &r"\frac{d}{dx}".repeat(9000),
        &format!("{} x", r"\frac{d}{dx}".repeat(9000)),
        &format!("{} x", r"\partial_x".repeat(9000)),
    ] {
        refused_with(latex, &mut Symbols::open());
    }
}
