//! FMUs that do what the standard does not let them.

use std::fs;
use std::path::Path;

use super::{Bench, Description, MODES};

#[test]
fn a_plant_without_fault_is_called_in_the_order_of_the_standard() {
    let bench = Bench::new();
    for version in ["2.0", "3.0"] {
        for mode in MODES {
            let flown = bench.fly("NONE", version, mode);
            assert_eq!((flown.code, flown.err.as_str()), (0, ""), "{version} {mode:?}");
            assert!(flown.out.contains("plant2 is `plant.fmu`"), "{}", flown.out);
            assert_eq!(flown.rows[1][8], "20.0");
            assert!((flown.last() - 22.0).abs() < 1e-9);
            let calls = bench.trace();
            let (early, late) = (["parameter early"; 3], ["parameter late"; 3]);
            let mut expected = vec!["resources right"];
            if version == "2.0" {
                expected.push("set up");
            }
            expected.extend(early);
            expected.push("enter");
            expected.extend(late);
            expected.extend(["leave", "terminate", "free"]);
            let names: Vec<&str> = calls.iter().map(|c| c.rsplit_once(' ').unwrap().0).collect();
            assert_eq!(names, expected, "{version} {mode:?}");
            assert!(version == "3.0" || calls.contains(&"set up 2".to_owned()), "{calls:?}");
            bench.expect_no_leftovers();
        }
    }
}

#[test]
fn what_goes_wrong_in_an_fmu_is_an_error_of_its_unit_and_the_run_until_then_is_kept() {
    let bench = Bench::new();
    let died = |how: &str| format!("its process was killed by signal {how}");
    let cases: [(&str, &str, String); 9] = [
        ("ERROR", "2.0", "stepping: error: engine number 42 is cold, 2.5%".to_owned()),
        ("DISCARD", "2.0", "stepping: discarded, without a message".to_owned()),
        ("FATAL", "3.0", "stepping: fatal: out of fuel".to_owned()),
        ("FATAL", "2.0", "stepping: fatal: out of fuel".to_owned()),
        ("SEGFAULT", "2.0", died("11 (SIGSEGV)")),
        ("SEGFAULT", "3.0", died("11 (SIGSEGV)")),
        ("ABORT", "2.0", died("6 (SIGABRT)")),
        ("EXIT", "2.0", "it ended its process (exit code 0)".to_owned()),
        ("HANG", "2.0", "no answer within 1 s: its process was ended".to_owned()),
    ];
    for (fault, version, part) in &cases {
        let flags: &[&str] = if *fault == "HANG" { &["--step-limit", "1"] } else { &[] };
        let flown = bench.fly(fault, version, flags);
        assert_eq!(flown.code, 2, "{fault}: {}", flown.err);
        assert!(flown.err.contains("error: unit `plant2`: `"), "{fault}: {}", flown.err);
        assert!(
            flown.err.contains(&format!("step 19, from 0.95 s: {part}")),
            "{fault}: {}",
            flown.err
        );
        // A head line and the grid points 0 to 19.
        assert_eq!(flown.rows.len(), 21, "{fault}");
        assert!(flown.out.contains("the run broke off: unit `plant2`"), "{fault}: {}", flown.out);
        let companion = fs::read_to_string(bench.path("run.csv.json")).unwrap();
        assert!(companion.contains("\"broken_off\": \"unit `plant2`"), "{companion}");
        bench.expect_no_leftovers();
    }
    // What is no crash is the same error without a process in between.
    for (fault, version, part) in &cases[..4] {
        let flown = bench.fly(fault, version, &["--in-process"]);
        assert_eq!(flown.code, 2);
        assert!(flown.err.contains(part), "{fault}: {}", flown.err);
        bench.expect_no_leftovers();
    }
}

#[test]
fn loggers_may_say_anything_at_any_time() {
    let bench = Bench::new();
    for version in ["2.0", "3.0"] {
        for mode in MODES {
            let cases = [
                ("NULL_CATEGORY", "no category"),
                ("NULL_MESSAGE", "a message without text"),
                ("PENDING", "still at it"),
                ("WARNING", "stepping: warning: low battery"),
                ("SPAM", "and 99992 more messages"),
                ("LATE_LOG", ""),
            ];
            for (fault, part) in cases {
                let flown = bench.fly(fault, version, mode);
                assert_eq!(flown.code, 0, "{fault} {version} {mode:?}: {}", flown.err);
                assert!(flown.err.contains(part), "{fault} {version} {mode:?}: {}", flown.err);
                assert!((flown.last() - 22.0).abs() < 1e-9, "it flies on");
            }
        }
    }
}

#[test]
fn an_fmu_that_makes_no_instance_or_lacks_functions_is_named() {
    let bench = Bench::new();
    for mode in MODES {
        let flown = bench.fly("NO_INSTANCE", "2.0", mode);
        assert_eq!((flown.code, flown.out.as_str()), (2, ""));
        let part = "plant.fmu`: making an instance: it made none: no licence for `t`";
        assert!(flown.err.contains(part), "{}", flown.err);
        let library = bench.library("NONE", "2.0", &["-DINCOMPLETE"]);
        bench.fmu("plant.fmu", &Description::of("2.0"), &library);
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), mode);
        assert_eq!(flown.code, 2);
        let part = "the binary has no function `fmi2ExitInitializationMode`";
        assert!(flown.err.contains(part), "{}", flown.err);
        bench.fmu("plant.fmu", &Description::of("2.0"), b"no library");
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), mode);
        assert_eq!(flown.code, 2);
        assert!(flown.err.contains("plant.fmu`: loading `"), "{}", flown.err);
        bench.expect_no_leftovers();
    }
}

#[test]
fn archives_beyond_the_limits_are_refused_before_they_are_unpacked() {
    let bench = Bench::new();
    let refused = |part: &str| {
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), &[]);
        assert_eq!((flown.code, flown.out.as_str()), (2, ""), "{part}: {}", flown.err);
        assert!(flown.err.contains(part), "{}", flown.err);
    };
    let huge = " ".repeat((1 << 26) + 1);
    bench.archive("plant.fmu", &[("modelDescription.xml", huge.as_bytes())]);
    refused("its `modelDescription.xml` is too large: expected at most 67108864 bytes");
    // Seventeen times 64 MiB of nothing.
    let names: Vec<String> = (0..17).map(|k| format!("resources/{k}")).collect();
    let files: Vec<(&str, &[u8])> = names.iter().map(|n| (n.as_str(), huge.as_bytes())).collect();
    bench.archive("plant.fmu", &files);
    refused("bytes: expected at most 1073741824");
    let library = bench.library("NONE", "2.0", &[]);
    let text = Description::of("2.0").text();
    let files: [(&str, &[u8]); 3] = [
        ("modelDescription.xml", text.as_bytes()),
        ("binaries/linux64/plant.so", &library),
        ("../outside", b"out"),
    ];
    bench.archive("plant.fmu", &files);
    refused("`../outside`: expected a path inside the archive");
    assert!(!bench.path("outside").exists() && !Path::new("outside").exists());
    bench.expect_no_leftovers();
}
