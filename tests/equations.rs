//! One named test an equation, one a sentence, and one for every typo that must be refuted.
//!
//! `06-spinning-top::6.73` is the equation as it stands in `derivations/`; `typo::6.73::sign: for “…” read “…”` is the
//! same equation with one slip, which must go red. `cargo test --test equations 6.73` runs them together.

#[path = "equations/paper.rs"]
mod paper;
#[path = "equations/typo.rs"]
mod typo;

use std::process::ExitCode;
use std::sync::Arc;

use libtest_mimic::{Arguments, Failed, Trial};

use paper::Paper;
use typo::Typo;

/// A test of the tests.
type Meta = fn(&[Arc<Paper>], &[Typo]) -> Result<(), Failed>;

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let mut trials = Vec::new();
    let mut papers = Vec::new();
    for claims in paper::claims_files() {
        match Paper::read(&claims) {
            Ok(paper) => papers.push(Arc::new(paper)),
            // A document that cannot be read must not make its tests disappear.
            Err(error) => trials.push(Trial::test(format!("{}::can be read", paper::stem(&claims)), move || {
                Err(Failed::from(error.to_string()))
            })),
        }
    }
    for paper in &papers {
        trials.extend(of_the_paper(paper));
    }
    let typos = Arc::new(typo::all());
    for typo in typos.iter() {
        let (typo, papers) = (typo.clone(), papers.clone());
        trials.push(Trial::test(typo.title(), move || typo.must_fail(home(&typo, &papers)?)));
    }
    let meta: [(&str, Meta); 4] = [
        ("every number from 2.1 to 6.78 is there", every_number_is_there),
        ("every equation has five typos of three kinds", five_typos_of_three_kinds),
        ("every typo has its equation", every_typo_has_its_equation),
        ("an equation that is not there gets no verdict", an_absent_equation_gets_no_verdict),
    ];
    for (name, test) in meta {
        let (papers, typos) = (papers.clone(), typos.clone());
        trials.push(Trial::test(format!("meta::{name}"), move || test(&papers, &typos)));
    }
    libtest_mimic::run(&arguments, trials).exit_code()
}

/// A test for each numbered equation and each sentence.
fn of_the_paper(paper: &Arc<Paper>) -> Vec<Trial> {
    let equations = paper.numbers().into_iter().map(|id| {
        let (paper, name) = (paper.clone(), format!("{}::{id}", paper.stem));
        Trial::test(name, move || paper.equation(&id))
    });
    let sentences = (0..paper.claims.sentences.len()).map(|at| {
        let (paper, name) = (paper.clone(), format!("{}::sentence::{}", paper.stem, paper.sentence_name(at)));
        Trial::test(name, move || paper.sentence(at))
    });
    equations.chain(sentences).collect()
}

/// The paper whose equation a typo is in.
fn home<'p>(typo: &Typo, papers: &'p [Arc<Paper>]) -> Result<&'p Paper, Failed> {
    let found = papers.iter().find(|paper| paper.notes.source.path == typo.document);
    found.map(Arc::as_ref).ok_or_else(|| Failed::from(format!("no claims file is about {}", typo.document)))
}

fn every_number_is_there(papers: &[Arc<Paper>], _: &[Typo]) -> Result<(), Failed> {
    let printed: Vec<String> = papers.iter().flat_map(|paper| paper.numbers()).collect();
    let section = |number: usize| match number {
        1..=32 => 2,
        33..=56 => 3,
        57..=62 => 4,
        63..=70 => 5,
        _ => 6,
    };
    let wanted = (1..=78).map(|number| format!("{}.{number}", section(number)));
    let missing: Vec<String> = wanted.filter(|number| !printed.contains(number)).collect();
    ensure(missing.is_empty(), || format!("no equation has the number {}", missing.join(", ")))
}

fn five_typos_of_three_kinds(papers: &[Arc<Paper>], typos: &[Typo]) -> Result<(), Failed> {
    let mut lacking = Vec::new();
    for paper in papers {
        for id in paper.numbers() {
            let here = |typo: &&Typo| typo.document == paper.notes.source.path && typo.equation == id;
            let mut kinds: Vec<&str> = typos.iter().filter(here).map(|typo| typo.kind.as_str()).collect();
            let count = kinds.len();
            kinds.sort_unstable();
            kinds.dedup();
            if count < 5 || kinds.len() < 3 {
                lacking.push(format!("({id}) has {count} typos of {} kinds", kinds.len()));
            }
        }
    }
    ensure(lacking.is_empty(), || lacking.join("\n"))
}

fn every_typo_has_its_equation(papers: &[Arc<Paper>], typos: &[Typo]) -> Result<(), Failed> {
    ensure(!typos.is_empty(), || "there are no typos".to_owned())?;
    let mut titles: Vec<String> = typos.iter().map(Typo::title).collect();
    titles.sort_unstable();
    titles.dedup();
    ensure(titles.len() == typos.len(), || "the same typo is there twice".to_owned())?;
    typos.iter().try_for_each(|typo| typo.apply(home(typo, papers)?).map(|_| ()))
}

fn an_absent_equation_gets_no_verdict(papers: &[Arc<Paper>], _: &[Typo]) -> Result<(), Failed> {
    let found = |paper: &Arc<Paper>| {
        paper::check(&paper.claims, &paper.notes, Some("6.999")).is_ok_and(|d| d.equations.is_empty())
    };
    ensure(papers.iter().all(found) && !papers.is_empty(), || "(6.999) was checked, and is not there".to_owned())
}

fn ensure(holds: bool, otherwise: impl FnOnce() -> String) -> Result<(), Failed> {
    if holds { Ok(()) } else { Err(Failed::from(otherwise())) }
}
