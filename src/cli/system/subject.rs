//! What a lecture or a picture is about: a system of the registry by its name, or notes that define a Lagrangian.

use std::path::Path;
use std::sync::Arc;

use crate::check::{Options, Run, system, system_of};
use crate::cli::files::documents::{Job, Loaded, find, load};
use crate::derive::Derivation;
use crate::mechanics::{AnyLagrangian, System};
use crate::notes::Claims;
use crate::parallel::on_deep_stacks;
use crate::systems::Registry;
use crate::{Error, Result, suggest};

/// A system to be derived or drawn.
pub(crate) struct Subject<'r> {
    /// Its traced Lagrangian.
    pub system: Arc<System>,
    /// The Lagrangian as a Rust function, which knows the parts of the system.
    source: Option<&'r dyn AnyLagrangian>,
}

impl<'r> Subject<'r> {
    /// The system of a name, or of the notes at a path.
    ///
    /// # Errors
    /// For an unknown name, and for notes that define no Lagrangian.
    pub fn of(name: &str, registry: &'r Registry) -> Result<Subject<'r>> {
        let path = Path::new(name);
        match registry.get(name) {
            Some(source) => Subject::named(source),
            None if path.is_file() => Subject::of_notes(path, &[], registry)?.ok_or_else(|| {
                Error::new(format!("{name} defines no Lagrangian"))
                    .help("write a display L = …, and \"means\": { \"L\": \"Lagrangian\" } in its claims file")
            }),
            None if path.extension().is_some() || path.components().count() > 1 => {
                Err(Error::new(format!("there is no file {name}"))
                    .help("name notes that exist, or a system such as heavy_top"))
            }
            None => Err(unknown(name, registry)),
        }
    }

    /// A system of the registry.
    pub fn named(source: &'r dyn AnyLagrangian) -> Result<Subject<'r>> {
        Ok(Subject { system: Arc::new(source.trace()?), source: Some(source) })
    }

    /// The system that notes are about; `None` if they name none and define no Lagrangian.
    ///
    /// # Errors
    /// For notes that cannot be read, and claims that do not fit them.
    pub fn of_notes(path: &Path, claims: &[std::path::PathBuf], registry: &'r Registry) -> Result<Option<Subject<'r>>> {
        let run = Run { registry, options: Options::default(), only: None, progress: &() };
        let Some(job) = find(path, claims)?.into_iter().next() else { return Ok(None) };
        if let Job::Pair { claims, .. } = &job
            && let Some(first) = claims.first()
            && let Some(found) = Subject::of_claims(first, registry)?
        {
            return Ok(Some(found));
        }
        if let Job::Claims(path) = &job
            && let Some(found) = Subject::of_claims(path, registry)?
        {
            return Ok(Some(found));
        }
        let system = on_deep_stacks(|| match load(&job)? {
            Loaded::Own(claims, notes) => system_of(&run, &claims, &notes),
            Loaded::Reprint(sets, _) => match sets.first() {
                Some((claims, notes)) => system_of(&run, claims, notes),
                None => Ok(None),
            },
            Loaded::Unclaimed(notes) => system(&run, &notes),
        })?;
        Ok(system.map(|system| Subject { system, source: None }))
    }

    /// The system of the registry that a claims file names.
    fn of_claims(path: &Path, registry: &'r Registry) -> Result<Option<Subject<'r>>> {
        let claims = Claims::read(path, &path.display().to_string())?;
        let named = claims.system.and_then(|system| registry.get(&system.name.value));
        named.map(Subject::named).transpose()
    }

    /// The name of the system.
    pub fn name(&self) -> &str {
        self.system.name()
    }

    /// Whether it is a system of the registry.
    pub fn is_named(&self) -> bool {
        self.source.is_some()
    }

    /// What follows from the system, as formulas.
    ///
    /// # Errors
    /// When two of its names are the same, or a name cannot be read.
    pub fn derivation(&self) -> Result<Derivation> {
        match self.source {
            Some(source) => Derivation::of(source),
            None => Derivation::new(&self.system),
        }
    }
}

fn unknown(name: &str, registry: &Registry) -> Error {
    let unknown = Error::new(format!("there is no system \"{name}\""));
    match suggest::nearest(name, registry.names()) {
        Some(near) => unknown.help(format!("did you mean {near}?")),
        None => unknown.help(suggest::systems(registry.names())),
    }
}
