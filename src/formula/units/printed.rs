//! The units that authors print after a number, each an exact multiple of a product of base units.
//!
//! A formula with units is evaluated with a number for each base unit. The numbers have no simple relation, so that two
//! sides with different units are not equal by chance.

use super::{Dimension, Ratio, parse};

/// A unit with a name.
struct Named {
    /// The symbol, as in `N`.
    symbol: &'static str,
    /// Its name in English; the plural ends with s.
    name: &'static str,
    /// The product of units that has the same dimension, as [`parse`] reads it.
    like: &'static str,
    /// The prefixes that stand before it in print. Those with which it would be a word, as in `as`, are left out.
    prefixes: &'static str,
    /// The digits and the power of ten of its size in units of the SI.
    size: (&'static str, i8),
    /// The relative distance of the other sizes that authors take it for.
    spread: f64,
}

const fn of_size(
    symbol: &'static str,
    name: &'static str,
    like: &'static str,
    prefixes: &'static str,
    size: (&'static str, i8),
) -> Named {
    Named { symbol, name, like, prefixes, size, spread: 0.0 }
}

/// A unit of the SI without a factor.
const fn si(symbol: &'static str, name: &'static str, prefixes: &'static str) -> Named {
    of_size(symbol, name, symbol, prefixes, ("1", 0))
}

/// A unit whose size is measured, or is not the same for all authors.
const fn rough(named: Named, spread: f64) -> Named {
    Named { spread, ..named }
}

/// The size of a degree is π/180.
const DEGREE: &str = "°";

const UNITS: [Named; 54] = [
    si("m", "metre", "kdcmµnpf"),
    of_size("g", "gram", "kg", "kmµn", ("1", -3)),
    si("s", "second", "mµnpf"),
    si("A", "ampere", "kmµnp"),
    si("K", "kelvin", "mµn"),
    si("mol", "mole", "kmµ"),
    si("cd", "candela", "m"),
    si("rad", "radian", "mµ"),
    si("sr", "steradian", ""),
    of_size(DEGREE, "degree", "rad", "", ("1", 0)),
    of_size("%", "percent", "1", "", ("1", -2)),
    si("Hz", "hertz", "kMGTm"),
    si("Bq", "becquerel", "kMG"),
    si("N", "newton", "kMGmµnp"),
    si("Pa", "pascal", "hkMGm"),
    of_size("bar", "bar", "Pa", "m", ("1", 5)),
    of_size("atm", "atmosphere", "Pa", "", ("101325", 0)),
    si("J", "joule", "kMGTmµ"),
    of_size("eV", "electronvolt", "J", "mkMGTP", ("1.602176634", -19)),
    of_size("Wh", "watthour", "J", "kMGT", ("3600", 0)),
    of_size("Ws", "wattsecond", "J", "k", ("1", 0)),
    of_size("Nm", "newtonmetre", "J", "k", ("1", 0)),
    of_size("erg", "erg", "J", "", ("1", -7)),
    rough(of_size("cal", "calorie", "J", "k", ("4.184", 0)), 2e-3),
    si("W", "watt", "kMGTmµn"),
    of_size("Js", "joulesecond", "J s", "", ("1", 0)),
    of_size("Ns", "newtonsecond", "N s", "", ("1", 0)),
    of_size("dyn", "dyne", "N", "", ("1", -5)),
    si("C", "coulomb", "kmµnp"),
    of_size("Ah", "amperehour", "C", "m", ("3600", 0)),
    si("V", "volt", "kMGmµn"),
    si("F", "farad", "mµnpf"),
    si("Ω", "ohm", "kMGmµ"),
    si("S", "siemens", "kmµn"),
    si("Wb", "weber", "mµ"),
    si("T", "tesla", "mµn"),
    si("H", "henry", "mµn"),
    si("lm", "lumen", ""),
    si("Gy", "gray", "mµ"),
    si("Sv", "sievert", "mµ"),
    of_size("L", "litre", "m^3", "mdcµ", ("1", -3)),
    of_size("l", "litre", "m^3", "mdcµ", ("1", -3)),
    of_size("min", "minute", "s", "", ("60", 0)),
    of_size("h", "hour", "s", "", ("3600", 0)),
    of_size("hr", "hour", "s", "", ("3600", 0)),
    of_size("sec", "second", "s", "", ("1", 0)),
    of_size("day", "day", "s", "", ("86400", 0)),
    rough(of_size("yr", "year", "s", "kMG", ("31557600", 0)), 3e-3),
    of_size("au", "astronomical unit", "m", "", ("149597870700", 0)),
    of_size("AU", "astronomical unit", "m", "", ("149597870700", 0)),
    rough(of_size("ly", "lightyear", "m", "kMG", ("9460730472580800", 0)), 3e-3),
    rough(of_size("pc", "parsec", "m", "kMG", ("3.0856775814914", 16)), 1e-9),
    of_size("Å", "angstrom", "m", "", ("1", -10)),
    rough(of_size("u", "dalton", "kg", "", ("1.66053906660", -27)), 1e-8),
];

/// The prefixes: symbol, name, power of ten.
const PREFIXES: [(char, &str, i8); 14] = [
    ('P', "peta", 15),
    ('T', "tera", 12),
    ('G', "giga", 9),
    ('M', "mega", 6),
    ('k', "kilo", 3),
    ('h', "hecto", 2),
    ('d', "deci", -1),
    ('c', "centi", -2),
    ('m', "milli", -3),
    ('µ', "micro", -6),
    ('μ', "micro", -6),
    ('n', "nano", -9),
    ('p', "pico", -12),
    ('f', "femto", -15),
];

/// The numbers that base units have where a formula is evaluated, in the order of [`super::BASE`].
#[cfg(feature = "notes")]
pub const BASE_VALUES: [&str; 7] =
    ["1.3247179572", "0.7548776662", "1.2207440846", "0.8191725134", "1.1673039783", "0.8566748838", "1.1347241384"];

/// A unit as it is printed, with its prefix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit {
    /// The place in the table.
    place: usize,
    /// The prefix, as a place in the table of prefixes.
    prefix: Option<usize>,
}

impl Unit {
    /// The unit that a word is, with a prefix perhaps: `kg`, `µF`, `seconds`.
    pub fn named(word: &str) -> Option<Unit> {
        let plain = |word: &str| UNITS.iter().position(|unit| unit.symbol == word);
        if let Some(place) = plain(word) {
            return Some(Unit { place, prefix: None });
        }
        let prefixed = PREFIXES.iter().enumerate().find_map(|(at, (prefix, ..))| {
            let place = plain(word.strip_prefix(*prefix)?)?;
            let usual = if *prefix == 'μ' { 'µ' } else { *prefix };
            UNITS[place].prefixes.contains(usual).then_some(Unit { place, prefix: Some(at) })
        });
        prefixed.or_else(|| Unit::spelled(word))
    }

    /// The unit with this name in English, perhaps in the plural, with a prefix perhaps: `metre`, `kilometers`, `days`.
    pub fn spelled(word: &str) -> Option<Unit> {
        let plain = |word: &str| {
            let singular = word.strip_suffix('s').filter(|singular| singular.len() > 2).unwrap_or(word);
            let singular = match singular {
                "meter" => "metre",
                "liter" => "litre",
                "gramme" => "gram",
                "hertz" | "hert" => "hertz",
                "celsiu" => return None,
                other => other,
            };
            UNITS.iter().position(|unit| unit.name == singular)
        };
        plain(word).map(|place| Unit { place, prefix: None }).or_else(|| {
            PREFIXES.iter().enumerate().find_map(|(at, (_, name, _))| {
                let place = plain(word.strip_prefix(name)?)?;
                (!UNITS[place].prefixes.is_empty()).then_some(Unit { place, prefix: Some(at) })
            })
        })
    }

    /// The degree of an angle.
    pub fn degree() -> Option<Unit> {
        Unit::named(DEGREE)
    }

    /// The symbol with its prefix.
    pub fn symbol(self) -> String {
        let prefix = self.prefix.map_or_else(String::new, |at| PREFIXES[at].0.to_string());
        format!("{prefix}{}", UNITS[self.place].symbol)
    }

    /// The name in English with its prefix; the symbol of a unit whose name is no word.
    pub fn spelling(self) -> String {
        let unit = &UNITS[self.place];
        let is_word = unit.name.bytes().all(|byte| byte.is_ascii_alphabetic()) && !self.is_sign();
        match (is_word, self.prefix) {
            (true, Some(at)) => format!("{}{}", PREFIXES[at].1, unit.name),
            (true, None) => unit.name.to_owned(),
            _ if unit.symbol == "%" => "\\%".to_owned(),
            _ => self.symbol(),
        }
    }

    /// Whether a size is one of quantum mechanics, where authors leave out c and ħ.
    pub fn is_natural(self) -> bool {
        UNITS[self.place].symbol == "eV"
    }

    /// Whether its symbol is a sign that touches the number: `45°`, `25%`.
    pub fn is_sign(self) -> bool {
        self.is_degree() || UNITS[self.place].symbol == "%"
    }

    /// Whether its letter stands for something else as often: `25 C` is a temperature, and `3 g` an acceleration.
    pub fn is_doubtful(self) -> bool {
        self.prefix.is_none() && ["C", "F", "g"].contains(&UNITS[self.place].symbol)
    }

    /// Whether it is a degree, whose size is π/180.
    pub fn is_degree(self) -> bool {
        UNITS[self.place].symbol == DEGREE
    }

    /// The digits and the power of ten of its size in base units; for a degree without π/180.
    pub fn size(self) -> (&'static str, i8) {
        let (digits, ten) = UNITS[self.place].size;
        (digits, ten + self.prefix.map_or(0, |at| PREFIXES[at].2))
    }

    /// The relative distance of the other sizes that authors take it for.
    pub fn spread(self) -> f64 {
        UNITS[self.place].spread
    }

    /// The dimension.
    pub fn dimension(self) -> Dimension {
        parse(UNITS[self.place].like).unwrap_or(Dimension::NONE)
    }

    /// The exponents of the base units, which are whole numbers.
    pub fn exponents(self) -> [i64; 7] {
        self.dimension().0.map(|exponent: Ratio| exponent.as_whole().unwrap_or(0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_unit_has_a_dimension_and_no_symbol_is_there_twice() {
        for (at, unit) in UNITS.iter().enumerate() {
            assert!(parse(unit.like).is_ok(), "{}", unit.symbol);
            assert!(UNITS[at + 1..].iter().all(|other| other.symbol != unit.symbol), "{}", unit.symbol);
        }
    }

    #[test]
    fn a_prefix_is_a_power_of_ten() {
        for (word, size) in
            [("km", ("1", 3)), ("kg", ("1", 0)), ("µF", ("1", -6)), ("μF", ("1", -6)), ("MeV", ("1.602176634", -13))]
        {
            assert_eq!(Unit::named(word).unwrap().size(), size, "{word}");
        }
        assert_eq!(Unit::named("kilometers"), Unit::named("km"));
        assert_eq!(Unit::named("milliseconds"), Unit::named("ms"));
        assert_eq!(Unit::named("min").unwrap().size(), ("60", 0));
        // The twins: words, and prefixes that nobody prints.
        for word in ["as", "at", "am", "in", "us", "const", "kkg", "Mm", "Gs", "and", "celsius", "kmin", ""] {
            assert_eq!(Unit::named(word), None, "{word}");
        }
    }
}
