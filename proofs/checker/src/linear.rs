//! Certificates about a user's linear system: invariants by Farkas' lemma, limits by quadratic forms.
//!
//! A mode's row is affine in the state and in each parameter. What is affine in each parameter is least, and
//! a positive definite form of it greatest, at a vertex of the box of their ranges: the vertices decide.

use std::collections::{BTreeMap, BTreeSet};

use crate::expr::Relation::{Positive, Zero};
use crate::expr::{Literal, Signature, Sort};
use crate::format::{Edge, Invariance, Linear, Named, Quadratic};
use crate::kernel::{Fault, Kernel, fault};
use crate::number::{Number, charge, exhausted};
use crate::poly::{Atom, Poly};

type Result<T> = std::result::Result<T, Fault>;
type Matrix = Vec<Vec<Number>>;

const FORMS: &str = "system";
const INVARIANCE: &str = "invariance";
const QUADRATIC: &str = "quadratic";

/// A linear system as read.
struct System<'c> {
    written: &'c Linear,
    /// The names of the state.
    state: Signature,
    /// What each mode makes of each variable that it changes.
    modes: BTreeMap<&'c str, BTreeMap<&'c str, Poly>>,
}

/// A name space of reals.
fn reals<'n>(names: impl Iterator<Item = &'n String>) -> Result<Signature> {
    let mut kernel = Kernel::default();
    for name in names {
        let name = kernel.fresh(name, &Vec::new())?;
        kernel.signature.constants.insert(name, Sort::Real);
    }
    Ok(kernel.signature)
}

/// Reads a polynomial that is affine in the variables together, and in each other name.
fn affine(text: &str, names: &Signature, variables: &Signature) -> Result<Poly> {
    let poly = names.poly(text, &Vec::new(), false).or_else(|e| fault("expression", e))?;
    is_affine(&poly, text, variables)?;
    Ok(poly)
}

fn is_affine(poly: &Poly, text: &str, variables: &Signature) -> Result<()> {
    let fits = |m: &Vec<Atom>| {
        m.iter().filter(|a| variables.knows(a)).count() < 2 && m.windows(2).all(|w| w[0] != w[1])
    };
    match poly.terms().all(|(m, _)| fits(m)) {
        true => Ok(()),
        false => fault(FORMS, format!("`{text:.60}` is not affine")),
    }
}

impl<'c> System<'c> {
    fn read(written: &'c Linear) -> Result<Self> {
        let state = reals(written.state.iter())?;
        let rows = reals(written.state.iter().chain(written.parameters.0.keys()))?;
        if let Some((name, _)) = written.parameters.0.iter().find(|(_, [low, high])| low > high) {
            return fault(FORMS, format!("the range of `{name}` is empty"));
        }
        let mut modes = BTreeMap::new();
        for (name, updates) in &written.modes.0 {
            let mut mode = BTreeMap::new();
            for (variable, text) in &updates.0 {
                if !state.constants.contains_key(variable.as_str()) {
                    return fault(
                        FORMS,
                        format!("mode `{name:.40}`: no variable `{variable:.40}`"),
                    );
                }
                mode.insert(variable.as_str(), affine(text, &rows, &state)?);
            }
            modes.insert(name.as_str(), mode);
        }
        if written.state.is_empty() || modes.is_empty() {
            return fault(FORMS, "a system without variables, or without modes");
        }
        Ok(Self { written, state, modes })
    }

    fn literal(&self, text: &str) -> Result<Literal> {
        let literal = self.state.literal(text, &Vec::new());
        let literal = literal.or_else(|e| fault("expression", e))?;
        is_affine(&literal.poly, text, &self.state)?;
        Ok(literal)
    }

    /// What a mode makes of each variable that it changes.
    fn rows(&self, mode: &str) -> Result<&BTreeMap<&'c str, Poly>> {
        self.modes.get(mode).map_or_else(|| fault(FORMS, format!("no mode `{mode:.40}`")), Ok)
    }

    /// The forms at each vertex of the box of the parameters that occur in them: lower ends first,
    /// the last parameter by name changing fastest. A range that is a point counts once.
    fn vertices(&self, forms: &[Poly]) -> Result<Vec<Vec<Poly>>> {
        let names = |f: &Poly| f.terms().flat_map(|(m, _)| m.clone()).collect::<Vec<_>>();
        let occur: BTreeSet<Atom> = forms.iter().flat_map(names).collect();
        let mut all = vec![forms.to_vec()];
        for atom in &occur {
            let Atom::Var(name) = atom else { continue };
            let Some([low, high]) = self.written.parameters.0.get(&**name) else { continue };
            if !charge(128 * all.len() as u64) {
                return fault("work", "more than a file is allowed");
            }
            let ends = if low == high { vec![low] } else { vec![low, high] };
            let at = |forms: &Vec<Poly>, end: &Number| -> Vec<Poly> {
                let value = |v: &str| (*v == **name).then(|| Poly::constant(end.clone()));
                forms.iter().map(|f| f.with(&value)).collect()
            };
            all = all.iter().flat_map(|f| ends.iter().map(|end| at(f, end))).collect();
        }
        Ok(all)
    }

    fn words(&self) -> String {
        let mut words = format!("a linear system of {}", self.written.state.join(", "));
        for (name, rows) in &self.modes {
            let rows: Vec<String> = rows.iter().map(|(v, row)| format!("{v}' = {row}")).collect();
            words += &format!("\n  mode {name}: {}", rows.join(", "));
        }
        for (name, [low, high]) in &self.written.parameters.0 {
            words += &format!("\n  in each step any {name} in [{low}, {high}]");
        }
        words
    }
}

/// Farkas' lemma: the goal is a sum of literals given, with multipliers that are >= 0 but for equations, and of a constant >= 0.
/// Where it says more than >= 0, so does the sum.
fn follows(
    given: &[Literal],
    goal: &Literal,
    multipliers: &Named<Number>,
) -> std::result::Result<(), String> {
    let (mut rest, mut strict) = (goal.poly.clone(), false);
    for (name, m) in &multipliers.0 {
        let index = name.parse().ok().filter(|i: &usize| i.to_string() == *name);
        let Some(fact) = index.and_then(|i| given.get(i)) else {
            return Err(format!("no literal `{name:.40}` is given"));
        };
        if fact.relation != Zero && (goal.relation == Zero || *m < Number::whole(0)) {
            return Err(format!(
                "the multiplier of literal {name} has to be of an equation, or >= 0"
            ));
        }
        strict |= fact.relation == Positive && m.is_positive();
        rest = rest - &(Poly::constant(m.clone()) * &fact.poly);
    }
    if let Some(atom) = rest.terms().find_map(|(m, _)| m.first()) {
        return Err(format!("the multipliers do not give the coefficient of {atom}"));
    }
    let constant = rest.coefficient(&[]);
    match goal.relation {
        Zero if !constant.is_zero() => Err(format!("{constant:.40} is left of the equation")),
        _ if constant < Number::whole(0) => {
            Err(format!("the bound is missed by {:.40}", constant.magnitude()))
        }
        Positive if constant.is_zero() && !strict => {
            Err("the bound is reached, but not strictly".into())
        }
        _ => Ok(()),
    }
}

/// `invariance`: what holds at a node holds at the ends of its edges, after a step where the edge takes one.
pub fn invariance(c: &Invariance) -> Result<(String, usize)> {
    let system = System::read(&c.system)?;
    let mut nodes = BTreeMap::new();
    for (name, literals) in &c.nodes.0 {
        let literals = literals.iter().map(|l| system.literal(l)).collect::<Result<Vec<_>>>()?;
        nodes.insert(name.as_str(), literals);
    }
    let node = |name: &str| match nodes.get(name) {
        Some(literals) => Ok(literals),
        None => fault(INVARIANCE, format!("no node `{name:.40}`")),
    };
    let start = node(&c.start)?;
    let mut proved = 0;
    for edge in &c.edges {
        let place = format!("edge {}", path(edge));
        let (given, goals) = (node(&edge.from)?, node(&edge.to)?);
        let rows = edge.by.as_ref().map(|mode| system.rows(mode)).transpose()?;
        if goals.len() != edge.multipliers.len() {
            let rows = edge.multipliers.len();
            return fault(
                INVARIANCE,
                format!("{place}: {rows} rows of multipliers: expected {}", goals.len()),
            );
        }
        for (row, (goal, multipliers)) in goals.iter().zip(&edge.multipliers).enumerate() {
            let after =
                rows.map_or(goal.poly.clone(), |rows| goal.poly.with(&|v| rows.get(v).cloned()));
            let vertices = system.vertices(&[after])?;
            if vertices.len() != multipliers.len() {
                let (found, count) = (multipliers.len(), vertices.len());
                return fault(
                    INVARIANCE,
                    format!("{place}, row {row}: {found} vertices: expected {count}"),
                );
            }
            for (vertex, (poly, multipliers)) in
                vertices.into_iter().flatten().zip(multipliers).enumerate()
            {
                let goal = Literal { poly, relation: goal.relation };
                follows(given, &goal, multipliers).or_else(|why| {
                    fault(INVARIANCE, format!("{place}, row {row}, vertex {vertex}: {why}"))
                })?;
                proved += 1;
            }
        }
    }
    let mut claims: BTreeMap<Literal, Nodes<'_>> = BTreeMap::new();
    for claim in &c.claims {
        let goal = system.literal(&claim.holds)?;
        follows(node(&claim.at)?, &goal, &claim.multipliers)
            .or_else(|why| fault(INVARIANCE, format!("claim at `{:.40}`: {why}", claim.at)))?;
        proved += 1;
        claims.entry(goal).or_default().insert(&claim.at);
    }
    if claims.is_empty() {
        return fault(INVARIANCE, "nothing is claimed");
    }
    let assumed: Vec<String> = start.iter().map(ToString::to_string).collect();
    let mut words =
        vec![system.words(), format!("assuming of the start: {}", assumed.join(" and "))];
    words.extend(said(c, &system, &claims));
    Ok((words.join("\n  "), proved))
}

fn path(edge: &Edge) -> String {
    let by = edge.by.as_ref().map_or(String::new(), |m| format!("{m}-"));
    format!("{:.40} -{by:.40}> {:.40}", edge.from, edge.to)
}

type Nodes<'c> = BTreeSet<&'c str>;

/// The edges by the node that they leave.
struct Graph<'c>(BTreeMap<&'c str, Vec<&'c Edge>>);

impl<'c> Graph<'c> {
    fn leaving(&self, node: &str) -> impl Iterator<Item = &'c Edge> {
        self.0.get(node).into_iter().flatten().copied().filter(|_| charge(128))
    }

    /// The node and those that it implies, by edges without a step.
    fn near(&self, node: &'c str) -> Nodes<'c> {
        self.closed([node].into(), |e| e.by.is_none())
    }

    /// Where edges of a kind lead from these nodes, themselves among them.
    fn closed(&self, mut all: Nodes<'c>, kind: impl Fn(&Edge) -> bool) -> Nodes<'c> {
        let mut open: Vec<&str> = all.iter().copied().collect();
        while let Some(node) = open.pop() {
            let ends = self.leaving(node).filter(|e| kind(e)).map(|e| e.to.as_str());
            open.extend(ends.filter(|to| all.insert(to)));
        }
        all
    }
}

/// What follows for the runs: for all of them, where every mode has an edge wherever a run can stand; else
/// for those along the edges.
fn said<'c>(
    c: &'c Invariance,
    system: &System<'c>,
    claims: &BTreeMap<Literal, Nodes<'c>>,
) -> Vec<String> {
    let mut graph = Graph(BTreeMap::new());
    for edge in &c.edges {
        graph.0.entry(&edge.from).or_default().push(edge);
    }
    let reached = graph.closed([c.start.as_str()].into(), |_| true);
    // Of each node: the nodes that it implies, and the steps that they allow.
    let all: BTreeMap<&str, (Nodes<'c>, Vec<&Edge>)> = reached
        .into_iter()
        .map(|n| {
            let near = graph.near(n);
            let steps = near.iter().flat_map(|n| graph.leaving(n)).filter(|e| e.by.is_some());
            (n, (near.clone(), steps.collect()))
        })
        .collect();
    let stepped = |nodes: &Nodes<'c>| -> Nodes<'c> {
        let steps = nodes.iter().filter_map(|n| all.get(n)).flat_map(|(_, steps)| steps);
        steps.filter(|_| charge(128)).map(|e| e.to.as_str()).collect()
    };
    let mut standing = Nodes::from([c.start.as_str()]);
    let mut front = standing.clone();
    while !front.is_empty() {
        front = stepped(&front).difference(&standing).copied().collect();
        standing.extend(&front);
    }
    let modes = |n: &&str| {
        let steps = all.get(n).into_iter().flat_map(|(_, steps)| steps);
        steps.filter_map(|e| e.by.as_deref()).collect::<Nodes<'_>>().len()
    };
    let every = standing.iter().all(|n| modes(n) == system.modes.len());
    let who = match (every, system.modes.len()) {
        (true, 1) => "proved of every run".to_owned(),
        (true, _) => "proved of every run, whatever mode acts in each step".to_owned(),
        _ => {
            let edges: Vec<String> = c.edges.iter().map(path).collect();
            format!("proved of the runs along {}", edges.join(", "))
        }
    };
    // Where runs can stand after 0, 1, .. steps or more; nothing is said of steps after which they end.
    let mut late = Vec::new();
    if standing.iter().all(|n| modes(n) > 0) {
        late.push(standing);
        while let Some(last) = late.last() {
            let next = stepped(last);
            if next == *last || exhausted() {
                break;
            }
            late.push(next);
        }
    }
    // Claims that hold alike are said together.
    let mut lines: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (goal, at) in claims {
        let holds =
            |n: &&str| charge(128) && all.get(n).is_some_and(|(near, _)| !near.is_disjoint(at));
        let when = match late.iter().position(|nodes| nodes.iter().all(&holds)) {
            Some(0) => "at every step".to_owned(),
            Some(k) => format!("from step {k} on"),
            None => format!("at {}", at.iter().copied().collect::<Vec<_>>().join(" and ")),
        };
        lines.entry(when).or_default().push(goal.to_string());
    }
    lines
        .into_iter()
        .map(|(when, goals)| format!("{who}, {when}: {}", goals.join(" and ")))
        .collect()
}

/// Most readouts: a form of them has as many rows.
const MAX_READOUTS: usize = 200;

/// The symmetric matrix with that lower triangle.
fn symmetric(triangle: &[Vec<Number>], size: usize) -> Result<Matrix> {
    if triangle.len() != size || triangle.iter().enumerate().any(|(i, row)| row.len() != i + 1) {
        return fault(QUADRATIC, format!("a lower triangle of {size} rows is expected"));
    }
    let entry = |i: usize, j: usize| triangle[i.max(j)][i.min(j)].clone();
    Ok((0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect())
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let row = |row: &Vec<Number>| {
        let mut sum = vec![Number::whole(0); b.len()];
        for (x, line) in row.iter().zip(b).filter(|(x, _)| !x.is_zero() && !exhausted()) {
            for (sum, y) in sum.iter_mut().zip(line).filter(|(_, y)| !y.is_zero()) {
                *sum = sum.clone() + &(x.clone() * y);
            }
        }
        sum
    };
    a.iter().map(row).collect()
}

/// Whether x'mx >= 0 for every x (> 0 but for x = 0), by elimination.
fn definite(mut m: Matrix, strictly: bool) -> bool {
    for k in 0..m.len() {
        let pivot = m[k][k].clone();
        if exhausted() || pivot < Number::whole(0) || (strictly && pivot.is_zero()) {
            return false;
        }
        let column: Vec<Number> = m.iter().map(|row| row[k].clone()).collect();
        for (i, row) in m.iter_mut().enumerate().skip(k + 1) {
            if row[k].is_zero() {
                continue;
            }
            // An entry beside a zero on the diagonal: a form of both signs.
            let Some(factor) = row[k].clone().over(&pivot) else { return false };
            for (x, y) in row[k + 1..=i].iter_mut().zip(&column[k + 1..]) {
                *x = x.clone() - &(factor.clone() * y);
            }
        }
    }
    true
}

/// a'pa.
fn moved(a: &Matrix, p: &Matrix) -> Matrix {
    let column = |k: usize| a.iter().map(|row| row[k].clone()).collect();
    let transposed: Matrix = (0..a.first().map_or(0, Vec::len)).map(column).collect();
    product(&product(&transposed, p), a)
}

/// `quadratic`: readouts y with L(step(x)) = A L(x) for every mode, and y'Py. If P > 0 and rate^2 P - A'PA >= 0 then y'Py
/// falls by rate^2 in every step. If A'PA - P >= 0 it never falls, and if y'Py > 0 at a start y does not tend to 0 from there.
pub fn quadratic(c: &Quadratic) -> Result<(String, usize)> {
    let system = System::read(&c.system)?;
    let size = c.readouts.len();
    if !(1..=MAX_READOUTS).contains(&size) {
        return fault(QUADRATIC, format!("{size} readouts: expected 1 to {MAX_READOUTS}"));
    }
    if c.maps.0.len() != system.modes.len() || c.matrix.is_some() != c.matrices.0.is_empty() {
        return fault(QUADRATIC, "a map for each mode is expected, and `matrix` or `matrices`");
    }
    let form = |mode: &str| match c.matrix.as_ref().or_else(|| c.matrices.0.get(mode)) {
        Some(triangle) => symmetric(triangle, size),
        None => fault(QUADRATIC, format!("no matrix of mode `{mode:.40}`")),
    };
    let forms = system.modes.keys().map(|m| form(m)).collect::<Result<Vec<_>>>()?;
    let targets = if c.matrix.is_some() { &forms[..1] } else { &forms[..] };
    let readouts: Vec<Poly> = c
        .readouts
        .iter()
        .map(|t| affine(t, &system.state, &system.state))
        .collect::<Result<_>>()?;
    // The readouts at the start, as a column, if growth is meant.
    let start: Option<Matrix> = match (&c.rate, &c.start) {
        (Some(rate), None) if (Number::whole(0)..Number::whole(1)).contains(rate) => None,
        (None, Some(start)) if start.len() == c.system.state.len() => {
            let at: BTreeMap<&str, &Number> =
                c.system.state.iter().map(|n| &**n).zip(start).collect();
            let value = |v: &str| at.get(v).map(|n| Poly::constant((*n).clone()));
            Some(readouts.iter().map(|f| vec![f.with(&value).coefficient(&[])]).collect())
        }
        _ => {
            return fault(
                QUADRATIC,
                "`rate` in [0, 1), or `start` with a number a variable, is expected",
            );
        }
    };
    let names: Vec<String> = (0..size).map(|j| format!("y{j}")).collect();
    let coordinates = reals(names.iter())?;
    let rows = reals(names.iter().chain(c.system.parameters.0.keys()))?;
    let meaning: BTreeMap<&str, &Poly> = names.iter().map(|n| &**n).zip(&readouts).collect();
    let mut proved = 0;
    for (mode, form) in system.modes.keys().zip(&forms) {
        let bad = |why: String| fault(QUADRATIC, format!("mode `{mode:.40}`: {why}"));
        let made = system.rows(mode)?;
        let written = c.maps.0.get(*mode).map_or(&[][..], Vec::as_slice);
        let map =
            written.iter().map(|t| affine(t, &rows, &coordinates)).collect::<Result<Vec<_>>>()?;
        if map.len() != size {
            return bad(format!("{} rows of the map: expected {size}", map.len()));
        }
        for (j, (row, readout)) in map.iter().zip(&readouts).enumerate() {
            let linear = row.terms().all(|(m, _)| m.iter().any(|a| coordinates.knows(a)));
            if !linear
                || row.with(&|v| meaning.get(v).copied().cloned())
                    != readout.with(&|v| made.get(v).cloned())
            {
                return bad(format!("row {j} of the map is not what a step makes of the readout"));
            }
        }
        match &start {
            None if !definite(form.clone(), true) => {
                return bad("the matrix is not positive definite".into());
            }
            Some(y) if !moved(y, form)[0][0].is_positive() => {
                return bad("the form is not above 0 at the start".into());
            }
            _ => {}
        }
        let vertices = system.vertices(&map)?;
        if start.is_some() && vertices.len() > 1 {
            return bad("growth is shown for one value of each parameter".into());
        }
        for (vertex, map) in vertices.iter().enumerate() {
            let entry =
                |row: &Poly, name: &String| row.coefficient(&[Atom::Var(name.as_str().into())]);
            let a: Matrix =
                map.iter().map(|row| names.iter().map(|n| entry(row, n)).collect()).collect();
            for target in targets {
                let mut left = moved(&a, target);
                for (left, form) in left.iter_mut().flatten().zip(form.iter().flatten()) {
                    *left = match &c.rate {
                        Some(rate) => rate.clone() * rate * form - left,
                        None => left.clone() - form,
                    };
                }
                if !definite(left, false) {
                    let way =
                        if start.is_some() { "may fall" } else { "does not fall by the rate" };
                    return bad(format!("vertex {vertex}: the form {way}"));
                }
                proved += 1;
            }
        }
    }
    let limits: Vec<String> = readouts.iter().map(ToString::to_string).collect();
    let modes = if system.modes.len() > 1 { ", whatever mode acts in each step" } else { "" };
    let said = match (&c.rate, &c.start) {
        (None, Some(start)) => {
            let start: Vec<String> = start.iter().map(ToString::to_string).collect();
            format!("from {}{modes}: these do not all tend to 0", start.join(", "))
        }
        (rate, _) => {
            let rate = rate.clone().unwrap_or_else(|| Number::whole(0));
            let falls = format!("the root of a form of theirs falls by {rate} in each");
            format!("from every start{modes}: these tend to 0 ({falls})")
        }
    };
    Ok((format!("{}\n  proved {said}: {}", system.words(), limits.join(", ")), proved))
}
