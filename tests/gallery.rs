//! Documents that are wrong on purpose, and what is said of each line of them.
//!
//! `tests/gallery/` has notes with slips in them, and beside each wrong display, on the line below, a comment with what
//! the checker has to say: the verdict, its place, and the edits that it has to offer, each with its place:
//!
//! ```text
//! refuted at 12:1; 12:15 “+” → “-”, or 12:20 “a” → “b”
//! ```
//!
//! An offer is what a physicist would write there. A display without a comment has to pass.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock};

use onshell::Source;
use onshell::check::Slip;
use onshell::check::{Document, Equation, Options, Repair, check_document};
use onshell::notes::Kind;
use onshell::notes::{Claims, Notes};
use onshell::systems::Registry;

/// A document of the gallery.
struct Page {
    /// The path of its notes.
    path: PathBuf,
    claims: Claims,
    /// The notes as they stand in the file.
    text: String,
    found: Document,
}

/// The documents, each checked once.
static GALLERY: LazyLock<Vec<Page>> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/gallery");
    let entries = std::fs::read_dir(folder).expect("tests/gallery can be read");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("it can be read").path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "json"));
    files.sort();
    files.iter().map(|file| Page::read(file)).collect()
});

impl Page {
    fn read(file: &Path) -> Page {
        let claims = Claims::read(file, &file.display().to_string()).unwrap_or_else(|error| panic!("{error}"));
        let path = claims.notes_path();
        let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let found = check(&claims, &path, &text, None);
        Page { path, claims, text, found }
    }

    /// The equations that are not as they should be, with the edits that are offered for them.
    fn wrong(&self) -> impl Iterator<Item = &Equation> {
        self.found.equations.iter().filter(|equation| !equation.ok)
    }
}

/// Checks these notes; `only` may name a single equation.
fn check(claims: &Claims, path: &Path, text: &str, only: Option<&str>) -> Document {
    let kind = Kind::of(path).expect("it is a kind of notes");
    let name = path.display().to_string();
    let checked = Notes::parse(Arc::new(Source::new(name, text)), kind)
        .and_then(|notes| check_document(claims, &notes, &Registry::standard(), Options::default(), only));
    checked.unwrap_or_else(|error| panic!("{error}"))
}

/// What the comments of some notes expect: the line of each, and its words.
fn expectations(notes: &str) -> Vec<(usize, String)> {
    let expectation = |line: &str| {
        let html = line.strip_prefix("<!-- ").and_then(|rest| rest.strip_suffix(" -->"));
        html.or_else(|| line.strip_prefix("% ")).map(str::to_owned)
    };
    notes.lines().enumerate().filter_map(|(at, line)| Some((at + 1, expectation(line)?))).collect()
}

/// What is said of an equation; nothing, if it passes.
fn said(equation: &Equation, source: &Source) -> Option<String> {
    let place = |offset: usize| {
        let (line, column) = source.line_column(offset);
        format!("{line}:{column}")
    };
    let offer = |repair: &Repair| {
        let (old, new) = (source.slice(repair.span), &repair.replacement);
        format!("{} “{old}” → “{new}”", place(repair.span.start))
    };
    let offers: Vec<String> = equation.repairs.iter().map(offer).collect();
    let offers = if offers.is_empty() { "nothing to offer".to_owned() } else { offers.join(", or ") };
    let finding = &equation.finding;
    (!equation.ok).then(|| format!("{} at {}; {offers}", finding.verdict, place(finding.span.start)))
}

/// Where what was found in some notes is not what their comments expect: each equation with both.
fn differences(notes: &str, found: &Document) -> Vec<String> {
    let expected = expectations(notes);
    let mut differences = Vec::new();
    for (at, equation) in found.equations.iter().enumerate() {
        let next = found.equations.get(at + 1).map_or(usize::MAX, |next| next.line);
        let wanted: Vec<&str> = expected
            .iter()
            .filter(|(line, _)| (equation.line..next).contains(line))
            .map(|(_, wanted)| wanted.as_str())
            .collect();
        let said = said(equation, &found.source);
        if wanted != Vec::from_iter(said.as_deref()) {
            let or_pass = |words: Option<&str>| words.unwrap_or("it passes").to_owned();
            let wanted = or_pass((!wanted.is_empty()).then(|| wanted.join("\n            ")).as_deref());
            let message = &equation.finding.message;
            let said = or_pass(said.as_deref());
            differences.push(format!("({})\n  expected: {wanted}\n  found:    {said}\n  ({message})", equation.id));
        }
    }
    differences
}

#[test]
fn every_slip_is_named_at_its_place_and_mended() {
    let differences: Vec<String> = GALLERY
        .iter()
        .flat_map(|page| {
            let name = page.path.display().to_string();
            differences(&page.text, &page.found).into_iter().map(move |difference| format!("{name} {difference}"))
        })
        .collect();
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

#[test]
fn an_equation_passes_with_each_edit_that_is_offered_and_no_byte_but_of_the_edit_is_changed() {
    let verdict = |page: &Page, equation: &Equation, text: &str| {
        let mended = check(&page.claims, &page.path, text, Some(&equation.id)).equations.remove(0);
        (mended.ok, mended.finding.verdict)
    };
    for page in GALLERY.iter() {
        for equation in page.wrong() {
            for repair in &equation.repairs {
                let (before, after) = (&page.text[..repair.span.start], &page.text[repair.span.end..]);
                let text = format!("{before}{}{after}", repair.replacement);
                let place = format!("{} ({}): {text}", page.path.display(), equation.id);
                assert_eq!(verdict(page, equation, &text), (true, repair.verdict), "{place}");
            }
            // The twin: as it stands it does not pass, and the edits are of the display alone.
            assert!(!verdict(page, equation, &page.text).0, "{} ({})", page.path.display(), equation.id);
        }
    }
}

#[test]
fn an_edit_stays_within_its_display() {
    for page in GALLERY.iter() {
        for equation in page.wrong() {
            let start = page.text.find(&equation.latex).expect("the display stands in the notes");
            let end = start + equation.latex.len();
            for repair in &equation.repairs {
                assert!(
                    start <= repair.span.start
                        && repair.span.end <= end
                        && page.text.matches(&equation.latex).count() == 1,
                    "{} ({}): {repair:?} is not within {start}..{end}",
                    page.path.display(),
                    equation.id
                );
            }
        }
    }
}

#[test]
fn every_kind_of_slip_is_in_the_gallery() {
    let kinds: BTreeSet<Slip> =
        GALLERY.iter().flat_map(Page::wrong).flat_map(|equation| &equation.repairs).map(|repair| repair.slip).collect();
    // But of an accent: a name without its own is another name, and mended as one.
    let all = [
        Slip::Sign,
        Slip::Symbol,
        Slip::Index,
        Slip::Dot,
        Slip::Number,
        Slip::Exponent,
        Slip::Function,
        Slip::Order,
        Slip::Fraction,
        Slip::Parenthesis,
        Slip::Relation,
        Slip::Factor,
        Slip::Term,
    ];
    let absent: Vec<&str> = all.into_iter().filter(|kind| !kinds.contains(kind)).map(Slip::word).collect();
    assert!(absent.is_empty(), "no slip of {absent:?}");
    let wrong = GALLERY.iter().flat_map(Page::wrong).count();
    assert!(wrong >= 40, "only {wrong} wrong displays");
}

/// The gallery's first page with a slip in what its comments expect, or in its displays.
#[test]
fn what_is_not_expected_is_noticed() {
    let page = GALLERY.iter().find(|page| page.path.ends_with("pendulum.md")).expect("there is a pendulum");
    assert_eq!(differences(&page.text, &page.found), Vec::<String>::new());
    let (line, words) = expectations(&page.text).remove(0);
    let comment = format!("<!-- {words} -->\n");
    let place = format!("at {}:1", line - 3);
    assert!(words.contains(&place), "{words}");
    for (what, slip) in [
        ("another verdict", comment.replace("refuted", "unreadable")),
        ("another place", comment.replace(&place, &format!("at {}:2", line - 3))),
        ("another edit", comment.replace("“\\sin”", "“\\tan”")),
        ("one edit more", comment.replace("“\\sin”", "“\\sin”, or 1:1 “a” → “b”")),
        ("no word on it", "\n".to_owned()),
        ("two words on it", format!("{comment}{comment}")),
    ] {
        let changed = page.text.replacen(&comment, &slip, 1);
        assert_ne!(changed, page.text, "{what}");
        assert_eq!(differences(&changed, &page.found).len(), 1, "{what}");
    }
    // A word on what passes is a difference, too: the first display is sound.
    let sound = page.text.find("\\tag{1}\n$$\n").expect("the first display") + "\\tag{1}\n$$\n".len();
    let blamed = format!("{}{comment}{}", &page.text[..sound], &page.text[sound..]);
    assert!(differences(&blamed, &page.found)[0].starts_with("(1)"));
}
