//! Certificates of the kind `theorem`, piece by piece (`proofs/checker/FORMAT.md`).

use cordon_core::Rational;
use cordon_core::exact::fraction;
use num_traits::Signed;
use serde_json::{Map, Value, json};

/// Text for a list of `name=value` pairs with `, ` between.
fn pairs(text: &str) -> Value {
    let pair = |p: &str| p.split_once('=').map(|(n, v)| (n.trim().to_owned(), json!(v.trim())));
    Value::Object(text.split(", ").filter_map(pair).collect())
}

/// A number as a factor or a term.
pub fn bracketed(x: &Rational) -> String {
    if x.is_negative() { format!("({})", fraction(x)) } else { fraction(x) }
}

/// An instance of a lemma as a fact: terms for its variables, sums for its literals given.
pub fn instance(name: &str, lemma: &str, with: &str, given: &str) -> Value {
    json!({ "name": name, "lemma": lemma, "with": pairs(with), "given": pairs(given) })
}

/// The instances that the sum or `times` names, or the sums of those that are kept: an instance reads earlier ones only.
fn read<'i>(instances: &'i [Value], times: &[&str], sum: &str) -> Vec<&'i Value> {
    let mut sums = sum.to_owned();
    let mut kept = Vec::new();
    for instance in instances.iter().rev() {
        let name = instance["name"].as_str().unwrap_or_default();
        if times.contains(&name) || sums.contains(&format!("[{name}]")) {
            let given = instance["given"].as_object().into_iter().flat_map(Map::values);
            sums.extend(given.filter_map(Value::as_str));
            kept.push(instance);
        }
    }
    kept.reverse();
    kept
}

/// The goal, times positive facts, as a sum of products of facts, instances among them.
pub fn positivity_times(times: &[&str], instances: &[Value], sum: &str) -> Value {
    let mut body = Map::new();
    let instances = read(instances, times, sum);
    if !instances.is_empty() {
        body.insert("use".into(), json!(instances));
    }
    if !times.is_empty() {
        body.insert("times".into(), json!(times));
    }
    body.insert("sum".into(), json!(sum));
    json!({ "positivity": body })
}

/// The goal as a sum of products of facts.
pub fn positivity(instances: &[Value], sum: &str) -> Value {
    positivity_times(&[], instances, sum)
}

/// The facts contradict each other: -1, times positive facts, as a sum.
pub fn absurd_times(times: &[&str], instances: &[Value], sum: &str) -> Value {
    json!({ "absurd": positivity_times(times, instances, sum)["positivity"] })
}

/// The facts contradict each other: -1 as a sum.
pub fn absurd(instances: &[Value], sum: &str) -> Value {
    absurd_times(&[], instances, sum)
}

/// A variable at the bound that the literal `on` sets, or beyond.
pub fn cases(on: &str, variable: &str, equal: Value, beyond: Value) -> Value {
    json!({ "cases": { "on": on, "variable": variable, "equal": equal, "beyond": beyond } })
}

/// A term above, equal to or below 0.
pub fn split(name: &str, on: &str, branches: [Value; 3]) -> Value {
    let [above, equal, below] = branches;
    json!({ "split": { "name": name, "on": on, "above": above, "equal": equal, "below": below } })
}

/// Induction over a variable from the bound that the literal `on` sets; the hypothesis is called
/// `IH`, its variable `earlier`.
pub fn induction(on: &str, variable: &str, earlier: &str, base: Value, step: Value) -> Value {
    induction_named("IH", [on, variable, earlier], base, step)
}

/// As [`induction`], with a hypothesis of that name: for one inside another.
pub fn induction_named(
    hypothesis: &str,
    [on, variable, earlier]: [&str; 3],
    base: Value,
    step: Value,
) -> Value {
    json!({ "induction": {
        "on": on, "variable": variable, "hypothesis": hypothesis, "earlier": earlier, "base": base, "step": step,
    } })
}

/// A clause over integers (reals where the name ends in `:real`): `given` has `name: literal`.
pub fn clause(name: &str, vars: &str, given: &[&str], goal: &str) -> Value {
    let var = |v: &str| match v.split_once(':') {
        Some((name, sort)) => json!({ "name": name, "sort": sort }),
        None => json!({ "name": v, "sort": "integer" }),
    };
    let vars: Vec<Value> = vars.split_whitespace().map(var).collect();
    let literal =
        |g: &&str| g.split_once(": ").map(|(name, holds)| json!({ "name": name, "holds": holds }));
    let given: Vec<Value> = given.iter().filter_map(literal).collect();
    let mut body = Map::new();
    body.insert("name".into(), json!(name));
    if !vars.is_empty() {
        body.insert("for".into(), json!(vars));
    }
    if !given.is_empty() {
        body.insert("given".into(), json!(given));
    }
    body.insert("goal".into(), json!(goal));
    Value::Object(body)
}

/// A certificate in the making.
#[derive(Clone, Debug, Default)]
pub struct Sheet {
    /// What runs, if it is a protocol of the spec.
    system: Option<Value>,
    functions: Map<String, Value>,
    constants: Map<String, Value>,
    definitions: Vec<Value>,
    assumptions: Vec<Value>,
    lemmas: Vec<Value>,
    conclusions: Vec<Value>,
    proofs: Map<String, Value>,
}

impl Sheet {
    /// A certificate about a protocol of the spec with such steps, of weight eps or another for drone i in step k.
    pub fn of(protocol: &str, steps: &str, weight: Option<&str>) -> Self {
        let mut system = json!({ "protocol": protocol, "steps": steps });
        if let Some(weight) = weight {
            system["weight"] = json!(weight);
        }
        Self { system: Some(system), ..Self::default() }
    }

    /// A certificate about agents 0 to last of which nothing is known but that they are three or more: facts `n` and `last`.
    pub fn of_three() -> Self {
        let mut sheet = Self::default();
        sheet.constant("last", "integer");
        sheet.assume(clause("n", "", &[], "last - 2 >= 0"));
        sheet.assume(clause("last", "", &[], "last > 0"));
        sheet
    }

    /// Every function of so many integers to that sort is spoken of.
    pub fn function(&mut self, name: &str, arity: usize, sort: &str) {
        self.functions.insert(name.into(), json!({ "of": arity, "to": sort }));
    }

    /// Every value of that sort is spoken of.
    pub fn constant(&mut self, name: &str, sort: &str) {
        self.constants.insert(name.into(), json!(sort));
    }

    /// A function by recursion on its last argument from 0.
    pub fn define(
        &mut self,
        name: &str,
        of: &[&str],
        base: &[&str],
        step: &str,
        scale: Option<&str>,
    ) {
        let mut body = json!({ "name": name, "of": of, "from": "0", "base": base, "step": step });
        if let Some(scale) = scale {
            body["scale"] = json!(scale);
        }
        self.definitions.push(body);
    }

    /// Something assumed.
    pub fn assume(&mut self, clause: Value) {
        self.assumptions.push(clause);
    }

    /// Something proved on the way.
    pub fn lemma(&mut self, clause: Value, proof: Value) {
        self.lemmas.push(json!({ "clause": clause, "proof": proof }));
    }

    /// Something to be proved.
    pub fn conclude(&mut self, clause: Value, proof: Value) {
        if let Some(name) = clause["name"].as_str() {
            self.proofs.insert(name.to_owned(), proof);
        }
        self.conclusions.push(clause);
    }

    /// What it says.
    pub fn statement(&self) -> Value {
        let mut body = Map::new();
        if let Some(system) = &self.system {
            body.insert("system".into(), system.clone());
        }
        for (key, all) in [("functions", &self.functions), ("constants", &self.constants)] {
            if !all.is_empty() {
                body.insert(key.into(), json!(all));
            }
        }
        for (key, all) in [("definitions", &self.definitions), ("assumptions", &self.assumptions)] {
            if !all.is_empty() {
                body.insert(key.into(), json!(all));
            }
        }
        body.insert("conclusions".into(), json!(self.conclusions));
        Value::Object(body)
    }

    /// The certificate.
    pub fn certificate(&self) -> Value {
        let mut proof = Map::new();
        if !self.lemmas.is_empty() {
            proof.insert("lemmas".into(), json!(self.lemmas));
        }
        proof.insert("conclusions".into(), json!(self.proofs));
        let body = json!({ "statement": self.statement(), "proof": proof });
        json!({ "schema": "cordon-certificate/2", "certificate": { "theorem": body } })
    }
}
