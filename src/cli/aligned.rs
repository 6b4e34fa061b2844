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

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use std::cell::Cell;
    use std::io;

    use super::*;

    #[test]
    fn known_widths_make_the_same_table() {
        let head = ["step", "x0"].map(String::from);
        let lines = || (8..12).map(|i| vec![i.to_string(), format!("{:.3}", f64::from(i))]);
        let (mut gathered, mut streamed) = (Vec::new(), Vec::new());
        aligned(&head, None, lines(), &mut gathered).unwrap();
        aligned(&head, Some(&[2, 6]), lines(), &mut streamed).unwrap();
        assert_eq!(gathered, streamed);
        assert_eq!(gathered.split(|&c| c == b'\n').nth(1).unwrap(), b"   8   8.000");
    }

    /// Takes two lines.
    struct Full(u32);

    impl Write for Full {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            if bytes.contains(&b'\n') {
                self.0 += 1;
            }
            if self.0 > 2 { Err(io::ErrorKind::BrokenPipe.into()) } else { Ok(bytes.len()) }
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn lines_are_written_as_they_come() {
        let made = Cell::new(0);
        let lines = (0..1000).map(|i| {
            made.set(made.get() + 1);
            vec![i.to_string()]
        });
        assert!(aligned(&["step".to_owned()], Some(&[3]), lines, &mut Full(0)).is_err());
        assert_eq!(made.get(), 2, "lines made until the reader is gone");
    }
}
