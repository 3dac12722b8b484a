//! How far a run has come: one line on standard error, where that is a terminal and the run takes more than a second.

use std::io::{IsTerminal, Write};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{JoinHandle, park_timeout};
use std::time::{Duration, Instant};

use crate::check::Progress;

/// A quicker run needs no line.
const PATIENCE: Duration = Duration::from_secs(1);

/// How often the line is written anew.
const TICK: Duration = Duration::from_millis(100);

/// Erases the line that the cursor stands in.
const ERASE: &str = "\r\u{1b}[2K";

/// How far the run is.
#[derive(Default)]
struct State {
    done: usize,
    document: String,
    over: bool,
}

/// The line of progress, erased when this is dropped. Without a terminal it does nothing.
pub(super) struct ProgressLine {
    state: Arc<Mutex<State>>,
    writer: Option<JoinHandle<()>>,
}

impl ProgressLine {
    /// Starts a run of so many items.
    pub(super) fn start(items: usize) -> ProgressLine {
        let state = Arc::new(Mutex::new(State::default()));
        let shared = state.clone();
        let writer = std::io::stderr()
            .is_terminal()
            .then(|| std::thread::spawn(move || write(&shared, items, PATIENCE, &mut std::io::stderr())));
        ProgressLine { state, writer }
    }

    fn with(&self, change: impl FnOnce(&mut State)) {
        change(&mut self.state.lock().unwrap_or_else(PoisonError::into_inner));
    }
}

impl Progress for ProgressLine {
    fn done(&self, document: &str) {
        self.with(|state| {
            state.done += 1;
            if state.document != document {
                document.clone_into(&mut state.document);
            }
        });
    }
}

impl Drop for ProgressLine {
    fn drop(&mut self) {
        self.with(|state| state.over = true);
        if let Some(writer) = self.writer.take() {
            writer.thread().unpark();
            // The thread is done, or has panicked; either way the report follows.
            let _ = writer.join();
        }
    }
}

/// Writes the line until the run is over. A terminal that has gone away needs no progress.
fn write(state: &Mutex<State>, items: usize, patience: Duration, terminal: &mut impl Write) {
    let mut print = |text: &str| drop(terminal.write_all(text.as_bytes()).and_then(|()| terminal.flush()));
    let started = Instant::now();
    let mut shown = false;
    loop {
        park_timeout(if shown { TICK } else { patience.saturating_sub(started.elapsed()) });
        let line = {
            let state = state.lock().unwrap_or_else(PoisonError::into_inner);
            if state.over {
                break;
            }
            format!("{} of {items} checked  {}", state.done, state.document)
        };
        if started.elapsed() >= patience {
            shown = true;
            print(&format!("{ERASE}{}", fitted(&line, width())));
        }
    }
    if shown {
        print(ERASE);
    }
}

fn width() -> usize {
    terminal_size::terminal_size_of(std::io::stderr()).map_or(80, |(width, _)| usize::from(width.0))
}

/// As much of a line as fits into one line of the terminal: a wrapped line could not be erased. Control characters, which a
/// path may have, would move the cursor; a character that is not ASCII may be two columns wide.
fn fitted(line: &str, width: usize) -> String {
    let mut columns = 0;
    let fits = |c: &char| {
        columns += if c.is_ascii() { 1 } else { 2 };
        columns < width
    };
    line.chars().map(|c| if c.is_control() { '?' } else { c }).take_while(fits).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a run of so long writes.
    fn written(patience: Duration, run: Duration) -> String {
        let state = Arc::new(Mutex::new(State::default()));
        let shared = state.clone();
        let writer = std::thread::spawn(move || {
            let mut terminal = Vec::new();
            write(&shared, 3, patience, &mut terminal);
            terminal
        });
        let terminal = ProgressLine { state: state.clone(), writer: None };
        terminal.done("top.md");
        std::thread::sleep(run);
        drop(terminal);
        writer.thread().unpark();
        String::from_utf8(writer.join().expect("it does not panic")).expect("it is UTF-8")
    }

    #[test]
    fn the_line_is_erased_and_a_quick_run_has_none() {
        let slow = written(Duration::ZERO, 2 * TICK);
        assert!(slow.contains("1 of 3 checked  top.md"), "{slow:?}");
        assert!(slow.starts_with(ERASE) && slow.ends_with(ERASE) && !slow.contains('\n'), "{slow:?}");
        assert_eq!(written(Duration::from_secs(60), Duration::ZERO), "");
    }

    #[test]
    fn a_line_never_wraps_and_never_moves_the_cursor() {
        assert_eq!(fitted("3 of 8", 80), "3 of 8");
        assert_eq!(fitted("3 of 8", 4), "3 o");
        assert_eq!(fitted("3 of 8", 0), "");
        assert_eq!(fitted("力学.md", 7), "力学.m");
        assert_eq!(fitted("a\u{1b}[2J\nb", 80), "a?[2J?b");
    }
}
