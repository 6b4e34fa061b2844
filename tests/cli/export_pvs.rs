//! The PVS export. PVS itself is not at hand in CI (`proofs/pvs/check.sh` runs it), so a small
//! structural checker reads the theories: brackets and keywords balance, importings resolve with the right number of
//! parameters, every identifier used is declared. The checker is tested on broken theories.

use std::collections::{BTreeMap, BTreeSet};

use crate::common::tools::{stderr_of, stdout_of};
use cordon_core::theorems::words;
use cordon_spec::theorems::{Form, StartSet, Theorem, WeightRange};

/// The words of the language that the export uses.
const RESERVED: &[&str] = &[
    "AND",
    "BEGIN",
    "CONJECTURE",
    "ELSE",
    "ELSIF",
    "END",
    "ENDIF",
    "EXISTS",
    "FORALL",
    "IF",
    "IFF",
    "IMPLIES",
    "IMPORTING",
    "IN",
    "LAMBDA",
    "LEMMA",
    "LET",
    "MEASURE",
    "NOT",
    "OR",
    "RECURSIVE",
    "THEN",
    "THEOREM",
    "THEORY",
    "TYPE",
    "VAR",
    "WITH",
];

/// Words that PVS reserves, in any case, and that must therefore name nothing.
const RESERVED_UNUSED: &[&str] = &[
    "ANDTHEN",
    "ARRAY",
    "AS",
    "ASSUMING",
    "ASSUMPTION",
    "AUTO_REWRITE",
    "AXIOM",
    "BUT",
    "BY",
    "CASES",
    "CHALLENGE",
    "CLAIM",
    "CLOSURE",
    "CODATATYPE",
    "COINDUCTIVE",
    "COND",
    "CONTAINING",
    "CONVERSION",
    "COROLLARY",
    "DATATYPE",
    "ENDASSUMING",
    "ENDCASES",
    "ENDCOND",
    "ENDTABLE",
    "EXPORTING",
    "FACT",
    "FORMULA",
    "FROM",
    "FUNCTION",
    "HAS_TYPE",
    "INDUCTIVE",
    "JUDGEMENT",
    "LAW",
    "LIBRARY",
    "MACRO",
    "NONEMPTY_TYPE",
    "O",
    "OBLIGATION",
    "OF",
    "ORELSE",
    "POSTULATE",
    "PROPOSITION",
    "SUBLEMMA",
    "SUBTYPES",
    "SUBTYPE_OF",
    "TABLE",
    "WHEN",
    "WHERE",
    "XOR",
];

/// What the export takes from the prelude (looked up in PVS's own prelude.pvs).
const PRELUDE: &[&str] = &[
    "nat", "posnat", "real", "nnreal", "posreal", "bool", "TRUE", "below", "upto", "list", "cons",
    "cons?", "car", "cdr", "null", "abs", "expt", "pred",
];

fn tokens(text: &str) -> Vec<String> {
    let mut out = Vec::new();
    for line in text.lines() {
        let mut chars = line.split('%').next().unwrap().chars().peekable();
        while let Some(c) = chars.next() {
            if c.is_whitespace() {
                continue;
            }
            let mut token = c.to_string();
            let wordy = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '?';
            if wordy(c) {
                while chars.peek().is_some_and(|&n| wordy(n)) {
                    token.push(chars.next().unwrap());
                }
            } else {
                let pairs = ["(#", "#)", "(:", ":)", ":=", "<=", ">=", "/=", "->"];
                if chars.peek().is_some_and(|n| pairs.contains(&format!("{c}{n}").as_str())) {
                    token.extend(chars.next());
                }
            }
            out.push(token);
        }
    }
    out
}

fn is_word(token: &str) -> bool {
    token.starts_with(|c: char| c.is_ascii_alphabetic())
}

struct Theory {
    name: String,
    formals: usize,
    tokens: Vec<String>,
}

/// Splits a file into theories, checking the frame of each.
fn theories(text: &str) -> Result<Vec<Theory>, String> {
    let tokens = tokens(text);
    let mut list = Vec::new();
    let mut i = 0;
    while i < tokens.len() {
        let name = tokens[i].clone();
        let begin = tokens[i..].iter().position(|t| t == "BEGIN").ok_or("no BEGIN")? + i;
        let head = &tokens[i + 1..begin];
        let [formals @ .., colon, theory] = head else { return Err(format!("{name}: no head")) };
        if (colon.as_str(), theory.as_str()) != (":", "THEORY") {
            return Err(format!("{name}: expected `: THEORY`"));
        }
        let end = tokens[begin..].iter().position(|t| t == "END").ok_or("no END")? + begin;
        if tokens.get(end + 1) != Some(&name) {
            return Err(format!("{name}: ended by another name"));
        }
        let formals = formals.to_vec();
        let all = [formals.clone(), tokens[begin + 1..end].to_vec()].concat();
        list.push(Theory { name, formals: arguments(&formals), tokens: all });
        i = end + 2;
    }
    Ok(list)
}

/// How many arguments stand between the outer brackets.
fn arguments(tokens: &[String]) -> usize {
    let mut depth = 0;
    let commas = tokens.iter().filter(|t| {
        match t.as_str() {
            "[" | "(" | "{" => depth += 1,
            "]" | ")" | "}" => depth -= 1,
            _ => {}
        }
        *t == "," && depth == 1
    });
    let commas = commas.count();
    if tokens.is_empty() { 0 } else { commas + 1 }
}

fn balanced(theory: &Theory) -> Result<(), String> {
    let mut open = Vec::new();
    for t in &theory.tokens {
        let close = match t.as_str() {
            "(" => ")",
            "[" => "]",
            "{" => "}",
            "(#" => "#)",
            "(:" => ":)",
            "IF" => "ENDIF",
            ")" | "]" | "}" | "#)" | ":)" | "ENDIF" => {
                let expected: Option<&str> = open.pop();
                if expected != Some(t.as_str()) {
                    return Err(format!("{}: `{t}` where {expected:?} was expected", theory.name));
                }
                continue;
            }
            _ => continue,
        };
        open.push(close);
    }
    if open.is_empty() { Ok(()) } else { Err(format!("{}: {open:?} is missing", theory.name)) }
}

/// Names introduced in the theory: declarations, bound variables, record fields.
fn declared(tokens: &[String]) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for (i, t) in tokens.iter().enumerate() {
        if !is_word(t) || RESERVED.contains(&t.as_str()) {
            continue;
        }
        let next = |n: usize| tokens.get(i + n).map_or("", String::as_str);
        let before = if i > 0 { tokens[i - 1].as_str() } else { "" };
        // `k, h: nat` and `name: type` and `field := value`.
        let mut j = 1;
        while next(j) == "," && tokens.get(i + j + 1).is_some_and(|t| is_word(t)) {
            j += 2;
        }
        let typed = next(j) == ":" && (j == 1 || before != "`");
        let assigned = next(1) == ":=" && ["(#", ",", "["].contains(&before);
        // `LET a = .., b = ..` and `name(args): type =`.
        let bound = next(1) == "=" && ["LET", ","].contains(&before);
        let function = next(1) == "(" && {
            let mut depth = 0;
            let close = tokens[i + 1..].iter().position(|t| {
                depth += i32::from(t == "(") - i32::from(t == ")");
                depth == 0
            });
            close.is_some_and(|c| {
                let after = tokens.get(i + c + 2).map(String::as_str);
                let typed = tokens[i + 2..i + 1 + c].iter().any(|t| t == ":");
                after == Some(":") && typed
            })
        };
        if typed || assigned || bound || function {
            names.insert(t.clone());
        }
    }
    names
}

/// Everything the checker has to say.
fn problems(files: &[&str]) -> Vec<String> {
    let mut found = Vec::new();
    let mut known: BTreeMap<String, (usize, BTreeSet<String>)> = BTreeMap::new();
    for file in files {
        let list = match theories(file) {
            Ok(list) => list,
            Err(e) => {
                found.push(e);
                continue;
            }
        };
        for theory in list {
            found.extend(balanced(&theory).err());
            let mut visible = declared(&theory.tokens);
            for name in &visible {
                let upper = name.to_uppercase();
                if RESERVED.iter().chain(RESERVED_UNUSED).any(|r| *r == upper) {
                    found.push(format!("{}: `{name}` is reserved", theory.name));
                }
            }
            let t = &theory.tokens;
            for i in (0..t.len()).filter(|&i| t[i] == "IMPORTING") {
                let name = &t[i + 1];
                let close = t[i..].iter().position(|t| t == "]").unwrap_or(2) + i;
                match known.get(name) {
                    None => found.push(format!("{}: imports unknown `{name}`", theory.name)),
                    Some((formals, _)) if arguments(&t[i + 2..=close]) != *formals => {
                        found.push(format!("{}: `{name}` takes {formals} parameters", theory.name));
                    }
                    Some((_, names)) => visible.extend(names.iter().cloned()),
                }
                visible.insert(name.clone());
            }
            for word in t.iter().filter(|w| is_word(w)) {
                let w = word.as_str();
                if !RESERVED.contains(&w) && !PRELUDE.contains(&w) && !visible.contains(w) {
                    found.push(format!("{}: `{w}` is not declared", theory.name));
                }
            }
            let before = known.insert(theory.name.clone(), (theory.formals, visible));
            if before.is_some() {
                found.push(format!("theory `{}` twice", theory.name));
            }
        }
    }
    found
}

/// The files of an export: theories, and the proofs of each.
fn exported(args: &[&str]) -> Vec<(String, String)> {
    let dir = tempfile::tempdir().unwrap();
    let folder = dir.path().join("new/folder");
    let mut full = vec!["export", "pvs", "--out", folder.to_str().unwrap()];
    full.extend(args);
    let listed = stdout_of(&full);
    let paths: Vec<_> = listed.lines().collect();
    let read = |p: &str| std::fs::read_to_string(p).unwrap();
    let named = |pair: &[&str]| {
        assert_eq!(pair[0].strip_suffix(".pvs"), pair[1].strip_suffix(".prf"), "{listed}");
        (read(pair[0]), read(pair[1]))
    };
    let files: Vec<_> = paths.chunks(2).map(named).collect();
    assert_eq!(files.len(), 5, "{listed}");
    files
}

#[test]
fn every_theory_is_well_formed() {
    let files = exported(&[]);
    let texts: Vec<_> = files.iter().map(|f| f.0.as_str()).collect();
    assert_eq!(problems(&texts), Vec::<String>::new());
    let names: Vec<_> = texts.iter().flat_map(|t| theories(t).unwrap()).map(|t| t.name).collect();
    assert_eq!(
        names,
        [
            "coverage",
            "coverage_execution",
            "coverage_table",
            "coverage_definitions",
            "coverage_lemmas",
            "coverage_theorems",
            "fmu_coverage",
            "fmu_exec_coverage",
            "projection",
            "sums",
            "consensus",
            "consensus_path",
            "coverage_scenario"
        ]
    );
}

#[test]
fn the_checker_finds_what_is_broken() {
    let files = exported(&[]);
    let [global, rest @ ..] = files.as_slice() else { unreachable!() };
    for (from, to, said) in [
        ("END coverage_table", "END coverage_tables", "ended by another name"),
        ("END coverage_table", "", "no END"),
        ("    ENDIF\n    MEASURE k", "    MEASURE k", "is missing"),
        ("getx(s, i - 1) ELSE seg_min", "getx(s, i - 1 ELSE seg_min", "was expected"),
        ("(# row := row_from(s, 0)", "( row := row_from(s, 0)", "was expected"),
        ("IMPORTING coverage[N, n]", "IMPORTING coverages[N, n]", "imports unknown `coverages`"),
        ("IMPORTING coverage[N, n]", "IMPORTING coverage[N]", "takes 2 parameters"),
        ("exec_cvg(xp, xi, xf, i)", "exec_cvg(xp, xi, xg, i)", "`xg` is not declared"),
        ("(t: tabState, k: nat)", "(t: tabState, from: nat)", "`from` is reserved"),
    ] {
        assert!(global.0.contains(from), "{from}");
        let broken = global.0.replacen(from, to, 1);
        let mut texts = vec![broken.as_str()];
        texts.extend(rest.iter().map(|f| f.0.as_str()));
        let found = problems(&texts);
        assert!(found.iter().any(|f| f.contains(said)), "{from} -> {to}: {found:?}");
    }
}

/// The weights of a hypothesis. No `_`: a new range needs its PVS twin.
fn weights(range: WeightRange) -> &'static str {
    match range {
        WeightRange::Any => "TRUE",
        WeightRange::Unit => "0 <= eps AND eps <= 1",
        WeightRange::BelowThird => "0 <= eps AND eps < 1/3",
        WeightRange::BelowHalf => "0 <= eps AND eps < 1/2",
        WeightRange::UpToHalf => "0 <= eps AND eps <= 1/2",
        WeightRange::UpToHalfOrOne => "0 <= eps AND (eps <= 1/2 OR (N = 3 AND eps <= 1))",
        WeightRange::PositiveUpToHalf => "0 < eps AND eps <= 1/2",
        WeightRange::BelowCritical => "0 < eps AND below_critical?",
    }
}

/// The starts of a hypothesis.
fn starts(set: StartSet) -> &'static str {
    match set {
        StartSet::Any => "anchored?(s)",
        StartSet::Ordered => "anchored?(s) AND ordered?(s)",
        StartSet::FirstSubsegment => "anchored?(s) AND ordered?(s) AND first_subsegment?(s)",
        StartSet::UpperBounded => "anchored?(s) AND upper_bounded?(s)",
    }
}

#[test]
fn every_theorem_is_stated_with_its_hypothesis_and_its_erratum() {
    let text = &exported(&[])[1].0;
    let unwrapped = text.replace("\n  %  ", "");
    let stated: Vec<_> = unwrapped.split("  % Sharp: ").collect();
    // What stands before the first, then each from its sharp form up to the next one's.
    assert_eq!(stated.len(), 1 + Theorem::ALL.len());
    for (theorem, pair) in Theorem::ALL.into_iter().zip(stated.windows(2)) {
        let (number, about) = (theorem.number(), words(theorem));
        assert!(pair[0].contains(&format!("  % {number} {}.", about.name)), "{number}");
        if let Some(erratum) = about.erratum {
            assert!(pair[1].contains(&format!("% Erratum: {erratum}.")), "{number}");
        }
        let h = theorem.hypothesis(Form::Sharp);
        let (weights, starts) = (weights(h.weights), starts(h.starts));
        let hypothesis = match theorem {
            Theorem::Limit => format!("{starts} IMPLIES converges?(s)) IFF {weights}\n"),
            _ => format!("({weights}) AND {starts}\n"),
        };
        assert!(pair[1].contains(&hypothesis), "{number}: {hypothesis}");
    }
}

/// Every formula has its proof, in the theory and in the proof file, but for conjectures.
#[test]
fn every_formula_carries_its_proof() {
    let mut formulas = 0;
    for (theories, proofs) in exported(&[]) {
        let lines: Vec<_> = theories.lines().collect();
        for line in &lines {
            let code = line.split('%').next().unwrap();
            let Some((name, _)) = code.split_once(": LEMMA").or(code.split_once(": THEOREM"))
            else {
                continue;
            };
            let name = name.trim();
            assert!(lines.contains(&format!("%|- {name} : PROOF").as_str()), "{name}");
            assert!(proofs.contains(&format!("\n ({name} 0\n  ({name}-1 nil 0\n")), "{name}");
            formulas += 1;
        }
        let scripts = theories.matches("%|- QED").count();
        assert_eq!(proofs.matches("-1 nil 0\n").count(), scripts);
        assert_eq!(proofs.matches('(').count(), proofs.matches(')').count());
    }
    assert!(formulas > 70, "{formulas} formulas");
}

/// What the table of the evidence lists is proved where it says.
#[test]
fn the_table_lists_theorems_of_the_export() {
    let files = exported(&[]);
    let table = std::fs::read_to_string("proofs/pvs/theorems.tsv").unwrap();
    let mut listed = Vec::new();
    for row in table.lines().skip(1) {
        let columns: Vec<_> = row.split('\t').collect();
        let [_, _, name, theory, _] = columns[..] else { panic!("{row}") };
        let inside = files.iter().find_map(|f| {
            let after =
                f.0.split_once(&format!("\n{theory}["))
                    .or(f.0.split_once(&format!("\n{theory}:")))?
                    .1;
            after.split_once(&format!("END {theory}\n")).map(|parts| parts.0)
        });
        let inside = inside.unwrap_or_else(|| panic!("no theory `{theory}`"));
        assert!(inside.contains(&format!("\n  {name}: THEOREM")), "{row}");
        listed.push(name);
    }
    let all = files.iter().map(|f| f.0.matches(": THEOREM").count()).sum::<usize>();
    assert_eq!(listed.len(), all, "every theorem is listed");
}

#[test]
fn a_scenario_brings_its_numbers() {
    let scenario = &exported(&[])[4].0;
    assert!(scenario.contains("IMPORTING coverage_table[5, 3, 0, 100, 1/5]"));
    assert!(scenario.contains("ELSIF i = 3 THEN 30\n    ELSE 100\n    ENDIF"));
    // PROTOCOL section 4, erratum 4: drone 3 is at 42 after the first update with eps = 1/5.
    assert!(scenario.contains("positions(4) = (: 0, 10, 20, 42, 100 :)"));
    let recorded = &exported(&["--scenario", "scenarios/recorded.toml"])[4].0;
    assert!(recorded.contains("IMPORTING coverage_table[5, 5, 0, 10, 1/4]"));
    assert!(recorded.contains("positions(6) = (: 0, 1, 2, 9/2, 10 :)"));
    let all = stdout_of(&["export", "pvs"]);
    assert_eq!(all.matches("END coverage").count(), 7);
}

#[test]
fn bad_input_is_named() {
    let error = stderr_of(&["export", "pvs", "--scenario", "scenarios/consensus.toml"], 2);
    assert_eq!(
        error,
        "error: scenarios/consensus.toml: protocol: `consensus`: expected `coverage`, the protocol of the paper's listings\n"
    );
    let error = stderr_of(&["export", "pvs", "--scenario", "no/such.toml"], 74);
    assert!(error.starts_with("error: cannot read `no/such.toml`"), "{error}");
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("file");
    std::fs::write(&file, "").unwrap();
    let error = stderr_of(&["export", "pvs", "--out", file.to_str().unwrap()], 74);
    assert!(error.starts_with("error: cannot write to `"), "{error}");
    assert!(error.ends_with("`: a file: expected a folder, or a name for a new one\n"), "{error}");
    let long = dir.path().join("long.toml");
    std::fs::write(&long, "drones = 1001\nmax = 9\nspread_to = 3\nweight = 0.5\n").unwrap();
    let error = stderr_of(&["export", "pvs", "--scenario", long.to_str().unwrap()], 2);
    assert_eq!(
        error,
        format!(
            "error: {}: drones: `1001`: expected at most 1000 in a PVS theory\n",
            long.display()
        )
    );
}
