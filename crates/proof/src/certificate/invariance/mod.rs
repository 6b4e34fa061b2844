//! What holds along the runs of a system, as a theorem: literals at nodes, and why those of one node follow
//! from those of the node before.
//!
//! At the first steps a node is shown literal by literal (`facts`). All literals of a later node are one clause, shown from that
//! of the node before (`carry`); where nodes recur, the first of them by induction. What is claimed are instances (`claims`).

mod carry;
mod claims;
mod facts;
mod walk;

use std::collections::BTreeMap;
use std::ops::Range;

use num_traits::One;
use serde_json::{Map, Value, json};

use super::linear::{Invariance, LinearSystem, NodeClaim};
use super::runs::{Literal, Runs, Time};
use super::theorem::{Sheet, clause, induction, positivity};
use super::weights::{Factor, Sum};
use carry::{Carry, Read, Weights};
use cordon_core::Rational;
use cordon_core::linear::feasible::Sign;
use walk::{How, Walk};

/// A certificate in the making.
struct Writer<'i> {
    sheet: Sheet,
    system: &'i LinearSystem,
    claims: &'i [NodeClaim],
    runs: Runs,
    walk: Walk<'i>,
    nodes: BTreeMap<&'i str, Vec<Literal>>,
    /// Names of variables: a literal's weight begins with the first, then the number that is added, the step (or the period), and
    /// an earlier one.
    weight: String,
    added: String,
    step: String,
    earlier: String,
    /// The least value that literals > 0 are assumed to have at the start.
    margin: String,
    /// Of the places whose literals are facts: literals > 0 are at least so much, times the margin if there is one.
    shares: Vec<Rational>,
}

/// Most literals of a node of which claims are instances; larger ones are divided into groups first.
const GROUP: usize = 32;

/// What is known of a node when something is proved from it.
struct Known {
    lemma: String,
    /// A term for the variable of the lemma's time, if there is one, and why that is in its range.
    time: Option<(String, String)>,
    /// The lemma is the hypothesis of an induction.
    earlier: bool,
}

/// The certificate of an invariance. `None` where it is not in a form that is written: nodes that are not in one row, modes that act
/// neither freely nor in turns, multipliers that do not fit, or a literal > 0 that gets no share of one.
pub fn certificate(invariance: &Invariance) -> Option<Value> {
    let walk = Walk::through(invariance)?;
    let mut sheet = Sheet::default();
    let mut runs = Runs::declare(&mut sheet, &invariance.system, walk.turns.clone())?;
    let mut nodes = BTreeMap::new();
    for (name, literals) in &invariance.nodes {
        let read = |text: &String| runs.literal(&invariance.system, text);
        nodes.insert(name.as_str(), literals.iter().map(read).collect::<Option<Vec<_>>>()?);
    }
    let [margin, weight, added, earlier] =
        ["margin", "l", "c", "t"].map(|wanted| runs.names.stem(wanted));
    let (system, step) = (&invariance.system, runs.step.clone());
    let mut writer = Writer {
        sheet,
        system,
        claims: &invariance.claims,
        runs,
        walk,
        nodes,
        weight,
        added,
        step,
        earlier,
        margin,
        shares: vec![Rational::one()],
    };
    writer.assume_start();
    writer.begin()?;
    writer.prove_places()?;
    writer.conclude()?;
    Some(writer.sheet.certificate())
}

impl<'i> Writer<'i> {
    fn node(&self, place: usize) -> &[Literal] {
        self.walk.places.get(place).and_then(|p| self.nodes.get(p.node)).map_or(&[], Vec::as_slice)
    }

    /// How many steps the recurring nodes take, and the first of them.
    fn period(&self) -> Option<(usize, usize)> {
        let (first, _) = self.walk.back.as_ref()?;
        let last = self.walk.places.last()?;
        Some((*first, last.step + 1 - self.walk.places.get(*first)?.step))
    }

    /// When a place is: at a step, or whenever it recurs.
    fn time(&self, place: usize) -> Time {
        let step = self.walk.places.get(place).map_or(0, |p| p.step);
        match self.period() {
            Some((first, 1)) if place >= first => {
                let variable = Some((self.step.clone(), step));
                Time { variable, stride: 1, offset: 0 }
            }
            Some((first, period)) if place >= first => {
                Time { variable: Some((self.step.clone(), 0)), stride: period, offset: step }
            }
            _ => Time::step(step),
        }
    }

    fn lemma(place: usize) -> String {
        format!("all{place}")
    }

    fn assume_start(&mut self) {
        let at = Time::step(0);
        let start = self.node(0).to_vec();
        if self.has_margin() {
            let margin = self.margin.clone();
            self.sheet.constant(&margin, "real");
            self.sheet.assume(clause("margin.low", "", &[], &format!("{margin} > 0")));
            self.sheet.assume(clause("margin.high", "", &[], &format!("{margin} <= 1")));
        }
        for (j, literal) in start.iter().enumerate() {
            let goal = match literal.sign {
                Sign::Positive => {
                    format!("{} >= {}", self.runs.text(&literal.poly(), &at), self.margin)
                }
                _ => literal.text(&self.runs, &at),
            };
            self.sheet.assume(clause(&format!("start.{j}"), "", &[], &goal));
        }
    }

    fn has_margin(&self) -> bool {
        self.node(0).iter().any(|l| l.sign == Sign::Positive)
    }

    fn weight(&self, j: usize) -> String {
        format!("{}{j}", self.weight)
    }

    /// The clause that says these literals of a node.
    fn clause(&self, name: &str, node: &[Literal], group: Range<usize>, at: &Time) -> Value {
        let added = &self.added;
        let (mut vars, mut given) = (Vec::new(), Vec::new());
        let (mut goal, mut positive) = (String::new(), added.clone());
        if let Some((variable, least)) = &at.variable {
            vars.push(variable.clone());
            given.push(format!("{variable}: {variable} >= {least}"));
        }
        for (j, literal) in node.iter().enumerate().take(group.end).skip(group.start) {
            let l = self.weight(j);
            vars.push(format!("{l}:real"));
            if literal.sign != Sign::Zero {
                given.push(format!("{l}: {l} >= 0"));
            }
            if literal.sign == Sign::Positive {
                positive += &format!(" + {l}");
            }
            goal += &format!("{l}*({}) + ", self.runs.text(&literal.poly(), at));
        }
        vars.push(format!("{added}:real"));
        given.push(format!("{added}: {added} >= 0"));
        given.push(format!("positive: {positive} > 0"));
        let given: Vec<&str> = given.iter().map(String::as_str).collect();
        clause(name, &vars.join(" "), &given, &format!("{goal}{added} > 0"))
    }

    /// The weights of the node whose clause is proved.
    fn goal_weights(&self, node: &[Literal]) -> Weights {
        let of = |(j, literal): (usize, &Literal)| {
            let l = self.weight(j);
            let fact = (literal.sign != Sign::Zero).then(|| format!("[{l}]"));
            Sum::factor(Factor { value: l, fact })
        };
        Weights {
            of: node.iter().enumerate().map(of).collect(),
            constant: Sum::factor(Factor::new(&self.added, format!("[{}]", self.added))),
            positive: Sum::factor(Factor::new("", "[positive]")),
        }
    }

    /// The clause of a node with these weights, as the fact `name`.
    fn instance(
        &self,
        name: &str,
        known: &Known,
        node: &[Literal],
        weights: &Weights,
    ) -> Option<Value> {
        let (mut with, mut given) = (Map::new(), Map::new());
        if let Some((term, bound)) = &known.time {
            given.insert(self.step.clone(), json!(bound));
            if known.earlier {
                given.insert(self.earlier.clone(), json!("0"));
            }
            let variable = if known.earlier { &self.earlier } else { &self.step };
            with.insert(variable.clone(), json!(term));
        }
        // What is not named is 0.
        for (j, (literal, weight)) in
            node.iter().zip(&weights.of).enumerate().filter(|(_, (_, w))| !w.is_zero())
        {
            with.insert(self.weight(j), json!(weight.value()));
            if literal.sign != Sign::Zero {
                given.insert(self.weight(j), json!(weight.facts()?));
            }
        }
        with.insert(self.added.clone(), json!(weights.constant.value()));
        given.insert(self.added.clone(), json!(weights.constant.facts()?));
        given.insert("positive".into(), json!(weights.positive.facts()?));
        Some(json!({ "name": name, "lemma": known.lemma, "with": with, "given": given }))
    }

    /// The clause of a place's node from that of the place before.
    fn shown_from_before(&self, place: usize, at: &Time, known: &Known) -> Option<Value> {
        let node = self.node(place);
        let after = self.goal_weights(node);
        let how = &self.walk.places.get(place)?.how;
        if place + 1 == self.shares.len() {
            return self.by_all_facts(place);
        }
        let before = self.node(place.checked_sub(1)?);
        let mut read = Read::default();
        let carry = Carry { runs: &self.runs, from: before, to: node, at, tag: "" };
        let weights = carry.back(how, &after, &mut read)?;
        self.by(known, before, &weights, read)
    }

    fn by(
        &self,
        known: &Known,
        before: &[Literal],
        weights: &Weights,
        read: Read,
    ) -> Option<Value> {
        let mut instances: Vec<Value> = read.instances.into_values().collect();
        instances.push(self.instance("before", known, before, weights)?);
        Some(positivity(&instances, &format!("[before]{}", read.zero)))
    }

    /// A lemma for each place from the last with facts on, if a run goes on from there.
    fn prove_places(&mut self) -> Option<()> {
        let opening = self.shares.len() - 1;
        if self.walk.back.is_none() && opening + 1 == self.walk.places.len() {
            return Some(());
        }
        let first = self.period().map(|(first, _)| first);
        for place in opening..self.walk.places.len() {
            let before = place.checked_sub(1);
            let at = self.time(place);
            let recurs = before.is_some() && first.is_some_and(|first| place > first);
            let known = Known {
                lemma: Self::lemma(before.unwrap_or_default()),
                time: recurs.then(|| (self.step.clone(), format!("[{}]", self.step))),
                earlier: false,
            };
            let earlier = before.map_or_else(|| Time::step(0), |b| self.time(b));
            let proof = match first == Some(place) {
                false => self.shown_from_before(place, &earlier, &known)?,
                true => {
                    let base = self.shown_from_before(place, &earlier, &known)?;
                    let step = self.around(place)?;
                    induction(&self.step, &self.step, &self.earlier, base, step)
                }
            };
            let node = self.node(place).to_vec();
            let clause = self.clause(&Self::lemma(place), &node, 0..node.len(), &at);
            self.sheet.lemma(clause, proof);
            self.divide(place, &node, &at)?;
        }
        Some(())
    }

    /// The group of a literal of a node, and its size, where there are groups.
    fn group(node: &[Literal], j: usize) -> Option<(usize, usize)> {
        let size = node.len().isqrt() + 1;
        (node.len() > GROUP).then_some((j / size, size))
    }

    /// Lemmas about fewer literals of a node: a claim reads few, and all of a clause is looked at.
    fn divide(&mut self, place: usize, node: &[Literal], at: &Time) -> Option<()> {
        let all = self.goal_weights(node);
        let mut start = 0;
        while let Some((group, size)) =
            Self::group(node, start).filter(|_| start < node.len() && self.claimed(place))
        {
            let range = start..node.len().min(start + size);
            let inside = |(j, w): (usize, &Sum)| {
                if range.contains(&j) { w.clone() } else { Sum::default() }
            };
            let of = all.of.iter().enumerate().map(inside).collect();
            let weights = Weights { of, ..all.clone() };
            let known = Known {
                lemma: Self::lemma(place),
                time: at.variable.as_ref().map(|(k, _)| (k.clone(), format!("[{k}]"))),
                earlier: false,
            };
            let instance = self.instance("all", &known, node, &weights)?;
            let name = format!("{}.{group}", known.lemma);
            let clause = self.clause(&name, node, range.clone(), at);
            self.sheet.lemma(clause, positivity(&[instance], "[all]"));
            start = range.end;
        }
        Some(())
    }

    /// Whether something is claimed at a place.
    fn claimed(&self, place: usize) -> bool {
        let node = self.walk.places.get(place).map(|p| p.node);
        self.claims.iter().any(|claim| Some(claim.at.as_str()) == node)
    }

    /// The clause of the first recurring node a period later, from the hypothesis.
    fn around(&self, first: usize) -> Option<Value> {
        let (_, back) = self.walk.back.as_ref()?;
        let last = self.walk.places.len() - 1;
        let mut weights = self.goal_weights(self.node(first));
        let mut read = Read::default();
        for place in (first..=last).rev() {
            let (to, how) = match place == last {
                true => (first, How::Step(back.clone())),
                false => (place + 1, self.walk.places.get(place + 1)?.how.clone()),
            };
            let tag = if last == first { String::new() } else { format!(".{}", place - first) };
            let at = self.time(place);
            let (from, to) = (self.node(place), self.node(to));
            let carry = Carry { runs: &self.runs, from, to, at: &at, tag: &tag };
            weights = carry.back(&how, &weights, &mut read)?;
        }
        let known = Known {
            lemma: "IH".into(),
            time: Some((self.step.clone(), format!("[{}]", self.step))),
            earlier: true,
        };
        self.by(&known, self.node(first), &weights, read)
    }
}
