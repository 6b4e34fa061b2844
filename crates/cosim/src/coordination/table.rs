//! The variables of a coordination unit.

use std::sync::Arc;

use cordon_spec::Phase;

use super::{Exchange, Law, OnLoss, Settings};
use crate::quotient::Quotient;
use crate::unit::{Causality, Dimension, Value, Variable};
use cordon_core::Rational;
use cordon_core::exact;

/// The meaning of a variable of a coordination unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slot {
    /// Input: a neighbour's position, by its index (0 and 1 are `prec` and `foll`).
    Heard(usize),
    /// Output `x_d`: the desired position as a double.
    Desired,
    /// Output `y_d`: the desired position across the line, of planar protocols.
    DesiredAcross,
    /// Output `own`: the exact desired position. Only where positions are exchanged exactly.
    Own,
    /// Output: a state variable of a protocol file other than the position, as it is sent to the other
    /// drones.
    Beside(usize),
    /// Parameter `id`: the drone's place in the line, from 0.
    Id,
    /// Parameter `count`: the number of drones N.
    Count,
    /// Parameter `min`: left end of the segment, in m.
    Min,
    /// Parameter `max`: right end of the segment, in m.
    Max,
    /// Parameter `weight`: eps, dimensionless.
    Weight,
    /// Parameter `start`: the desired position at the start, in m.
    Start,
    /// Parameter: a state variable of a protocol file other than the position, at the start.
    StartOf(usize),
    /// Parameter `parameters.eps`: a protocol file's parameter, by its index among those that are
    /// constant.
    Constant(usize),
    /// Parameter `period`, in ticks.
    Period,
    /// Parameter `first_update`, `first` or `last`; or `update_last`, where numbers are doubles.
    FirstUpdate,
    /// Parameter `skip_lost`: skip an update for which a message was lost.
    SkipLost,
    /// Parameter `displacement`: sum of the desired displacements from the neighbours, in m
    /// (formation).
    Displacement,
}

/// Start values of the inputs: before the first exchange a unit hears its own start.
pub(super) fn starts(settings: &Settings) -> Vec<Value> {
    let count = match &settings.law {
        Law::Coverage { .. } => 2,
        Law::Consensus { neighbours } | Law::Formation { neighbours, .. } => neighbours.len(),
        Law::Own(law) => {
            let send = |x: &Rational| settings.exchange.send(&Quotient::from(x));
            return law
                .heard
                .iter()
                .map(|(_, v)| law.start.get(*v).map_or_else(|| send(&settings.start), send))
                .collect();
        }
    };
    let start = match settings.exchange {
        Exchange::Exact => Value::Exact(Quotient::from(&settings.start)),
        Exchange::Double | Exchange::SixDigits => Value::Real(exact::to_f64(&settings.start)),
    };
    vec![start; count]
}

pub(super) fn phase_value(exchange: Exchange, phase: Phase) -> Value {
    if exchange != Exchange::Exact {
        return Value::Boolean(phase == Phase::Last);
    }
    Value::Text(
        match phase {
            Phase::First => "first",
            Phase::Last => "last",
        }
        .into(),
    )
}

/// The table: inputs, then outputs, then parameters.
pub(super) fn table(settings: &Settings) -> (Arc<[Variable]>, Arc<[Slot]>) {
    let mut rows: Vec<(Slot, Variable)> = Vec::new();
    inputs(settings, &mut rows);
    outputs(settings, &mut rows);
    parameters(settings, &mut rows);
    let slots = rows.iter().map(|(slot, _)| *slot).collect();
    (rows.into_iter().map(|(_, variable)| variable).collect(), slots)
}

fn inputs(settings: &Settings, rows: &mut Vec<(Slot, Variable)>) {
    let names: Vec<String> = match &settings.law {
        Law::Coverage { .. } => vec!["prec".to_owned(), "foll".to_owned()],
        Law::Consensus { neighbours } | Law::Formation { neighbours, .. } => {
            neighbours.iter().map(|j| format!("heard_{j}")).collect()
        }
        Law::Own(law) => law.heard.iter().map(|(j, v)| law.input(*j, *v)).collect(),
    };
    for (i, (name, start)) in names.into_iter().zip(starts(settings)).enumerate() {
        let is_position = settings.law.hears_position(i);
        let (dimension, text) = match is_position {
            true => (Dimension::METRE, "desired position of a neighbour"),
            false => (Dimension::NONE, "state variable of a neighbour"),
        };
        let input = Variable::new(name, dimension, Causality::Input, start, text);
        rows.push((Slot::Heard(i), input));
    }
}

fn outputs(settings: &Settings, rows: &mut Vec<(Slot, Variable)>) {
    let mut output = |slot, name: &str, dimension, start, text| {
        rows.push((slot, Variable::new(name, dimension, Causality::Output, start, text)));
    };
    let metre = Dimension::METRE;
    let rounded = |x: &Rational| Value::Real(exact::to_f64(x));
    let text = "desired position, rounded to the nearest double";
    output(Slot::Desired, "x_d", metre, rounded(&settings.start), text);
    if settings.exchange == Exchange::Exact {
        let own = Value::Exact(Quotient::from(&settings.start));
        output(Slot::Own, "own", metre, own, "desired position, exact");
    }
    let Law::Own(law) = &settings.law else { return };
    for (v, start) in law.start.iter().enumerate() {
        if Some(v) == law.across {
            let text = "desired position across the line, rounded to the nearest double";
            output(Slot::DesiredAcross, "y_d", metre, rounded(start), text);
        }
        if v != law.position {
            let start = settings.exchange.send(&Quotient::from(start));
            let dimension = if law.is_position(v) { metre } else { Dimension::NONE };
            let text = "state variable, as it travels to other drones";
            output(Slot::Beside(v), &law.named("own", v), dimension, start, text);
        }
    }
}

fn parameters(settings: &Settings, rows: &mut Vec<(Slot, Variable)>) {
    let mut parameter = |slot, name: &str, dimension, start, text: &'static str| {
        rows.push((slot, Variable::new(name, dimension, Causality::Parameter, start, text)));
    };
    let exact = |x: &Rational| settings.exchange.parameter(x);
    // Drones are counted up to a million.
    let whole = |n: usize| Value::Integer(i64::try_from(n).unwrap_or(i64::MAX));
    let (none, metre) = (Dimension::NONE, Dimension::METRE);
    match &settings.law {
        Law::Coverage { id, count, min, max } => {
            parameter(Slot::Id, "id", none, whole(*id), "the drone's identifier, from 0");
            parameter(Slot::Count, "count", none, whole(*count), "number of drones");
            parameter(Slot::Min, "min", metre, exact(min), "left end of the segment");
            parameter(Slot::Max, "max", metre, exact(max), "right end of the segment");
        }
        Law::Formation { displacement, .. } => {
            let text = "sum of the wanted displacements from the neighbours";
            parameter(Slot::Displacement, "displacement", metre, exact(displacement), text);
        }
        Law::Own(law) => {
            if let Some((own, drone)) = &law.open {
                parameter(Slot::Id, "id", none, whole(*drone), "the drone's identifier, from 0");
                for (k, (p, x)) in own.constants().enumerate() {
                    let text = "parameter of the protocol";
                    let name = format!("parameters.{}", p.name);
                    parameter(Slot::Constant(k), &name, none, exact(x), text);
                }
                for (v, start) in law.start.iter().enumerate().filter(|(v, _)| *v != law.position) {
                    let (name, text) = (law.named("start", v), "state variable at the start");
                    let dimension = if law.is_position(v) { metre } else { none };
                    parameter(Slot::StartOf(v), &name, dimension, exact(start), text);
                }
            }
        }
        Law::Consensus { .. } => {}
    }
    let s = settings;
    // A protocol file has its weights in its rule.
    if !matches!(s.law, Law::Own(_)) {
        parameter(Slot::Weight, "weight", none, exact(&s.weight), "weight eps of the neighbours");
    }
    parameter(Slot::Start, "start", metre, exact(&s.start), "desired position at the start");
    let period = Value::Integer(s.period.into());
    parameter(Slot::Period, "period", none, period, "communication steps from update to update");
    match s.exchange {
        Exchange::Exact => {
            let text = "tick of the first update: `first` or `last` of the period";
            let start = phase_value(s.exchange, s.phase);
            parameter(Slot::FirstUpdate, "first_update", none, start, text);
        }
        // Not every tool can set strings.
        Exchange::Double | Exchange::SixDigits => {
            let text =
                "whether the first update is in the last tick of the period, not in the first";
            let start = phase_value(s.exchange, s.phase);
            parameter(Slot::FirstUpdate, "update_last", none, start, text);
        }
    }
    let skip = Value::Boolean(s.on_loss == OnLoss::Skip);
    let text = "whether an update is skipped where a message was lost";
    parameter(Slot::SkipLost, "skip_lost", none, skip, text);
}
