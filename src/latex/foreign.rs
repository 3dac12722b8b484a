//! What people write by hand that is read only here, since there it has one sense: a function of a parenthesis with a power,
//! `\sin(x)^2`; functions of other languages; a number with a unit, `3\,\text{kg}`, or in degrees; a decimal comma; and words
//! between statements.

use crate::source::Span;

/// The functions as other languages write them.
const FUNCTIONS: [(&str, &str); 14] = [
    ("\\operatorname{sen}", "\\sin"),
    ("\\operatorname{sin}", "\\sin"),
    ("\\operatorname{cos}", "\\cos"),
    ("\\operatorname{tg}", "\\tan"),
    ("\\operatorname{tan}", "\\tan"),
    ("\\operatorname{ctg}", "\\cot"),
    ("\\operatorname{arctg}", "\\arctan"),
    ("\\operatorname{arcsen}", "\\arcsin"),
    ("\\mathrm{sen}", "\\sin"),
    ("\\mathrm{sin}", "\\sin"),
    ("\\mathrm{cos}", "\\cos"),
    ("\\mathrm{tg}", "\\tan"),
    ("\\mathrm{arctg}", "\\arctan"),
    ("\\mathrm{sh}", "\\sinh"),
];

/// The functions whose power may stand after the parenthesis.
const POWERED: [&str; 6] = ["\\sin", "\\cos", "\\tan", "\\cot", "\\sinh", "\\cosh"];

/// Units, and the power of ten that each is of the unit of the SI.
const UNITS: [(&str, i32); 34] = [
    ("kg", 0),
    ("m", 0),
    ("s", 0),
    ("N", 0),
    ("J", 0),
    ("W", 0),
    ("V", 0),
    ("A", 0),
    ("K", 0),
    ("Pa", 0),
    ("Hz", 0),
    ("C", 0),
    ("F", 0),
    ("H", 0),
    ("T", 0),
    ("mol", 0),
    ("rad", 0),
    ("Nm", 0),
    ("Js", 0),
    ("cm", -2),
    ("mm", -3),
    ("km", 3),
    ("dm", -1),
    ("nm", -9),
    ("g", -3),
    ("mg", -6),
    ("ms", -3),
    ("kN", 3),
    ("kJ", 3),
    ("kW", 3),
    ("kPa", 3),
    ("mA", -3),
    ("MW", 6),
    ("MJ", 6),
];

/// The edits of a text that make what is written by hand readable, in no order.
pub(super) fn edits(text: &str) -> Vec<(Span, String)> {
    let mut edits = Vec::new();
    let is_subscript = |at: usize| text[..at].trim_end_matches('{').ends_with('_');
    for (foreign, own) in FUNCTIONS {
        let found = text.match_indices(foreign).filter(|(at, _)| !is_subscript(*at));
        edits.extend(found.map(|(at, _)| (Span::new(at, at + foreign.len()), own.to_owned())));
    }
    for function in POWERED {
        edits.extend(
            text.match_indices(function).filter_map(|(at, _)| power_moved(text, at + function.len())).flatten(),
        );
        edits.extend(text.match_indices(function).filter_map(|(at, _)| divided(text, at + function.len())).flatten());
    }
    edits.extend(numbers(text).into_iter().filter_map(|number| {
        degrees(text, number).or_else(|| {
            let (end, power) = units(text, number.end)?;
            let factor = if power == 0 { String::new() } else { format!(" \\cdot 10^{{{power}}}") };
            Some((Span::new(number.end, end), factor))
        })
    }));
    edits
}

/// A text of the same length, in which decimal commas are points, and words between statements are spaces.
pub fn separated(text: &str) -> String {
    let mut new = text.to_owned();
    while let Some(at) = new.match_indices("{,}").map(|(at, _)| at).find(|at| between_digits(&new, *at, 3)) {
        let end = at + 3 + new[at + 3..].bytes().take_while(u8::is_ascii_digit).count();
        let digits = new[at + 3..end].to_owned();
        new.replace_range(at..end, &format!(".{digits}  "));
    }
    // A zero before the comma begins no list.
    let commas: Vec<usize> = new.match_indices(',').map(|(at, _)| at).collect();
    for at in commas {
        if !between_digits(&new, at, 1) {
            continue;
        }
        let whole = new[..at].trim_end_matches(|c: char| c.is_ascii_digit()).len();
        let is_in_list = new[..whole].ends_with(['(', '[', '{', ',']);
        if !is_in_list {
            new.replace_range(at..=at, ".");
        }
    }
    for command in ["\\text{", "\\mbox{", "\\textrm{"] {
        let places: Vec<usize> = text.match_indices(command).map(|(at, _)| at).collect();
        for at in places {
            let Some(length) = text[at + command.len()..].find('}') else { continue };
            let end = at + command.len() + length + 1;
            let words = &text[at + command.len()..end - 1];
            if !words.contains(['$', '\\', '{']) && is_between_statements(text, (at, end), words) {
                new.replace_range(at..end, &format!("\\quad{}", " ".repeat(end - at - "\\quad".len())));
            }
        }
    }
    debug_assert_eq!(new.len(), text.len());
    new
}

/// Whether words stand between statements: there are several, and no sign that binds them is beside them.
fn is_between_statements(text: &str, (start, end): (usize, usize), words: &str) -> bool {
    const KNOWN: [&str; 14] = [
        "const", "is ", "and", "or", "if", "for", "when", "whenever", "provided", "with", "where", "const.", "so that",
        "all",
    ];
    let words = words.trim();
    let known = |known: &&str| words == known.trim() || words.starts_with(*known) && (*known == "is ");
    let count = words.split_whitespace().filter(|word| word.chars().any(char::is_alphabetic)).count();
    let spaces = ["\\quad", "\\qquad", "\\,", "\\;", "\\ ", "~", "&"];
    let (mut before, mut after) = (text[..start].trim_end(), text[end..].trim_start());
    let mut is_apart = false;
    while let Some(space) = spaces.iter().find(|space| before.ends_with(**space)) {
        before = before[..before.len() - space.len()].trim_end();
        is_apart = true;
    }
    while let Some(space) = spaces.iter().find(|space| after.starts_with(**space)) {
        after = after[space.len()..].trim_start();
    }
    let binds = |c: char| "=+-*/^_<>({[|".contains(c);
    let is_bound = before.ends_with(binds) || after.starts_with(|c: char| "=+-*/^_<>)}]|(".contains(c));
    let is_first = before.is_empty() || before.ends_with([',', ';', '.', '&']) || before.ends_with("\\\\");
    !words.is_empty()
        && !KNOWN.iter().any(known)
        && !is_bound
        && (count > 1 || is_apart || is_first)
        && words.chars().filter(|c| c.is_alphabetic()).count() > 2
}

fn between_digits(text: &str, at: usize, length: usize) -> bool {
    let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    digit(text[..at].chars().next_back()) && digit(text[at + length..].chars().next())
}

/// The edits that enclose the argument of a function which is divided by a parenthesis or by another function:
/// `\sin\alpha/(M+m)`. Nobody means the sine of that quotient. `from` is the end of the function.
fn divided(text: &str, from: usize) -> Option<[(Span, String); 2]> {
    let skip = |at: usize| at + text[at..].len() - text[at..].trim_start().len();
    let mut start = skip(from);
    if text[start..].starts_with('^') {
        let power = &text[start + 1..];
        let length = match power.starts_with('{') {
            true => power.find('}')? + 1,
            false => power.chars().next().filter(char::is_ascii_digit)?.len_utf8(),
        };
        start = skip(start + 1 + length);
    }
    let argument = text[start..].strip_prefix('\\').unwrap_or(&text[start..]);
    let is_command = argument.len() < text[start..].len();
    let letters = argument.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(argument.len());
    let length = if is_command { 1 + letters } else { letters.min(1) };
    let end = start + length;
    let after = text[skip(end)..].strip_prefix('/')?.trim_start();
    let is_enclosed = ["(", "\\left(", "\\sin", "\\cos", "\\tan"].iter().any(|below| after.starts_with(below));
    (letters > 0 && is_enclosed)
        .then(|| [(Span::new(start, start), "(".to_owned()), (Span::new(end, end), ")".to_owned())])
}

/// The edits that put the power after a parenthesis, `(x)^2`, before it; `from` is the end of the function.
fn power_moved(text: &str, from: usize) -> Option<[(Span, String); 2]> {
    let skipped = from + text[from..].len() - text[from..].trim_start().len();
    let rest = &text[skipped..];
    let rest_start = skipped + if rest.starts_with("\\left(") { "\\left".len() } else { 0 };
    if !text[rest_start..].starts_with('(') {
        return None;
    }
    let mut depth = 0i32;
    let mut close = None;
    for (at, c) in text[rest_start..].char_indices() {
        depth += i32::from(c == '(') - i32::from(c == ')');
        if depth == 0 {
            close = Some(rest_start + at + 1);
            break;
        }
    }
    let after = &text[close?..];
    let start = close? + after.len() - after.trim_start().len();
    let power = text[start..].strip_prefix('^')?;
    let length = match power.starts_with('{') {
        true => power.find('}')? + 1,
        false => power.chars().next().filter(char::is_ascii_digit)?.len_utf8(),
    };
    let span = Span::new(start, start + 1 + length);
    Some([(Span::new(from, from), text[span.range()].to_owned()), (span, String::new())])
}

/// The numbers in a text, but for those in a subscript or a power.
fn numbers(text: &str) -> Vec<Span> {
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
        if !before.ends_with(['_', '^']) && !before.ends_with(|c: char| c.is_ascii_alphabetic()) {
            found.push(Span::new(at, at + length));
        } else if before.ends_with('^') && before.trim_end_matches(['^', '-']).ends_with("10") {
            // `10^3` and `10^{-3}` end a number.
            found.push(Span::new(at, at + length + usize::from(text[at + length..].starts_with('}'))));
        }
        at += length;
    }
    found
}

/// A number in degrees, as a multiple of π.
fn degrees(text: &str, number: Span) -> Option<(Span, String)> {
    let rest = &text[number.end..];
    let mark = ["^\\circ", "^{\\circ}", "\\degree", "°"].iter().find(|mark| rest.starts_with(**mark))?;
    let value = text[number.range()].to_owned();
    Some((Span::new(number.start, number.end + mark.len()), format!("\\frac{{{value} \\pi}}{{180}}")))
}

/// The end of a unit after a number, and its power of ten; `None`, if no unit of the list stands there.
fn units(text: &str, from: usize) -> Option<(usize, i32)> {
    let mut at = skipped(text, from);
    let mut power = 0;
    let mut sign = 1;
    let mut end = None;
    while let Some((next, more)) = unit(text, at) {
        power += sign * more;
        end = Some(next);
        let rest = &text[skipped(text, next)..];
        at = text.len() - rest.len();
        if let Some(after) = rest.strip_prefix('/') {
            (sign, at) = (-1, skipped(text, text.len() - after.len()));
        } else if let Some(after) = rest.strip_prefix("\\cdot") {
            at = skipped(text, text.len() - after.len());
        }
    }
    Some((end?, power))
}

/// The end of one unit, with its power, and the power of ten.
fn unit(text: &str, at: usize) -> Option<(usize, i32)> {
    let rest = &text[at..];
    if let Some(inside) = rest.strip_prefix("\\frac{") {
        let (above, length) = braced(inside)?;
        let below = inside[length..].strip_prefix('{')?;
        let (below, more) = braced(below)?;
        let power = whole(above)? - whole(below)?;
        return Some((at + "\\frac{".len() + length + 1 + more, power));
    }
    let command = ["\\text{", "\\mathrm{", "\\textrm{", "\\mbox{", "\\rm{", "\\unit{"];
    let command = command.iter().find(|command| rest.starts_with(**command))?;
    let (inside, length) = braced(&rest[command.len()..])?;
    let power = words(inside)?;
    let end = at + command.len() + length;
    let (exponent, end) = exponent(text, end);
    Some((end, power * exponent))
}

/// The power of ten of a text that is units and nothing else.
fn whole(text: &str) -> Option<i32> {
    if text.trim() == "1" {
        return Some(0);
    }
    let (end, power) = units(text, 0)?;
    text[end..].trim().is_empty().then_some(power)
}

/// The power of ten of the units in a word: `m/s^2`, `kg m`.
fn words(text: &str) -> Option<i32> {
    let mut power = 0;
    let mut sign = 1;
    let text = text.replace("\\,", " ").replace("\\cdot", " ").replace("\\ ", " ").replace(['~', '·'], " ");
    let text = text.replace('²', "^2").replace('³', "^3").replace('/', " / ");
    let mut any = false;
    for word in text.split_whitespace() {
        if word == "/" {
            sign = -1;
            continue;
        }
        let (name, exponent) = word.split_once('^').unwrap_or((word, "1"));
        let exponent: i32 = exponent.trim_matches(['{', '}']).parse().ok()?;
        let (_, ten) = UNITS.iter().find(|(unit, _)| *unit == name)?;
        power += sign * ten * exponent.clamp(-9, 9);
        any = true;
    }
    any.then_some(power)
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
fn braced(text: &str) -> Option<(&str, usize)> {
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
fn skipped(text: &str, from: usize) -> usize {
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
    use super::*;
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
        assert_eq!(plain(r"v = 2~\text{km}/\text{s}"), r"v = 2 \cdot 10^{3}");
        assert_eq!(plain(r"\alpha = 60^\circ"), r"\alpha = \frac{60 \pi}{180}");
        // The twins: no unit, no number, a subscript.
        for text in [r"3\,\text{apples}", r"x = \text{m}", r"T_1 \mathrm{m}", r"3 m"] {
            assert_eq!(plain(text), text);
        }
    }

    #[test]
    fn a_power_after_the_parenthesis_of_a_function_belongs_to_the_function() {
        assert_eq!(plain(r"\sin(x)^2 + \cos\left(x\right)^{2}"), r"\sin^2(x) + \cos^{2}\left(x\right)");
        assert_eq!(plain(r"\sin(x^2) (y)^2"), r"\sin(x^2) (y)^2");
    }

    #[test]
    fn words_and_commas_keep_their_length() {
        for (text, new) in [
            (r"x = 57{,}7\,m", r"x = 57.7  \,m"),
            (r"x = 0,5 t", "x = 0.5 t"),
            (r"a = b \quad \text{y también} \quad c = d", r"a = b \quad \quad             \quad c = d"),
            // The twins: a list, a subscript, a word that is read.
            ("f(1,2)", "f(1,2)"),
            (r"E_\text{kin max} = 1", r"E_\text{kin max} = 1"),
            (r"E = \text{const}", r"E = \text{const}"),
            (r"a = b \text{ for } x > 0", r"a = b \text{ for } x > 0"),
        ] {
            assert_eq!(separated(text), new);
        }
    }
}
