//! The hash of the sources that a result depends on.

use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use cordon_core::{Error, Result};

/// Extensions of source files; other files are build products.
const ENDINGS: [&str; 10] = ["rs", "toml", "v", "tsv", "txt", "sh", "awk", "lean", "json", "pvs"];

/// Source files without an extension.
const NAMES: [&str; 2] = ["_CoqProject", "lean-toolchain"];

/// `sha256:` and the hash of the content and the names of all source files at or below the
/// given paths, which are relative to `root`.
///
/// A path that does not exist, or a file that cannot be read.
/// A path that is not there, or a file that cannot be read.
pub fn hash(root: &Path, paths: &[&str]) -> Result<String> {
    let mut files = Vec::new();
    for path in paths {
        let full = root.join(path);
        if full.is_file() {
            files.push(full);
        } else {
            collect(&full, &mut files)?;
        }
    }
    let mut named: Vec<(String, PathBuf)> =
        files.into_iter().map(|f| (portable_name(root, &f), f)).collect();
    named.sort();
    named.dedup();
    let mut hasher = Sha256::new();
    for (name, file) in named {
        let content = std::fs::read(&file).map_err(|e| Error::file("read", &file, e))?;
        // Lengths keep names and contents apart.
        for part in [name.as_bytes(), content.as_slice()] {
            hasher.update((part.len() as u64).to_le_bytes());
            hasher.update(part);
        }
    }
    let digest: String = hasher.finalize().iter().map(|b| format!("{b:02x}")).collect();
    Ok(format!("sha256:{digest}"))
}

/// The path below the root, with `/` as the separator on every system.
fn portable_name(root: &Path, file: &Path) -> String {
    let below = file.strip_prefix(root).unwrap_or(file);
    let parts: Vec<_> = below.iter().map(|part| part.to_string_lossy()).collect();
    parts.join("/")
}

fn collect(folder: &Path, found: &mut Vec<PathBuf>) -> Result<()> {
    let fail = |e| Error::file("read", folder, e);
    for entry in std::fs::read_dir(folder).map_err(fail)? {
        let path = entry.map_err(fail)?.path();
        let name = path.file_name().and_then(|n| n.to_str()).unwrap_or_default();
        let hidden = name.starts_with('.');
        if path.is_dir() {
            if !hidden && name != "target" {
                collect(&path, found)?;
            }
        } else if !hidden {
            let ending = path.extension().and_then(|e| e.to_str());
            if ending.is_some_and(|e| ENDINGS.contains(&e)) || NAMES.contains(&name) {
                found.push(path);
            }
        }
    }
    Ok(())
}
