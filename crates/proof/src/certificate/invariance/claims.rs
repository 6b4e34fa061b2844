//! What follows from the nodes, as conclusions.

use std::collections::BTreeMap;

use num_traits::{One, Zero};
use serde_json::Value;

use super::super::linear::Multipliers;
use super::super::runs::{Literal, Time};
use super::super::theorem::{absurd_times, cases, clause, instance, positivity, split};
use super::super::weights::{Factor, Sum};
use super::carry::Weights;
use super::{Known, Writer};
use cordon_core::Rational;
use cordon_core::exact;
use cordon_core::linear::feasible::Sign;

impl Writer<'_> {
    /// The claims: each for all steps from one on, where it is made at every node from there, else for each of its steps alone.
    pub(super) fn conclude(&mut self) -> Option<()> {
        // By what they say, in the order given: the multipliers at each place.
        let mut said: Vec<(&str, BTreeMap<usize, &Multipliers>)> = Vec::new();
        for claim in self.claims {
            let holds = claim.holds.as_str();
            let index = said.iter().position(|(text, _)| *text == holds).unwrap_or_else(|| {
                said.push((holds, BTreeMap::new()));
                said.len() - 1
            });
            let place = self.walk.places.iter().position(|p| p.node == claim.at)?;
            said.get_mut(index)?.1.insert(place, &claim.multipliers);
        }
        for (index, (holds, places)) in said.iter().enumerate() {
            let literal = self.runs.literal(self.system, holds)?;
            self.conclude_one(&format!("claim{index}"), &literal, places)?;
        }
        Some(())
    }

    fn conclude_one(
        &mut self,
        name: &str,
        literal: &Literal,
        places: &BTreeMap<usize, &Multipliers>,
    ) -> Option<()> {
        let k = self.step.clone();
        let (first, period) = self.period().unwrap_or((usize::MAX, 0));
        // The places before those that recur, by their steps.
        let mut chain: BTreeMap<usize, (usize, &Multipliers)> = BTreeMap::new();
        for (place, multipliers) in places.range(..first) {
            chain.insert(self.walk.places.get(*place)?.step, (*place, multipliers));
        }
        for (place, multipliers) in places.range(first..) {
            let at = self.time(*place);
            let mut known = (at.clone(), self.follows(literal, *place, multipliers, &at)?);
            let mut from = self.walk.places.get(*place)?.step;
            // From earlier steps on, as long as it is claimed there.
            while let Some((before, multipliers)) =
                (period == 1).then_some(()).and_then(|()| chain.remove(&from.checked_sub(1)?))
            {
                let lemma = format!("{name}.{from}");
                self.sheet.lemma(self.said(&lemma, literal, &known.0), known.1);
                from -= 1;
                let now = Time::step(from);
                let equal = self.follows(literal, before, multipliers, &now)?;
                let later = instance("later", &lemma, &format!("{k}={k}"), &format!("{k}=[{k}]"));
                let beyond = positivity(&[later], "[later]");
                let at = Time { variable: Some((k.clone(), from)), ..at.clone() };
                known = (at, cases(&k, &k, equal, beyond));
            }
            chain.retain(|step, _| *step < from || period > 1);
            let name =
                if period == 1 { name.to_owned() } else { format!("{name}.{}", *place - first) };
            self.sheet.conclude(self.said(&name, literal, &known.0), known.1);
            if period == 1 {
                break;
            }
        }
        for (step, (place, multipliers)) in chain {
            let at = Time::step(step);
            let proof = self.follows(literal, place, multipliers, &at)?;
            self.sheet.conclude(self.said(&format!("{name}.at{step}"), literal, &at), proof);
        }
        Some(())
    }

    fn said(&self, name: &str, literal: &Literal, at: &Time) -> Value {
        let goal = literal.text(&self.runs, at);
        match &at.variable {
            None => clause(name, "", &[], &goal),
            Some((k, least)) => clause(name, k, &[&format!("{k}: {k} >= {least}")], &goal),
        }
    }

    /// A literal from those of a node, with multipliers.
    fn follows(
        &self,
        literal: &Literal,
        place: usize,
        multipliers: &Multipliers,
        at: &Time,
    ) -> Option<Value> {
        if at.variable.is_none() && place < self.shares.len() {
            return self.by_facts(literal, place, multipliers);
        }
        let node = self.node(place);
        let mut factors = vec![Rational::zero(); node.len()];
        for (i, text) in multipliers {
            *factors.get_mut(*i)? = exact::parse("multiplier", text).ok()?;
        }
        let of = |value: &dyn Fn(&Literal) -> Rational| -> Rational {
            node.iter().zip(&factors).map(|(l, m)| m * value(l)).sum()
        };
        let left = &literal.constant - of(&|l| l.constant.clone());
        let strict = of(&|l| Rational::from_integer(i32::from(l.sign == Sign::Positive).into()));
        let time = at.variable.as_ref().map(|(k, _)| (k.clone(), format!("[{k}]")));
        // The lemma about the group in which all multipliers are, if there is one.
        let mut groups = multipliers.keys().map(|j| Self::group(node, *j).map(|(group, _)| group));
        let lemma = match groups.next().flatten() {
            Some(group) if groups.all(|g| g == Some(group)) => {
                format!("{}.{group}", Self::lemma(place))
            }
            _ => Self::lemma(place),
        };
        let known = Known { lemma, time, earlier: false };
        // The instance with the factors times a sign, and something added.
        let instance = |sign: i32, added: &Sum| {
            let sign = Rational::from_integer(sign.into());
            let mut constant = Sum::number(&sign * &left);
            constant.add(&Rational::one(), added);
            let mut positive = Sum::number(&sign * &strict);
            positive.add(&Rational::one(), &constant);
            let of = factors.iter().map(|m| Sum::number(&sign * m)).collect();
            self.instance("node", &known, node, &Weights { of, constant, positive })
        };
        if literal.sign == Sign::Positive {
            return Some(positivity(&[instance(1, &Sum::default())?], "[node]"));
        }
        // If it were on the other side of 0, the node's sum would be 0, but it is above.
        let form = self.runs.text(&literal.poly(), at);
        let missed = |sign: i32, value: String| {
            let added = Sum::factor(Factor::new(value, "[sign]"));
            Some(absurd_times(&["node"], &[instance(sign, &added)?], "0"))
        };
        let is = positivity(&[], "[sign]");
        let above = match literal.sign {
            Sign::Zero => missed(-1, format!("({form})"))?,
            _ => is.clone(),
        };
        let below = missed(1, format!("(-({form}))"))?;
        Some(split("sign", &form, [above, is, below]))
    }
}
