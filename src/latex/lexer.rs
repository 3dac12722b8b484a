//! The lexer: text to tokens. It cannot fail.
//!
//! Commands for size and style give no token. Spaces give one, since they may end the argument of a function
//! (`\cos\theta\,p_\psi`) or separate statements (`\quad`).

use crate::source::Span;

/// One token and its bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// The place; after macro expansion, the place of the call.
    pub span: Span,
}

/// What a token is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// `{`
    Open,
    /// `}`
    Close,
    /// `_`
    Sub,
    /// `^`
    Super,
    /// `'`
    Prime,
    /// `&`
    Align,
    /// `\\`
    Row,
    /// A command with its backslash: `\theta`, `\frac`.
    Command(String),
    /// A single letter.
    Letter(char),
    /// A single digit or the point of a decimal number.
    Digit(char),
    /// A space that is typeset: thin (`\,`), or wide (`\quad`).
    Space(Space),
    /// The number of a macro's argument, `#1`.
    Parameter(u8),
    /// Any other character: `+`, `=`, `(`, `|`, `,`.
    Other(char),
}

/// The spaces with a meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// Ends the argument of a function.
    Thin,
    /// Separates statements.
    Wide,
}

/// Commands without meaning: style, sizes of delimiters, line breaking hints.
const IGNORED: [&str; 30] = [
    "displaystyle",
    "textstyle",
    "scriptstyle",
    "scriptscriptstyle",
    "limits",
    "nolimits",
    "nonumber",
    "notag",
    "big",
    "Big",
    "bigg",
    "Bigg",
    "bigl",
    "Bigl",
    "biggl",
    "Biggl",
    "bigr",
    "Bigr",
    "biggr",
    "Biggr",
    "bigm",
    "Bigm",
    "noindent",
    "allowbreak",
    "strut",
    "mathstrut",
    "relax",
    "normalsize",
    "mathop",
    "mathrel",
];

/// The tokens of a text.
pub fn tokens(text: &str) -> Vec<Token> {
    let mut in_norm = false;
    let mut tokens = Vec::with_capacity(text.len() / 2);
    let mut chars = text.char_indices().peekable();
    while let Some((start, typed)) = chars.next() {
        let mut end = start + typed.len_utf8();
        let c = upright(typed);
        let kind = match c {
            '{' => TokenKind::Open,
            '}' => TokenKind::Close,
            '_' => TokenKind::Sub,
            '^' => TokenKind::Super,
            '\'' | '’' | '′' => TokenKind::Prime,
            '&' => TokenKind::Align,
            // `||v||`, but not `|a||b|`
            '|' if text[end..].starts_with('|') && (in_norm || opens(tokens.last())) => {
                chars.next();
                end += 1;
                in_norm = !in_norm;
                TokenKind::Command("\\|".to_owned())
            }
            '~' => thin(&tokens),
            '\\' => match chars.peek().copied() {
                Some((_, letter)) if letter.is_ascii_alphabetic() => {
                    while let Some((at, letter)) = chars.next_if(|(_, c)| c.is_ascii_alphabetic()) {
                        end = at + letter.len_utf8();
                    }
                    match &text[start + 1..end] {
                        "quad" | "qquad" => TokenKind::Space(Space::Wide),
                        "thinspace" | "enspace" | "space" => thin(&tokens),
                        "negthinspace" => continue,
                        // `\middle|` divides what stands in the brackets around it, and opens nothing.
                        "middle" => {
                            while chars.next_if(|(_, c)| c.is_whitespace()).is_some() {}
                            match chars.next_if(|(_, c)| *c == '|') {
                                Some((at, bar)) => end = at + bar.len_utf8(),
                                None => continue,
                            }
                            TokenKind::Command("\\mid".to_owned())
                        }
                        "cr" | "newline" => TokenKind::Row,
                        name if IGNORED.contains(&name) => continue,
                        name => TokenKind::Command(format!("\\{}", spelling(name))),
                    }
                }
                Some((at, symbol)) => {
                    chars.next();
                    end = at + symbol.len_utf8();
                    match symbol {
                        '\\' => {
                            end = after_row_break(text, end);
                            while chars.next_if(|(at, _)| *at < end).is_some() {}
                            TokenKind::Row
                        }
                        ',' | ';' | ':' | '>' | ' ' | '\n' | '\t' => thin(&tokens),
                        '!' | '/' => continue,
                        symbol => TokenKind::Command(format!("\\{symbol}")),
                    }
                }
                None => TokenKind::Other('\\'),
            },
            '#' => match chars.peek().copied() {
                Some((at, digit)) if digit.is_ascii_digit() => {
                    chars.next();
                    end = at + 1;
                    TokenKind::Parameter(digit as u8 - b'0')
                }
                _ => TokenKind::Other('#'),
            },
            c if c.is_whitespace() => continue,
            c if c.is_ascii_alphabetic() => TokenKind::Letter(c),
            c if c.is_ascii_digit() => TokenKind::Digit(c),
            '.' if text[end..].starts_with(|c: char| c.is_ascii_digit()) => TokenKind::Digit('.'),
            '−' => TokenKind::Other('-'),
            c => match greek(c) {
                Some(name) => TokenKind::Command(format!("\\{name}")),
                None => TokenKind::Other(c),
            },
        };
        tokens.push(Token { kind, span: Span::new(start, end) });
    }
    tokens
}

/// A thin space after these tokens; three of them are as wide as a `\quad`.
fn thin(before: &[Token]) -> TokenKind {
    let is_space = |token: &Token| matches!(token.kind, TokenKind::Space(_));
    TokenKind::Space(match before {
        [.., a, b] if is_space(a) && is_space(b) => Space::Wide,
        _ => Space::Thin,
    })
}

/// Whether a formula begins after this token.
fn opens(before: Option<&Token>) -> bool {
    before.is_none_or(|token| match &token.kind {
        TokenKind::Open | TokenKind::Align | TokenKind::Row | TokenKind::Space(_) => true,
        TokenKind::Other(c) => ['=', '+', '-', '<', '>', '(', '[', ','].contains(c),
        TokenKind::Command(name) => ["\\leq", "\\geq", "\\equiv", "\\left", "\\cdot"].contains(&name.as_str()),
        _ => false,
    })
}

/// One spelling for commands that are synonyms.
fn spelling(name: &str) -> &str {
    match name {
        "dfrac" | "tfrac" | "cfrac" => "frac",
        "le" | "leqslant" | "leqq" => "leq",
        "ge" | "geqslant" | "geqq" => "geq",
        "ne" => "neq",
        "simeq" | "thickapprox" => "approx",
        "implies" | "Longrightarrow" => "Rightarrow",
        "iff" | "Longleftrightarrow" => "Leftrightarrow",
        "to" => "rightarrow",
        "gets" => "leftarrow",
        "dag" => "dagger",
        "ddag" => "ddagger",
        "overrightarrow" => "vec",
        "widehat" => "hat",
        "overline" => "bar",
        "widetilde" => "tilde",
        "triangle" => "Delta",
        "bm" | "bold" | "boldsymbol" | "pmb" | "symbf" | "mathbfit" => "mathbf",
        "operatorname" | "mathrm" | "mathit" | "mathsf" | "mathnormal" => "mathrm",
        "bcancel" | "xcancel" => "cancel",
        "textrm" | "textit" | "textsf" | "textsl" | "mbox" | "hbox" | "textnormal" | "textup" => "text",
        "intercal" => "top",
        "lbrace" => "{",
        "rbrace" => "}",
        other => other,
    }
}

/// The units of lengths in TeX.
const LENGTHS: [&str; 9] = ["pt", "em", "ex", "mm", "cm", "in", "pc", "bp", "mu"];

/// Skips the star and the optional height of a row break, `\\*[2pt]`.
fn after_row_break(text: &str, mut end: usize) -> usize {
    if text[end..].starts_with('*') {
        end += 1;
    }
    let open = end + text[end..].len() - text[end..].trim_start_matches(' ').len();
    if text[open..].starts_with('[')
        && let Some(close) = text[open..].find(']')
    {
        let inside = text[open + 1..open + close].trim();
        let is_unit = if open == end {
            inside.ends_with(|c: char| c.is_ascii_alphabetic())
        } else {
            LENGTHS.iter().any(|unit| inside.ends_with(unit))
        };
        if is_unit && inside.len() <= 12 && inside.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '.') {
            return open + close + 1;
        }
    }
    end
}

/// A letter of mathematical italics as a plain letter.
fn upright(c: char) -> char {
    const GREEK: &str = "αβγδεζηθικλμνξοπρσστυφχψω";
    let nth = |letters: &str, at: u32| letters.chars().nth(at as usize).unwrap_or(c);
    match u32::from(c) {
        0x210E => 'h',
        code @ 0x1D434..=0x1D44D => char::from_u32(code - 0x1D434 + u32::from('A')).unwrap_or(c),
        code @ 0x1D44E..=0x1D467 => char::from_u32(code - 0x1D44E + u32::from('a')).unwrap_or(c),
        code @ 0x1D6E2..=0x1D6FA => nth("ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΘΣΤΥΦΧΨΩ", code - 0x1D6E2),
        code @ 0x1D6FC..=0x1D714 => nth(GREEK, code - 0x1D6FC),
        0x1D715 => '∂',
        0x1D719 => 'φ',
        _ => c,
    }
}

/// The command for a Greek letter or a sign typed directly.
fn greek(c: char) -> Option<&'static str> {
    Some(match c {
        'α' => "alpha",
        'β' => "beta",
        'γ' => "gamma",
        'δ' => "delta",
        'ε' => "epsilon",
        'ζ' => "zeta",
        'η' => "eta",
        'θ' => "theta",
        'ι' => "iota",
        'κ' => "kappa",
        'λ' => "lambda",
        'μ' => "mu",
        'ν' => "nu",
        'ξ' => "xi",
        'π' => "pi",
        'ρ' => "rho",
        'σ' => "sigma",
        'τ' => "tau",
        'φ' => "phi",
        'χ' => "chi",
        'ψ' => "psi",
        'ω' => "omega",
        'Γ' => "Gamma",
        'Δ' => "Delta",
        'Θ' => "Theta",
        'Λ' => "Lambda",
        'Ξ' => "Xi",
        'Π' => "Pi",
        'Σ' => "Sigma",
        'Φ' => "Phi",
        'Ψ' => "Psi",
        'Ω' => "Omega",
        'ħ' | 'ℏ' => "hbar",
        'ℓ' => "ell",
        '∂' => "partial",
        '∇' => "nabla",
        '∞' => "infty",
        '…' | '⋯' => "dots",
        '→' => "rightarrow",
        '⇒' | '⟹' => "Rightarrow",
        '∑' => "sum",
        '∏' => "prod",
        '∫' => "int",
        '∈' => "in",
        '±' => "pm",
        '∓' => "mp",
        '†' => "dagger",
        '⟨' => "langle",
        '⟩' => "rangle",
        '⊗' => "otimes",
        '∝' => "propto",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_span_is_the_text_of_its_token() {
        let text = "\\frac12 m\\,v^2 \\\\[2pt] θ";
        let spans: Vec<&str> = tokens(text).iter().map(|t| &text[t.span.range()]).collect();
        assert_eq!(spans, ["\\frac", "1", "2", "m", "\\,", "v", "^", "2", "\\\\[2pt]", "θ"]);
    }

    #[test]
    fn a_bracket_after_a_row_break_is_skipped_only_when_it_is_a_length() {
        assert_eq!(tokens("\\\\[x]").len(), 4);
        assert_eq!(tokens("\\\\[-.5em]").len(), 1);
    }
}
