//! The pages in a browser: each kind of page at 360 and 1280 pixels, light and dark, has no script error, does not
//! overflow, typesets every equation as MathML, has labels where they are needed, and text that contrasts with what is
//! behind it. Each kind is also given to axe, a checker of accessibility that others keep.
//!
//! The browser is Chromium without a window. A small script, which is put beside copies of the pages, looks at a page in a
//! frame of the wanted width and writes what it finds into the document, which Chromium prints. Where there is no
//! Chromium, or no axe, the tests that need it are skipped, and counted as such.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use libtest_mimic::{Arguments, Failed, Trial};

/// Looks at the page in a frame and returns what is wrong with it, as a list of texts.
const PROBE: &str = include_str!("browser/probe.js");

/// How to get the browser.
const NO_BROWSER: &str = "no chromium: `apt-get install chromium` gets it, or name it in CHROMIUM";

/// How to get the checker of accessibility.
const NO_AXE: &str = "no axe: `npm install --prefix target/tools axe-core` gets it, or name its axe.min.js in AXE";

/// Makes the pages of one kind in a folder, and returns the folder of the pages.
type Make = fn(&Path) -> PathBuf;

/// What a test looks at in the browser.
type Look = Box<dyn Fn(&Browser) -> Result<(), String> + Send>;

/// The kinds of pages.
const KINDS: [(&str, Make); 7] = [
    ("pages_of_a_report", pages_of_a_report),
    ("page_with_mistakes", page_with_mistakes),
    ("pages_of_a_lagrangian_in_notes", pages_of_a_lagrangian_in_notes),
    ("page_of_a_tex_document", page_of_a_tex_document),
    ("page_of_a_derivation", page_of_a_derivation),
    ("single_page", single_page),
    ("pages_of_a_class", pages_of_a_class),
];

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let (browser, axe) = (browser(), axe());
    [(NO_BROWSER, &browser), (NO_AXE, &axe)].iter().filter(|(_, tool)| tool.is_none()).for_each(|(advice, _)| {
        eprintln!("{advice}");
    });
    let mut trials = Vec::new();
    let mut add = |name: &str, needs_axe: bool, test: Look| {
        let axe = axe.clone().filter(|_| needs_axe);
        let is_skipped = browser.is_none() || (needs_axe && axe.is_none());
        let browser = browser.clone();
        let trial = Trial::test(name, move || {
            let path = browser.ok_or_else(|| Failed::from(NO_BROWSER))?;
            if needs_axe && axe.is_none() {
                return Err(Failed::from(NO_AXE));
            }
            test(&Browser { path, axe }).map_err(Failed::from)
        });
        trials.push(trial.with_ignored_flag(is_skipped));
    };
    for (name, make) in KINDS {
        add(name, false, Box::new(move |browser| browser.expect_none(&make(&desk(name)))));
        let name = format!("{name}_by_axe");
        add(&name.clone(), true, Box::new(move |browser| browser.expect_none(&make(&desk(&name)))));
    }
    add("what_is_wrong_is_found", false, Box::new(|browser| what_is_wrong_is_found(browser, &WRONG)));
    add("what_is_wrong_is_found_by_axe", true, Box::new(|browser| what_is_wrong_is_found(browser, &WRONG_FOR_AXE)));
    libtest_mimic::run(&arguments, trials).exit_code()
}

/// The script of axe, if it is there.
fn axe() -> Option<PathBuf> {
    let named = std::env::var_os("AXE").map(PathBuf::from);
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().map(|target| target.join("tools"));
    let folders = [target, Some("/usr/lib".into()), Some("/usr/local/lib".into()), Some("/usr/share".into())];
    let found = folders.into_iter().flatten().map(|folder| folder.join("node_modules/axe-core/axe.min.js"));
    named.into_iter().chain(found).find(|path| path.is_file())
}

/// The program, if there is one.
fn browser() -> Option<PathBuf> {
    let named = std::env::var_os("CHROMIUM").map(PathBuf::from);
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folders: Vec<PathBuf> = std::env::split_paths(&path).collect();
    let names = ["chromium", "chromium-browser", "google-chrome"];
    let found = names.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    named.into_iter().chain(found).find(|path| path.is_file())
}

/// Chromium.
struct Browser {
    path: PathBuf,
    /// The script of axe, if it is to look at the pages too.
    axe: Option<PathBuf>,
}

impl Browser {
    /// What is wrong with the pages of a folder, at both widths, light and dark.
    fn faults(&self, folder: &Path) -> Result<Vec<String>, String> {
        let failed = |error: std::io::Error| error.to_string();
        let mut pages: Vec<PathBuf> =
            std::fs::read_dir(folder).map_err(failed)?.filter_map(|entry| Some(entry.ok()?.path())).collect();
        pages.retain(|path| path.extension().is_some_and(|ending| ending == "html"));
        pages.sort();
        let style = std::fs::read_to_string(folder.join("style.css")).unwrap_or_default();
        let axe = self.axe.iter().map(|path| format!("<script src=\"file://{}\"></script>", path.display()));
        let axe: String = axe.collect();
        let mut frames = String::new();
        for page in &pages {
            let text = std::fs::read_to_string(page).map_err(failed)?;
            let text = text.replace("<link rel=\"stylesheet\" href=\"style.css\">", &format!("<style>{style}</style>"));
            let text = text.replace("</body>", &format!("{axe}</body>"));
            let name = page.file_name().unwrap_or_default().to_string_lossy();
            for dark in [false, true] {
                // What the style says for dark screens is said for this page, or for none.
                let to = if dark { "@media all" } else { "@media not all" };
                let text = text.replace("@media (prefers-color-scheme: dark)", to);
                let text = text.replace('&', "&amp;").replace('"', "&quot;");
                for width in [360, 1280] {
                    let title = format!("{name}, {width} pixels, {}", if dark { "dark" } else { "light" });
                    frames.push_str(&format!(
                        "<iframe title=\"{title}\" width={width} height=800 style=\"border:0\" srcdoc=\"{text}\"></iframe>\n"
                    ));
                }
            }
        }
        let probe = folder.join("probe.htm");
        let html = format!("<!DOCTYPE html><meta charset=utf-8><pre id=found></pre>{frames}<script>{PROBE}</script>");
        std::fs::write(&probe, html).map_err(failed)?;
        let profile = folder.join("profile");
        let arguments = [
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-quic",
            "--no-first-run",
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-sync",
            "--virtual-time-budget=20000",
            "--timeout=120000",
            "--dump-dom",
        ];
        let run = Command::new(&self.path)
            .args(arguments)
            .arg(format!("--user-data-dir={}", profile.display()))
            .arg(format!("file://{}", probe.display()))
            .output()
            .map_err(failed)?;
        let dom = String::from_utf8_lossy(&run.stdout).into_owned();
        let found = dom.split_once("<pre id=\"found\">").and_then(|(_, rest)| rest.split_once("</pre>"));
        let found =
            found.map(|(found, _)| found).filter(|found| found.contains(&format!("{} frames", 4 * pages.len())));
        let found =
            found.ok_or_else(|| format!("the page was not looked at: {}", String::from_utf8_lossy(&run.stderr)))?;
        Ok(found.lines().skip(1).map(str::to_owned).collect())
    }

    /// That nothing is wrong with the pages.
    fn expect_none(&self, folder: &Path) -> Result<(), String> {
        let faults = self.faults(folder)?;
        if faults.is_empty() { Ok(()) } else { Err(faults.join("\n")) }
    }
}

/// An empty folder.
fn desk(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("browser").join(name);
    if folder.exists() {
        std::fs::remove_dir_all(&folder).expect("the folder can be emptied");
    }
    std::fs::create_dir_all(&folder).expect("the folder can be made");
    folder
}

fn onshell(folder: &Path, arguments: &[&str]) {
    let run = Command::new(env!("CARGO_BIN_EXE_onshell")).args(arguments).current_dir(folder).output();
    let run = run.expect("the program runs");
    assert!(run.status.code().is_some_and(|code| code <= 2), "{}", String::from_utf8_lossy(&run.stderr));
}

fn derivations() -> String {
    format!("{}/derivations", env!("CARGO_MANIFEST_DIR"))
}

fn pages_of_a_report(folder: &Path) -> PathBuf {
    onshell(folder, &["report", &derivations(), "--out", "pages"]);
    folder.join("pages")
}

fn page_with_mistakes(folder: &Path) -> PathBuf {
    let long = "a + b + c + d + e_1 + f + g + h + k + l + m + n + o + p".repeat(3);
    let notes = format!(
        "# A title\n\n$$ (a+b)^2 = a^2 + b^2 $$\n\nWith ${long}$ in a line, and\n\n$$ {long} = 1 $$\n\n\
         | | a |\n|---|---|\n| b | $x$ |\n\n$$ \\frac{{a^2-b^2}}{{a-b}} = a - b $$\n\n$$ \\foo{{ $$\n"
    );
    std::fs::write(folder.join("notes.md"), notes).expect("the notes can be written");
    onshell(folder, &["report", "notes.md", "--out", "pages"]);
    folder.join("pages")
}

/// With pictures, derived terms beside printed ones, and the curves of a wrong equation.
fn pages_of_a_lagrangian_in_notes(folder: &Path) -> PathBuf {
    let notes = "# A bead\n\nThe Lagrangian is\n\n$$ L = \\frac12 m R^2 (\\dot\\theta^2 + \\Omega^2 \\sin^2\\theta) + m g R \\cos\\theta $$\n\n\
                 $$ m R^2 \\ddot\\theta = m R^2 \\Omega^2 \\sin\\theta\\cos\\theta + m g R \\sin\\theta $$\n";
    std::fs::write(folder.join("bead.md"), notes).expect("the notes can be written");
    onshell(folder, &["report", "bead.md", "--out", "pages"]);
    folder.join("pages")
}

fn page_of_a_tex_document(folder: &Path) -> PathBuf {
    let notes = "\\documentclass{article}\n\\begin{document}\n\\section{Squares}\nIt is \\emph{known} that\n\\begin{itemize}\n\\item $a > 0$\n\
                 \\end{itemize}\n\\[ (a+b)^2 = a^2 + b^2 \\]\n\\end{document}\n";
    std::fs::write(folder.join("notes.tex"), notes).expect("the notes can be written");
    onshell(folder, &["report", "notes.tex", "--out", "pages"]);
    folder.join("pages")
}

fn page_of_a_derivation(folder: &Path) -> PathBuf {
    let run =
        Command::new(env!("CARGO_BIN_EXE_onshell")).args(["derive", "kepler", "--steps", "--format", "html"]).output();
    std::fs::create_dir_all(folder.join("pages")).expect("the folder can be made");
    std::fs::write(folder.join("pages/kepler.html"), run.expect("the program runs").stdout)
        .expect("the page can be written");
    folder.join("pages")
}

fn single_page(folder: &Path) -> PathBuf {
    onshell(folder, &["report", &format!("{}/06-spinning-top.json", derivations()), "--out", "pages", "--single"]);
    folder.join("pages")
}

fn pages_of_a_class(folder: &Path) -> PathBuf {
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).expect("the file can be written");
    write(
        "fall.md",
        "$$ v = v_0 - g t $$\n\n$$ t_1 = \\frac{v_0}{g} $$\n\n$$ H = v_0 t_1 - \\frac12 g t_1^2 = \\frac{v_0^2}{2g} \\tag{1} $$\n",
    );
    write("fall.json", "{ \"notes\": \"fall.md\", \"constants\": { \"v_0, g\": \"> 0\" } }");
    std::fs::create_dir_all(folder.join("class")).expect("the folder can be made");
    write("class/anna.md", "$$ t_1 = \\frac{v_0}{g} $$\n\n$$ H = \\frac{v_0^2}{2g} $$\n");
    write(
        "class/ben.md",
        "$$ t_1 = \\frac{v_0}{2g} $$\n\n$$ H = v_0 t_1 - \\frac12 g t_1^2 = \\frac{3 v_0^2}{8 g} $$\n",
    );
    onshell(folder, &["mark", "class", "--claims", "fall.json", "--hints", "3", "--out", "pages"]);
    folder.join("pages")
}

/// What the script finds in a page that was made wrong on purpose.
const WRONG: [&str; 7] = ["overflows", "contrast", "no MathML", "no name", "no title", "no language", "script error"];

/// The rules of axe that such a page breaks.
const WRONG_FOR_AXE: [&str; 5] = ["color-contrast", "link-name", "document-title", "html-has-lang", "image-alt"];

fn what_is_wrong_is_found(browser: &Browser, expected: &[&str]) -> Result<(), String> {
    let folder = desk(&format!("wrong_{}", browser.axe.is_some()));
    let page = "<!DOCTYPE html><html><head><title></title></head><body><main>\
                <div style='width:2000px'>wide</div><p style='color:#aaa;background:#fff'>pale</p><a href='#x'></a>\
                <img src='data:,'><section class='equation'><div>a = b</div></section><div tabindex=0>no label</div>\
                <script>nothing()</script></main></body></html>";
    std::fs::write(folder.join("wrong.html"), page).expect("the page can be written");
    let faults = browser.faults(&folder)?.join("\n");
    match expected.iter().find(|words| !faults.contains(*words)) {
        Some(words) => Err(format!("“{words}” is not found in {faults}")),
        None => Ok(()),
    }
}
