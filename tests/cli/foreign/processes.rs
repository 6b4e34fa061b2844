//! What flies where, and what is left when it dies.

use std::fs;
use std::process::Command;

use super::{Bench, Description, MODES};
use crate::common::run;

#[test]
fn fmus_fly_side_by_side_each_alone_in_its_process() {
    let bench = Bench::new();
    // Its second instance in a process would be none.
    let library = bench.library("ONCE", "2.0", &[]);
    bench.fmu("plant.fmu", &Description::of("2.0"), &library);
    let scenario = bench.scenario(&[(1, "plant.fmu"), (2, "plant.fmu"), (3, "plant.fmu")], "");
    let flown = bench.fly_scenario(&scenario, &[]);
    assert_eq!(flown.code, 0, "{}", flown.err);
    for (drone, column) in [(1, 7), (2, 8), (3, 9)] {
        let x: f64 = flown.rows.last().unwrap()[column].parse().unwrap();
        assert!((x - (10.0 * f64::from(drone) + 2.0)).abs() < 1e-9, "drone {drone}: {x}");
    }
    bench.expect_no_leftovers();
}

/// Killed with an FMU inside the process, the program leaves a folder that the next run removes.
#[test]
fn what_a_killed_process_leaves_the_next_one_removes() {
    let bench = Bench::new();
    bench.fmu("plant.fmu", &Description::of("2.0"), &bench.library("SEGFAULT", "2.0", &[]));
    let scenario = bench.scenario(&[(2, "plant.fmu")], "");
    let (code, _, _) = bench.run(&["cosim", &scenario, "--in-process"]);
    assert_eq!(code, -1, "a signal");
    let left = || fs::read_dir(bench.path("tmp")).unwrap().count();
    assert_eq!(left(), 1);
    bench.fmu("plant.fmu", &Description::of("2.0"), &bench.library("NONE", "2.0", &[]));
    for mode in MODES {
        assert_eq!(bench.run(&[&["cosim", &scenario], mode].concat()).0, 0);
        bench.expect_no_leftovers();
    }
}

/// Killed in the middle of a hanging step, the program leaves no folder and no process behind.
#[test]
fn nothing_is_left_where_the_program_is_killed() {
    let bench = Bench::new();
    let library = bench.library("HANG", "2.0", &[]);
    bench.fmu("plant.fmu", &Description::of("2.0"), &library);
    let scenario = bench.scenario(&[(2, "plant.fmu")], "");
    fs::create_dir_all(bench.path("tmp")).unwrap();
    let mut flying = Command::new(env!("CARGO_BIN_EXE_cordon"))
        .args(["cosim", &scenario])
        .env("TMPDIR", bench.path("tmp"))
        .env("CORDON_TEST_TRACE", bench.path("trace"))
        .spawn()
        .unwrap();
    // Long enough to be a failure; none of it passes where all is well.
    let wait = |what: &str, done: &dyn Fn() -> bool| {
        let came = (0..3000).any(|_| {
            std::thread::sleep(std::time::Duration::from_millis(20));
            done()
        });
        assert!(came, "{what}");
    };
    let begun = || fs::read_to_string(bench.path("trace")).is_ok_and(|t| t.contains("leave"));
    wait("the plant is initialised", &begun);
    assert_eq!(fs::read_dir(bench.path("tmp")).unwrap().count(), 1);
    flying.kill().unwrap();
    flying.wait().unwrap();
    wait("the unpacked archive is removed", &|| {
        fs::read_dir(bench.path("tmp")).unwrap().count() == 0
    });
}

#[test]
fn flags_about_processes_are_checked() {
    for (flags, part) in [
        (&["--step-limit", "0"][..], "step-limit: `0`: expected a positive number of seconds"),
        (&["--step-limit", "-1"][..], "step-limit"),
    ] {
        let (code, _, err) = run(&[&["cosim", "scenarios/paper.toml"], flags].concat());
        assert_eq!(code, 2);
        assert!(err.contains(part), "{err}");
    }
}

/// All units of a step have begun it when the first one's death is seen; the first of them is named.
#[test]
fn of_several_that_die_in_one_step_the_first_is_named() {
    let bench = Bench::new();
    let description = Description::of("2.0");
    bench.fmu("crash.fmu", &description, &bench.library("SEGFAULT", "2.0", &[]));
    bench.fmu("fails.fmu", &description, &bench.library("ERROR", "2.0", &[]));
    bench.fmu("hangs.fmu", &description, &bench.library("HANG", "2.0", &[]));
    for (plants, expected) in [
        (["crash.fmu", "fails.fmu", "hangs.fmu"], "unit `plant1`: `"),
        (["fails.fmu", "hangs.fmu", "crash.fmu"], "stepping: error: engine number 42 is cold"),
    ] {
        let [first, second, third] = plants;
        let scenario = bench.scenario(&[(1, first), (2, second), (3, third)], "");
        let flown = bench.fly_scenario(&scenario, &["--step-limit", "5"]);
        assert_eq!(flown.code, 2);
        assert!(flown.err.contains("unit `plant1`: `"), "{}", flown.err);
        assert!(flown.err.contains(expected) && !flown.err.contains("plant2"), "{}", flown.err);
        assert_eq!(flown.rows.len(), 21, "what was flown until then");
        bench.expect_no_leftovers();
    }
}
