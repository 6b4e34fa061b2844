//! The line counts in TRUST.md are those of the files.
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Lines that are neither blank nor comment. Test modules count; the trusted files have none.
fn code_lines(text: &str) -> usize {
    text.lines().map(str::trim).filter(|l| !l.is_empty() && !l.starts_with("//")).count()
}

fn count(folder: &Path, counts: &mut BTreeMap<String, usize>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            count(&path, counts);
        } else if path.extension().is_some_and(|e| e == "rs") {
            let lines = code_lines(&fs::read_to_string(&path).unwrap());
            counts.insert(path.to_str().unwrap().to_owned(), lines);
        }
    }
}

#[test]
fn the_line_counts_in_trust_md_are_true() {
    let mut counts = BTreeMap::new();
    for folder in ["spec/src", "proofs/checker/src"] {
        count(Path::new(folder), &mut counts);
    }
    let total = |folder: &str| -> usize {
        counts.iter().filter(|(f, _)| f.starts_with(folder)).map(|(_, n)| n).sum()
    };
    let mut expected = vec![format!("| `spec/src/` (whole) | {} |", total("spec/src"))];
    for (file, lines) in counts.iter().filter(|(f, _)| f.starts_with("proofs/checker/src")) {
        expected.push(format!("| `{file}` | {lines} |"));
    }
    expected.push(format!("| `proofs/checker/src/` (whole) | {} |", total("proofs/checker/src")));
    let trust = fs::read_to_string("TRUST.md").unwrap();
    let counted = |l: &&str| l.starts_with("| `") && l.contains("/src/");
    if std::env::var_os("CORDON_BLESS").is_some() {
        let before = trust.lines().take_while(|l| !counted(l));
        let after = trust.lines().skip_while(|l| !counted(l)).skip_while(counted);
        let lines: Vec<&str> =
            before.chain(expected.iter().map(String::as_str)).chain(after).collect();
        fs::write("TRUST.md", lines.join("\n") + "\n").unwrap();
        return;
    }
    let found: Vec<&str> = trust.lines().filter(counted).collect();
    assert!(found == expected, "TRUST.md should have\n{}", expected.join("\n"));
}

#[test]
fn code_lines_are_counted_as_said() {
    assert_eq!(code_lines("//! a\n\nfn f() {\n    // b\n    g(); // c\n}\n"), 3);
}

/// The sources whose mutants were judged are those of today: else they are to be judged again.
#[test]
fn the_judged_sources_are_the_present_ones() {
    let files = "cat proofs/checker/src/*.rs proofs/checker/src/*/*.rs | sha256sum";
    let trust = fs::read_to_string("TRUST.md").unwrap();
    let (said, _) = trust.split_once("... (`cat proofs").expect("a hash and its command");
    assert!(trust.contains(files), "{files}");
    let said = said.rsplit(' ').next().unwrap();
    let out = std::process::Command::new("sh").args(["-c", files]).env("LC_ALL", "C").output();
    let found = String::from_utf8(out.unwrap().stdout).unwrap();
    assert!(said.len() == 16 && found.starts_with(said), "TRUST.md: {said}; now {found}");
}
