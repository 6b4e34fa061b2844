//! Finds the binary that is put into exported FMUs: the compiled crate `cordon-fmu`.

use std::env;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use cordon_core::files::{self, Limit};
use cordon_core::{Error, Result};
use cordon_cosim::fmi::interface::BINARY_MARK;

/// The compiled crate's file name.
fn file_name() -> String {
    format!("{}cordon_fmu{}", env::consts::DLL_PREFIX, env::consts::DLL_SUFFIX)
}

/// How to make the binary, for messages.
const BUILD: &str = "cargo build --release -p cordon-fmu";

/// The bytes of the binary: the file named by the user, or the one beside this program.
///
/// Under cargo (`cargo run -- fmu export ..`), cargo builds that crate first, so that the binary exists
/// and is up to date.
///
/// # Errors
/// There is none, or it cannot be read; the message says how to build it.
pub fn load(named: Option<&Path>) -> Result<Vec<u8>> {
    if let Some(path) = named {
        return expect_ours(path, files::read(path, Limit::FMU)?);
    }
    let here = env::current_exe().map_err(|e| Error::file("find", Path::new("cordon"), e))?;
    let Some(folder) = here.parent() else {
        return Err(missing(&here));
    };
    build_under_cargo(folder)?;
    let path = folder.join(file_name());
    match std::fs::read(&path) {
        Ok(bytes) => expect_ours(&path, bytes),
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => Err(missing(&path)),
        Err(e) => Err(Error::file("read", &path, e)),
    }
}

/// Refuses anything but the compiled crate of this version.
fn expect_ours(path: &Path, bytes: Vec<u8>) -> Result<Vec<u8>> {
    // This program contains the mark too, but only the library contains its complement.
    let mark: Vec<u8> = black_box(BINARY_MARK).bytes().map(|b| !b).collect();
    if bytes.windows(mark.len()).any(|found| found == mark) {
        return Ok(bytes);
    }
    Err(Error::input(format!(
        "`{}`: expected the compiled crate `cordon-fmu`, version {}: build it with `{BUILD}`",
        path.display(),
        env!("CARGO_PKG_VERSION")
    )))
}

fn missing(path: &Path) -> Error {
    Error::input(format!(
        "the binary for FMUs is missing: expected `{}`: build it with `{BUILD}`, \
         or name it with `--binary`",
        path.display()
    ))
}

/// Builds the binary if this program runs under cargo, which sets two environment variables.
fn build_under_cargo(folder: &Path) -> Result<()> {
    let (Some(cargo), Some(root)) = (env::var_os("CARGO"), env::var_os("CARGO_MANIFEST_DIR"))
    else {
        return Ok(());
    };
    let manifest = PathBuf::from(root).join("Cargo.toml");
    let (Some(profile), Some(target)) = (folder.file_name(), folder.parent()) else {
        return Ok(());
    };
    // The folder of the profile `dev` has another name.
    let profile = if profile == "debug" { "dev".as_ref() } else { profile };
    let ended = Command::new(cargo)
        .args(["build", "--quiet", "--package", "cordon-fmu", "--profile"])
        .arg(profile)
        .arg("--manifest-path")
        .arg(&manifest)
        .arg("--target-dir")
        .arg(target)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .status()
        .map_err(|e| Error::file("run cargo for", &manifest, e))?;
    if ended.success() {
        return Ok(());
    }
    Err(Error::input(format!("the binary for FMUs cannot be built: run `{BUILD}` to see why")))
}
