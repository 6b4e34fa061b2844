//! Output files, which appear whole or not at all.

use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::PoisonError;

use super::{INPUTS, STREAM};
use crate::{Error, Result};

/// Refuses an output that would take the place of an input.
fn expect_no_input(path: &Path) -> Result<()> {
    let inputs = INPUTS.lock().unwrap_or_else(PoisonError::into_inner);
    match inputs.iter().find(|input| same(input, path)) {
        Some(_) => Err(Error::input(format!(
            "out: `{}`: expected a file other than the inputs of the command",
            path.display()
        ))),
        None => Ok(()),
    }
}

/// What a path to be written turns out to be.
enum Target {
    /// A regular file, or none yet: replaced as a whole, with the permissions it had.
    Whole(PathBuf, Option<fs::Permissions>),
    /// A pipe or a device: written through.
    Through(File),
    /// This program's stdout, by whichever name.
    Stdout,
}

/// The file at the end of a chain of symbolic links, which need not exist.
fn followed(path: &Path) -> io::Result<PathBuf> {
    const MOST_LINKS: usize = 40;
    let mut at = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::symlink_metadata(&at) {
            Ok(meta) if meta.is_symlink() => {
                let to = fs::read_link(&at)?;
                at = at.parent().unwrap_or(Path::new("")).join(to);
            }
            _ => return Ok(at),
        }
    }
    Err(io::Error::other("too many symbolic links"))
}

fn target(path: &Path) -> io::Result<Target> {
    if is_stdout(path) {
        return Ok(Target::Stdout);
    }
    let meta = match fs::metadata(path) {
        Ok(meta) => meta,
        Err(e) if e.kind() == io::ErrorKind::NotFound => {
            return Ok(Target::Whole(followed(path)?, None));
        }
        Err(e) => return Err(e),
    };
    // Root could write it regardless; respect the read-only flag.
    if meta.is_file() && meta.permissions().readonly() {
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, "the file is read-only"));
    }
    // Opening for writing changes nothing, but checks the permission.
    let file = OpenOptions::new().write(true).open(path)?;
    if meta.is_file() {
        Ok(Target::Whole(fs::canonicalize(path)?, Some(meta.permissions())))
    } else {
        Ok(Target::Through(file))
    }
}

/// Refuses an existing file that cannot be written, before work is spent on its content.
///
/// # Errors
/// It is read-only, a folder, not writable by this user, or an input of this process.
pub fn expect_writable(path: &Path) -> Result<()> {
    if is_stdout(path) {
        return Ok(());
    }
    expect_no_input(path)?;
    let fail = |e| Error::file("write", path, e);
    match fs::metadata(path) {
        Ok(meta) if meta.is_file() => target(path).map(|_| ()).map_err(fail),
        Ok(meta) if meta.is_dir() => {
            let message = "a folder: expected a file";
            Err(fail(io::Error::new(io::ErrorKind::IsADirectory, message)))
        }
        Ok(_) => Ok(()),
        Err(_) => {
            let at = followed(path).map_err(fail)?;
            temporary_beside(&at).map(drop).map_err(fail)
        }
    }
}

/// Refuses a folder into which no files can be written, before work is spent on them. Where there is none,
/// it can be made.
///
/// # Errors
/// It, or what it would be made in, is a file, or not writable by this user.
pub fn expect_folder(path: &Path) -> Result<()> {
    let fail = |e| Error::file("write to", path, e);
    let stands = |p: &&Path| !p.as_os_str().is_empty() && fs::symlink_metadata(p).is_ok();
    let nearest = path.ancestors().find(stands).unwrap_or(Path::new("."));
    if nearest.is_dir() {
        return temporary_beside(&nearest.join("new")).map(drop).map_err(fail);
    }
    let kind = if nearest.is_file() { "a file" } else { "no folder" };
    let message = match nearest == path {
        true => format!("{kind}: expected a folder, or a name for a new one"),
        false => format!("`{}` is {kind}: expected a folder", nearest.display()),
    };
    Err(fail(io::Error::new(io::ErrorKind::NotADirectory, message)))
}

/// Whether a name stands for this program's stdout: `-`, `/dev/stdout`, or what stdout is
/// redirected to.
pub fn is_stdout(path: &Path) -> bool {
    path == Path::new(STREAM) || fs::metadata(path).is_ok_and(|meta| is_open_as_stdout(&meta))
}

#[cfg(unix)]
fn is_open_as_stdout(meta: &Metadata) -> bool {
    use std::os::fd::AsFd;
    use std::os::unix::fs::MetadataExt;

    let stdout = io::stdout().as_fd().try_clone_to_owned().map(File::from);
    stdout
        .and_then(|out| out.metadata())
        .is_ok_and(|out| (out.dev(), out.ino()) == (meta.dev(), meta.ino()))
}

#[cfg(not(unix))]
fn is_open_as_stdout(_: &Metadata) -> bool {
    false
}

/// Whether a name leads to a regular file that is not stdout.
pub fn is_regular(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|meta| meta.is_file()) && !is_stdout(path)
}

/// Whether two names lead to the same regular file.
pub fn same(a: &Path, b: &Path) -> bool {
    is_regular(a) && fs::canonicalize(a).is_ok_and(|a| fs::canonicalize(b).is_ok_and(|b| a == b))
}

/// A temporary file in the folder of `path`, with the permissions of a new file.
fn temporary_beside(path: &Path) -> io::Result<tempfile::NamedTempFile> {
    let folder = match path.parent() {
        Some(p) if !p.as_os_str().is_empty() => p,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".cordon-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder).map_err(|e| match e.kind() {
        // The name of the temporary file would only confuse.
        io::ErrorKind::NotFound => io::Error::new(e.kind(), "there is no such folder"),
        io::ErrorKind::PermissionDenied => {
            io::Error::new(e.kind(), "new files cannot be created in the folder")
        }
        _ => e,
    })
}

/// Writes a file. A regular one is replaced as a whole (into a temporary file beside it, then
/// renamed: a reader sees the old content or the new, never a part) and keeps its permissions;
/// symbolic links are followed; pipes and devices are written through; `-` is stdout.
///
/// # Errors
/// The file is read-only or an input of this process, or file or folder cannot be written.
pub fn write_atomically(path: &Path, content: &[u8]) -> Result<()> {
    write_whole(path, |out| Ok(out.write_all(content)?))
}

/// As [`write_atomically`], for content that is produced piece by piece and need not fit in memory. If
/// `content` fails, no regular file is changed.
///
/// # Errors
/// As [`write_atomically`], or `content` fails.
pub fn write_whole(path: &Path, content: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    expect_no_input(path)?;
    write_regardless(path, content)
}

/// As [`write_whole`], for a file that is read, updated and written back.
///
/// # Errors
/// As [`write_whole`], except that an input may be replaced.
pub fn write_regardless(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> Result<()>,
) -> Result<()> {
    let fail = |e| Error::file("write", path, e);
    // An output error inside is about this file.
    let named = |e| match e {
        Error::Output(e) => fail(e),
        e => e,
    };
    match target(path).map_err(fail)? {
        Target::Stdout => {
            let mut out = io::BufWriter::new(io::stdout().lock());
            content(&mut out)?;
            Ok(out.flush()?)
        }
        Target::Through(file) => {
            let mut out = io::BufWriter::new(file);
            content(&mut out).map_err(named)?;
            out.flush().map_err(fail)
        }
        Target::Whole(at, permissions) => {
            let mut file = temporary_beside(&at).map_err(fail)?;
            let mut out = io::BufWriter::new(file.as_file_mut());
            content(&mut out).map_err(named)?;
            out.flush().map_err(fail)?;
            drop(out);
            if let Some(permissions) = permissions {
                file.as_file().set_permissions(permissions).map_err(fail)?;
            }
            file.as_file().sync_all().map_err(fail)?;
            file.persist(&at).map_err(|e| fail(e.error))?;
            Ok(())
        }
    }
}
