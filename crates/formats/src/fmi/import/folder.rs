//! Temporary folders for unpacked archives, which are always removed in the end.
//!
//! A process that exits normally removes its folders; the child process of one that was killed removes
//! those it used. Where a process died with its FMUs in-process, the next process that unpacks an FMU
//! removes its folders: each contains a file that its process locks while it lives.

use std::fs::{self, File};
use std::path::Path;

use tempfile::{Builder, TempDir};

use cordon_core::{Error, Result};

/// Prefix of the folders' names.
const PREFIX: &str = "cordon-fmu-";

/// The file in a folder that is locked while its process lives.
const LOCK: &str = ".in-use";

/// A folder for an unpacked archive, removed when dropped.
pub struct Folder {
    _lock: File,
    folder: TempDir,
}

impl Folder {
    /// Creates a folder. Those of processes that have died are removed.
    ///
    /// # Errors
    /// It cannot be created.
    pub fn new() -> Result<Self> {
        let root = std::env::temp_dir();
        let failed = |e| Error::file("create", &root, e);
        let folder = Builder::new().prefix(PREFIX).tempdir_in(&root).map_err(failed)?;
        // Lock it under another name first: the final name must never exist unlocked.
        let (unlocked, locked) = (folder.path().join("new"), folder.path().join(LOCK));
        let lock = File::create(&unlocked).map_err(failed)?;
        lock.lock().map_err(failed)?;
        fs::rename(&unlocked, &locked).map_err(failed)?;
        remove_left_over(&root, folder.path());
        Ok(Self { _lock: lock, folder })
    }

    /// The folder into which the archive is unpacked.
    pub fn path(&self) -> &Path {
        self.folder.path()
    }
}

/// Removes folders left by dead processes of this user. Failures to remove are ignored.
fn remove_left_over(root: &Path, own: &Path) {
    let entries = fs::read_dir(root).into_iter().flatten().flatten();
    for path in entries.map(|entry| entry.path()) {
        let named = path.file_name().is_some_and(|n| n.to_string_lossy().starts_with(PREFIX));
        if named && path != own && same_owner(&path, own) {
            let unused = File::open(path.join(LOCK)).is_ok_and(|lock| lock.try_lock().is_ok());
            if unused {
                let _ = fs::remove_dir_all(&path);
            }
        }
    }
}

/// Whether a path is a folder (not a link) with the same owner as another.
#[cfg(unix)]
fn same_owner(path: &Path, own: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let folder = fs::symlink_metadata(path).ok().filter(fs::Metadata::is_dir);
    folder.zip(fs::symlink_metadata(own).ok()).is_some_and(|(a, b)| a.uid() == b.uid())
}

#[cfg(not(unix))]
fn same_owner(path: &Path, _: &Path) -> bool {
    path.is_dir()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    #[test]
    fn folders_of_the_dead_are_removed_and_those_of_the_living_and_of_others_stay() {
        let root = tempfile::tempdir().unwrap();
        let made = |name: &str, lock: bool| {
            let path = root.path().join(name);
            fs::create_dir(&path).unwrap();
            fs::write(path.join("binary"), "x").unwrap();
            lock.then(|| File::create(path.join(LOCK)).unwrap())
        };
        made("cordon-fmu-dead", true);
        let living = made("cordon-fmu-living", true).unwrap();
        living.lock().unwrap();
        made("cordon-fmu-strange", false);
        made("another", true);
        made("cordon-fmu-own", true);
        remove_left_over(root.path(), &root.path().join("cordon-fmu-own"));
        let mut left: Vec<_> = fs::read_dir(root.path()).unwrap().flatten().collect();
        left.sort_by_key(fs::DirEntry::file_name);
        let left: Vec<_> = left.iter().map(|e| e.file_name().into_string().unwrap()).collect();
        assert_eq!(left, ["another", "cordon-fmu-living", "cordon-fmu-own", "cordon-fmu-strange"]);
    }
}
