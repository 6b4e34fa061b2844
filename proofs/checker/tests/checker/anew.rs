//! Whether a certificate is a proof, decided without the checker's help:
//! * contraction, growth and ellipsoid by formulas written out here, the last on forms whose coefficients are read off
//!   their values;
//! * a refutation by running the protocol, written out here, and asking the theorem's predicates.

use std::collections::BTreeMap;

use cordon_spec::theorems::{Form, Setting, Subject, Theorem, Truth, Verdict};
use num_rational::BigRational as Rational;
use num_traits::{One, Signed, Zero};
use serde_json::{Value, json};

pub fn rational(text: &str) -> Option<Rational> {
    let value: Rational = text.parse().ok()?;
    (value.to_string() == text).then_some(value)
}

pub fn is_proof(page: &Value) -> bool {
    let (kind, body) = page["certificate"].as_object().unwrap().iter().next().unwrap();
    match kind.as_str() {
        "contraction" => {
            vector(body, |aw, w| aw <= q(&body["rate"]) * w) && {
                let rate = q(&body["rate"]);
                !rate.is_negative() && rate < Rational::one()
            }
        }
        "growth" => vector(body, |aw, w| aw >= w.clone()),
        "refutation" => refutation(body),
        "counterexample" => counterexample(body),
        "ellipsoid" => ellipsoid(body),
        _ => false,
    }
}

fn q(number: &Value) -> Rational {
    rational(number.as_str().unwrap()).unwrap()
}

fn qs(numbers: &Value) -> Vec<Rational> {
    numbers.as_array().unwrap().iter().map(q).collect()
}

/// |1-2eps| w_i + |eps| (w_{i-1} + w_{i+1}) against w_i.
fn vector(body: &Value, holds: impl Fn(Rational, &Rational) -> bool) -> bool {
    let (eps, w) = (q(&body["eps"]), qs(&body["vector"]));
    let two = Rational::from_integer(2.into());
    let at =
        |i: usize| i.checked_sub(1).and_then(|i| w.get(i)).cloned().unwrap_or_else(Rational::zero);
    body["drones"].as_u64().unwrap() == w.len() as u64 + 2
        && w.iter().all(Signed::is_positive)
        && (1..=w.len()).all(|i| {
            let own = (Rational::one() - &two * &eps).abs() * at(i);
            holds(own + eps.abs() * (at(i - 1) + at(i + 1)), &at(i))
        })
}

type Values = BTreeMap<String, Rational>;

/// The value of a sum of products of numbers, names and brackets.
fn value(text: &str, values: &Values) -> Rational {
    fn split<'t>(text: &'t str, signs: &[char]) -> Option<(&'t str, char, &'t str)> {
        let mut depth = 0;
        let at = text.char_indices().rev().find(|(_, c)| {
            depth += i32::from(*c == ')') - i32::from(*c == '(');
            depth == 0 && signs.contains(c)
        });
        at.map(|(at, c)| (&text[..at], c, &text[at + 1..]))
    }
    let text = text.trim();
    if let Some((left, sign, right)) = split(text, &['+', '-']) {
        let left = if left.trim().is_empty() { Rational::zero() } else { value(left, values) };
        let right = value(right, values);
        return if sign == '+' { left + right } else { left - right };
    }
    if let Some((left, _, right)) = split(text, &['*']) {
        return value(left, values) * value(right, values);
    }
    match text.strip_prefix('(') {
        Some(inside) => value(inside.strip_suffix(')').unwrap(), values),
        None => rational(text).unwrap_or_else(|| values[text].clone()),
    }
}

/// An affine function by its constant and its coefficients.
type Affine = Vec<Rational>;

fn affine(names: &[String], f: impl Fn(&Values) -> Rational) -> Affine {
    let at = |one: Option<&String>| {
        f(&names
            .iter()
            .map(|n| (n.clone(), Rational::from_integer(i32::from(one == Some(n)).into())))
            .collect())
    };
    let constant = at(None);
    let rest = names.iter().map(|n| at(Some(n)) - &constant);
    std::iter::once(constant.clone()).chain(rest).collect()
}

/// Left minus right, and the relation.
fn literal(names: &[String], text: &str) -> (Affine, &'static str) {
    for (sign, relation, turned) in [
        (">=", ">=", false),
        ("<=", ">=", true),
        (">", ">", false),
        ("<", ">", true),
        ("=", "=", false),
    ] {
        if let Some((l, r)) = text.split_once(sign) {
            let (l, r) = if turned { (r, l) } else { (l, r) };
            return (affine(names, |v| value(l, v) - value(r, v)), relation);
        }
    }
    panic!("{text}")
}

fn words(list: &Value) -> Vec<String> {
    list.as_array().unwrap().iter().map(|w| w.as_str().unwrap().to_owned()).collect()
}

/// At each end of the one parameter, if there is one, what a mode makes of a function of the state.
fn after(system: &Value, mode: &str, f: &Affine) -> Vec<Affine> {
    let names = words(&system["state"]);
    let rows = &system["modes"][mode];
    let parameter = system.get("parameters").and_then(|p| p.as_object().unwrap().iter().next());
    let ends = parameter.map_or(vec![None], |(name, ends)| {
        qs(ends).into_iter().map(|end| Some((name.clone(), end))).collect()
    });
    let at = |end: &Option<(String, Rational)>| {
        affine(&names, |state| {
            let mut all = state.clone();
            all.extend(end.clone());
            let next = |n: &String| {
                rows.get(n).map_or(state[n].clone(), |row| value(row.as_str().unwrap(), &all))
            };
            names.iter().zip(&f[1..]).fold(f[0].clone(), |sum, (n, c)| sum + c * next(n))
        })
    };
    let mut images: Vec<Affine> = ends.iter().map(at).collect();
    images.dedup();
    images
}

fn ranges(system: &Value) -> bool {
    let all = system
        .get("parameters")
        .map(|p| p.as_object().unwrap().values().map(qs).collect::<Vec<_>>());
    all.unwrap_or_default().iter().all(|ends| ends[0] <= ends[1])
}

/// The run of a linear system, and whether it starts where it should and ends where the claim fails.
fn counterexample(body: &Value) -> bool {
    let system = &body["system"];
    let names = words(&system["state"]);
    let pairs = |all: &Value| -> Values {
        let all = all.as_object().into_iter().flatten();
        all.map(|(name, number)| (name.clone(), q(number))).collect()
    };
    let within = |values: &Values| {
        values.iter().all(|(name, v)| {
            let ends = qs(&system["parameters"][name]);
            ends[0] <= *v && *v <= ends[1]
        })
    };
    let mut state: Values = names.iter().cloned().zip(qs(&body["start"])).collect();
    let holds = |text: &Value, state: &Values| {
        let (form, relation) = literal(&names, text.as_str().unwrap());
        let sum =
            names.iter().zip(&form[1..]).fold(form[0].clone(), |sum, (n, c)| sum + c * &state[n]);
        match relation {
            "=" => sum.is_zero(),
            ">" => sum.is_positive(),
            _ => !sum.is_negative(),
        }
    };
    let constants = pairs(&body["with"]);
    let started = body["assumptions"].as_array().unwrap().iter().all(|a| holds(a, &state));
    let mut sound = ranges(system) && started && within(&constants);
    for step in body["steps"].as_array().unwrap() {
        let mut now = pairs(&step["with"]);
        sound &= within(&now);
        now.extend(constants.clone());
        now.extend(state.clone());
        for (name, row) in system["modes"][step["by"].as_str().unwrap()].as_object().unwrap() {
            state.insert(name.clone(), value(row.as_str().unwrap(), &now));
        }
    }
    sound && !holds(&body["claim"], &state)
}

/// Determinant by the first row.
fn determinant(m: &[Vec<Rational>]) -> Rational {
    let Some((first, rest)) = m.split_first() else { return Rational::one() };
    let minor = |j: usize| {
        let row = |r: &Vec<Rational>| {
            r.iter().enumerate().filter(|(k, _)| *k != j).map(|(_, x)| x.clone()).collect()
        };
        determinant(&rest.iter().map(row).collect::<Vec<_>>())
    };
    first.iter().enumerate().fold(Rational::zero(), |sum, (j, x)| {
        if j % 2 == 0 { sum + x * minor(j) } else { sum - x * minor(j) }
    })
}

/// Whether all principal minors are >= 0.
fn semidefinite(m: &[Vec<Rational>]) -> bool {
    (1..1usize << m.len()).all(|set| {
        let chosen: Vec<usize> = (0..m.len()).filter(|i| set >> i & 1 == 1).collect();
        let row = |i: &usize| chosen.iter().map(|j| m[*i][*j].clone()).collect();
        !determinant(&chosen.iter().map(row).collect::<Vec<_>>()).is_negative()
    })
}

/// The inequality at each end of the one parameter and of each edge; claims at the centre and, with a root in
/// rationals, on the way: of a quadratic the lowest value.
pub fn ellipsoid(body: &Value) -> bool {
    let system = &body["system"];
    let names = words(&system["state"]);
    let n = names.len();
    let node = |name: &str| -> (Vec<Rational>, Vec<Vec<Rational>>) {
        let low = &body["nodes"][name]["matrix"];
        let row = |i: usize| (0..n).map(|j| q(&low[i.max(j)][i.min(j)])).collect();
        (qs(&body["nodes"][name]["centre"]), (0..n).map(row).collect())
    };
    let bordered = |m: Vec<Vec<Rational>>, column: Vec<Rational>, corner: Rational| {
        let mut all: Vec<Vec<Rational>> = m
            .into_iter()
            .zip(&column)
            .map(|(r, x)| r.into_iter().chain([x.clone()]).collect())
            .collect();
        all.push(column.into_iter().chain([corner]).collect());
        all
    };
    let positive = body["nodes"].as_object().unwrap().keys().all(|name| {
        let (_, m) = node(name);
        semidefinite(&m) && determinant(&m).is_positive()
    });
    let started = words(&body["start"]).iter().all(|name| {
        let (c, m) = node(name);
        body["points"].as_array().unwrap().iter().all(|p| {
            let away = qs(p).iter().zip(&c).map(|(p, c)| p - c).collect();
            semidefinite(&bordered(m.clone(), away, Rational::one()))
        })
    });
    let edges = body["edges"].as_array().unwrap();
    let kept = edges.iter().all(|e| {
        let [from, to, by] = ["from", "to", "by"].map(|f| e[f].as_str().unwrap());
        let time = e.get("time").map(q);
        if time.as_ref().is_some_and(|t| !t.is_positive()) {
            return false;
        }
        let rate = time.as_ref().map_or(Rational::zero(), |t| Rational::one() / t);
        let ([(c0, q0), (c1, q1)], decay) = ([node(from), node(to)], q(&e["decay"]));
        // What a mode makes of each variable, at each end; a variable that it does not name stands.
        let mut stands = system.clone();
        for name in &names {
            let rows = stands["modes"][by].as_object_mut().unwrap();
            rows.entry(name.clone()).or_insert(json!("0"));
        }
        let int = |n: usize| Rational::from_integer(n.into());
        let images: Vec<Vec<Affine>> = (0..n)
            .map(|i| after(&stands, by, &(0..=n).map(|j| int(usize::from(j == i + 1))).collect()))
            .collect();
        let vertices = images.iter().map(Vec::len).max().unwrap();
        (0..vertices).all(|v| {
            let row = |i: usize| images[i].get(v).unwrap_or(&images[i][0]);
            [(&c0, &q0), (&c1, &q1)].into_iter().take(if time.is_some() { 2 } else { 1 }).all(
                |(c, m)| {
                    let aq = |i: usize, j: usize| -> Rational {
                        (0..n).map(|k| &row(i)[k + 1] * &m[k][j]).sum()
                    };
                    let entry = |i: usize, j: usize| {
                        &rate * (&q1[i][j] - &q0[i][j]) - aq(i, j) - aq(j, i) - &decay * &m[i][j]
                    };
                    let drift = |i: usize| -> Rational {
                        &row(i)[0] + (0..n).map(|k| &row(i)[k + 1] * &c[k]).sum::<Rational>()
                    };
                    let matrix = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
                    let column = (0..n).map(|i| &rate * (&c1[i] - &c0[i]) - drift(i)).collect();
                    semidefinite(&bordered(matrix, column, decay.clone()))
                },
            )
        })
    });
    let held = words(&body["claims"]).iter().all(|text| {
        let (form, sign) = literal(&names, text);
        let reached = |x: &Rational| x.is_positive() || (x.is_zero() && sign == ">=");
        let at = |name: &str| {
            let (c, m) = node(name);
            let g = (0..n).fold(form[0].clone(), |sum, i| sum + &form[i + 1] * &c[i]);
            let wide: Rational =
                (0..n * n).map(|k| &form[k / n + 1] * &m[k / n][k % n] * &form[k % n + 1]).sum();
            (g, wide)
        };
        let nodes = body["nodes"].as_object().unwrap().keys().all(|name| {
            let (g, wide) = at(name);
            reached(&g) && reached(&(&g * &g - wide))
        });
        let ways = edges.iter().filter(|e| e.get("time").is_some()).all(|e| {
            let ((g0, w0), (g1, w1)) =
                (at(e["from"].as_str().unwrap()), at(e["to"].as_str().unwrap()));
            // (g0 + s dg)^2 - w0 - s dw, lowest at s = (dw - 2 g0 dg) / (2 dg^2).
            let (dg, dw, two) = (&g1 - &g0, &w1 - &w0, Rational::from_integer(2.into()));
            if dg.is_zero() {
                return true;
            }
            let s = (&dw - &two * &g0 * &dg) / (&two * &dg * &dg);
            let g = &g0 + &s * &dg;
            !s.is_positive() || s >= Rational::one() || reached(&(&g * &g - &w0 - &s * &dw))
        });
        nodes && ways
    });
    ranges(system) && positive && started && kept && held
}

fn refutation(body: &Value) -> bool {
    let named = |t: &Theorem| body["theorem"] == t.number();
    let theorem = *Theorem::ALL.iter().find(|t| named(t)).unwrap();
    let form = *Form::ALL.iter().find(|f| body["form"] == f.label()).unwrap();
    let (min, max, eps) = (q(&body["min"]), q(&body["max"]), q(&body["eps"]));
    let start = qs(&body["start"]);
    let setting = Setting {
        min: min.clone(),
        max: max.clone(),
        eps_num: eps.clone(),
        eps_den: Rational::one(),
    };
    let hypothesis = theorem.hypothesis(form);
    let met = match body.get("weights") {
        Some(_) => hypothesis.starts.contains(&setting, &start),
        None => hypothesis.met_by(&setting, &start),
    };
    let (n, step) = (start.len(), usize::try_from(body["step"].as_u64().unwrap()).unwrap());
    let steps = step + theorem.span(form, n);
    let schedules = ["activation", "delay"].map(|k| body.get(k).and_then(Value::as_array));
    if met != Truth::True || min >= max || schedules.iter().flatten().any(|s| s.len() != steps) {
        return false;
    }
    let mut run = vec![start];
    for t in 0..steps {
        let age = |i: usize, j: usize| -> Option<usize> {
            let all = schedules[1]?[t].as_array().unwrap();
            let entry = all.iter().find(|d| d["drone"] == i && d["sees"] == j)?;
            usize::try_from(entry["age"].as_u64().unwrap()).ok()
        };
        let active =
            |i: usize| schedules[0].is_none_or(|s| s[t].as_array().unwrap().contains(&json!(i)));
        if !sound(schedules, t, n) {
            return false;
        }
        let see = |i: usize, j: usize| run[t - age(i, j).unwrap_or(0)][j].clone();
        let two = Rational::from_integer(2.into());
        let next = (0..n)
            .map(|i| match i {
                _ if !active(i) => run[t][i].clone(),
                0 => min.clone(),
                _ if i + 1 == n => max.clone(),
                _ => {
                    &eps * (see(i, i - 1) + see(i, i + 1))
                        + (Rational::one() - &two * &eps) * &run[t][i]
                }
            })
            .collect();
        run.push(next);
    }
    let Verdict::Violated(v) = theorem.conclusion(form, &setting, &run[step..]) else {
        return false;
    };
    body["violation"]
        == match v.subject {
            Subject::Pair(i) => json!({ "step": v.step, "subject": "pair", "at": i }),
            Subject::Drone(i) => json!({ "step": v.step, "subject": "drone", "at": i }),
            Subject::Sum => json!({ "step": v.step, "subject": "sum" }),
            Subject::Energy => json!({ "step": v.step, "subject": "energy" }),
        }
}

/// Ascending entries about drones that there are, and messages that had been sent.
fn sound(schedules: [Option<&Vec<Value>>; 2], t: usize, n: usize) -> bool {
    let ascending = |rows: Vec<Vec<u64>>| rows.windows(2).all(|w| w[0] < w[1]);
    let whole = |v: &Value| v.as_u64().unwrap();
    let (n, t) = (n as u64, t);
    let active = schedules[0].is_none_or(|s| {
        let drones: Vec<u64> = s[t].as_array().unwrap().iter().map(whole).collect();
        drones.iter().all(|&i| i < n) && ascending(drones.iter().map(|&i| vec![i]).collect())
    });
    active
        && schedules[1].is_none_or(|s| {
            let entries: Vec<Vec<u64>> = s[t]
                .as_array()
                .unwrap()
                .iter()
                .map(|d| ["drone", "sees", "age"].iter().map(|f| whole(&d[f])).collect())
                .collect();
            let pairs = entries.iter().map(|d| d[..2].to_vec()).collect();
            ascending(pairs)
                && entries.iter().all(|d| d[0] < n && d[1] < n && (1..=t as u64).contains(&d[2]))
        })
}
