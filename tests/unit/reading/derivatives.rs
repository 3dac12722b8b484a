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
