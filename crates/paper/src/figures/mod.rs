//! The paper's figures 8 to 16, redrawn from co-simulated runs.

#[cfg(feature = "figures")]
mod draw;
#[cfg(feature = "figures")]
mod font;
#[cfg(not(feature = "figures"))]
mod undrawn;

use std::path::{Path, PathBuf};

use cordon_spec::{Phase, Scalar};

use cordon_core::exact::Rational;
use cordon_core::{Result, files};
use cordon_cosim::collision::{Event, EventKind};
use cordon_cosim::cosimulation::Cosimulation;
use cordon_cosim::record::Record;
use cordon_cosim::run;
use cordon_run::scenario::{Flight, Protocol, Scenario, Topology};

/// The format of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Scalable Vector Graphics
    Svg,
    /// Portable Network Graphics
    Png,
}

/// What a figure shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shown {
    Desired,
    Actual,
    /// The desired position of drone 2, one line per run.
    Centre,
    /// Height over x at one time, in hundredths of a second.
    Side(i32),
}

/// A figure of the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Figure {
    /// Number in the paper.
    pub number: u32,
    shown: Shown,
    consensus: bool,
    /// Weights of its runs, in tenths; the period is the same number of tenths of a second.
    tenths: &'static [i32],
    /// Length of the time axis in s.
    seconds: i32,
    /// Distance of the vertical grid lines in tenths of a second: the period of the updates.
    grid_tenths: i32,
}

/// The figures, by number.
pub const FIGURES: [Figure; 9] = [
    figure(8, Shown::Desired, &[2], 10),
    figure(9, Shown::Actual, &[2], 20),
    figure(10, Shown::Centre, &[1, 3, 5], 8),
    figure(11, Shown::Desired, &[7], 11),
    figure(12, Shown::Actual, &[7], 15),
    figure(13, Shown::Side(0), &[2], 10),
    figure(14, Shown::Side(965), &[2], 10),
    Figure { consensus: true, ..figure(15, Shown::Desired, &[3], 10) },
    Figure { consensus: true, ..figure(16, Shown::Actual, &[3], 20) },
];

const fn figure(number: u32, shown: Shown, tenths: &'static [i32], seconds: i32) -> Figure {
    let grid_tenths = match tenths {
        [one] => *one,
        // With several periods, a line every half second is a compromise.
        _ => 5,
    };
    Figure { number, shown, consensus: false, tenths, seconds, grid_tenths }
}

/// Whether this build can draw.
///
/// # Errors
/// It was built without the feature `figures`; the message says which build has it.
pub fn drawable() -> Result<()> {
    #[cfg(feature = "figures")]
    return Ok(());
    #[cfg(not(feature = "figures"))]
    Err(undrawn::missing())
}

/// A figure's lines, ready to be drawn.
#[cfg_attr(not(feature = "figures"), allow(dead_code))]
pub struct Plot {
    title: String,
    /// Label of the vertical axis.
    label: &'static str,
    /// Ends of the horizontal axis, in seconds or metres.
    across: (f64, f64),
    /// Distance of the vertical grid lines, in units of the axis.
    grid: f64,
    grid_label: String,
    /// A line of one point is a dot.
    lines: Vec<Line>,
    /// Collisions within the time axis: time, position, label.
    marks: Vec<(f64, f64, String)>,
}

#[cfg_attr(not(feature = "figures"), allow(dead_code))]
struct Line {
    name: String,
    points: Vec<(f64, f64)>,
}

impl Figure {
    /// Runs what the figure shows.
    ///
    /// # Errors
    /// A run fails.
    pub fn plot(&self) -> Result<Plot> {
        let runs = self
            .tenths
            .iter()
            .map(|&tenths| Ok((tenths, run::run(&self.swarm(tenths)?)?)))
            .collect::<Result<Vec<_>>>()?;
        let lines = match self.shown {
            Shown::Centre => runs
                .iter()
                .map(|(tenths, record)| Line {
                    name: format!("eps = {}", decimal(*tenths)),
                    points: points(record, 2, true),
                })
                .collect(),
            Shown::Side(at) => runs.iter().flat_map(|(_, record)| side(record, at)).collect(),
            shown => runs
                .iter()
                .flat_map(|(_, record)| {
                    let desired = shown == Shown::Desired;
                    (0..record.count).map(move |i| Line {
                        name: format!("drone {i}"),
                        points: points(record, i, desired),
                    })
                })
                .collect(),
        };
        let marks = match (self.shown, runs.as_slice()) {
            // For consensus, meeting is the goal and not a collision.
            (Shown::Actual, [(_, record)]) if !self.consensus => collisions(record),
            _ => Vec::new(),
        };
        let (label, what) = match self.shown {
            Shown::Desired => ("desired position x_d [m]", "desired positions"),
            Shown::Actual => ("actual position x [m]", "actual positions"),
            Shown::Centre => {
                ("desired position x_d of drone 2 [m]", "desired position of the central drone")
            }
            Shown::Side(0) => ("height z [m]", "the drones at the start"),
            Shown::Side(_) => ("height z [m]", "the drones"),
        };
        let protocol = if self.consensus { "consensus" } else { "coverage" };
        let weight = match self.tenths {
            [one] => format!(", eps = {}", decimal(*one)),
            _ => String::new(),
        };
        let grid_label = match self.shown {
            Shown::Centre => "time t [s]; grid lines every 0.5 s".to_owned(),
            Shown::Side(_) => "position x [m]".to_owned(),
            _ => format!("time t [s]; a grid line every eps = {} s", decimal(self.grid_tenths)),
        };
        let moment = match self.shown {
            Shown::Side(at) if at > 0 => format!(" at {:.2} s", f64::from(at) / 100.0),
            _ => String::new(),
        };
        let (across, grid) = match self.shown {
            Shown::Side(_) => ((-8.0, 108.0), 10.0),
            _ => ((0.0, f64::from(self.seconds)), f64::from(self.grid_tenths) / 10.0),
        };
        Ok(Plot {
            title: format!("Fig. {}: {what}{moment}, {protocol}{weight}", self.number),
            label,
            across,
            grid,
            grid_label,
            lines,
            marks,
        })
    }

    /// The paper's swarm with weight eps = tenths/10 and the period that the paper couples to it, eps
    /// seconds in ticks of 0.05 s.
    fn swarm(&self, tenths: i32) -> Result<Cosimulation> {
        let start: Vec<_> = [0, 10, 20, 30, 100].map(Rational::from_int).into();
        let protocol = if self.consensus {
            Protocol::Consensus { graph: Topology::Path(start.len()) }
        } else {
            Protocol::Coverage { min: Rational::from_int(0), max: Rational::from_int(100) }
        };
        let scenario = Scenario {
            title: format!("Fig. {}", self.number),
            protocol,
            start,
            weight: Rational::new(tenths.into(), 10.into()),
            period: 2 * tenths.unsigned_abs(),
            phase: Phase::First,
            tau: Some(Rational::new(1.into(), 20.into())),
            steps: 0,
        };
        let duration = Some(Rational::from_int(self.seconds));
        Cosimulation::new(scenario, Flight { duration, ..Flight::default() })
    }

    /// The name of the figure's file.
    pub fn file_name(&self, format: Format) -> String {
        let extension = match format {
            Format::Svg => "svg",
            Format::Png => "png",
        };
        format!("fig{:02}.{extension}", self.number)
    }

    /// Draws the figure into a file in a folder, written atomically.
    ///
    /// # Errors
    /// The run fails, or the file cannot be written.
    pub fn save(&self, format: Format, folder: &Path) -> Result<PathBuf> {
        let content = self.plot()?.drawn(format)?;
        let path = folder.join(self.file_name(format));
        files::write_atomically(&path, &content)?;
        Ok(path)
    }
}

/// A drone's line. Desired positions are constant between grid points: a staircase.
fn points(record: &Record, drone: usize, desired: bool) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = Vec::new();
    for (row, &time) in record.times.iter().enumerate() {
        let positions = if desired { record.desired_at(row) } else { record.actual_at(row) };
        let Some(&x) = positions.get(drone) else {
            continue;
        };
        if let (true, Some(&(_, before))) = (desired, points.last())
            && before != x
        {
            points.push((time, before));
        }
        points.push((time, x));
    }
    points
}

/// Ground and desired height, which fix the scale, and the positions x and z of every drone at one
/// time.
fn side(record: &Record, hundredths: i32) -> Vec<Line> {
    let moment = f64::from(hundredths) / 100.0;
    // The grid point for that time.
    let row = record.times.iter().position(|t| *t > moment - 1e-9).unwrap_or_default();
    let Some(height) = &record.height else { return Vec::new() };
    let level = |name: &str, z: f64| Line {
        name: name.to_owned(),
        points: [-8.0, 108.0].map(|x| (x, z)).into(),
    };
    let places = record.actual_at(row).iter().zip(record.at(&height.actual, row));
    let drones = places
        .enumerate()
        .map(|(i, (&x, &z))| Line { name: format!("drone {i}"), points: vec![(x, z)] });
    drones.chain([level("z_d", height.desired), level("ground", 0.0)]).collect()
}

fn collisions(record: &Record) -> Vec<(f64, f64, String)> {
    let events = record.events.as_deref().unwrap_or_default();
    let first = events.iter().find(|e| e.kind == EventKind::Collision);
    first.and_then(|e| mark(record, e)).into_iter().collect()
}

/// The position of a collision; between samples the drone's position is interpolated.
fn mark(record: &Record, event: &Event) -> Option<(f64, f64, String)> {
    let (i, j) = event.drones;
    let after = record.times.iter().position(|t| *t >= event.time)?;
    let before = after.saturating_sub(1);
    let (t0, t1) = (record.times.get(before)?, record.times.get(after)?);
    let (x0, x1) = (record.actual_at(before).get(i)?, record.actual_at(after).get(i)?);
    let share = if t1 > t0 { (event.time - t0) / (t1 - t0) } else { 0.0 };
    let label = format!("drones {i} and {j} collide at {:.2} s", event.time);
    Some((event.time, x0 + share * (x1 - x0), label))
}

fn decimal(tenths: i32) -> String {
    format!("{}.{}", tenths / 10, tenths % 10)
}
