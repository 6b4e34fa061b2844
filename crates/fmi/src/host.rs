//! The child process: one instance, which carries out the orders of the parent.

use std::io::{BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use crate::fmu::Fmu;
use crate::instance::Instance;
use crate::message::{self, Order, Reply};

/// Carries out orders until the last one, or until a pipe to the parent process is closed.
pub fn serve(orders: impl Read, answers: impl Write) {
    let mut folder = None;
    let ended = attend(orders, answers, &mut folder);
    // The parent process has died: nobody else will remove the unpacked archive.
    if let (Err(_), Some(folder)) = (ended, folder) {
        remove(&folder);
    }
}

/// Answers orders until the last one; `folder` is where the archive is unpacked, once that is known.
fn attend(
    orders: impl Read,
    mut answers: impl Write,
    folder: &mut Option<PathBuf>,
) -> std::io::Result<()> {
    // Read a whole message (length and content) in one system call.
    let mut orders = BufReader::new(orders);
    let mut instance: Option<Instance> = None;
    loop {
        let answer = match (message::read(&mut orders)?, &mut instance) {
            (Order::Load(fmu), _) => {
                watch_over(&fmu);
                *folder = Some(fmu.folder.clone());
                let made = Instance::load(&fmu);
                let result = made.map(|made| {
                    instance = Some(made);
                    Vec::new()
                });
                Reply { result, notes: Vec::new() }
            }
            (Order::Initialise(beginning), Some(instance)) => instance.initialise(beginning),
            (Order::Step { from, size, inputs }, Some(instance)) => {
                instance.step(from, size, &inputs)
            }
            (Order::Finish, _) => {
                drop(instance.take());
                let done = Reply { result: Ok(Vec::new()), notes: Vec::new() };
                return message::write(&mut answers, &done);
            }
            (_, None) => Reply::failed("there is no instance".to_owned()),
        };
        message::write(&mut answers, &answer)?;
    }
}

/// Removes an unpacked archive completely. The main thread and the watching thread may both call this.
fn remove(folder: &Path) {
    static ONE: Mutex<()> = Mutex::new(());
    let _one = ONE.lock().unwrap_or_else(PoisonError::into_inner);
    // There is nobody left to report a failure to.
    let _ = std::fs::remove_dir_all(folder);
}

/// Exits and removes the unpacked archive when the parent process is gone: it may be killed while the
/// FMU computes.
#[cfg(unix)]
fn watch_over(fmu: &Fmu) {
    let parent = std::os::unix::process::parent_id();
    let folder: PathBuf = fmu.folder.clone();
    std::thread::spawn(move || {
        while std::os::unix::process::parent_id() == parent {
            std::thread::sleep(std::time::Duration::from_millis(200));
        }
        remove(&folder);
        std::process::exit(1);
    });
}

#[cfg(not(unix))]
fn watch_over(_: &Fmu) {}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::fmu::Version;

    /// A parent process that is gone: answers cannot be written.
    struct Gone;

    impl Write for Gone {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(std::io::ErrorKind::BrokenPipe.into())
        }

        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }

    /// Whichever process outlives the other removes the folder: the child if its answer cannot be
    /// delivered, otherwise the parent.
    #[test]
    fn the_archive_is_removed_where_nobody_takes_the_answer() {
        let folder = std::env::temp_dir().join(format!("cordon-host-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let (token, name) = (String::new(), "plant".to_owned());
        let binary = folder.join("missing.so");
        let fmu = Fmu { folder: folder.clone(), binary, version: Version::V2, token, name };
        let mut orders = Vec::new();
        for order in [Order::Load(fmu), Order::Finish] {
            message::write(&mut orders, &order).unwrap();
        }
        serve(orders.as_slice(), Vec::new());
        assert!(folder.exists());
        serve(orders.as_slice(), Gone);
        assert!(!folder.exists());
    }
}
