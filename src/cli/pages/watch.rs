//! `onshell watch`: checks documents again whenever a file of theirs is saved, and shows their pages on this computer.
//!
//! Files are looked at every few milliseconds: that needs no library, works on every file system, and answers within the
//! time in which a person notices a delay. Only the documents whose files changed are checked again.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::mpsc::channel;
use std::time::{Duration, SystemTime};

use crate::check::Report;
use crate::cli::check;
use crate::cli::files::documents::{Job, find};
use crate::cli::outcome::{Outcome, Screen, shown};
use crate::cli::values;
use crate::error::reason;
use crate::notes::Claims;
use crate::page::{self, Exhibit};
use crate::report;
use crate::systems::Registry;
use crate::{Error, Result};

use super::serve::Server;

/// Checks documents again whenever they are saved
///
/// With --serve, the pages of `report` are shown at an address of this computer, and change with each save.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  onshell watch notes.md\n  onshell watch . --serve")]
pub struct Arguments {
    /// Claims files (.json), notes (.md, .tex, .ipynb, .rst and others), or folders of these
    #[arg(required = true)]
    paths: Vec<PathBuf>,
    /// The claims file for the notes, if it is not beside them
    #[arg(long, value_name = "FILE")]
    claims: Vec<PathBuf>,
    /// Show the pages at http://127.0.0.1:PORT/
    #[arg(long)]
    serve: bool,
    /// The port of --serve; 0 takes one that is free
    #[arg(long, default_value_t = 8321, value_parser = values::port)]
    port: u16,
}

/// The time between two looks at the files.
const PAUSE: Duration = Duration::from_millis(25);
/// So many looks go by until folders are searched for new documents.
const LOOKS: u32 = 40;

/// What a file was like when it was looked at; nothing for one that is not there.
type Seen = Option<(SystemTime, u64)>;

/// A document: what `check` is given for it, its files as they were, and its report.
struct Watched {
    claims: Vec<PathBuf>,
    files: BTreeMap<PathBuf, Seen>,
    report: Report,
    errors: Vec<Error>,
}

pub(crate) fn run(arguments: &Arguments, registry: &Registry, screen: Screen) -> Outcome {
    let failed = |error: Error| Outcome { messages: shown(&[error], screen), code: 2, ..Outcome::default() };
    let mut all: BTreeMap<PathBuf, Watched> = BTreeMap::new();
    if let Err(error) = search(arguments, registry, &mut all) {
        return failed(error);
    }
    let server = match arguments.serve.then(|| Server::start(arguments.port)).transpose() {
        Ok(server) => server,
        Err(error) => return failed(error),
    };
    if let Some(server) = &server {
        println!("http://127.0.0.1:{}/", server.port);
    }
    std::thread::scope(|scope| {
        // Pictures and derivations take longer than a check, so they follow it.
        let (send, drawn) = channel::<(PathBuf, u32, Vec<Exhibit>)>();
        let mut exhibits: BTreeMap<PathBuf, (u32, Vec<Exhibit>)> = BTreeMap::new();
        let mut changed: Vec<PathBuf> = all.keys().cloned().collect();
        for look in 1_u32.. {
            let mut is_new = !changed.is_empty();
            for (path, at, found) in drawn.try_iter() {
                let known = exhibits.entry(path).or_default();
                if known.0 <= at {
                    is_new |= !(known.1.is_empty() && found.is_empty());
                    *known = (at, found);
                }
            }
            if let Some(server) = server.as_ref().filter(|_| is_new) {
                let documents = all.values().flat_map(|watched| watched.report.documents.iter().cloned());
                let beside: Vec<&Exhibit> = exhibits.values().flat_map(|(_, exhibits)| exhibits).collect();
                server.show(page::pages(&Report::new(documents.collect()), &beside, false));
                for path in &changed {
                    let report = all.get(path).map(|watched| watched.report.clone()).unwrap_or_default();
                    let (path, send) = (path.clone(), send.clone());
                    // The program may have ended before.
                    scope.spawn(move || drop(send.send((path, look, super::report::exhibits(&report, registry)))));
                }
            }
            // Who reads this may leave.
            if !changed.is_empty() && tell(&changed, &all, screen).is_err() {
                break;
            }
            std::thread::sleep(PAUSE);
            changed = all.iter().filter(|(_, watched)| watched.is_changed()).map(|(path, _)| path.clone()).collect();
            for path in &changed {
                if let Some(watched) = all.get_mut(path) {
                    *watched = Watched::check(path, watched.claims.clone(), registry);
                }
            }
            if look.is_multiple_of(LOOKS) {
                // A folder that is gone for a moment keeps its documents.
                changed.extend(search(arguments, registry, &mut all).unwrap_or_default());
            }
        }
    });
    Outcome::default()
}

/// Adds the documents that the paths name and that are not known yet, and returns them.
fn search(arguments: &Arguments, registry: &Registry, all: &mut BTreeMap<PathBuf, Watched>) -> Result<Vec<PathBuf>> {
    let mut new = Vec::new();
    for path in &arguments.paths {
        for job in find(path, &arguments.claims)? {
            let (path, claims) = match job {
                Job::Claims(path) | Job::Notes(path) => (path, Vec::new()),
                Job::Pair { notes, claims } => (notes, claims),
            };
            if !all.contains_key(&path) {
                all.insert(path.clone(), Watched::check(&path, claims, registry));
                new.push(path);
            }
        }
    }
    Ok(new)
}

impl Watched {
    fn check(path: &Path, claims: Vec<PathBuf>, registry: &Registry) -> Watched {
        let mut files: BTreeMap<PathBuf, Seen> = BTreeMap::new();
        // A file that is saved during the check is seen to be newer than this.
        let mut look = |path: PathBuf| {
            let seen = seen(&path);
            files.entry(path).or_insert(seen);
        };
        look(path.to_owned());
        claims.iter().cloned().for_each(&mut look);
        if path.extension().is_some_and(|extension| extension == "json") {
            let notes = Claims::read(path, &path.display().to_string()).map(|claims| claims.notes_path());
            notes.into_iter().for_each(&mut look);
        }
        let (report, errors) = check::documents(&[path.to_owned()], &claims, registry);
        let parts = report.documents.iter().flat_map(|document| document.source.files());
        parts.map(|part| PathBuf::from(&part.path)).for_each(&mut look);
        Watched { claims, files, report, errors }
    }

    fn is_changed(&self) -> bool {
        self.files.iter().any(|(path, before)| seen(path) != *before)
    }
}

fn seen(path: &Path) -> Seen {
    let data = path.metadata().ok()?;
    Some((data.modified().ok()?, data.len()))
}

/// Prints the reports on the documents that changed.
fn tell(changed: &[PathBuf], all: &BTreeMap<PathBuf, Watched>, screen: Screen) -> Result<()> {
    let lost = |error: std::io::Error| Error::new(format!("cannot write the output: {}", reason(&error)));
    for watched in changed.iter().filter_map(|path| all.get(path)) {
        let mut out = std::io::stdout().lock();
        out.write_all(report::text::report(&watched.report, false, screen.out).as_bytes()).map_err(lost)?;
        out.flush().map_err(lost)?;
        std::io::stderr().write_all(shown(&watched.errors, screen).as_bytes()).map_err(lost)?;
    }
    Ok(())
}
