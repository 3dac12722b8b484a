//! The claims file: declarations of symbols, the system or the laws, and the claims about equations.
//!
//! Every value is typed and has its place; LaTeX stays text. A key that is unknown or not supported yet is an error.
//!
//! Offers [`Claims`], and the schema of the file. Knows JSON with places, and addresses; no LaTeX is read.
//!
//! # Why the claims are JSON beside the notes
//!
//! Notes may belong to someone else. Equation numbers are text in JSON (`2.10` is a number in YAML and a dotted key
//! in TOML). The price is doubled backslashes and no comments; hence `because`.

mod claim;
mod continua;
mod fields;
mod key;
mod range;
mod rubric;
#[cfg(feature = "cli")]
pub mod schema;
mod sentence;
mod vectors;

use std::path::{Path, PathBuf};
use std::sync::Arc;

pub use super::json::Spanned;
pub use claim::{Claim, Conserved, Equilibrium, Erratum, Expect, Expected, Holds, Solved, Solves};
pub use continua::{Continuum, SolidKind};
pub(crate) use key::Key;
pub use range::{Count, Range};
pub use rubric::Rubric;
#[cfg(feature = "cli")]
pub use rubric::{Lost, Share};
pub use sentence::{Property, Sentence, Sign, Test};
pub use vectors::{Axes, Components};

use super::address::Address;
use super::file::read_text;
use super::json::{self, Json, Value};
use super::normalize::normalized;
use crate::source::{Fault, Source, Span};
use crate::{Error, Result};
use fields::{Fields, Text};

/// A claims file.
#[derive(Clone, Debug)]
pub struct Claims {
    /// The file.
    pub source: Arc<Source>,
    /// Where it is.
    pub path: PathBuf,
    /// `notes`: the notes, relative to this file.
    pub notes: Spanned<String>,
    /// `system`: the system whose equations of motion are used.
    pub system: Option<SystemRef>,
    /// `independent variable`
    pub independent_variable: Option<Spanned<String>>,
    /// The symbols, one by one.
    pub declarations: Vec<Declaration>,
    /// `axes`: right-handed unit vectors, and their rotation.
    pub axes: Vec<(Spanned<String>, Spanned<Axes>)>,
    /// `components`: the names of a vector's components.
    pub components: Vec<(Spanned<String>, Spanned<Components>)>,
    /// `continua`: bodies with a density.
    pub continua: Vec<Continuum>,
    /// `laws`: hypotheses that hold on shell and are not checked, each an address or LaTeX.
    pub laws: Vec<(Spanned<String>, Spanned<String>)>,
    /// `units`: symbols, and their units in SI.
    pub units: Vec<(Spanned<String>, Spanned<String>)>,
    /// `dissipation`: Rayleigh's function, whose slopes by the velocities are subtracted from the generalized forces.
    pub dissipation: Option<Spanned<String>>,
    /// `forces`: the generalized force on a coordinate, beside what the Lagrangian gives.
    pub forces: Vec<(Spanned<String>, Spanned<String>)>,
    /// `constraints`: for each Lagrange multiplier the formula f of its constraint f = 0, which the Lagrangian does not contain.
    pub constraints: Vec<(Spanned<String>, Spanned<String>)>,
    /// `rotations`: rotation matrices, active or passive.
    pub rotations: Vec<(Spanned<String>, Spanned<Turning>)>,
    /// `means`: the derived quantity that a name stands for.
    pub means: Vec<(Spanned<String>, Spanned<String>)>,
    /// `define`: definitions that the prose gives.
    pub define: Vec<(Spanned<String>, Spanned<String>)>,
    /// `conditions`: named hypotheses.
    pub conditions: Vec<(Spanned<String>, Vec<Spanned<String>>)>,
    /// `assume`: hypotheses of every equation.
    pub assume: Vec<Spanned<String>>,
    /// `macros`: commands that the notes do not define themselves.
    pub macros: Vec<(Spanned<String>, Spanned<String>)>,
    /// `steps`: derivations, each the address of its steps in order.
    pub steps: Vec<Address>,
    /// The claims about equations.
    pub equations: Vec<(Address, Claim)>,
    /// The claims about sentences.
    pub sentences: Vec<Sentence>,
    /// `rubric`: what a hand-in is marked by.
    pub rubric: Option<Rubric>,
    /// `guesses`: declarations that nobody has confirmed, each with its reason. With this key, even if it is empty, the notes
    /// are judged as notes without a claims file.
    pub guesses: Option<Vec<(Spanned<String>, Spanned<String>)>>,
}

/// A system by name, with the notes' names of its parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SystemRef {
    /// Its name.
    pub name: Spanned<String>,
    /// `read`: the system's name of a parameter or coordinate, and the notes' name.
    pub read: Vec<(Spanned<String>, Spanned<String>)>,
}

/// A declared symbol.
#[derive(Clone, Debug, PartialEq)]
pub struct Declaration {
    /// What kind of symbol it is.
    pub role: Role,
    /// The symbol with its own place, also where one key declares several.
    pub name: Spanned<String>,
    /// Its values.
    pub range: Spanned<Range>,
    /// Whether the name is a formula that stands for one name, under `formulas as names`.
    pub is_formula: bool,
}

/// The kind of symbol that a declaration makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    /// `coordinates`: varies, and obeys the equations of motion.
    Coordinate,
    /// `varies with time`: freely.
    VariesWithTime,
    /// `constants`
    Constant,
    /// `functions`: any smooth one.
    Function,
    /// `indices`
    Index,
}

/// What a formula that stands for one name is.
#[derive(Clone, Copy)]
enum Formula {
    Constant { is_vector: bool },
    Varies { is_vector: bool },
    Rate,
    Given,
}

/// What a rotation matrix turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turning {
    /// `of the axes`: passive.
    Axes,
    /// `of the vectors`: active.
    Vectors,
}

const KEYS: &[&str] = &[
    "notes",
    "system",
    "independent variable",
    "coordinates",
    "varies with time",
    "constants",
    "functions",
    "formulas as names",
    "dissipation",
    "forces",
    "constraints",
    "indices",
    "axes",
    "components",
    "continua",
    "rotations",
    "laws",
    "units",
    "means",
    "define",
    "conditions",
    "assume",
    "macros",
    "steps",
    "equations",
    "sentences",
    "rubric",
    "guesses",
];

/// Keys that are planned and not supported yet.
const LATER: &[&str] =
    &["covers", "builds on", "prime", "imaginary unit", "bodies", "gravity", "potential", "Lagrangian", "unsure"];

/// The path of the claims file for the notes at `path`: the same path with the extension `.json`.
pub fn claims_beside(path: &Path) -> PathBuf {
    path.with_extension("json")
}

impl Claims {
    /// Reads the claims file at `path`, known in messages as `shown_as`.
    pub fn read(path: &Path, shown_as: &str) -> Result<Claims> {
        Claims::parse(read_text(path, shown_as)?, path)
    }

    /// Reads the text of a claims file that is, or would be, at `path`.
    pub fn parse(source: Arc<Source>, path: &Path) -> Result<Claims> {
        let read = json::read(&source.text).and_then(|json| document(&json, &source, path));
        read.map_err(|fault| Error::fault(&source, fault))
    }

    /// Where the notes are.
    pub fn notes_path(&self) -> PathBuf {
        self.path.parent().unwrap_or(Path::new("")).join(&self.notes.value)
    }
}

fn document(json: &Json, source: &Arc<Source>, path: &Path) -> Result<Claims, Fault> {
    let fields = Fields::new(json, "a claims file", &[KEYS], LATER)?;
    let missing = || {
        Fault::claims(Span::new(json.span.start, json.span.start + 1), "a claims file needs \"notes\"")
            .help("add \"notes\": \"top.md\", the path of the document relative to this file")
    };
    let rotations = rotations(&fields, source)?;
    let Declared { declarations, conditions: between, values } = declarations(&fields, source)?;
    let axes = vectors::axes(&fields, source)?;
    let continua = continua::continua(&fields, source)?;
    let mut means = fields.declared("means", source)?;
    let mut dissipation = fields.text("dissipation")?;
    // The name of the dissipation function says the same as the key of its own.
    if dissipation.is_none()
        && let Some(at) = means.iter().position(|(_, meaning)| meaning.value == "dissipation function")
    {
        dissipation = Some(means.remove(at).0);
    }
    let units = fields.declared("units", source)?;
    // A formula in the place of a meaning or a range defines the name.
    let (given, meanings): (Vec<_>, Vec<_>) = means.into_iter().partition(|(_, what)| range::is_formula(&what.value));
    means = meanings;
    let define: Vec<(Text, Text)> = fields.pairs("define")?.into_iter().chain(given).chain(values).collect();
    let declared =
        declarations.iter().filter(|declaration| !declaration.is_formula).map(|declaration| &declaration.name);
    let turned = rotations.iter().map(|(name, _)| name).chain(axes.iter().map(|(name, _)| name));
    let spread = continua.iter().map(|continuum| &continuum.name);
    let tied = means.iter().chain(&define).map(|(name, _)| name);
    once(declared.chain(turned).chain(spread).chain(tied), &fields, source)?;
    once(units.iter().map(|(name, _)| name), &fields, source)?;
    Ok(Claims {
        source: source.clone(),
        path: path.to_owned(),
        notes: fields.text("notes")?.ok_or_else(missing)?,
        system: system(&fields)?,
        independent_variable: fields.text("independent variable")?,
        declarations,
        axes,
        components: vectors::components(&fields, source)?,
        continua,
        laws: fields.pairs("laws").map_err(|fault| match fault.help {
            Some(_) => fault,
            None => fault.help("write a name and an equation for each, as in { \"Newton's law\": \"1\" }"),
        })?,
        units,
        dissipation,
        forces: fields.pairs("forces")?,
        constraints: fields.pairs("constraints")?,
        rotations,
        means,
        define,
        conditions: conditions(&fields)?,
        assume: fields.texts("assume")?.into_iter().chain(between).collect(),
        macros: fields.pairs("macros")?,
        steps: fields.texts("steps")?.iter().map(|step| Address::parse(step, source)).collect::<Result<_, _>>()?,
        equations: equations(&fields, source)?,
        sentences: sentences(&fields, source)?,
        rubric: rubric::rubric(&fields, source)?,
        guesses: fields.get("guesses").map(|_| fields.pairs("guesses")).transpose()?,
    })
}

fn system(fields: &Fields<'_>) -> Result<Option<SystemRef>, Fault> {
    match fields.get("system") {
        None => Ok(None),
        Some(json @ Json { value: Value::String(_), .. }) => {
            Ok(Some(SystemRef { name: fields::text(json, "system")?, read: Vec::new() }))
        }
        Some(json @ Json { value: Value::Object(_), .. }) => {
            let inner = Fields::new(json, "\"system\"", &[&["name", "read"]], &[])?;
            let missing = || Fault::claims(json.span, "\"system\" needs \"name\", the name of the system");
            Ok(Some(SystemRef { name: inner.text("name")?.ok_or_else(missing)?, read: inner.pairs("read")? }))
        }
        Some(json) => Err(fields::wrong(json, "system", "a name or an object with \"name\" and \"read\"")),
    }
}

/// What the declarations of a claims file say.
struct Declared {
    declarations: Vec<Declaration>,
    /// The conditions that ranges with formulas as ends make.
    conditions: Vec<Text>,
    /// The names that have a formula in the place of a range, with it.
    values: Vec<(Text, Text)>,
}

fn declarations(fields: &Fields<'_>, source: &Source) -> Result<Declared, Fault> {
    const ROLES: &[(&str, Role)] = &[
        ("coordinates", Role::Coordinate),
        ("varies with time", Role::VariesWithTime),
        ("constants", Role::Constant),
        ("functions", Role::Function),
        ("indices", Role::Index),
    ];
    let (mut declarations, mut conditions, mut values) = (Vec::new(), Vec::new(), Vec::new());
    for &(section, role) in ROLES {
        for (key, value) in fields.pairs(section)? {
            if matches!(role, Role::Coordinate | Role::Constant | Role::VariesWithTime) {
                let names = fields::names(&key, source)?;
                if role == Role::Constant && range::is_formula(&value.value) {
                    values.extend(names.into_iter().map(|name| (name, value.clone())));
                    continue;
                }
                let found: Option<Vec<_>> = names
                    .into_iter()
                    .map(|name| range::between(&value, &name.value).map(|(range, own)| (name, range, own)))
                    .collect();
                if let Some(found) = found {
                    for (name, range, own) in found {
                        conditions.extend(own);
                        declarations.push(Declaration { role, name, range, is_formula: false });
                    }
                    continue;
                }
            }
            let range = match role {
                Role::Index => range::index(&value)?,
                Role::Function => range::function(&value)?,
                Role::VariesWithTime => range::motion(&value)?,
                Role::Coordinate | Role::Constant => range::range(&value)?,
            };
            let names = fields::names(&key, source)?;
            declarations.extend(names.into_iter().map(|name| Declaration {
                role,
                name,
                range: range.clone(),
                is_formula: false,
            }));
        }
    }
    for (name, value) in fields.pairs("formulas as names")? {
        let words = &[
            ("constant", Formula::Constant { is_vector: false }),
            ("varies with time", Formula::Varies { is_vector: false }),
            ("constant vector", Formula::Constant { is_vector: true }),
            ("vector that varies with time", Formula::Varies { is_vector: true }),
            ("rate", Formula::Rate),
            ("given by a display", Formula::Given),
        ];
        let Spanned { value: formula, span } = fields::word(&value, &name.value, words)?;
        let (role, range) = match formula {
            Formula::Constant { is_vector: false } => (Role::Constant, Range::Any),
            Formula::Constant { is_vector: true } => (Role::Constant, Range::Matrix(3, 1)),
            Formula::Varies { is_vector: false } => (Role::VariesWithTime, Range::Any),
            Formula::Varies { is_vector: true } => (Role::VariesWithTime, Range::Matrix(3, 1)),
            Formula::Rate => (Role::VariesWithTime, Range::Rate),
            Formula::Given => (Role::Constant, Range::Given),
        };
        declarations.push(Declaration { role, name, range: Spanned::new(range, span), is_formula: true });
    }
    Ok(Declared { declarations, conditions, values })
}

fn rotations(fields: &Fields<'_>, source: &Source) -> Result<Vec<(Text, Spanned<Turning>)>, Fault> {
    let mut rotations = Vec::new();
    for (key, value) in fields.pairs("rotations")? {
        let words = &[("of the axes", Turning::Axes), ("of the vectors", Turning::Vectors)];
        let turning = fields::word(&value, &key.value, words)?;
        rotations.extend(fields::names(&key, source)?.into_iter().map(|name| (name, turning.clone())));
    }
    Ok(rotations)
}

fn conditions(fields: &Fields<'_>) -> Result<Vec<(Text, Vec<Text>)>, Fault> {
    let Some(json) = fields.get("conditions") else { return Ok(Vec::new()) };
    let entries = fields::object(json, "\"conditions\"")?;
    entries.iter().map(|(key, value)| Ok((key.clone(), fields::texts(value, &key.value)?))).collect()
}

fn equations(fields: &Fields<'_>, source: &Source) -> Result<Vec<(Address, Claim)>, Fault> {
    let Some(json) = fields.get("equations") else { return Ok(Vec::new()) };
    let read =
        |(key, value): &(Text, Json)| Ok((Address::parse(key, source)?, claim::claim(value, &key.value, source)?));
    fields::object(json, "\"equations\"")?.iter().map(read).collect()
}

fn sentences(fields: &Fields<'_>, source: &Source) -> Result<Vec<Sentence>, Fault> {
    match fields.get("sentences") {
        None => Ok(Vec::new()),
        Some(Json { value: Value::Array(items), .. }) => {
            items.iter().map(|item| sentence::sentence(item, source)).collect()
        }
        Some(json) => Err(fields::wrong(json, "sentences", "a list")),
    }
}

/// Rejects a symbol that is declared twice. `V` and `V(r)` are one symbol.
fn once<'a>(names: impl Iterator<Item = &'a Text>, fields: &Fields<'_>, source: &Source) -> Result<(), Fault> {
    let mut seen: std::collections::HashMap<String, Span> = std::collections::HashMap::new();
    for name in names {
        if let Some(first) = seen.insert(normalized(head(&name.value)), name.span) {
            let (line, column) = source.line_column(first.start);
            let keys = [first, name.span].map(|span| fields.key_at(span).unwrap_or("the claims file"));
            let message = match keys {
                [one, other] if one == other => {
                    format!("{} is declared twice under \"{one}\"; first at {line}:{column}", name.value)
                }
                [one, other] => {
                    format!("{} is declared under \"{one}\", at {line}:{column}, and under \"{other}\"", name.value)
                }
            };
            return Err(Fault::claims(name.span, message).help("remove one of the two declarations"));
        }
    }
    Ok(())
}

/// A symbol without the arguments that it is shown with: the `V` of `V(r)`.
fn head(name: &str) -> &str {
    let mut braces = 0usize;
    for (at, c) in name.char_indices() {
        match c {
            '{' => braces += 1,
            '}' => braces = braces.saturating_sub(1),
            '(' if braces == 0 && at > 0 => return &name[..at],
            _ => {}
        }
    }
    name
}
