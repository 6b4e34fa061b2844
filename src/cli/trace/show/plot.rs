//! Traces as a small plot in the terminal.

use std::io::Write;

use textplots::{Chart, Plot, Shape};

use cordon_core::Result;
use cordon_run::trace::{Counted, Row};

/// Size of the plot in braille dots: two per column, four per line.
const WIDTH: u32 = 140;
const HEIGHT: u32 = 60;

/// Writes one curve of dots per drone, with positions upward and rows to the right; with fewer than two
/// rows nothing is drawn.
///
/// # Errors
/// `out` cannot be written.
pub fn plot(unit: Counted, rows: &[Row], out: &mut dyn Write) -> Result<()> {
    let at = |row: &Row| match unit {
        Counted::Steps => row.step as f32,
        Counted::Ticks => row.tick as f32,
    };
    let [first, .., last] = rows else {
        return Ok(());
    };
    let mut lines: Vec<Vec<(f32, f32)>> = vec![Vec::new(); first.positions.doubles().len()];
    for row in rows {
        for (line, x) in lines.iter_mut().zip(row.positions.doubles()) {
            line.push((at(row), x as f32));
        }
    }
    let shapes: Vec<Shape<'_>> = lines.iter().map(|l| Shape::Lines(l)).collect();
    let mut chart = Chart::new(WIDTH, HEIGHT, at(first), at(last));
    let mut plotted: &mut Chart<'_> = &mut chart;
    for shape in &shapes {
        plotted = plotted.lineplot(shape);
    }
    plotted.axis();
    plotted.figures();
    writeln!(out, "\nposition against {}", unit.name())?;
    writeln!(out, "{plotted}")?;
    Ok(())
}
