//! The record of a run: positions at every grid point, and other variables on request.

use super::collision::Event;
use cordon_core::Rational;

/// The directions in which drones are commanded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Along the line of drones.
    X,
    /// Across it, for planar protocols.
    Y,
}

impl Axis {
    /// Its index among a body's three directions.
    pub fn index(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
        }
    }
}

/// Positions of all drones along an axis, in m: one number per drone, grid point by grid point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Track {
    /// The desired positions.
    pub desired: Vec<f64>,
    /// The actual positions.
    pub actual: Vec<f64>,
}

/// The height of the drones.
#[derive(Clone, Debug, PartialEq)]
pub struct Height {
    /// The desired height of all, z_d in m.
    pub desired: f64,
    /// The actual heights, laid out as in a [`Track`].
    pub actual: Vec<f64>,
}

/// A variable of a unit, at every grid point.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Unit and variable: `plant0.theta`.
    pub name: String,
    /// Symbol of its physical unit, `1` of a pure number.
    pub unit: String,
    /// One number per grid point; `true` is 1.
    pub values: Vec<f64>,
}

impl Series {
    /// The heading of its column: `plant0.theta [rad]`.
    pub fn head(&self) -> String {
        format!("{} [{}]", self.name, self.unit)
    }
}

/// Desired and actual positions of a run at its grid points, and what happened.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// A title, for display.
    pub title: String,
    /// Number of drones in the line.
    pub count: usize,
    /// Grid points in seconds, ascending.
    pub times: Vec<f64>,
    /// The track along the line.
    pub x: Track,
    /// The track across it, where drones fly in the plane.
    pub y: Option<Track>,
    /// The heights, where they are known.
    pub height: Option<Height>,
    /// Other recorded variables.
    pub series: Vec<Series>,
    /// Collisions and violations of the order, by time, where they were searched for.
    pub events: Option<Vec<Event>>,
    /// The set-up of the run, where it is known.
    pub setup: Option<Setup>,
    /// Further notes for the user: warnings of FMUs.
    pub notes: Vec<String>,
    /// Why the run ended early; the record covers the time until then.
    pub broken_off: Option<String>,
}

/// The set-up of a run, in words and exact numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setup {
    /// `coverage`, `consensus`, `formation` or a protocol file.
    pub protocol: String,
    /// Ends of the segment in m, for coverage.
    pub segment: Option<(Rational, Rational)>,
    /// Weight eps of the neighbours, dimensionless; `None` for a protocol file without one.
    pub weight: Option<Rational>,
    /// Ticks from one update to the next.
    pub period: u32,
    /// Communication step in s.
    pub tau: Rational,
    /// How plants integrate: `euler` or `exact`.
    pub integrator: String,
    /// How the master exchanges values: `jacobi` or `gauss-seidel`.
    pub master: String,
    /// The order in which drones updated, where it was not all at once.
    pub order: Option<Vec<usize>>,
    /// Whether the arithmetic was that of the authors' recorded runs.
    pub recorded: bool,
    /// FMUs that replaced units.
    pub fmus: Vec<Flown>,
}

/// An FMU that replaced a unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flown {
    /// Name of the unit that it replaced: `plant2`.
    pub unit: String,
    /// Name of the FMU's file.
    pub fmu: String,
}

impl Setup {
    /// What simulated the drones, in words: the plants, the master, and anything unusual.
    pub fn flown_with(&self) -> String {
        let mut text = format!("{} plant, {} master", self.integrator, self.master);
        if let Some(order) = &self.order {
            let first = order.iter().take(MOST_LISTED).map(usize::to_string);
            let first: Vec<_> = first.collect();
            let rest = if order.len() > MOST_LISTED { ", .." } else { "" };
            text.push_str(&format!(", updates in the order {}{rest}", first.join(", ")));
        }
        if self.recorded {
            text.push_str(", arithmetic of the recorded runs");
        }
        for (index, flown) in self.fmus.iter().enumerate() {
            match index {
                MOST_LISTED => {
                    text.push_str(&format!(", and {} more FMUs", self.fmus.len() - index));
                }
                p if p < MOST_LISTED => {
                    text.push_str(&format!(", {} is `{}`", flown.unit, flown.fmu));
                }
                _ => {}
            }
        }
        text
    }

    /// The weight in words, after a comma: `, eps = 1/5`.
    pub fn weighted(&self) -> String {
        self.weight.as_ref().map_or_else(String::new, |weight| format!(", eps = {weight}"))
    }

    /// How often drones update, in words.
    pub fn rhythm(&self) -> String {
        let period = match self.period {
            1 => "tick".to_owned(),
            ticks => format!("{ticks} ticks"),
        };
        format!("an update every {period} of {} s", self.tau)
    }
}

/// Most FMUs and drones that are listed by name.
const MOST_LISTED: usize = 6;

impl Record {
    /// Desired positions along x at a grid point.
    pub fn desired_at(&self, row: usize) -> &[f64] {
        self.at(&self.x.desired, row)
    }

    /// Actual positions along x at a grid point.
    pub fn actual_at(&self, row: usize) -> &[f64] {
        self.at(&self.x.actual, row)
    }

    /// One number per drone, at a grid point.
    pub fn at<'n>(&self, numbers: &'n [f64], row: usize) -> &'n [f64] {
        let from = row.saturating_mul(self.count);
        numbers.get(from..from.saturating_add(self.count)).unwrap_or_default()
    }

    /// The axes along which drones fly.
    pub fn tracks(&self) -> impl Iterator<Item = (Axis, &Track)> {
        std::iter::once((Axis::X, &self.x)).chain(self.y.as_ref().map(|y| (Axis::Y, y)))
    }

    /// The columns of positions: the prefix of their names, and one number per drone and grid point.
    pub fn positions(&self) -> impl Iterator<Item = (&'static str, &[f64])> {
        self.tracks().flat_map(|(axis, track)| {
            let (desired, actual) = match axis {
                Axis::X => ("xd", "x"),
                Axis::Y => ("yd", "y"),
            };
            [(desired, track.desired.as_slice()), (actual, track.actual.as_slice())]
        })
    }

    /// The number of grid points.
    pub fn rows(&self) -> usize {
        self.times.len()
    }
}
