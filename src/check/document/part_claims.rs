//! Claims about one row, one statement or one step of a display: `"3 row 2"`, `"3 part 2"`, `"3 step 1"`.
//!
//! The reading of the display is divided: what has a claim of its own is judged under it, and the rest under the claim of the
//! display.

use crate::formula::Statement;
use crate::latex::{DefinedSymbol, Reading};
use crate::notes::claims::Claim;
use crate::{Error, Result};

use crate::check::document::checker::Checker;

/// A piece of a reading, and the claim about it alone.
type Piece<'c> = (Reading, Option<&'c Claim>);

impl<'a> Checker<'a> {
    /// The pieces of the reading of a display, in their order; one without a claim if no part has one.
    ///
    /// # Errors
    /// For an address of a part that the display does not have, or with two claims.
    pub(crate) fn pieces(&self, display: usize, reading: &Reading) -> Result<Vec<Piece<'a>>> {
        let mut own: Vec<(usize, Option<usize>, &'a Claim)> = Vec::new();
        for (address, claim) in &self.claims.equations {
            for place in address.lookup(self.notes, &self.claims.source)?.into_iter().filter(|p| p.display == display) {
                if place.row.or(place.part).or(place.step).is_none() {
                    continue;
                }
                let chosen: Vec<usize> = (0..reading.statements.len())
                    .filter(|at| place.part.is_none_or(|part| part == at + 1))
                    .filter(|at| {
                        let row = reading.statements[*at].as_ref().map(|statement| statement.row);
                        place.row.is_none_or(|wanted| row.is_ok_and(|row| row == wanted))
                    })
                    .collect();
                let steps = |at: &usize| reading.statements[*at].as_ref().map_or(0, |s| s.relations.len());
                let has_step = |at: &usize| place.step.is_none_or(|step| (1..=steps(at)).contains(&step));
                let is_read = reading.statements.iter().all(std::result::Result::is_ok);
                if is_read && (chosen.is_empty() || !chosen.iter().all(has_step)) {
                    let rows = reading.statements.iter().flatten().map(|statement| statement.row).max().unwrap_or(1);
                    let counted = |count: usize, what: &str| match count {
                        1 => format!("1 {what}"),
                        count => format!("{count} {what}s"),
                    };
                    let message = format!(
                        "the display has no such part: it has {} and {}",
                        counted(rows, "row"),
                        counted(reading.statements.len(), "part")
                    );
                    return Err(Error::at(&self.claims.source, address.span, message)
                        .help("rows, parts and steps count from 1; a step is one relation of a chain"));
                }
                for at in chosen {
                    if own.iter().any(|(known, step, _)| *known == at && (*step == place.step || step.is_none())) {
                        return Err(Error::at(&self.claims.source, address.span, "this part has two claims")
                            .help("put all keys of the part under one address"));
                    }
                    own.push((at, place.step, claim));
                }
            }
        }
        if own.is_empty() {
            return Ok(vec![(reading.clone(), None)]);
        }
        let mut pieces: Vec<Piece<'a>> = Vec::new();
        for (at, statement) in reading.statements.iter().enumerate() {
            let mut claims: Vec<(Option<usize>, &'a Claim)> =
                own.iter().filter(|(known, ..)| *known == at).map(|(_, step, claim)| (*step, *claim)).collect();
            claims.sort_by_key(|(step, _)| *step);
            match (statement, claims.as_slice()) {
                (Ok(statement), [(Some(_), _), ..]) => {
                    let last = statement.members.len() - 1;
                    let mut done = 0;
                    for (step, claim) in claims.iter().filter_map(|(step, claim)| Some(((*step)?, *claim))) {
                        if step - 1 > done {
                            pieces.push((slice(reading, at, statement, (done, step - 1)), None));
                        }
                        pieces.push((slice(reading, at, statement, (step - 1, step)), Some(claim)));
                        done = step;
                    }
                    if done < last {
                        pieces.push((slice(reading, at, statement, (done, last)), None));
                    }
                }
                (_, claims) => pieces.push((only(reading, at), claims.first().map(|(_, claim)| *claim))),
            }
        }
        Ok(pieces)
    }
}

/// One statement of a reading with the names that it introduces.
fn only(reading: &Reading, at: usize) -> Reading {
    let introduced = reading.introduced.iter().filter(|new| new.statement == at);
    Reading {
        statements: vec![reading.statements[at].clone()],
        introduced: introduced.map(|new| DefinedSymbol { statement: 0, ..new.clone() }).collect(),
    }
}

/// The members of a statement from one to another.
fn slice(reading: &Reading, at: usize, statement: &Statement, (from, to): (usize, usize)) -> Reading {
    let members = statement.members[from..=to].to_vec();
    let span = members[0].span.to(members[to - from].span);
    let is_end = to + 1 == statement.members.len();
    let part = Statement {
        relations: statement.relations[from..to].to_vec(),
        constant: statement.constant.filter(|_| is_end),
        members,
        span,
        ..statement.clone()
    };
    let here = reading.introduced.iter().filter(|new| new.statement == at && (from..=to).contains(&new.member));
    let here = here.filter(|new| new.member > from || from == 0);
    Reading {
        statements: vec![Ok(part)],
        introduced: here.map(|new| DefinedSymbol { statement: 0, member: new.member - from, ..new.clone() }).collect(),
    }
}
