//! The pages of `onshell watch --serve`: a server for this computer alone.
//!
//! It answers on 127.0.0.1 only, to requests that name this address, and reads nothing but its own pages. A page gets a
//! few lines of script, which ask for its version, wait, and put the new text in the place of the old one; open evidence
//! and the place on the page stay.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use crate::error::reason;
use crate::page::Page;
use crate::{Error, Result};

/// A server that runs until the program ends.
pub(super) struct Server {
    /// The port.
    pub port: u16,
    shown: Arc<Mutex<Shown>>,
}

/// The pages, and how often they have changed.
#[derive(Default)]
struct Shown {
    version: u64,
    pages: Vec<Page>,
}

/// The longest time that a question for a newer version waits.
const WAIT: Duration = Duration::from_secs(20);
/// The longest request that is read, in bytes.
const LONGEST: u64 = 8192;

const SCRIPT: &str = r#"<script>
(async () => {
  for (let version = "VERSION"; ;) {
    try {
      const now = await (await fetch("/version?" + version)).text();
      if (now === version) continue;
      const page = new DOMParser().parseFromString(await (await fetch(location.pathname)).text(), "text/html");
      const keys = (root) => {
        const seen = {};
        return [...root.querySelectorAll("main details")].map((d) => {
          const id = (d.closest("[id]") || {}).id;
          seen[id] = (seen[id] || 0) + 1;
          return [d, id + " " + seen[id]];
        });
      };
      const open = new Set(keys(document).filter(([d]) => d.open).map(([, key]) => key));
      keys(page).forEach(([d, key]) => { if (open.has(key)) d.open = true; });
      const reached = "main a, main summary, main [tabindex]";
      const focus = [...document.querySelectorAll(reached)].indexOf(document.activeElement);
      const seen = [...document.querySelectorAll("main section[id], main h2[id]")].find((e) => e.getBoundingClientRect().bottom > 0);
      const [id, top] = seen ? [seen.id, seen.getBoundingClientRect().top] : ["", 0];
      document.querySelector("main").innerHTML = page.querySelector("main").innerHTML;
      const again = document.getElementById(id);
      if (again && scrollY > 0) scrollBy(0, again.getBoundingClientRect().top - top);
      if (focus >= 0) { const e = document.querySelectorAll(reached)[focus]; if (e) e.focus({ preventScroll: true }); }
      version = now;
    } catch { await new Promise((done) => setTimeout(done, 1000)); }
  }
})();
</script>"#;

impl Server {
    /// Starts the server.
    ///
    /// # Errors
    /// When the port cannot be used.
    pub fn start(port: u16) -> Result<Server> {
        let failed = |error: std::io::Error| {
            Error::new(format!("cannot use port {port}: {}", reason(&error))).help("name another one: --port 8322")
        };
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(failed)?;
        let port = listener.local_addr().map_err(failed)?.port();
        let shown = Arc::new(Mutex::new(Shown::default()));
        let pages = shown.clone();
        std::thread::spawn(move || {
            for stream in listener.incoming().flatten() {
                let pages = pages.clone();
                // A reader that leaves early loses its answer only.
                std::thread::spawn(move || drop(answer(stream, port, &pages)));
            }
        });
        Ok(Server { port, shown })
    }

    /// Shows these pages from now on.
    pub fn show(&self, pages: Vec<Page>) {
        let mut shown = self.shown.lock().unwrap_or_else(PoisonError::into_inner);
        *shown = Shown { version: shown.version + 1, pages };
    }
}

fn answer(mut stream: TcpStream, port: u16, pages: &Mutex<Shown>) -> std::io::Result<()> {
    stream.set_read_timeout(Some(Duration::from_secs(5)))?;
    let mut lines = BufReader::new(stream.try_clone()?.take(LONGEST)).lines();
    let request = lines.next().transpose()?.unwrap_or_default();
    let mut host = String::new();
    for line in lines {
        let line = line?;
        if let Some((_, value)) = line.split_once(':').filter(|(name, _)| name.eq_ignore_ascii_case("host")) {
            value.trim().clone_into(&mut host);
        }
        if line.is_empty() {
            break;
        }
    }
    let path = request.strip_prefix("GET ").and_then(|rest| rest.split(' ').next()).unwrap_or_default();
    // A page from elsewhere that made a name lead to this computer may not read the notes.
    let is_own = [format!("127.0.0.1:{port}"), format!("localhost:{port}")].contains(&host);
    let (status, kind, text) = match path.strip_prefix("/version?") {
        _ if !is_own => ("403 Forbidden", "text/plain", "this address is for this computer only".to_owned()),
        Some(known) => ("200 OK", "text/plain", newer(known, pages)),
        None => page(path, pages),
    };
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}; charset=utf-8\r\nContent-Length: {}\r\nCache-Control: no-store\r\n\
         X-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n{text}",
        text.len()
    )?;
    stream.flush()
}

/// The version of the pages, once it is another one than the one that is known, or after some time.
fn newer(known: &str, pages: &Mutex<Shown>) -> String {
    let start = Instant::now();
    loop {
        let version = pages.lock().unwrap_or_else(PoisonError::into_inner).version.to_string();
        if version != known || start.elapsed() > WAIT {
            return version;
        }
        std::thread::sleep(Duration::from_millis(20));
    }
}

fn page(path: &str, pages: &Mutex<Shown>) -> (&'static str, &'static str, String) {
    let shown = pages.lock().unwrap_or_else(PoisonError::into_inner);
    let name = if path == "/" { "index.html" } else { path.trim_start_matches('/') };
    let name = name.split('?').next().unwrap_or_default();
    match shown.pages.iter().find(|page| page.name == name) {
        Some(page) if name.ends_with(".css") => ("200 OK", "text/css", page.text.clone()),
        Some(page) => {
            let script = SCRIPT.replace("VERSION", &shown.version.to_string());
            ("200 OK", "text/html", page.text.replace("</body>", &format!("{script}</body>")))
        }
        None => ("404 Not Found", "text/plain", "there is no such page".to_owned()),
    }
}
