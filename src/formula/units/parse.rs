//! The parser of SI units: `kg m^2/s^2`, `N m`, `J s`, `m s^-1`, `1`.
//!
//! Factors are separated by a space, `·` or `*`. A power is written `^2`, `^{-1}`, `^(1/2)` or as a superscript. One
//! factor, or a product in parentheses, may follow a slash. Ambiguous units such as `W/m^2 K` and `m/s/s` are
//! rejected.

use crate::code::Code;
use crate::source::{Fault, Span};
use crate::suggest;

use super::{Dimension, Ratio, SUPERSCRIPTS};

/// A named unit: its symbol, its name, its dimension, and whether it takes prefixes.
struct Unit(&'static str, &'static str, Dimension, bool);

const UNITS: [Unit; 40] = [
    Unit("m", "metre", Dimension::LENGTH, true),
    Unit("g", "gram", Dimension::base(0), true),
    Unit("s", "second", Dimension::TIME, true),
    Unit("A", "ampere", Dimension::base(3), true),
    Unit("K", "kelvin", Dimension::base(4), true),
    Unit("mol", "mole", Dimension::base(5), true),
    Unit("cd", "candela", Dimension::base(6), true),
    Unit("rad", "radian", Dimension::NONE, true),
    Unit("sr", "steradian", Dimension::NONE, false),
    Unit("deg", "degree", Dimension::NONE, false),
    Unit("°", "degree", Dimension::NONE, false),
    Unit("Hz", "hertz", Dimension::of(0, 0, -1), true),
    Unit("Bq", "becquerel", Dimension::of(0, 0, -1), true),
    Unit("N", "newton", Dimension::of(1, 1, -2), true),
    Unit("Pa", "pascal", Dimension::of(1, -1, -2), true),
    Unit("bar", "bar", Dimension::of(1, -1, -2), true),
    Unit("J", "joule", Dimension::of(1, 2, -2), true),
    Unit("eV", "electronvolt", Dimension::of(1, 2, -2), true),
    Unit("W", "watt", Dimension::of(1, 2, -3), true),
    Unit("C", "coulomb", Dimension::with_current(0, 0, 1, 1), true),
    Unit("V", "volt", Dimension::with_current(1, 2, -3, -1), true),
    Unit("F", "farad", Dimension::with_current(-1, -2, 4, 2), true),
    Unit("Ω", "ohm", Dimension::with_current(1, 2, -3, -2), true),
    Unit("Ohm", "ohm", Dimension::with_current(1, 2, -3, -2), true),
    Unit("S", "siemens", Dimension::with_current(-1, -2, 3, 2), true),
    Unit("Wb", "weber", Dimension::with_current(1, 2, -2, -1), true),
    Unit("T", "tesla", Dimension::with_current(1, 0, -2, -1), true),
    Unit("H", "henry", Dimension::with_current(1, 2, -2, -2), true),
    Unit("lm", "lumen", Dimension::base(6), true),
    Unit("Gy", "gray", Dimension::of(0, 2, -2), true),
    Unit("Sv", "sievert", Dimension::of(0, 2, -2), true),
    Unit("L", "litre", Dimension::of(0, 3, 0), true),
    Unit("l", "litre", Dimension::of(0, 3, 0), true),
    Unit("min", "minute", Dimension::TIME, false),
    Unit("h", "hour", Dimension::TIME, false),
    Unit("d", "day", Dimension::TIME, false),
    Unit("yr", "year", Dimension::TIME, false),
    Unit("au", "astronomical unit", Dimension::LENGTH, false),
    Unit("u", "atomic mass unit", Dimension::base(0), false),
    Unit("t", "tonne", Dimension::base(0), false),
];

/// The prefixes. They change the scale only, and are ignored.
const PREFIXES: [&str; 23] = [
    "da", "Y", "Z", "E", "P", "T", "G", "M", "k", "h", "d", "c", "m", "µ", "μ", "u", "n", "p", "f", "a", "z", "y", "Q",
];

/// Reads the dimension of a product of units.
///
/// # Errors
/// [`Code::InvalidUnit`] at the bytes that are no unit, with the unit that was probably meant; [`Code::Ambiguous`]
/// for several units after a slash.
pub fn parse(text: &str) -> Result<Dimension, Fault> {
    let mut parser = Parser { text, at: 0 };
    let found = parser.product()?;
    match parser.peek() {
        None => Ok(found),
        Some(c) => {
            Err(invalid(Span::new(parser.at, parser.at + c.len_utf8()), format!("{c} is not allowed in a unit")))
        }
    }
}

fn invalid(span: Span, message: impl Into<String>) -> Fault {
    Fault::new(span, message).code(Code::InvalidUnit)
}

struct Parser<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Parser<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    /// The next character that is not a space or a multiplication sign.
    fn peek(&mut self) -> Option<char> {
        let rest = self.rest();
        let trimmed = rest.trim_start_matches(|c: char| c.is_whitespace() || matches!(c, '·' | '⋅' | '*'));
        self.at += rest.len() - trimmed.len();
        trimmed.chars().next()
    }

    fn fault(&self, from: usize, message: impl Into<String>) -> Fault {
        invalid(Span::new(from, self.at.max(from)), message)
    }

    /// Factors side by side, and at most one slash.
    fn product(&mut self) -> Result<Dimension, Fault> {
        let mut found = Dimension::NONE;
        let mut divided: Option<usize> = None;
        let start = self.at;
        let mut count = 0;
        loop {
            match self.peek() {
                None | Some(')') if count == 0 => {
                    return Err(self.fault(start, "a unit is missing").help("write 1 for a quantity without a unit"));
                }
                None | Some(')') => return Ok(found),
                Some('/') if count == 0 => {
                    return Err(self.fault(start, "no unit stands before the /").help("write 1 before it, as in 1/s"));
                }
                Some(_) if divided.is_some() => {
                    let from = divided.unwrap_or(start);
                    self.at = self.text.len();
                    let message = format!(
                        "in “{}”, the / may divide by the next unit only, or by all units after it",
                        self.text.trim()
                    );
                    return Err(self
                        .fault(from, message)
                        .code(Code::Ambiguous)
                        .help("use parentheses, J/(kg K), or negative exponents, J kg^-1 K^-1"));
                }
                Some('/') => {
                    divided = Some(self.at);
                    self.at += 1;
                    found = found.times(self.factor()?.power(Ratio::whole(-1)));
                }
                Some(_) => found = found.times(self.factor()?),
            }
            count += 1;
        }
    }

    /// A unit or a product in parentheses, and its power.
    fn factor(&mut self) -> Result<Dimension, Fault> {
        let found = match self.peek() {
            Some('(') => {
                let open = self.at;
                if self.text[..open].matches('(').count() > 8 {
                    return Err(self.fault(open, "a unit has at most 8 pairs of parentheses"));
                }
                self.at += 1;
                let found = self.product()?;
                if self.peek() != Some(')') {
                    return Err(self.fault(open, "this parenthesis is not closed"));
                }
                self.at += 1;
                found
            }
            Some(c) if c.is_ascii_digit() => {
                let from = self.at;
                let digits = self.take(|c| c.is_ascii_digit() || c == '.');
                if digits != "1" {
                    return Err(self
                        .fault(from, format!("a unit cannot contain the number {digits}"))
                        .help("only the dimension is checked; remove the number, or write a power as m^2"));
                }
                Dimension::NONE
            }
            Some(c) if c.is_alphabetic() || c == '°' => {
                let from = self.at;
                let word = self.take(|c| (c.is_alphabetic() || c == '°') && !SUPERSCRIPTS.contains(&c));
                named(word).ok_or_else(|| unknown(word, Span::new(from, self.at), self.rest()))?
            }
            Some(c) => {
                let span = Span::new(self.at, self.at + c.len_utf8());
                return Err(
                    invalid(span, format!("{c} is not allowed in a unit")).help("write a unit as in kg m^2/s^2")
                );
            }
            None => return Err(self.fault(self.at, "a unit is missing").help("write a unit at this place, as in 1/s")),
        };
        Ok(match self.exponent()? {
            Some(exponent) => found.power(exponent),
            None => found,
        })
    }

    fn take(&mut self, belongs: impl Fn(char) -> bool) -> &'a str {
        let rest = self.rest();
        let end = rest.find(|c| !belongs(c)).unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }

    fn exponent(&mut self) -> Result<Option<Ratio>, Fault> {
        let from = self.at;
        let digit = |c: char| SUPERSCRIPTS.iter().position(|known| *known == c);
        let raised = self.take(|c| c == '⁻' || digit(c).is_some());
        let text = if raised.is_empty() {
            let Some(behind) = self.rest().strip_prefix('^') else { return Ok(None) };
            self.at += 1;
            let closing = [('{', '}'), ('(', ')')].into_iter().find(|(open, _)| behind.starts_with(*open));
            match closing {
                Some((_, close)) => {
                    self.at += 1;
                    let inner = self.take(|c| c != close);
                    if self.rest().is_empty() {
                        return Err(self.fault(from, "this exponent is not closed"));
                    }
                    self.at += 1;
                    inner.trim().to_owned()
                }
                None => {
                    let sign = self.take(|c| matches!(c, '-' | '−' | '+'));
                    format!("{sign}{}", self.take(|c| c.is_ascii_digit()))
                }
            }
        } else {
            raised.chars().map(|c| digit(c).map_or("-".to_owned(), |value| value.to_string())).collect()
        };
        let text = text.replace('−', "-");
        let (above, below) = text.split_once('/').unwrap_or((&text, "1"));
        let small = |part: &str| part.trim().parse::<i64>().ok().filter(|value| value.abs() <= 100);
        match (small(above), small(below)) {
            (Some(above), Some(below)) if below != 0 => Ok(Some(Ratio::new(above, below))),
            _ => Err(self
                .fault(from, "an exponent must be a whole number up to 100 or a fraction")
                .help("write exponents as in m^2, s^-1, m^(1/2)")),
        }
    }
}

fn named(word: &str) -> Option<Dimension> {
    let plain = |word: &str| UNITS.iter().find(|unit| unit.0 == word);
    let prefixed = || {
        PREFIXES.iter().find_map(|prefix| word.strip_prefix(prefix).and_then(plain).filter(|Unit(.., takes)| *takes))
    };
    plain(word).or_else(prefixed).map(|unit| unit.2)
}

fn unknown(word: &str, span: Span, behind: &str) -> Fault {
    let fault = invalid(span, format!("{word} is not a unit"));
    let lower = word.to_lowercase();
    let called = UNITS.iter().find(|Unit(_, name, ..)| lower == *name || lower == format!("{name}s"));
    let cased = ["kg", "Hz", "Pa", "mol", "km"].into_iter().find(|known| known.to_lowercase() == lower);
    if let Some(symbol) = called.map(|unit| unit.0).or(cased) {
        return fault.help(format!("write {symbol}"));
    }
    let halves = word.char_indices().skip(1).map(|(at, _)| word.split_at(at));
    // `kgg` is kg with a letter too many: nobody writes two masses in one unit.
    let is_product = |a: &str, b: &str| named(a).zip(named(b)).is_some_and(|(a, b)| a != b);
    if let Some((a, b)) = halves.into_iter().find(|(a, b)| is_product(a, b)) {
        return fault.help(format!("write a space between factors: {a} {b}{behind}"));
    }
    let names = UNITS.iter().flat_map(|Unit(symbol, name, ..)| [*symbol, *name]).chain(["kg", "km", "cm", "mm", "ms"]);
    match suggest::nearest(word, names) {
        Some(near) => {
            let symbol = UNITS.iter().find(|Unit(_, name, ..)| *name == near).map_or(near, |unit| unit.0);
            fault.help(format!("did you mean {symbol}?"))
        }
        None => fault.help("use SI units: kg, m, s, A, K, mol, cd, or derived ones such as N, J, W, Pa, Hz"),
    }
}

#[cfg(test)]
mod tests {
    use super::{Dimension, parse};

    #[test]
    fn units_multiply_and_two_slashes_are_rejected() {
        assert_eq!(parse("N m"), parse("kg m^2/s^2"));
        assert_eq!(parse("J s").unwrap().to_string(), "kg m² s⁻¹");
        assert!(parse("kg m/s/s").is_err());
    }

    fn shown(text: &str) -> String {
        parse(text).unwrap_or_else(|fault| panic!("{text}: {}", fault.message)).to_string()
    }

    #[test]
    fn derived_units_are_products_of_base_units() {
        for (derived, base) in [
            ("N m", "J"),
            ("N m", "kg m^2/s^2"),
            ("Pa", "N/m^2"),
            ("W", "J/s"),
            ("W", "V A"),
            ("V", "J/C"),
            ("C", "A s"),
            ("F", "C/V"),
            ("Ω", "V/A"),
            ("S", "1/Ω"),
            ("Wb", "V s"),
            ("T", "Wb/m^2"),
            ("H", "Wb/A"),
            ("Hz", "s^-1"),
            ("Gy", "J/kg"),
            ("J/(kg K)", "m² s⁻² K⁻¹"),
            ("m·s^{-1}", "m/s"),
            ("m^(1/2) m^{1/2}", "m"),
            ("rad", "1"),
        ] {
            assert_eq!(parse(derived), parse(base), "{derived} and {base}");
        }
        for (one, other) in [("N", "J"), ("kg m/s", "kg m/s^2"), ("m s^-1", "m s"), ("m^(1/2)", "m"), ("rad", "s")] {
            assert_ne!(parse(one), parse(other), "{one} and {other}");
        }
    }

    #[test]
    fn a_prefix_changes_the_scale_alone() {
        for (prefixed, plain) in
            [("km", "m"), ("cm", "m"), ("mm", "m"), ("µm", "m"), ("ms", "s"), ("g", "kg"), ("kN", "N")]
        {
            assert_eq!(parse(prefixed), parse(plain), "{prefixed}");
        }
        // What looks like a prefix and is none: minute, candela, pascal, a power.
        assert_eq!(parse("min"), parse("s"));
        assert_eq!(parse("cd"), Ok(Dimension::base(6)));
        assert!(parse("kkg").is_err() && parse("kmin").is_err());
    }

    #[test]
    fn it_is_printed_as_it_can_be_read() {
        assert_eq!(shown("J s"), "kg m² s⁻¹");
        assert_eq!(shown("1"), "1");
        assert_eq!(shown("K m^-12"), "m⁻¹² K");
        assert_eq!(shown("kg^(1/2)"), "kg^(1/2)");
        for text in ["kg m² s⁻²", "m^(-3/2) A", "mol cd⁻¹"] {
            assert_eq!(shown(text), text);
        }
    }

    #[test]
    fn what_is_no_unit_is_refused_with_what_was_meant() {
        for (text, place, help) in [
            ("Nm", "Nm", "N m"),
            ("kg newtons", "newtons", "N"),
            ("metre/s", "metre", "m"),
            ("Kg", "Kg", "kg"),
            ("9.81 m/s^2", "9.81", "dimension"),
            ("m2", "2", "m^2"),
            ("m/s/s", "/s/s", "may divide by"),
            ("W/m^2 K", "/m^2 K", "may divide by"),
            ("m^x", "^", "m^2"),
            ("m^(1/0)", "^(1/0)", "fraction"),
            ("m^99999999999999999999", "^99999999999999999999", "up to 100"),
            ("(m", "(m", "not closed"),
            ("m)", ")", "not allowed"),
            ("m/", "", "missing"),
            ("", "", "missing"),
            ("x", "x", "SI"),
        ] {
            let fault = parse(text).unwrap_err();
            let said = format!("{} {}", fault.message, fault.help.unwrap_or_default());
            assert!(said.contains(help), "{text}: {said}");
            assert_eq!(&text[fault.span.range()], place, "{text}: {said}");
        }
        assert!(parse(&"(".repeat(1000)).is_err());
    }
}
