//! What is checked and what is not: small documents whose claims are true, each beside a twin that is not.

#[path = "checks/support.rs"]
mod support;

#[path = "checks/algebra.rs"]
mod algebra;
#[path = "checks/branches.rs"]
mod branches;
#[path = "checks/certified.rs"]
mod certified;
#[path = "checks/chains.rs"]
mod chains;
#[path = "checks/claims.rs"]
mod claims;
#[path = "checks/continua.rs"]
mod continua;
#[path = "checks/coupled.rs"]
mod coupled;
#[path = "checks/difference.rs"]
mod difference;
#[path = "checks/digits.rs"]
mod digits;
#[path = "checks/doubles.rs"]
mod doubles;
#[path = "checks/edges.rs"]
mod edges;
#[path = "checks/evidence.rs"]
mod evidence;
#[path = "checks/families.rs"]
mod families;
#[path = "checks/forces.rs"]
mod forces;
#[path = "checks/laws.rs"]
mod laws;
#[path = "checks/mechanics.rs"]
mod mechanics;
#[path = "checks/names.rs"]
mod names;
#[path = "checks/other_branches.rs"]
mod other_branches;
#[path = "checks/own_system.rs"]
mod own_system;
#[path = "checks/preconditions.rs"]
mod preconditions;
#[path = "checks/prose_claims.rs"]
mod prose_claims;
#[path = "checks/prose_formulas.rs"]
mod prose_formulas;
#[path = "checks/prose_motions.rs"]
mod prose_motions;
#[path = "checks/rates.rs"]
mod rates;
#[path = "checks/repairs.rs"]
mod repairs;
#[path = "checks/rigid.rs"]
mod rigid;
#[path = "checks/sentences.rs"]
mod sentences;
#[path = "checks/shared.rs"]
mod shared;
#[path = "checks/sizes.rs"]
mod sizes;
#[path = "checks/small.rs"]
mod small;
#[path = "checks/solutions_of_laws.rs"]
mod solutions_of_laws;
#[path = "checks/special_cases.rs"]
mod special_cases;
#[path = "checks/starts.rs"]
mod starts;
#[path = "checks/steady.rs"]
mod steady;
#[path = "checks/steps.rs"]
mod steps;
#[path = "checks/symmetries.rs"]
mod symmetries;
#[path = "checks/terms.rs"]
mod terms;
#[path = "checks/textbook_systems.rs"]
mod textbook_systems;
#[path = "checks/units.rs"]
mod units;
#[path = "checks/values.rs"]
mod values;
#[path = "checks/wide.rs"]
mod wide;
#[path = "checks/worst.rs"]
mod worst;
