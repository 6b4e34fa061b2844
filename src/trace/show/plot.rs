//! Traces as a small plot in the terminal.

use std::io::Write;

use textplots::{Chart, Plot, Shape};

use crate::exact;
use crate::trace::Trace;
use crate::{Error, Result};

/// Size of the plot in braille dots: two a column, four a line.
const WIDTH: u32 = 140;
const HEIGHT: u32 = 60;

/// Writes one line of dots a drone, positions upward, rows rightward.
///
/// # Errors
/// Fewer than two rows, or `out` cannot be written.
pub fn plot(trace: &Trace<'_>, out: &mut dyn Write) -> Result<()> {
    let at = |row: &crate::trace::Row| match trace.selection.unit {
        crate::trace::Unit::Steps => row.step as f32,
        crate::trace::Unit::Ticks => row.tick as f32,
    };
    let (Some(first), Some(last)) = (trace.rows.first(), trace.rows.last()) else {
        return Err(Error::input("plot: expected at least two rows"));
    };
    if first == last {
        return Err(Error::input("plot: expected at least two rows"));
    }
    let lines: Vec<Vec<(f32, f32)>> = (0..trace.scenario.count())
        .map(|i| {
            let point = |row: &crate::trace::Row| {
                row.positions.get(i).map(|x| (at(row), exact::to_f64(x) as f32))
            };
            trace.rows.iter().filter_map(point).collect()
        })
        .collect();
    let shapes: Vec<Shape<'_>> = lines.iter().map(|l| Shape::Lines(l)).collect();
    let mut chart = Chart::new(WIDTH, HEIGHT, at(first), at(last));
    let mut plotted: &mut Chart<'_> = &mut chart;
    for shape in &shapes {
        plotted = plotted.lineplot(shape);
    }
    plotted.axis();
    plotted.figures();
    writeln!(out, "\nposition against {}", trace.selection.unit.name())?;
    writeln!(out, "{plotted}")?;
    Ok(())
}
