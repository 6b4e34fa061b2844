//! Files that appear whole or not at all.

use std::io::Write;
use std::path::Path;

use crate::{Error, Result};

/// Reads a UTF-8 text file.
///
/// # Errors
/// The file cannot be read, or is no UTF-8 text.
pub fn read_text(path: &Path) -> Result<String> {
    let bytes = std::fs::read(path).map_err(|e| Error::file("read", path, e))?;
    String::from_utf8(bytes)
        .map_err(|_| Error::input(format!("`{}`: expected UTF-8 text", path.display())))
}

/// A temporary file in the folder of `path`, readable by whom the user lets read new files.
fn temporary_beside(path: &Path) -> std::io::Result<tempfile::NamedTempFile> {
    let folder = match path.parent() {
        Some(p) if !p.as_os_str().is_empty() => p,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".cordon-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder)
}

/// Writes a file so that a reader sees the old content or the new, never a part: into a
/// temporary file beside it, then renamed.
///
/// # Errors
/// The folder cannot be written.
pub fn write_atomically(path: &Path, content: &[u8]) -> Result<()> {
    let fail = |e| Error::file("write", path, e);
    let mut file = temporary_beside(path).map_err(fail)?;
    file.write_all(content).and_then(|()| file.as_file().sync_all()).map_err(fail)?;
    file.persist(path).map_err(|e| fail(e.error))?;
    Ok(())
}

/// As [`write_atomically`], for content that is written bit by bit and need not fit the
/// memory. Where `content` fails nothing is left behind.
///
/// # Errors
/// The folder cannot be written, or `content` fails.
pub fn write_whole(path: &Path, content: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    let fail = |e| Error::file("write", path, e);
    let mut file = temporary_beside(path).map_err(fail)?;
    let mut buffer = std::io::BufWriter::new(file.as_file_mut());
    content(&mut buffer).map_err(|e| match e {
        Error::Output(e) => fail(e),
        e => e,
    })?;
    buffer.flush().map_err(fail)?;
    drop(buffer);
    file.as_file().sync_all().map_err(fail)?;
    file.persist(path).map_err(|e| fail(e.error))?;
    Ok(())
}
