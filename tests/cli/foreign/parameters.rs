//! Parameters: set, read back, in batches.

use std::fs;

use super::{Bench, Description};

#[test]
fn start_values_reach_tools_that_take_them_early_and_tools_that_take_them_late() {
    let bench = Bench::new();
    for version in ["2.0", "3.0"] {
        for fault in ["EARLY_ONLY", "LATE_ONLY"] {
            let flown = bench.fly(fault, version, &[]);
            assert_eq!((flown.code, flown.rows[1][8].as_str()), (0, "20.0"), "{fault} {version}");
        }
        let flown = bench.fly("FORGETFUL", version, &[]);
        assert_eq!((flown.code, flown.rows[1][8].as_str()), (0, "0.0"));
        let expected = "warning: unit `plant2`: `";
        assert!(flown.err.starts_with(expected), "{}", flown.err);
        assert!(
            flown.err.contains("parameter `x0` was set to `20` and reads back as `0`"),
            "{}",
            flown.err
        );
    }
}

/// Parameters of every type are set, and read back: what an FMU does not keep is a warning.
#[test]
fn integers_booleans_and_texts_are_set_and_read_back() {
    let bench = Bench::new();
    let parameter = |version: &str, kind: &str, name: &str, reference: usize| match version {
        "2.0" => format!(
            r#"<ScalarVariable name="{name}" valueReference="{reference}" causality="parameter"><{kind} start="0"/></ScalarVariable>"#
        ),
        _ => {
            format!(r#"<{kind} name="{name}" valueReference="{reference}" causality="parameter"/>"#)
        }
    };
    let mut set = 0;
    for (version, whole) in [("2.0", "Integer"), ("3.0", "Int8"), ("3.0", "UInt64")] {
        let kinds = [(whole, "gear"), ("Boolean", "armed"), ("String", "label")];
        let mut description = Description::of(version);
        let parameters = kinds.iter().zip(103..);
        description.more =
            parameters.map(|((kind, name), r)| parameter(version, kind, name, r)).collect();
        let more = "[unit.parameters]\ngear = 5\narmed = true\nlabel = \"north\"\n";
        for fault in ["NONE", "FORGETFUL"] {
            bench.fmu("plant.fmu", &description, &bench.library(fault, version, &[]));
            let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], more), &[]);
            assert_eq!(flown.code, 0, "{}", flown.err);
            let calls = bench.trace();
            for call in ["integer 5", "boolean 1", "north 5"] {
                assert!(calls.iter().any(|c| c == call), "{version} {whole}: {call} in {calls:?}");
                set += 1;
            }
            for (name, value, back) in
                [("gear", "5", "0"), ("armed", "true", "false"), ("label", "north", "")]
            {
                let warning =
                    format!("parameter `{name}` was set to `{value}` and reads back as `{back}`");
                assert_eq!(flown.err.contains(&warning), fault == "FORGETFUL", "{}", flown.err);
            }
        }
        // More than the type holds.
        bench.fmu("plant.fmu", &description, &bench.library("NONE", version, &[]));
        let more = more.replace('5', if whole == "UInt64" { "-1" } else { "5000000000" });
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], &more), &[]);
        assert_eq!(flown.code, 2);
        assert!(flown.err.contains("setting `gear`: `"), "{}", flown.err);
    }
    assert_eq!(set, 3 * 2 * 3);
}

/// A range or a list of values makes a run for each combination, in an order that is always the same.
#[test]
fn parameters_with_several_values_make_a_batch() {
    let bench = Bench::new();
    let mut description = Description::of("3.0");
    description.more =
        r#"<Int8 name="gear" valueReference="103" causality="parameter" start="0"/>"#.into();
    bench.fmu("plant.fmu", &description, &bench.library("NONE", "3.0", &[]));
    let with = |parameters: &str| {
        let more = format!("[unit.parameters]\n{parameters}");
        bench.scenario(&[(2, "plant.fmu")], &more)
    };
    let scenario = with("gear = [1, 2]\nx0 = { from = 20, to = 21, runs = 3 }");
    let csv = bench.text("table.csv");
    let (code, out, err) = bench.run(&["cosim", &scenario, "--out", &csv]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    let table = fs::read_to_string(&csv).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|l| l.split(',').collect()).collect();
    assert_eq!(rows[0][..4], ["run", "plant2.gear", "plant2.x0", "collisions"]);
    let values: Vec<String> = rows[1..].iter().map(|r| r[..3].join(" ")).collect();
    assert_eq!(values, ["1 1 20", "2 1 41/2", "3 1 21", "4 2 20", "5 2 41/2", "6 2 21"]);
    // It glides on from where it starts: 9 m, 8.5 m and 8 m from drone 3 to the right, and 2 m on.
    let gaps: Vec<f64> = rows[1..].iter().map(|r| r[5].parse().unwrap()).collect();
    assert_eq!(gaps[..3], gaps[3..]);
    assert!(gaps[0] > gaps[1] && gaps[1] > gaps[2], "{gaps:?}");
    assert!(bench.trace().contains(&"integer 2".to_owned()));
    let again = bench.run(&["cosim", &scenario]);
    assert_eq!((again.0, again.1.as_str()), (0, out.as_str()), "the same table");
    for (parameters, part) in [
        ("x0 = []", "s.toml:12:6: unit.parameters.x0: expected at least one value"),
        ("x0 = [1, true]", "unit.parameters.x0: expected numbers"),
        ("x0 = { from = 1, runs = 3 }", "unit.parameters.x0: to is missing"),
        ("x0 = { from = 1, to = 2, runs = 1 }", "runs: expected 2 to 10000"),
        ("x0 = { from = 1, to = 2, step = 1 }", "expected `from`, `to` and `runs`"),
        ("gear = [0.5, 1]", "`1/2`: expected a whole number"),
        (
            "x0 = { from = 0, to = 1, runs = 101 }\ny0 = { from = 0, to = 1, runs = 101 }",
            "too many runs",
        ),
    ] {
        let (code, out, err) = bench.run(&["cosim", &with(parameters)]);
        assert_eq!((code, out.as_str()), (2, ""), "{parameters}");
        assert!(err.contains(part), "{parameters}: {err}");
    }
    let scenario = with("x0 = [20, 21]");
    for (args, part) in [
        (
            &["replay", &scenario, "--out", &bench.text("page.html")][..],
            "2 values: expected one in a run",
        ),
        (&["cosim", &scenario, "--exact"], "exact: expected one run"),
        (&["cosim", &scenario, "--variables", "*.x"], "variables: expected one run"),
        (&["cosim", &scenario, "--format", "json"], "format: expected `csv`"),
    ] {
        let (code, out, err) = bench.run(args);
        assert_eq!((code, out.as_str()), (2, ""), "{args:?}");
        assert!(err.contains(part), "{args:?}: {err}");
    }
    bench.expect_no_leftovers();
}

#[test]
fn parameters_of_an_fmu_are_set_by_its_own_names_and_checked() {
    let bench = Bench::new();
    let library = bench.library("NONE", "3.0", &[]);
    let mut description = Description::of("3.0");
    description.more =
        r#"<Int32 name="mode" valueReference="102" causality="parameter" start="0"/>"#.into();
    bench.fmu("plant.fmu", &description, &library);
    let with = |parameters: &str| {
        let more = format!("[unit.parameters]\n{parameters}");
        bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], &more), &[])
    };
    let flown = with("x0 = 21.25");
    assert_eq!((flown.code, flown.rows[1][8].as_str()), (0, "21.25"), "{}", flown.err);
    for (parameters, part) in [
        ("speed = 1", "variable `speed`: `"),
        ("x = 1", "it is output: expected a parameter"),
        ("x0 = true", "it has type Float64: expected a value of that type"),
        ("mode = 1.5", "`3/2`: expected a whole number"),
    ] {
        let flown = with(parameters);
        assert_eq!((flown.code, flown.out.as_str()), (2, ""), "{parameters}");
        assert!(flown.err.contains(part), "{parameters}: {}", flown.err);
    }
}

/// A coordination unit of another tool has its identifier as a double: a parameter is told it so.
#[test]
fn a_foreign_coordination_unit_flies_and_is_told_its_identifier() {
    let bench = Bench::new();
    let variable = |name: &str, reference: u32, causality: &str, start: &str| {
        format!(
            r#"<ScalarVariable name="{name}" valueReference="{reference}" causality="{causality}"><Real {start}/></ScalarVariable>"#
        )
    };
    let text = format!(
        r#"<fmiModelDescription fmiVersion="2.0" modelName="test" guid="t"><CoSimulation modelIdentifier="plant"/><ModelVariables>{}{}{}{}</ModelVariables><ModelStructure/></fmiModelDescription>"#,
        variable("x_prec", 0, "input", r#"start="0""#),
        variable("x_foll", 1, "input", r#"start="0""#),
        variable("x_d", 4, "output", ""),
        variable("id", 100, "parameter", r#"start="0""#)
    );
    let library = bench.library("NONE", "2.0", &[]);
    let files: [(&str, &[u8]); 2] =
        [("modelDescription.xml", text.as_bytes()), ("binaries/linux64/plant.so", &library)];
    bench.archive("coordination.fmu", &files);
    let scenario = bench.path("s.toml");
    let flown = |exchange: &str| {
        let text = format!(
            "start = [0, 10, 20, 30, 100]\nweight = 0.2\nperiod = 4\ntau = 0.05\n[flight]\n\
             exchange = \"{exchange}\"\nduration = 2\n[[unit]]\ndrone = 3\nunit = \"coordination\"\n\
             fmu = \"coordination.fmu\"\nnames = {{ prec = \"x_prec\", foll = \"x_foll\" }}\n"
        );
        fs::write(&scenario, text).unwrap();
        bench.fly_scenario(scenario.to_str().unwrap(), &[])
    };
    let run = flown("double");
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    // It starts where its identifier says, and grows by the step in each.
    let x_d: Vec<f64> = run.rows[1..].iter().map(|row| row[4].parse().unwrap()).collect();
    assert_eq!((x_d.len(), x_d[0], x_d[1]), (41, 3.0, 3.05));
    // Its neighbour hears it: drone 2's first update is 20 + (10 + 3 - 40)/5.
    assert_eq!(run.rows[2][3], "14.6");
    assert!(run.out.contains("coordination3 is `coordination.fmu`"), "{}", run.out);
    let run = flown("exact");
    assert_eq!(run.code, 2);
    assert!(run.err.contains("expected String"), "{}", run.err);
}

/// In the plane gaps are distances, and what is off at the end is so in both directions.
#[test]
fn a_planar_batch_has_distances() {
    let bench = Bench::new();
    bench.fmu("plant.fmu", &Description::of("2.0"), &bench.library("NONE", "2.0", &[]));
    let start: Vec<String> =
        (0..16).flat_map(|i| [(i % 4 * 10).to_string(), (i / 4 * 7).to_string()]).collect();
    let protocol = std::path::absolute("scenarios/own/grid.toml").unwrap();
    let text = format!(
        "protocol = '{}'\nstart = [{}]\nweight = 0.2\nperiod = 4\ntau = 0.05\n[flight]\n\
         duration = 0.5\n[[unit]]\ndrone = 0\nunit = \"plant\"\nfmu = \"plant.fmu\"\n\
         [unit.parameters]\ny0 = [0, 4, -40]\n",
        protocol.display(),
        start.join(", ")
    );
    fs::write(bench.path("s.toml"), text).unwrap();
    let csv = bench.text("table.csv");
    let (code, _, err) = bench.run(&["cosim", &bench.text("s.toml"), "--out", &csv]);
    assert_eq!(code, 0, "{err}");
    let table = fs::read_to_string(&csv).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|l| l.split(',').collect()).collect();
    assert_eq!(rows[0][4..], ["smallest gap", "at [s]", "off at end"]);
    // Drone 4 is at (0, 7); drone 0 starts 7 m, 3 m and 47 m below it, and glides along x.
    assert_eq!(rows[2][4..6], ["3.0000", "0.00"]);
    let numbers = |row: usize| [4, 6].map(|k| rows[row][k].parse::<f64>().unwrap());
    assert!(numbers(1)[0] > 6.0 && numbers(3)[0] > 6.0, "{rows:?}");
    // 40 m are missing across the line alone.
    assert!(numbers(3)[1] > 40.0, "{rows:?}");
}
