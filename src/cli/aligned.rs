//! Tables with aligned columns, line by line where the widths are known beforehand.

use std::io::Write;

use cordon_core::Result;

/// Writes the head and the lines, every column to the right of `widths` or of its widest cell.
/// Without `widths` all lines are gathered first.
///
/// # Errors
/// `out` cannot be written.
pub fn aligned(
    head: &[String],
    widths: Option<&[usize]>,
    lines: impl Iterator<Item = Vec<String>>,
    out: &mut dyn Write,
) -> Result<()> {
    let widest = |widths: &mut Vec<usize>, cells: &[String]| {
        for (width, cell) in widths.iter_mut().zip(cells) {
            *width = (*width).max(cell.chars().count());
        }
    };
    let mut all = vec![0; head.len()];
    widest(&mut all, head);
    let mut write = |widths: &[usize], cells: &[String]| -> Result<()> {
        let cells = widths.iter().zip(cells);
        let line: String = cells.map(|(w, cell)| format!("{cell:>w$}  ")).collect();
        writeln!(out, "{}", line.trim_end())?;
        Ok(())
    };
    if let Some(widths) = widths {
        all.iter_mut().zip(widths).for_each(|(a, w)| *a = (*a).max(*w));
        write(&all, head)?;
        for cells in lines {
            write(&all, &cells)?;
        }
        return Ok(());
    }
    let lines: Vec<_> = lines.inspect(|cells| widest(&mut all, cells)).collect();
    write(&all, head)?;
    lines.iter().try_for_each(|cells| write(&all, cells))
}
