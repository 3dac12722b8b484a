//! The claim about one equation in the claims file. Every key is optional.

use super::fields::{self, Fields, Text};
use crate::notes::address::Address;
use crate::notes::json::{Json, Spanned, Value};
use crate::source::{Fault, Source, Span};

/// The claim about an equation, in addition to its printed formula.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Claim {
    /// The whole object.
    pub span: Span,
    /// `holds`: pins the reading.
    pub holds: Option<Spanned<Holds>>,
    /// `assume`: hypotheses at the instant of the equation.
    pub assume: Vec<Spanned<String>>,
    /// `throughout`: hypotheses at all times.
    pub throughout: Vec<Spanned<String>>,
    /// `where`: what symbols mean in this equation only.
    pub meanings: Vec<(Spanned<String>, Spanned<String>)>,
    /// `also equals`: a link added to the chain.
    pub also_equals: Option<Spanned<String>>,
    /// `conserved`
    pub conserved: Option<Spanned<Conserved>>,
    /// `solves` and `for`
    pub solves: Option<Solves>,
    /// `limit`: `x \to a`.
    pub limit: Option<Spanned<String>>,
    /// `dropping`: the terms that the printed equation leaves out.
    pub dropping: Option<Spanned<String>>,
    /// `erratum`: corrections.
    pub errata: Vec<Erratum>,
    /// `expect` and `because`
    pub expect: Option<Expect>,
    /// `skip`: why there is no claim.
    pub skip: Option<Spanned<String>>,
    /// `generates`: the consequences of the printed function.
    pub generates: Option<Spanned<Generates>>,
    /// `for each`: the index of a family that the printed equation leaves out.
    pub for_each: Option<Spanned<String>>,
    /// `small`: the symbols that scale with one small number.
    pub small: Vec<Spanned<String>>,
    /// `order`: the power of the small number up to which both sides agree; 1 if only `small` is given.
    pub order: Option<Spanned<u32>>,
    /// `continuum limit of`: the equation for particles whose continuum limit this equation is.
    pub continuum_limit_of: Option<Address>,
    /// `true exactly when`: the alternatives, each a list of conditions that hold together.
    pub exactly_when: Vec<Vec<Spanned<String>>>,
    /// `same motion as`: another Lagrangian.
    pub same_motion_as: Option<Spanned<String>>,
    /// `symmetry`: the change of each coordinate under the symmetry whose charge is printed.
    pub symmetry: Vec<(Spanned<String>, Spanned<String>)>,
    /// `equilibrium`: the printed positions are equilibria.
    pub equilibrium: Option<Spanned<Equilibrium>>,
    /// `at`: where the coordinates are in this equilibrium.
    pub at: Vec<(Spanned<String>, Spanned<String>)>,
    /// `secular equation for`: the frequency of which the equation is the secular equation.
    pub secular_for: Option<Spanned<String>>,
    /// `units`: the place of `off`.
    pub units_off: Option<Span>,
    /// Hypotheses that the prose makes, and no claims file: `\theta_0` is where the system rests.
    pub implied: Vec<Spanned<String>>,
    /// The same, of hypotheses that hold at all times: `x = r\cos\phi` in polar coordinates.
    pub implied_throughout: Vec<Spanned<String>>,
}

/// When an equation holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holds {
    /// At all states.
    Always,
    /// On the solutions of the equations of motion.
    OnShell,
}

/// What is conserved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Conserved {
    /// The quantity that the equation is about.
    This,
    /// This LaTeX.
    Expression(String),
}

/// An equation that is a solution.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Solves {
    /// Of what.
    pub of: Solved,
    /// For which unknowns.
    pub unknowns: Vec<Spanned<String>>,
    /// Whether the printed branches must be all solutions.
    pub complete: bool,
}

/// What is solved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Solved {
    /// `equations of motion`
    EquationsOfMotion(Span),
    /// An equation of the notes.
    Equation(Address),
}

/// What a printed function generates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Generates {
    /// `the motion`: Hamilton's equations from the printed Hamiltonian give the motion.
    TheMotion,
}

/// What is claimed of an equilibrium.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equilibrium {
    /// `true`: the system stays at rest there.
    Any,
    /// `stable`: it is a stable one.
    Stable,
    /// `unstable`: it is an unstable one.
    Unstable,
    /// `steady`: the other coordinates stay there while cyclic ones move steadily, as on a circular orbit.
    Steady,
}

/// A correction: "for … read …".
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Erratum {
    /// What is printed.
    pub printed: Spanned<String>,
    /// What it should be.
    pub read: Spanned<String>,
    /// How often it is printed so.
    pub times: usize,
    /// Why.
    pub because: Option<Spanned<String>>,
}

/// An expected verdict that is no pass.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expect {
    /// Which.
    pub verdict: Spanned<Expected>,
    /// Why.
    pub because: Spanned<String>,
}

/// The verdicts that can be expected: those that are no pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expected {
    /// `refuted`
    Refuted,
    /// `domain`
    Domain,
    /// `undecided`
    Undecided,
    /// `unreadable`
    Unreadable,
    /// `unclaimed`
    Unclaimed,
}

/// The keys of a claim.
pub(super) const KEYS: &[&str] = &[
    "holds",
    "assume",
    "throughout",
    "where",
    "also equals",
    "conserved",
    "solves",
    "for",
    "limit",
    "dropping",
    "erratum",
    "expect",
    "because",
    "skip",
    "generates",
    "for each",
    "small",
    "order",
    "continuum limit of",
    "true exactly when",
    "same motion as",
    "symmetry",
    "equilibrium",
    "at",
    "secular equation for",
    "units",
];

/// Keys that are planned and not supported yet.
pub(super) const LATER: &[&str] = &[
    "up to a constant",
    "times",
    "divided by",
    "defines",
    "equation of motion of",
    "from",
    "starting at",
    "up to a term without",
    "up to a factor without",
    "up to a total time derivative",
    "equivalent to",
    "minimum of",
];

/// The highest order of an expansion.
const HIGHEST_ORDER: u32 = 9;

/// Reads the claim about the equation at `address`.
pub(super) fn claim(json: &Json, address: &str, source: &Source) -> Result<Claim, Fault> {
    let fields = Fields::new(json, &format!("the claim for \"{address}\""), &[KEYS], LATER)?;
    fields.together("solves", "for", "write the equation under \"solves\", and the unknown under \"for\"")?;
    let mut claim = shared(&fields, source)?;
    claim.solves = solves(&fields, source)?;
    Ok(claim)
}

/// The keys that equations and sentences share: all but `solves` and `for`, which differ beside `solutions`.
pub(super) fn shared(fields: &Fields<'_>, source: &Source) -> Result<Claim, Fault> {
    fields.together("expect", "because", "write the verdict under \"expect\", and the reason under \"because\"")?;
    let holds = fields.text("holds")?;
    let generates = fields.text("generates")?;
    let units = fields.text("units")?;
    let generating = |g: &Text| fields::word(g, "generates", &[("the motion", Generates::TheMotion)]);
    Ok(Claim {
        span: fields.span,
        holds: holds
            .map(|h| fields::word(&h, "holds", &[("always", Holds::Always), ("on shell", Holds::OnShell)]))
            .transpose()?,
        assume: fields.texts("assume")?,
        throughout: fields.texts("throughout")?,
        meanings: fields.pairs("where")?,
        also_equals: fields.text("also equals")?,
        conserved: conserved(fields)?,
        solves: None,
        limit: limit(fields)?,
        dropping: fields.text("dropping")?,
        errata: errata(fields)?,
        expect: expect(fields)?,
        skip: fields.text("skip")?,
        generates: generates.as_ref().map(generating).transpose()?,
        for_each: fields.text("for each")?,
        order: order(fields)?,
        small: small(fields, source)?,
        continuum_limit_of: fields.text("continuum limit of")?.map(|of| Address::parse(&of, source)).transpose()?,
        exactly_when: exactly_when(fields)?,
        same_motion_as: fields.text("same motion as")?,
        symmetry: fields.declared("symmetry", source)?,
        equilibrium: equilibrium(fields)?,
        at: fields.declared("at", source)?,
        secular_for: fields.text("secular equation for")?,
        units_off: units.map(|off| fields::word(&off, "units", &[("off", ())])).transpose()?.map(|off| off.span),
        implied: Vec::new(),
        implied_throughout: Vec::new(),
    })
}

fn small(fields: &Fields<'_>, source: &Source) -> Result<Vec<Text>, Fault> {
    let mut small = Vec::new();
    for list in fields.texts("small")? {
        small.extend(fields::names(&list, source)?);
    }
    Ok(small)
}

fn order(fields: &Fields<'_>) -> Result<Option<Spanned<u32>>, Fault> {
    let small = fields.entry("small").map(|(key, _)| Spanned::new(1, key.span));
    let Some((key, json)) = fields.entry("order") else { return Ok(small) };
    if small.is_none() {
        return Err(Fault::claims(key.span, "\"order\" needs \"small\" beside it")
            .help("write the name of the small quantity under \"small\""));
    }
    let order = fields::count(json, "order")?;
    match u32::try_from(order.value) {
        Ok(value) if value <= HIGHEST_ORDER => Ok(Some(Spanned::new(value, order.span))),
        _ => Err(Fault::claims(order.span, format!("\"order\" must be at most {HIGHEST_ORDER}"))
            .help("write 1 for an equation that holds to first order in the small quantity")),
    }
}

/// The conditions under which a claim holds, and only under which it holds.
fn exactly_when(fields: &Fields<'_>) -> Result<Vec<Vec<Text>>, Fault> {
    const KEY: &str = "true exactly when";
    let Some(json) = fields.get(KEY) else { return Ok(Vec::new()) };
    if !matches!(json.value, Value::Object(_)) {
        return Ok(vec![fields::texts(json, KEY)?]);
    }
    let inner = Fields::new(json, &format!("\"{KEY}\""), &[&["any of"]], &[])?;
    match inner.get("any of") {
        Some(Json { value: Value::Array(items), .. }) if !items.is_empty() => {
            items.iter().map(|item| fields::texts(item, "any of")).collect()
        }
        Some(json) => Err(fields::wrong(json, "any of", "a list of conditions")),
        None => Err(Fault::claims(json.span, format!("\"{KEY}\" is empty"))
            .help("write alternatives as in { \"any of\": [\"a = 0\", \"b = 0\"] }")),
    }
}

fn conserved(fields: &Fields<'_>) -> Result<Option<Spanned<Conserved>>, Fault> {
    match fields.get("conserved") {
        Some(json @ Json { value: Value::String(_), .. }) => {
            let text = fields::text(json, "conserved")?;
            if ["yes", "no", "true", "false"].contains(&text.value.trim()) {
                let message = format!("“{}” is not a formula", text.value);
                return Err(Fault::claims(text.span, message)
                    .help("write true without quotation marks, or the LaTeX of the constant quantity"));
            }
            Ok(Some(text.map(Conserved::Expression)))
        }
        Some(json) if !matches!(json.value, Value::Bool(_)) => Err(fields::wrong(json, "conserved", "true or LaTeX")),
        _ => Ok(fields.on("conserved")?.map(|span| Spanned::new(Conserved::This, span))),
    }
}

fn equilibrium(fields: &Fields<'_>) -> Result<Option<Spanned<Equilibrium>>, Fault> {
    if let (Some((at, _)), None) = (fields.entry("at"), fields.entry("equilibrium")) {
        return Err(Fault::claims(at.span, "\"at\" needs \"equilibrium\" beside it")
            .help("write \"equilibrium\": true; \"at\" gives the values of the coordinates there"));
    }
    match fields.get("equilibrium") {
        Some(json @ Json { value: Value::String(_), .. }) => {
            let text = fields::text(json, "equilibrium")?;
            let words =
                [("stable", Equilibrium::Stable), ("unstable", Equilibrium::Unstable), ("steady", Equilibrium::Steady)];
            let fault = |fault: Fault| {
                fault.help("write true without quotation marks, or \"stable\", \"unstable\" or \"steady\"")
            };
            Ok(Some(fields::word(&text, "equilibrium", &words).map_err(fault)?))
        }
        Some(json) if !matches!(json.value, Value::Bool(_)) => {
            Err(fields::wrong(json, "equilibrium", "true, \"stable\", \"unstable\" or \"steady\""))
        }
        _ => Ok(fields.on("equilibrium")?.map(|span| Spanned::new(Equilibrium::Any, span))),
    }
}

fn solves(fields: &Fields<'_>, source: &Source) -> Result<Option<Solves>, Fault> {
    let Some(of) = fields.text("solves")? else { return Ok(None) };
    let of = match of.value.trim() {
        "equations of motion" => Solved::EquationsOfMotion(of.span),
        _ => Solved::Equation(Address::parse(&of, source)?),
    };
    Ok(Some(Solves { of, unknowns: fields.texts("for")?, complete: true }))
}

fn limit(fields: &Fields<'_>) -> Result<Option<Text>, Fault> {
    let limit = fields.text("limit")?;
    match &limit {
        Some(text) if !is_limit(&text.value) => {
            Err(Fault::claims(text.span, format!("\"{}\" is not a limit", text.value))
                .help("write a limit as in \"x \\\\to 0\""))
        }
        _ => Ok(limit),
    }
}

/// Whether a text is a limit, `x \to a`.
pub(super) fn is_limit(text: &str) -> bool {
    ["\\to", "\\rightarrow"].iter().any(|arrow| text.contains(arrow))
}

fn errata(fields: &Fields<'_>) -> Result<Vec<Erratum>, Fault> {
    let Some(json) = fields.get("erratum") else { return Ok(Vec::new()) };
    let items = match &json.value {
        Value::Array(items) if !items.is_empty() => items.as_slice(),
        _ => std::slice::from_ref(json),
    };
    items.iter().map(erratum).collect()
}

fn erratum(json: &Json) -> Result<Erratum, Fault> {
    let fields = Fields::new(json, "an erratum", &[&["for", "read", "times", "because"]], &[])?;
    let missing = |key: &str| {
        Fault::claims(json.span, format!("an erratum needs \"{key}\""))
            .help("write the printed text under \"for\", and the correct text under \"read\"")
    };
    let times = fields.count("times")?;
    if let Some(Spanned { value: 0, span }) = times {
        return Err(Fault::claims(span, "\"times\" must be at least 1"));
    }
    Ok(Erratum {
        printed: fields.text("for")?.ok_or_else(|| missing("for"))?,
        read: fields.text("read")?.ok_or_else(|| missing("read"))?,
        times: times.map_or(1, |times| times.value),
        because: fields.text("because")?,
    })
}

fn expect(fields: &Fields<'_>) -> Result<Option<Expect>, Fault> {
    let (Some(verdict), Some(because)) = (fields.text("expect")?, fields.text("because")?) else { return Ok(None) };
    if ["certified", "verified", "definition", "law"].contains(&verdict.value.as_str()) {
        return Err(Fault::claims(
            verdict.span,
            format!("\"expect\" is for verdicts that do not pass, and \"{}\" passes", verdict.value),
        )
        .help("remove \"expect\" and \"because\""));
    }
    const WORDS: &[(&str, Expected)] = &[
        ("refuted", Expected::Refuted),
        ("domain", Expected::Domain),
        ("undecided", Expected::Undecided),
        ("unreadable", Expected::Unreadable),
        ("unclaimed", Expected::Unclaimed),
    ];
    Ok(Some(Expect { verdict: fields::word(&verdict, "expect", WORDS)?, because }))
}
