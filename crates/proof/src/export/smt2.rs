//! Inductive proofs, and the search for counterexamples, as SMT-LIB 2.
//!
//! A theorem about all steps k of N drones is cut into obligations about symbols. With I the
//! invariant (the sharp hypothesis on starts):
//!
//! * *initial*: every start of the hypothesis meets I (where the two differ);
//! * *preserved*: where I holds, it holds after one `exec_coverage`;
//! * *concluded*: where I holds at X^k, the conclusion about step k holds;
//! * *identity*: the equation behind 7.5, for every weight and every start.
//!
//! Each is written negated, so that `unsat` proves it. The formulas are what the spec computes
//! on terms: `term` and `decision`.

use std::fmt::Write as _;
use std::rc::Rc;

use cordon_core::theorems;
use cordon_spec::coverage::exec_coverage;
use cordon_spec::theorems::{Form, Setting, Theorem, Truth, Verdict, WeightRange};
use cordon_spec::{Params, State};
use num_traits::Signed;

use super::conjecture::Conjecture;
use super::decision::Diagram;
use super::term::Term;
use crate::symbolic::{Oracle, Symbol};
use cordon_core::Rational;
use cordon_core::range::Interval;

/// Which weights a query is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WeightDomain {
    /// Those of the claim's hypothesis.
    OfHypothesis,
    /// 0 <= eps <= 1 (the paper's definition 6) without those of the sharp hypothesis.
    Beyond,
    /// The weights of an interval, instead of the theorem's.
    Interval(Interval),
}

/// What a query asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obligation {
    /// The hypothesis implies the invariant.
    Initial,
    /// A step preserves the invariant.
    Preserved,
    /// The invariant implies the conclusion.
    Concluded,
    /// `c^{k+1} - c^k = eps*(g_{N-2} - g_0)`.
    Identity,
    /// Some allowed start violates the conclusion at a step `0 ..= steps`.
    Violated {
        /// The last step looked at.
        steps: usize,
    },
}

impl Obligation {
    /// The obligation in a word.
    pub fn label(self) -> &'static str {
        match self {
            Self::Initial => "initial",
            Self::Preserved => "preserved",
            Self::Concluded => "concluded",
            Self::Identity => "identity",
            Self::Violated { .. } => "violated",
        }
    }

    fn question(self) -> String {
        match self {
            Self::Initial => "is there a start in the hypothesis outside the invariant?".into(),
            Self::Preserved => "does a step lead out of the invariant?".into(),
            Self::Concluded => {
                "is there a placement in the invariant without the conclusion?".into()
            }
            Self::Identity => {
                "is there a step whose sum changes by other than eps*(g_{N-2} - g_0)?".into()
            }
            Self::Violated { steps } => {
                format!(
                    "is there a start whose run violates the conclusion at a step 0 .. {steps}?"
                )
            }
        }
    }
}

/// One satisfiability question, complete in itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Query {
    /// What is claimed: a theorem, or one of the companions of 7.3.
    pub claim: Conjecture,
    /// As printed, or sharp.
    pub form: Form,
    /// The number of drones N.
    pub drones: usize,
    /// What has to be unsatisfiable.
    pub obligation: Obligation,
    /// The weights that are meant.
    pub weights: WeightDomain,
}

/// Smallest number of drones the protocol is about.
pub const MIN_DRONES: usize = 3;

/// Largest number of drones exported: the predicates' comparisons are explored path by path,
/// up to three to the power N paths.
pub const MAX_DRONES: usize = 9;

/// The proof obligations of a claim, in order. All of them `unsat` prove it for this number of
/// drones, for all steps.
pub fn obligations(
    claim: Conjecture,
    form: Form,
    drones: usize,
    weights: &WeightDomain,
) -> Vec<Query> {
    let query = |obligation| Query { claim, form, drones, obligation, weights: weights.clone() };
    let mut queries = Vec::new();
    if !claim.starts_are_invariant(form) {
        queries.push(query(Obligation::Initial));
    }
    queries.push(query(Obligation::Preserved));
    queries.push(query(Obligation::Concluded));
    if (claim, form) == (Conjecture::Theorem(Theorem::SumNonDecreasing), Form::Sharp) {
        queries.push(Query { weights: WeightDomain::OfHypothesis, ..query(Obligation::Identity) });
    }
    queries
}

/// Whether some weight of 0 <= eps <= 1 lies outside the claim's sharp hypothesis.
pub fn has_beyond(claim: Conjecture, drones: usize) -> bool {
    match claim.weights(Form::Sharp) {
        WeightRange::Any | WeightRange::Unit => false,
        WeightRange::UpToHalfOrOne => drones > MIN_DRONES,
        _ => true,
    }
}

impl Query {
    /// A name for files and listings, like `7.2-sharp-n4-preserved`.
    pub fn name(&self) -> String {
        let (claim, form) = (self.claim, self.form.label());
        format!("{claim}-{form}-n{}-{}", self.drones, self.obligation.label())
    }

    /// The names whose values make up a model: ends, weight, positions of the start.
    pub fn symbols(&self) -> Vec<String> {
        let fixed = ["min", "max", "eps"].map(str::to_owned);
        fixed.into_iter().chain((0..self.drones).map(|i| position(i, 0))).collect()
    }

    /// Whether the weight of `setting` is among those the query is about.
    pub fn asks_about(&self, setting: &Setting<Rational>) -> bool {
        let within = |range: WeightRange| {
            range.contains(&setting.eps_num, &setting.eps_den, self.drones).is_true()
        };
        match &self.weights {
            WeightDomain::OfHypothesis => within(self.claim.weights(self.form)),
            WeightDomain::Beyond => {
                within(WeightRange::Unit) && !within(self.claim.weights(Form::Sharp))
            }
            WeightDomain::Interval(i) => i.contains(&(&setting.eps_num / &setting.eps_den)),
        }
    }

    /// The SMT-LIB 2 text of the query.
    pub fn text(&self) -> String {
        Writer::new(self).finish()
    }
}

/// The constant that stands for drone `i` at step `k`.
fn position(i: usize, k: usize) -> String {
    format!("x{i}_{k}")
}

struct Writer<'q> {
    query: &'q Query,
    oracle: Rc<Oracle<Term>>,
    params: Params<Symbol<Term>>,
    setting: Setting<Symbol<Term>>,
    /// Step k of the run, as constants.
    run: Vec<Vec<Symbol<Term>>>,
    text: String,
}

impl<'q> Writer<'q> {
    fn new(query: &'q Query) -> Self {
        let oracle = Oracle::new();
        let symbol = |name: &str| oracle.symbol(Term::Symbol(name.into()));
        let params = Params { min: symbol("min"), max: symbol("max"), eps: symbol("eps"), n: 0 };
        let setting = Setting::from(&params);
        let start = (0..query.drones).map(|i| symbol(&position(i, 0))).collect();
        Self { query, params, setting, run: vec![start], oracle, text: String::new() }
    }

    fn line(&mut self, text: impl AsRef<str>) {
        self.text.push_str(text.as_ref());
        self.text.push('\n');
    }

    fn finish(mut self) -> String {
        let query = self.query;
        self.head();
        match query.obligation {
            Obligation::Initial => {
                self.weights();
                self.start();
                let goal = self.not(|w| w.query.claim.invariant(&w.setting, &w.run[0]));
                self.assert("outside the invariant", "out", &goal);
            }
            Obligation::Preserved => {
                self.weights();
                self.invariant();
                self.steps(1);
                let goal = self.not(|w| w.query.claim.invariant(&w.setting, &w.run[1]));
                self.assert("outside the invariant after the step", "out", &goal);
            }
            Obligation::Concluded => {
                self.weights();
                self.invariant();
                self.steps(query.claim.span(query.form, query.drones));
                let goal = self.violated_at(0);
                self.assert("the conclusion does not hold", "v", &goal);
            }
            Obligation::Identity => {
                self.anchored();
                self.steps(1);
                let w = &self;
                let residual = cordon_spec::theorems::telescoping_residual(
                    &w.params.eps,
                    &w.run[0],
                    &w.run[1],
                );
                let line = format!("(assert (not (= {} 0.0)))", residual.expression);
                self.line("; telescoping_residual is not zero");
                self.line(line);
            }
            Obligation::Violated { steps } => {
                self.weights();
                self.start();
                self.steps(steps + query.claim.span(query.form, query.drones));
                let goals: Vec<_> = (0..=steps).map(|k| self.violated_at(k)).collect();
                self.assert_any("the conclusion does not hold at some step", &goals);
            }
        }
        self.line("(check-sat)");
        if matches!(query.obligation, Obligation::Violated { .. }) {
            let line = format!("(get-value ({}))", query.symbols().join(" "));
            self.line(line);
        }
        self.text
    }

    fn head(&mut self) {
        let Query { claim, form, drones, obligation, .. } = self.query;
        let said = claim.conclusion_text(*form);
        self.line(format!(
            "; {} of {claim} ({} form), N = {drones}",
            obligation.label(),
            form.label()
        ));
        self.line(format!("; claim: {said}"));
        self.line(format!("; {} `unsat` means no", obligation.question()));
        self.line("; written by executing cordon-spec on terms; xI_K is drone I at step K");
        self.line("(set-logic QF_NRA)");
        for name in self.query.symbols() {
            self.line(format!("(declare-const {name} Real)"));
        }
        self.line("; the segment has a length");
        self.line("(assert (< min max))");
    }

    /// Asserts what the weights are.
    fn weights(&mut self) {
        let claim = self.query.claim;
        let range = |w: &Self, r: WeightRange| {
            r.contains(&w.setting.eps_num, &w.setting.eps_den, w.query.drones)
        };
        match &self.query.weights {
            WeightDomain::OfHypothesis => {
                let hypothesis = claim.weights(self.query.form);
                let diagram = self.is(|w| range(w, hypothesis));
                self.assert(&format!("weights: {}", theorems::weights(hypothesis)), "w", &diagram);
            }
            WeightDomain::Beyond => {
                let unit = self.is(|w| range(w, WeightRange::Unit));
                self.assert(
                    &format!("weights: {}", theorems::weights(WeightRange::Unit)),
                    "u",
                    &unit,
                );
                let sharp = claim.weights(Form::Sharp);
                let beyond = self.not(|w| range(w, sharp));
                self.assert(&format!("but not: {}", theorems::weights(sharp)), "w", &beyond);
            }
            WeightDomain::Interval(i) => {
                let relation = |closed| if closed { "<=" } else { "<" };
                let low = format!("(assert ({} {} eps))", relation(i.low_closed), real(&i.low));
                let high = format!("(assert ({} eps {}))", relation(i.high_closed), real(&i.high));
                self.line("; weights: an interval given by the user");
                self.line(low);
                self.line(high);
            }
        }
    }

    fn anchored(&mut self) {
        let starts = cordon_spec::theorems::StartSet::Any;
        let diagram = self.is(|w| starts.contains(&w.setting, &w.run[0]));
        self.assert("drones 0 and N-1 in place", "a", &diagram);
    }

    fn start(&mut self) {
        let Query { claim, form, .. } = *self.query;
        let diagram = self.is(|w| claim.allows(form, &w.setting, &w.run[0]));
        self.assert(&format!("start: {}", claim.starts_text(form)), "s", &diagram);
    }

    fn invariant(&mut self) {
        let claim = self.query.claim;
        let diagram = self.is(|w| claim.invariant(&w.setting, &w.run[0]));
        self.assert(&format!("invariant: {}", claim.starts_text(Form::Sharp)), "i", &diagram);
    }

    /// Appends protocol steps to the run: `exec_coverage` of the constants of the step before,
    /// under new names.
    fn steps(&mut self, count: usize) {
        for k in 1..=count {
            let before = State { drones: self.run[k - 1].clone(), timesteps: 0 };
            let after = exec_coverage(&self.params, &before).drones;
            self.line(format!("; step {k}: exec_coverage"));
            let mut names = Vec::new();
            for (i, x) in after.iter().enumerate() {
                let name = position(i, k);
                self.line(format!("(define-fun {name} () Real {})", x.expression));
                names.push(self.oracle.symbol(Term::Symbol(name.into())));
            }
            self.run.push(names);
        }
    }

    /// The diagram of a statement taken as given. A path in doubt counts as allowed.
    fn is(&self, truth: impl Fn(&Self) -> Truth) -> Diagram {
        Diagram::explore(&self.oracle, true, || known(truth(self)))
    }

    /// The diagram of a statement's negation. A path in doubt counts as a violation.
    fn not(&self, truth: impl Fn(&Self) -> Truth) -> Diagram {
        Diagram::explore(&self.oracle, true, || known(truth(self)).map(|is| !is))
    }

    fn violated_at(&self, k: usize) -> Diagram {
        let Query { claim, form, .. } = *self.query;
        Diagram::explore(&self.oracle, true, || {
            match claim.conclusion(form, &self.setting, &self.run[k..]) {
                Verdict::Violated(_) => Some(true),
                Verdict::Holds | Verdict::Vacuous => Some(false),
                Verdict::Undecided => None,
            }
        })
    }

    fn assert(&mut self, what: &str, prefix: &str, diagram: &Diagram) {
        self.line(format!("; {what}"));
        let (definitions, formula) = diagram.to_smt2(prefix);
        definitions.iter().for_each(|d| self.line(d));
        self.line(format!("(assert {formula})"));
    }

    fn assert_any(&mut self, what: &str, diagrams: &[Diagram]) {
        self.line(format!("; {what}"));
        let mut formulas = String::new();
        for (k, diagram) in diagrams.iter().enumerate() {
            let (definitions, formula) = diagram.to_smt2(&format!("v{k}_"));
            definitions.iter().for_each(|d| self.line(d));
            // Writing to a string cannot fail.
            let _ = write!(formulas, " {formula}");
        }
        // One alternative is `false` more, so that `or` never stands alone.
        self.line(format!("(assert (or false{formulas}))"));
    }
}

fn known(truth: Truth) -> Option<bool> {
    match truth {
        Truth::True => Some(true),
        Truth::False => Some(false),
        Truth::Unknown => None,
    }
}

/// A rational as a term of sort Real.
fn real(x: &Rational) -> String {
    let magnitude = if x.is_integer() {
        Term::Int(x.numer().abs()).to_string()
    } else {
        format!("(/ {} {})", Term::Int(x.numer().abs()), Term::Int(x.denom().clone()))
    };
    if x.is_negative() { format!("(- {magnitude})") } else { magnitude }
}
