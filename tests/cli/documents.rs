//! What the documents promise is so: every `console` block of README.md is run and compared
//! byte for byte, every path that README.md and TRUST.md link to exists.
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

#[test]
fn the_readmes_sessions_are_what_the_program_prints() {
    let readme = std::fs::read_to_string("README.md").unwrap();
    let sessions = console_blocks(&readme);
    assert!(sessions.len() >= 2, "{} sessions", sessions.len());
    assert!(sessions.iter().any(|s| s.0 == "cargo run --release -- trace scenarios/paper.toml"));
    for (command, expected) in &sessions {
        let out = crate::common::cordon().args(arguments(command)).output().unwrap();
        let found = String::from_utf8(out.stdout).unwrap();
        assert!(
            agrees(expected, &found),
            "{command} prints\n{found}\n{}\nwhere README.md has\n{expected}",
            String::from_utf8_lossy(&out.stderr)
        );
    }
}

#[test]
fn the_comparison_of_sessions_can_fail() {
    let sessions = console_blocks("x\n```console\n$ cordon a\nb\n$ cordon c\nd\n...\n```\ny\n");
    assert_eq!(sessions.len(), 2);
    assert_eq!(sessions[0], ("cordon a".to_owned(), "b\n".to_owned()));
    assert!(agrees(&sessions[0].1, "b\n") && !agrees(&sessions[0].1, "b\nc\n"));
    assert!(agrees(&sessions[1].1, "d\ne\n") && !agrees(&sessions[1].1, "e\n"));
}

#[test]
fn linked_files_exist() {
    let mut links = 0;
    for document in ["README.md", "TRUST.md", "CONTRIBUTING.md"] {
        let text = std::fs::read_to_string(document).unwrap();
        for target in text.split("](").skip(1).filter_map(|t| t.split(')').next()) {
            let path = target.split('#').next().unwrap_or_default();
            if path.is_empty() || path.contains("://") {
                continue;
            }
            assert!(Path::new(path).exists(), "{document} links to `{path}`");
            links += 1;
        }
    }
    assert!(links >= 5, "{links} links");
}
