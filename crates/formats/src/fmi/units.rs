//! Physical units in the XML of FMI and SSP: by name, with their exponents of SI base units.

use std::collections::BTreeMap;
use std::io::{Cursor, Result};

use quick_xml::Writer;

use cordon_cosim::unit::{Dimension, Kind, Variable};

/// XML being written.
pub(crate) type Xml = Writer<Cursor<Vec<u8>>>;

/// Names of the elements, which FMI and SSP have in different namespaces.
pub(crate) struct Elements {
    /// The element around all units of measurement.
    pub list: &'static str,
    /// The element of one unit of measurement.
    pub unit: &'static str,
    /// The element of its exponents in SI base units.
    pub base: &'static str,
}

/// Whether a variable has a physical unit in model descriptions.
pub(crate) fn has_unit(variable: &Variable) -> bool {
    variable.kind() == Kind::Real && variable.dimension != Dimension::NONE
}

/// Writes the definitions of all physical units of these variables, by name.
pub(crate) fn write<'v>(
    xml: &mut Xml,
    elements: &Elements,
    variables: impl IntoIterator<Item = &'v Variable>,
) -> Result<()> {
    let with_unit = variables.into_iter().filter(|v| has_unit(v));
    let mut symbols: Vec<&str> = with_unit.map(|v| v.dimension.0).collect();
    symbols.sort_unstable();
    symbols.dedup();
    xml.create_element(elements.list).write_inner_content(|xml| {
        for symbol in symbols {
            xml.create_element(elements.unit)
                .with_attribute(("name", symbol))
                .write_inner_content(|xml| {
                    let mut base = xml.create_element(elements.base);
                    for (unit, exponent) in base_units(symbol) {
                        base = base.with_attribute((unit.as_str(), exponent.to_string().as_str()));
                    }
                    base.write_empty()?;
                    Ok(())
                })?;
        }
        Ok(())
    })?;
    Ok(())
}

/// Exponents of the base units of a symbol like `kg.m2`, `m/s2` or `m.s-1`.
pub(crate) fn base_units(symbol: &str) -> Vec<(String, i32)> {
    let mut exponents: Vec<(String, i32)> = Vec::new();
    for (index, part) in symbol.split('/').enumerate() {
        let sign = if index == 0 { 1 } else { -1 };
        for factor in part.split('.').filter(|f| *f != "1") {
            let is_exponent = |c: char| c.is_ascii_digit() || c == '-' || c == '+';
            let name = factor.trim_end_matches(is_exponent);
            let exponent: i32 = factor.get(name.len()..).and_then(|e| e.parse().ok()).unwrap_or(1);
            match exponents.iter_mut().find(|(n, _)| n == name) {
                Some((_, sum)) => *sum += sign * exponent,
                None => exponents.push((name.to_owned(), sign * exponent)),
            }
        }
    }
    exponents
}

/// A physical unit in SI base units: a value corresponds to `factor * value + offset` there.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Si {
    /// Nonzero exponents, by base unit.
    exponents: BTreeMap<&'static str, i32>,
    factor: f64,
    offset: f64,
}

/// The base units of the standards.
const BASE: [&str; 8] = ["kg", "m", "s", "A", "K", "mol", "cd", "rad"];

impl Si {
    pub(crate) fn new(
        exponents: impl IntoIterator<Item = (&'static str, i32)>,
        factor: f64,
        offset: f64,
    ) -> Self {
        let exponents = exponents.into_iter().filter(|(_, e)| *e != 0).collect();
        Self { exponents, factor, offset }
    }

    /// The unit described by a name made of base units, like `m/s`, `m.s-1` or `m*s^-1`.
    pub(crate) fn named(name: &str) -> Option<Self> {
        let name = name.replace('*', ".").replace(['^', '(', ')', ' '], "");
        let known = |(unit, exponent): (String, i32)| {
            Some((*BASE.iter().find(|base| **base == unit)?, exponent))
        };
        let exponents: Option<Vec<_>> = base_units(&name).into_iter().map(known).collect();
        Some(Self::new(exponents?, 1.0, 0.0))
    }

    /// The conversion from `theirs`, a unit called `name`, to this one; `None` where the two measure
    /// different quantities.
    pub(crate) fn from(&self, theirs: &Self, name: &str) -> Option<Conversion> {
        let without_angle = |si: &Self| {
            let mut exponents = si.exponents.clone();
            exponents.remove("rad");
            exponents
        };
        // A radian is dimensionless, and many tools leave it out.
        let same = self.exponents == theirs.exponents
            || (name.contains("rad") && without_angle(self) == without_angle(theirs));
        let usable = theirs.factor.is_finite() && theirs.factor != 0.0 && theirs.offset.is_finite();
        (same && usable && self.factor == 1.0 && self.offset == 0.0)
            .then_some(Conversion { factor: theirs.factor, offset: theirs.offset })
    }
}

/// Converts values between a foreign unit and one of SI base units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Conversion {
    factor: f64,
    offset: f64,
}

#[cfg_attr(not(feature = "fmi-import"), allow(dead_code, reason = "values flow where FMUs run"))]
impl Conversion {
    /// Whether it leaves values unchanged.
    pub(crate) fn is_identity(self) -> bool {
        self.factor == 1.0 && self.offset == 0.0
    }

    /// A value of theirs in our unit.
    pub(crate) fn inward(self, theirs: f64) -> f64 {
        self.factor * theirs + self.offset
    }

    /// A value of ours in their unit.
    pub(crate) fn outward(self, ours: f64) -> f64 {
        (ours - self.offset) / self.factor
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    #[test]
    fn units_are_compared_by_what_they_are_in_base_units() {
        let speed = Si::named("m/s").unwrap();
        for name in ["m/s", "m.s-1", "m*s^-1", "m.s^(-1)"] {
            let same = speed.from(&Si::named(name).unwrap(), name).unwrap();
            assert!(same.is_identity(), "{name}");
        }
        let millimetre = Si::new([("m", 1)], 0.001, 0.0);
        let metre = Si::named("m").unwrap();
        let conversion = metre.from(&millimetre, "mm").unwrap();
        assert_eq!((conversion.inward(1500.0), conversion.outward(1.5)), (1.5, 1500.0));
        assert_eq!(speed.from(&millimetre, "mm/s"), None);
        assert_eq!(Si::named("ft"), None);
        // Radians left out of a definition.
        let turning = Si::named("rad/s").unwrap();
        assert!(turning.from(&Si::new([("s", -1)], 1.0, 0.0), "rad/s").is_some());
        assert_eq!(turning.from(&Si::new([("s", -1)], 1.0, 0.0), "Hz"), None);
    }
}
