//! `onshell watch`: a save is answered at once, and the pages are for this computer only.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use crate::support::Desk;

/// A program that is ended with its test.
struct Watch {
    child: Child,
    lines: Receiver<String>,
}

impl Watch {
    fn start(desk: &Desk, arguments: &[&str]) -> Watch {
        let mut command = Command::new(env!("CARGO_BIN_EXE_onshell"));
        command.arg("watch").args(arguments).current_dir(desk.path("")).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut child = command.spawn().expect("the program starts");
        let out = child.stdout.take().expect("the output is there");
        let (send, lines) = channel();
        std::thread::spawn(move || {
            for line in BufReader::new(out).lines().map_while(Result::ok) {
                if send.send(line).is_err() {
                    break;
                }
            }
        });
        Watch { child, lines }
    }

    /// The next line with these words.
    fn line_with(&self, words: &str) -> String {
        let end = Instant::now() + Duration::from_secs(60);
        loop {
            let left = end.saturating_duration_since(Instant::now());
            let line = self.lines.recv_timeout(left).unwrap_or_else(|_| panic!("no line with {words}"));
            if line.contains(words) {
                return line;
            }
        }
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The answer to a request, as a whole.
fn asked(port: u16, path: &str, host: &str) -> String {
    let mut stream = TcpStream::connect(("127.0.0.1", port)).expect("the server is there");
    write!(stream, "GET {path} HTTP/1.1\r\nHost: {host}\r\n\r\n").expect("the request can be written");
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("the answer can be read");
    answer
}

#[test]
fn a_save_is_answered_and_the_page_changes() {
    let desk = Desk::new("watch");
    desk.write("notes.md", "$$ (a+b)^2 = a^2 + 2ab + b^2 $$\n");
    let watch = Watch::start(&desk, &["notes.md", "--serve", "--port", "0"]);
    let address = watch.line_with("http://127.0.0.1:");
    let port: u16 =
        address.trim_end_matches('/').rsplit(':').next().and_then(|port| port.parse().ok()).expect("a port");
    watch.line_with("1 follows");
    let own = format!("127.0.0.1:{port}");
    let before = asked(port, "/notes.html", &own);
    assert!(before.starts_with("HTTP/1.1 200") && before.contains("<math") && !before.contains("✗"), "{before}");
    let version = asked(port, "/version?0", &own);
    assert!(version.ends_with("\r\n1"), "{version}");
    desk.write("notes.md", "$$ (a+b)^2 = a^2 + b^2 $$\n");
    watch.line_with("1 refuted");
    assert!(asked(port, "/version?1", &own).ends_with("\r\n2"));
    assert!(asked(port, "/notes.html", &own).contains("class=\"correction\""));
    assert!(asked(port, "/style.css", &own).contains("text/css"));
    // Nothing but the pages, and nobody but this computer.
    assert!(asked(port, "/../notes.md", &own).starts_with("HTTP/1.1 404"));
    assert!(asked(port, "/notes.html", "evil.example").starts_with("HTTP/1.1 403"));
}

#[test]
fn what_cannot_be_watched_is_an_error() {
    let desk = Desk::new("watch-nothing");
    let run = desk.onshell(&["watch", "absent.md"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("absent.md"), "{}", run.err);
}
