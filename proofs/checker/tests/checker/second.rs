//! The second checker, in another language and written from FORMAT.md alone, gives the same verdicts on every committed
//! certificate, every bad one, by the same rule, and mutants of the former.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use cordon_check::{Verdict, check};

/// How many files are compared.
const COMPARED: usize = 872;

fn files(folder: &Path) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> =
        fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.retain(|p| p.file_name().is_some_and(|n| n != "index.json"));
    files.sort();
    files
}

#[test]
fn both_checkers_agree() {
    let proofs = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mutants = Path::new(env!("CARGO_TARGET_TMPDIR")).join("second");
    // Mutants of certificates that are there no more would be compared too.
    let _ = fs::remove_dir_all(&mutants);
    fs::create_dir_all(&mutants).unwrap();
    for path in files(&proofs.join("certificates")) {
        let text = fs::read_to_string(&path).unwrap();
        let name = path.file_stem().unwrap().to_str().unwrap();
        let changes = [
            ("1", "2"),
            (">=", ">"),
            ("[k]", "[i]"),
            ("eps", "last"),
            (" + 1", " - 1"),
            ("k + 1", "k"),
            ("i - 1", "i"),
        ];
        for (n, (from, to)) in changes.into_iter().enumerate() {
            // The last occurrence: most of a certificate is its statement's and its proofs' beginning.
            if let Some(at) = text.rfind(from) {
                let mutant = format!("{}{to}{}", &text[..at], &text[at + from.len()..]);
                fs::write(mutants.join(format!("{name}.{n}.json")), mutant).unwrap();
            }
        }
    }
    let bad = proofs.join("must-not-prove");
    let all: Vec<PathBuf> = [&proofs.join("certificates"), &bad]
        .into_iter()
        .chain([&mutants])
        .flat_map(|f| files(f))
        .collect();
    let output = Command::new("python3")
        .arg(proofs.join("second-checker/check.py"))
        .args(&all)
        .output()
        .expect("python3 runs the second checker");
    let said = String::from_utf8(output.stdout).unwrap();
    assert_eq!(said.lines().count(), all.len(), "{}", String::from_utf8_lossy(&output.stderr));
    for (path, line) in all.iter().zip(said.lines()) {
        let verdict = match fs::read(path).map(String::from_utf8).unwrap() {
            Ok(text) => check(&text),
            Err(_) => Verdict::Unreadable { reason: "no UTF-8 text".into() },
        };
        let answer = line.strip_prefix(&format!("{}: ", path.display())).unwrap();
        let mut said = answer.split(": ");
        assert_eq!(said.next(), Some(verdict.label()), "{line}\n{verdict}");
        // Mutants may have several faults; the bad files have one.
        if let (Verdict::Invalid { rule, .. }, true) = (&verdict, path.starts_with(&bad)) {
            assert_eq!(said.next(), Some(*rule), "{line}\n{verdict}");
        }
    }
    assert_eq!(all.len(), COMPARED);
}

/// The worst verdict is the exit code, as of the first checker.
#[test]
fn the_second_checker_has_exit_codes() {
    let proofs = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let good = "certificates/7.2-sharp.json";
    let bad = "must-not-prove/positivity-sides-differ.json";
    let none = "must-not-prove/format-schema.json";
    let cases: [(&[&str], i32); 6] = [
        (&[good], 0),
        (&[good, none], 2),
        (&[none, bad, good], 4),
        (&[bad, "certificates/there-is-none.json"], 74),
        (&[], 2),
        (&["--help"], 2),
    ];
    for (files, code) in cases {
        let run = Command::new("python3")
            .arg("second-checker/check.py")
            .args(files)
            .current_dir(&proofs)
            .output()
            .unwrap();
        assert_eq!(run.status.code(), Some(code), "{files:?}");
        let said = String::from_utf8(run.stderr).unwrap();
        assert!(!said.contains("Traceback"), "{said}");
    }
}

/// With another protocol written into the second checker, the certificates that rest on what is
/// changed are proofs no more.
#[test]
fn a_wrong_protocol_breaks_the_certificates() {
    let proofs = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let source = fs::read_to_string(proofs.join("second-checker/check.py")).unwrap();
    let average = "average = \"eps*{} + (1 - 2*eps)*x(k,i) + eps*{}\"";
    let ends = "first, inner, last = \"min\", near, \"max\"";
    let wrong = [
        (
            "neighbour off by one",
            "near = average.format(\"x(k,i-1)\"",
            "near = average.format(\"x(k,i-2)\"",
        ),
        ("weight 1-eps", average, "average = \"eps*{} + (1 - eps)*x(k,i) + eps*{}\""),
        ("weight turned", average, "average = \"eps*{} + (1 - 2*eps)*x(k,i) - eps*{}\""),
        ("end drones moving", ends, "first, inner, last = \"min + eps\", near, \"max\""),
        ("last drone following", ends, "first, inner, last = \"min\", near, \"x(k,last-1)\""),
    ];
    let names = [
        "7.2-sharp",
        "7.3-sharp",
        "7.4i-sharp",
        "7.5i-sharp",
        "7.6ii-sharp",
        "7.7-sharp",
        "7.8-sharp",
        "7.8-beyond",
    ];
    let files: Vec<PathBuf> =
        names.iter().map(|n| proofs.join(format!("certificates/{n}.json"))).collect();
    let mut broken = 0;
    for (what, right, written) in wrong {
        let program = source.replacen(right, written, 1);
        assert_ne!(program, source, "{what}");
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("wrong.py");
        fs::write(&path, program).unwrap();
        let output = Command::new("python3").arg(&path).args(&files).output().unwrap();
        let said = String::from_utf8(output.stdout).unwrap();
        assert_eq!(said.matches(": invalid: positivity: ").count(), files.len(), "{what}: {said}");
        broken += files.len();
    }
    assert_eq!(broken, 40);
}
