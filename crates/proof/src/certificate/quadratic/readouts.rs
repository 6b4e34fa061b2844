//! Readouts as functions of the step, and what a step makes of them.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::Zero;

use super::text::add;
use super::{Parameter, Writer};
use crate::certificate::theorem::positivity;
use cordon_core::scalar::Polynomial;
use cordon_core::system::expression::or_zero;

impl Writer<'_> {
    /// What a mode makes of a readout, by the readouts at this step.
    pub(super) fn row(&self, mode: usize, a: usize) -> Option<BTreeMap<usize, String>> {
        let rows = self.quadratic.maps.get(self.runs.written.get(mode)?)?;
        let text = |(b, entry): (&usize, &Polynomial)| {
            let mut text = String::new();
            for (monomial, c) in entry.terms() {
                let (mut c, mut names) = (c.clone(), Vec::new());
                for (p, _) in monomial.powers() {
                    match self.values.get(p as usize)? {
                        Parameter::Point(value) => c *= value,
                        Parameter::Range(f, _) => names.push(format!("{f}({})", self.runs.step)),
                    }
                }
                if !c.is_zero() {
                    add(&mut text, &c, names);
                }
            }
            Some((*b, text))
        };
        rows.get(a)?
            .iter()
            .map(text)
            .filter(|t| t.as_ref().is_none_or(|(_, t)| !t.is_empty()))
            .collect()
    }

    /// Defines readouts, and shows what a step makes of them.
    pub(super) fn readouts(&mut self) -> Option<()> {
        let (now, k) = (self.now.clone(), self.runs.step.clone());
        let (next, here) = (now.later(1), self.at(&now));
        for a in 0..self.y.len() {
            let text = self.readout(a, &now)?;
            self.sheet.define(&self.y[a].clone(), &[&k], &[], &text, None);
        }
        for a in 0..self.y.len() {
            // By how much a step and the readouts' definitions have to be added.
            let mut goal = Vec::new();
            let mut sum = "[next]".to_owned();
            let mut facts = vec![self.defined(&self.y[a], &next, "next")];
            let (_, coefficients) = self.quadratic.readouts[a].parts()?;
            for (v, c) in coefficients.iter().enumerate().filter(|(_, c)| !c.is_zero()) {
                facts.push(self.runs.step_at(v, &now, ""));
                add(&mut sum, c, [self.runs.step_fact(v, &now, "")]);
            }
            let selectors = self.selectors(&now);
            if selectors.is_some() {
                facts.push(self.runs.every("modes", &now, ""));
                sum += &format!(" + ({})*[modes]", self.readout(a, &now)?);
            }
            let mut read = BTreeSet::new();
            for mode in 0..self.runs.modes.len() {
                let row = self.row(mode, a)?;
                let by = selectors.as_ref().map(|s| format!("{}*", s[mode])).unwrap_or_default();
                let terms: Vec<String> =
                    row.iter().map(|(b, c)| format!("({c})*{}", here[*b])).collect();
                let terms = terms.join(" + ");
                if !terms.is_empty() {
                    goal.push(if by.is_empty() { terms } else { format!("{by}({terms})") });
                }
                for (b, c) in &row {
                    sum += &format!(" - {by}({c})*[{}]", self.y[*b]);
                    read.insert(*b);
                }
            }
            facts.extend(read.iter().map(|b| self.defined(&self.y[*b], &now, &self.y[*b])));
            let goal = format!("{} = {}", self.at(&next)[a], or_zero(goal.join(" + ")));
            let clause = self.every_step(&format!("next.{}", self.y[a]), &goal);
            self.sheet.lemma(clause, positivity(&facts, &sum));
        }
        self.square();
        Some(())
    }
}
