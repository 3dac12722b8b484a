//! Evidence in a display without declarations: letters that must be matrices, columns or complex numbers.
//!
//! A name is a matrix if it equals a written matrix, if it stands under `\det` or `\operatorname{tr}` and is bold or a
//! capital, if it is a bold capital that is transposed, inverted or followed by another bold letter, or if it stands
//! between x^T and x. Whether i is √−1 is decided by [`super::imaginary`], and j by [`super::engineering`].

use crate::formula::symbols::{Kind, Name, Symbols};
use crate::source::Span;

use super::super::super::layout::{Item, Layout, contents, parts};
use super::super::super::names::Printed;
use super::super::super::rows::relation;
use super::super::items::{is_minus_one, is_transpose};
use super::super::symbols::e_is_a_number;
use super::engineering;
use super::imaginary::{has_imaginary_unit, has_upright, is_evident, is_index};
use super::matrices::{is_bold, is_break, is_matrix, name_of, operator_word};

/// Notes in the table what a display says of its letters.
pub fn note(items: &[Item], symbols: &mut Symbols) {
    // Beside each other an upright i and j are directions.
    let is_direction = has_upright(items, 'i') && has_upright(items, 'j');
    symbols.imaginary_here = !is_direction && has_imaginary_unit(items);
    symbols.inferred.imaginary_factor = !is_direction && is_evident(items);
    symbols.inferred.i_is_index = !symbols.imaginary_here && is_index(items);
    symbols.inferred.e_is_number = symbols.open && e_is_a_number(items);
    symbols.imaginary_j_here = engineering::is_imaginary(items) && !symbols.imaginary_here;
    if !symbols.open {
        return;
    }
    let mut found = Vec::new();
    collect(items, &mut found);
    // `\mathbf{E}\mathbf{E}` beside `\mathbf{E} \times \mathbf{B}` is a product of vectors.
    let crossed = crossed(items);
    found.retain(|(name, kind)| *kind != SQUARE || !crossed.contains(&name.base));
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

/// The bold letters and those with an arrow beside a ×: vectors.
pub fn crossed(items: &[Item]) -> Vec<String> {
    let solid: Vec<&Item> =
        items.iter().filter(|item| !matches!(item.layout, Layout::Space(_) | Layout::Align)).collect();
    let vector = |item: &Item| {
        let found = name_of(item).filter(|found| found.sup.is_none())?;
        (is_bold(&found.name) || found.name.base.starts_with("\\vec{")).then_some(found.name.base)
    };
    let is_cross = |item: &Item| matches!(&item.layout, Layout::Command(name) if name == "\\times");
    // In `\omega \times I\omega` a matrix stands behind the ×.
    let after = |at: usize| {
        let acts = solid.get(at + 1).is_some_and(|next| vector(next).is_some());
        solid.get(at).filter(|_| !acts).and_then(|item| vector(item))
    };
    let crosses = (1..solid.len()).filter(|at| is_cross(solid[*at]));
    let mut found: Vec<String> = crosses.flat_map(|at| [vector(solid[at - 1]), after(at + 1)]).flatten().collect();
    found.extend(items.iter().flat_map(parts).flat_map(crossed));
    found
}

/// A matrix of an unknown size.
const SQUARE: Kind = Kind::Matrix(0, 0);

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
