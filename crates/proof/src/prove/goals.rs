//! What has to be proved for each claim, derived from the spec on this side too; the checker
//! derives it again and believes nothing from here.

use cordon_spec::consensus::exec_consensus;
use cordon_spec::graph::Path;
use cordon_spec::placement::contraction_weight_at;
use cordon_spec::theorems::{Form, StartSet, Theorem, WeightRange};

use super::claims::{Claim, Kind};
use super::symbols::Sign::{self, NonNegative, Positive, Zero};
use super::symbols::{Fact, Goal, cell, constant, fact, int, named, substitute};
use super::window::{Part, Property, Step, Window, error};
use cordon_core::Rational;
use cordon_core::scalar::Polynomial;

const ORDERED: Property =
    Property { label: "gap", sign: Positive, width: 2, poly: |_, x| x[1].clone() - &x[0] };
const UPPER_BOUND: Property =
    Property { label: "error", sign: NonNegative, width: 1, poly: |i, x| error(i, &x[0]) };
const LOWER_BOUND: Property = Property {
    label: "-error",
    sign: NonNegative,
    width: 1,
    poly: |i, x| int(0) - &error(i, &x[0]),
};
const AT_TARGET: Property = Property { sign: Zero, ..UPPER_BOUND };
const ABOVE_MIN: Property = Property {
    label: "x-min",
    sign: NonNegative,
    width: 1,
    poly: |_, x| x[0].clone() - &named("min"),
};
const BELOW_MAX: Property =
    Property { label: "max-x", sign: NonNegative, width: 1, poly: |_, x| named("max") - &x[0] };

/// What a claim is proved for.
#[derive(Clone, Debug)]
pub struct Scope {
    /// The form of the theorem.
    pub form: Form,
    /// An interval of weights in the place of the theorem's own range.
    pub weights: Option<(Rational, Rational)>,
    /// One N, or all of them.
    pub drones: Option<u32>,
}

/// A closed form that a claim needs: F with F(i+1) - F(i) = the summand.
#[derive(Clone, Debug)]
pub struct Primitive {
    /// Its name in the certificate.
    pub name: &'static str,
    /// F(i), in i, x[-1], x[0] and the parameters.
    pub poly: Polynomial,
}

/// Facts about weight and N, for one part of the case split over N.
struct Case {
    prefix: &'static str,
    three: bool,
    facts: Vec<Fact>,
}

fn goal(name: impl Into<String>, facts: Vec<Fact>, poly: Polynomial, sign: Sign) -> Goal {
    Goal { name: name.into(), facts, poly, sign }
}

/// Derives the goals of a claim from its primitives.
pub struct Deriver<'a> {
    /// The claim.
    pub claim: &'a Claim,
    /// What it is proved for.
    pub scope: &'a Scope,
    /// Its closed forms.
    pub primitives: &'a [Primitive],
}

impl Deriver<'_> {
    /// Every goal, in the checker's order.
    pub fn goals(&self) -> Vec<Goal> {
        match self.claim.kind {
            Kind::Invariant(which, step) => self.invariant(properties(which), step, true),
            Kind::Step(which, step) => self.invariant(properties(which), step, false),
            Kind::Flux => self.flux(),
            Kind::Consensus => self.consensus(),
            Kind::Projection => super::exchange::goals(),
            Kind::Theorem(theorem) => self.theorem(theorem),
        }
    }

    fn theorem(&self, theorem: Theorem) -> Vec<Goal> {
        let bounded = || self.invariant(&[UPPER_BOUND], Step::Plain, true);
        match theorem {
            Theorem::Ordering => self.invariant(&[ORDERED], Step::Plain, true),
            Theorem::UpperBound => bounded(),
            Theorem::SumBounded => [bounded(), self.sum_bounded()].concat(),
            Theorem::SumMaximal => [bounded(), self.sum_maximal()].concat(),
            Theorem::SumNonDecreasing => {
                let increment = self.increments("increment", NonNegative, NonNegative, NonNegative);
                [bounded(), self.flux(), vec![increment]].concat()
            }
            Theorem::SumStationary => {
                [self.flux(), vec![self.increments("increment", Zero, Zero, Zero)]].concat()
            }
            Theorem::TargetsFixed => {
                [self.invariant(&[AT_TARGET], Step::Plain, false), self.same_sum()].concat()
            }
            Theorem::ConstantSum => [bounded(), self.flux(), self.constant_sum()].concat(),
            Theorem::GloballyIncreasing => [bounded(), self.flux(), self.increasing()].concat(),
            Theorem::Limit => self.limit(),
        }
    }

    fn cases(&self) -> Vec<Case> {
        let range = self.claim.weights(self.scope.form);
        let case = |prefix, three, least: u32, sign| {
            let rest = named("last") - &int(least as i32);
            let mut facts = weight_facts(range, self.scope.weights.as_ref(), three);
            facts.push(fact("max-min", named("max") - &named("min"), Positive));
            facts.push(fact("last", named("last"), Positive));
            facts.push(fact(format!("last-{least}"), rest, sign));
            Case { prefix, three, facts }
        };
        match self.scope.drones {
            Some(n) => vec![case("", n == 3, n.saturating_sub(1), Zero)],
            None if range == WeightRange::UpToHalfOrOne && self.scope.weights.is_none() => {
                vec![case("N=3/", true, 2, Zero), case("N>=4/", false, 3, NonNegative)]
            }
            None => vec![case("", false, 2, NonNegative)],
        }
    }

    fn known(&self) -> Vec<Fact> {
        self.cases().pop().map(|c| c.facts).unwrap_or_default()
    }

    fn invariant(&self, properties: &[Property], step: Step, with_start: bool) -> Vec<Goal> {
        let (mut starts, mut steps) = (Vec::new(), Vec::new());
        for case in self.cases() {
            for property in properties {
                for part in Part::ALL {
                    if property.width == 2 && case.three && part == Part::Inner {
                        continue;
                    }
                    let path = format!("{}/{}", property.label, part.label());
                    let now = Window::new(part, property.width, Step::Plain);
                    let facts = [case.facts.clone(), now.index_facts(), self.start(part, &now)];
                    let name = format!("{}start/{path}", case.prefix);
                    starts.push(goal(name, facts.concat(), now.goal(property), property.sign));
                    let seen = Window::new(part, property.width, step);
                    let mut facts = [case.facts.clone(), seen.index_facts()].concat();
                    facts.extend(properties.iter().flat_map(|p| seen.facts(p)));
                    for (suffix, poly) in seen.goals_after(property, step) {
                        let name = format!("{}step/{path}{suffix}", case.prefix);
                        steps.push(goal(name, facts.clone(), poly, property.sign));
                    }
                }
            }
        }
        if with_start { [starts, steps].concat() } else { steps }
    }

    fn start(&self, part: Part, window: &Window) -> Vec<Fact> {
        match self.claim.starts(self.scope.form) {
            StartSet::Any => Vec::new(),
            StartSet::Ordered => window.facts(&ORDERED),
            StartSet::UpperBounded => window.facts(&UPPER_BOUND),
            StartSet::FirstSubsegment => {
                let mut facts = window.facts(&ORDERED);
                if part == Part::Inner {
                    let bound = named("last") * &named("min") + &(named("max") - &named("min"));
                    let poly = bound - &(named("last") * &cell("x", 0));
                    facts.push(fact("min+l-x[0]", poly, Positive));
                }
                facts
            }
        }
    }

    fn primitive(
        &self,
        name: &str,
        i: &Polynomial,
        before: &Polynomial,
        here: &Polynomial,
    ) -> Polynomial {
        let found = self.primitives.iter().find(|p| p.name == name);
        found.map_or_else(Polynomial::default, |p| {
            let values = [
                (named("i"), i.clone()),
                (cell("x", -1), before.clone()),
                (cell("x", 0), here.clone()),
            ];
            substitute(&p.poly, &values)
        })
    }

    /// F(N-1) - F(1): the increment of the sum.
    fn increment(&self) -> Polynomial {
        let last = self.primitive("flux", &named("last"), &named("x(N-2)"), &named("max"));
        last - &self.primitive("flux", &int(1), &named("min"), &named("x1"))
    }

    fn flux(&self) -> Vec<Goal> {
        let at = |o: i32| {
            self.primitive("flux", &(named("i") + &int(o)), &cell("x", o - 1), &cell("x", o))
        };
        let gaps = named("max") - &named("x(N-2)") - &(named("x1") - &named("min"));
        let total = self.increment() - &(named("eps") * &gaps);
        vec![
            goal("flux/inner", Vec::new(), moved() - &(at(1) - &at(0)), Zero),
            goal("flux/total", Vec::new(), total, Zero),
        ]
    }

    fn consensus(&self) -> Vec<Goal> {
        let at = |o: i32| {
            self.primitive("flux", &(named("i") + &int(o)), &cell("x", o - 1), &cell("x", o))
        };
        let [first, inner, last] = consensus_moves();
        vec![
            goal("flux/first", Vec::new(), first - &at(1), Zero),
            goal("flux/inner", Vec::new(), inner - &(at(1) - &at(0)), Zero),
            goal("flux/last", Vec::new(), last + &at(0), Zero),
        ]
    }

    fn increments(&self, name: &str, first: Sign, last: Sign, sign: Sign) -> Goal {
        goal(name, [self.known(), ends(first, last)].concat(), self.increment(), sign)
    }

    fn total(&self, c: &'static str, e: &'static str) -> (Goal, Fact) {
        let at = |i: &Polynomial| self.primitive("targets", i, &int(0), &int(0));
        let (i, one) = (named("i"), int(1));
        let step = at(&(i.clone() + &one)) - &at(&i);
        let all = at(&(named("last") + &one)) - &at(&int(0));
        let sum = named(e) + &(named("last") * &named(c)) - &all;
        (
            goal("targets", Vec::new(), error(&i, &int(0)) - &step, Zero),
            fact(format!("{e}-targets+last*{c}"), sum, Zero),
        )
    }

    fn sum_bounded(&self) -> Vec<Goal> {
        let (targets, sum) = self.total("c", "E");
        let facts = [self.known(), vec![sum, fact("E", named("E"), NonNegative)]].concat();
        vec![targets, goal("bound", facts, deficit(), NonNegative)]
    }

    fn sum_maximal(&self) -> Vec<Goal> {
        let (targets, sum) = self.total("c", "E");
        let with = |extra| [self.known(), vec![sum.clone(), extra]].concat();
        let reached = with(fact("E", named("E"), Zero));
        let met = with(fact("deficit", deficit(), Zero));
        vec![
            targets,
            goal("if", reached, deficit(), Zero),
            goal("only-if", met, int(0) - &named("E"), NonNegative),
        ]
    }

    fn same_sum(&self) -> Vec<Goal> {
        let ((targets, now), (_, later)) = (self.total("c", "E"), self.total("c'", "E'"));
        let zeros = vec![now, later, fact("E", named("E"), Zero), fact("E'", named("E'"), Zero)];
        let facts = [self.known(), zeros].concat();
        vec![targets, goal("sum", facts, named("c'") - &named("c"), Zero)]
    }

    /// Facts about an inner drone and its neighbours, and its error one step later.
    fn inner(&self, signs: [Sign; 3]) -> (Vec<Fact>, Polynomial) {
        let window = Window::new(Part::Inner, 1, Step::Plain);
        let mut facts = [self.known(), window.index_facts()].concat();
        for (o, sign) in (-1..=1).zip(signs) {
            let poly = error(&(named("i") + &int(o)), &cell("x", o));
            facts.push(fact(format!("error[{o}]"), poly, sign));
        }
        let after = window.goals_after(&UPPER_BOUND, Step::Plain);
        (facts, after.into_iter().map(|(_, poly)| poly).next().unwrap_or_default())
    }

    fn constant_sum(&self) -> Vec<Goal> {
        let mut goals = Vec::new();
        for (end, label) in ends(Zero, Zero).into_iter().zip(["first", "last"]) {
            let mut facts = [self.known(), ends(NonNegative, NonNegative)].concat();
            facts.push(fact("c'-c", self.increment(), Zero));
            goals.push(goal(format!("ends/{label}"), facts, int(0) - &end.poly, NonNegative));
        }
        for (o, label) in [(1, "right"), (-1, "left")] {
            let (mut facts, after) = self.inner([NonNegative; 3]);
            facts.push(fact("error'[0]", after, Zero));
            let neighbour = error(&(named("i") + &int(o)), &cell("x", o));
            goals.push(goal(format!("pull/{label}"), facts, int(0) - &neighbour, NonNegative));
        }
        let beyond = |depth: Polynomial| depth - &named("H") - &int(1);
        let enough = int(2) * &named("H") - &named("last") + &int(1);
        let facts = vec![
            fact("2H-last+1", enough, NonNegative),
            fact("j-H-1", beyond(named("j")), NonNegative),
            fact("last-j-H-1", beyond(named("last") - &named("j")), NonNegative),
        ];
        goals.push(goal("depth", facts, int(-1), NonNegative));
        goals
    }

    fn increasing(&self) -> Vec<Goal> {
        let (facts, after) = self.inner([Zero; 3]);
        let mut goals = vec![goal("retreat", facts, after, Zero)];
        let from = [
            ("right", [NonNegative, NonNegative, Positive]),
            ("left", [Positive, NonNegative, NonNegative]),
        ];
        for (label, signs) in from {
            let (facts, after) = self.inner(signs);
            goals.push(goal(format!("advance/{label}"), facts, after, Positive));
        }
        goals.push(self.increments("constant", Zero, Zero, Zero));
        goals.push(self.increments("increase/first", Positive, NonNegative, Positive));
        goals.push(self.increments("increase/last", NonNegative, Positive, Positive));
        goals
    }

    fn limit(&self) -> Vec<Goal> {
        let window = Window::new(Part::Inner, 1, Step::Plain);
        let known = [self.known(), window.index_facts()].concat();
        let (_, after) = self.inner([NonNegative; 3]);
        let index = |o: i32| named("i") + &int(o);
        let weight = |o| contraction_weight_at(&named("last"), &index(o));
        let mut facts = known.clone();
        facts.push(fact("M", named("M"), NonNegative));
        for o in -1..=1 {
            let (bound, e) = (named("M") * &weight(o), error(&index(o), &cell("x", o)));
            facts.push(fact(format!("M*w-error[{o}]"), bound.clone() - &e, NonNegative));
            facts.push(fact(format!("M*w+error[{o}]"), bound + &e, NonNegative));
        }
        let square = named("last") * &named("last");
        let kept = square.clone() - &(int(8) * &named("eps"));
        let bound = kept.clone() * &(named("M") * &weight(0));
        let moved = square.clone() * &after;
        vec![
            goal("weight", known.clone(), weight(0), Positive),
            goal("step/upper", facts.clone(), bound.clone() - &moved, NonNegative),
            goal("step/lower", facts, bound + &moved, NonNegative),
            goal("rate/below-one", known.clone(), square - &kept, Positive),
            goal("rate/nonnegative", known, kept, NonNegative),
        ]
    }
}

/// How far an inner drone moves in a step.
pub fn moved() -> Polynomial {
    let after = Window::new(Part::Inner, 1, Step::Plain).after(Step::Plain);
    let next = after.into_iter().flat_map(|(_, cells)| cells).next();
    next.unwrap_or_default() - &cell("x", 0)
}

/// How far the first, an inner and the last drone of a path move in a consensus step.
pub fn consensus_moves() -> [Polynomial; 3] {
    [(0..=2, 0), (-2..=2, 2), (-2..=0, 2)].map(|(offsets, i)| {
        let drones: Vec<Polynomial> = offsets.map(|o| cell("x", o)).collect();
        let next = exec_consensus(&named("eps"), &Path { count: drones.len() }, &drones);
        next[i].clone() - &cell("x", 0)
    })
}

/// The properties behind a name.
fn properties(which: &str) -> &'static [Property] {
    match which {
        "ordered" => &[ORDERED],
        "upper" => &[UPPER_BOUND],
        "lower" => &[LOWER_BOUND],
        _ => &[ABOVE_MIN, BELOW_MAX],
    }
}

fn deficit() -> Polynomial {
    let count = named("last") + &int(1);
    count * &(named("min") + &named("max")) - &(int(2) * &named("c"))
}

fn ends(first: Sign, last: Sign) -> Vec<Fact> {
    vec![
        fact("error(1)", error(&int(1), &named("x1")), first),
        fact("error(N-2)", error(&(named("last") - &int(1)), &named("x(N-2)")), last),
    ]
}

fn weight_facts(
    range: WeightRange,
    interval: Option<&(Rational, Rational)>,
    three: bool,
) -> Vec<Fact> {
    let eps = |sign| fact("eps", named("eps"), sign);
    let below = |n: i32, sign| {
        let label = if n == 1 { "1-eps".to_owned() } else { format!("1-{n}eps") };
        fact(label, int(1) - &(int(n) * &named("eps")), sign)
    };
    if let Some((from, to)) = interval {
        let mut facts = vec![
            fact("eps-from", named("eps") - &constant(from), NonNegative),
            fact("to-eps", constant(to) - &named("eps"), NonNegative),
        ];
        if num_traits::Signed::is_positive(from) {
            facts.push(eps(Positive));
        }
        return facts;
    }
    match range {
        WeightRange::Any | WeightRange::BelowCritical => Vec::new(),
        WeightRange::Unit => vec![eps(NonNegative), below(1, NonNegative)],
        WeightRange::UpToHalfOrOne if three => vec![eps(NonNegative), below(1, NonNegative)],
        WeightRange::BelowThird => vec![eps(NonNegative), below(3, Positive)],
        WeightRange::BelowHalf => vec![eps(NonNegative), below(2, Positive)],
        WeightRange::UpToHalf | WeightRange::UpToHalfOrOne => {
            vec![eps(NonNegative), below(2, NonNegative)]
        }
        WeightRange::PositiveUpToHalf => vec![eps(Positive), below(2, NonNegative)],
    }
}
