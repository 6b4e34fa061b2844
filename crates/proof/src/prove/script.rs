//! Proof scripts: proofs for every N as one writes them down, kept in `scripts/`.
//!
//! An item a line, what belongs to it indented by two blanks below, `#` begins a comment:
//!
//! ```text
//! let v(i) = p(last-(i))*minor(i)            # from here on @v(t) is that text, with t for i
//! function f(k, i): real                     # any function of integers
//! constant K: integer
//! define p(i) = 1; eps*p(i)                  # p(0); then p(i+1)
//! assume OFF |- @v(K) > 0
//! lemma P(i) i: i >= 0 |- p(i) > 0           # for all i, given what has a name: the goal
//!   induction i i t                          # the literal with the bound, the variable, its name in IH (or, last, another name)
//!     by [p.0] + 1                           # the goal as a sum of products of facts
//!     by [h] + [eps]*[ih]
//!       h = p.step(i=i; from=[i])            # an instance: terms for variables; sums for its literals
//!       ih = IH(t=i; i=[i], t=0)
//! ```
//!
//! `conclude` is a lemma that the certificate states. Rules: `by` and `absurd` (below them `times`, further
//! terms that begin with a sign, and instances), `cases LITERAL VARIABLE`, `split NAME = TERM` (above, equal
//! to, below 0), `induction`; and two shapes of them: `class`, a drone `i` is the first, the last or an inner
//! one, and `active NAME DRONE`, it updates or does not. Instances and `times` above the branches of a rule
//! are there in all of them.
//!
//! A `let` without a text of its own stands for the lines below it, wherever a line is `@name(..)` alone; what is
//! below that line is then below each of them.

use std::borrow::Cow;

use serde_json::Value;

use super::lemmas::{by_activity, by_class};
use crate::certificate::theorem::{
    Sheet, absurd_times, cases, clause, induction_named, instance, positivity_times, split,
};

/// What every script may refer to.
const LIBRARY: [(&str, &str); 7] = [
    ("terms", include_str!("scripts/terms.proof")),
    ("ends", include_str!("scripts/ends.proof")),
    ("endsactive", include_str!("scripts/ends-active.proof")),
    ("increase", include_str!("scripts/increase.proof")),
    ("powers", include_str!("scripts/powers.proof")),
    ("family", include_str!("scripts/family.proof")),
    ("ordering", include_str!("scripts/ordering.proof")),
];

/// Abbreviations, the latest last: a name, its parameters, its text.
type Lets = Vec<(String, Vec<String>, String)>;

/// A line with what is indented below it.
#[derive(Clone, Debug)]
struct Node {
    text: String,
    below: Vec<Node>,
}

/// What is wrong with a script.
pub type Fault = String;

impl Sheet {
    /// Adds what a script says. `given` are abbreviations: `("v(i)", "p(i)*minor(i)")`.
    ///
    /// # Errors
    /// The script is wrong: says where.
    pub fn read(&mut self, script: &str, given: &[(&str, &str)]) -> Result<(), Fault> {
        let known = LIBRARY.iter().chain(given);
        let mut lets = known.map(|(head, body)| abbreviation(head, body)).collect();
        let terms = tree("@terms");
        terms.iter().try_for_each(|node| self.item(node, &mut lets))?;
        tree(script).iter().try_for_each(|node| self.item(node, &mut lets))
    }

    fn item(&mut self, node: &Node, lets: &mut Lets) -> Result<(), Fault> {
        if let Some(lines) = referred(node, lets)? {
            return lines.iter().try_for_each(|node| self.item(node, lets));
        }
        let said = self.plain_item(node, lets);
        said.map_err(|fault| format!("`{}`: {fault}", node.text))
    }

    fn plain_item(&mut self, node: &Node, lets: &mut Lets) -> Result<(), Fault> {
        if let Some(head) = node.text.strip_prefix("let ") {
            let lines = written(&node.below, 0);
            let (head, body) = head.split_once(" = ").unwrap_or((head, &lines));
            lets.push(abbreviation(head, body));
            return Ok(());
        }
        let text = expanded(&node.text, lets)?;
        let (word, rest) = parted(&text, " ")?;
        match word {
            "constant" => {
                let (name, sort) = parted(rest, ": ")?;
                self.constant(name, sort);
            }
            "function" => {
                let (head, sort) = parted(rest, ": ")?;
                let (name, of, _) = abbreviation(head, "");
                self.function(&name, of.len(), sort);
            }
            "define" => self.definition(rest, node, lets)?,
            "assume" => self.assume(stated(rest)?),
            "lemma" => self.lemma(stated(rest)?, proof(&node.below, &Shared::default(), lets)?),
            "conclude" => {
                self.conclude(stated(rest)?, proof(&node.below, &Shared::default(), lets)?);
            }
            _ => {
                return Err(
                    "expected let, function, constant, define, assume, lemma or conclude".into()
                );
            }
        }
        Ok(())
    }

    /// `p(i) = 1; eps*p(i)`, with `scale TERM` below.
    fn definition(&mut self, text: &str, node: &Node, lets: &Lets) -> Result<(), Fault> {
        let (head, body) = parted(text, " = ")?;
        let (base, step) = parted(body, "; ")?;
        let (name, of, _) = abbreviation(head, "");
        let scale = node.below.first().map(|n| expanded(&n.text, lets)).transpose()?;
        let scale = scale.as_deref().and_then(|s| s.strip_prefix("scale "));
        let of: Vec<&str> = of.iter().map(String::as_str).collect();
        self.define(&name, &of, &base.split(", ").collect::<Vec<_>>(), step, scale);
        Ok(())
    }
}

/// What all branches of a rule have.
#[derive(Clone, Debug, Default)]
struct Shared {
    times: Vec<String>,
    instances: Vec<Value>,
}

/// The proof that these lines are.
fn proof(nodes: &[Node], shared: &Shared, lets: &Lets) -> Result<Value, Fault> {
    match nodes {
        [one] => rule(one, shared, lets),
        _ => Err(format!("{} proofs: expected one", nodes.len())),
    }
}

fn rule(node: &Node, shared: &Shared, lets: &Lets) -> Result<Value, Fault> {
    if let Some(lines) = referred(node, lets)? {
        return proof(&lines, shared, lets);
    }
    let text = expanded(&node.text, lets)?;
    let (word, rest) = text.split_once(' ').unwrap_or((&text, ""));
    let mut sum = rest.trim_end().to_owned();
    let mut shared = shared.clone();
    let mut branches = Vec::new();
    for below in written_out(&node.below, lets)? {
        let line = expanded(&below.text, lets)?;
        if line.starts_with(['+', '-']) {
            sum = format!("{sum} {line}");
        } else if let Some(times) = line.strip_prefix("times ") {
            shared.times.extend(times.split(", ").map(str::to_owned));
        } else if let Some((name, (lemma, with))) = named_instance(&line) {
            let (with, given) = with.split_once(';').unwrap_or((with, ""));
            shared.instances.push(instance(name, lemma, with.trim(), given.trim()));
        } else {
            branches.push(below);
        }
    }
    let leaf = |of: fn(&[&str], &[Value], &str) -> Value| {
        let times: Vec<&str> = shared.times.iter().map(String::as_str).collect();
        of(&times, &shared.instances, &sum)
    };
    let words: Vec<&str> = rest.split(' ').collect();
    let branch = |node: &Node| rule(node, &shared, lets);
    let proofs = branches.iter().map(branch).collect::<Result<Vec<_>, _>>()?;
    match (word, words.as_slice(), proofs.as_slice()) {
        ("by", _, []) => Ok(leaf(positivity_times)),
        ("absurd", _, []) => Ok(leaf(absurd_times)),
        ("class", _, [first, last, inner]) => {
            Ok(by_class(first.clone(), last.clone(), inner.clone()))
        }
        ("split", _, [above, equal, below]) => {
            let (name, term) = parted(rest, " = ")?;
            Ok(split(name, term, [above.clone(), equal.clone(), below.clone()]))
        }
        ("cases", [on, variable], [equal, beyond]) => {
            Ok(cases(on, variable, equal.clone(), beyond.clone()))
        }
        ("induction", [on, variable, earlier, name @ ..], [base, step]) if name.len() <= 1 => {
            let name = name.first().unwrap_or(&"IH");
            Ok(induction_named(name, [on, variable, earlier], base.clone(), step.clone()))
        }
        ("active", [name, ..], [on, off]) => {
            let drone = rest.get(name.len() + 1..).unwrap_or_default();
            Ok(by_activity(name, drone, on.clone(), off.clone()))
        }
        _ => Err(format!("`{}`: no rule with such branches", node.text)),
    }
}

/// The lines that a line `@name(..)` stands for.
fn referred(node: &Node, lets: &Lets) -> Result<Option<Vec<Node>>, Fault> {
    let Some(after) = node.text.strip_prefix('@') else { return Ok(None) };
    let (body, rest) = abbreviated(after, lets)?;
    if !rest.is_empty() {
        return Ok(None);
    }
    let mut lines = tree(&body);
    for line in &mut lines {
        line.below.splice(0..0, node.below.iter().cloned());
    }
    Ok(Some(lines))
}

/// The lines, with what references among them stand for.
fn written_out(nodes: &[Node], lets: &Lets) -> Result<Vec<Node>, Fault> {
    let mut all = Vec::new();
    for node in nodes {
        match referred(node, lets)? {
            Some(lines) => all.extend(written_out(&lines, lets)?),
            None => all.push(node.clone()),
        }
    }
    Ok(all)
}

/// `name = LEMMA(terms; sums)`.
fn named_instance(line: &str) -> Option<(&str, (&str, &str))> {
    let (name, call) = line.split_once(" = ")?;
    Some((name, call.strip_suffix(')')?.split_once('(')?)).filter(|_| !name.contains(' '))
}

/// `NAME(i s:real) a: i >= 0, b: i <= 3 |- goal`.
fn stated(text: &str) -> Result<Value, Fault> {
    let (head, goal) = parted(text, "|- ")?;
    let end = head.find([' ', '(']).unwrap_or(head.len());
    let (name, rest) = head.split_at(end);
    let (vars, given) = match rest.strip_prefix('(') {
        Some(rest) => parted(rest, ")")?,
        None => ("", rest),
    };
    let given: Vec<&str> = given.trim().split(", ").filter(|g| !g.is_empty()).collect();
    Ok(clause(name, vars, &given, goal))
}

fn parted<'t>(text: &'t str, by: &str) -> Result<(&'t str, &'t str), Fault> {
    text.split_once(by).ok_or_else(|| format!("`{text}`: expected `{by}`"))
}

fn abbreviation(head: &str, body: &str) -> (String, Vec<String>, String) {
    let (name, parameters) = head.split_once('(').unwrap_or((head, ""));
    let parameters = parameters.trim_end_matches(')').split(',').map(|p| p.trim().to_owned());
    (name.to_owned(), parameters.filter(|p| !p.is_empty()).collect(), body.to_owned())
}

/// The text with its abbreviations written out.
fn expanded<'t>(text: &'t str, lets: &Lets) -> Result<Cow<'t, str>, Fault> {
    let Some((before, after)) = text.split_once('@') else { return Ok(Cow::Borrowed(text)) };
    let (body, rest) = abbreviated(after, lets)?;
    let (body, rest) = (expanded(&body, lets)?, expanded(rest, lets)?);
    Ok(Cow::Owned(format!("{before}{body}{rest}")))
}

/// What the abbreviation at the beginning stands for, and what follows it.
fn abbreviated<'t>(text: &'t str, lets: &Lets) -> Result<(String, &'t str), Fault> {
    let (name, rest) = text.split_at(word_end(text));
    let known = lets.iter().rev().find(|(n, ..)| n == name);
    let (_, parameters, body) = known.ok_or_else(|| format!("@{name}: expected a `let`"))?;
    if parameters.is_empty() {
        return Ok((body.clone(), rest));
    }
    let end = closing(rest).ok_or_else(|| format!("@{name}: expected arguments"))?;
    let inside = expanded(rest.get(1..end).unwrap_or_default(), lets)?;
    let arguments = arguments(&inside);
    if arguments.len() != parameters.len() {
        return Err(format!("@{name}: expected {} arguments", parameters.len()));
    }
    let after = rest.get(end + 1..).unwrap_or_default();
    Ok((substituted(body, parameters, &arguments), after))
}

/// Where the word at the beginning ends.
fn word_end(text: &str) -> usize {
    text.find(|c: char| !c.is_alphanumeric()).unwrap_or(text.len())
}

/// Where the parenthesis at the beginning is closed.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    text.char_indices().find_map(|(i, c)| {
        depth = match c {
            '(' => depth + 1,
            ')' => depth.checked_sub(1)?,
            _ => depth,
        };
        (depth == 0).then_some(i)
    })
}

/// What commas outside parentheses part.
fn arguments(text: &str) -> Vec<&str> {
    let (mut depth, mut from, mut all) = (0_i32, 0, Vec::new());
    for (i, c) in text.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            ',' if depth == 0 => {
                all.extend(text.get(from..i));
                from = i + 1;
            }
            _ => {}
        }
    }
    all.extend(text.get(from..));
    all.into_iter().map(str::trim).collect()
}

fn substituted(body: &str, parameters: &[String], arguments: &[&str]) -> String {
    let (mut rest, mut text) = (body, String::new());
    while let Some(first) = rest.chars().next() {
        let end = word_end(rest).max(first.len_utf8());
        let (word, after) = rest.split_at(end);
        let place = parameters.iter().position(|p| p == word);
        text += place.and_then(|i| arguments.get(i).copied()).unwrap_or(word);
        rest = after;
    }
    text
}

/// The lines as text again.
fn written(nodes: &[Node], depth: usize) -> String {
    let line = |n: &Node| format!("{:depth$}{}\n{}", "", n.text, written(&n.below, depth + 2));
    nodes.iter().map(line).collect()
}

/// The lines by their indentation.
fn tree(text: &str) -> Vec<Node> {
    let lines = text.lines().map(|line| line.split('#').next().unwrap_or_default().trim_end());
    let lines = lines.filter(|line| !line.is_empty());
    let lines: Vec<(usize, &str)> =
        lines.map(|l| (l.len() - l.trim_start().len(), l.trim_start())).collect();
    nodes(&lines)
}

fn nodes(mut lines: &[(usize, &str)]) -> Vec<Node> {
    let mut all = Vec::new();
    while let Some(((depth, text), rest)) = lines.split_first() {
        let deeper = rest.iter().take_while(|(d, _)| d > depth).count();
        let (below, after) = rest.split_at(deeper);
        all.push(Node { text: (*text).to_owned(), below: nodes(below) });
        lines = after;
    }
    all
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::certificate::theorem::induction;

    fn read(script: &str) -> Result<Value, Fault> {
        let mut sheet = Sheet::of("coverage", "full", None);
        sheet.read(script, &[("half", "1/2")])?;
        Ok(sheet.certificate())
    }

    const SCRIPT: &str = "\
let f(i, j) = (i)*x(j,i)   # a comment
lemma A(i s:real) i: i >= 0, s: s*s = 1 |- @f(g(i,0), i+1) >= @half
  induction i i t
    by [b]
      + [h]
      times eps
      h = B(i=i, j=x(i,0); i=[i] + 1)
    split q = i - 1
      h = B()
      absurd [h]
      by 2*[g]
        g = C
      by [h]
";

    #[test]
    fn a_script_says_what_the_rules_take() {
        let found = read(&SCRIPT.replace("        g = C\n", "        g = C()\n")).unwrap();
        let lemma = &found["certificate"]["theorem"]["proof"]["lemmas"][0];
        let wanted =
            clause("A", "i s:real", &["i: i >= 0", "s: s*s = 1"], "(g(i,0))*x(i+1,g(i,0)) >= 1/2");
        assert_eq!(lemma["clause"], wanted);
        let h = instance("h", "B", "i=i, j=x(i,0)", "i=[i] + 1");
        let base = positivity_times(&["eps"], &[h], "[b] + [h]");
        let [h, g] = [instance("h", "B", "", ""), instance("g", "C", "", "")];
        let step = split(
            "q",
            "i - 1",
            [
                absurd_times(&[], std::slice::from_ref(&h), "[h]"),
                // Nobody reads h.
                positivity_times(&[], &[g], "2*[g]"),
                positivity_times(&[], &[h], "[h]"),
            ],
        );
        assert_eq!(lemma["proof"], induction("i", "i", "t", base, step));
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (from, to, wanted) in [
            ("@half", "@third", "@third: expected a `let`"),
            ("@f(g(i,0), i+1)", "@f(i)", "@f: expected 2 arguments"),
            ("|-", "->", "expected `|- `"),
            ("lemma", "axiom", "expected let, function, constant"),
            ("      absurd [h]\n", "", "no rule with such branches"),
            ("        g = C\n", "        by 3\n", "`by 2*[g]`: no rule"),
            ("    by [b]", "    by [b]\n    by 1", "no rule with such branches"),
        ] {
            let said = read(&SCRIPT.replacen(from, to, 1)).unwrap_err();
            assert!(said.contains(wanted), "{said}");
        }
    }
}
