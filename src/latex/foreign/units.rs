//! Numbers with units, as numbers in units of the SI; numbers in degrees.

use crate::source::Span;

/// Units of the SI, each with the power of ten that it is of the coherent unit.
const UNITS: [(&str, i32); 21] = [
    ("m", 0),
    ("g", -3),
    ("s", 0),
    ("A", 0),
    ("K", 0),
    ("mol", 0),
    ("N", 0),
    ("J", 0),
    ("W", 0),
    ("V", 0),
    ("Pa", 0),
    ("Hz", 0),
    ("C", 0),
    ("F", 0),
    ("H", 0),
    ("T", 0),
    ("Ω", 0),
    ("rad", 0),
    ("Nm", 0),
    ("Js", 0),
    ("Ws", 0),
];

/// Prefixes of units, with their powers of ten.
const PREFIXES: [(&str, i32); 9] =
    [("k", 3), ("M", 6), ("G", 9), ("d", -1), ("c", -2), ("m", -3), ("µ", -6), ("n", -9), ("p", -12)];

/// Units of time, each with its power of sixty seconds.
const TIMES: [(&str, i32); 2] = [("min", 1), ("h", 2)];

/// The electronvolt in joules, without its power of ten, and that power.
const ELECTRONVOLT: (&str, i32) = ("1.602176634", -19);

/// What one of a unit is in coherent units: a power of ten, a power of the digits of the electronvolt, and one of the sixty seconds of
/// a minute.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Size {
    ten: i32,
    electronvolts: i32,
    sixties: i32,
}

impl Size {
    fn times(self, other: Size, power: i32) -> Size {
        Size {
            ten: self.ten + power * other.ten,
            electronvolts: self.electronvolts + power * other.electronvolts,
            sixties: self.sixties + power * other.sixties,
        }
    }

    /// The size as a factor after a number.
    pub fn factor(self) -> String {
        let digits = match self.electronvolts {
            0 => String::new(),
            1 => format!(" \\cdot {}", ELECTRONVOLT.0),
            power => format!(" \\cdot {}^{{{power}}}", ELECTRONVOLT.0),
        };
        let ten = if self.ten == 0 { String::new() } else { format!(" \\cdot 10^{{{}}}", self.ten) };
        let sixty = if self.sixties == 0 { String::new() } else { format!(" \\cdot 60^{{{}}}", self.sixties) };
        digits + &sixty + &ten
    }
}

/// The size of a unit, perhaps with a prefix.
fn size_of(word: &str) -> Option<Size> {
    let plain = |word: &str| match word {
        "eV" => Some(Size { ten: ELECTRONVOLT.1, electronvolts: 1, ..Size::default() }),
        _ => UNITS.iter().find(|(unit, _)| *unit == word).map(|(_, ten)| Size { ten: *ten, ..Size::default() }),
    };
    // Nobody writes a prefix before these.
    let of_time = TIMES.iter().find(|(unit, _)| *unit == word);
    if let Some((_, sixties)) = of_time {
        return Some(Size { sixties: *sixties, ..Size::default() });
    }
    plain(word).or_else(|| {
        let with = |(prefix, power): &(&str, i32)| {
            let size = plain(word.strip_prefix(prefix)?)?;
            Some(Size { ten: size.ten + power, ..size })
        };
        PREFIXES.iter().find_map(with)
    })
}

/// The numbers in a text, but for those in a subscript or a power.
pub(super) fn numbers(text: &str) -> Vec<Span> {
    let mut found = Vec::new();
    let bytes = text.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        if !bytes[at].is_ascii_digit() {
            at += 1;
            continue;
        }
        let length = bytes[at..].iter().take_while(|byte| byte.is_ascii_digit() || **byte == b'.').count();
        let before = text[..at].trim_end_matches('{');
        let below = before.trim_end_matches('-').trim_end_matches('{');
        let commands = ["\\frac", "\\dfrac", "\\tfrac", "\\sqrt"];
        let is_argument = before.len() < at && commands.iter().any(|command| before.ends_with(command));
        if let Some(base) = below.strip_suffix('^') {
            // `10^3` and `10^{-3}` end a number.
            if base.ends_with("10") {
                found.push(Span::new(at, at + length + usize::from(text[at + length..].starts_with('}'))));
            }
        } else if !before.ends_with('_') && (!before.ends_with(|c: char| c.is_ascii_alphabetic()) || is_argument) {
            found.push(Span::new(at, at + length));
        }
        at += length;
    }
    found
}

/// The ends of groups of numbers and nothing else, after which a unit may stand: `(9.81 - 3.24)\,\text{m/s}^2`,
/// `\sqrt{2 \cdot 3.24}\,\text{m/s}`.
pub(super) fn groups(text: &str) -> Vec<usize> {
    let opening = |close: usize| {
        let (open, shut) = if text[close..].starts_with(')') { ('(', ')') } else { ('{', '}') };
        let mut depth = 0;
        text[..=close].char_indices().rev().find_map(|(at, c)| {
            depth += i32::from(c == shut) - i32::from(c == open);
            (depth == 0).then_some(at)
        })
    };
    let ends = text.char_indices().filter(|(_, c)| [')', '}'].contains(c)).map(|(at, _)| at);
    let is_numeric = |inside: &str| {
        let commands = ["\\cdot", "\\times", "\\sqrt", "\\frac", "\\left", "\\right"];
        let plain = commands.iter().fold(inside.to_owned(), |text, command| text.replace(command, " "));
        plain.contains(|c: char| c.is_ascii_digit()) && !plain.contains(char::is_alphabetic)
    };
    ends.filter(|close| {
        opening(*close).is_some_and(|open| {
            // A subscript or a power is no number.
            !text[..open].ends_with(['_', '^']) && is_numeric(&text[open + 1..*close])
        })
    })
    .map(|close| close + 1)
    .collect()
}

/// Whether a text prints a number with decimals or with a unit, which somebody measured or computed.
#[cfg(feature = "cli")]
pub(super) fn is_measured(text: &str) -> bool {
    numbers(text).into_iter().any(|number| text[number.range()].contains('.') || units(text, number.end).is_some())
}

/// A number in degrees, as a multiple of π.
pub(super) fn degrees(text: &str, number: Span) -> Option<(Span, String)> {
    let rest = &text[number.end..];
    let mark = ["^\\circ", "^{\\circ}", "\\degree", "°"].iter().find(|mark| rest.starts_with(**mark))?;
    let value = text[number.range()].to_owned();
    Some((Span::new(number.start, number.end + mark.len()), format!("\\frac{{{value} \\pi}}{{180}}")))
}

/// The end of a unit after a number, and its size; `None`, if no unit of the list stands there.
pub(super) fn units(text: &str, from: usize) -> Option<(usize, Size)> {
    let mut at = skipped(text, from);
    let mut size = Size::default();
    let mut sign = 1;
    let mut end = None;
    while let Some((next, more)) = unit(text, at) {
        size = size.times(more, sign);
        end = Some(next);
        let rest = &text[skipped(text, next)..];
        at = text.len() - rest.len();
        if let Some(after) = rest.strip_prefix('/') {
            (sign, at) = (-1, skipped(text, text.len() - after.len()));
        } else if let Some(after) = rest.strip_prefix("\\cdot") {
            at = skipped(text, text.len() - after.len());
        }
    }
    Some((end?, size))
}

/// The end of one unit, with its power, and its size.
fn unit(text: &str, at: usize) -> Option<(usize, Size)> {
    let rest = &text[at..];
    if let Some(inside) = rest.strip_prefix("\\frac{") {
        let (above, length) = braced(inside)?;
        let below = inside[length..].strip_prefix('{')?;
        let (below, more) = braced(below)?;
        let size = whole(above)?.times(whole(below)?, -1);
        return Some((at + "\\frac{".len() + length + 1 + more, size));
    }
    // `\mu\mathrm{F}`
    let micro = ["\\mu", "\\upmu"].iter().find_map(|mu| rest.strip_prefix(*mu));
    let (at, rest) = micro.map_or((at, rest), |after| {
        let at = skipped(text, text.len() - after.len());
        (at, &text[at..])
    });
    let command = ["\\text{", "\\mathrm{", "\\textrm{", "\\mbox{", "\\rm{", "\\unit{"];
    let Some(command) = command.iter().find(|command| rest.starts_with(**command)) else {
        return single_letter(text, at, rest).filter(|_| micro.is_none());
    };
    let (inside, length) = braced(&rest[command.len()..])?;
    let mut end = at + command.len() + length;
    let size = match words(inside) {
        Some(size) if micro.is_some() => Size { ten: size.ten - 6, ..size },
        Some(size) => size,
        // `\text{k}\Omega`
        None => {
            let (_, power) = PREFIXES.iter().find(|(prefix, _)| *prefix == inside.trim())?;
            let ohm = text[skipped(text, end)..].strip_prefix("\\Omega")?;
            end = text.len() - ohm.len();
            Size { ten: *power, ..Size::default() }
        }
    };
    let (exponent, end) = exponent(text, end);
    Some((end, Size::default().times(size, exponent)))
}

/// The same for a unit of one letter without braces: `\mathrm m`.
fn single_letter(text: &str, at: usize, rest: &str) -> Option<(usize, Size)> {
    let after = ["\\mathrm ", "\\rm ", "\\text "].iter().find_map(|command| rest.strip_prefix(*command))?;
    let letter = after.trim_start();
    let size = size_of(letter.get(..1)?)?;
    let end = at + rest.len() - letter.len() + 1;
    let is_word = text[end..].starts_with(|c: char| c.is_ascii_alphabetic()) && rest.starts_with("\\rm");
    let (exponent, end) = exponent(text, end);
    (!is_word).then(|| (end, Size::default().times(size, exponent)))
}

/// The size of a text that is units and nothing else.
fn whole(text: &str) -> Option<Size> {
    if text.trim() == "1" {
        return Some(Size::default());
    }
    let (end, size) = units(text, 0)?;
    text[end..].trim().is_empty().then_some(size)
}

/// The size of the units in a word: `m/s^2`, `kg m`.
pub(super) fn words(text: &str) -> Option<Size> {
    let mut size = Size::default();
    let mut sign = 1;
    let text = text.replace("\\,", " ").replace("\\cdot", " ").replace("\\ ", " ").replace(['~', '·'], " ");
    let text = text.replace("$", "").replace("\\Omega", "Ω").replace("\\mu", "µ").replace('μ', "µ").replace("µ ", "µ");
    let text = text.replace('²', "^2").replace('³', "^3").replace('/', " / ");
    let mut any = false;
    for word in text.split_whitespace() {
        if word == "/" {
            sign = -1;
            continue;
        }
        let (name, exponent) = word.split_once('^').unwrap_or((word, "1"));
        let exponent: i32 = exponent.trim_matches(['{', '}']).parse().ok()?;
        size = size.times(size_of(name)?, sign * exponent.clamp(-9, 9));
        any = true;
    }
    any.then_some(size)
}

/// The exponent that stands at a place, and where it ends; 1, if none does.
fn exponent(text: &str, at: usize) -> (i32, usize) {
    let none = (1, at);
    let Some(rest) = text[at..].strip_prefix('^') else { return none };
    let (digits, length) = match rest.strip_prefix('{') {
        Some(inside) => match braced(inside) {
            Some((digits, length)) => (digits, length + 1),
            None => return none,
        },
        None => match rest.chars().next() {
            Some(c) => (&rest[..c.len_utf8()], c.len_utf8()),
            None => return none,
        },
    };
    digits.trim().parse().map_or(none, |value: i32| (value.clamp(-9, 9), at + 1 + length))
}

/// What stands before the brace that closes, and the length with it.
pub(super) fn braced(text: &str) -> Option<(&str, usize)> {
    let mut depth = 1;
    for (at, c) in text.char_indices() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        if depth == 0 {
            return Some((&text[..at], at + 1));
        }
    }
    None
}

/// The place after spaces.
pub(super) fn skipped(text: &str, from: usize) -> usize {
    let mut rest = &text[from..];
    loop {
        let next = rest.trim_start();
        let next = ["\\,", "\\;", "\\:", "\\ ", "~", "\\!"].iter().find_map(|s| next.strip_prefix(*s)).unwrap_or(next);
        if next.len() == rest.len() {
            return text.len() - rest.len();
        }
        rest = next;
    }
}

#[cfg(test)]
mod tests {
    use crate::latex::Macros;
    use crate::latex::rename::renamed;

    fn plain(text: &str) -> String {
        renamed(text, &Macros::default(), &std::collections::HashMap::new()).text
    }

    #[test]
    fn a_number_with_a_unit_is_its_number_in_units_of_the_si() {
        assert_eq!(plain(r"m = 3\,\text{kg}"), "m = 3");
        assert_eq!(plain(r"g = 9.81\,\frac{\text{m}}{\text{s}^2}"), "g = 9.81");
        assert_eq!(plain(r"g = 9.81\ \mathrm{m\,s^{-2}}"), "g = 9.81");
        assert_eq!(plain(r"l = 30\,\text{cm} + x"), r"l = 30 \cdot 10^{-2} + x");
        assert_eq!(plain(r"C = 3 \cdot 10^{-6}\,\text{F}"), r"C = 3 \cdot 10^{-6}");
        assert_eq!(plain(r"v = 2~\text{km}/\text{s}"), r"v = 2 \cdot 10^{3}");
        assert_eq!(plain(r"\alpha = 60^\circ"), r"\alpha = \frac{60 \pi}{180}");
        assert_eq!(plain(r"R = 2\,\text{k}\Omega, C = 3\,\text{mF}"), r"R = 2 \cdot 10^{3}, C = 3 \cdot 10^{-3}");
        assert_eq!(
            plain(r"C = 5\,\mathrm{\mu F}, R = 5\,\mathrm{M\Omega}"),
            r"C = 5 \cdot 10^{-6}, R = 5 \cdot 10^{6}"
        );
        assert_eq!(plain(r"m = 938\,\text{MeV}"), r"m = 938 \cdot 1.602176634 \cdot 10^{-13}");
        assert_eq!(plain(r"x = 2\,\text{eV}^2/\text{J}"), r"x = 2 \cdot 1.602176634^{2} \cdot 10^{-38}");
        assert_eq!(plain(r"C = 100\,\mu\mathrm{F}"), r"C = 100 \cdot 10^{-6}");
        assert_eq!(plain(r"x = 100\,\mu \, y"), r"x = 100\,\mu \, y");
        assert_eq!(plain(r"3\,\text{kg} \cdot (9.81 - 3.24)\,\text{m/s}^2"), r"3 \cdot (9.81 - 3.24)");
        assert_eq!(
            plain(r"v = \sqrt{2 \cdot 3.24 \cdot 1.5}\,\frac{\text{m}}{\text{s}}"),
            r"v = \sqrt{2 \cdot 3.24 \cdot 1.5}"
        );
        assert_eq!(plain(r"s = \frac{3}{2}\,\text{cm}"), r"s = \frac{3}{2} \cdot 10^{-2}");
        assert_eq!(plain(r"\mu = \frac{3.27\,\text{N}}{17.0\,\text{N}}"), r"\mu = \frac{3.27}{17.0}");
        assert_eq!(plain(r"v = 90\,\text{km/h}"), r"v = 90 \cdot 60^{-2} \cdot 10^{3}");
        assert_eq!(plain(r"t = 5\,\text{min}"), r"t = 5 \cdot 60^{1}");
        assert_eq!(plain(r"v = 4.4\,\frac{\mathrm m}{\mathrm s^2}"), "v = 4.4");
        // The twins: no unit, no number, a subscript.
        for text in
            [r"3\,\text{apples}", r"x = \text{m}", r"T_1 \mathrm{m}", r"3 m", r"T_{1} \mathrm{m}", r"(x) \mathrm{m}"]
        {
            assert_eq!(plain(text), text);
        }
    }
}
