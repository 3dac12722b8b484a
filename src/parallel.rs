//! The threads of a check.
//!
//! Laws that determine each other are followed in turn, each at one derivative less than the one before, and formulas are
//! evaluated by recursion. Both are bounded, and need more stack than a thread has that a test harness or rayon starts
//! (2 MB), above all in a build without optimisation. So checks run on threads of their own.

use std::sync::LazyLock;

use rayon::{ThreadPool, ThreadPoolBuilder};

/// The stack of each thread, in bytes. Memory is taken only as far as it is used.
const STACK: usize = 64 << 20;

static POOL: LazyLock<Option<ThreadPool>> = LazyLock::new(|| ThreadPoolBuilder::new().stack_size(STACK).build().ok());

/// Runs work, and what it runs in parallel, on threads with a deep stack. Where there can be none, it runs on this one.
pub(crate) fn on_deep_stacks<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    match POOL.as_ref() {
        Some(pool) => pool.install(work),
        None => work(),
    }
}
