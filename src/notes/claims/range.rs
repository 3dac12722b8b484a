//! Ranges: the values that are sampled for a symbol.

use crate::notes::json::Spanned;
use crate::notes::normalize::normalized;
use crate::source::Fault;
use crate::suggest::nearest;

/// The values of a symbol.
#[derive(Clone, Debug, PartialEq)]
pub enum Range {
    /// `> 0`
    Positive,
    /// `< 0`
    Negative,
    /// `any`: of either sign.
    Any,
    /// `angle`: the whole circle.
    Angle,
    /// `(0, \pi)`, `[0.2, 2.9]`
    Interval {
        /// The lower end.
        low: f64,
        /// The upper end.
        high: f64,
        /// Whether the lower end is excluded.
        low_open: bool,
        /// Whether the upper end is excluded.
        high_open: bool,
    },
    /// `integer 2..5`; for indices also `1..3` and `1..n`.
    Integer {
        /// The first.
        low: i64,
        /// The last.
        high: Count,
    },
    /// `labels 1..4`, `labels 1..n`: a label, which is not summed over by repetition. For indices only.
    Labels {
        /// The last.
        high: Count,
    },
    /// `rigid, turning with \vec\omega`: a vector of fixed length whose rate is ω × the vector; `about \vec c`: a
    /// position that turns about **c**. Under `varies with time` only.
    Rigid {
        /// ω, in LaTeX.
        turning_with: String,
        /// The fixed point of the rotation, in LaTeX; the origin by default.
        about: Option<String>,
    },
    /// `of r`, `of x, y`: any smooth function of these names, in LaTeX. For functions only.
    Of(Vec<String>),
    /// `2x3 matrix`: a matrix of arbitrary real entries, by its numbers of rows and columns.
    Matrix(u8, u8),
    /// `complex`: a complex number.
    Complex,
    /// `imaginary unit`: √−1.
    ImaginaryUnit,
    /// Of a differential such as dU: the rate of what is differentiated, since all differentials of a display are taken along one
    /// process.
    Rate,
    /// `given by a display`: of a formula that stands for one name, what the display with that name on its left side says.
    Given,
    /// `fixed direction`: a vector of which only the length varies. Under `varies with time` only.
    FixedDirection,
}

/// The last value of an index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Count {
    /// A number.
    Number(i64),
    /// A symbol, as the `n` of `1..n`.
    Symbol(String),
}

const RANGES: &str = "a range is \"> 0\", \"< 0\", \"any\", \"nonzero\", \"angle\", an interval such as \"(0, \\\\pi)\" or \
                      \"[0.2, 2.9]\", \"integer 2..5\", \"multiplier\", \"complex\", \"imaginary unit\", or \"3x3 matrix\"";

/// The ranges that are words.
const WORDS: [&str; 6] = ["any", "angle", "nonzero", "multiplier", "complex", "imaginary unit"];

/// What was probably meant by a text that is no range: advice.
fn meant(text: &str) -> Option<String> {
    let squeezed: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let is_size = |part: &str| !part.is_empty() && part.chars().all(|c| c.is_ascii_digit());
    let is_at_least = |sign: &str| squeezed.strip_prefix(sign).is_some_and(|end| end.parse::<f64>().is_ok());
    let word = |word: &&&str| text.starts_with(**word) || text.ends_with(**word);
    match squeezed.as_str() {
        "integer" | "integers" => Some("an integer needs its ends: write \"integer 1..5\"".to_owned()),
        _ if squeezed.split_once(['x', '×']).is_some_and(|(rows, columns)| is_size(rows) && is_size(columns)) => {
            Some(format!("for a matrix write \"{squeezed} matrix\""))
        }
        _ if [">=", "≥", "\\ge", "\\geq"].iter().any(|sign| is_at_least(sign)) => {
            Some("write \"> 0\", or \"[0, \\\\infty)\" if the end belongs to the range".to_owned())
        }
        _ if ["<=", "≤", "\\le", "\\leq"].iter().any(|sign| is_at_least(sign)) => {
            Some("write \"< 0\", or \"(-\\\\infty, 0]\" if the end belongs to the range".to_owned())
        }
        _ => WORDS
            .iter()
            .find(word)
            .filter(|word| **word != text)
            .map(|word| format!("did you mean \"{word}\"? {RANGES}")),
    }
}

/// Kinds of quantities that authors write where a range belongs.
const QUANTITIES: [&str; 20] = [
    "distance",
    "length",
    "position",
    "height",
    "charge",
    "mass",
    "time",
    "speed",
    "velocity",
    "current",
    "voltage",
    "energy",
    "temperature",
    "momentum",
    "force",
    "number",
    "real",
    "positive",
    "coordinate",
    "scalar",
];
const INDICES: &str = "write \"1..3\" or \"1..n\"; for an index that is summed over only under Σ, write \"labels \
                       1..3\"";
const MOTIONS: &str =
    "write \"rigid, turning with \\\\vec\\\\omega\"; if the body turns about a point, add \"about \\\\vec c\"";

/// Reads the range of a symbol.
pub(super) fn range(written: &Spanned<String>) -> Result<Spanned<Range>, Fault> {
    let text = written.value.trim();
    let squeezed: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let range = match squeezed.as_str() {
        ">0" => Range::Positive,
        "<0" => Range::Negative,
        "any" | "real" | "multiplier" => Range::Any,
        "angle" => Range::Angle,
        "complex" => Range::Complex,
        "imaginaryunit" => Range::ImaginaryUnit,
        _ if squeezed.ends_with("matrix") => matrix(written, squeezed.trim_end_matches("matrix"))?,
        _ if text.starts_with(['(', '[']) => interval(written)?,
        _ => match text.strip_prefix("integer").filter(|rest| rest.starts_with(char::is_whitespace)) {
            Some(rest) => integers(written, rest, false)?,
            None => {
                let fault = Fault::claims(written.span, format!("\"{text}\" is not a range"));
                if text == "fixed direction" || text.starts_with("rigid") {
                    return Err(fault.help("declare this vector under \"varies with time\""));
                }
                let is_quantity = QUANTITIES.iter().any(|word| text.eq_ignore_ascii_case(word));
                if is_quantity {
                    let help = format!(
                        "a range says which values a quantity may have; in place of \"{text}\" write \"> 0\" if it is \
                         always positive, else \"any\""
                    );
                    return Err(fault.help(help));
                }
                if let Some(help) = meant(text) {
                    return Err(fault.help(help));
                }
                return Err(match nearest(text, WORDS) {
                    Some(word) => fault.help(format!("did you mean \"{word}\"? {RANGES}")),
                    None => fault.help(RANGES),
                });
            }
        },
    };
    Ok(Spanned::new(range, written.span))
}

/// Whether a text is a formula, and no words: it has no letters side by side, but for commands.
pub(super) fn is_formula(text: &str) -> bool {
    if meant(text).is_some() {
        return false;
    }
    let mut rest = text;
    let (mut run, mut is_written) = (0, false);
    while let Some(c) = rest.chars().next() {
        rest = &rest[c.len_utf8()..];
        if c == '\\' {
            let command = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_alphabetic()).len();
            rest = &rest[command..];
            (run, is_written) = (0, true);
            continue;
        }
        run = if c.is_alphabetic() { run + 1 } else { 0 };
        if run > 1 || matches!(c, '=' | '<' | '>' | ',' | '.') {
            return false;
        }
        is_written |= c.is_alphabetic();
    }
    is_written
}

/// Reads the size of a matrix: `3x3`, `2×1`.
fn matrix(written: &Spanned<String>, size: &str) -> Result<Range, Fault> {
    let parts: Option<Vec<u8>> =
        size.split(['x', '×']).map(|part| part.parse().ok().filter(|n| (1..=6).contains(n))).collect();
    match parts.as_deref() {
        Some([rows, columns]) if (*rows, *columns) != (1, 1) => Ok(Range::Matrix(*rows, *columns)),
        _ => Err(Fault::claims(written.span, format!("\"{}\" is not the size of a matrix", written.value.trim()))
            .help("write \"3x3 matrix\"; a matrix has up to six rows and six columns")),
    }
}

/// Reads the range of a symbol that varies with time: values, or the motion of a vector.
pub(super) fn motion(written: &Spanned<String>) -> Result<Spanned<Range>, Fault> {
    let text = written.value.trim();
    if text == "fixed direction" {
        return Ok(Spanned::new(Range::FixedDirection, written.span));
    }
    let Some(rest) = text.strip_prefix("rigid") else { return range(written) };
    let turning = rest.trim_start().strip_prefix(',').map(str::trim_start);
    let turning = turning.and_then(|rest| rest.strip_prefix("turning with ")).map(str::trim);
    let (rate, about) = match turning.map(|rest| (rest, rest.split_once(" about "))) {
        Some((_, Some((rate, point)))) => (rate.trim(), Some(point.trim())),
        Some((rate, None)) => (rate, None),
        None => ("", None),
    };
    if rate.is_empty() || about == Some("") || rate.ends_with(" about") {
        return Err(Fault::claims(written.span, format!("\"{text}\" does not name the angular velocity")).help(MOTIONS));
    }
    let range = Range::Rigid { turning_with: rate.to_owned(), about: about.map(str::to_owned) };
    Ok(Spanned::new(range, written.span))
}

/// Reads the arguments of a function.
pub(super) fn function(written: &Spanned<String>) -> Result<Spanned<Range>, Fault> {
    let names = written.value.trim().strip_prefix("of ").unwrap_or_default();
    let names: Vec<String> = names.split(',').map(|name| name.trim().to_owned()).collect();
    match names.iter().any(String::is_empty) {
        true => Err(Fault::claims(
            written.span,
            format!("\"{}\" does not name the arguments of the function", written.value),
        )
        .help("write \"of r\", or \"of x, y\" with up to three names")),
        false => Ok(Spanned::new(Range::Of(names), written.span)),
    }
}

/// Reads the range of an index.
pub(super) fn index(written: &Spanned<String>) -> Result<Spanned<Range>, Fault> {
    let rest = written.value.trim();
    if let Some(labels) = rest.strip_prefix("labels ") {
        return match integers(written, labels, true)? {
            Range::Integer { low: 1, high } => Ok(Spanned::new(Range::Labels { high }, written.span)),
            _ => Err(Fault::claims(written.span, "labels must count from 1").help(INDICES)),
        };
    }
    let rest = rest.strip_prefix("integer ").unwrap_or(rest);
    Ok(Spanned::new(integers(written, rest, true)?, written.span))
}

fn integers(written: &Spanned<String>, rest: &str, symbolic: bool) -> Result<Range, Fault> {
    let help = if symbolic { INDICES } else { RANGES };
    let fault = |message: String| Fault::claims(written.span, message).help(help);
    let unread = || fault(format!("\"{}\" is not a range of integers", written.value));
    let (low, high) = rest.split_once("..").ok_or_else(unread)?;
    let low: i64 = low.trim().parse().map_err(|_| unread())?;
    let high = high.trim();
    let in_name = |c: char| c.is_alphanumeric() || matches!(c, '\\' | '_' | '{' | '}' | '\'');
    let is_symbol = symbolic && high.starts_with(|c: char| c.is_alphabetic() || c == '\\') && high.chars().all(in_name);
    let high = match high.parse() {
        Ok(number) => Count::Number(number),
        Err(_) if is_symbol => Count::Symbol(high.to_owned()),
        Err(_) => return Err(unread()),
    };
    match high {
        Count::Number(number) if number < low => {
            Err(fault(format!("the range \"{}\" ends before it begins", written.value)))
        }
        Count::Number(number) if number == low && !symbolic => {
            Err(Fault::claims(written.span, format!("the range \"{}\" has one value only", written.value))
                .help("give a fixed value under \"where\" or \"define\""))
        }
        high => Ok(Range::Integer { low, high }),
    }
}

/// The range of a symbol between formulas of other symbols, as `(0, L)` or `(1, \\infty)`, and the conditions that it then
/// meets: one for each end that is no number.
///
/// An end that is a formula is a hypothesis of every equation, as under `assume`.
pub(super) fn between(written: &Spanned<String>, name: &str) -> Option<(Spanned<Range>, Vec<Spanned<String>>)> {
    let text = written.value.trim();
    if text == "nonzero" {
        let condition = Spanned::new(format!("{name} \\neq 0"), written.span);
        return Some((Spanned::new(Range::Any, written.span), vec![condition]));
    }
    // `> a` has one end, and is the interval from it.
    let one_end = |sign: char| {
        text.strip_prefix(sign).filter(|_| meant(text).is_none()).map(str::trim).filter(|end| endpoint(end).is_err())
    };
    let one_ended = one_end('>').map(|end| format!("({end}, \\infty)"));
    let one_ended = one_ended.or_else(|| one_end('<').map(|end| format!("(-\\infty, {end})")));
    let text = one_ended.as_deref().unwrap_or(text);
    let inside = text.strip_prefix(['(', '['])?.strip_suffix([')', ']'])?;
    let (low, high) = inside.split_once(',').map(|(low, high)| (low.trim(), high.trim()))?;
    let is_infinite = |end: &str| matches!(end.trim_start_matches(['+', '-']).trim(), "\\infty");
    // Beside π and digits a formula has a name: `1e400`, `\pi\pi` and `nan` are numbers that are written wrongly.
    let has_name = |end: &str| {
        let rest = ["\\pi", "\\frac", "\\infty"].iter().fold(end.to_owned(), |text, known| text.replace(known, " "));
        let is_number =
            rest.trim_start_matches(['+', '-']).starts_with(|c: char| c.is_ascii_digit()) && !rest.contains(' ');
        let letters = rest.trim_matches(|c: char| !c.is_alphabetic()).to_lowercase();
        !letters.is_empty() && !["inf", "nan", "infinity"].contains(&letters.as_str()) && (letters != "e" || !is_number)
    };
    let is_formula = |end: &str| endpoint(end).is_err() && has_name(end) && !end.contains(['<', '>', '=', ',']);
    if ![low, high].into_iter().any(|end| is_formula(end) || is_infinite(end))
        || is_infinite(low) != low.starts_with("-\\infty")
    {
        return None;
    }
    let range = match (endpoint(low), endpoint(high)) {
        (Ok(low), _) if low >= 0.0 => Range::Positive,
        (_, Ok(high)) if high <= 0.0 => Range::Negative,
        (Err(_), Err(_)) | (Ok(_), Err(_)) | (Err(_), Ok(_)) => Range::Any,
        (Ok(_), Ok(_)) => return None,
    };
    let is_said = |end: &str| is_infinite(end) || endpoint(end).is_ok_and(|end| end == 0.0 && range != Range::Any);
    let (above, below) =
        (if text.starts_with('(') { ">" } else { "\\ge" }, if text.ends_with(')') { "<" } else { "\\le" });
    let ends = [(low, above), (high, below)].into_iter().filter(|(end, _)| !is_said(end));
    let conditions = ends.map(|(end, relation)| Spanned::new(format!("{name} {relation} {end}"), written.span));
    Some((Spanned::new(range.clone(), written.span), conditions.collect()))
}

fn interval(written: &Spanned<String>) -> Result<Range, Fault> {
    let text = written.value.trim();
    let fault = |message: String| Fault::claims(written.span, message);
    let unread = || fault(format!("\"{text}\" is not an interval")).help(RANGES);
    let inside = text.get(1..text.len() - 1).filter(|_| text.ends_with([')', ']'])).ok_or_else(unread)?;
    let (low, high) = inside.split_once(',').ok_or_else(unread)?;
    let end = |end: &str| endpoint(end).map_err(|message| fault(message).help(RANGES));
    let (low, high) = (end(low)?, end(high)?);
    if low > high {
        return Err(fault(format!("the range \"{text}\" ends before it begins")).help("write the smaller end first"));
    }
    if low == high {
        return Err(fault(format!("the range \"{text}\" has one value only"))
            .help("give a fixed value under \"where\" or \"define\""));
    }
    Ok(Range::Interval { low, high, low_open: text.starts_with('('), high_open: text.ends_with(')') })
}

/// A number, or a multiple of π: `-\pi`, `2\pi`, `\pi/2`, `\frac{3\pi}{2}`.
fn endpoint(text: &str) -> Result<f64, String> {
    let plain = normalized(text);
    let mut tokens = plain.split_terminator('\u{1f}').peekable();
    let mut sign = 1.0;
    while let Some(token) = tokens.next_if(|&token| token == "-" || token == "+") {
        sign = if token == "-" { -sign } else { sign };
    }
    let value = if tokens.next_if_eq(&"\\frac").is_some() {
        let (above, below) = (argument(&mut tokens), argument(&mut tokens));
        let rest: String = tokens.collect();
        let factor = if rest.is_empty() { 1.0 } else { product(&rest, text)? };
        product(&above, text)? / product(&below, text)? * factor
    } else {
        let whole: String = tokens.collect();
        match whole.split_once('/') {
            Some((above, below)) => product(above, text)? / product(below, text)?,
            None => product(&whole, text)?,
        }
    };
    if value.is_finite() { Ok(sign * value) } else { Err(format!("\"{}\" is not a finite number", text.trim())) }
}

/// The argument of a `\frac`: a token, or the tokens in braces.
fn argument<'a>(tokens: &mut impl Iterator<Item = &'a str>) -> String {
    match tokens.next() {
        Some("{") => tokens.take_while(|&token| token != "}").collect(),
        Some(token) => token.to_owned(),
        None => String::new(),
    }
}

fn product(product: &str, text: &str) -> Result<f64, String> {
    let (number, pi) = match product.strip_suffix("\\pi") {
        Some("") => return Ok(std::f64::consts::PI),
        Some(number) => (number, std::f64::consts::PI),
        None => (product, 1.0),
    };
    let number = number.trim_end_matches("\\cdot").trim_end_matches('*');
    let looks = number.starts_with(|c: char| c.is_ascii_digit() || c == '.')
        && number.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'e' | b'E' | b'+' | b'-'));
    let value = number.parse::<f64>().ok().filter(|_| looks);
    let value = value.ok_or_else(|| format!("\"{}\" is neither a number nor a multiple of \\pi", text.trim()))?;
    Ok(value * pi)
}
