//! `cordon cosim`, `figures` and `replay` as a user runs them.
use std::fs;
use std::path::Path;

use crate::common::run;
use serde_json::Value;

fn in_folder(name: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name).display().to_string();
    (folder, path)
}

fn files_in(folder: &Path) -> usize {
    fs::read_dir(folder).unwrap().count()
}

#[test]
fn a_summary_says_where_the_drones_are_and_what_happened() {
    let (code, out, err) = run(&["cosim", "scenarios/paper.toml"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(
        out.contains("10.00  0.00  24.95  49.93  74.95  100.00  0.00  22.05  44.91  69.16  100.00"),
        "{out}"
    );
    assert!(out.contains("no collision, at the grid points and between them (this run only)"));
    let (code, out, _) = run(&["cosim", "scenarios/paper-unstable.toml", "--exact"]);
    assert_eq!(code, 0);
    assert!(out.contains("at 12.5912 s drones 1 and 2 collide\n"), "{out}");
    assert!(out.contains("largest difference from the run in exact arithmetic: desired "), "{out}");
}

#[test]
fn csv_and_json_say_the_same_and_read_back() {
    let (folder, csv) = in_folder("run.csv");
    let json = folder.path().join("run.json").display().to_string();
    let flags = ["cosim", "scenarios/faults.toml", "--out"];
    assert_eq!(run(&[&flags[..], &[&csv]].concat()).0, 0);
    assert_eq!(run(&[&flags[..], &[&json, "--progress"]].concat()).0, 0);
    let (code, printed, said) = run(&["cosim", "scenarios/faults.toml", "--format", "csv"]);
    assert_eq!(code, 0);
    assert_eq!(printed, fs::read_to_string(&csv).unwrap());
    assert!(said.contains("the paper's coverage run with bad radio"));
    assert_eq!(printed.lines().count(), 402);
    let page: Value = serde_json::from_str(&fs::read_to_string(&json).unwrap()).unwrap();
    assert_eq!(page["schema"], "cordon-cosim/1");
    assert_eq!(page["time"].as_array().unwrap().len(), 401);
    let row: Vec<f64> =
        printed.lines().nth(200).unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    assert_eq!(page["desired"][199][2].as_f64().unwrap(), row[3]);
    assert_eq!(page["actual"][199][2].as_f64().unwrap(), row[8]);
    for run_file in [&csv, &json] {
        let html = folder.path().join("page.html").display().to_string();
        assert_eq!(run(&["replay", run_file, "--out", &html]).0, 0);
        assert!(fs::read_to_string(&html).unwrap().contains("</html>"));
    }
    // The CSV, its companion, the JSON, the page.
    assert_eq!(files_in(folder.path()), 4, "nothing temporary is left");
}

/// Events on the exact plant's curves and between the samples: straight lines tell others.
#[test]
fn a_replayed_file_and_a_replayed_scenario_are_the_same_page() {
    let (folder, csv) = in_folder("run.csv");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let flight = ["scenarios/paper-unstable.toml", "--integrator", "exact", "--duration", "15"];
    let page = |args: &[&str]| {
        let html = path("page.html");
        let (code, _, err) = run(&[&["replay"], args, &["--out", &html]].concat());
        assert_eq!(code, 0, "{err}");
        fs::read_to_string(html).unwrap()
    };
    let flown = page(&flight);
    assert!(flown.contains("\"kind\":\"collision\"") && flown.contains("exact plant"));
    for out in [&csv, &path("run.json")] {
        assert_eq!(run(&[&["cosim"], &flight[..], &["--out", out]].concat()).0, 0);
        assert_eq!(page(&[out]), flown, "{out}");
    }
    // Without the companion there are the positions alone.
    let companion = path("run.csv.json");
    let kept = fs::read(&companion).unwrap();
    fs::remove_file(&companion).unwrap();
    assert_ne!(page(&[&csv]), flown);
    // The companion of another run is refused.
    let text = fs::read_to_string(&csv).unwrap();
    fs::write(&csv, text.replacen(",10.0,", ",10.5,", 1)).unwrap();
    fs::write(&companion, &kept).unwrap();
    let (code, _, err) = run(&["replay", &csv, "--out", &path("page.html")]);
    assert_eq!(code, 2);
    assert!(err.contains("run.csv.json`: belongs to another run"), "{err}");
    let cut = String::from_utf8(kept).unwrap();
    fs::write(&companion, &cut[..cut.len() / 2]).unwrap();
    let (code, _, err) = run(&["replay", &csv, "--out", &path("page.html")]);
    assert_eq!(code, 2);
    assert!(err.contains("expected schema cordon-cosim-companion/1"), "{err}");
}

/// Any numbers of the units, by patterns: in every form with their units, and read back.
#[test]
fn variables_are_recorded_by_name() {
    let (folder, csv) = in_folder("run.csv");
    let json = folder.path().join("run.json").display().to_string();
    let flags = ["cosim", "scenarios/paper.toml", "--duration", "1"];
    let wanted = ["--variables", "*.w1,plant?.z,coordination3.weight"];
    let call = |more: &[&str]| run(&[&flags[..], &wanted[..], more].concat());
    assert_eq!(call(&["--out", &csv]).0, 0);
    assert_eq!(call(&["--out", &json]).0, 0);
    let text = fs::read_to_string(&csv).unwrap();
    let head: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    // Beside time and positions: w1 of controllers and plants, z of plants, a weight.
    assert_eq!(head.len(), 1 + 10 + 10 + 5 + 1);
    assert_eq!(head[11..14], ["control0.w1 [rad/s]", "plant0.w1 [rad/s]", "plant0.z [m]"]);
    assert!(head.contains(&"coordination3.weight [1]"), "{head:?}");
    let page: Value = serde_json::from_str(&fs::read_to_string(&json).unwrap()).unwrap();
    let column = |name: &str| {
        let index = head.iter().position(|h| h.starts_with(name)).unwrap();
        let cell = |l: &str| l.split(',').nth(index).unwrap().parse::<f64>().unwrap();
        text.lines().skip(1).map(cell).collect::<Vec<_>>()
    };
    let mut compared = 0;
    for variable in page["variables"].as_array().unwrap() {
        let values = variable["values"].as_array().unwrap().iter();
        let values: Vec<f64> = values.map(|x| x.as_f64().unwrap()).collect();
        let name = format!("{} ", variable["name"].as_str().unwrap());
        assert_eq!(column(&name), values, "{name}");
        compared += 1;
    }
    assert_eq!(compared, 16);
    // The take-off: the plants' height is what the companion has, and rotors lead.
    assert!(column("plant0.z ").windows(2).all(|z| z[0] <= z[1]));
    assert_eq!(column("control0.w1 ")[0], 0.0);
    assert!(column("control0.w1 ")[1] > 0.0);
    assert_eq!(column("coordination3.weight")[7], 0.2);
    // The same without them, column by column.
    let (_, plain, _) = run(&[&flags[..], &["--format", "csv"]].concat());
    let first: Vec<String> =
        text.lines().map(|l| l.split(',').take(11).collect::<Vec<_>>().join(",")).collect();
    assert_eq!(plain.lines().collect::<Vec<_>>(), first);
    for run_file in [&csv, &json] {
        let html = folder.path().join("page.html").display().to_string();
        assert_eq!(run(&["replay", run_file, "--out", &html]).0, 0);
    }
    let (code, _, err) = run(&[&flags[..], &["--variables", "*.w1,*.speed"]].concat());
    assert_eq!(code, 2);
    assert!(err.contains("variables: `*.speed`: expected a pattern of names of numbers"), "{err}");
}

/// A protocol file with x and y, in every form: both axes, and the page with the plane.
#[test]
fn planar_runs_are_written_and_read_back() {
    let (folder, csv) = in_folder("run.csv");
    let json = folder.path().join("run.json").display().to_string();
    let html = folder.path().join("page.html").display().to_string();
    let start: Vec<String> = (0..16).map(|i| format!("{},{}", i % 4 * 10, i / 4 * 10)).collect();
    let start = start.join(",");
    let flags =
        ["cosim", "--protocol", "scenarios/own/grid.toml", "--eps", "1/5", "--start", &start];
    let rest = ["--period", "4", "--duration", "20", "--exact", "--out"];
    let mut pages = Vec::new();
    for out in [&csv, &json] {
        let (code, said, err) = run(&[&flags[..], &rest[..], &[out]].concat());
        assert_eq!((code, err.as_str()), (0, ""));
        assert!(said.contains("desired x_d and y_d, actual x and y, in m)"), "{said}");
        assert!(said.contains("smallest distance ") && !said.contains("order"), "{said}");
        assert!(said.contains("largest difference from the run in exact arithmetic"), "{said}");
        assert_eq!(run(&["replay", out, "--out", &html]).0, 0);
        pages.push(fs::read_to_string(&html).unwrap());
    }
    assert_eq!(pages[0], pages[1]);
    let text = fs::read_to_string(&csv).unwrap();
    let head: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    assert_eq!((head.len(), head[33], head[49]), (65, "yd0", "y0"));
    let cells: Vec<f64> =
        text.lines().nth(401).unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    // All have come near the middle, in x as in y.
    assert!(
        cells[17..33].iter().chain(&cells[49..65]).all(|x| (x - 15.0).abs() < 8.0),
        "{cells:?}"
    );
    crate::common::schema::meets(
        "cordon-cosim/1",
        &serde_json::from_str(&fs::read_to_string(&json).unwrap()).unwrap(),
        "planar",
    );
    let companion = fs::read_to_string(format!("{csv}.json")).unwrap();
    crate::common::schema::meets(
        "cordon-cosim-companion/1",
        &serde_json::from_str(&companion).unwrap(),
        "planar",
    );
    let short = text.replace(",y15", "");
    fs::write(&csv, short).unwrap();
    fs::remove_file(format!("{csv}.json")).unwrap();
    let (code, _, err) = run(&["replay", &csv, "--out", &html]);
    assert_eq!(code, 2);
    assert!(err.contains(":1: expected the columns time, xd0"), "{err}");
}

/// The summary says what flew: nothing claims a plant or an arithmetic that was another.
#[test]
fn the_recorded_arithmetic_is_named() {
    let (code, out, _) = run(&["cosim", "scenarios/paper.toml", "--compat", "recorded"]);
    assert_eq!(code, 0);
    assert!(out.contains("jacobi master, arithmetic of the recorded runs"), "{out}");
    let (_, out, _) = run(&["cosim", "scenarios/paper.toml"]);
    assert!(!out.contains("recorded runs"), "{out}");
}

/// Neighbours' new desired positions within the step, with six digits as in the recorded runs; worked
/// out by hand for the second update, in tick 7.
#[test]
fn the_recorded_arithmetic_flies_in_an_order_of_updates_too() {
    let mut flown = 0;
    for (order, second) in [
        ("at-once", [1.0, 2.375, 5.25]),
        ("ascending", [1.0, 2.375, 5.34375]),
        // 2.796875 is heard as 2.79688.
        ("descending", [1.246095, 2.796875, 5.34375]),
        ("0,2,1,3,4", [1.09375, 2.375, 5.34375]),
    ] {
        let (_folder, csv) = in_folder("run.csv");
        let args =
            ["cosim", "scenarios/recorded.toml", "--compat", "recorded", "--duration", "0.5"];
        let args = [&args[..], &["--order", order, "--out", &csv]].concat();
        assert_eq!(run(&args).0, 0, "{order}");
        let text = fs::read_to_string(csv).unwrap();
        // The head, the start, six ticks, and the seventh.
        let row: Vec<f64> =
            text.lines().nth(8).unwrap().split(',').map(|x| x.parse().unwrap()).collect();
        assert_eq!(row[2..5], second, "{order}");
        flown += 1;
    }
    assert_eq!(flown, 4);
}

#[test]
fn bad_runs_are_refused_by_name_and_leave_nothing() {
    let (folder, good) = in_folder("good.csv");
    let (_, text, _) =
        run(&["cosim", "scenarios/paper.toml", "--duration", "1", "--format", "csv"]);
    fs::write(&good, &text).unwrap();
    let (_, whole, _) =
        run(&["cosim", "scenarios/paper.toml", "--duration", "1", "--format", "json"]);
    let lines = |n: usize| text.lines().take(n).map(|l| format!("{l}\n")).collect::<String>();
    let row = |from: &str, to: &str| text.replacen(from, to, 1);
    let cases = [
        ("cut.csv", text[..text.len() - 40].to_owned(), ":22: the last line is cut off"),
        ("short.csv", format!("{}0.5,1\n", lines(3)), ":4: 2 fields: expected 11"),
        ("head.csv", row("time", "when"), ":1: expected the columns time, xd0"),
        ("empty.csv", String::new(), ":1: expected the columns"),
        ("lonely.csv", lines(2), "5 drones at 1 times: expected at least 2 of each"),
        ("word.csv", row("12.4192", "twelve"), "`twelve`: expected a finite number"),
        ("nan.csv", row("12.4192", "NaN"), "`NaN`: expected a finite number"),
        ("back.csv", row("\n0.1,", "\n0.01,"), "back.csv:4: expected a time after that before"),
        (
            "cut.json",
            whole[..whole.len() / 2].to_owned(),
            "expected a whole run, schema cordon-cosim/1",
        ),
        (
            "other.json",
            whole.replace("cordon-cosim/1", "cordon-cosim/9"),
            "schema: `cordon-cosim/9`",
        ),
        (
            "few.json",
            whole.replace("\"drones\":5", "\"drones\":4"),
            "expected one position for each of the 4 drones",
        ),
        ("extra.json", whole.replace("\"title\"", "\"name\""), "unknown field `name`"),
    ];
    let page = folder.path().join("page.html").display().to_string();
    let mut refused = 0;
    for (name, content, expected) in &cases {
        let path = folder.path().join(name).display().to_string();
        fs::write(&path, content).unwrap();
        let (code, out, err) = run(&["replay", &path, "--out", &page]);
        assert_eq!((code, out.as_str()), (2, ""), "{name}");
        assert!(err.contains(name) && err.contains(expected), "{name}: {err}");
        refused += 1;
    }
    assert_eq!(refused, 12);
    assert!(!Path::new(&page).exists());
    let (code, _, err) = run(&["replay", "no/such.csv", "--out", &page]);
    assert_eq!(code, 74);
    assert!(err.contains("cannot read `no/such.csv`"), "{err}");
    assert_eq!(files_in(folder.path()), cases.len() + 1);
}

#[test]
fn bad_flights_are_refused() {
    let (folder, scenario) = in_folder("bad.toml");
    let base = "start = [0, 10, 20, 30, 100]\nweight = 0.2\nperiod = 4\ntau = 0.05\n";
    let cases = [
        ("[flight]\nlambda_Q = 1\n", "bad.toml:6:1: unknown field `lambda_Q`"),
        ("[flight]\nlambda_P = \"x\"\n", "bad.toml:6:12: lambda_P: `x` is not a number"),
        ("[flight]\nstart = [0, true]\n", "bad.toml:6:13: flight.start: expected a number"),
        (
            "[flight]\nintegrator = \"rk4\"\n",
            "bad.toml:6:14: integrator: `rk4`: expected `euler` or `exact`",
        ),
        ("[[fault]]\nkind = \"lost\"\n", "bad.toml:6:8: fault: `lost` is unknown"),
        ("[[fault]]\nkind = \"loss\"\n", "bad.toml:6:8: fault: probability is missing"),
        (
            "[[fault]]\nkind = \"delay\"\nticks = 1\ndrone = 2\n",
            "bad.toml:6:8: fault: `drone` is not a field of a `delay`",
        ),
        ("[[fault]]\nkind = \"loss\"\nodds = 2\n", "unknown field `odds`"),
    ];
    let out = folder.path().join("run.csv").display().to_string();
    for (table, expected) in cases {
        fs::write(&scenario, format!("{base}{table}")).unwrap();
        let (code, _, err) = run(&["cosim", &scenario, "--out", &out]);
        assert_eq!(code, 2, "{table}: {err}");
        assert!(err.contains(expected), "{err}, expected {expected}");
        // The other commands read the same files.
        assert!(run(&["trace", &scenario]).0 == 2 || table.contains("rk4"));
    }
    for (flags, expected) in [
        (&["--duration", "1.02"][..], "duration: `51/50`: expected a whole multiple"),
        (
            &["--compat", "recorded", "--integrator", "exact"],
            "integrator: `exact`: expected `euler`",
        ),
        (&["--exchange", "morse"], "exchange: `morse`: expected `exact` or `double`"),
        (&["--duration", "400000000"], "expected at most 67108864 positions"),
    ] {
        let (code, _, err) =
            run(&[&["cosim", "scenarios/paper.toml", "--out", &out], flags].concat());
        assert_eq!(code, 2, "{err}");
        assert!(err.contains(expected), "{err}");
    }
    let (code, _, err) = run(&["cosim", "scenarios/paper.toml", "--out", "no/such/folder/run.csv"]);
    assert_eq!(code, 74);
    assert!(err.contains("cannot write `no/such/folder/run.csv`"), "{err}");
    let (code, _, err) =
        run(&["replay", "tests/data/recorded/run-a.csv", "--duration", "3", "--out", &out]);
    assert_eq!(code, 2);
    assert!(err.contains("duration: expected a scenario to fly, found a run"), "{err}");
    assert_eq!(files_in(folder.path()), 1, "nothing was written");
}

/// A build without Parquet says so; one that has it writes a file with its magic number.
#[test]
fn parquet_is_written_or_refused_in_words() {
    let (_folder, path) = in_folder("run.parquet");
    let (code, _, err) = run(&["cosim", "scenarios/paper.toml", "--duration", "1", "--out", &path]);
    if cfg!(feature = "parquet") {
        let bytes = fs::read(&path).unwrap();
        assert_eq!(code, 0, "{err}");
        assert!(bytes.starts_with(b"PAR1") && bytes.ends_with(b"PAR1"));
    } else {
        assert_eq!(code, 2);
        assert!(err.contains("this build has no Parquet"), "{err}");
        assert!(!Path::new(&path).exists());
    }
}

#[test]
fn figures_are_drawn_as_svg_and_png() {
    let (folder, path) = in_folder("figures");
    let (code, out, _) = run(&["figures", "--out", &path]);
    assert_eq!(code, 0);
    assert_eq!(out.lines().count(), 9);
    for (number, what) in [
        (8, "desired positions, coverage, eps = 0.2"),
        (9, "actual positions, coverage, eps = 0.2"),
        (10, "desired position of the central drone, coverage"),
        (11, "desired positions, coverage, eps = 0.7"),
        (12, "actual positions, coverage, eps = 0.7"),
        (13, "the drones at the start, coverage, eps = 0.2"),
        (14, "the drones at 9.65 s, coverage, eps = 0.2"),
        (15, "desired positions, consensus, eps = 0.3"),
        (16, "actual positions, consensus, eps = 0.3"),
    ] {
        let svg = fs::read_to_string(format!("{path}/fig{number:02}.svg")).unwrap();
        assert!(svg.contains(&format!("Fig. {number}: {what}")), "{number}");
        let across = if [13, 14].contains(&number) { "position x [m]" } else { "time t [s]" };
        assert!(svg.contains(across) && svg.contains("[m]") && svg.ends_with("</svg>\n"));
        assert_eq!(svg.contains("drones 1 and 2 collide at 12.59 s"), number == 12);
    }
    let (code, out, _) = run(&["figures", "12,15", "--format", "png", "--out", &path]);
    assert_eq!((code, out.lines().count()), (0, 2));
    let png = fs::read(format!("{path}/fig12.png")).unwrap();
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n") && png.len() > 20_000);
    assert_eq!(files_in(Path::new(&path)), 11);
    let (code, _, err) = run(&["figures", "7", "--out", &path]);
    assert_eq!(code, 2);
    assert!(err.contains("figure: `7` is unknown: expected some of 8, 9, 10"), "{err}");
    drop(folder);
}
