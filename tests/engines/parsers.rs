//! Parsers against mutated inputs: an error or a result, never a panic, and never an internal
//! fault. A smoke run of 2,000 inputs a parser; `CORDON_FUZZ=1000000` runs as many instead.
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use cordon_core::random::SplitMix;
use cordon_core::{Error, exact, range};
use cordon_cosim::cosimulation::Cosimulation;
use cordon_cosim::fmi::interface::FmiVersion;
use cordon_cosim::store;
use cordon_formats::fmi::package;
use cordon_formats::interchange::{self, Assembly, into_cps};
use cordon_proof::export::conjecture::Conjecture;
use cordon_proof::export::smt_model::read_answer;
use cordon_proof::export::smt2::{Obligation, Query, WeightDomain};
use cordon_proof::sweep::store as results;
use cordon_run::scenario;
use cordon_spec::theorems::{Form, Theorem};

/// Tokens at which parsers break, if any do.
const TOKENS: &[&[u8]] = &[
    b"0",
    b"-1",
    b"1e309",
    b"1/0",
    b"99999999999999999999999999999999999999999",
    b"nan",
    b"inf",
    b"18446744073709551615",
    b"-0.0",
    b"\"",
    b"'",
    b"[",
    b"]",
    b"{",
    b"}",
    b"[[",
    b"]]",
    b"=",
    b",",
    b".",
    b"..",
    b"\n",
    b"\r\n",
    b"\t",
    b"\\u0000",
    b"\xef\xbb\xbf",
    b"\xc3\x28",
    b"\xf0\x9f\x9a\x81",
    b"(",
    b")",
    b"null",
    b"true",
    b"1_000",
    b"0x7f",
    b"#",
    b"x0",
    b"eps",
    b"*",
];

/// One input, a few changes away from a good one.
fn mutated(good: &[u8], random: &mut SplitMix) -> Vec<u8> {
    let mut bytes = good.to_vec();
    for _ in 0..=random.below(4) {
        let length = bytes.len() as u64;
        let mut at = |most: u64| usize::try_from(random.below(most + 1)).unwrap();
        let (from, to) = (at(length), at(length));
        let (from, to) = (from.min(to), from.max(to).min(from.min(to) + 40));
        let token = TOKENS[at(TOKENS.len() as u64 - 1)];
        match at(6) {
            0 => drop(bytes.drain(from..to)),
            1 => drop(bytes.splice(from..from, token.iter().copied())),
            2 => drop(bytes.splice(from..to, token.iter().copied())),
            3 => {
                let part = bytes[from..to].to_vec();
                drop(bytes.splice(to..to, part));
            }
            4 => bytes.truncate(from.max(1)),
            5 if from < bytes.len() => bytes[from] ^= 1 << at(7),
            // Another number where one is.
            _ => {
                if let Some(digit) = bytes.iter().skip(from).position(u8::is_ascii_digit) {
                    let digit = from + digit;
                    drop(bytes.splice(digit..=digit, token.iter().copied()));
                }
            }
        }
    }
    bytes
}

/// Runs a parser on mutations of good inputs, which it has to accept as they are.
fn smoke(name: &str, good: &[Vec<u8>], parse: impl Fn(&[u8]) -> Result<(), Error>) {
    let inputs = std::env::var("CORDON_FUZZ").ok().and_then(|n| n.parse().ok()).unwrap_or(2_000);
    assert!(!good.is_empty(), "{name}");
    for good in good {
        if let Err(e) = parse(good) {
            panic!("{name} refuses a good input: {e}");
        }
    }
    let mut random = SplitMix::new(name.bytes().fold(0, |h, b| h * 31 + u64::from(b)));
    let (mut refused, mut ran) = (0, 0);
    for _ in 0..inputs {
        let from = &good[usize::try_from(random.below(good.len() as u64)).unwrap()];
        let input = mutated(from, &mut random);
        match catch_unwind(AssertUnwindSafe(|| parse(&input))) {
            Ok(Ok(())) => {}
            Ok(Err(Error::Input(message))) => {
                assert!(!message.contains('\u{1b}') || input.contains(&0x1b), "{name}: {message}");
                refused += 1;
            }
            Ok(Err(e)) => panic!("{name}: {e} from {:?}", String::from_utf8_lossy(&input)),
            Err(_) => panic!("{name} panics on {:?}", String::from_utf8_lossy(&input)),
        }
        ran += 1;
    }
    assert_eq!(ran, inputs);
    // Mutations that are all accepted or all refused by the first byte would test nothing.
    assert!(refused * 10 > ran && refused < ran, "{name}: {refused} of {ran} refused");
}

fn text(bytes: &[u8]) -> Result<&str, Error> {
    std::str::from_utf8(bytes).map_err(|_| Error::input("expected UTF-8 text"))
}

fn files_of(folder: &str, ending: &str) -> Vec<Vec<u8>> {
    let mut paths: Vec<PathBuf> =
        fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == ending));
    paths.sort();
    paths.iter().map(|p| fs::read(p).unwrap()).collect()
}

/// A parser of files, given bytes.
fn through_file<T>(
    name: &str,
    read: impl Fn(&Path) -> Result<T, Error>,
) -> impl Fn(&[u8]) -> Result<(), Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    move |bytes| {
        let _kept = &folder;
        fs::write(&path, bytes).unwrap();
        read(&path).map(|_| ())
    }
}

#[test]
fn scenarios() {
    smoke("scenario", &files_of("scenarios", "toml"), |bytes| {
        let draft = scenario::parse("x.toml", text(bytes)?)?;
        // A million drones spread out is a scenario; it takes a second.
        if draft.drones.is_some_and(|n| n > 1_000) {
            return Ok(());
        }
        let flight = draft.flight.clone();
        Cosimulation::new(draft.finish()?, flight).map(|_| ())
    });
}

#[test]
fn own_protocols() {
    smoke("own protocol", &files_of("scenarios/own", "toml"), |bytes| {
        let file = cordon_run::protocol::parse("x.toml", text(bytes)?)?;
        // Many agents take a second each.
        if file.agents.fewest() > 60 { Ok(()) } else { file.system().map(|_| ()) }
    });
}

#[test]
fn certificates() {
    let short: Vec<_> =
        files_of("proofs/certificates", "json").into_iter().filter(|c| c.len() < 1_500).collect();
    smoke("certificate", &short, |bytes| match cordon_check::check(text(bytes)?) {
        cordon_check::Verdict::Valid { .. } => Ok(()),
        verdict => Err(Error::input(verdict.to_string())),
    });
}

fn swarm() -> Cosimulation {
    let draft = scenario::parse(
        "x.toml",
        "start = [0, 10, 20, 100]\nweight = 0.2\nperiod = 4\ntau = 0.05\n[flight]\nduration = 1\n",
    )
    .unwrap();
    let flight = draft.flight.clone();
    Cosimulation::new(draft.finish().unwrap(), flight).unwrap()
}

#[test]
fn recorded_runs() {
    let record = cordon_cosim::run::run(&swarm()).unwrap();
    for (name, format) in [("run.csv", store::Format::Csv), ("run.json", store::Format::Json)] {
        let mut good = Vec::new();
        store::write(&record, format, &mut good).unwrap();
        smoke(name, &[good], through_file(name, store::load));
    }
}

#[test]
fn result_files_of_sweeps() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sweep.jsonl");
    let out = path.display().to_string();
    let call = [
        "sweep",
        "7.2,7.6ii",
        "--form",
        "both",
        "--drones",
        "3",
        "--grid",
        "3",
        "--steps",
        "2",
        "--out",
        &out,
    ];
    assert_eq!(crate::common::run(&call).0, 1);
    let good = fs::read(&path).unwrap();
    let merge = |path: &Path| cordon_proof::sweep::merge::merge(&[path.to_owned()]);
    smoke("sweep", std::slice::from_ref(&good), through_file("sweep.jsonl", results::read));
    // Every line is held against the others: hardly a mutation passes.
    let merged = through_file("sweep.jsonl", merge);
    smoke("merge", &[good], |bytes| merged(bytes));
}

#[test]
fn multi_models() {
    let assembly = Assembly::of(&swarm()).unwrap();
    let good = serde_json::to_vec_pretty(&into_cps::multi_model(&assembly)).unwrap();
    // The FMUs that it names lie beside it; nothing runs them.
    let folder = tempfile::tempdir().unwrap();
    for model in assembly.models() {
        let fmu = package::fmu(model, FmiVersion::V2, b"no binary").unwrap();
        fs::write(folder.path().join(into_cps::fmu_file(model)), fmu).unwrap();
    }
    let path = folder.path().join("mm.json");
    smoke("multi-model", &[good], |bytes| {
        fs::write(&path, bytes).unwrap();
        match interchange::read(&path) {
            // Another name of an FMU is the name of a file that is not there.
            Err(Error::File { .. }) => Err(Error::input("no such FMU")),
            read => read.map(|_| ()),
        }
    });
}

#[test]
fn answers_of_solvers() {
    let query = Query {
        claim: Conjecture::Theorem(Theorem::Ordering),
        form: Form::Sharp,
        drones: 4,
        obligation: Obligation::Violated { steps: 1 },
        weights: WeightDomain::Beyond,
    };
    let values: Vec<String> =
        query.symbols().iter().map(|s| format!("({s} (/ 1.0 (- 3.0)))")).collect();
    let good = [b"unsat\n".to_vec(), format!("sat\n({})\n", values.join("\n ")).into_bytes()];
    smoke("answer", &good, |bytes| read_answer(&query, text(bytes)?).map(|_| ()));
}

#[test]
fn numbers_ranges_and_lists() {
    let good = ["-3/4", "0.2", "1.5e-3", "12345678901234567890", "1e300"];
    let good: Vec<_> = good.iter().map(|t| t.as_bytes().to_vec()).collect();
    smoke("number", &good, |bytes| exact::parse("x", text(bytes)?).map(|_| ()));
    let good = [b"0..1/2".to_vec(), b"1/5".to_vec(), b"(1/2,1]".to_vec()];
    smoke("interval", &good, |bytes| range::interval("eps", text(bytes)?).map(|_| ()));
    let good = [b"3..7".to_vec(), b"5".to_vec()];
    smoke("whole", &good, |bytes| range::whole("drones", text(bytes)?, 3..=50).map(|_| ()));
    let good = [b"0,1/3,0.5,2".to_vec()];
    smoke("list", &good, |bytes| {
        range::list(|i| format!("start: drone {i}"), text(bytes)?).map(|_| ())
    });
}

#[test]
fn the_smoke_can_be_seen() {
    let panics = catch_unwind(|| {
        smoke("one that panics", &[b"good".to_vec()], |bytes| {
            assert!(bytes.len() < 5, "too long");
            if bytes == b"good" { Ok(()) } else { Err(Error::input("bad")) }
        });
    });
    assert!(panics.is_err());
    let internal = catch_unwind(|| {
        smoke("one that blames itself", &[b"good".to_vec()], |bytes| {
            if bytes == b"good" { Ok(()) } else { Err(Error::internal("bad")) }
        });
    });
    assert!(internal.is_err());
}
