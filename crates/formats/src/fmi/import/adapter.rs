//! Mapping between the variables of a unit and those of an FMU.

use std::collections::BTreeMap;

use crate::fmi::archive::Fmu;
use crate::fmi::model_description::{FmuVariable, REALS};
use crate::fmi::units::{Conversion, Si};
use cordon_core::{Error, Rational, Result, exact};
use cordon_cosim::unit::{Causality, Kind, Unit, Value, Variable};
use cordon_run::scenario::{Parameter, Substitute};
use num_traits::ToPrimitive;

/// A variable of a unit and the FMU's variable that stands for it.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(not(feature = "fmi-import"), allow(dead_code, reason = "read where FMUs run"))]
pub(super) struct Counterpart {
    /// Index in the unit's table.
    pub index: usize,
    /// Causality in our unit: input, output or parameter.
    pub causality: Causality,
    /// The type of its values in our unit.
    pub kind: Kind,
    /// The variable of the FMU that stands for it.
    pub theirs: FmuVariable,
    /// From the FMU's physical unit to the unit's, where they differ.
    pub conversion: Option<Conversion>,
}

/// The counterparts, and notes for the user.
pub(super) struct Map {
    pub counterparts: Vec<Counterpart>,
    /// Parameters of the FMU that the scenario sets.
    #[cfg_attr(not(feature = "fmi-import"), allow(dead_code, reason = "read where FMUs run"))]
    pub parameters: Vec<(FmuVariable, Value)>,
    pub notes: Vec<String>,
}

/// Finds the counterparts by name: every input and output must have one; parameters that the FMU lacks
/// are ignored.
///
/// # Errors
/// An input or output without a counterpart, or with one of another causality, type or physical unit;
/// two variables with the same counterpart; a name that the unit does not have.
pub(super) fn map(unit: &dyn Unit, fmu: &Fmu, substitute: &Substitute) -> Result<Map> {
    let names = &substitute.names;
    let fail = |variable: &str, what: String| {
        Error::input(format!(
            "unit `{}`, variable `{variable}`: `{}`: {what}",
            unit.name(),
            fmu.path.display()
        ))
    };
    if let Some(name) = names.keys().find(|n| !unit.variables().iter().any(|v| v.name == **n)) {
        return Err(fail(name, "is not a variable of this unit".to_owned()));
    }
    let mut map = Map { counterparts: Vec::new(), parameters: Vec::new(), notes: Vec::new() };
    for (name, value) in &substitute.parameters {
        let theirs = fmu.variable(name);
        let theirs = theirs.ok_or_else(|| fail(name, "it has no such variable".to_owned()))?;
        let value = parameter(theirs, value).map_err(|what| fail(name, what))?;
        map.parameters.push((theirs.clone(), value));
    }
    let mut taken: BTreeMap<&str, &str> = BTreeMap::new();
    for (index, variable) in unit.variables().iter().enumerate() {
        let name = names.get(&variable.name).unwrap_or(&variable.name);
        let wanted = match variable.causality {
            Causality::Input | Causality::Output => true,
            Causality::Parameter => names.contains_key(&variable.name),
            Causality::Local => continue,
        };
        let Some(theirs) = fmu.variable(name) else {
            if wanted {
                let what =
                    format!("has no variable `{name}`: expected an {}", variable.causality.name());
                return Err(fail(&variable.name, what));
            }
            continue;
        };
        if variable.causality == Causality::Parameter && substitute.parameters.contains_key(name) {
            continue;
        }
        if !wanted && theirs.causality != Causality::Parameter.name() {
            let what = format!("`{name}` is {}, no parameter: it is not set", theirs.causality);
            map.notes.push(what);
            continue;
        }
        let conversion = compared(variable, theirs).map_err(|what| fail(&variable.name, what))?;
        if let Some(other) = taken.insert(&theirs.name, &variable.name) {
            let what = format!("`{name}` stands for `{other}` already: expected one for each");
            return Err(fail(&variable.name, what));
        }
        let conversion = conversion.filter(|c| !c.is_identity());
        if let (Some(_), Some(unit)) = (conversion, &theirs.unit) {
            let what =
                format!("`{name}` is in `{}`: converted to `{}`", unit.name, variable.dimension);
            map.notes.push(what);
        }
        map.counterparts.push(Counterpart {
            index,
            causality: variable.causality,
            kind: variable.kind(),
            theirs: theirs.clone(),
            conversion,
        });
    }
    Ok(map)
}

/// The value of a parameter in the FMU's type.
fn parameter(theirs: &FmuVariable, value: &Parameter) -> Result<Value, String> {
    if theirs.causality != Causality::Parameter.name() {
        return Err(format!("it is {}: expected a parameter", theirs.causality));
    }
    if theirs.is_array {
        return Err("it is an array: expected a single value".to_owned());
    }
    let kind = theirs.kind.as_str();
    let whole = |x: &Rational| x.is_integer().then(|| x.to_integer().to_i64()).flatten();
    match value {
        Parameter::Number(x) if theirs.is_real() => Ok(Value::Real(exact::to_f64(x))),
        Parameter::Number(x) if WHOLES.contains(&kind) => match whole(x) {
            Some(n) => Ok(Value::Integer(n)),
            None => Err(format!("`{x}`: expected a whole number")),
        },
        Parameter::Boolean(b) if kind == "Boolean" => Ok(Value::Boolean(*b)),
        Parameter::Text(t) if kind == "String" => Ok(Value::Text(t.as_str().into())),
        _ => Err(format!("it has type {kind}: expected a value of that type")),
    }
}

/// Types of integer variables.
const WHOLES: &[&str] =
    &["Integer", "Int64", "Int32", "Int16", "Int8", "UInt64", "UInt32", "UInt16", "UInt8"];

/// Compares a variable with its counterpart: the conversion of its values, or the reason why they do
/// not match.
fn compared(ours: &Variable, theirs: &FmuVariable) -> Result<Option<Conversion>, String> {
    let name = &theirs.name;
    if theirs.causality != ours.causality.name() {
        let (found, expected) = (&theirs.causality, ours.causality.name());
        return Err(format!("`{name}` is {found}: expected {expected}"));
    }
    // An integer parameter may be sent as a real number; a received value must have the declared type.
    let told = ours.causality == Causality::Parameter;
    let kinds: &[&str] = match ours.kind() {
        Kind::Real => REALS,
        Kind::Integer if told && theirs.is_real() => REALS,
        Kind::Integer => WHOLES,
        Kind::Boolean => &["Boolean"],
        Kind::Text | Kind::Exact => &["String"],
    };
    if !kinds.contains(&theirs.kind.as_str()) {
        return Err(format!("`{name}` has type {}: expected {}", theirs.kind, kinds.join(" or ")));
    }
    if theirs.is_array {
        return Err(format!("`{name}` is an array: expected a single value"));
    }
    let Some(unit) = theirs.unit.as_ref().filter(|_| ours.kind() == Kind::Real) else {
        return Ok(None);
    };
    let found = &unit.name;
    let refused = || format!("`{name}` is in `{found}`: expected `{}`", ours.dimension);
    match (Si::named(ours.dimension.0), &unit.si) {
        (Some(si), Some(theirs)) => si.from(theirs, found).map(Some).ok_or_else(refused),
        _ if found == ours.dimension.0 => Ok(None),
        _ => Err(refused()),
    }
}
