//! `cordon separation`, and the gaps that runs have beside those that it certifies.
use std::fs;

use cordon_core::random::SplitMix;
use serde_json::Value;

use crate::common::run;

fn certified(scenario: &str, more: &[&str]) -> (i32, Value) {
    let args = [&["separation", scenario, "--format", "json"], more].concat();
    let (code, out, err) = run(&args);
    assert_eq!(err, "", "{scenario}");
    (code, serde_json::from_str(&out).unwrap())
}

#[test]
fn the_authors_run_keeps_its_ten_metres() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("certificates");
    let (code, page) = certified("scenarios/paper.toml", &["--out", out.to_str().unwrap()]);
    assert_eq!((code, &page["gap"], &page["evidence"]), (0, &"10".into(), &"certified".into()));
    let mut checked = 0;
    for file in page["files"].as_array().unwrap() {
        let (code, said, _) = run(&["check", file.as_str().unwrap()]);
        assert!(
            code == 0 && said.contains("proved: for all integers k, if k >= 0 then "),
            "{said}"
        );
        checked += 1;
    }
    assert_eq!(checked, 2);
    // Wind costs 12.5 s^2 of it.
    let (code, page) = certified("scenarios/paper.toml", &["--wind", "0.4"]);
    assert_eq!((code, &page["gap"], &page["wind"]["costs"]), (0, &"5".into(), &"5".into()));
    let (code, page) = certified("scenarios/paper.toml", &["--wind", "0.8"]);
    assert_eq!((code, &page["gap"], &page["holds"]), (3, &"0".into(), &false.into()));
    assert_eq!(page["evidence"], Value::Null);
    // A response that is somewhere negative costs a little.
    let (code, page) = certified("scenarios/quick.toml", &[]);
    let gap = cordon_core::exact::parse("gap", page["gap"].as_str().unwrap()).unwrap();
    assert!((cordon_core::exact::to_f64(&gap) - 7.804_891).abs() < 1e-4, "{gap}");
    assert_eq!((code, &page["evidence"]), (0, &"inductive".into()));
    // And so does wind, a little more than 2 W/lambda_P^2 then; without an exchange, and with the other plant.
    for flags in [&[][..], &["--master", "gauss-seidel"], &["--integrator", "exact"]] {
        let (code, page) = certified("scenarios/quick.toml", &[&["--wind", "1"], flags].concat());
        let number = |x: &Value| {
            cordon_core::exact::to_f64(
                &cordon_core::exact::parse("x", x.as_str().unwrap()).unwrap(),
            )
        };
        let (gap, costs) = (number(&page["gap"]), number(&page["wind"]["costs"]));
        assert!(code == 0 && costs > 2.0 && costs < 2.4 && gap > 4.0, "{flags:?}: {gap} {costs}");
    }
}

#[test]
fn what_is_not_known_is_not_certified_and_what_is_no_one_system_is_refused() {
    let (code, out, _) = run(&["separation", "scenarios/paper-unstable.toml"]);
    assert_eq!(code, 3);
    assert!(out.contains("not certified: no bound of the gaps is known"), "{out}");
    assert!(out.contains("eps = 7/10 is not in [0, 1/2]: a step may lower"), "{out}");
    // An unstable loop.
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        path.display().to_string()
    };
    let flown = "start = [0, 1, 3]\nweight = 1\n[flight]\nlambda_P = 1\nlambda_A = 10\n";
    let (code, out, _) = run(&["separation", &file("unstable.toml", flown)]);
    assert_eq!(code, 3);
    assert!(out.contains("no bound of that was found"), "{out}");
    let direct = file("direct.toml", &format!("{flown}master = \"gauss-seidel\"\n"));
    assert_eq!(run(&["separation", &direct]).0, 0, "without the exchange it is stable");
    for (file, reason) in [
        ("scenarios/consensus.toml".to_owned(), "protocol: `consensus`: expected `coverage`"),
        ("scenarios/faults.toml".to_owned(), "fault: expected none"),
        (
            file(
                "fmu.toml",
                "start = [0, 2, 3]\nweight = 0.1\n[[unit]]\ndrone = 1\nunit = \"plant\"\nfmu = \"a.fmu\"\n",
            ),
            "drones that differ are not one linear system",
        ),
    ] {
        let (code, out, err) = run(&["separation", &file]);
        assert_eq!((code, out.as_str()), (2, ""), "{file}");
        assert!(err.contains(reason), "{err}");
    }
    let recorded = ["separation", "scenarios/paper.toml", "--compat", "recorded"];
    let (code, out, err) = run(&recorded);
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(err.contains("--compat: `recorded`: expected none"), "{err}");
    assert_eq!(run(&recorded[..2]).0, 0);
    let (code, _, err) = run(&["separation", "scenarios/paper.toml", "--wind", "-1"]);
    assert_eq!(code, 2);
    assert!(err.contains("wind: `-1`: expected 0 or more m/s2"), "{err}");
}

#[test]
fn the_gain_is_bracketed_from_both_sides() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().display().to_string();
    let mut brackets = Vec::new();
    for (integrator, master) in [("euler", "jacobi"), ("euler", "gauss-seidel")] {
        let flags = ["--integrator", integrator, "--master", master, "--out", &out];
        let call = ["threshold", "--property", "separation", "--format", "json"];
        let (code, page, _) = run(&[&call[..], &flags].concat());
        assert_eq!(code, 0, "{page}");
        let page: Value = serde_json::from_str(&page).unwrap();
        let gain = |side: &str| page[side]["lambda_p"].as_str().unwrap().to_owned();
        brackets.push((gain("below"), gain("above")));
        for file in page["files"].as_array().unwrap() {
            assert_eq!(run(&["check", file.as_str().unwrap()]).0, 0);
        }
    }
    let expected = [("91/100", "23/25"), ("22/25", "9/10")];
    let expected = expected.map(|(a, b)| (a.to_owned(), b.to_owned()));
    assert_eq!(brackets, expected);
    let (code, _, err) = run(&["threshold", "--property", "ordering"]);
    assert_eq!(code, 2);
    assert!(err.contains("drones: expected --drones N"), "{err}");
}

/// Starts, weights, gains, integrators, masters and orders drawn from a seed: the smallest gap that
/// a run has is never below the certified one, and sometimes hardly above it.
#[test]
fn no_run_has_a_gap_below_the_certified_one() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = SplitMix::new(18);
    let (mut certified_runs, mut near) = (0, 0);
    for k in 0..24 {
        let drones = 3 + random.below(5);
        let places = |random: &mut SplitMix| {
            let gaps = (0..drones).map(|_| 1 + random.below(40));
            let places = gaps.scan(0, |x, gap| {
                let at = *x;
                *x += gap;
                Some(at)
            });
            places.map(|x| x.to_string()).collect::<Vec<_>>().join(", ")
        };
        let desired = places(&mut random);
        let actual = if random.below(3) == 0 { places(&mut random) } else { desired.clone() };
        let mut pick = |list: &[&str]| list[random.below(list.len() as u64) as usize].to_owned();
        let (eps, period) = (pick(&["0.1", "1/3", "0.5"]), pick(&["1", "4", "14"]));
        let gains = pick(&["0.4 4", "0.4 2", "0.8 4", "1 4", "1/2 3"]);
        let (lambda_p, lambda_a) = gains.split_once(' ').unwrap();
        let (integrator, master) = (pick(&["euler", "exact"]), pick(&["jacobi", "gauss-seidel"]));
        let order = pick(&["at-once", "ascending", "descending"]);
        let text = format!(
            "start = [{desired}]\nweight = \"{eps}\"\nperiod = {period}\ntau = 0.05\n[flight]\nstart = [{actual}]\n\
             lambda_P = \"{lambda_p}\"\nlambda_A = \"{lambda_a}\"\nintegrator = \"{integrator}\"\n\
             master = \"{master}\"\norder = \"{order}\"\nduration = 20\n"
        );
        let scenario = folder.path().join(format!("{k}.toml")).display().to_string();
        fs::write(&scenario, &text).unwrap();
        let (code, page) = certified(&scenario, &[]);
        if code == 3 {
            // Only where swinging past costs more than there is.
            assert_eq!((lambda_p, page["holds"].as_bool()), ("1", Some(false)), "{text}{page}");
            continue;
        }
        assert_eq!(code, 0, "{text}{page}");
        let gap = cordon_core::exact::parse("gap", page["gap"].as_str().unwrap()).unwrap();
        let gap = cordon_core::exact::to_f64(&gap);
        let csv = folder.path().join("run.csv").display().to_string();
        let (code, said, _) = run(&["cosim", &scenario, "--out", &csv]);
        assert_eq!(code, 0, "{text}");
        assert!(said.contains("no collision") && said.contains("smallest gap"), "{text}{said}");
        let least = fs::read_to_string(&csv)
            .unwrap()
            .lines()
            .skip(1)
            .map(|line| {
                let row: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
                let actual = &row[row.len() - drones as usize..];
                actual.windows(2).map(|x| x[1] - x[0]).fold(f64::INFINITY, f64::min)
            })
            .fold(f64::INFINITY, f64::min);
        assert!(least >= gap - 1e-9, "{least} below {gap}:\n{text}");
        certified_runs += 1;
        near += usize::from(least < gap + 1e-6);
    }
    assert!(certified_runs >= 20 && near >= 10, "{certified_runs} {near}");
}
