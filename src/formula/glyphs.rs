//! LaTeX names and templates as Unicode: Greek letters as letters, accents as combining marks.

/// A LaTeX name as Unicode: Greek letters as letters, accents as combining marks.
pub fn plain(latex: &str) -> String {
    if let Some((above, below)) = derivative(latex) {
        return format!("∂{}/∂{}", plain(above), plain(below));
    }
    let mut text = String::new();
    let mut rest = latex;
    while let Some(at) = rest.find('\\') {
        text.push_str(&rest[..at]);
        let command = &rest[at + 1..];
        let length = command.bytes().take_while(u8::is_ascii_alphabetic).count();
        let name = &command[..length];
        rest = &command[length..];
        if let Some(mark) = mark(name)
            && let Some(inner) = rest.strip_prefix('{')
            && let Some(close) = matching(inner)
        {
            match alphabet(name, &inner[..close]) {
                Some(letter) => text.push(letter),
                None => text.push_str(&plain(&inner[..close])),
            }
            text.push_str(mark);
            rest = &inner[close + 1..];
            continue;
        }
        if name == "frac"
            && let Some((above, below, after)) = fraction(rest)
        {
            let grouped = |part: &str| match part.contains(['+', '-', ' ']) && part.contains(['+', '-']) {
                true => format!("({})", plain(part)),
                false => plain(part.trim()),
            };
            text.push_str(&format!("{}/{}", grouped(above), grouped(below)));
            rest = after;
            continue;
        }
        if name == "binom"
            && let Some((above, below, after)) = fraction(rest)
        {
            text.push_str(&format!("binom({}, {})", plain(above), plain(below)));
            rest = after;
            continue;
        }
        match letter(name) {
            Some(letter) => {
                text.push(letter);
                if letter.is_alphabetic() || ['∂', '⟨'].contains(&letter) {
                    rest = rest.strip_prefix(' ').unwrap_or(rest);
                }
            }
            None => match name {
                "lim" | "max" | "min" | "sup" | "inf" | "arg" | "log" => text.push_str(name),
                // Sizes and spaces print nothing.
                "left" | "right" => {}
                // `\{` and `\,`
                "" => {
                    let next = rest.chars().next().unwrap_or_default();
                    rest = &rest[next.len_utf8()..];
                    text.push(if next == ',' { ' ' } else { next });
                }
                _ => {
                    text.push('\\');
                    text.push_str(name);
                }
            },
        }
    }
    text.push_str(rest);
    // The empty base of a script that stands alone.
    subscripts(&text.replace("{}", "").replace("{ ", "{").replace(" }", "}"))
}

/// What stands above and below in the name of a derivative, `\frac{\partial L}{\partial \dot q}`.
fn derivative(latex: &str) -> Option<(&str, &str)> {
    let above = latex.strip_prefix("\\frac{\\partial ")?;
    let close = matching(above)?;
    let below = above[close + 1..].strip_prefix("{\\partial ")?.strip_suffix('}')?;
    Some((&above[..close], below)).filter(|(above, below)| !above.contains("\\partial") && !below.contains("\\partial"))
}

/// A name in which a subscript has a number as its own subscript: `p_{θ_{1}}` becomes p_θ₁.
fn subscripts(name: &str) -> String {
    let Some((head, rest)) = name.split_once("_{") else { return name.to_owned() };
    let Some(close) = matching(rest) else { return name.to_owned() };
    let (inner, after) = (&rest[..close], subscripts(&rest[close + 1..]));
    let lowered = inner.split_once('_').and_then(|(letter, number)| {
        let number = number.strip_prefix('{').and_then(|number| number.strip_suffix('}')).unwrap_or(number);
        let digits: Option<String> = number.chars().map(|c| char::from_u32(u32::from('₀') + c.to_digit(10)?)).collect();
        Some(format!("{letter}{}", digits.filter(|digits| !digits.is_empty())?))
    });
    match lowered {
        Some(lowered) => format!("{head}_{lowered}{after}"),
        None => format!("{head}_{{{inner}}}{after}"),
    }
}

fn matching(inner: &str) -> Option<usize> {
    let mut depth = 0;
    inner.char_indices().find_map(|(at, c)| match c {
        '{' => {
            depth += 1;
            None
        }
        '}' if depth == 0 => Some(at),
        '}' => {
            depth -= 1;
            None
        }
        _ => None,
    })
}

/// The parts of `{above}{below}`, and what follows them.
fn fraction(text: &str) -> Option<(&str, &str, &str)> {
    let above = text.strip_prefix('{')?;
    let end = matching(above)?;
    let below = above[end + 1..].strip_prefix('{')?;
    let close = matching(below)?;
    Some((&above[..end], &below[..close], &below[close + 1..]))
}

fn mark(command: &str) -> Option<&'static str> {
    Some(match command {
        "dot" => "\u{307}",
        "ddot" => "\u{308}",
        "vec" => "\u{20d7}",
        "hat" => "\u{302}",
        "bar" => "\u{304}",
        "tilde" => "\u{303}",
        "mathring" => "\u{30a}",
        "slashed" => "\u{338}",
        "underline" => "\u{332}",
        "overleftrightarrow" => "\u{20e1}",
        "mathbf" | "mathrm" | "mathbb" | "mathcal" | "mathfrak" | "mathscr" | "text" => "",
        _ => return None,
    })
}

/// A letter of another alphabet, so that 𝒜 and A are not printed alike.
fn alphabet(command: &str, inner: &str) -> Option<char> {
    let mut letters = inner.chars();
    let (letter, None) = (letters.next()?, letters.next()) else { return None };
    let (capitals, smalls, others) = match command {
        // Letters that Unicode had before the alphabet have other places.
        "mathcal" | "mathscr" => ('𝒜', '𝒶', "BℬEℰFℱHℋIℐLℒMℳRℛeℯgℊoℴ"),
        "mathfrak" => ('𝔄', '𝔞', "CℭHℌIℑRℜZℨ"),
        _ => return None,
    };
    let pairs: Vec<char> = others.chars().collect();
    if let [_, other] = pairs.chunks(2).find(|pair| pair[0] == letter).unwrap_or_default() {
        return Some(*other);
    }
    let (first, at) = match letter {
        'A'..='Z' => (capitals, letter as u32 - u32::from('A')),
        'a'..='z' => (smalls, letter as u32 - u32::from('a')),
        _ => return None,
    };
    char::from_u32(u32::from(first) + at)
}

/// The commands that print one character, without the backslash.
const LETTERS: [(&str, char); 134] = [
    ("sum", 'Σ'),
    ("prod", 'Π'),
    ("int", '∫'),
    ("oint", '∮'),
    ("iint", '∬'),
    ("nabla", '∇'),
    ("partial", '∂'),
    ("dots", '…'),
    ("cdot", '·'),
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ϵ'),
    ("varepsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("vartheta", 'ϑ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("varphi", 'ϕ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Xi", 'Ξ'),
    ("Pi", 'Π'),
    ("Sigma", 'Σ'),
    ("Upsilon", 'Υ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
    ("ell", 'ℓ'),
    ("hbar", 'ħ'),
    ("infty", '∞'),
    ("perp", '⊥'),
    ("langle", '⟨'),
    ("rangle", '⟩'),
    ("otimes", '⊗'),
    ("wedge", '∧'),
    ("oplus", '⊕'),
    ("circ", '∘'),
    ("ast", '∗'),
    ("star", '⋆'),
    ("dagger", '†'),
    ("top", '⊤'),
    ("parallel", '∥'),
    ("in", '∈'),
    ("notin", '∉'),
    ("ni", '∋'),
    ("subset", '⊂'),
    ("subseteq", '⊆'),
    ("supset", '⊃'),
    ("cup", '∪'),
    ("cap", '∩'),
    ("setminus", '∖'),
    ("emptyset", '∅'),
    ("sim", '∼'),
    ("cong", '≅'),
    ("ll", '≪'),
    ("gg", '≫'),
    ("neq", '≠'),
    ("leq", '≤'),
    ("geq", '≥'),
    ("times", '×'),
    ("rightarrow", '→'),
    ("longrightarrow", '⟶'),
    ("longmapsto", '⟼'),
    ("longleftarrow", '⟵'),
    ("leftarrow", '←'),
    ("leftrightarrow", '↔'),
    ("uparrow", '↑'),
    ("downarrow", '↓'),
    ("nearrow", '↗'),
    ("searrow", '↘'),
    ("Rightarrow", '⟹'),
    ("Leftrightarrow", '⟺'),
    ("mapsto", '↦'),
    ("forall", '∀'),
    ("exists", '∃'),
    ("vdots", '⋮'),
    ("ddots", '⋱'),
    ("colon", ':'),
    ("mid", '|'),
    ("pm", '±'),
    ("mp", '∓'),
    ("Box", '□'),
    ("prime", '′'),
    ("deg", '°'),
    ("propto", '∝'),
    ("approx", '≈'),
    ("equiv", '≡'),
    ("bullet", '•'),
    ("odot", '⊙'),
    ("ominus", '⊖'),
    ("square", '□'),
    ("blacksquare", '■'),
    ("diamond", '⋄'),
    ("bigstar", '★'),
    ("flat", '♭'),
    ("land", '∧'),
    ("lor", '∨'),
    ("neg", '¬'),
    ("backslash", '∖'),
    ("prec", '≺'),
    ("preceq", '⪯'),
    ("succ", '≻'),
    ("succeq", '⪰'),
    ("sharp", '♯'),
    ("bot", '⊥'),
    ("lesssim", '≲'),
    ("gtrsim", '≳'),
    ("iiint", '∭'),
    ("oiint", '∯'),
    ("varpi", 'ϖ'),
    ("vert", '|'),
    ("Vert", '‖'),
    ("therefore", '∴'),
    ("underbrace", '⏟'),
    ("overbrace", '⏞'),
];

fn letter(command: &str) -> Option<char> {
    LETTERS.iter().find(|(name, _)| *name == command).map(|(_, letter)| *letter)
}

/// A name with its overdots, as a combining mark over the letter.
pub fn with_dots(latex: &str, dots: u8) -> String {
    let name = plain(latex);
    let mark = match dots {
        0 => return name,
        1 => '\u{307}',
        2 => '\u{308}',
        3 => '\u{20db}',
        _ => '\u{20dc}',
    };
    let at = name.find('_').unwrap_or(name.len());
    format!("{}{mark}{}", &name[..at], &name[at..])
}
