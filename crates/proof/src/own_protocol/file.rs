//! Protocol files (TOML).

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

use serde::Deserialize;
use toml::{Spanned, Value};

use super::expression::{Expression, SyntaxError, parse_claim};
use super::{OwnProtocol, Predicate, Update};
use cordon_core::files::{self, Limit};
use cordon_core::{Error, Rational, Result, range};
use cordon_run::scenario::Topology;
use cordon_run::scenario::document::document;
use cordon_run::scenario::file::Source;

/// A protocol file as written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    title: Option<String>,
    drones: Spanned<usize>,
    eps: Option<Spanned<Value>>,
    graph: Option<Spanned<Value>>,
    weight: Option<Spanned<Value>>,
    weights: Option<Spanned<Vec<Spanned<Value>>>>,
    start: Option<Vec<Spanned<String>>>,
    claim: Spanned<Vec<Spanned<String>>>,
    #[serde(default)]
    update: BTreeMap<Spanned<String>, Spanned<Value>>,
}

/// Most drones: the certificate format takes 200 variables.
const MOST: usize = 200;

/// Most comparisons in the claims, and as many in the assumptions on the start.
const MOST_COMPARISONS: usize = 200;

/// Reads a protocol file.
///
/// # Errors
/// The file cannot be read, is no TOML, has an unknown key, or says something that is not
/// linear: the message has file, line, column and key.
pub fn read(path: &Path) -> Result<OwnProtocol> {
    parse(&path.display().to_string(), &files::read_text(path, Limit::PROTOCOL)?)
}

/// Reads a protocol from text; `name` stands for the file in messages.
///
/// # Errors
/// As for [`read`].
pub fn parse(name: &str, text: &str) -> Result<OwnProtocol> {
    let source = Source { name, text };
    let (doc, _): (Document, _) = document(&source)?;
    let count = *doc.drones.get_ref();
    if !(1..=MOST).contains(&count) {
        let message = format!("drones: `{count}`: expected a number from 1 to {MOST}");
        return Err(source.error(&doc.drones.span(), &message));
    }
    let reader = Reader { source: &source, count, has_eps: doc.eps.is_some() };
    let eps = doc.eps.as_ref().map(|eps| reader.eps(eps)).transpose()?;
    let graph = doc.graph.as_ref().map(|g| reader.graph(g)).transpose()?;
    let updates = reader.updates(&doc, graph.is_some())?;
    let claims = reader.claims("claim", doc.claim.get_ref())?;
    if claims.is_empty() {
        return Err(source.error(&doc.claim.span(), "claim: expected at least one"));
    }
    let starts = match &doc.start {
        Some(list) => reader.claims("start", list)?,
        None => claims.clone(),
    };
    let title = doc.title.unwrap_or_else(|| name.to_owned());
    Ok(OwnProtocol { title, count, eps, graph, updates, starts, claims })
}

struct Reader<'s> {
    source: &'s Source<'s>,
    count: usize,
    has_eps: bool,
}

impl Reader<'_> {
    fn eps(&self, value: &Spanned<Value>) -> Result<(Rational, Rational)> {
        let Value::String(text) = value.get_ref() else {
            let number = self.source.number("eps", value)?;
            return Ok((number.clone(), number));
        };
        let fail = |e: Error| self.source.error(&value.span(), &e.to_string());
        range::closed("eps", text).map_err(fail)
    }

    fn graph(&self, value: &Spanned<Value>) -> Result<Topology> {
        let (name, edges) = self.source.graph(value)?;
        let graph = match (name, edges) {
            (Some(name), _) => Topology::named(&name, self.count),
            (None, edges) => Topology::from_edges(&edges.unwrap_or_default(), self.count),
        };
        graph.map_err(|e| self.source.error(&value.span(), &e.to_string()))
    }

    /// One update a drone: the pull of its neighbours, unless `[update]` has another.
    fn updates(&self, doc: &Document, has_graph: bool) -> Result<Vec<Update>> {
        let mut updates = self.pulls(doc)?;
        for (key, value) in &doc.update {
            let name = key.get_ref();
            let drone = name.strip_prefix('x').and_then(|i| i.parse::<usize>().ok());
            let Some(slot) = drone.and_then(|i| updates.get_mut(i)) else {
                let last = self.count - 1;
                let message = format!("update: `{name}` is no drone: expected x0 to x{last}");
                return Err(self.source.error(&key.span(), &message));
            };
            let field = format!("update.{name}");
            let expression = self.expression(&field, value)?;
            self.check_affine(&field, &value.span(), &expression, true)?;
            *slot = Some(Update::Own(expression));
        }
        let mut complete = Vec::new();
        for (i, update) in updates.into_iter().enumerate() {
            let pulled = matches!(update, Some(Update::Pulled(_)));
            match update {
                Some(update) if has_graph || !pulled => complete.push(update),
                _ => {
                    return Err(Error::input(format!(
                        "{}: drone {i} has no update: expected `update.x{i}`, or `graph` and `weight`",
                        self.source.name
                    )));
                }
            }
        }
        Ok(complete)
    }

    fn pulls(&self, doc: &Document) -> Result<Vec<Option<Update>>> {
        let pulled = |field: &str, value: &Spanned<Value>| -> Result<Option<Update>> {
            let weight = self.expression(field, value)?;
            self.check_affine(field, &value.span(), &weight, false)?;
            Ok(Some(Update::Pulled(weight)))
        };
        match (&doc.weight, &doc.weights) {
            (None, None) => Ok(vec![None; self.count]),
            (Some(weight), None) => Ok(vec![pulled("weight", weight)?; self.count]),
            (None, Some(weights)) => {
                let list = weights.get_ref();
                if list.len() != self.count {
                    let message = format!(
                        "weights: {} entries: expected {}, one a drone",
                        list.len(),
                        self.count
                    );
                    return Err(self.source.error(&weights.span(), &message));
                }
                list.iter().map(|w| pulled("weights", w)).collect()
            }
            (Some(weight), Some(_)) => {
                let message = "weight and weights: expected one of them";
                Err(self.source.error(&weight.span(), message))
            }
        }
    }

    fn expression(&self, field: &str, value: &Spanned<Value>) -> Result<Expression> {
        match value.get_ref() {
            Value::String(text) => Expression::parse(text, self.count)
                .map_err(|fault| self.fault(field, &value.span(), &fault)),
            _ => self.source.number(field, value).map(Expression::Number),
        }
    }

    fn fault(&self, field: &str, span: &Range<usize>, fault: &SyntaxError) -> Error {
        // Inside the quotation marks; escapes have no use in expressions.
        let at = span.start + 1 + fault.at;
        self.source.error(&(at..span.end), &format!("{field}: {}", fault.message))
    }

    fn claims(&self, field: &str, list: &[Spanned<String>]) -> Result<Vec<Predicate>> {
        let mut claims = Vec::new();
        for written in list {
            let comparisons = parse_claim(written.get_ref(), self.count)
                .map_err(|fault| self.fault(field, &written.span(), &fault))?;
            for comparison in comparisons {
                self.check_claim(field, &written.span(), &comparison.difference)?;
                claims.push(Predicate { text: written.get_ref().clone(), comparison });
            }
            if claims.len() > MOST_COMPARISONS {
                let message = format!("{field}: expected at most {MOST_COMPARISONS} comparisons");
                return Err(self.source.error(&written.span(), &message));
            }
        }
        Ok(claims)
    }

    /// At most the first power of eps, and of the positions the first or (for weights) none.
    fn check_affine(
        &self,
        field: &str,
        span: &Range<usize>,
        expression: &Expression,
        positions: bool,
    ) -> Result<()> {
        let fail = |message: &str| Err(self.source.error(span, &format!("{field}: {message}")));
        let degree = expression.degree();
        if degree.eps > 0 && !self.has_eps {
            return fail("expected no eps, or a key `eps` with its value or range");
        }
        if degree.eps > 1 {
            return fail("expected no higher power of eps than the first");
        }
        if degree.positions > 0 && !positions {
            return fail("expected no positions");
        }
        if degree.positions > 1 {
            return fail("expected no product of positions");
        }
        Ok(())
    }

    fn check_claim(&self, field: &str, span: &Range<usize>, difference: &Expression) -> Result<()> {
        let degree = difference.degree();
        if degree.eps > 0 {
            return Err(self.source.error(span, &format!("{field}: expected no eps")));
        }
        if degree.positions > 1 {
            let message = format!("{field}: expected no product of positions");
            return Err(self.source.error(span, &message));
        }
        Ok(())
    }
}
