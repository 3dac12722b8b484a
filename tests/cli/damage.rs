//! A misprint in a display that others stand on: it is named, what needs it is unreadable, and the rest is judged. The
//! claims file is to blame for its own mistakes alone.

use crate::support::{Desk, Run, outcome};

const NOTES: &str = r"
$$ p = m v \tag{1} $$
$$ p v = m v^2 \tag{2} $$
$$ m v + m v = 2 m v \tag{3} $$
The double of it is twice as much.
";

const CLAIMS: &str = r#"{
  "notes": "notes.md",
  "constants": { "m": "> 0" },
  "varies with time": { "v": "> 0" },
  "define": { "w": "3q", "q": "2p" },
  "equations": { "2": { "assume": "p > 1" } },
  "sentences": [{ "quote": "The double of it is twice as much.", "claim": "w = 6 m v" }]
}"#;

/// A frame lost its brace in what introduces p.
const DAMAGE: (&str, &str) = ("p = m v", "p = m \\frac{v}{1");

fn check(name: &str, claims: &str, notes: &str) -> Run {
    let desk = Desk::new(name);
    desk.write("claims.json", claims);
    desk.write("notes.md", notes);
    desk.onshell(&["check", "claims.json", "--format", "json"])
}

/// The verdicts on the equations, and then on the sentences, with what is said of each.
fn verdicts(run: &Run) -> Vec<(String, String)> {
    let document = &run.json()["documents"][0];
    let word = |item: &serde_json::Value, key: &str| item[key].as_str().unwrap_or_else(|| panic!("{item}")).to_owned();
    let all = ["equations", "sentences"].iter().flat_map(|key| document[key].as_array().cloned().unwrap_or_default());
    all.map(|item| (word(&item, "verdict"), word(&item, "message"))).collect()
}

fn words(found: &[(String, String)]) -> Vec<&str> {
    found.iter().map(|(verdict, _)| outcome(verdict)).collect()
}

#[test]
fn a_damaged_definition_is_named_and_the_rest_is_judged() {
    let sound = check("damage-none", CLAIMS, NOTES);
    assert_eq!((sound.code, words(&verdicts(&sound))), (0, vec!["definition", "verified", "verified", "verified"]));
    for (name, damage) in [("brace", DAMAGE.1), ("name", r"p = m u"), ("arrow", r"\vec p = m v")] {
        let run = check(&format!("damage-{name}"), CLAIMS, &NOTES.replace(DAMAGE.0, damage));
        assert_eq!((run.code, run.err.as_str()), (2, ""), "{name}: {}", run.out);
        let found = verdicts(&run);
        assert_eq!(words(&found), ["unreadable", "unreadable", "verified", "unreadable"], "{name}: {}", run.out);
        for (_, message) in [&found[1], &found[3]] {
            assert!(message.contains("its definition may be in (1), which cannot be read"), "{name}: {message}");
        }
        assert_eq!(run.json()["documents"][0]["equations"][0]["line"], 2, "{name}");
    }
}

#[test]
fn a_mistake_of_the_claims_file_is_no_damage() {
    for (name, from, to, word) in [
        ("condition", "p > 1", "k > 1", "k is not declared"),
        ("definition", "3q", "3k", "k is not declared"),
        ("claim", "w = 6", "k = 6", "k is not declared"),
    ] {
        let claims = CLAIMS.replace(from, to);
        for (state, notes) in [("sound", NOTES.to_owned()), ("damaged", NOTES.replace(DAMAGE.0, DAMAGE.1))] {
            let run = check(&format!("mistake-{name}-{state}"), &claims, &notes);
            assert_eq!(run.code, 2, "{name}: {}", run.out);
            assert!(
                run.err.contains(word) && run.err.contains("claims.json:"),
                "{name}, {state}: {}{}",
                run.err,
                run.out
            );
        }
    }
}

#[test]
fn what_needs_a_damaged_law_is_not_judged() {
    let claims = r#"{
      "notes": "notes.md",
      "constants": { "m": "> 0" },
      "varies with time": { "x, f": "any" },
      "laws": { "Newton's second law": "1" }
    }"#;
    let law = r"m \ddot x = f";
    let notes = format!(
        "$$ {law} \\tag{{1}} $$\n$$ m \\dot x \\ddot x = f \\dot x \\tag{{2}} $$\n$$ x + x = 2 x \\tag{{3}} $$\n"
    );
    let sound = check("damage-no-law", claims, &notes);
    assert_eq!((sound.code, words(&verdicts(&sound))), (0, vec!["law", "verified", "verified"]), "{}", sound.out);
    let run = check("damage-law", claims, &notes.replace(law, r"m \ddot{x = f"));
    let found = verdicts(&run);
    assert_eq!((run.code, words(&found)), (2, vec!["unreadable", "unreadable", "verified"]), "{}{}", run.err, run.out);
    assert!(found[1].1.contains("without Newton's second law: (1) cannot be read"), "{}", found[1].1);
}

/// What a display has among other things is not introduced there; so it is not to blame that it lacks something itself.
#[test]
fn displays_that_lack_the_same_names_do_not_blame_each_other() {
    let claims = r#"{ "notes": "notes.md", "constants": { "m": "> 0" }, "varies with time": { "v": "> 0" } }"#;
    let notes = |second: &str| format!("\n$$ p m = m a \\tag{{1}} $$\n$$ {second} \\tag{{2}} $$\n");
    let of = |name: &str, second: &str| -> Vec<String> {
        let run = check(name, claims, &notes(second));
        verdicts(&run).into_iter().map(|(_, message)| message).collect()
    };
    let found = of("circle", "m p v = m v + b a");
    assert!(found[0].contains("p is not declared; add \"p\": \"any\""), "{found:?}");
    assert!(found[1].contains("not declared; add "), "{found:?}");
    // The twin: a side of its own is what introduces a name, though another is lacking beside it.
    let found = of("side", "p = m v + b");
    assert!(found[0].contains("p is not declared; its definition may be in (2), which cannot be read"), "{found:?}");
}
