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

/// Writes a file so that a reader sees the old content or the new, never a part: into a
/// temporary file beside it, then renamed.
///
/// # Errors
/// The folder cannot be written.
pub fn write_atomically(path: &Path, content: &[u8]) -> Result<()> {
    let fail = |e| Error::file("write", path, e);
    let folder = match path.parent() {
        Some(p) if !p.as_os_str().is_empty() => p,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".cordon-");
    // A temporary file is its owner's alone; the result is as open as the user's umask allows.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(folder).map_err(fail)?;
    file.write_all(content).and_then(|()| file.as_file().sync_all()).map_err(fail)?;
    file.persist(path).map_err(|e| fail(e.error))?;
    Ok(())
}
