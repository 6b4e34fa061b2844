//! Reading FMUs: the archive, and the binaries in it.

use std::fs::File;
use std::io::{BufReader, Cursor, Read, Seek};
use std::path::{Path, PathBuf};

use zip::ZipArchive;

#[cfg(feature = "fmi-import")]
use super::import::folder::Folder;
use super::model_description::{FmuVariable, ModelDescription};
use super::package::platform;
use cordon_core::{Error, Result, files};
use cordon_cosim::fmi::carried::{self, Carried};
use cordon_cosim::fmi::interface::{FmiVersion, Model};

/// An FMU on disk with its model description.
#[derive(Clone, Debug, PartialEq)]
pub struct Fmu {
    /// Where the archive is.
    pub path: PathBuf,
    /// Its parsed model description.
    description: ModelDescription,
    /// The model of this program that it was exported from, if any.
    model: Option<Model>,
    /// Platforms that it has binaries for.
    platforms: Vec<String>,
    /// Paths of all its files.
    files: Vec<String>,
}

impl Fmu {
    /// Reads an FMU.
    ///
    /// # Errors
    /// There is no such file; it is not an archive, is truncated, or unpacks to more than a gigabyte;
    /// the model description is missing, too large, or of another version of the standard. The message
    /// names the file.
    pub fn open(path: &Path) -> Result<Self> {
        let fail = |what: String| Error::input(format!("`{}`: {what}", path.display()));
        let mut archive = opened(path)?;
        let files: Vec<String> = archive.file_names().map(str::to_owned).collect();
        let text = entry(&mut archive, "modelDescription.xml", "an FMU").map_err(fail)?;
        Self::from_description(path, &text, files, || {
            let [scenario, protocol] = [carried::SCENARIO, carried::PROTOCOL].map(|name| {
                entry(&mut archive, &format!("resources/{name}"), "a protocol's FMU").map_err(fail)
            });
            Carried::parse(&path.join("resources"), &scenario?, protocol?)
        })
    }

    fn from_description(
        path: &Path,
        text: &str,
        files: Vec<String>,
        carried: impl FnOnce() -> Result<Carried>,
    ) -> Result<Self> {
        let fail = |what: String| Error::input(format!("`{}`: {what}", path.display()));
        let mut platforms: Vec<String> = files
            .iter()
            .filter_map(|f| f.strip_prefix("binaries/")?.split_once('/'))
            .map(|(platform, _)| platform.to_owned())
            .collect();
        platforms.sort();
        platforms.dedup();
        let description = ModelDescription::read(text).map_err(fail)?;
        let model = Model::of_token(description.version, &description.token, carried)?;
        Ok(Self { path: path.to_owned(), description, model, platforms, files })
    }

    /// The model of this program that the FMU was exported from, if any.
    pub fn model(&self) -> Option<&Model> {
        self.model.as_ref()
    }

    /// Version of the standard.
    pub fn version(&self) -> FmiVersion {
        self.description.version
    }

    /// Identifier required to make instances.
    pub fn token(&self) -> &str {
        &self.description.token
    }

    /// A variable by name.
    pub fn variable(&self, name: &str) -> Option<&FmuVariable> {
        self.description.variables.iter().find(|v| v.name == name)
    }

    /// The path, within the archive, of the binary for co-simulation on this platform.
    ///
    /// # Errors
    /// It is not for co-simulation, or has no binary for this platform.
    pub fn binary(&self) -> Result<String> {
        let fail = |what: String| Err(Error::input(format!("`{}`: {what}", self.path.display())));
        let Some(identifier) = &self.description.identifier else {
            return fail("expected an FMU for co-simulation; it is for model exchange".to_owned());
        };
        let Some((folder, ending)) = platform(self.version()) else {
            return fail("FMI has no name for this platform".to_owned());
        };
        let binary = format!("binaries/{folder}/{identifier}{ending}");
        if self.files.contains(&binary) {
            return Ok(binary);
        }
        let others = match self.platforms.as_slice() {
            [] => "no binaries at all".to_owned(),
            list => format!("binaries for {}", list.join(", ")),
        };
        fail(format!("expected `{binary}`, a binary for this platform; it has {others}"))
    }
}

/// Most bytes of a text file: a model description of hundreds of thousands of variables.
const LARGEST_TEXT: u64 = 1 << 26;

/// Most bytes of all files of an archive, uncompressed.
const LARGEST_CONTENT: u64 = 1 << 30;

/// Most files of an archive.
const MOST_FILES: usize = 100_000;

/// The source of an archive: a file, or a file of another archive in memory.
pub(crate) trait Stored: Read + Seek {}

impl<T: Read + Seek> Stored for T {}

/// An archive open for reading.
pub(crate) type Archive = ZipArchive<Box<dyn Stored>>;

/// Opens an archive and checks the limits. A path may lead into another archive:
/// `system.ssp/resources/plant.fmu`.
pub(crate) fn opened(path: &Path) -> Result<Archive> {
    let outer = path.ancestors().skip(1).find(|a| a.is_file());
    let (Some(outer), false) = (outer, path.is_file()) else {
        let file = File::open(path).map_err(|e| Error::file("read", path, e))?;
        if file.metadata().is_ok_and(|found| found.is_dir()) {
            let message = format!("a folder: expected {}", expected(path));
            let is_folder = std::io::Error::new(std::io::ErrorKind::IsADirectory, message);
            return Err(Error::file("read", path, is_folder));
        }
        files::is_input(path);
        return archive(path, Box::new(BufReader::new(file)));
    };
    let inside = path.strip_prefix(outer).unwrap_or(path).to_string_lossy().replace('\\', "/");
    let mut outer = opened(outer)?;
    let mut bytes = Vec::new();
    let read = outer.by_name(&inside).map_err(std::io::Error::other);
    let read = read.and_then(|entry| entry.take(LARGEST_CONTENT).read_to_end(&mut bytes));
    read.map_err(|e| Error::file("read", path, e))?;
    archive(path, Box::new(Cursor::new(bytes)))
}

/// The kind of archive that a name promises.
fn expected(path: &Path) -> &'static str {
    let is_system = path.extension().is_some_and(|e| e == "ssp");
    if is_system { "an SSP archive" } else { "an FMU" }
}

fn archive(path: &Path, mut stored: Box<dyn Stored>) -> Result<Archive> {
    let fail = |what: String| Error::input(format!("`{}`: {what}", path.display()));
    let what = expected(path);
    let mut first = [0; 2];
    let is_empty = stored.read_exact(&mut first).is_err();
    let archive = stored.rewind().map_err(Into::into).and_then(|()| ZipArchive::new(stored));
    let archive = archive.map_err(|e| {
        fail(match (is_empty, &first) {
            (true, _) => format!("empty: expected {what}, a whole zip archive"),
            (false, b"PK") => format!("expected {what}, a whole zip archive: {e}"),
            (false, _) => format!("no zip archive: expected {what}, a whole zip archive"),
        })
    })?;
    if archive.len() > MOST_FILES {
        let found = archive.len();
        return Err(fail(format!("it has {found} files: expected at most {MOST_FILES}")));
    }
    // Where the archive understates its size, unpacking stops at the stated size.
    match archive.decompressed_size() {
        Some(size) if size > u128::from(LARGEST_CONTENT) => {
            Err(fail(format!("it unpacks to {size} bytes: expected at most {LARGEST_CONTENT}")))
        }
        _ => Ok(archive),
    }
}

/// A text file of an archive, by its path within it. `what` names the kind of archive, for messages.
pub(crate) fn entry(archive: &mut Archive, name: &str, what: &str) -> Result<String, String> {
    let entry = archive.by_name(name);
    let entry = entry.map_err(|e| format!("expected {what} with a `{name}`: {e}"))?;
    let mut bytes = Vec::new();
    entry
        .take(LARGEST_TEXT + 1)
        .read_to_end(&mut bytes)
        .map_err(|e| format!("its `{name}` cannot be read: {e}"))?;
    if u64::try_from(bytes.len()).is_ok_and(|length| length > LARGEST_TEXT) {
        return Err(format!("its `{name}` is too large: expected at most {LARGEST_TEXT} bytes"));
    }
    // Older tools write ISO 8859-1, whose bytes are Unicode code points.
    let latin =
        |e: std::string::FromUtf8Error| e.as_bytes().iter().copied().map(char::from).collect();
    Ok(String::from_utf8(bytes).unwrap_or_else(latin))
}

#[cfg(feature = "fmi-import")]
impl Fmu {
    /// Unpacks the archive into a temporary folder.
    ///
    /// # Errors
    /// It cannot be unpacked, one of its paths leads outside it, or it is too large.
    pub(super) fn unpack(&self) -> Result<Folder> {
        let fail = |what: String| Error::input(format!("`{}`: {what}", self.path.display()));
        let failed = |e: &dyn std::fmt::Display| fail(format!("it cannot be unpacked: {e}"));
        let folder = Folder::new()?;
        let mut archive = opened(&self.path)?;
        let mut left = LARGEST_CONTENT;
        for index in 0..archive.len() {
            let mut file = archive.by_index(index).map_err(|e| failed(&e))?;
            let Some(inside) = file.enclosed_name() else {
                let name = file.name();
                return Err(fail(format!("`{name}`: expected a path inside the archive")));
            };
            let path = folder.path().join(inside);
            let not_created = |e| Error::file("create", &path, e);
            if file.is_dir() {
                std::fs::create_dir_all(&path).map_err(not_created)?;
                continue;
            }
            if let Some(parent) = path.parent() {
                std::fs::create_dir_all(parent).map_err(not_created)?;
            }
            let mut to = File::create(&path).map_err(not_created)?;
            let copied = std::io::copy(&mut file.by_ref().take(left + 1), &mut to);
            left = copied.map_err(|e| failed(&e)).and_then(|written| {
                let too_much =
                    || fail(format!("expected at most {LARGEST_CONTENT} bytes, unpacked"));
                left.checked_sub(written).ok_or_else(too_much)
            })?;
            #[cfg(unix)]
            if file.unix_mode().is_some_and(|mode| mode & 0o100 != 0) {
                let executable = std::os::unix::fs::PermissionsExt::from_mode(0o700);
                std::fs::set_permissions(&path, executable).map_err(not_created)?;
            }
        }
        Ok(folder)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use crate::fmi::description::model_description;
    use cordon_cosim::fmi::interface::Positions;
    use cordon_run::scenario::parse;

    #[test]
    fn reads_back_every_model_description() {
        let mut compared = 0;
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/own/platoon.toml");
        let text = format!("protocol = '{file}'\nstart = [0, 0, 0.25, 0, 0, 0, 0, 0, 0, 0]");
        let own = parse("test", &text).unwrap().finish().unwrap();
        let carried = Carried::of(&own).unwrap();
        let own = Model::coordination(Positions::Double, &own).unwrap();
        for model in Model::PLAIN.into_iter().chain([own]) {
            for version in [FmiVersion::V2, FmiVersion::V3] {
                let text = String::from_utf8(model_description(&model, version).unwrap()).unwrap();
                let [(_, scenario), (_, protocol)] = carried.files();
                let carried = || Carried::parse(Path::new("resources"), &scenario, protocol);
                let path = Path::new("x.fmu");
                let fmu = Fmu::from_description(path, &text, Vec::new(), carried).unwrap();
                assert_eq!(fmu.version(), version);
                assert_eq!(fmu.model().map(Model::identifier), Some(model.identifier()));
                assert_eq!(fmu.description.model_name, model.identifier());
                for (index, v) in model.variables().iter().enumerate() {
                    let read = fmu.variable(&v.name).unwrap();
                    assert_eq!(read.reference as usize, index);
                    assert_eq!(read.causality, v.causality.name());
                    compared += 1;
                }
                let time = usize::from(version == FmiVersion::V3);
                assert_eq!(fmu.description.variables.len(), model.variables().len() + time);
            }
        }
        assert_eq!(compared, 2 * (15 + 14 + 14 + 33 + 31 + 20));
    }
}
