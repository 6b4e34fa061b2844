//! What the documents promise is so: every `console` block of README.md and of the guide is run
//! and compared byte for byte, every path that a document links to exists. `CORDON_BLESS=1` writes
//! into the documents what the program prints now: read the difference before committing it.
use std::path::Path;

/// The `console` blocks of a Markdown text, each a list of (command, expected output).
fn console_blocks(text: &str) -> Vec<(String, String)> {
    let mut sessions: Vec<(String, String)> = Vec::new();
    let mut inside = false;
    for line in text.lines() {
        match (inside, line) {
            (false, "```console") => inside = true,
            (true, "```") => inside = false,
            (true, line) => match line.strip_prefix("$ ") {
                Some(command) => sessions.push((command.to_owned(), String::new())),
                None => {
                    let (_, output) = sessions.last_mut().expect("output before a command");
                    output.push_str(line);
                    output.push('\n');
                }
            },
            (false, _) => {}
        }
    }
    sessions
}

/// The arguments of a line like `cordon trace x.toml` or `cargo run --release -- trace x.toml`.
fn arguments(command: &str) -> Vec<String> {
    let rest = command
        .strip_prefix("cargo run --release -- ")
        .or_else(|| command.strip_prefix("cordon "))
        .unwrap_or_else(|| panic!("`{command}` runs something else"));
    rest.split_whitespace().map(|word| word.trim_matches('"').to_owned()).collect()
}

/// A last line `...` stands for more output.
fn agrees(expected: &str, found: &str) -> bool {
    match expected.strip_suffix("...\n") {
        Some(beginning) => found.starts_with(beginning),
        None => expected == found,
    }
}

/// What a session in a document should say: as much as it has, or all.
fn blessed(expected: &str, found: &str) -> String {
    match expected.strip_suffix("...\n") {
        Some(beginning) => {
            let lines = found.lines().take(beginning.lines().count());
            lines.map(|l| format!("{l}\n")).collect::<String>() + "...\n"
        }
        None => found.to_owned(),
    }
}

/// Runs the sessions of a document; with `CORDON_BLESS` writes into it what they print.
fn check_sessions(document: &str) -> usize {
    let text = std::fs::read_to_string(document).unwrap();
    let bless = std::env::var_os("CORDON_BLESS").is_some();
    let mut written = text.clone();
    let sessions = console_blocks(&text);
    for (command, expected) in &sessions {
        let out = crate::common::cordon().args(arguments(command)).output().unwrap();
        let found = String::from_utf8(out.stdout).unwrap();
        if bless {
            let (old, new) = (
                format!("$ {command}\n{expected}"),
                format!("$ {command}\n{}", blessed(expected, &found)),
            );
            written = written.replacen(&old, &new, 1);
            continue;
        }
        assert!(
            agrees(expected, &found),
            "{command} prints\n{found}\n{}\nwhere {document} has\n{expected}",
            String::from_utf8_lossy(&out.stderr)
        );
        assert!(!found.is_empty() || !out.stderr.is_empty(), "{command} says nothing");
    }
    if bless && written != text {
        std::fs::write(document, written).unwrap();
    }
    sessions.len()
}

#[test]
fn the_readmes_sessions_are_what_the_program_prints() {
    let readme = std::fs::read_to_string("README.md").unwrap();
    let first = "cargo run --release -- trace scenarios/paper.toml";
    assert!(console_blocks(&readme).iter().any(|s| s.0 == first));
    assert!(check_sessions("README.md") >= 2);
}

/// The chapters of the guide, in order.
fn chapters() -> Vec<String> {
    let summary = std::fs::read_to_string("docs/src/SUMMARY.md").unwrap();
    let names = summary.split("](").skip(1).filter_map(|t| t.split(')').next());
    names.map(|name| format!("docs/src/{name}")).collect()
}

#[test]
fn the_guides_sessions_are_what_the_program_prints() {
    // What an earlier version has left is another sweep.
    let _ = std::fs::remove_dir_all("target/guide");
    let chapters = chapters();
    assert_eq!(chapters.len(), 10);
    let sessions: usize = chapters.iter().map(|c| check_sessions(c)).sum();
    assert!(sessions >= 20, "{sessions}");
    let picture = std::fs::read("target/guide/fig08.svg").unwrap();
    if std::env::var_os("CORDON_BLESS").is_some() {
        std::fs::create_dir_all("docs/src/pictures").unwrap();
        std::fs::write("docs/src/pictures/fig08.svg", &picture).unwrap();
    }
    assert!(picture == std::fs::read("docs/src/pictures/fig08.svg").unwrap(), "fig08.svg");
    // Every page is in the book.
    let pages = std::fs::read_dir("docs/src").unwrap().map(|e| e.unwrap().path());
    let pages = pages.filter(|p| p.extension().is_some_and(|e| e == "md")).count();
    assert_eq!(pages, chapters.len() + 1);
}

#[test]
fn the_comparison_of_sessions_can_fail() {
    let sessions = console_blocks("x\n```console\n$ cordon a\nb\n$ cordon c\nd\n...\n```\ny\n");
    assert_eq!(sessions.len(), 2);
    assert_eq!(sessions[0], ("cordon a".to_owned(), "b\n".to_owned()));
    assert!(agrees(&sessions[0].1, "b\n") && !agrees(&sessions[0].1, "b\nc\n"));
    assert!(agrees(&sessions[1].1, "d\ne\n") && !agrees(&sessions[1].1, "e\n"));
    assert_eq!(blessed("d\n...\n", "x\ny\n"), "x\n...\n");
    assert_eq!(blessed("d\n", "x\ny\n"), "x\ny\n");
}

#[test]
fn linked_files_exist() {
    let mut links = 0;
    let mut documents = chapters();
    documents.extend(
        ["README.md", "TRUST.md", "CONTRIBUTING.md", "docs/src/SUMMARY.md", "schemas/README.md"]
            .map(str::to_owned),
    );
    for document in &documents {
        let text = std::fs::read_to_string(document).unwrap();
        let folder = Path::new(document).parent().unwrap();
        for target in text.split("](").skip(1).filter_map(|t| t.split(')').next()) {
            let path = target.split('#').next().unwrap_or_default();
            if path.is_empty() || path.contains("://") {
                continue;
            }
            assert!(folder.join(path).exists(), "{document} links to `{path}`");
            // A book has nothing above itself.
            let leaves = document.starts_with("docs/") && path.starts_with("..");
            assert!(!leaves, "{document} links to `{path}`, which is not in the book");
            links += 1;
        }
    }
    assert!(links >= 5, "{links} links");
}
