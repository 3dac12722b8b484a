//! Evidence in a display without declarations: letters that must be matrices, columns or complex numbers, and whether i is
//! √−1.
//!
//! A name is a matrix if it equals a written matrix, if it stands under `\det` or `\operatorname{tr}` and is bold or a
//! capital, if it is a bold capital that is transposed, inverted or followed by another bold letter, or if it stands
//! between x^T and x. The letter i is √−1 in the exponent of e, beside ħ, squared, or upright, unless it is an index
//! somewhere in the display. So is an upright j, and a j by the evidence of [`super::engineering`].

use crate::formula::symbols::{Kind, Name, Symbols};
use crate::source::Span;

use super::super::super::layout::{Delimiter, Item, Layout};
use super::super::super::names::{self, Printed};
use super::super::super::rows::relation;
use super::super::items::{contents, is_minus_one, is_transpose, parts};
use super::engineering;
use super::matrices::operator_word;

/// Notes in the table what a display says of its letters.
pub fn note(items: &[Item], symbols: &mut Symbols) {
    // Beside each other an upright i and j are directions.
    let is_direction = has_upright(items, 'i') && has_upright(items, 'j');
    symbols.imaginary_here = !is_direction && has_imaginary_unit(items);
    symbols.inferred.imaginary_factor = !is_direction && is_evident(items);
    symbols.inferred.i_is_index = !symbols.imaginary_here && is_index(items);
    symbols.imaginary_j_here = engineering::is_imaginary(items) && !symbols.imaginary_here;
    if !symbols.open {
        return;
    }
    let mut found = Vec::new();
    collect(items, &mut found);
    // `e = …` says what e is: no number is defined.
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    if let [first, second, ..] = solid.as_slice()
        && first.layout == Layout::Letter('e')
        && second.layout == Layout::Other('=')
    {
        found.push((Name::plain("e"), Kind::Scalar));
    }
    for (name, kind) in found {
        if symbols.find(&name).is_none() {
            symbols.add(name, kind);
        }
    }
}

/// A matrix of an unknown size.
const SQUARE: Kind = Kind::Matrix(0, 0);

fn name_of(item: &Item) -> Option<Printed<'_>> {
    names::printed(item, None).filter(|printed| printed.name.primes == 0)
}

fn is_bold(name: &Name) -> bool {
    name.base.starts_with("\\mathbf{")
}

/// A capital Latin letter, bold perhaps.
fn is_capital(name: &Name) -> bool {
    let letter = name.base.strip_prefix("\\mathbf{").and_then(|base| base.strip_suffix('}')).unwrap_or(&name.base);
    matches!(letter.as_bytes(), [b'A'..=b'Z']) || is_greek_capital(letter)
}

/// Λ and its like, which stand for matrices too.
fn is_greek_capital(letter: &str) -> bool {
    ["\\Lambda", "\\Sigma", "\\Omega", "\\Gamma", "\\Phi", "\\Psi", "\\Theta"].contains(&letter)
}

fn collect(items: &[Item], found: &mut Vec<(Name, Kind)>) {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    for (at, item) in solid.iter().enumerate() {
        if let Some(Printed { name, sup: Some(sup), .. }) = name_of(item)
            && is_bold(&name)
            && is_capital(&name)
            && (is_transpose(sup) || is_minus_one(sup))
        {
            found.push((name, SQUARE));
        }
        let word = operator_word(item);
        if let (Some("det" | "tr" | "Tr"), Some(argument)) = (word.as_deref(), solid.get(at + 1)) {
            let inside = match &argument.layout {
                Layout::Fence(_, inside) => inside.as_slice(),
                _ => std::slice::from_ref(*argument),
            };
            let matrices = inside.iter().filter_map(name_of).filter(|printed| is_capital(&printed.name));
            // `I` is the unit matrix beside another.
            found.extend(matrices.filter(|printed| printed.name.base != "I").map(|printed| (printed.name, SQUARE)));
        }
        let is_defined = matches!(solid.get(at + 1).map(|next| &next.layout), Some(Layout::Other(':')));
        let equal = at + 1 + usize::from(is_defined);
        if let (Some([sign, right, rest @ ..]), Some(Printed { name, sup: None, .. })) =
            (solid.get(equal..), name_of(item))
            && relation(sign).is_some()
            && (at == 0 || is_break(solid[at - 1]))
            && let Some((rows, columns)) = diagonal(right, rest).or_else(|| size_of_product(&solid[equal + 1..]))
        {
            let kind = match (rows, columns) {
                (1, 1) => Kind::Scalar,
                (3, 1) => Kind::Vector,
                _ => Kind::Matrix(rows, columns),
            };
            found.push((name, kind));
        }
        // `(K - \omega^2 M) a`: the bold capitals in the parenthesis are matrices.
        if let (Layout::Fence(_, inside), Some(second)) =
            (&item.layout, solid.get(at + 1).and_then(|next| name_of(next)))
            && is_bold(&second.name)
        {
            let inside: Vec<Printed<'_>> =
                inside.iter().filter_map(name_of).filter(|found| is_bold(&found.name)).collect();
            if inside.iter().all(|found| is_capital(&found.name)) {
                found.extend(inside.into_iter().filter(|found| found.sup.is_none()).map(|found| (found.name, SQUARE)));
            }
        }
        if let (Some(first), Some(second)) = (name_of(item), solid.get(at + 1).and_then(|next| name_of(next)))
            && first.sup.is_none()
            && is_bold(&first.name)
            && is_capital(&first.name)
            && is_bold(&second.name)
        {
            found.push((first.name, SQUARE));
        }
        quadratic_form(&solid[at..], found);
        found.extend(of_eigenvectors(&solid, at).map(|name| (name, SQUARE)));
        if let (Some(Printed { name, sup: Some(sup), dots: 0 }), Some(next)) = (name_of(item), solid.get(at + 1))
            && is_capital(&name)
            && (is_transpose(sup) && is_bold_item(next) || is_minus_one(sup) && has_transposed(next))
        {
            found.push((name, SQUARE));
        }
        if let (Some(first), Some(second)) = (name_of(item), solid.get(at + 1).and_then(|next| name_of(next)))
            && ["z", "w"].contains(&first.name.base.as_str())
            && second.name.base == format!("\\bar{{{}}}", first.name.base)
        {
            found.push((first.name, Kind::Complex));
        }
        if let (Some(Printed { name, dots: 0, sup: None }), Some(next)) = (name_of(item), solid.get(at + 1))
            && let Some(Printed { name: other, dots: 0, sup: Some(sup) }) = name_of(next)
            && name == other
            && is_star(sup)
        {
            found.push((name, Kind::Complex));
        }
        if let (Some(Printed { name, dots: 0, sup: Some(sup) }), Some(next)) = (name_of(item), solid.get(at + 1))
            && let Some(Printed { name: other, dots: 0, sup: None }) = name_of(next)
            && name == other
            && is_star(sup)
        {
            found.push((name, Kind::Complex));
        }
    }
    for item in items {
        for inside in parts(item) {
            collect(inside, found);
        }
    }
}

/// The A of `A\mathbf{v} = \lambda\mathbf{v}`, at the relation: one capital before the same vector as on the other side, where no number
/// of one letter would say anything.
fn of_eigenvectors(solid: &[&Item], at: usize) -> Option<Name> {
    relation(solid[at])?;
    let plain =
        |item: &Item| name_of(item).filter(|found| found.sup.is_none() && found.dots == 0).map(|found| found.name);
    let start = solid[..at].iter().rposition(|item| is_break(item)).map_or(0, |before| before + 1);
    let end = solid[at + 1..].iter().position(|item| is_break(item)).map_or(solid.len(), |after| at + 1 + after);
    let [first, second] = &solid[start..at] else { return None };
    let (matrix, vector) = (plain(first)?, plain(second)?);
    let (last, others) = solid[at + 1..end].split_last()?;
    let [value] = others else { return None };
    let value = plain(value)?;
    // Beside plain letters only an eigenvalue says so: `M g = m g` is about two masses.
    let is_eigenvalue = ["\\lambda", "\\mu"].contains(&value.base.as_str());
    let is_wave = ["\\psi", "\\Psi"].contains(&vector.base.as_str());
    let is_vector = is_bold(&vector)
        || vector.base.starts_with("\\vec{")
        || is_wave
        || is_eigenvalue && matches!(vector.base.as_bytes(), [b'a'..=b'z']);
    let is_twin = value.base.eq_ignore_ascii_case(&matrix.base);
    let is_matrix = is_capital(&matrix) && !is_greek_capital(&matrix.base) && !is_twin;
    (is_matrix && is_vector && plain(last)? == vector).then_some(matrix)
}

fn is_bold_item(item: &Item) -> bool {
    name_of(item).is_some_and(|found| is_bold(&found.name) || found.name.base.starts_with("\\vec{"))
}

/// A parenthesis in which a letter is transposed, `M^{-1}(J^T\mathbf{F} - \mathbf{V})`. Before a vector alone M may be a mass.
fn has_transposed(item: &Item) -> bool {
    let is_one = |item: &Item| name_of(item).is_some_and(|found| found.sup.is_some_and(is_transpose));
    matches!(&item.layout, Layout::Fence(_, inside) if inside.iter().any(is_one))
}

/// The first letter that must be a matrix though the table has it as a number, where the declarations are guesses.
pub fn taken_for_a_number(items: &[Item], symbols: &Symbols) -> Option<(Span, Name)> {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let is_number = |name: &Name| {
        symbols.find(name).is_some_and(|(id, _)| {
            let entry = symbols.entry(id);
            entry.kind == Kind::Scalar && entry.definition.is_none()
        })
    };
    let here = (1..solid.len()).find_map(|at| {
        let name = of_eigenvectors(&solid, at).filter(is_number)?;
        Some((solid[at - 1].span.to(solid[at].span), name))
    });
    here.or_else(|| items.iter().flat_map(parts).find_map(|part| taken_for_a_number(part, symbols)))
}

/// The star of a conjugate.
fn is_star(sup: &Item) -> bool {
    match contents(sup) {
        [Item { layout: Layout::Other('*'), .. }] => true,
        [Item { layout: Layout::Command(name), .. }] => name == "\\ast" || name == "\\star",
        _ => false,
    }
}

/// `x^T M x`: x is a column and M a matrix.
fn quadratic_form(items: &[&Item], found: &mut Vec<(Name, Kind)>) {
    let Some(Printed { name, dots, sup: Some(sup) }) = items.first().and_then(|item| name_of(item)) else { return };
    if !is_transpose(sup) {
        return;
    }
    let middle: Vec<Printed<'_>> = items[1..].iter().map_while(|item| name_of(item)).collect();
    let Some(end) = middle.iter().position(|printed| printed.name == name && printed.dots == dots) else { return };
    let between = &middle[..end];
    // `\Lambda^T \eta \Lambda`: between the capitals a small Greek letter is a matrix too.
    let is_matrix = |of: &Name| is_capital(of) || is_capital(&name) && of.base.starts_with('\\');
    if between.len() <= 2 && between.iter().all(|printed| printed.sup.is_none() && is_matrix(&printed.name)) {
        // `A^T A` and `A^T J A` of capitals: all of them are matrices.
        let kind = if is_capital(&name) { SQUARE } else { Kind::Vector };
        found.push((name, kind));
        found.extend(between.iter().map(|printed| (printed.name.clone(), SQUARE)));
    }
}

fn is_break(item: &Item) -> bool {
    matches!(item.layout, Layout::Other(',' | ';' | '.') | Layout::Text(_) | Layout::Row | Layout::Align)
        || relation(item).is_some()
}

/// The size of `\operatorname{diag}(a, b)`, where nothing stands behind it.
fn diagonal(head: &Item, rest: &[&Item]) -> Option<(u8, u8)> {
    let [Item { layout: Layout::Fence(_, inside), .. }, after @ ..] = rest else { return None };
    let is_lone = after.first().is_none_or(|next| is_break(next));
    let entries = inside.split(|item| item.layout == Layout::Other(',')).count();
    let entries = u8::try_from(entries).ok().filter(|_| is_lone)?;
    (operator_word(head).as_deref() == Some("diag")).then_some((entries, entries))
}

/// The size of a written matrix with numbers before it, up to the next break.
fn size_of_product(items: &[&Item]) -> Option<(u8, u8)> {
    let end = items.iter().position(|item| is_break(item)).unwrap_or(items.len());
    let (last, others) = items[..end].split_last()?;
    let is_number = |item: &&Item| {
        matches!(item.layout, Layout::Number(_) | Layout::Fraction(..) | Layout::Root(..))
            || name_of(item).is_some_and(|printed| !is_bold(&printed.name) && !printed.name.base.contains("\\vec"))
    };
    size(last).filter(|_| others.iter().all(is_number))
}

/// The rows and columns of a written matrix, in parentheses perhaps.
fn size(item: &Item) -> Option<(u8, u8)> {
    match &item.layout {
        Layout::Fence(_, inside) if inside.len() == 1 => size(&inside[0]),
        Layout::Environment(name, rows) if is_matrix(name) => {
            let columns = rows.first()?.len();
            Some((u8::try_from(rows.len()).ok()?, u8::try_from(columns).ok()?))
        }
        _ => None,
    }
}

/// Whether an environment is a matrix.
pub fn is_matrix(name: &str) -> bool {
    matches!(name, "pmatrix" | "bmatrix" | "matrix" | "array" | "smallmatrix" | "Bmatrix")
}

fn is_i(item: &Item) -> bool {
    item.layout == Layout::Letter('i') || item.layout == Layout::Command("\\imath".to_owned()) || is_upright_i(item)
}

fn is_upright_i(item: &Item) -> bool {
    is_upright(item, 'i') || is_upright(item, 'j')
}

fn is_upright(item: &Item, letter: char) -> bool {
    matches!(&item.layout, Layout::Style(style, inner) if style == "\\mathrm"
        && matches!(contents(inner), [Item { layout: Layout::Letter(c), .. }] if *c == letter))
}

/// Whether an upright letter stands anywhere in items.
fn has_upright(items: &[Item], letter: char) -> bool {
    items.iter().any(|item| is_upright(item, letter) || parts(item).into_iter().any(|part| has_upright(part, letter)))
}

/// Whether the letter i must be √−1 here.
pub fn has_imaginary_unit(items: &[Item]) -> bool {
    (is_evident(items) || (has_hbar(items) || has_states(items)) && mentions(items)) && !is_index(items)
}

/// Whether a product of states stands anywhere, `\langle a|A|b\rangle`, and i is the name of none: it is no current beside it.
fn has_states(items: &[Item]) -> bool {
    fn states<'i>(items: &'i [Item], found: &mut Vec<&'i [Item]>) {
        let is_bar = |item: &&Item| item.layout == Layout::Other('|');
        for item in items {
            match &item.layout {
                Layout::Fence(Delimiter::Bra | Delimiter::Ket, inside) => found.push(inside),
                Layout::Fence(Delimiter::Angle, inside) if inside.iter().filter(is_bar).count() == 2 => {
                    found.push(inside)
                }
                _ => parts(item).into_iter().for_each(|part| states(part, found)),
            }
        }
    }
    let mut found = Vec::new();
    states(items, &mut found);
    !found.is_empty() && !found.into_iter().any(mentions)
}

/// Whether ħ stands anywhere: i is no current in such a display.
fn has_hbar(items: &[Item]) -> bool {
    let is_hbar = |item: &Item| {
        let nucleus = if let Layout::Scripts { nucleus, .. } = &item.layout { nucleus } else { item };
        matches!(&nucleus.layout, Layout::Command(name) if name == "\\hbar")
    };
    items.iter().any(|item| is_hbar(item) || parts(item).into_iter().any(has_hbar))
}

/// `\begin{pmatrix} 0 & -i \\ i & 0 \end{pmatrix}`: a matrix of numbers and i.
fn is_matrix_of_units(rows: &[Vec<Vec<Item>>]) -> bool {
    let is_part = |item: &Item| {
        is_i(item) || matches!(item.layout, Layout::Number(_) | Layout::Space(_) | Layout::Other('+' | '-'))
    };
    let mut cells = rows.iter().flatten();
    rows.len() > 1 && cells.clone().flatten().any(is_i) && cells.all(|cell| cell.iter().all(is_part))
}

fn is_evident(items: &[Item]) -> bool {
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let is_hbar = |item: Option<&&Item>| {
        item.is_some_and(|item| {
            let nucleus = if let Layout::Scripts { nucleus, .. } = &item.layout { nucleus } else { *item };
            nucleus.layout == Layout::Command("\\hbar".to_owned())
        })
    };
    // `\frac{L + iv}{L - iv}`: a number over its conjugate.
    let is_over_conjugate = |item: &Item| match &item.layout {
        Layout::Fraction(above, below) => is_conjugate(contents(above), contents(below)),
        _ => false,
    };
    if solid.iter().any(|item| is_over_conjugate(item)) {
        return true;
    }
    let here = solid.iter().enumerate().any(|(at, item)| match &item.layout {
        Layout::Scripts { nucleus, sub: None, sup: Some(sup), .. } => {
            let is_e = nucleus.layout == Layout::Letter('e')
                || matches!(&nucleus.layout, Layout::Style(style, inner) if style == "\\mathrm"
                    && matches!(contents(inner), [Item { layout: Layout::Letter('e'), .. }]));
            is_e && mentions(contents(sup))
        }
        // `\frac{i}{\hbar}`
        Layout::Fraction(above, below)
            if contents(above).iter().any(is_i) && contents(below).iter().any(|item| is_hbar(Some(&item))) =>
        {
            true
        }
        // `\frac{i}{4}`
        Layout::Fraction(above, below) if matches!(contents(above), [only] if is_i(only)) => {
            contents(below).iter().all(|item| matches!(item.layout, Layout::Number(_) | Layout::Root(..)))
        }
        // `\frac{1}{2\pi i}`, `\frac{1}{2i}[A, B]`
        Layout::Fraction(above, below)
            if matches!(contents(above), [one] if is_one(one)) && is_twice_i(contents(below)) =>
        {
            let has_pi = contents(below).iter().any(|item| item.layout == Layout::Command("\\pi".to_owned()));
            has_pi || solid.get(at + 1).is_some_and(|next| is_commutator(next))
        }
        Layout::Environment(name, rows) if is_matrix(name) => is_matrix_of_units(rows),
        Layout::Command(name) if name == "\\exp" => {
            solid.get(at + 1).is_some_and(|next| matches!(&next.layout, Layout::Fence(_, inside) if mentions(inside)))
        }
        _ => {
            let next = solid.get(at + 1);
            is_upright_i(item)
                || is_i(item)
                    && (is_hbar(next)
                        || is_sine(next)
                        || is_greek(next)
                        || is_bold_name(next)
                        || is_pair(&solid, at)
                        || next.is_some_and(|next| is_commutator(next))
                        || next.is_some_and(|next| begins_with_a_frequency(next)))
        }
    });
    here || items.iter().any(|item| parts(item).into_iter().any(is_evident))
}

fn is_one(item: &Item) -> bool {
    matches!(&item.layout, Layout::Number(digits) if digits == "1")
}

/// `2i`, `2\pi i`
fn is_twice_i(items: &[Item]) -> bool {
    let mut solid = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
    let is_two = solid.next().is_some_and(|first| matches!(&first.layout, Layout::Number(digits) if digits == "2"));
    let rest: Vec<&Item> = solid.collect();
    is_two && rest.last().is_some_and(|last| is_i(last)) && rest.len() <= 2
}

/// `[A, B]`, in angle brackets or parentheses perhaps.
fn is_commutator(item: &Item) -> bool {
    match &item.layout {
        Layout::Fence(Delimiter::Square, inside) => inside.iter().any(|item| item.layout == Layout::Other(',')),
        Layout::Fence(Delimiter::Angle | Delimiter::Round, inside) => {
            matches!(inside.as_slice(), [only] if is_commutator(only))
        }
        _ => false,
    }
}

/// `(\omega L - \ldots)`: what is imaginary of an impedance.
fn begins_with_a_frequency(item: &Item) -> bool {
    let Layout::Fence(Delimiter::Round | Delimiter::Square, inside) = &item.layout else { return false };
    let first = inside.iter().find(|item| !matches!(item.layout, Layout::Space(_)));
    first.and_then(name_of).is_some_and(|found| ["\\omega", "\\Omega"].contains(&found.name.base.as_str()))
}

/// A sine after i, as in cos θ + i sin θ.
fn is_sine(item: Option<&&Item>) -> bool {
    item.is_some_and(|item| matches!(&item.layout, Layout::Command(name) if name == "\\sin" || name == "\\sinh"))
}

/// A vector after i, which is then no index.
fn is_bold_name(item: Option<&&Item>) -> bool {
    item.and_then(|item| name_of(item))
        .is_some_and(|printed| is_bold(&printed.name) || printed.name.base.starts_with("\\vec{"))
}

/// A Greek letter that stands after √−1 more often than after a current: a frequency, a rate, an angle.
fn is_greek(item: Option<&&Item>) -> bool {
    const LETTERS: [&str; 15] = [
        "\\omega",
        "\\Omega",
        "\\gamma",
        "\\Gamma",
        "\\beta",
        "\\kappa",
        "\\theta",
        "\\phi",
        "\\varphi",
        "\\pi",
        "\\mu",
        "\\sigma",
        "\\varepsilon",
        "\\epsilon",
        "\\eta",
    ];
    item.and_then(|item| name_of(item)).is_some_and(|printed| LETTERS.contains(&printed.name.base.as_str()))
}

/// `x + iy`, `a - ib`, `v_x + iv_y`: a sum of two neighbours in the alphabet.
fn is_pair(items: &[&Item], at: usize) -> bool {
    let [.., first, sign] = &items[..at] else { return false };
    let (Layout::Other('+' | '-'), Some(first), Some(second)) =
        (&sign.layout, name_of(first), items.get(at + 1).and_then(|next| name_of(next)))
    else {
        return false;
    };
    let (a, b) = (&first.name, &second.name);
    let pairs = [("x", "y"), ("a", "b"), ("u", "v"), ("p", "q"), ("A", "B"), ("X", "Y")];
    let by_letter = a.subscript == b.subscript && pairs.contains(&(a.base.as_str(), b.base.as_str()));
    let by_axis = a.base == b.base && a.subscript == ["x"] && b.subscript == ["y"];
    first.dots == second.dots && (by_letter || by_axis)
}

/// Whether i stands among the factors of an exponent.
fn mentions(items: &[Item]) -> bool {
    items.iter().any(|item| is_i(item) || parts(item).into_iter().any(mentions))
}

/// Whether i is an index, in a subscript or beside a sum, or equals something.
fn is_index(items: &[Item]) -> bool {
    let names = |item: &Item| contents(item).iter().any(is_i);
    let here = |item: &Item| match &item.layout {
        Layout::Scripts { nucleus, sub, .. } => sub.as_deref().is_some_and(names) || is_i(nucleus) && sub.is_some(),
        Layout::Accent(_, inner) => is_i(inner),
        _ => false,
    };
    let solid: Vec<&Item> = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let is_value = solid
        .windows(2)
        .enumerate()
        .any(|(at, pair)| is_i(pair[0]) && relation(pair[1]).is_some() && (at == 0 || is_break(solid[at - 1])));
    is_value || items.iter().any(|item| here(item) || parts(item).into_iter().any(is_index))
}

/// Whether two sums differ in the signs of their terms with i alone, and have such a term.
fn is_conjugate(left: &[Item], right: &[Item]) -> bool {
    let solid = |items: &[Item]| {
        items.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).cloned().collect::<Vec<_>>()
    };
    let (left, right) = (solid(left), solid(right));
    let is_sign = |item: &Item| matches!(item.layout, Layout::Other('+' | '-'));
    let mut changes = 0;
    let is_same = left.len() == right.len()
        && left.iter().zip(&right).enumerate().all(|(at, (a, b))| {
            match a.layout == b.layout || is_sign(a) && is_sign(b) {
                true if a.layout != b.layout => {
                    changes += 1;
                    left.get(at + 1).is_some_and(is_i)
                }
                is_same => {
                    is_same
                        || super::super::super::layout::latex(std::slice::from_ref(a))
                            == super::super::super::layout::latex(std::slice::from_ref(b))
                }
            }
        });
    is_same && changes > 0
}
