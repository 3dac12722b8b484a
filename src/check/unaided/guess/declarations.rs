//! The declarations of an inferred claims file: which names are coordinates, constants or functions, and with which ranges.
//!
//! Offers `Guess`, which grows while displays that lack a name are read again. Knows `usage` and `ordered`.

use std::path::Path;
use std::sync::Arc;

use serde_json::{Map, Value, json};

use crate::Result;
use crate::formula::symbols::Name;
use crate::latex::names;
use crate::notes::{Claims, Notes, claims_beside};
use crate::source::Source;

use crate::check::unaided::guess::letters::{is_reserved, is_reserved_name};
use crate::check::unaided::guess::values::Value as OneValue;
use crate::check::unaided::ordered::Ordered;
use crate::check::usage::Usage;

/// Letters whose hat marks a direction.
const DIRECTIONS: [&str; 20] = [
    "x", "y", "z", "r", "n", "k", "s", "t", "u", "v", "e", "i", "j", "\\rho", "\\theta", "\\phi", "\\varphi",
    "\\imath", "\\jmath", "\\ell",
];

/// Letters that change where a formula with them is said to be constant, as in `pV^\gamma = \text{const}`.
const QUANTITIES_OF_STATE: [&str; 8] = ["p", "P", "V", "v", "T", "S", "U", "y"];

/// The range of γ in the exponents of an adiabat, C_p/C_V.
const HEATS: &str = "(1, 3)";

/// Letters for quantities that are positive in each state if they are in one.
const MEASURES: [&str; 14] = ["p", "P", "V", "T", "m", "M", "R", "C", "L", "n", "N", "\\rho", "\\lambda", "\\ell"];

/// A name with the formula that the notes give it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Formula {
    /// The name.
    pub name: Name,
    /// The formula, in LaTeX.
    pub latex: String,
}

/// A coordinate that is a multiple of another one, x = Rφ, where the Lagrangian is differentiated by the first.
struct Rolling {
    /// φ
    depends: Name,
    /// x
    coordinate: Name,
    /// R
    factors: Vec<Name>,
}

fn rolling(usages: &[Usage]) -> Option<Rolling> {
    let find = |name: &Name| usages.iter().find(|usage| usage.name == *name);
    usages.iter().filter(|usage| usage.differentiates && usage.moves && defined(usage)).find_map(|usage| {
        let product = usage.product.as_ref()?;
        let (moving, factors): (Vec<&Name>, Vec<&Name>) =
            product.iter().partition(|name| find(name).is_some_and(|usage| usage.moves));
        let [depends] = moving.as_slice() else { return None };
        let is_free = find(depends).is_some_and(|usage| !usage.differentiates && !defined(usage));
        (is_free && !factors.is_empty()).then(|| Rolling {
            depends: (*depends).clone(),
            coordinate: usage.name.clone(),
            factors: factors.into_iter().cloned().collect(),
        })
    })
}

/// Whether a name is differentiated with d by another one, or another one by it, where no formula says how the one depends on the
/// other, or one of its powers only, as in `\omega^2 = gk`: dM/dx is then the quotient of two rates.
fn runs_along(usage: &Usage, usages: &[Usage]) -> bool {
    let is_unknown = |usage: &&Usage| (!usage.given || usage.only_a_power) && usage.arguments.is_none();
    let by_it = |other: &&Usage| other.differentiated_by.contains(&usage.name);
    is_unknown(&usage) && !usage.differentiated_by.is_empty()
        || usages.iter().filter(is_unknown).any(|other| by_it(&other))
}

/// Whether a display defines a name, before any other display uses it.
fn defined(usage: &Usage) -> bool {
    usage.introduced == Some(usage.first)
}

/// The declarations of a claims file.
#[derive(Clone, Debug, Default)]
pub(super) struct Guess {
    keys: Map<String, Value>,
    /// The formulas that stand for one name whose shape was changed.
    reshaped: Vec<String>,
    /// The letters that stand for vectors and matrices.
    ordered: Vec<Ordered>,
}

impl Guess {
    /// The guess where a name is the Lagrangian, perhaps, whose formula contains some names.
    pub fn of(usages: &[Usage], (lagrangian, inside): (Option<&Name>, &[Name]), ordered: &[Ordered]) -> Guess {
        let mut guess = Guess { ordered: ordered.to_vec(), ..Guess::default() };
        // An orbit r(φ) moves as the place does.
        let is_function = |usage: &Usage| {
            usage.arguments.as_ref().is_some_and(|of| *of != [Name::plain("t")] && (!usage.moves || of.len() > 1))
        };
        let is_of_time = |usage: &Usage| usage.arguments.as_ref().is_some_and(|of| *of == [Name::plain("t")]);
        let rolling = lagrangian.and_then(|_| rolling(usages));
        let is_ratio_of_heats = |usage: &Usage| {
            usage.raises && ["\\gamma", "\\kappa"].iter().any(|letter| usage.name == Name::plain(*letter))
        };
        let has_heats = usages.iter().any(is_ratio_of_heats);
        let is_known = |usage: &Usage| match &rolling {
            Some(rolling) if rolling.depends == usage.name => true,
            Some(rolling) if rolling.coordinate == usage.name => false,
            _ if usage.only_a_power && lagrangian.is_none() && runs_along(usage, usages) => false,
            _ => (defined(usage) || usage.given && is_function(usage)) && !is_of_time(usage),
        };
        // A transmission coefficient t, where nothing moves.
        let is_timeless = !usages.iter().any(|usage| usage.moves || is_of_time(usage));
        let is_coefficient = |usage: &Usage| is_timeless && usage.given && usage.name == Name::plain("t");
        for usage in usages.iter().filter(|usage| is_coefficient(usage) || !is_reserved(usage) && !is_known(usage)) {
            let name = usage.name.to_string();
            let plain = Name { primes: 0, ..usage.name.clone() };
            // A prime on a function is its derivative.
            if usage.name.primes > 0 && usages.iter().any(|other| other.name == plain && other.arguments.is_some()) {
                continue;
            }
            let shape = ordered.iter().find(|letter| letter.name == usage.name).map(|letter| letter.range.as_deref());
            let is_vector = shape.is_some()
                || ["\\vec{", "\\mathbf{", "\\boldsymbol{", "\\bm{"].iter().any(|mark| name.starts_with(mark));
            let is_argument = usages
                .iter()
                .any(|other| other.given && other.arguments.as_ref().is_some_and(|of| of.contains(&usage.name)));
            let is_of_state = usage.conserved && usage.name.subscript.is_empty();
            let changes = is_of_state && QUANTITIES_OF_STATE.contains(&usage.name.base.as_str());
            let runs = lagrangian.is_none() && runs_along(usage, usages);
            let moves = usage.moves || is_of_time(usage) || changes && lagrangian.is_none() || runs;
            // A quantity of one kind has one sign in all states. What has a power other than a whole one is not negative.
            let is_alike = |other: &Usage| other.positive && other.name.base == usage.name.base;
            let is_measure = MEASURES.contains(&usage.name.base.as_str());
            // Of a positive number nobody prints the modulus.
            let positive = !usage.modulus
                && !usage.opposite
                && (usage.positive || usage.exponential || is_measure && (has_heats || usages.iter().any(is_alike)));
            let range = match (is_vector, usage.angle, positive) {
                (false, ..) if is_ratio_of_heats(usage) => HEATS,
                (true, ..) => shape.flatten().unwrap_or("any"),
                (_, true, _) => "angle",
                (_, _, true) => "> 0",
                _ => "any",
            };
            match &usage.arguments {
                Some(of) if is_function(usage) && !is_vector && of.len() <= 3 && !of.contains(&usage.name) => {
                    let of: Vec<String> = of.iter().map(ToString::to_string).collect();
                    guess.declare("functions", &name, &format!("of {}", of.join(", ")));
                }
                _ if moves && lagrangian.is_some() && !is_vector => guess.declare("coordinates", &name, range),
                // An acceleration a in a Lagrangian is constant, though \ddot x = a says that it is equal to what moves.
                _ if moves || is_argument || usage.follows && !inside.contains(&usage.name) => {
                    guess.declare("varies with time", &name, range)
                }
                _ => guess.declare("constants", &name, range),
            }
        }
        if let Some(Rolling { depends, coordinate, factors }) = &rolling {
            let factors: Vec<String> = factors.iter().map(ToString::to_string).collect();
            let formula = format!("\\frac{{{coordinate}}}{{{}}}", factors.join(" "));
            guess.define(&depends.to_string(), &formula);
        }
        if let Some(lagrangian) = lagrangian {
            guess.keys.insert("means".to_owned(), json!({ lagrangian.to_string(): "Lagrangian" }));
        }
        guess
    }

    /// Gives a name a formula.
    pub fn define(&mut self, name: &str, formula: &str) {
        self.declare("define", name, formula);
    }

    /// Declares a name under a key.
    pub fn declare(&mut self, role: &str, name: &str, range: &str) {
        let group = self.keys.entry(role).or_insert_with(|| json!({}));
        if let Value::Object(group) = group {
            group.insert(name.to_owned(), json!(range));
        }
    }

    /// Whether a name is declared.
    pub fn declares(&self, name: &str) -> bool {
        self.keys.values().any(|group| group.get(name).is_some())
    }

    /// The names that a key declares.
    pub fn names(&self, role: &str) -> Vec<String> {
        let group = self.keys.get(role).and_then(Value::as_object);
        group.into_iter().flat_map(|group| group.keys().cloned()).collect()
    }

    /// The same without some names of a key.
    pub fn without(&self, role: &str, names: &[String]) -> Guess {
        let mut guess = self.clone();
        if let Some(group) = guess.keys.get_mut(role).and_then(Value::as_object_mut) {
            group.retain(|name, _| !names.contains(name));
        }
        guess
    }

    /// Declares formulas that stand for one name; returns whether one of them is new.
    pub fn add_values(&mut self, values: &[OneValue]) -> bool {
        let mut is_new = false;
        let has_motion = self.keys.contains_key("coordinates");
        for OneValue { name, moves, is_vector, differential_of, is_given } in values {
            if !self.declares(name) {
                is_new = true;
                // All differentials of a display are taken along one process, so they are as rates are.
                if let Some(of) = differential_of.as_ref().filter(|_| !has_motion && !is_vector) {
                    self.declare("formulas as names", name, "rate");
                    self.release_constant(&of.to_string());
                    continue;
                }
                let kind = match (moves, is_vector) {
                    (_, false) if *is_given => "given by a display",
                    (false, false) => "constant",
                    (true, false) => "varies with time",
                    (false, true) => "constant vector",
                    (true, true) => "vector that varies with time",
                };
                self.declare("formulas as names", name, kind);
            }
        }
        is_new
    }

    /// Declares formulas that stand for one name and that no display gives after all; returns whether there is one.
    pub fn take_given(&mut self, missing: &[String]) -> bool {
        let Some(group) = self.keys.get_mut("formulas as names").and_then(Value::as_object_mut) else { return false };
        let mut is_one = false;
        for (name, kind) in group.iter_mut() {
            if missing.contains(name) && kind.as_str() == Some("given by a display") {
                *kind = json!("varies with time");
                is_one = true;
            }
        }
        is_one
    }

    /// Makes a number of a formula that stands for a vector, or a vector of one that stands for a number, where a display
    /// does not fit; each once. Returns whether there is one.
    pub fn reshape(&mut self, misshapen: &[(usize, String)]) -> bool {
        let Some(group) = self.keys.get_mut("formulas as names").and_then(Value::as_object_mut) else { return false };
        let (mut is_one, mut displays) = (false, Vec::new());
        for (display, name) in misshapen {
            if displays.contains(display) || self.reshaped.contains(name) {
                continue;
            }
            let other = match group.get(name).and_then(Value::as_str) {
                Some("constant") => "constant vector",
                Some("varies with time") => "vector that varies with time",
                Some("constant vector") => "constant",
                Some(_) => "varies with time",
                None => continue,
            };
            group.insert(name.clone(), json!(other));
            displays.push(*display);
            self.reshaped.push(name.clone());
            is_one = true;
        }
        is_one
    }

    /// Declares names as constants; returns whether one of them is new.
    pub fn add(&mut self, missing: &[String], directions: bool) -> bool {
        let mut is_new = false;
        for name in missing {
            let Some((parsed, _)) = names::parse(name) else { continue };
            // A direction is that of a vector.
            let parsed = match parsed.base.strip_prefix("\\hat{").and_then(|inner| inner.strip_suffix('}')) {
                Some(inner) if directions && DIRECTIONS.contains(&inner) => {
                    Name { base: format!("\\vec{{{inner}}}"), ..parsed.clone() }
                }
                _ => parsed,
            };
            let name = parsed.to_string();
            if !self.declares(&name) && !is_reserved_name(&parsed) && !name.starts_with("\\hat") {
                let shape = self.ordered.iter().find(|letter| letter.name == parsed);
                let range = shape.and_then(|letter| letter.range.clone()).unwrap_or_else(|| "any".to_owned());
                self.declare("constants", &name, &range);
                is_new = true;
            }
        }
        is_new
    }

    /// Makes quantities of their own of the differentials; returns whether there is one.
    pub fn without_rates(&mut self) -> bool {
        let Some(group) = self.keys.get_mut("formulas as names").and_then(Value::as_object_mut) else { return false };
        let mut rates: Vec<&mut Value> = group.values_mut().filter(|value| value.as_str() == Some("rate")).collect();
        rates.iter_mut().for_each(|value| **value = json!("constant"));
        !rates.is_empty()
    }

    /// Lets a constant vary with time.
    fn release_constant(&mut self, name: &str) {
        let range = self.keys.get_mut("constants").and_then(Value::as_object_mut).and_then(|group| group.remove(name));
        if let Some(range) = range {
            self.declare("varies with time", name, range.as_str().unwrap_or("any"));
        }
    }

    /// Lets coordinates vary freely; returns whether there is one.
    pub fn release(&mut self, coordinates: &[String]) -> bool {
        let mut is_one = false;
        for name in coordinates {
            let range =
                self.keys.get_mut("coordinates").and_then(Value::as_object_mut).and_then(|group| group.remove(name));
            if let Some(range) = range {
                self.declare("varies with time", name, range.as_str().unwrap_or("any"));
                is_one = true;
            }
        }
        is_one
    }

    pub fn claims(&self, notes: &Notes) -> Result<Claims> {
        let path = Path::new(&notes.source.path);
        let beside = claims_beside(path);
        let mut keys = self.keys.clone();
        let own =
            path.file_name().map_or_else(|| notes.source.path.clone(), |name| name.to_string_lossy().into_owned());
        keys.insert("notes".to_owned(), json!(own));
        keys.insert("guesses".to_owned(), json!({}));
        let text = format!("{:#}\n", Value::Object(keys));
        Claims::parse(Arc::new(Source::new(format!("{} (inferred)", beside.display()), text)), &beside)
    }
}
