//! The normalizer: rewrites legacy TeX and decoration into the forms that the layout parser reads.
//!
//! Legacy TeX is `{a \over b}` and `{\bf v}`. Decoration is a box around a result, colour, or words under a brace or
//! above a relation. Each rewritten token keeps its place, so that a fault is shown where the author wrote it. A
//! decoration with mathematics in it, `\underbrace{x}_{=0}`, is not changed, and the reader rejects it.

use crate::source::Span;

use super::lexer::{Space, Token, TokenKind};

/// The same tokens in normal form.
pub fn normalized(tokens: Vec<Token>) -> Vec<Token> {
    if !tokens.iter().any(is_old) {
        return tokens;
    }
    let (mut normalized, mut at) = (Vec::with_capacity(tokens.len()), 0);
    while at < tokens.len() {
        at = one(&tokens, at, &mut normalized);
    }
    normalized
}

fn is_old(token: &Token) -> bool {
    let TokenKind::Command(name) = &token.kind else { return false };
    let forms = [
        "\\over",
        "\\boxed",
        "\\fbox",
        "\\color",
        "\\textcolor",
        "\\underbrace",
        "\\overbrace",
        "\\stackrel",
        "\\overset",
        "\\displaylines",
        "\\arg",
        "\\require",
        "\\textbf",
    ];
    forms.contains(&name.as_str()) || switch(name).is_some()
}

/// The modern command for a legacy style switch. The inner value is `None` for a style without effect.
fn switch(name: &str) -> Option<Option<&'static str>> {
    match name {
        "\\bf" => Some(Some("\\mathbf")),
        "\\rm" | "\\sf" | "\\tt" => Some(Some("\\mathrm")),
        "\\cal" => Some(Some("\\mathcal")),
        "\\it" | "\\mit" => Some(None),
        _ => None,
    }
}

/// Rewrites the token or group at `at`. Returns the position of the next one.
fn one(tokens: &[Token], at: usize, into: &mut Vec<Token>) -> usize {
    let token = &tokens[at];
    let TokenKind::Command(name) = &token.kind else {
        if token.kind != TokenKind::Open {
            into.push(token.clone());
            return at + 1;
        }
        let Some(end) = closed(tokens, at) else {
            into.push(token.clone());
            return at + 1;
        };
        group(tokens, at, end, into);
        return end + 1;
    };
    let after = |at: usize| Some(at).filter(|at| tokens.get(*at).is_some_and(|next| next.kind == TokenKind::Open));
    let argument = |at: usize| after(at).and_then(|open| Some((open, closed(tokens, open)?)));
    match name.as_str() {
        "\\left" => sized(tokens, at, into),
        "\\boxed" | "\\fbox" | "\\displaylines" => match argument(at + 1) {
            Some((open, end)) => {
                unwrapped(tokens, open, end, into);
                end + 1
            }
            None => at + 1,
        },
        "\\textcolor" | "\\color" => match (argument(at + 1), name.as_str()) {
            (Some((_, end)), "\\color") => end + 1,
            (Some((_, end)), _) => match argument(end + 1) {
                Some((open, end)) => {
                    unwrapped(tokens, open, end, into);
                    end + 1
                }
                None => end + 1,
            },
            (None, _) => at + 1,
        },
        "\\underbrace" | "\\overbrace" => match argument(at + 1) {
            Some((open, end)) => braced(tokens, at, (open, end), into),
            None => at + 1,
        },
        // `\textbf{u}(t)`: a letter alone is a name.
        "\\textbf" if matches!(argument(at + 1), Some((open, end)) if is_letter(&tokens[open + 1..end])) => {
            into.push(Token { kind: TokenKind::Command("\\mathbf".to_owned()), span: token.span });
            at + 1
        }
        "\\require" => argument(at + 1).map_or(at + 1, |(_, end)| end + 1),
        "\\arg" => argument_of_an_extremum(tokens, at, into),
        "\\stackrel" | "\\overset" => stacked(tokens, at, argument, into),
        // `9.8\,\rm m\,s^{-2}`, `\rm kg`: the unit reaches to the end, as TeX sets it.
        "\\rm" if upright(tokens, at) > 0 => upright_unit(tokens, at, into),
        // `\bf v` outside of a group is taken for the style of what comes next.
        name if switch(name).is_some() => {
            let style = switch(name).flatten();
            into.extend(style.map(|style| Token { kind: TokenKind::Command(style.to_owned()), span: token.span }));
            at + 1
        }
        _ => {
            into.push(token.clone());
            at + 1
        }
    }
}

/// Rewrites `\arg\min`, `\arg\max` and their kin into one name. Returns the position of what follows.
fn argument_of_an_extremum(tokens: &[Token], at: usize, into: &mut Vec<Token>) -> usize {
    let spaces = tokens[at + 1..].iter().take_while(|token| token.kind == TokenKind::Space(Space::Thin)).count();
    let extremum = tokens.get(at + 1 + spaces).and_then(|token| match &token.kind {
        TokenKind::Command(name) if ["\\min", "\\max", "\\inf", "\\sup"].contains(&name.as_str()) => {
            Some((name, token.span))
        }
        _ => None,
    });
    let Some((name, end)) = extremum else {
        into.push(tokens[at].clone());
        return at + 1;
    };
    let span = tokens[at].span.to(end);
    let letters = format!("arg{}", &name[1..]);
    let name = [TokenKind::Command("\\mathrm".to_owned()), TokenKind::Open];
    let all = name.into_iter().chain(letters.chars().map(TokenKind::Letter)).chain([TokenKind::Close]);
    into.extend(all.map(|kind| Token { kind, span }));
    at + 2 + spaces
}

/// Rewrites what stands over or under a brace, without the brace, and leaves out its label. Returns the position of what follows.
fn braced(tokens: &[Token], at: usize, (open, end): (usize, usize), into: &mut Vec<Token>) -> usize {
    let token = &tokens[at];
    let labelled = end + 1 + words(&tokens[end + 1..]);
    // A label with mathematics in it is neither a power nor a subscript: the reader rejects the brace.
    let is_script = |token: &Token| matches!(token.kind, TokenKind::Sub | TokenKind::Super);
    // So it does where statements stand over the brace, which are no term.
    let inside = &tokens[open + 1..end];
    let is_statement = |at: &usize| is_relation(&inside[*at..=*at]) && depth(&inside[..*at]) == 0;
    if (0..inside.len()).any(|at| is_statement(&at)) {
        into.push(token.clone());
        group(tokens, open, end, into);
        return end + 1;
    }
    if tokens.get(labelled).is_some_and(is_script) {
        into.push(token.clone());
    }
    group(tokens, open, end, into);
    labelled
}

/// Rewrites a relation with something above it as the relation. Returns the position of what follows.
fn stacked(
    tokens: &[Token],
    at: usize,
    argument: impl Fn(usize) -> Option<(usize, usize)>,
    into: &mut Vec<Token>,
) -> usize {
    let token = &tokens[at];
    // A relation with a question mark above it states nothing.
    let is_mark = |token: &Token| token.kind == TokenKind::Other('?');
    let is_asked = |open: usize, end: usize| tokens[open..end].iter().any(is_mark);
    let label = argument(at + 1).filter(|(open, end)| !is_asked(*open, *end));
    if let Some((open, end)) = label
        && let (Some(accent), Some(_)) = (accent(&tokens[open + 1..end]), argument(end + 1))
    {
        into.push(Token { kind: TokenKind::Command(accent.to_owned()), span: token.span });
        return end + 1;
    }
    // `\stackrel{\mathrm{def}}=`
    if let Some((_, end)) = label
        && let Some(sign) = tokens.get(end + 1..end + 2).filter(|sign| is_relation(sign))
    {
        into.extend_from_slice(sign);
        return end + 2;
    }
    let relation = label.and_then(|(_, end)| argument(end + 1));
    match relation.filter(|(open, end)| is_relation(&tokens[open + 1..*end])) {
        Some((open, end)) => {
            into.extend_from_slice(&tokens[open + 1..end]);
            end + 1
        }
        None => {
            into.push(token.clone());
            at + 1
        }
    }
}

/// The accent that stands above a formula as a formula of its own: `\overset{..}{x}`.
fn accent(label: &[Token]) -> Option<&'static str> {
    let is_dot = |token: &Token| match &token.kind {
        TokenKind::Other('.') => true,
        TokenKind::Command(name) => name == "\\cdot",
        _ => false,
    };
    match label {
        [Token { kind: TokenKind::Command(name), .. }] if ["\\to", "\\rightarrow"].contains(&name.as_str()) => {
            Some("\\vec")
        }
        dots if dots.iter().all(is_dot) => ["\\dot", "\\ddot", "\\dddot"].get(dots.len().checked_sub(1)?).copied(),
        _ => None,
    }
}

/// Writes the letters behind `\rm` as one upright unit. Returns the position of what follows.
fn upright_unit(tokens: &[Token], at: usize, into: &mut Vec<Token>) -> usize {
    let token = &tokens[at];
    let end = at + 1 + upright(tokens, at);
    let brace = |kind: TokenKind| Token { kind, span: token.span };
    into.extend([brace(TokenKind::Command("\\mathrm".to_owned())), brace(TokenKind::Open)]);
    for next in at + 1..end {
        // `m s` is no millisecond.
        let is_letter = |at: usize| matches!(tokens[at].kind, TokenKind::Letter(_));
        if next > at + 1
            && is_letter(next - 1)
            && is_letter(next)
            && tokens[next - 1].span.end < tokens[next].span.start
        {
            into.push(brace(TokenKind::Space(Space::Thin)));
        }
        into.push(tokens[next].clone());
    }
    into.push(brace(TokenKind::Close));
    end
}

/// Rewrites what stands between `\left` and its `\right`, where TeX lets `\over` divide all there is, as in a group. Returns the
/// position of what follows.
fn sized(tokens: &[Token], at: usize, into: &mut Vec<Token>) -> usize {
    let is = |token: &Token, wanted: &str| matches!(&token.kind, TokenKind::Command(name) if name == wanted);
    let mut inner = 0_usize;
    let right = (at + 1..tokens.len()).find(|next| {
        let token = &tokens[*next];
        inner += usize::from(is(token, "\\left"));
        let closes = is(token, "\\right");
        let found = closes && inner == 0;
        inner -= usize::from(closes && inner > 0);
        found
    });
    let content = at + 2;
    let over = right.and_then(|right| {
        let is_over = |next: &usize| is(&tokens[*next], "\\over") && depth(&tokens[content..*next]) == 0;
        let is_outside = |next: &usize| {
            let count = |wanted: &str| tokens[content..*next].iter().filter(|token| is(token, wanted)).count();
            count("\\left") == count("\\right")
        };
        (content..right).find(|next| is_over(next) && is_outside(next)).map(|over| (over, right))
    });
    let Some((over, right)) = over else {
        into.push(tokens[at].clone());
        return at + 1;
    };
    let brace = |kind: TokenKind, span: Span| Token { kind, span };
    let span = tokens[over].span;
    let all = |from: usize, to: usize, into: &mut Vec<Token>| {
        let mut next = from;
        while next < to {
            next = one(&tokens[..to], next, into);
        }
    };
    into.extend([tokens[at].clone(), tokens[at + 1].clone(), brace(TokenKind::Command("\\frac".to_owned()), span)]);
    into.push(brace(TokenKind::Open, span));
    all(content, over, into);
    into.extend([brace(TokenKind::Close, span), brace(TokenKind::Open, span)]);
    all(over + 1, right, into);
    into.push(brace(TokenKind::Close, span));
    right
}

/// Rewrites a group: a fraction if it contains `\over`, one style if it begins with a style switch, else unchanged.
fn group(tokens: &[Token], open: usize, end: usize, into: &mut Vec<Token>) {
    let brace = |kind: TokenKind, span: Span| Token { kind, span };
    let command = |name: &str, span: Span| Token { kind: TokenKind::Command(name.to_owned()), span };
    let over = (open + 1..end).find(|at| {
        let is_over = matches!(&tokens[*at].kind, TokenKind::Command(name) if name == "\\over");
        is_over && depth(&tokens[open + 1..*at]) == 0
    });
    let all = |from: usize, to: usize, into: &mut Vec<Token>| {
        let mut at = from;
        while at < to {
            at = one(&tokens[..to], at, into);
        }
    };
    if let Some(over) = over {
        let span = tokens[over].span;
        into.extend([command("\\frac", span), tokens[open].clone()]);
        all(open + 1, over, into);
        into.extend([brace(TokenKind::Close, span), brace(TokenKind::Open, span)]);
        all(over + 1, end, into);
        into.push(tokens[end].clone());
        return;
    }
    let first = tokens.get(open + 1).filter(|_| open + 1 < end);
    let style = first.and_then(|first| match &first.kind {
        TokenKind::Command(name) => Some((switch(name)?, first.span)),
        _ => None,
    });
    let from = open + 1 + usize::from(style.is_some());
    if let Some((Some(name), span)) = style {
        into.push(command(name, span));
    }
    into.push(tokens[open].clone());
    all(from, end, into);
    into.push(tokens[end].clone());
}

/// The number of tokens after the `\rm` at `at` that are one upright word: all to the end if they are units, else the
/// letters of a first word, `\rm Tr A`; 0 for a lone letter and a differential, `\rm dx`.
fn upright(tokens: &[Token], at: usize) -> usize {
    let rest = &tokens[at + 1..];
    let all = &rest[..scope(rest)];
    let letter = |token: &Token| match token.kind {
        TokenKind::Letter(letter) => Some(letter),
        _ => None,
    };
    let touch = |pair: &[Token]| pair[0].span.end == pair[1].span.start && letter(&pair[1]).is_some();
    let word = |from: &[Token]| match from.first().and_then(letter) {
        Some(_) => 1 + from.windows(2).take_while(|pair| touch(pair)).count(),
        None => 0,
    };
    let (mut place, mut is_unit) = (0, !all.is_empty());
    while place < all.len() && is_unit {
        let length = word(&all[place..]);
        is_unit = match (length, &all[place].kind) {
            (0, TokenKind::Letter(_)) => false,
            (0, TokenKind::Command(name)) => ["\\cdot", "\\Omega", "\\mu"].contains(&name.as_str()),
            (0, _) => true,
            _ => {
                let word: String = all[place..place + length].iter().filter_map(letter).collect();
                word != "d" && names_a_unit(&word)
            }
        };
        place += length.max(1);
    }
    let first = word(rest);
    let is_after_a_number = tokens[..at].iter().rev().find(|token| !matches!(token.kind, TokenKind::Space(_)));
    let is_after_a_number = is_after_a_number.is_some_and(|token| matches!(token.kind, TokenKind::Digit(_)));
    match first {
        1 if is_unit && is_after_a_number => all.len(),
        2.. if is_unit => all.len(),
        2.. if rest.first().and_then(letter) != Some('d') => first,
        _ => 0,
    }
}

/// The number of tokens up to the end of the group, the cell, the row or the formula, or to a sign or a relation.
fn scope(tokens: &[Token]) -> usize {
    let mut depth = 0usize;
    let ends = |token: &Token| {
        match token.kind {
            TokenKind::Open => depth += 1,
            TokenKind::Close if depth == 0 => return true,
            TokenKind::Close => depth -= 1,
            TokenKind::Align | TokenKind::Row | TokenKind::Space(Space::Wide) => return true,
            TokenKind::Other('+' | '-' | ',' | ';' | '.' | ')' | ']') => return depth == 0,
            _ => return depth == 0 && is_relation(std::slice::from_ref(token)),
        }
        false
    };
    tokens.iter().position(ends).unwrap_or(tokens.len())
}

/// Rewrites a boxed formula. A box around a whole equation loses its braces.
fn unwrapped(tokens: &[Token], open: usize, end: usize, into: &mut Vec<Token>) {
    let inner = &tokens[open + 1..end];
    let relation = (0..inner.len()).any(|at| is_relation(&inner[at..=at]) && depth(&inner[..at]) == 0);
    // A box around all there is.
    let is_blank = |token: &Token| matches!(token.kind, TokenKind::Space(_) | TokenKind::Other('.' | ','));
    let is_whole = tokens[..open.saturating_sub(1)].iter().chain(&tokens[end + 1..]).all(is_blank);
    match relation || is_whole {
        true => {
            let mut at = open + 1;
            while at < end {
                at = one(&tokens[..end], at, into);
            }
        }
        false => group(tokens, open, end, into),
    }
}

/// The number of tokens of a leading script that is only text, `_{\text{spin}}`, `_{\mathrm{spin}}`.
fn words(tokens: &[Token]) -> usize {
    let is = |at: usize, kind: &TokenKind| tokens.get(at).is_some_and(|token| token.kind == *kind);
    let text = matches!(tokens.get(2).map(|token| &token.kind), Some(TokenKind::Command(name))
        if name == "\\text" || name == "\\mathrm");
    if !(is(0, &TokenKind::Sub) || is(0, &TokenKind::Super)) || !is(1, &TokenKind::Open) || !text {
        return 0;
    }
    let Some(end) = closed(tokens, 1) else { return 0 };
    match closed(tokens, 3) {
        Some(word) if word + 1 == end => end + 1,
        _ => 0,
    }
}

fn is_letter(tokens: &[Token]) -> bool {
    matches!(tokens, [Token { kind: TokenKind::Letter(_), .. }])
}

fn is_relation(tokens: &[Token]) -> bool {
    let [token] = tokens else { return false };
    match &token.kind {
        TokenKind::Other(c) => matches!(c, '=' | '<' | '>' | '≈' | '≡' | '≤' | '≥'),
        TokenKind::Command(name) => {
            matches!(name.as_str(), "\\equiv" | "\\approx" | "\\leq" | "\\geq" | "\\neq" | "\\propto" | "\\ll" | "\\gg")
        }
        _ => false,
    }
}

/// The position where the group that opens at `open` closes.
fn closed(tokens: &[Token], open: usize) -> Option<usize> {
    let mut depth = 0usize;
    for (at, token) in tokens.iter().enumerate().skip(open) {
        match token.kind {
            TokenKind::Open => depth += 1,
            TokenKind::Close => depth = depth.checked_sub(1)?,
            _ => {}
        }
        if depth == 0 {
            return (at > open).then_some(at);
        }
    }
    None
}

/// The number of groups that are open after these tokens.
fn depth(tokens: &[Token]) -> usize {
    let count = |kind: &TokenKind| tokens.iter().filter(|token| token.kind == *kind).count();
    count(&TokenKind::Open).saturating_sub(count(&TokenKind::Close))
}

/// Whether a word is a unit.
#[cfg(feature = "notes")]
fn names_a_unit(word: &str) -> bool {
    crate::formula::units::parse(word).is_ok()
}

/// Whether a word is a unit. Names alone, which are all that is read without notes, have none.
#[cfg(not(feature = "notes"))]
fn names_a_unit(_word: &str) -> bool {
    false
}

#[cfg(test)]
mod tests;
