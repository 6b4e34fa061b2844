//! Help, completions and the manual page.
use crate::common::run;

#[test]
fn every_command_has_an_example_and_completions_offer_numbers_and_files() {
    let commands = [
        "trace",
        "local",
        "swarm",
        "cosim",
        "figures",
        "replay",
        "fmu",
        "fmu export",
        "theorems",
        "errata",
        "sweep",
        "sweep merge",
        "sweep status",
        "refute",
        "prove",
        "check",
        "separation",
        "threshold",
        "settle",
        "export",
        "export smt2",
        "export pvs",
        "export into-cps",
        "export ssp",
        "completions",
    ];
    for command in commands {
        let args: Vec<&str> = command.split(' ').chain(["--help"]).collect();
        let (code, out, _) = run(&args);
        assert_eq!(code, 0, "{command}");
        let examples = out.split("Example").nth(1).unwrap_or_else(|| panic!("{command}: {out}"));
        assert!(examples.contains(&format!("cordon {command}")) || command == "export", "{out}");
    }
    // What has a limit says so, and is held to it.
    for (command, limit, beyond) in [
        ("trace", "10,000 decimal places", "trace scenarios/paper.toml --digits 10001"),
        ("trace", "10,000,000 rows", "trace scenarios/paper.toml --steps 10000001"),
        ("local", "100,000 ticks", "local scenarios/paper.toml --ticks 100001"),
        ("swarm", "100,000,000 drones", "swarm --drones 100000001"),
        ("swarm", "1,000,000,000,000 drone", "swarm --drones 1000 --steps 1000000001"),
        ("cosim", "67,108,864 positions", "cosim scenarios/paper.toml --duration 400000"),
        ("sweep", "3 to 64 drones", "sweep 7.2 --drones 65"),
        ("sweep", "100,000 steps", "sweep 7.2 --steps 100001"),
        ("sweep", "1,000,000 weights", "sweep 7.2 --max-denominator 2000"),
        ("sweep", "1,024 threads", "sweep 7.2 --threads 1025"),
        ("refute", "3 to 50 drones", "refute 7.2 --drones 51"),
        ("refute", "600 positions", "refute 7.2 --drones 50 --delay 12"),
        ("refute", "1,000 steps", "refute 7.2 --steps 1001"),
        ("refute", "denominators up to 100", "refute 7.2 --denominators 101"),
        ("prove", "one N up to 1,000,000", "prove 7.2 --drones 1000001"),
        ("threshold", "3 to 1,000 drones", "threshold --property bound --drones 1001"),
        ("threshold", "1,000 decimal", "threshold --property bound --drones 5 --digits 1001"),
        ("settle", "3 to 10,000 drones", "settle --drones 10001 --eps 1/4 --within 1"),
        ("export smt2", "3 to 9 drones", "export smt2 7.2 --drones 10"),
        ("export smt2", "8 steps", "export smt2 7.2 --drones 4 --negate --steps 9"),
    ] {
        let args: Vec<&str> = command.split(' ').chain(["--help"]).collect();
        let (_, help, _) = run(&args);
        let words = help.split_whitespace().collect::<Vec<_>>().join(" ");
        let limits = words.split("Limits: ").nth(1).unwrap_or_else(|| panic!("{command}"));
        assert!(limits.contains(limit), "{command}: {limits}");
        let (code, out, err) = run(&beyond.split(' ').collect::<Vec<_>>());
        assert_eq!((code, out.as_str()), (2, ""), "{beyond}: {err}");
    }
    // All there are, but those that moved and those about the program itself.
    let (_, help, _) = run(&["--help"]);
    let listed = help.split("Commands:").nth(1).unwrap().split("Options:").next().unwrap();
    let names = listed.lines().filter(|l| l.starts_with("  ") && !l.starts_with("   "));
    let names: Vec<_> = names.filter_map(|l| l.split_whitespace().next()).collect();
    for name in names {
        assert!(commands.contains(&name) || ["man", "help"].contains(&name), "{name}");
    }
    let (code, fish, _) = run(&["completions", "fish"]);
    assert_eq!(code, 0);
    assert!(fish.lines().any(|l| l.starts_with("7.4ii")), "numbers of theorems");
    let (_, zsh, _) = run(&["completions", "zsh"]);
    assert!(zsh.contains("_files"), "files where files are meant");
    assert!(zsh.contains("7.4ii"));
}

#[test]
fn completions_and_manual_are_printed() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let (code, out, _) = run(&["completions", shell]);
        assert!(code == 0 && out.contains("trace"), "{shell}");
    }
    let (code, out, _) = run(&["man"]);
    assert_eq!(code, 0);
    for command in ["trace", "local", "errata", "theorems"] {
        assert!(
            out.contains(&format!("cordon\\-{command}"))
                || out.contains(&format!("cordon-{command}"))
        );
    }
    assert!(out.contains("Exit codes"));
}

/// clap waives `requires` where the other flag conflicts with a third that is given, and says nothing of the
/// flag that is ignored: the program keeps a table of its own (`src/cli/edge.rs`).
#[test]
fn no_flag_leaves_what_it_needs_to_clap() {
    let mut folders = vec![std::path::PathBuf::from("src/cli")];
    let mut read = 0;
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                assert!(
                    !std::fs::read_to_string(&path).unwrap().contains("requires = "),
                    "{path:?}"
                );
                read += 1;
            }
        }
    }
    assert!(read >= 40, "{read} files");
}
