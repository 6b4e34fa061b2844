//! Reading systems of other tools as scenarios.
//!
//! The system must be a swarm: for each drone a coordination unit of this program, a controller and a
//! plant, connected as [`Assembly`] connects them. A controller or a plant may be an FMU of another
//! tool whose variables have the same names. To make sure that nothing is overlooked, the scenario is
//! assembled again and compared with the file.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use cordon_spec::Phase;
use serde_json::Value as Json;

use super::into_cps::{self, MasterAlgorithm};
use super::ports::{Instance, Port, Ports};
use super::{Assembly, End, ssp};
use crate::fmi::archive::Fmu;
use cordon_core::exact::{self, Rational};
use cordon_core::{Error, Result};
use cordon_cosim::coordination::OwnLaw;
use cordon_cosim::cosimulation::Cosimulation;
use cordon_cosim::fmi::interface::{Model, Positions, TAU};
use cordon_cosim::quotient::Quotient;
use cordon_cosim::seat::Seat;
use cordon_cosim::unit::Value;
use cordon_run::scenario::{Draft, Flight, Parameter, Start, Substitute, UnitName};

/// Whether a file's name is that of a multi-model or an SSP archive.
pub fn is_system(path: &Path) -> bool {
    path.extension().is_some_and(|e| e == "json" || e == ssp::ENDING)
}

/// Reads a multi-model, a co-simulation configuration that names one, or an SSP archive as a scenario.
///
/// # Errors
/// The file or one of its FMUs cannot be read, or it is not the system of a swarm: the message names
/// the file and what does not match.
pub fn read(path: &Path) -> Result<Draft> {
    let named = |e: Error| match e {
        Error::Input(what) => Error::input(format!("{}: {what}", path.display())),
        e => e,
    };
    let system = match path.extension().is_some_and(|e| e == ssp::ENDING) {
        true => ssp::system(path)?,
        false => into_cps::system(path)?,
    };
    system.draft().map_err(named)
}

/// Instances of FMUs and their connections, as in a file.
pub(super) struct System {
    /// Its title, where the file has one.
    pub title: Option<String>,
    /// The FMUs by their keys, in braces.
    pub fmus: BTreeMap<String, Fmu>,
    pub ports: Ports,
    pub clock: Clock,
    /// Start and end in seconds, where the file gives them.
    pub start: Option<f64>,
    pub end: Option<f64>,
}

/// The length of a step, or where it comes from.
pub(super) enum Clock {
    /// That of the units.
    Units,
    /// That of the configuration, where it has one.
    Said(Option<MasterAlgorithm>),
}

/// The three instances of a drone.
struct Drone {
    units: [Instance; UnitName::ALL.len()],
    /// Their models; `None` for FMUs of other tools.
    models: [Option<Model>; UnitName::ALL.len()],
}

impl System {
    fn draft(&self) -> Result<Draft> {
        let drones = self.drones()?;
        let draft = self.as_read(&drones)?;
        let mut draft = Draft { title: self.title.clone(), ..draft };
        let names = self.compare(&drones, &draft)?;
        draft.flight.units = self.substitutes(&drones, &names)?;
        Ok(draft)
    }

    fn model_of(&self, instance: &Instance) -> Option<&Model> {
        self.fmus.get(&instance.fmu).and_then(Fmu::model)
    }

    /// The value of a variable: as set, or the model's start value.
    fn value(&self, instance: &Instance, model: &Model, variable: &str) -> Result<String> {
        let set = self.ports.settings.get(instance).and_then(|s| s.get(variable));
        match set {
            Some(Json::String(text)) => Ok(text.clone()),
            // A double stands for the fraction it was written from.
            Some(Json::Number(n)) if n.is_f64() => Ok(fraction(n.as_f64())),
            Some(other) => Ok(other.to_string()),
            None => {
                let start = model.variables().into_iter().find(|v| v.name == variable);
                let missing =
                    || Error::internal(format!("{instance}: has no variable `{variable}`"));
                Ok(match start.ok_or_else(missing)?.start {
                    Value::Real(x) => fraction(Some(x)),
                    other => other.to_string(),
                })
            }
        }
    }

    fn number(&self, instance: &Instance, model: &Model, variable: &str) -> Result<Rational> {
        exact::parse(&format!("{instance}.{variable}"), &self.value(instance, model, variable)?)
    }

    fn whole<T: std::str::FromStr>(
        &self,
        instance: &Instance,
        model: &Model,
        variable: &str,
    ) -> Result<T> {
        let text = self.value(instance, model, variable)?;
        text.parse().map_err(|_| {
            Error::input(format!("{instance}.{variable}: `{text}`: expected a whole number"))
        })
    }

    /// The drones, ordered by identifier.
    fn drones(&self) -> Result<Vec<Drone>> {
        let mut by_id = BTreeMap::new();
        for instance in self.ports.settings.keys() {
            if let Some(model) = self.model_of(instance).filter(|m| m.positions().is_some()) {
                let id: usize = self.whole(instance, model, "id")?;
                if let Some(other) = by_id.insert(id, (instance.clone(), model)) {
                    return Err(Error::input(format!(
                        "{instance}.id: `{id}` is that of {} too: expected different ones",
                        other.0
                    )));
                }
            }
        }
        let count = by_id.len();
        let mut drones = Vec::with_capacity(count);
        for (index, (id, (coordination, model))) in by_id.into_iter().enumerate() {
            let said: usize = match model {
                Model::Protocol(_, carried) => carried.own.system.agents,
                _ => self.whole(&coordination, model, "count")?,
            };
            if id != index || said != count {
                return Err(Error::input(format!(
                    "{coordination}: drone {id} of {said}: expected drone {index} of {count}, \
                     as many as there are"
                )));
            }
            drones.push(self.drone(coordination, model)?);
        }
        if drones.is_empty() {
            return Err(Error::input(
                "expected coordination units of this program, exported by `cordon fmu export`",
            ));
        }
        Ok(drones)
    }

    fn drone(&self, coordination: Instance, model: &Model) -> Result<Drone> {
        let others = |from: &Instance, variable: Option<&str>| {
            let mut targets = self.ports.targets(from, variable);
            targets.retain(|t| self.model_of(t).is_none_or(|m| m.positions().is_none()));
            targets
        };
        let one = |what: &str, from: &Instance, found: BTreeSet<Instance>| {
            let count = found.len();
            let mut found = found.into_iter();
            match (found.next(), count) {
                (Some(only), 1) => Ok(only),
                _ => Err(Error::input(format!(
                    "{from}: sends to {count} units: expected one {what}"
                ))),
            }
        };
        let control = one("controller", &coordination, others(&coordination, Some("x_d")))?;
        let plant = one("plant", &control, others(&control, None))?;
        let models = [Some(model), self.model_of(&control), self.model_of(&plant)];
        let models = models.map(Option::<&Model>::cloned);
        let expected = [(1, Model::Control, &control), (2, Model::Plant, &plant)];
        for (index, wanted, instance) in expected {
            if models[index].as_ref().is_some_and(|m| *m != wanted) {
                return Err(Error::input(format!(
                    "{instance}: expected `{}` here, or an FMU of another tool",
                    wanted.identifier()
                )));
            }
        }
        Ok(Drone { units: [coordination, control, plant], models })
    }

    /// The scenario that the file describes.
    fn as_read(&self, drones: &[Drone]) -> Result<Draft> {
        let mut start = Vec::new();
        let mut actual = Vec::new();
        let mut common = None;
        for drone in drones {
            let [coordination, _, plant] = &drone.units;
            let Some(model) = &drone.models[0] else { continue };
            let Some(positions) = model.positions() else { continue };
            if positions == Positions::SixDigits {
                return Err(Error::input(format!(
                    "{coordination}: expected exact positions or doubles: the arithmetic of the \
                     recorded runs needs a scenario file and `--compat recorded`"
                )));
            }
            let number = |variable: &str| self.number(coordination, model, variable);
            // Where the drone is at the start: what its plant is told, or else its coordination.
            let mut places = vec![("x0", "start".to_owned())];
            let of_others = match model {
                Model::Protocol(_, carried) => {
                    let law = OwnLaw::open(&carried.own, &[], 0);
                    for v in 0..law.variables.len() {
                        start.push(number(&law.named("start", v))?);
                    }
                    places.extend(law.across.map(|v| ("y0", law.named("start", v))));
                    let names = carried.own.constants().map(|(p, _)| p.name.clone());
                    let value = |name: String| Ok((number(&format!("parameters.{name}"))?, name));
                    names.map(value).collect::<Result<Vec<_>>>()?
                }
                _ => {
                    start.push(number("start")?);
                    let value = |name: &str| Ok((number(name)?, name.to_owned()));
                    ["min", "max", "weight"].into_iter().map(value).collect::<Result<_>>()?
                }
            };
            let period: u32 = self.whole(coordination, model, "period")?;
            let is_last = match positions {
                Positions::Exact => self.value(coordination, model, "first_update")? == "last",
                _ => self.value(coordination, model, "update_last")? == "true",
            };
            let phase = if is_last { Phase::Last } else { Phase::First };
            let skip = self.value(coordination, model, "skip_lost")?;
            let shared = (of_others, number(TAU)?, period, phase, skip, model);
            match &common {
                Some(known) if *known != shared => {
                    return Err(Error::input(format!(
                        "{coordination}: expected the parameters that the other drones have"
                    )));
                }
                _ => common = Some(shared),
            }
            for (of_plant, own) in places {
                actual.push(match &drone.models[2] {
                    Some(model) => self.number(plant, model, of_plant)?,
                    None => number(&own)?,
                });
            }
        }
        let Some((parameters, tau, period, phase, skip, model)) = common else {
            return Err(Error::internal("a swarm was read that has no drones"));
        };
        let is_exact = model.positions() == Some(Positions::Exact);
        let mut flight = Flight {
            start: Some(actual),
            exchange: Some(if is_exact { "exact" } else { "double" }.to_owned()),
            on_loss: Some(if skip == "true" { "skip" } else { "hold" }.to_owned()),
            duration: self.duration(&tau)?,
            ..Flight::default()
        };
        if let Some((control, model)) = first(drones, 1) {
            flight.lambda_p = Some(self.number(control, model, "lambda_P")?);
            flight.lambda_a = Some(self.number(control, model, "lambda_A")?);
            flight.z_d = Some(self.number(control, model, "z_d")?);
        }
        if let Some((plant, model)) = first(drones, 2) {
            flight.integrator = Some(self.value(plant, model, "integrator")?);
        }
        let draft = Draft {
            start: Some(Start::Listed(start)),
            period: Some(period),
            phase: Some(phase),
            tau: Some(tau),
            flight,
            ..Draft::default()
        };
        let mut parameters: BTreeMap<_, _> =
            parameters.into_iter().map(|(value, name)| (name, value)).collect();
        Ok(match model {
            Model::Protocol(_, carried) => Draft {
                protocol: Some(carried.own.file.clone()),
                protocol_text: Some(carried.own.text.clone()),
                parameters,
                ..draft
            },
            _ => Draft {
                min: parameters.remove("min"),
                max: parameters.remove("max"),
                weight: parameters.remove("weight"),
                ..draft
            },
        })
    }

    /// The length of the run, a whole number of steps; `None` where an archive does not give it.
    fn duration(&self, tau: &Rational) -> Result<Option<Rational>> {
        let step = exact::to_f64(tau);
        match (&self.clock, self.end) {
            (Clock::Units, None) => return Ok(None),
            (Clock::Units, Some(_)) => {}
            (Clock::Said(None), _) => {
                return Err(Error::input("algorithm is missing: expected a fixed step"));
            }
            (Clock::Said(Some(algorithm)), _) => {
                if algorithm.kind != "fixed-step" || algorithm.size != Some(step) {
                    let size = algorithm.size.map_or("none".to_owned(), |s| s.to_string());
                    return Err(Error::input(format!(
                        "algorithm: `{}` of size {size}: expected `fixed-step` of size {step}, the units' `{TAU}`",
                        algorithm.kind
                    )));
                }
            }
        }
        let end = self.end.unwrap_or(f64::NAN);
        let start = self.start.unwrap_or(0.0);
        let steps = (end / step).round();
        let duration = Rational::from_float(steps).unwrap_or_default() * tau;
        if start == 0.0 && end >= 0.0 && exact::to_f64(&duration) == end {
            return Ok(Some(duration));
        }
        Err(Error::input(format!(
            "a run from {start} to {end} s: expected one from 0 to a whole multiple of {step} s"
        )))
    }

    /// Compares the file with the assembly of the scenario. Returns the names that FMUs of other tools
    /// use for their variables, where a connection to a unit of this program reveals them.
    fn compare(&self, drones: &[Drone], draft: &Draft) -> Result<Names> {
        let swarm = Cosimulation::new(draft.clone().finish()?, draft.flight.clone())?;
        let assembly = match self.clock {
            Clock::Units => Assembly::of(&swarm)?.with_first_inputs(&swarm)?,
            Clock::Said(_) => Assembly::of(&swarm)?,
        };
        let mut unmatched = self.ports.wires.clone();
        let mut names = Names::new();
        for (from, to) in &assembly.connections {
            let matches = |(f, t): &&(Port, Port)| {
                let (here, there) = (fit(drones, from, f), fit(drones, to, t));
                // An end at another tool's FMU may have another name.
                matches!((here, there), (Fit::Whole, Fit::Whole | Fit::Renamed))
                    || matches!((here, there), (Fit::Renamed, Fit::Whole))
            };
            let whole = |w: &&(Port, Port)| {
                fit(drones, from, &w.0) == Fit::Whole && fit(drones, to, &w.1) == Fit::Whole
            };
            let found = unmatched.iter().find(whole).or_else(|| unmatched.iter().find(matches));
            let Some(found) = found.cloned() else {
                return Err(Error::input(format!(
                    "a connection from `{}` to `{}` is missing: expected those of a swarm",
                    expected_name(drones, from),
                    expected_name(drones, to)
                )));
            };
            for (end, port) in [(from, &found.0), (to, &found.1)] {
                if end.variable != port.variable {
                    let of_unit = names.entry(Seat::at(end.instance)).or_default();
                    of_unit.insert(end.variable.clone(), port.variable.clone());
                }
            }
            unmatched.remove(&found);
        }
        if let Some((from, to)) = unmatched.first() {
            return Err(Error::input(format!(
                "the connection from `{from}` to `{to}` does not belong in a swarm"
            )));
        }
        for (seat, instance) in Seat::all(drones.len()).zip(&assembly.instances) {
            let Some((unit, Some(_))) = unit_at(drones, seat) else { continue };
            let ours: BTreeMap<&str, String> =
                instance.settings.iter().map(|(n, v)| (n.as_str(), v.to_string())).collect();
            let changed = |(name, value): &(&String, &Json)| -> bool {
                let start = instance.model.variables().into_iter().find(|v| v.name == **name);
                !start.is_some_and(|v| same(&v.start, value))
            };
            let theirs = self.ports.settings.get(unit).into_iter().flatten();
            for (name, value) in theirs.filter(changed) {
                let known = ours.get(name.as_str());
                if !known.is_some_and(|k| same_text(k, value)) {
                    return Err(Error::input(format!(
                        "{unit}.{name}: `{value}`: expected `{}`, as a swarm has it",
                        known.map_or("the start value", String::as_str)
                    )));
                }
            }
        }
        Ok(names)
    }

    /// FMUs of other tools.
    fn substitutes(&self, drones: &[Drone], names: &Names) -> Result<Vec<Substitute>> {
        let mut substitutes = Vec::new();
        for (drone, d) in drones.iter().enumerate() {
            for (index, unit) in UnitName::ALL.into_iter().enumerate() {
                let (Some(instance), Some(None)) = (d.units.get(index), d.models.get(index)) else {
                    continue;
                };
                let Some(fmu) = self.fmus.get(&instance.fmu) else { continue };
                let fmu = fmu.path.clone();
                let names = names.get(&Seat { drone, unit }).cloned().unwrap_or_default();
                let set = self.ports.settings.get(instance).into_iter().flatten();
                let parameter = |(name, value): (&String, &Json)| {
                    let value = parameter(value).ok_or_else(|| {
                        let what = "expected a number, true, false or a text";
                        Error::input(format!("{instance}.{name}: `{value}`: {what}"))
                    })?;
                    Ok((name.clone(), value))
                };
                let parameters = set.map(parameter).collect::<Result<_>>()?;
                let ranges = BTreeMap::new();
                substitutes.push(Substitute { drone, unit, fmu, names, parameters, ranges });
            }
        }
        Ok(substitutes)
    }
}

/// The first instance of a given kind (index among a drone's units) that is a unit of this program.
fn first(drones: &[Drone], index: usize) -> Option<(&Instance, &Model)> {
    drones.iter().find_map(|d| Some((d.units.get(index)?, d.models.get(index)?.as_ref()?)))
}

fn unit_at(drones: &[Drone], seat: Seat) -> Option<(&Instance, Option<&Model>)> {
    let drone = drones.get(seat.drone)?;
    let index = seat.unit.index();
    Some((drone.units.get(index)?, drone.models.get(index)?.as_ref()))
}

/// The names that FMUs of other tools use for the variables of the units that they replace.
type Names = BTreeMap<Seat, BTreeMap<String, String>>;

/// How a port of the file matches an end of a connection of the assembly.
#[derive(Clone, Copy, PartialEq)]
enum Fit {
    /// It exists, with the same name.
    Whole,
    /// It is a variable of another tool's FMU, with another name.
    Renamed,
    /// The connection does not belong in the swarm.
    Not,
}

fn fit(drones: &[Drone], end: &End, port: &Port) -> Fit {
    match unit_at(drones, Seat::at(end.instance)) {
        Some((unit, _)) if *unit != port.instance => Fit::Not,
        Some(_) if end.variable == port.variable => Fit::Whole,
        Some((_, None)) => Fit::Renamed,
        _ => Fit::Not,
    }
}

fn parameter(value: &Json) -> Option<Parameter> {
    Some(match value {
        Json::Number(n) => Parameter::Number(match n.as_i64() {
            Some(whole) => Rational::from_integer(whole.into()),
            None => Rational::from_float(n.as_f64()?)?,
        }),
        Json::Bool(b) => Parameter::Boolean(*b),
        Json::String(text) => Parameter::Text(text.clone()),
        _ => return None,
    })
}

fn expected_name(drones: &[Drone], end: &End) -> String {
    let unit = unit_at(drones, Seat::at(end.instance)).map(|(unit, _)| unit.to_string());
    format!("{}.{}", unit.unwrap_or_default(), end.variable)
}

/// The simple fraction that a double stands for, as text.
fn fraction(x: Option<f64>) -> String {
    x.and_then(Quotient::simplest_of).map(|q| q.to_string()).unwrap_or_default()
}

/// Whether a value of the file equals the start value.
fn same(start: &Value, json: &Json) -> bool {
    same_text(&start.to_string(), json)
}

fn same_text(ours: &str, json: &Json) -> bool {
    let theirs = match json {
        Json::String(text) => text.clone(),
        other => other.to_string(),
    };
    let number = |text: &str| exact::parse("value", text).ok();
    ours == theirs || number(ours).is_some_and(|n| number(&theirs) == Some(n))
}
