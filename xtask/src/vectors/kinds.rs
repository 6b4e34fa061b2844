//! The kinds of vectors: what each evaluates, with arguments in the order of the mirrors' definitions
//! of the same name.

use cordon_spec::activation::exec_coverage_active;
use cordon_spec::consensus::exec_consensus;
use cordon_spec::coverage::kth_step;
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::formation::exec_formation;
use cordon_spec::graph::{Edges, Path};
use cordon_spec::local::{
    LocalParams, LocalState, SimState, TickRatio, fmu_kth_step, project, swarm_tick,
};
use cordon_spec::placement::{
    contraction_weight, gap, gaps, scaled_energy, scaled_error, scaled_target, sum,
};
use cordon_spec::theorems::{
    Form, Setting, StartSet, Theorem, Truth, Verdict, WeightRange, above_targets, in_box,
    telescoping_residual,
};
use cordon_spec::{DroneMap, Params, Phase, Scalar, State};

use super::Value::{Count, Edges as Links, Flags, Number, Numbers};
use super::{Value, Vector};
use cordon_core::Rational;

type Positions = Vec<Rational>;

fn of(kind: &'static str, name: &str, arguments: Vec<(&'static str, Value)>) -> Vector {
    Vector { kind, name: name.to_owned(), arguments, expected: Vec::new() }
}

fn protocol(p: &Params<Rational>) -> Vec<(&'static str, Value)> {
    let number = |x: &Rational| Number(x.clone());
    vec![("min", number(&p.min)), ("max", number(&p.max)), ("eps", number(&p.eps))]
}

/// `kth_step`: k ticks of the whole swarm.
pub(super) fn coverage(
    name: &str,
    p: &Params<Rational>,
    phase: Phase,
    start: Positions,
    k: u64,
) -> Vector {
    let mut arguments = protocol(p);
    arguments.extend([
        ("n", Count(p.n.into())),
        ("phase", Value::Phase(phase)),
        ("start", Numbers(start.clone())),
        ("k", Count(k)),
    ]);
    let expected = kth_step(p, State::initial(start, p.n, phase), k).drones;
    Vector { expected, ..of("coverage", name, arguments) }
}

/// `swarm_tick`, k times: local machines that exchange positions. The counter limit of the protocol
/// follows from the quotient eps/stepsize.
pub(super) fn local(
    name: &str,
    p: &Params<Rational>,
    ratio: TickRatio,
    phase: Phase,
    start: Positions,
    k: u64,
) -> Vector {
    let mut arguments = protocol(p);
    arguments.extend([
        ("num", Count(ratio.num.into())),
        ("den", Count(ratio.den.get().into())),
        ("phase", Value::Phase(phase)),
        ("start", Numbers(start.clone())),
        ("k", Count(k)),
    ]);
    let protocol = Params { n: ratio.counter_limit(), ..p.clone() };
    let local = LocalParams { protocol, count: start.len(), ratio };
    let global = State::initial(start, local.protocol.n, phase);
    let machines: Vec<_> = (0..local.count).map(|i| project(&local.protocol, &global, i)).collect();
    let after = (0..k).fold(machines, |m, _| swarm_tick(&local, &m));
    let expected = after.into_iter().map(|m| m.st.own).collect();
    Vector { expected, ..of("local", name, arguments) }
}

/// `fmu_kth_step`: k ticks of one machine with an integer period, number `id` of `drones`, that hears
/// nothing new; then its state.
pub(super) fn alone(
    name: &str,
    p: &Params<Rational>,
    drones: usize,
    [prec, own, foll]: [Rational; 3],
    id: usize,
    k: u64,
) -> Vector {
    let number = |x: &Rational| Number(x.clone());
    let mut arguments = protocol(p);
    arguments.extend([
        ("n", Count(p.n.into())),
        ("drones", Count(drones as u64)),
        ("prec", number(&prec)),
        ("own", number(&own)),
        ("foll", number(&foll)),
        ("id", Count(id as u64)),
        ("k", Count(k)),
    ]);
    let local = LocalParams { protocol: p.clone(), count: drones, ratio: TickRatio::whole(p.n) };
    let start = SimState { timesteps: 0, st: LocalState { prec, own, foll, id } };
    let after = fmu_kth_step(&local, start, k).st;
    Vector { expected: vec![after.prec, after.own, after.foll], ..of("alone", name, arguments) }
}

/// `exec_consensus` on the path, k times.
pub(super) fn consensus(name: &str, eps: &Rational, start: Positions, k: u64) -> Vector {
    let arguments =
        vec![("eps", Number(eps.clone())), ("start", Numbers(start.clone())), ("k", Count(k))];
    let path = Path { count: start.count() };
    let expected = (0..k).fold(start, |x, _| exec_consensus(eps, &path, &x));
    Vector { expected, ..of("consensus", name, arguments) }
}

/// `exec_consensus` on a graph given by its edges, k times.
pub(super) fn meeting(
    name: &str,
    eps: &Rational,
    edges: &[(usize, usize)],
    start: Positions,
    k: u64,
) -> Vector {
    let arguments = vec![
        ("eps", Number(eps.clone())),
        ("edges", Links(edges.to_vec())),
        ("start", Numbers(start.clone())),
        ("k", Count(k)),
    ];
    let graph = Edges { count: start.count(), edges };
    let expected = (0..k).fold(start, |x, _| exec_consensus(eps, &graph, &x));
    Vector { expected, ..of("meeting", name, arguments) }
}

/// `exec_formation` on a graph given by its edges.
pub(super) fn formation(
    name: &str,
    eps: &Rational,
    edges: &[(usize, usize)],
    start: Positions,
    input: Positions,
) -> Vector {
    let arguments = vec![
        ("eps", Number(eps.clone())),
        ("edges", Links(edges.to_vec())),
        ("start", Numbers(start.clone())),
        ("input", Numbers(input.clone())),
    ];
    let graph = Edges { count: start.count(), edges };
    let expected = exec_formation(eps, &graph, &start, &input);
    Vector { expected, ..of("formation", name, arguments) }
}

/// `exec_coverage_active`: one step of the flagged drones.
pub(super) fn active(
    name: &str,
    p: &Params<Rational>,
    start: Positions,
    flags: Vec<bool>,
) -> Vector {
    let mut arguments = protocol(p);
    arguments.extend([("start", Numbers(start.clone())), ("flags", Flags(flags.clone()))]);
    let state = State { drones: start, timesteps: 0 };
    let moves = |i: usize| flags.get(i).copied().unwrap_or(false);
    let expected = exec_coverage_active(p, &state, moves).drones;
    Vector { expected, ..of("active", name, arguments) }
}

/// `exec_coverage_delayed`: one step in which drone i sees drone j at entry `i N + j`.
pub(super) fn delayed(
    name: &str,
    p: &Params<Rational>,
    start: Positions,
    seen: Positions,
) -> Vector {
    let mut arguments = protocol(p);
    arguments.extend([("start", Numbers(start.clone())), ("seen", Numbers(seen.clone()))]);
    let count = start.len();
    let state = State { drones: start, timesteps: 0 };
    let zero = Rational::from_int(0);
    let entry = |i: usize, j: usize| seen.get(i * count + j).unwrap_or(&zero);
    let expected = exec_coverage_delayed(p, &state, entry).drones;
    Vector { expected, ..of("delayed", name, arguments) }
}

/// Quantities of a placement: number of gaps, sum, energy, then gap, target, error and
/// contraction weight of every drone that has one.
pub(super) fn quantities(name: &str, p: &Params<Rational>, x: Positions) -> Vector {
    let arguments = vec![
        ("min", Number(p.min.clone())),
        ("max", Number(p.max.clone())),
        ("x", Numbers(x.clone())),
    ];
    let (min, max, count) = (&p.min, &p.max, x.len());
    let mut expected = vec![gaps(&x), sum(&x), scaled_energy(min, max, &x)];
    expected.extend((0..count - 1).map(|i| gap(&x, i)));
    expected.extend((0..count).map(|i| scaled_target(min, max, count, i)));
    expected.extend((0..count).map(|i| scaled_error(min, max, &x, i)));
    expected.extend((0..count).map(|i| Rational::from_index(contraction_weight(count, i))));
    Vector { expected, ..of("quantities", name, arguments) }
}

/// `telescoping_residual` between two placements.
pub(super) fn residual(name: &str, eps: &Rational, before: Positions, after: Positions) -> Vector {
    let arguments = vec![
        ("eps", Number(eps.clone())),
        ("before", Numbers(before.clone())),
        ("after", Numbers(after.clone())),
    ];
    let expected = vec![telescoping_residual(eps, &before, &after)];
    Vector { expected, ..of("residual", name, arguments) }
}

/// Predicates of a placement, 1 if true: the four start sets, at the targets, above the targets, in the
/// box.
pub(super) fn predicates(name: &str, p: &Params<Rational>, x: Positions) -> Vector {
    let arguments = vec![
        ("min", Number(p.min.clone())),
        ("max", Number(p.max.clone())),
        ("x", Numbers(x.clone())),
    ];
    let setting = Setting::from(p);
    let sets =
        [StartSet::Any, StartSet::Ordered, StartSet::FirstSubsegment, StartSet::UpperBounded];
    let mut answers: Vec<_> =
        sets.iter().map(|s| s.contains(&setting, &x) == Truth::True).collect();
    // 7.5 (ii) constrains a placement only where all drones are at their targets.
    let run = [x.clone(), x.clone()];
    let at_targets = Theorem::SumStationary.conclusion(Form::Sharp, &setting, &run);
    answers.push(at_targets == Verdict::Holds);
    answers.push(above_targets(&setting, &x) == Verdict::Holds);
    answers.push(in_box(&setting, &x) == Verdict::Holds);
    let expected = answers.into_iter().map(yes).collect();
    Vector { expected, ..of("predicates", name, arguments) }
}

/// Whether the weight `num/den` is positive and below the critical one of N drones: 1 if so.
pub(super) fn critical(name: &str, num: &Rational, den: &Rational, count: usize) -> Vector {
    let arguments = vec![
        ("num", Number(num.clone())),
        ("den", Number(den.clone())),
        ("drones", Count(count as u64)),
    ];
    let below = WeightRange::BelowCritical.contains(num, den, count) == Truth::True;
    Vector { expected: vec![yes(below)], ..of("critical", name, arguments) }
}

fn yes(answer: bool) -> Rational {
    Rational::from_int(answer.into())
}
