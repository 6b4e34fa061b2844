//! A user's linear system as read: what each mode makes of the state, and at which values of the
//! parameters that has to be looked at.
//!
//! A mode's row is affine in the state and in each parameter. What is affine in each parameter is least at a vertex of
//! the box of their ranges: the vertices decide.

use std::collections::{BTreeMap, BTreeSet};

use crate::expr::{Literal, Signature, Sort, joined};
use crate::fault::{Result, ensure, fault};
use crate::format::{Linear, Named};
use crate::kernel::Kernel;
use crate::number::{Number, spend};
use crate::poly::{Atom, Poly};

const SYSTEM: &str = "system";

/// A linear system as read.
pub struct System<'c> {
    written: &'c Linear,
    state: Signature,
    /// What each mode makes of each variable that it changes.
    pub modes: BTreeMap<&'c str, BTreeMap<&'c str, Poly>>,
}

/// Polynomials in the place of variables, by name.
pub type Values<'c> = BTreeMap<&'c str, Poly>;

/// The polynomial with those values in the place of variables.
pub fn at(poly: &Poly, values: &Values<'_>) -> Poly {
    poly.with(&|v| values.get(v).cloned())
}

/// A name space of reals.
fn reals<'n>(names: impl IntoIterator<Item = &'n String>) -> Result<Signature> {
    let mut kernel = Kernel::default();
    for name in names {
        kernel.constant(name, Sort::Real)?;
    }
    Ok(kernel.signature)
}

/// In the variables together, and in each other name.
fn is_affine(poly: &Poly, text: &str, variables: &Signature) -> Result<()> {
    let fits = |m: &Vec<Atom>| {
        m.iter().filter(|a| variables.knows(a)).count() < 2 && m.windows(2).all(|w| w[0] != w[1])
    };
    ensure!(poly.terms().all(|(m, _)| fits(m)), SYSTEM, "`{text:.60}` is not affine");
    Ok(())
}

impl<'c> System<'c> {
    /// Reads a system.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn read(written: &'c Linear) -> Result<Self> {
        let state = reals(&written.state)?;
        let rows = reals(written.state.iter().chain(written.parameters.0.keys()))?;
        for (name, [low, high]) in &written.parameters.0 {
            ensure!(low <= high, SYSTEM, "the range of `{name}` is empty");
        }
        let mut modes = BTreeMap::new();
        for (name, updates) in &written.modes.0 {
            let mut mode = BTreeMap::new();
            for (variable, text) in &updates.0 {
                let known = state.constants.contains_key(variable.as_str());
                ensure!(known, SYSTEM, "mode `{name:.40}`: no variable `{variable:.40}`");
                let row = rows.poly(text, &Vec::new(), false)?;
                is_affine(&row, text, &state)?;
                mode.insert(variable.as_str(), row);
            }
            modes.insert(name.as_str(), mode);
        }
        let empty = written.state.is_empty() || modes.is_empty();
        ensure!(!empty, SYSTEM, "a system without variables, or without modes");
        Ok(Self { written, state, modes })
    }

    /// Reads a literal that is affine in the state.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn literal(&self, text: &str) -> Result<Literal> {
        let literal = self.state.literal(text, &Vec::new())?;
        is_affine(&literal.poly, text, &self.state)?;
        Ok(literal)
    }

    /// What a mode makes of each variable that it changes.
    ///
    /// # Errors
    /// There is no such mode.
    pub fn rows(&self, mode: &str) -> Result<&Values<'c>> {
        self.modes.get(mode).map_or_else(|| fault(SYSTEM, format!("no mode `{mode:.40}`")), Ok)
    }

    /// The forms at each vertex of the box of the parameters that occur in them. A range that is a point counts once.
    ///
    /// # Errors
    /// They are too many.
    pub fn vertices(&self, forms: &[Poly]) -> Result<Vec<Vec<Poly>>> {
        let names = |f: &Poly| f.terms().flat_map(|(m, _)| m.clone()).collect::<Vec<_>>();
        let occur: BTreeSet<Atom> = forms.iter().flat_map(names).collect();
        let mut all = vec![forms.to_vec()];
        for atom in &occur {
            let Atom::Var(name) = atom else { continue };
            let Some([low, high]) = self.written.parameters.0.get(&**name) else { continue };
            spend(128 * all.len() as u64)?;
            let ends = BTreeSet::from([low, high]);
            let there = |forms: &Vec<Poly>, end: &Number| -> Vec<Poly> {
                let end = Values::from([(&**name, Poly::constant(end.clone()))]);
                forms.iter().map(|f| at(f, &end)).collect()
            };
            all = all.iter().flat_map(|f| ends.iter().map(|end| there(f, end))).collect();
        }
        Ok(all)
    }

    /// The system in words: what it is, its modes, the ranges of parameters but for those that have a value in the whole run, and
    /// what is assumed of the start.
    pub fn words(
        &self,
        [what, each]: [&str; 2],
        with: &Named<Number>,
        assumed: &[Literal],
    ) -> String {
        let mut words = format!("{what} {}", joined(&self.written.state, ", "));
        for (name, rows) in &self.modes {
            let rows = rows.iter().map(|(v, row)| format!("{v}' = {row}"));
            words += &format!("\n  mode {name}: {}", joined(rows, ", "));
        }
        for (name, [low, high]) in &self.written.parameters.0 {
            words += &match with.0.get(name) {
                Some(value) => format!("\n  in every step {name} = {value}, in [{low}, {high}]"),
                None => format!("\n  {each} any {name} in [{low}, {high}]"),
            };
        }
        if !assumed.is_empty() {
            words += &format!("\n  assuming of the start: {}", joined(assumed, " and "));
        }
        words
    }
}

/// The constant of an affine polynomial, and its coefficients.
pub fn coefficients(poly: &Poly, names: &[String]) -> (Number, Vec<Number>) {
    let entry = |name: &String| poly.coefficient(&[Atom::Var(name.as_str().into())]);
    (poly.coefficient(&[]), names.iter().map(entry).collect())
}
