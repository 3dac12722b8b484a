//! The command line, run as a user runs it: its JSON, its exit codes, what it says when something is wrong.
//!
//! Every test works in a folder of its own; `support` copies the documents there and may change one place in them.

#[path = "cli/support.rs"]
mod support;

#[path = "cli/bad_input.rs"]
mod bad_input;
#[path = "cli/contract.rs"]
mod contract;
#[path = "cli/damage.rs"]
mod damage;
#[path = "cli/derive.rs"]
mod derive;
#[path = "cli/explain.rs"]
mod explain;
#[path = "cli/formats.rs"]
mod formats;
#[path = "cli/formulas.rs"]
mod formulas;
#[path = "cli/init.rs"]
mod init;
#[path = "cli/mark.rs"]
mod mark;
#[path = "cli/mark_classes.rs"]
mod mark_classes;
#[path = "cli/mark_letters.rs"]
mod mark_letters;
#[path = "cli/mark_motion.rs"]
mod mark_motion;
#[path = "cli/mark_numbers.rs"]
mod mark_numbers;
#[path = "cli/mark_starts.rs"]
mod mark_starts;
#[path = "cli/mark_states.rs"]
mod mark_states;
#[path = "cli/mark_steps.rs"]
mod mark_steps;
#[path = "cli/mark_trials.rs"]
mod mark_trials;
#[path = "cli/messages.rs"]
mod messages;
#[path = "cli/mutate.rs"]
mod mutate;
#[path = "cli/printed/constraints.rs"]
mod printed_constraints;
#[path = "cli/printed/lagrangian.rs"]
mod printed_lagrangian;
#[path = "cli/printed/motions.rs"]
mod printed_motions;
#[path = "cli/printed/prose.rs"]
mod printed_prose;
#[path = "cli/printed/textbooks.rs"]
mod printed_textbooks;
#[path = "cli/report.rs"]
mod report;
#[path = "cli/reprint.rs"]
mod reprint;
#[path = "cli/requests.rs"]
mod requests;
#[path = "cli/schema.rs"]
mod schema;
#[path = "cli/steps.rs"]
mod steps;
#[path = "cli/strangers.rs"]
mod strangers;
#[path = "cli/typst.rs"]
mod typst;
#[path = "cli/unaided.rs"]
mod unaided;
#[path = "cli/unaided_cases.rs"]
mod unaided_cases;
#[path = "cli/unaided_chains.rs"]
mod unaided_chains;
#[path = "cli/unaided_contradictions.rs"]
mod unaided_contradictions;
#[path = "cli/unaided_differentials.rs"]
mod unaided_differentials;
#[path = "cli/unaided_letters.rs"]
mod unaided_letters;
#[path = "cli/unaided_places.rs"]
mod unaided_places;
#[path = "cli/unaided_premises.rs"]
mod unaided_premises;
#[path = "cli/unaided_readings.rs"]
mod unaided_readings;
#[path = "cli/unaided_restated.rs"]
mod unaided_restated;
#[path = "cli/unaided_sentences.rs"]
mod unaided_sentences;
#[path = "cli/unaided_series.rs"]
mod unaided_series;
#[path = "cli/unaided_solutions.rs"]
mod unaided_solutions;
#[path = "cli/unaided_states.rs"]
mod unaided_states;
#[path = "cli/watch.rs"]
mod watch;
#[path = "cli/widths.rs"]
mod widths;
#[path = "cli/wording.rs"]
mod wording;
#[path = "cli/writing.rs"]
mod writing;
