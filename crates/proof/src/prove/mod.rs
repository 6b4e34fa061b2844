//! Proofs: the untrusted search for certificates. What it finds counts only once the independent checker
//! (`cordon-check`) has accepted it.
//!
//! For a user's protocol the proof is searched ([`any_size`]). For the theorems it is known, and written down as
//! one reads it (`scripts/`, the language is described in `script.rs`): induction over steps with cases over the
//! drones (`invariants`), telescoping sums and fronts (`sums`), contraction (`limit`). The range of weights and the
//! number of drones are filled in.

pub mod any_size;

mod departing;
mod invariants;
mod lemmas;
mod limit;
mod others;
mod script;
mod sums;

use cordon_spec::theorems::{Form, Theorem};
use serde_json::Value;

use crate::certificate::theorem::Sheet;
pub use lemmas::Scope;
use lemmas::{ABOVE, BELOW, LOWER, Steps};

/// Something that can be proved: a theorem, a part or an extension of one.
#[derive(Clone, Copy, Debug)]
pub struct Claim {
    /// The theorem's number, with the name of the extension.
    pub name: &'static str,
    /// The theorem whose hypothesis is meant, if the claim has the two forms of one.
    pub theorem: Option<Theorem>,
    sheet: fn(&Scope) -> Option<Sheet>,
}

/// Every claim.
pub const CLAIMS: [Claim; 47] = {
    use Steps::{Activation, Delay, Full};
    const fn of(name: &'static str, theorem: Theorem, sheet: fn(&Scope) -> Option<Sheet>) -> Claim {
        Claim { name, theorem: Some(theorem), sheet }
    }
    const fn claim(name: &'static str, sheet: fn(&Scope) -> Option<Sheet>) -> Claim {
        Claim { name, theorem: None, sheet }
    }
    [
        of("7.2", Theorem::Ordering, |s| invariants::ordering(s, Full)),
        of("7.3", Theorem::UpperBound, |s| invariants::upper(s, Full)),
        of("7.4i", Theorem::SumBounded, sums::bounded),
        of("7.4ii", Theorem::SumMaximal, sums::maximal),
        of("7.5i", Theorem::SumNonDecreasing, sums::non_decreasing),
        of("7.5ii", Theorem::SumStationary, sums::stationary),
        of("7.6i", Theorem::TargetsFixed, sums::targets_fixed),
        of("7.6ii", Theorem::ConstantSum, sums::constant_sum),
        of("7.7", Theorem::GloballyIncreasing, sums::globally_increasing),
        of("7.8", Theorem::Limit, limit::limit),
        claim("7.8-beyond", limit::beyond),
        claim("7.8-low", limit::low),
        claim("7.5-identity", sums::identity),
        claim("7.3-mirror", |s| invariants::assumed(s, Full, &[LOWER])),
        claim("7.3-box", |s| invariants::assumed(s, Full, &[ABOVE, BELOW])),
        claim("7.2-activation", |s| invariants::ordering(s, Activation)),
        claim("7.3-activation", |s| invariants::upper(s, Activation)),
        claim("7.3-mirror-activation", |s| invariants::assumed(s, Activation, &[LOWER])),
        claim("7.3-box-activation", |s| invariants::assumed(s, Activation, &[ABOVE, BELOW])),
        claim("7.3-delay", |s| invariants::upper(s, Delay)),
        claim("7.3-mirror-delay", |s| invariants::assumed(s, Delay, &[LOWER])),
        claim("7.3-box-delay", |s| invariants::assumed(s, Delay, &[ABOVE, BELOW])),
        claim("7.2-one-late", departing::ordering_one_late),
        claim("7.2-cells-delay", departing::ordering_in_cells),
        claim("7.8-delay", departing::limit_late),
        claim("7.2-gaps-activation", departing::gaps_active),
        claim("7.8-activation", departing::limit_active),
        claim("7.2-hold", departing::gaps_held),
        claim("7.2-loss", departing::ordering_with_losses),
        claim("7.2-hold-sums", departing::ordering_held),
        claim("7.2-hold-exact", departing::ordering_held_exact),
        claim("7.2-loss-sums", departing::weak_ordering_with_losses),
        claim("7.2-loss-exact", departing::weak_ordering_with_losses_exact),
        claim("7.2-joining", departing::ordering_joining),
        claim("7.2-gaps-varying", departing::gaps_varying),
        claim("7.3-varying", departing::upper_varying),
        claim("7.5i-varying", departing::increasing_varying),
        claim("7.6i-varying", departing::fixed_varying),
        claim("7.6ii-varying", departing::constant_varying),
        claim("7.7-varying", departing::increasing_in_time_varying),
        claim("7.8-varying", departing::limit_varying),
        claim("7.8-varying-exact", departing::limit_exact),
        claim("consensus-average", sums::consensus),
        claim("rendez-vous", departing::rendezvous),
        claim("projection", others::projection),
        claim("7.2-exact", others::ordering_exact),
        claim("7.3-exact", others::upper_exact),
    ]
};

impl Claim {
    /// The forms that it has; the sharp one stands for a claim that has no other.
    pub fn forms(&self) -> &'static [Form] {
        if self.theorem.is_some() { &Form::ALL } else { &[Form::Sharp] }
    }

    /// Its name in that form.
    pub fn label(&self, form: Form) -> String {
        match self.theorem {
            Some(_) => format!("{}-{}", self.name, form.label()),
            None => self.name.to_owned(),
        }
    }

    /// What a certificate of the claim has to state; nothing if the strategy fits no such scope.
    pub fn statement(&self, scope: &Scope) -> Option<Value> {
        (self.sheet)(scope).map(|sheet| sheet.statement())
    }

    /// A certificate of the claim, for the checker to judge; nothing if the strategy fits no such scope.
    pub fn prove(&self, scope: &Scope) -> Option<Value> {
        (self.sheet)(scope).map(|sheet| sheet.certificate())
    }
}

/// The claim, and its form, whose statement for every N and all weights of its range this is.
pub fn stated(statement: &Value) -> Option<(&'static Claim, Form)> {
    let all = CLAIMS.iter().flat_map(|c| c.forms().iter().map(move |&form| (c, form)));
    let mut whole = all.map(|(c, form)| (c, form, Scope { form, weights: None, drones: None }));
    whole
        .find(|(c, _, scope)| c.statement(scope).as_ref() == Some(statement))
        .map(|(c, form, _)| (c, form))
}
