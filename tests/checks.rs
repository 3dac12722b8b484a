//! What is checked and what is not: small documents whose claims are true, each beside a twin that is not.

#[path = "checks/support.rs"]
mod support;

#[path = "checks/claims.rs"]
mod claims;
#[path = "checks/evidence.rs"]
mod evidence;
#[path = "checks/own_system.rs"]
mod own_system;
#[path = "checks/sentences.rs"]
mod sentences;
#[path = "checks/units.rs"]
mod units;
