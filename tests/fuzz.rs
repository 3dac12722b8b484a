//! Near misses made by machine: pairs that are equal or unequal by construction, and damaged text.
//!
//! Every case has a number, from which it is made again. `FUZZ_CASES=100000` runs that many cases of each property in place of
//! the few of a usual run, and `FUZZ_FIRST=4711` starts at that number: CONTRIBUTING.md has the command.

#[path = "fuzz/damage.rs"]
mod damage;
#[path = "fuzz/draw.rs"]
mod draw;
#[path = "fuzz/nasty.rs"]
mod nasty;
#[path = "fuzz/pairs.rs"]
mod pairs;
#[path = "fuzz/statements.rs"]
mod statements;
#[path = "fuzz/tree.rs"]
mod tree;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use onshell::check::Verdict;
use onshell::systems::Registry;
use onshell::testing::check_text;
use onshell::{Formula, Options, compare};

use draw::Draw;

/// The numbers of the cases: as many as the environment asks for, else `usual`.
fn cases(usual: u64) -> std::ops::Range<u64> {
    let asked = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<u64>().ok());
    let first = asked("FUZZ_FIRST").unwrap_or(0);
    first..first + asked("FUZZ_CASES").unwrap_or(usual)
}

/// Runs a property on all cases and names every one that fails.
fn all(name: &str, usual: u64, property: impl Fn(u64) -> Result<(), String>) {
    let mut failures = Vec::new();
    let cases = cases(usual);
    let count = cases.end - cases.start;
    for case in cases {
        let found = catch_unwind(AssertUnwindSafe(|| property(case))).unwrap_or_else(|_| Err("panics".to_owned()));
        if let Err(message) = found {
            println!("{name}, case {case}: {message}");
            failures.push(case);
        }
    }
    println!("{name}: {count} cases, {} failures", failures.len());
    assert!(failures.is_empty(), "{name}: {} of {count} cases fail: {failures:?}", failures.len());
}

/// The verdict on a pair, if both formulas can be read.
fn verdict(a: &str, b: &str) -> Result<Option<(Verdict, String)>, String> {
    let start = Instant::now();
    let found = compare(a, b, &[], Options::default());
    let elapsed = start.elapsed();
    if elapsed > Duration::from_secs(1) {
        println!("takes {elapsed:?}: {a} = {b}");
    }
    if elapsed > Duration::from_secs(20) {
        return Err(format!("takes {elapsed:?}: {a} = {b}"));
    }
    Ok(found.ok().map(|found| (found.finding.verdict, found.finding.message)))
}

#[test]
fn what_is_equal_is_never_refuted() {
    all("equal pairs", 150, |case| {
        let (a, b) = pairs::equal(&mut Draw::new(1, case));
        match verdict(&a, &b)? {
            Some((Verdict::Refuted, message)) => Err(format!("refuted: {a} = {b}: {message}")),
            _ => Ok(()),
        }
    });
}

#[test]
fn what_differs_is_never_accepted() {
    all("unequal pairs", 150, |case| {
        let (a, b) = pairs::unequal(&mut Draw::new(2, case));
        match verdict(&a, &b)? {
            Some((verdict, message)) if verdict.passes() => Err(format!("{verdict:?}: {a} = {b}: {message}")),
            _ => Ok(()),
        }
    });
}

/// The pairs say nothing if none of them is judged.
#[test]
fn most_pairs_are_judged() {
    let judged = |pair: fn(&mut Draw) -> (String, String), stream: u64, wanted: fn(Verdict) -> bool| {
        (0..40)
            .filter(|case| {
                let (a, b) = pair(&mut Draw::new(stream, *case));
                verdict(&a, &b).ok().flatten().is_some_and(|(verdict, _)| wanted(verdict))
            })
            .count()
    };
    let (accepted, refuted) =
        (judged(pairs::equal, 1, Verdict::passes), judged(pairs::unequal, 2, |verdict| verdict == Verdict::Refuted));
    assert!(accepted >= 20 && refuted >= 15, "{accepted} of 40 accepted, {refuted} of 40 refuted");
}

#[test]
fn what_is_printed_is_read_with_the_same_value() {
    all("readings", 3000, |case| {
        let mut draw = Draw::new(3, case);
        let formula = tree::any(&mut draw, 4);
        let latex = formula.latex();
        let read = Formula::read(&latex).map_err(|error| format!("{latex}: {error}"))?;
        let letters: Vec<(&str, f64)> = tree::LETTERS.iter().map(|letter| (*letter, draw.between(0.3, 1.7))).collect();
        let used: Vec<(&str, f64)> =
            letters.iter().filter(|(letter, _)| read.letters().iter().any(|known| known == letter)).copied().collect();
        let (wanted, size) = formula.value(&letters);
        match read.value(&used) {
            Ok(found) if (found - wanted).abs() <= 1e-9 * size => Ok(()),
            Ok(found) if wanted.is_finite() && size < 1e12 => Err(format!("{latex} is {found} and not {wanted}")),
            _ => Ok(()),
        }
    });
}

#[test]
fn no_text_makes_the_reader_panic() {
    all("texts", 3000, |case| {
        let text = damage::soup(&mut Draw::new(4, case));
        let start = Instant::now();
        let _ = Formula::read_all(&text);
        let elapsed = start.elapsed();
        if elapsed > Duration::from_secs(5) { Err(format!("takes {elapsed:?}: {text}")) } else { Ok(()) }
    });
}

/// The verdict on a statement under its claims, with the message.
fn judged(case: u64, is_true: bool, registry: &Registry) -> (Verdict, String) {
    let made = statements::statement(&mut Draw::new(7, case), is_true);
    let notes = format!("# Notes\n\n$$\n{}\n\\tag{{1}}\n$$\n", made.display);
    match check_text(&notes, &made.claims.to_string(), registry) {
        Ok(document) => {
            let finding = &document.equations[0].finding;
            (finding.verdict, format!("{}: {:?}: {}", made.display, finding.verdict, finding.message))
        }
        Err(error) => (Verdict::Unreadable, format!("{}: {error}", made.display)),
    }
}

#[test]
fn what_is_true_under_claims_is_never_refuted() {
    let registry = Registry::standard();
    all("true statements", 30, |case| match judged(case, true, &registry) {
        (Verdict::Refuted | Verdict::Unreadable, message) => Err(message),
        _ => Ok(()),
    });
}

#[test]
fn what_is_false_under_claims_is_never_accepted() {
    let registry = Registry::standard();
    all("false statements", 30, |case| match judged(case, false, &registry) {
        (verdict, message) if verdict.passes() || verdict == Verdict::Unreadable => Err(message),
        _ => Ok(()),
    });
}

/// Searches have budgets in steps. The limit in seconds is far above what these cost, so that a loaded machine passes.
#[test]
fn no_short_formula_takes_long() {
    all("hard formulas", 150, |case| {
        let (a, b) = nasty::pair(&mut Draw::new(6, case));
        verdict(&a, &b).map(|_| ())
    });
}

#[test]
fn no_damage_makes_a_check_panic() {
    let registry = Registry::standard();
    all("documents", 40, |case| {
        let (notes, claims) = damage::document(&mut Draw::new(5, case));
        let start = Instant::now();
        let _ = check_text(&notes, &claims, &registry);
        let elapsed = start.elapsed();
        if elapsed > Duration::from_secs(60) { Err(format!("takes {elapsed:?}:\n{notes}\n{claims}")) } else { Ok(()) }
    });
}
