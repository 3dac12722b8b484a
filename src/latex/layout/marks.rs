//! Marks that authors set in several ways: the d and ∂ of a derivative in bold or as a word, `\mathbf{\partial B}`, `\text{d}`; bold signs of products;
//! `\_` for a subscript; two bars of a bra and a ket; the bar of a place; the bars of a norm, `||x||`; the sign at the end of a proof.

use super::super::lexer::{Space, Token, TokenKind};

/// The same tokens, where each of these marks has its usual form.
pub(super) fn with_plain_marks(tokens: Vec<Token>) -> Vec<Token> {
    let mut found: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut open_bars = 0_usize;
    // The `||` at which a norm ends.
    let mut end_of_norm = None;
    let mut bars = 0_usize;
    // For each open brace, whether it is that of a text.
    let mut braces: Vec<bool> = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        let token = &tokens[at];
        let span = token.span;
        match token.kind {
            TokenKind::Open => braces.push(is_text(at.checked_sub(1).and_then(|before| tokens.get(before)))),
            TokenKind::Close => drop(braces.pop()),
            _ => {}
        }
        // `\_`, as Markdown needs it in formulas.
        if is(Some(token), "\\_") && !braces.contains(&true) {
            found.push(Token { kind: TokenKind::Sub, span });
            at += 1;
            continue;
        }
        if let Some(length) = differential_in_bold(&tokens[at..]) {
            // The style belongs to what is differentiated: `\partial\mathbf{B}`.
            found.extend([tokens[at + 2].clone(), token.clone(), tokens[at + 1].clone()]);
            found.extend_from_slice(&tokens[at + 3..at + length]);
            at += length;
            continue;
        }
        if let Some(length) = bold_d_of_an_integral(&tokens[..at], &tokens[at..]) {
            let command = TokenKind::Command("\\mathrm".to_owned());
            found.push(Token { kind: command, span });
            found.extend_from_slice(&tokens[at + 1..at + length]);
            at += length;
            continue;
        }
        // `5000\,\AA`: the unit of a length.
        if is(Some(token), "\\AA") && !braces.contains(&true) {
            let text = TokenKind::Command("\\text".to_owned());
            let kinds = [text, TokenKind::Open, token.kind.clone(), TokenKind::Close];
            found.extend(kinds.map(|kind| Token { kind, span }));
            at += 1;
            continue;
        }
        if let Some(length) = operator_in_text(&tokens[at..]) {
            found.push(Token { kind: TokenKind::Command("\\mathrm".to_owned()), span });
            found.push(tokens[at + 1].clone());
            found.extend(
                tokens[at + 2..at + length].iter().filter(|token| !matches!(token.kind, TokenKind::Space(_))).cloned(),
            );
            at += length;
            continue;
        }
        if let Some(mark) = upright_mark(&tokens[..at], &tokens[at..]) {
            found.extend(mark.into_iter().map(|kind| Token { kind, span }));
            at += 4;
            continue;
        }
        // `A^\#`, the pseudoinverse
        if is(Some(token), "\\#") && found.last().is_some_and(|before| before.kind == TokenKind::Super) {
            found.push(Token { kind: TokenKind::Command("\\sharp".to_owned()), span });
            at += 1;
            continue;
        }
        // `\mathbb{SE}(3)` is the group that others write upright.
        if is(Some(token), "\\mathbb") && is_word_in_braces(&tokens[at + 1..]) {
            found.push(Token { kind: TokenKind::Command("\\mathrm".to_owned()), span });
            at += 1;
            continue;
        }
        // `\boldsymbol{\cdot}`
        if let [style, open, sign, close, ..] = &tokens[at..]
            && is(Some(style), "\\mathbf")
            && open.kind == TokenKind::Open
            && close.kind == TokenKind::Close
            && ["\\cdot", "\\times", "\\otimes", "\\wedge"].iter().any(|name| is(Some(sign), name))
        {
            found.push(sign.clone());
            at += 4;
            continue;
        }
        if is_end_of_proof(token) && tokens[at + 1..].iter().all(is_blank) {
            at += 1;
            continue;
        }
        if bars.is_multiple_of(2) && end_of_norm.is_none() {
            end_of_norm = norm_length(&tokens[at..]).map(|length| at + length);
        }
        if end_of_norm == Some(at) || end_of_norm.is_some() && is_double_bar(&tokens[at..]) {
            end_of_norm = end_of_norm.filter(|end| *end != at);
            found.push(Token { kind: TokenKind::Command("\\|".to_owned()), span: span.to(tokens[at + 1].span) });
            at += 2;
            continue;
        }
        bars += usize::from(token.kind == TokenKind::Other('|'));
        match &token.kind {
            // `\big\vert_{x=a}`
            TokenKind::Command(name)
                if name == "\\vert" && tokens.get(at + 1).is_some_and(|next| next.kind == TokenKind::Sub) =>
            {
                found.push(Token { kind: TokenKind::Other('|'), span });
                at += 1;
                continue;
            }
            // `\lvert\psi\rangle`, `\langle\psi\rvert`: the bars of states.
            TokenKind::Command(name)
                if name == "\\lvert" && opens_a_ket(&tokens[at + 1..])
                    || name == "\\rvert" && open_bars == 0 && is_in_angles(&found) =>
            {
                found.push(Token { kind: TokenKind::Other('|'), span });
                at += 1;
                continue;
            }
            TokenKind::Command(name) if name == "\\lvert" => open_bars += 1,
            // `\biggr\rvert_{x=a}`: nothing opens it.
            TokenKind::Command(name) if name == "\\rvert" => match open_bars.checked_sub(1) {
                Some(less) => open_bars = less,
                None if tokens.get(at + 1).is_some_and(|next| next.kind == TokenKind::Sub) => {
                    found.push(Token { kind: TokenKind::Other('|'), span });
                    at += 1;
                    continue;
                }
                None => {}
            },
            // `\bra{a}\ket{b}` prints one bar. What a command prints has the place of the command.
            TokenKind::Other('|') if span.range().len() > 1 => {
                let last = found.last();
                if last.is_some_and(|last| last.kind == TokenKind::Other('|') && last.span.range().len() > 1) {
                    at += 1;
                    continue;
                }
            }
            _ => {}
        }
        found.push(token.clone());
        at += 1;
    }
    found
}

/// Whether at least two capitals stand alone in braces.
fn is_word_in_braces(tokens: &[Token]) -> bool {
    let [open, rest @ ..] = tokens else { return false };
    let letters = rest.iter().take_while(|token| matches!(token.kind, TokenKind::Letter('A'..='Z'))).count();
    open.kind == TokenKind::Open && letters > 1 && rest.get(letters).is_some_and(|token| token.kind == TokenKind::Close)
}

/// Whether a bracket of a state is the next delimiter that closes, and no bar.
fn opens_a_ket(tokens: &[Token]) -> bool {
    let is_mark = |token: &&Token| {
        token.kind == TokenKind::Other('|')
            || ["\\lvert", "\\rvert", "\\vert", "\\langle", "\\rangle"].iter().any(|name| is(Some(*token), name))
    };
    tokens.iter().find(is_mark).is_some_and(|token| is(Some(token), "\\rangle"))
}

/// Whether an angle bracket is open.
fn is_in_angles(tokens: &[Token]) -> bool {
    let is_angle = |token: &&Token| is(Some(*token), "\\langle") || is(Some(*token), "\\rangle");
    tokens.iter().rev().find(is_angle).is_some_and(|token| is(Some(token), "\\langle"))
}

/// Whether two bars touch.
fn is_double_bar(tokens: &[Token]) -> bool {
    matches!(tokens, [first, second, ..] if first.kind == TokenKind::Other('|')
        && second.kind == TokenKind::Other('|')
        && first.span.end == second.span.start)
}

/// The number of tokens before the second `||` of `||x||`, in which no other bar stands.
fn norm_length(tokens: &[Token]) -> Option<usize> {
    if !is_double_bar(tokens) {
        return None;
    }
    let next = 2 + tokens[2..].iter().position(|token| token.kind == TokenKind::Other('|'))?;
    let is_closed = tokens[2..next].iter().filter(|token| token.kind == TokenKind::Open).count()
        == tokens[2..next].iter().filter(|token| token.kind == TokenKind::Close).count();
    (next > 2 && is_closed && is_double_bar(&tokens[next..])).then_some(next)
}

/// The number of tokens of `\mathbf{\partial B}` or `\vec{dl}`.
fn differential_in_bold(tokens: &[Token]) -> Option<usize> {
    let [style, open, mark, rest @ ..] = tokens else { return None };
    let is_style = ["\\mathbf", "\\boldsymbol", "\\bm", "\\vec"].iter().any(|name| is(Some(style), name));
    if !is_style || open.kind != TokenKind::Open {
        return None;
    }
    let close = rest.iter().position(|token| token.kind == TokenKind::Close)?;
    let is_name = |token: &Token| matches!(token.kind, TokenKind::Letter(_) | TokenKind::Command(_));
    let is_one = match mark.kind {
        TokenKind::Letter('d') => close == 1,
        _ => is(Some(mark), "\\partial") && close > 0,
    };
    let is_flat = rest[..close].iter().all(|token| token.kind != TokenKind::Open);
    (is_one && is_flat && rest.first().is_some_and(is_name)).then_some(close + 4)
}

/// The number of tokens of a bold d before a letter, `\int P\,\mathbf{d}V`, behind an integral that has no differential before it: an
/// integral needs one.
fn bold_d_of_an_integral(before: &[Token], tokens: &[Token]) -> Option<usize> {
    let is_d = |token: Option<&Token>| token.is_some_and(|token| token.kind == TokenKind::Letter('d'));
    let is_bold = ["\\mathbf", "\\boldsymbol", "\\bm"].iter().any(|name| is(tokens.first(), name));
    let length = match tokens.get(1).map(|token| &token.kind) {
        Some(TokenKind::Open) if is_d(tokens.get(2)) && tokens.get(3)?.kind == TokenKind::Close => 4,
        Some(TokenKind::Letter('d')) => 2,
        _ => return None,
    };
    let is_letter = |token: &Token| match &token.kind {
        TokenKind::Letter(_) => true,
        TokenKind::Command(name) => !["\\cdot", "\\times", "\\right", "\\frac", "\\end"].contains(&name.as_str()),
        _ => false,
    };
    let sign = before.iter().rposition(|token| {
        matches!(&token.kind, TokenKind::Command(name) if name.ends_with("int") && name.len() < "\\iiiint".len())
    })?;
    let ends = |token: &Token| {
        matches!(token.kind, TokenKind::Other('=' | '<' | '>') | TokenKind::Row | TokenKind::Align)
            || is(Some(token), "\\quad")
    };
    let between = &before[sign + 1..];
    let after = tokens.get(length..)?;
    let after = &after[..after.iter().position(ends).unwrap_or(after.len())];
    let has_other = |tokens: &[Token]| {
        tokens.windows(2).any(|pair| is_d(pair.first()) && is_letter(&pair[1]))
            || tokens.windows(3).any(|three| is(three.first(), "\\mathrm") && is_d(three.get(2)))
    };
    let is_first = !between.iter().any(ends) && !has_other(between) && !has_other(after);
    (is_bold && is_first && after.first().is_some_and(is_letter)).then_some(length)
}

/// The number of tokens of an operator in `\text{…}`, `\text{Tr}\,A`, before a formula: it is the operator that others write upright.
fn operator_in_text(tokens: &[Token]) -> Option<usize> {
    const OPERATORS: [&str; 9] = ["Tr", "tr", "det", "rank", "Re", "Im", "grad", "div", "rot"];
    if !is(tokens.first(), "\\text") || tokens.get(1)?.kind != TokenKind::Open {
        return None;
    }
    let close = 2 + tokens[2..].iter().position(|token| token.kind == TokenKind::Close)?;
    let letter = |token: &Token| match token.kind {
        TokenKind::Letter(letter) => Some(Some(letter)),
        TokenKind::Space(_) => Some(None),
        _ => None,
    };
    let letters: Option<Vec<Option<char>>> = tokens[2..close].iter().map(letter).collect();
    let word: String = letters?.into_iter().flatten().collect();
    let next = tokens[close + 1..].iter().find(|token| token.kind != TokenKind::Space(Space::Thin))?;
    // `\text{Re}\,\text{Pr}` is a product of numbers, and `\text{Re} \approx 2300` no operator.
    const OTHERS: [&str; 22] = [
        "\\text", "\\mathrm", "\\sqrt", "\\frac", "\\left", "\\right", "\\cdot", "\\times", "\\approx", "\\sim",
        "\\simeq", "\\leq", "\\geq", "\\ll", "\\gg", "\\equiv", "\\propto", "\\to", "\\end", "\\le", "\\ge", "\\in",
    ];
    let is_formula = match &next.kind {
        TokenKind::Letter(_) => true,
        TokenKind::Command(name) => !OTHERS.contains(&name.as_str()),
        _ => false,
    };
    (is_formula && OPERATORS.contains(&word.as_str())).then_some(close + 1)
}

/// The kinds of the tokens for `\text{d}` alone in a numerator, `\mathrm{\delta}` and the like, which are four tokens.
fn upright_mark(before: &[Token], tokens: &[Token]) -> Option<Vec<TokenKind>> {
    let [style, open, mark, close, rest @ ..] = tokens else { return None };
    let is_upright = is(Some(style), "\\mathrm") || is(Some(style), "\\text");
    if !is_upright || open.kind != TokenKind::Open || close.kind != TokenKind::Close {
        return None;
    }
    if ["\\delta", "\\Delta", "\\partial"].iter().any(|name| is(Some(mark), name)) {
        return Some(vec![mark.kind.clone()]);
    }
    let is_alone = before.last().is_some_and(|before| before.kind == TokenKind::Open)
        && rest.first().is_some_and(|next| matches!(next.kind, TokenKind::Close | TokenKind::Super));
    let command = TokenKind::Command("\\mathrm".to_owned());
    (mark.kind == TokenKind::Letter('d') && is_alone && is(Some(style), "\\text"))
        .then(|| vec![command, TokenKind::Open, mark.kind.clone(), TokenKind::Close])
}

/// Whether the brace after a token is that of a text.
fn is_text(before: Option<&Token>) -> bool {
    ["\\text", "\\mathrm", "\\mathtt"].iter().any(|name| is(before, name))
}

fn is_end_of_proof(token: &Token) -> bool {
    ["\\blacksquare", "\\qed", "\\qedsymbol"].iter().any(|name| is(Some(token), name))
}

fn is_blank(token: &Token) -> bool {
    matches!(token.kind, TokenKind::Space(_) | TokenKind::Other('.' | ',') | TokenKind::Close)
        || is(Some(token), "\\end")
        || is_end_of_proof(token)
}

fn is(token: Option<&Token>, command: &str) -> bool {
    matches!(token.map(|token| &token.kind), Some(TokenKind::Command(name)) if name == command)
}
