//! Traces as a small plot in the terminal.

use std::io::Write;

use textplots::{Chart, Plot, Shape};

use cordon_core::Result;
use cordon_core::exact;
use cordon_run::trace::{Row, Trace, Unit};

/// Size of the plot in braille dots: two a column, four a line.
const WIDTH: u32 = 140;
const HEIGHT: u32 = 60;

/// Writes one line of dots a drone, positions upward, rows rightward; of fewer than two rows
/// there is nothing to draw.
///
/// # Errors
/// `out` cannot be written.
pub fn plot(trace: &Trace<'_>, out: &mut dyn Write) -> Result<()> {
    let at = |row: &Row| match trace.selection.unit {
        Unit::Steps => row.step as f32,
        Unit::Ticks => row.tick as f32,
    };
    let [first, .., last] = trace.rows.as_slice() else {
        return Ok(());
    };
    let lines: Vec<Vec<(f32, f32)>> = (0..trace.scenario.count())
        .map(|i| {
            let point =
                |row: &Row| row.positions.get(i).map(|x| (at(row), exact::to_f64(x) as f32));
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
