//! From one node to the next: all literals of a node at once, as one clause.
//!
//! That all of g_0, g_1, .. are >= 0 and some of them > 0 is one statement with a weight for each:
//!
//! ```text
//! for all l_j >= 0 and c >= 0, if c + (sum of l_j, g_j > 0) > 0 then (sum of l_j g_j) + c > 0
//! ```
//!
//! (the weights of equations are any numbers). By Farkas' lemma a step makes of such a sum another one of
//! the node before, with weights that are linear in the l_j and c.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::{One, Signed, Zero};
use serde_json::Value;

use super::super::linear::{Edge, Multipliers};
use super::super::runs::{Literal, Runs, Time, symbol};
use super::super::weights::{Factor, Range, Sum, spread};
use super::walk::How;
use cordon_core::Rational;
use cordon_core::exact;
use cordon_core::linear::feasible::Sign;

/// The weights of a node's literals, in terms of those of a node after it.
#[derive(Clone, Debug)]
pub struct Weights {
    /// Of each literal.
    pub of: Vec<Sum>,
    /// The number that is added, c.
    pub constant: Sum,
    /// c plus the weights of the literals > 0.
    pub positive: Sum,
}

/// What a proof reads beside the hypothesis.
#[derive(Clone, Debug, Default)]
pub struct Read {
    /// Instances of assumptions, by their names as facts.
    pub instances: BTreeMap<String, Value>,
    /// Products with a factor that is 0, each with a sign before it.
    pub zero: String,
}

/// What makes of a node's literals one of the next node: with this share, a mode or no change.
struct Way {
    share: Sum,
    /// The share is 0.
    nothing: bool,
    /// The parameters that play a part.
    ranges: Vec<usize>,
    /// At each vertex of their ranges the multipliers, and the constant that is left.
    rows: Vec<(BTreeMap<usize, Rational>, Rational)>,
}

/// Multipliers as numbers, and what they leave of a constant.
pub fn row(
    multipliers: &Multipliers,
    constant: Rational,
    from: &[Literal],
) -> Option<(BTreeMap<usize, Rational>, Rational)> {
    let mut numbers = BTreeMap::new();
    let mut left = constant;
    for (i, text) in multipliers {
        let number = exact::parse("multiplier", text).ok()?;
        left -= &number * &from.get(*i)?.constant;
        numbers.insert(*i, number);
    }
    Some((numbers, left))
}

/// A step, or none, from the literals of one node to those of the next.
pub struct Carry<'c> {
    /// The system.
    pub runs: &'c Runs,
    /// The node before.
    pub from: &'c [Literal],
    /// The node after.
    pub to: &'c [Literal],
    /// When the step is made.
    pub at: &'c Time,
    /// What the names of facts about it end in.
    pub tag: &'c str,
}

impl Carry<'_> {
    /// The weights of the node before in terms of those of the node after; what the proof of that reads is
    /// added. `None` where the multipliers do not fit, or a literal > 0 gets no share of one.
    pub fn back(&self, how: &How<'_>, after: &Weights, read: &mut Read) -> Option<Weights> {
        let ways = (0..self.to.len())
            .map(|j| match how {
                How::Start => None,
                How::Here(edge) => Some(vec![self.still(edge, j)?]),
                How::Step(edges) => self.moved(edges, j),
            })
            .collect::<Option<Vec<_>>>()?;
        let shares = |way: &Way| -> Vec<Rational> {
            let strict = |i: &usize| self.from[*i].sign == Sign::Positive;
            let of = |(m, left): &(BTreeMap<usize, Rational>, Rational)| {
                left + m.iter().filter(|(i, _)| strict(i)).map(|(_, m)| m).sum::<Rational>()
            };
            way.rows.iter().map(of).collect()
        };
        let strict = |j: &usize| self.to[*j].sign == Sign::Positive;
        let least = (0..ways.len())
            .filter(strict)
            .flat_map(|j| ways[j].iter().filter(|way| !way.nothing).flat_map(shares));
        let kept = least.fold(Rational::one(), Rational::min);
        if !kept.is_positive() {
            return None;
        }
        let mut before = Weights {
            of: vec![Sum::default(); self.from.len()],
            constant: after.constant.clone(),
            positive: Sum::default(),
        };
        before.positive.add(&kept, &after.positive);
        before.positive.add(&(Rational::one() - &kept), &after.constant);
        for (j, ways) in ways.iter().enumerate() {
            let equation = self.to[j].sign == Sign::Zero;
            for way in ways {
                let ranges: Vec<Range> = way.ranges.iter().map(|p| self.range(*p)).collect();
                let weight = after.of[j].times(&way.share);
                let with = |values: &[Rational]| weight.times(&spread(values, &ranges));
                let used: BTreeSet<usize> =
                    way.rows.iter().flat_map(|r| r.0.keys().copied()).collect();
                for i in used {
                    let of = |r: &(BTreeMap<usize, Rational>, _)| r.0.get(&i).cloned();
                    let values: Vec<Rational> =
                        way.rows.iter().map(|r| of(r).unwrap_or_default()).collect();
                    before.of[i].add(&Rational::one(), &with(&values));
                }
                let left: Vec<Rational> = way.rows.iter().map(|r| r.1.clone()).collect();
                before.constant.add(&Rational::one(), &with(&left));
                let taken = if strict(&j) { kept.clone() } else { Rational::zero() };
                let over: Vec<Rational> = shares(way).iter().map(|s| s - &taken).collect();
                if equation && !over.iter().all(Zero::is_zero) {
                    return None;
                }
                before.positive.add(&Rational::one(), &with(&over));
                for p in &way.ranges {
                    let name = &self.runs.ranges[*p].0;
                    self.read(read, &format!("low.{name}"));
                    self.read(read, &format!("high.{name}"));
                }
            }
        }
        if let How::Step(_) = how {
            self.step(after, read);
        }
        Some(before)
    }

    /// Adds the equations of the step, each times what it is multiplied with in the sum of the literals.
    fn step(&self, after: &Weights, read: &mut Read) {
        let mut moved: BTreeMap<usize, Sum> = BTreeMap::new();
        for (literal, weight) in self.to.iter().zip(&after.of) {
            for (v, c) in &literal.form {
                moved.entry(*v).or_default().add(c, weight);
            }
        }
        for (v, weight) in moved.iter().filter(|(_, w)| !w.is_zero()) {
            let fact = self.runs.step_fact(*v, self.at, self.tag);
            read.zero += &format!(" + ({})*{fact}", weight.value());
            read.instances.insert(fact, self.runs.step_at(*v, self.at, self.tag));
        }
        if self.runs.chooses() {
            self.read(read, "modes");
            for (mode, _) in &self.runs.modes {
                self.read(read, &format!("acts.{mode}"));
            }
            // What no mode leaves alone: the share that the modes leave is 0.
            for (literal, weight) in self.to.iter().zip(&after.of) {
                if self.changing(literal).len() == self.runs.modes.len() {
                    let form = self.runs.text(&literal.poly(), self.at);
                    read.zero += &format!(" + ({})*({form})*[modes{}]", weight.value(), self.tag);
                }
            }
        }
    }

    fn read(&self, read: &mut Read, lemma: &str) {
        read.instances
            .insert(format!("[{lemma}{}]", self.tag), self.runs.every(lemma, self.at, self.tag));
    }

    fn range(&self, p: usize) -> Range {
        let (name, [low, high]) = &self.runs.ranges[p];
        let factor = |end: &str| {
            let value = self.runs.distance(end, name, self.at).unwrap_or_default();
            Factor::new(value, format!("[{end}.{name}{}]", self.tag))
        };
        Range { width: high - low, above_low: factor("low"), below_high: factor("high") }
    }

    fn still(&self, edge: &Edge, j: usize) -> Option<Way> {
        let [multipliers] = edge.multipliers.get(j)?.as_slice() else { return None };
        let rows = vec![row(multipliers, self.to[j].constant.clone(), self.from)?];
        Some(Way { share: Sum::number(Rational::one()), nothing: false, ranges: Vec::new(), rows })
    }

    /// The modes that change a literal.
    fn changing(&self, literal: &Literal) -> Vec<usize> {
        let changes =
            |m: &usize| literal.form.keys().any(|v| self.runs.modes[*m].1.contains_key(v));
        (0..self.runs.modes.len()).filter(changes).collect()
    }

    fn moved(&self, edges: &[&Edge], j: usize) -> Option<Vec<Way>> {
        let place = |e: &Edge| {
            let by = e.by.as_ref()?;
            self.runs.written.iter().position(|name| name == by)
        };
        if !self.runs.chooses() {
            let [edge] = edges else { return None };
            let share = Sum::number(Rational::one());
            return Some(vec![self.by(edge, place(edge)?, j, share)?]);
        }
        let changing = self.changing(&self.to[j]);
        let at = self.at.text();
        let mut ways = Vec::new();
        for &m in &changing {
            let edge = edges.iter().find(|e| place(e) == Some(m))?;
            let name = &self.runs.modes[m].0;
            let acts = Factor::new(format!("{name}({at})"), format!("[acts.{name}{}]", self.tag));
            ways.push(self.by(edge, m, j, Sum::factor(acts))?);
        }
        let acting = |m: &usize| format!(" - {}({at})", self.runs.modes[*m].0);
        let value = format!("(1{})", changing.iter().map(acting).collect::<String>());
        let other = (0..self.runs.modes.len()).filter(|m| !changing.contains(m));
        let facts =
            other.clone().map(|m| format!("[acts.{}{}] + ", self.runs.modes[m].0, self.tag));
        let fact = format!("({}[modes{}])", facts.collect::<String>(), self.tag);
        let share = Sum::factor(Factor::new(value, fact));
        let unchanged = other.clone().find_map(|m| edges.iter().find(|e| place(e) == Some(m)));
        ways.push(match unchanged {
            Some(edge) => Way { share, ..self.still(edge, j)? },
            None => {
                Way { share, nothing: true, ranges: Vec::new(), rows: vec![Default::default()] }
            }
        });
        Some(ways)
    }

    /// By a mode.
    fn by(&self, edge: &Edge, mode: usize, j: usize, share: Sum) -> Option<Way> {
        let rows = &self.runs.modes.get(mode)?.1;
        let image = self.to[j].with(|v| rows.get(&v).cloned().unwrap_or_else(|| symbol(v)));
        let size = self.runs.state.len();
        let ranges: BTreeSet<usize> = image
            .terms()
            .flat_map(|(m, _)| m.powers().filter_map(|(v, _)| (v as usize).checked_sub(size)))
            .collect();
        let multipliers = edge.multipliers.get(j)?;
        if multipliers.len() != 1usize.checked_shl(u32::try_from(ranges.len()).ok()?)? {
            return None;
        }
        let vertex = |place: usize| {
            let ends = ranges.iter().rev().enumerate().map(|(bit, p)| {
                let [low, high] = &self.runs.ranges[*p].1;
                (p + size, if place >> bit & 1 == 0 { low } else { high })
            });
            let ends: BTreeMap<usize, &Rational> = ends.collect();
            image
                .evaluate(|v| ends.get(&(v as usize)).map_or_else(Rational::zero, |e| (*e).clone()))
        };
        let rows =
            multipliers.iter().enumerate().map(|(place, m)| row(m, vertex(place), self.from));
        Some(Way {
            share,
            nothing: false,
            ranges: ranges.iter().copied().collect(),
            rows: rows.collect::<Option<_>>()?,
        })
    }
}
