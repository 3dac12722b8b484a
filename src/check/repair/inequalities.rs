//! Edits of an inequality: the relation may be reversed. An edit that only adds or removes something is no slip that an author made,
//! since an inequality holds with almost any number or factor that is large enough.

use crate::formula::Relation;
use crate::latex::Reading;
use crate::latex::slips::{Edit, Slip};

/// Whether a display states an inequality.
pub(super) fn has_inequality(reading: &Reading) -> bool {
    use Relation::{Greater, GreaterEqual, Less, LessEqual};
    let relations = reading.statements.iter().flatten().flat_map(|statement| &statement.relations);
    relations.into_iter().any(|(relation, _)| matches!(relation, Less | Greater | LessEqual | GreaterEqual))
}

/// Whether an edit of an inequality may be meant: it reverses the relation, or replaces something by a formula of its kind, and it
/// puts no number in the place of a name.
pub(super) fn may_be_meant(text: &str, edit: &Edit) -> bool {
    let has_names = |text: &str| text.chars().any(char::is_alphabetic);
    match edit.slip {
        Slip::Relation | Slip::Exponent | Slip::Parenthesis | Slip::Index | Slip::Order => true,
        _ if edit.span.start == edit.span.end || edit.replacement.trim().is_empty() => false,
        _ => has_names(&edit.replacement) || !has_names(&text[edit.span.range()]),
    }
}
