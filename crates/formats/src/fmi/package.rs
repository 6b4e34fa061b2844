//! Building FMU archives: model description and binary.

use std::io::{Cursor, Write};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use super::description::model_description;
use cordon_core::{Error, Result};
use cordon_cosim::fmi::interface::{FmiVersion, Model};

/// The name of this platform in FMUs (a folder; it differs between FMI 2.0 and 3.0), and the extension
/// of shared libraries. `None` where the standards have no name for it.
pub fn platform(version: FmiVersion) -> Option<(&'static str, &'static str)> {
    use std::env::consts::{ARCH, OS};
    let (two, three, ending) = match (OS, ARCH) {
        ("linux", "x86_64") => ("linux64", "x86_64-linux", ".so"),
        ("linux", "aarch64") => ("linux64", "aarch64-linux", ".so"),
        ("macos", "x86_64") => ("darwin64", "x86_64-darwin", ".dylib"),
        ("macos", "aarch64") => ("darwin64", "aarch64-darwin", ".dylib"),
        ("windows", "x86_64") => ("win64", "x86_64-windows", ".dll"),
        _ => return None,
    };
    Some((if version == FmiVersion::V2 { two } else { three }, ending))
}

/// The FMU of a model with this binary. The same input gives the same bytes.
///
/// # Errors
/// The standards have no name for this platform, or the binary is too large for an archive.
pub fn fmu(model: &Model, version: FmiVersion, binary: &[u8]) -> Result<Vec<u8>> {
    let Some((folder, ending)) = platform(version) else {
        return Err(Error::input(format!(
            "platform `{}-{}`: FMI has no name for it",
            std::env::consts::ARCH,
            std::env::consts::OS
        )));
    };
    let name = format!("binaries/{folder}/{}{ending}", model.identifier());
    let description = model_description(model, version)?;
    let resources = model.resources().into_iter();
    let resources: Vec<_> =
        resources.map(|(name, text)| (format!("resources/{name}"), text)).collect();
    let mut files = vec![("modelDescription.xml", description.as_slice()), (&name, binary)];
    files.extend(resources.iter().map(|(name, text)| (name.as_str(), text.as_bytes())));
    archive(&files)
}

/// An archive of files, by their paths within it.
///
/// # Errors
/// A file is too large.
pub fn archive(files: &[(&str, &[u8])]) -> Result<Vec<u8>> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    // A fixed time stamp, for reproducible archives.
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::default())
        .unix_permissions(0o644);
    let fail =
        |e: zip::result::ZipError| Error::internal(format!("the archive cannot be made: {e}"));
    for (path, content) in files {
        zip.start_file(*path, options).map_err(fail)?;
        zip.write_all(content)?;
    }
    Ok(zip.finish().map_err(fail)?.into_inner())
}
