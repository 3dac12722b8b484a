//! The rows of a display, and the statements that stand side by side in them.
//!
//! `\` separates rows. `&` marks where the relations of all rows stand, and every second `&` begins another column of
//! equations: `a &= b & c &= d` are two.

use crate::formula::tree::Relation;
use crate::source::Span;

use super::layout::{Item, Layout};
use super::lexer::Space;

/// Between two columns of equations.
pub(super) static COLUMN: Item = Item { layout: Layout::Space(Space::Wide), span: Span { start: 0, end: 0 } };

/// One row of a display.
pub(super) struct Row<'a> {
    /// What stands in it, without alignment marks.
    pub items: Vec<&'a Item>,
    /// Whether the relations are aligned by `&`, and something stands before the first of them.
    pub is_aligned: bool,
    /// Whether it begins with `&`, and a row before has something there: it continues that row.
    pub is_indented: bool,
    /// Whether the row before ends with a comma or a point.
    pub follows_stop: bool,
    /// Whether it is an equation of its own behind a brace.
    pub is_of_a_system: bool,
}

/// The rows of a display, or of the `aligned` or `split` environment that is the whole display.
///
/// In a display that is read for its structure, such an environment may also be one row among others, or end a row.
pub(super) fn rows(items: &[Item], is_abstract: bool) -> Vec<Row<'_>> {
    // Braces around all there is: `{\displaystyle {\begin{aligned} … \end{aligned}}}`.
    let is_solid = |item: &&Item| !matches!(item.layout, Layout::Space(_));
    let mut solid = items.iter().filter(is_solid);
    if let (Some(Item { layout: Layout::Group(inside), .. }), None) = (solid.next(), solid.next())
        && !inside.is_empty()
    {
        return rows(inside, is_abstract);
    }
    let cells: Vec<Vec<Vec<&Item>>> = match whole(items) {
        // `\begin{equation}\begin{split} … \end{split}\end{equation}`
        Some([row]) if matches!(row.as_slice(), [cell] if whole(cell).is_some()) => {
            return self::rows(&row[0], is_abstract);
        }
        Some(rows) => rows.iter().flat_map(|row| inner_rows(row, is_abstract)).collect(),
        None => items
            .split(|item| item.layout == Layout::Row)
            .flat_map(|row| if is_abstract { flattened(row) } else { vec![cells_of(row)] })
            .collect(),
    };
    let is_of_a_system = items.iter().any(|item| {
        let is_other = |item: &Item| matches!(item.layout, Layout::Space(_) | Layout::Other('.' | ','));
        matches!(&item.layout, Layout::Environment(name, rows) if is_system(name, rows))
            && items.iter().all(|other| std::ptr::eq(other, item) || is_other(other))
    });
    let mut rows: Vec<Row<'_>> = Vec::with_capacity(cells.len());
    for cells in &cells {
        let is_aligned = cells.len() > 1 && !is_blank(&cells[0]);
        let is_indented = cells.len() > 1 && is_blank(&cells[0]) && rows.iter().any(|row| row.is_aligned);
        let stop = |row: &Row<'_>| {
            let last = row.items.iter().rev().find(|item| !matches!(item.layout, Layout::Space(_)));
            last.is_some_and(|item| matches!(item.layout, Layout::Other(',' | '.' | ';')))
        };
        let follows_stop = rows.last().is_some_and(stop);
        rows.push(Row { items: side_by_side(cells), is_aligned, is_indented, follows_stop, is_of_a_system });
    }
    rows
}

/// The rows of a row of an environment: in `gather` it may have rows of its own.
fn inner_rows(row: &[Vec<Item>], is_abstract: bool) -> Vec<Vec<Vec<&Item>>> {
    match row {
        [cell] if is_abstract => flattened(cell),
        _ => vec![row.iter().map(|cell| cell.iter().collect()).collect()],
    }
}

/// The rows of the environment that is all there is, if they are statements.
fn whole(items: &[Item]) -> Option<&[Vec<Vec<Item>>]> {
    let mut significant =
        items.iter().filter(|item| !matches!(item.layout, Layout::Space(_) | Layout::Other('.' | ',')));
    let (Some(Item { layout: Layout::Environment(name, rows), .. }), None) = (significant.next(), significant.next())
    else {
        return None;
    };
    let has_rows = matches!(
        name.trim_end_matches('*'),
        "aligned"
            | "split"
            | "gathered"
            | "align"
            | "gather"
            | "alignedat"
            | "alignat"
            | "equation"
            | "eqnarray"
            | "multline"
            | "flalign"
            | "multlined"
            | "displaymath"
            | "dmath"
            | "dgroup"
            | "subequations"
    );
    // `\begin{array}{rcl} a & = & b \end{array}`
    let has_relation = |row: &Vec<Vec<Item>>| row.iter().flatten().any(|item| relation(item).is_some());
    let is_blank = |row: &Vec<Vec<Item>>| row.iter().flatten().all(|item| matches!(item.layout, Layout::Space(_)));
    let are_statements = || rows.iter().any(has_relation) && rows.iter().all(|row| has_relation(row) || is_blank(row));
    // `\begin{matrix} a = b \\ c = d \end{matrix}` has no brackets, and an equation is no element.
    let is_column = || name == "matrix" && rows.iter().all(|row| row.len() == 1);
    // `\begin{cases} \begin{aligned} … \end{aligned} \end{cases}`: the brace around rows.
    if name == "cases" && rows.len() == 1 {
        let inner = Item::inner_rows(rows);
        let is_inner = !std::ptr::eq(inner, rows.as_slice());
        return (is_inner && inner.iter().all(|row| has_relation(row) || is_blank(row)))
            .then_some(inner)
            .or_else(|| is_system(name, rows).then_some(rows.as_slice()));
    }
    let is_array = (name == "array" || is_column()) && are_statements();
    (has_rows || is_array || is_system(name, rows)).then_some(rows.as_slice())
}

/// The rows of an environment, cell by cell.
fn rows_of(rows: &[Vec<Vec<Item>>]) -> Vec<Vec<Vec<&Item>>> {
    rows.iter().map(|cells| cells.iter().map(|cell| cell.iter().collect()).collect()).collect()
}

fn cells_of(row: &[Item]) -> Vec<Vec<&Item>> {
    row.split(|item| item.layout == Layout::Align).map(|cell| cell.iter().collect()).collect()
}

/// The rows of a row that ends with rows of its own.
fn flattened(row: &[Item]) -> Vec<Vec<Vec<&Item>>> {
    let is_blank = |item: &Item| matches!(item.layout, Layout::Space(_) | Layout::Other('.' | ','));
    // A system before further statements: `\begin{cases} x = 1 \\ y = 2 \end{cases} \quad z = 3`.
    if let Some(at) = row.iter().position(|item| !is_blank(item))
        && let Layout::Environment(name, inner) = &row[at].layout
        && is_system(name, inner)
        && row[at + 1..].iter().any(|item| !is_blank(item))
        && row.get(at + 1).is_some_and(|next| matches!(next.layout, Layout::Space(Space::Wide) | Layout::Other(',')))
    {
        let mut rows = rows_of(inner);
        rows.extend(flattened(&row[at + 2..]));
        return rows;
    }
    let end = row.iter().rposition(|item| !is_blank(item)).map_or(0, |at| at + 1);
    let Some((Item { layout: Layout::Environment(name, inner), .. }, before)) = row[..end].split_last() else {
        return vec![cells_of(row)];
    };
    // A system after a word or an arrow: `\text{(a)} \rightarrow \begin{cases} x = 1 \\ y = 2 \end{cases}`.
    let is_arrow = |item: &Item| {
        matches!(&item.layout, Layout::Command(name)
            if ["\\Rightarrow", "\\rightarrow", "\\Leftrightarrow", "\\therefore"].contains(&name.as_str()))
            || matches!(item.layout, Layout::Text(_) | Layout::Space(_))
    };
    let is_after_words = is_system(name, inner) && before.iter().all(is_arrow);
    if !matches!(name.trim_end_matches('*'), "aligned" | "split" | "gathered" | "alignedat" | "align" | "gather")
        && !is_after_words
    {
        return vec![cells_of(row)];
    }
    let mut rows = rows_of(inner);
    if let Some(first) = rows.first_mut().and_then(|row: &mut Vec<Vec<&Item>>| row.first_mut()) {
        first.splice(0..0, before.iter().filter(|item| item.layout != Layout::Align));
    }
    rows
}

/// Whether `cases` is a list of equations behind a brace: each row has a relation in its first column, or before its
/// second.
fn is_system(name: &str, rows: &[Vec<Vec<Item>>]) -> bool {
    let has_relation = |cell: &[Item]| cell.iter().any(|item| relation(item).is_some());
    let begins = |cell: &Vec<Item>| {
        let first = cell.iter().find(|item| !matches!(item.layout, Layout::Space(_)));
        first.is_some_and(|item| relation(item).is_some())
    };
    // `x = 0 & t = 0`: the second column is a condition, or a second equation.
    let has_second = |row: &Vec<Vec<Item>>| row.get(1).is_some_and(|cell| has_relation(cell) && !begins(cell));
    let is_equation = |row: &Vec<Vec<Item>>| {
        row.first().is_some_and(|cell| has_relation(before_condition(cell))) && !has_second(row)
            || row.get(1).is_some_and(begins)
    };
    matches!(name.trim_end_matches('*'), "cases" | "dcases" | "rcases")
        && !rows.is_empty()
        && rows.iter().all(is_equation)
}

/// The items before a comma, a wide space or a word, after which a condition may stand.
fn before_condition(cell: &[Item]) -> &[Item] {
    let ends = |item: &Item| matches!(item.layout, Layout::Space(Space::Wide) | Layout::Other(',') | Layout::Text(_));
    &cell[..cell.iter().position(ends).unwrap_or(cell.len())]
}

fn is_blank(cell: &[&Item]) -> bool {
    cell.iter().all(|item| matches!(item.layout, Layout::Space(_)))
}

/// The cells of a row one after the other, with a break before each column of equations but the first.
fn side_by_side<'a>(cells: &[Vec<&'a Item>]) -> Vec<&'a Item> {
    let mut items: Vec<&'a Item> = Vec::new();
    let is_relation = |item: &&Item| relation(item).is_some();
    // Whether a relation stands in the column so far.
    let mut has_relation = false;
    for (at, cell) in cells.iter().enumerate() {
        let joins = |item: Option<&&Item>| item.is_some_and(|item| relation(item).is_some() || is_operator(item));
        let goes_on = joins(items.iter().rev().find(is_significant)) || joins(cell.iter().find(is_significant));
        // `a = b & c = d`: each column is an equation.
        let is_second = has_relation && cell.iter().any(is_relation);
        if at > 0 && (at % 2 == 0 || is_second) && !is_blank(cell) && !goes_on {
            items.push(&COLUMN);
            has_relation = false;
        }
        has_relation |= cell.iter().any(is_relation);
        items.extend(cell);
    }
    items
}

/// Whether an item is + or −.
pub(super) fn is_sign(item: &Item) -> bool {
    matches!(item.layout, Layout::Other('+' | '-'))
}

/// Whether an item is an operator between two terms or factors.
pub(super) fn is_operator(item: &Item) -> bool {
    is_sign(item)
        || matches!(&item.layout, Layout::Command(name) if matches!(name.as_str(), "\\cdot" | "\\times" | "\\wedge" | "\\pm" | "\\mp"))
}

/// Whether an item is more than a space or an empty group.
pub(super) fn is_significant(item: &&&Item) -> bool {
    !matches!(item.layout, Layout::Space(_)) && !matches!(&item.layout, Layout::Group(items) if items.is_empty())
}

/// The relation that an item is.
pub(super) fn relation(item: &Item) -> Option<Relation> {
    Some(match &item.layout {
        Layout::Other('=') => Relation::Equal,
        Layout::Other('<') => Relation::Less,
        Layout::Other('>') => Relation::Greater,
        Layout::Other('≈') => Relation::Approximately,
        Layout::Other('≡') => Relation::Identical,
        Layout::Other('≤') => Relation::LessEqual,
        Layout::Other('≥') => Relation::GreaterEqual,
        Layout::Other('≠') => Relation::NotEqual,
        Layout::Command(name) => match name.as_str() {
            "\\equiv" | "\\coloneqq" => Relation::Identical,
            "\\lt" => Relation::Less,
            "\\gt" => Relation::Greater,
            "\\leq" => Relation::LessEqual,
            "\\geq" => Relation::GreaterEqual,
            "\\neq" => Relation::NotEqual,
            "\\approx" => Relation::Approximately,
            "\\propto" => Relation::Proportional,
            _ => return None,
        },
        _ => return None,
    })
}
