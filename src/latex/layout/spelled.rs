//! Functions without a backslash before a parenthesis, where the letters can be no product: `cos(\phi)`, `mgl\,sin(\theta)`.
//!
//! Nobody multiplies c, o and s. `asin(x)` may be the arcsine or a product, and stays as it is; so does `sin x`, whose argument
//! nothing encloses. `log` is taken for the function wherever it stands alone. Units in italic letters, and names of several letters,
//! are here too.

use super::super::lexer::{Space, Token, TokenKind};
use crate::formula::units;

/// The longer ones go before those that they end with.
const FUNCTIONS: [&str; 14] =
    ["arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "coth", "sin", "cos", "tan", "cot", "sec", "csc", "exp"];

/// The same tokens, where such letters are the command of the function.
pub(super) fn with_commands(tokens: Vec<Token>) -> Vec<Token> {
    let mut found: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        // `\mathrm{sin(x)}` is `\sin(x)`.
        if let Some((name, open, end)) = upright_function(&tokens[at..]) {
            found.push(Token { kind: TokenKind::Command(format!("\\{name}")), span: tokens[at].span });
            found.extend_from_slice(&tokens[at + open..at + end]);
            at += end + 1;
            continue;
        }
        // `{\rm tanh(x)}`
        if let Some((name, open)) = switched_function(&tokens[at..]) {
            found.push(Token { kind: TokenKind::Command(format!("\\{name}")), span: tokens[at].span });
            at += open;
            continue;
        }
        // Words are no formulas.
        if let Some(end) = end_of_words(&tokens[at..]) {
            found.extend_from_slice(&tokens[at..at + end]);
            at += end;
            continue;
        }
        // The letter directly after _ or ^ is all of the script.
        let is_script = at > 0 && matches!(tokens[at - 1].kind, TokenKind::Sub | TokenKind::Super);
        let length = if is_script { 0 } else { run(&tokens[at..]) };
        if length < 3 {
            found.push(tokens[at].clone());
            at += 1;
            continue;
        }
        let letters = &tokens[at..at + length];
        match function(letters, &tokens[at + length..]) {
            Some(name) => {
                let (factors, word) = letters.split_at(length - name.len());
                found.extend_from_slice(factors);
                let span = word.iter().map(|token| token.span).fold(word[0].span, crate::source::Span::to);
                found.push(Token { kind: TokenKind::Command(format!("\\{name}")), span });
            }
            None => found.extend_from_slice(letters),
        }
        at += length;
    }
    found
}

/// The same tokens, where italic letters after a number and a space are upright units: `1\ kWh = 3.6 \cdot 10^6\ J`.
///
/// Some words are units for sure in such a place. Only beside one of them is any other word or letter one.
pub(super) fn with_units(tokens: Vec<Token>) -> Vec<Token> {
    const SURE: [&str; 15] =
        ["kWh", "Wh", "eV", "keV", "MeV", "GeV", "Hz", "kHz", "MHz", "GHz", "kW", "MW", "kPa", "MPa", "mol"];
    let spots: Vec<(usize, String)> =
        (1..tokens.len()).filter_map(|at| Some((at, word_after_a_number(&tokens, at)?))).collect();
    if !spots.iter().any(|(_, word)| SURE.contains(&word.as_str())) {
        return tokens;
    }
    let mut found = tokens;
    for (at, word) in
        spots.into_iter().rev().filter(|(_, word)| SURE.contains(&word.as_str()) || units::parse(word).is_ok())
    {
        let (start, end) = (at + 1, at + 1 + word.len());
        let token = |kind: TokenKind, place: usize, found: &[Token]| Token { kind, span: found[place].span };
        let style = token(TokenKind::Command("\\mathrm".to_owned()), start, &found);
        let (open, close) = (token(TokenKind::Open, start, &found), token(TokenKind::Close, end - 1, &found));
        found.insert(end, close);
        found.splice(start..start, [style, open]);
    }
    found
}

/// The letters after the space at `at`, if a number stands before it and the term ends after them.
fn word_after_a_number(tokens: &[Token], at: usize) -> Option<String> {
    let is_after_number = matches!(tokens[at - 1].kind, TokenKind::Digit(_));
    if tokens[at].kind != TokenKind::Space(Space::Thin) || !is_after_number {
        return None;
    }
    let length = run(&tokens[at + 1..]);
    let ends = tokens.get(at + 1 + length).is_none_or(|next| match &next.kind {
        TokenKind::Space(Space::Wide) | TokenKind::Row | TokenKind::Align | TokenKind::Close => true,
        TokenKind::Other(c) => "=+-,.;)<>".contains(*c),
        _ => false,
    });
    (length > 0 && ends).then(|| tokens[at + 1..][..length].iter().filter_map(letter).collect())
}

/// The number of tokens of a word in `\text{…}` or the like that begins here.
fn end_of_words(tokens: &[Token]) -> Option<usize> {
    let TokenKind::Command(name) = &tokens.first()?.kind else { return None };
    let is_word = ["\\text", "\\mathrm", "\\operatorname", "\\label", "\\tag"].contains(&name.as_str());
    if !is_word || tokens.get(1)?.kind != TokenKind::Open {
        return None;
    }
    let mut depth = 0_usize;
    for (at, token) in tokens.iter().enumerate().skip(1) {
        match token.kind {
            TokenKind::Open => depth += 1,
            TokenKind::Close => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some(at + 1);
        }
    }
    None
}

/// The function that begins an upright group and stands there before a parenthesis, with the place of the parenthesis and that of the
/// closing brace.
fn upright_function(tokens: &[Token]) -> Option<(&'static str, usize, usize)> {
    let TokenKind::Command(style) = &tokens.first()?.kind else { return None };
    if style != "\\mathrm" || tokens.get(1)?.kind != TokenKind::Open {
        return None;
    }
    let (name, open) = function_before_a_parenthesis(&tokens[2..])?;
    let end = end_of_words(tokens)?.checked_sub(1)?;
    Some((name, 2 + open, end))
}

/// The function behind the switch to upright letters, with the place of its parenthesis.
fn switched_function(tokens: &[Token]) -> Option<(&'static str, usize)> {
    let TokenKind::Command(style) = &tokens.first()?.kind else { return None };
    let start = 1 + tokens[1..].iter().take_while(|token| matches!(token.kind, TokenKind::Space(_))).count();
    let (name, open) = function_before_a_parenthesis(tokens.get(start..)?).filter(|_| style == "\\rm")?;
    Some((name, start + open))
}

/// The function that letters spell directly before a parenthesis, with the place of that.
fn function_before_a_parenthesis(tokens: &[Token]) -> Option<(&'static str, usize)> {
    let length = run(tokens);
    let word: String = tokens[..length].iter().filter_map(letter).collect();
    let name = FUNCTIONS.into_iter().find(|name| *name == word)?;
    matches!(tokens.get(length)?.kind, TokenKind::Other('(' | '[')).then_some((name, length))
}

/// The number of letters side by side at the beginning.
fn run(tokens: &[Token]) -> usize {
    let is_letter = |token: &Token| matches!(token.kind, TokenKind::Letter(_));
    if !tokens.first().is_some_and(is_letter) {
        return 0;
    }
    1 + tokens.windows(2).take_while(|pair| is_letter(&pair[1]) && pair[0].span.end == pair[1].span.start).count()
}

/// The function at the end of a run of letters.
fn function(letters: &[Token], after: &[Token]) -> Option<&'static str> {
    let word: String = letters.iter().filter_map(letter).collect();
    let is_enclosed = opens(after) || power(after).is_some_and(|length| opens(&after[length..]));
    if word == "log" && after.first().is_some_and(begins_argument) {
        return Some("log");
    }
    let name = FUNCTIONS.into_iter().find(|name| is_enclosed && word.ends_with(name))?;
    let factors = &word[..word.len() - name.len()];
    let is_word = factors.contains(['a', 'e', 'i', 'o', 'u']);
    let has_another = FUNCTIONS.into_iter().any(|other| factors.contains(other)) || factors.contains("log");
    (!is_word && !has_another).then_some(name)
}

fn letter(token: &Token) -> Option<char> {
    match token.kind {
        TokenKind::Letter(letter) => Some(letter),
        _ => None,
    }
}

/// Whether a round parenthesis opens here.
fn opens(tokens: &[Token]) -> bool {
    let is = |at: usize, kind: &TokenKind| tokens.get(at).is_some_and(|token| token.kind == *kind);
    let round = TokenKind::Other('(');
    is(0, &round) || is(0, &TokenKind::Command("\\left".to_owned())) && is(1, &round)
}

/// The number of tokens of a whole power, `^2`.
fn power(tokens: &[Token]) -> Option<usize> {
    match tokens {
        [first, digit, ..] if first.kind == TokenKind::Super && matches!(digit.kind, TokenKind::Digit(_)) => Some(2),
        _ => None,
    }
}

fn begins_argument(token: &Token) -> bool {
    match &token.kind {
        TokenKind::Letter(_) | TokenKind::Digit(_) | TokenKind::Other('(') | TokenKind::Sub => true,
        TokenKind::Command(name) => ["\\frac", "\\left", "\\dfrac", "\\tfrac"].contains(&name.as_str()),
        _ => false,
    }
}

/// Names of several letters that are products nowhere: energies, errors, heating values. `F = Ma`, `\tau = Fr` and `BIL = mg` are
/// products.
const NAMES: [&str; 56] = [
    "SWR", "API", "FSR", "TOF", "CFL", "LMTD", "CMRR", "PSRR", "SED", "KE", "PE", "GPE", "EPE", "COP", "NTU", "SNR",
    "RMS", "EMF", "MSE", "RMSE", "LHV", "HHV", "LCV", "HCV", "ESS", "GBW", "GBP", "BER", "RPM", "PSF", "MTF", "OTF",
    "BMI", "FOM", "SPL", "PSD", "PRF", "SAR", "VSWR", "MTBF", "LCOE", "RCS", "THD", "SINR", "SFDR", "FWHM", "EIRP",
    "ENBW", "DOF", "ITAE", "IAE", "ISE", "MAE", "OPD", "IMA", "NPSH",
];

/// Numbers without a unit, which are names where one of them is a whole left side and a quotient is the right one:
/// `Pr = \frac{\nu}{\alpha}`.
const QUOTIENTS: [&str; 16] =
    ["Ma", "St", "Ca", "Sc", "Eu", "Pr", "Pe", "Sh", "Bi", "Fr", "We", "Gr", "Ra", "Kn", "Bo", "Wo"];

/// Numbers of flows that depend on one another.
const TRANSFERS: [&str; 9] = ["Re", "Nu", "Sh", "Sc", "Pr", "Pe", "Gr", "Ra", "Bi"];

/// Whether letters are such a name.
pub fn is_name_of_letters(word: &str) -> bool {
    NAMES.contains(&word)
}

/// Whether upright letters are a number of a flow, `\mathrm{Ma}^2`.
pub fn is_number_of_a_flow(word: &str) -> bool {
    QUOTIENTS.contains(&word) || TRANSFERS.contains(&word)
}

/// Numbers without a unit, which are names where one of them is a whole left side: `Re = \rho v D/\mu`.
const NUMBERS: [&str; 9] = ["Re", "Nu", "NA", "QE", "RH", "AR", "MA", "TE", "VR"];

/// The same tokens, where such letters are one upright name, if they are a term of their own anywhere.
pub(super) fn with_names(tokens: Vec<Token>) -> Vec<Token> {
    let spots: Vec<(usize, String)> = (0..tokens.len()).filter_map(|at| Some((at, name_at(&tokens, at)?))).collect();
    let has_number =
        spots.iter().any(|(at, name)| NUMBERS.contains(&name.as_str()) && is_left_side(&tokens, *at, name.len()));
    // `Nu = 0.023\,Re^{0.8} Pr^{0.4}`: beside a number of a flow the others are numbers too.
    let is_of_a_transfer = spots.iter().any(|(at, name)| {
        ["Nu", "Sh", "Re"].contains(&name.as_str())
            && (is_left_side(&tokens, *at, name.len()) || is_equal_to_a_quotient(&tokens, *at, name))
    });
    let is_sure = |at: usize, name: &String| {
        name == "Re" && is_no_real_part(&tokens, at)
            || is_of_a_transfer && TRANSFERS.contains(&name.as_str())
            || is_of_a_flow(&tokens, at, name)
            || name == "NA" && is_below_a_wavelength(&tokens, at)
            || QUOTIENTS.contains(&name.as_str())
                && spots.iter().any(|(at, other)| other == name && is_equal_to_a_quotient(&tokens, *at, name))
            || match NUMBERS.contains(&name.as_str()) {
                _ if QUOTIENTS.contains(&name.as_str()) => false,
                true => has_number,
                false => spots.iter().any(|(at, other)| other == name && is_term(&tokens, *at, name.len())),
            }
    };
    let mut found = tokens.clone();
    for (at, name) in spots.iter().rev().filter(|(at, name)| is_sure(*at, name)) {
        let (start, end) = (*at, at + name.len());
        let token = |kind: TokenKind, place: usize| Token { kind, span: tokens[place].span };
        found.insert(end, token(TokenKind::Close, end - 1));
        let style = token(TokenKind::Command("\\mathrm".to_owned()), start);
        found.splice(start..start, [style, token(TokenKind::Open, start)]);
    }
    found
}

/// The name that begins here, if it is a whole run of letters, and in no `\text{…}`.
fn name_at(tokens: &[Token], at: usize) -> Option<String> {
    let touches = |before: usize| tokens[before].span.end == tokens[at].span.start;
    let is_inside = at.checked_sub(1).is_some_and(|before| match tokens[before].kind {
        TokenKind::Letter(_) => touches(before),
        // In braces it may be the argument of a command or a script; in a fraction or a root it is a formula.
        TokenKind::Open => !before.checked_sub(1).is_some_and(|outer| match &tokens[outer].kind {
            TokenKind::Command(name) => ["\\frac", "\\dfrac", "\\tfrac", "\\sqrt"].contains(&name.as_str()),
            TokenKind::Close => true,
            _ => false,
        }),
        // What stands beside a relation or the sign of a product is no argument.
        TokenKind::Command(ref name) => {
            !["\\propto", "\\approx", "\\sim", "\\cdot", "\\times", "\\quad", "\\qquad", "\\leq", "\\geq"]
                .contains(&name.as_str())
        }
        TokenKind::Sub | TokenKind::Super => true,
        _ => false,
    });
    let length = if is_inside { 0 } else { run(&tokens[at..]) };
    let word: String = tokens[at..at + length].iter().filter_map(letter).collect();
    [&NAMES[..], &NUMBERS, &QUOTIENTS].iter().any(|names| names.contains(&word.as_str())).then_some(word)
}

/// Whether a run is all of a denominator below a wavelength: `\frac{0.61\lambda}{NA}` has the numerical aperture there.
fn is_below_a_wavelength(tokens: &[Token], at: usize) -> bool {
    let is = |place: usize, kind: &TokenKind| tokens.get(place).is_some_and(|token| token.kind == *kind);
    let is_whole =
        at > 1 && is(at - 1, &TokenKind::Open) && is(at - 2, &TokenKind::Close) && is(at + 2, &TokenKind::Close);
    let above = tokens[..at.saturating_sub(2)].iter().rev().take_while(|token| token.kind != TokenKind::Open);
    let lambda = TokenKind::Command("\\lambda".to_owned());
    is_whole && above.into_iter().any(|token| token.kind == lambda)
}

/// Whether a run is a whole left side, and one fraction the right one. The Mach number is a speed by another one, c or a, and the Froude
/// number has a root or g below: `Ma = \frac{dp}{dt}` and `Fr = \frac{L}{t}` are products.
fn is_equal_to_a_quotient(tokens: &[Token], at: usize, name: &str) -> bool {
    let begins =
        tokens[..at].iter().rev().find(|token| token.kind != TokenKind::Space(Space::Thin)).is_none_or(|before| {
            matches!(before.kind, TokenKind::Row | TokenKind::Align | TokenKind::Space(_) | TokenKind::Other(',' | ';'))
        });
    let mut rest = tokens[at + name.len()..]
        .iter()
        .enumerate()
        .filter(|(_, token)| !matches!(token.kind, TokenKind::Space(Space::Thin) | TokenKind::Align))
        .map(|(place, _)| at + name.len() + place);
    let is_equal = rest.next().is_some_and(|place| tokens[place].kind == TokenKind::Other('='));
    let Some(start) = rest.next().filter(|_| begins && is_equal) else { return false };
    let is_fraction = matches!(&tokens[start].kind, TokenKind::Command(name)
        if ["\\frac", "\\dfrac", "\\tfrac"].contains(&name.as_str()));
    // `Ma = v/c`
    let slash = [start, start + 1, start + 2].map(|place| tokens.get(place).map(|token| &token.kind));
    if let [Some(TokenKind::Letter(_)), Some(TokenKind::Other('/')), Some(TokenKind::Letter(below))] = slash {
        return name == "Ma" && "ca".contains(*below);
    }
    if !is_fraction {
        return false;
    }
    let below = start + 1 + script(&tokens[start + 1..]);
    let end = (below + script(tokens.get(below..).unwrap_or_default())).min(tokens.len());
    let inside = |from: usize, to: usize| tokens[from..to].iter().filter(|token| token.kind != TokenKind::Open);
    let is_differential = inside(start + 1, below.min(tokens.len())).next().is_some_and(|first| {
        first.kind == TokenKind::Letter('d')
            || matches!(&first.kind, TokenKind::Command(name) if name == "\\partial" || name == "\\mathrm")
    });
    let ends = tokens[end..].iter().find(|token| token.kind != TokenKind::Space(Space::Thin)).is_none_or(|next| {
        matches!(next.kind, TokenKind::Other('=' | '.' | ',' | ';') | TokenKind::Row | TokenKind::Align | TokenKind::Space(_))
            || matches!(&next.kind, TokenKind::Command(name) if ["\\end", "\\approx", "\\sim", "\\equiv", "\\propto"].contains(&name.as_str()))
    });
    let has = |command: &str| {
        inside(below.min(end), end).any(|token| matches!(&token.kind, TokenKind::Command(name) if name == command))
    };
    let fits = match name {
        "Ma" => {
            let first = inside(below.min(end), end).next();
            first.is_some_and(|first| matches!(first.kind, TokenKind::Letter('c' | 'a')))
                || has("\\sqrt")
                || has("\\text")
        }
        "Fr" => has("\\sqrt") || inside(below.min(end), end).any(|token| token.kind == TokenKind::Letter('g')),
        _ => true,
    };
    !is_differential && ends && fits
}

/// Whether a number of a flow has the length or the place below it for which it holds: `Re_D`, `Nu_L`, `Re_x`.
fn is_of_a_flow(tokens: &[Token], at: usize, name: &str) -> bool {
    let [sub, below, ..] = &tokens[at + name.len()..] else { return false };
    let length = |token: &Token| letter(token).is_some_and(|c| "DLdhHx".contains(c));
    let is_braced = || tokens.get(at + name.len() + 2).is_some_and(length);
    // `Re_m = Re_p`, `Re_{crit}`: R does not multiply a charge there; `R e_r` has a direction below.
    let is_label = || {
        let letters = tokens.get(at + name.len() + 2..).map_or(0, run);
        letter(below).is_some_and(|c| "mpc".contains(c)) || below.kind == TokenKind::Open && letters > 1
    };
    NUMBERS[..2].contains(&name)
        && sub.kind == TokenKind::Sub
        && (length(below)
            || below.kind == TokenKind::Open && is_braced()
            || is_label() && is_term(tokens, at, name.len()))
}

/// Whether what follows "Re" is no complex number of which it is the real part. Nobody multiplies R by Euler's number.
fn is_no_real_part(tokens: &[Token], at: usize) -> bool {
    let after = tokens[at + 2..].iter().find(|token| token.kind != TokenKind::Space(Space::Thin));
    after.is_none_or(|token| match &token.kind {
        TokenKind::Other(c) => "=+-/<>),]|".contains(*c),
        TokenKind::Close | TokenKind::Super | TokenKind::Row | TokenKind::Align | TokenKind::Space(_) => true,
        TokenKind::Command(name) => {
            ["\\sqrt", "\\cdot", "\\times", "\\right", "\\approx", "\\leq", "\\geq", "\\ll", "\\gg"]
                .contains(&name.as_str())
        }
        _ => false,
    })
}

/// Whether a run is the first side of an equation: at the beginning, or of a row.
fn is_left_side(tokens: &[Token], at: usize, length: usize) -> bool {
    let begins = at.checked_sub(1).is_none_or(|before| matches!(tokens[before].kind, TokenKind::Row));
    let after =
        tokens[at + length..].iter().find(|token| !matches!(token.kind, TokenKind::Space(_) | TokenKind::Align));
    begins && after.is_some_and(|token| token.kind == TokenKind::Other('='))
}

/// Whether a run is a term: a sign or nothing stands before it, and after it and its scripts.
fn is_term(tokens: &[Token], at: usize, length: usize) -> bool {
    let bounds = |token: &Token| match &token.kind {
        TokenKind::Other(c) => "=+-<>()".contains(*c),
        TokenKind::Row | TokenKind::Align | TokenKind::Open | TokenKind::Close | TokenKind::Space(Space::Wide) => true,
        TokenKind::Command(name) => ["\\approx", "\\leq", "\\geq", "\\equiv", "\\propto"].contains(&name.as_str()),
        _ => false,
    };
    let is_thin = |token: &&Token| token.kind == TokenKind::Space(Space::Thin);
    let before = tokens[..at].iter().rev().find(|token| !is_thin(token));
    let mut end = at + length;
    while matches!(tokens.get(end).map(|token| &token.kind), Some(TokenKind::Sub | TokenKind::Super)) {
        end += 1 + script(&tokens[end + 1..]);
    }
    let after = tokens.get(end..).and_then(|rest| rest.iter().find(|token| !is_thin(token)));
    before.is_none_or(bounds) && after.is_none_or(bounds)
}

/// The number of tokens of a script.
fn script(tokens: &[Token]) -> usize {
    let mut depth = 0_usize;
    for (at, token) in tokens.iter().enumerate() {
        match token.kind {
            TokenKind::Open => depth += 1,
            TokenKind::Close => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return at + 1;
        }
    }
    tokens.len()
}
