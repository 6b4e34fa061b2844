//! The child process's side: one instance, which does what it is told.

use std::io::{BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use crate::fmu::Fmu;
use crate::instance::Instance;
use crate::message::{self, Order, Reply};

/// Carries out orders until the last one, or until nobody sends any more.
///
/// # Errors
/// The answers cannot be written.
pub fn serve(orders: impl Read, mut answers: impl Write) -> std::io::Result<()> {
    // A message a call of the system: the length and what follows come together.
    let mut orders = BufReader::new(orders);
    let mut instance: Option<Instance> = None;
    let mut folder: Option<PathBuf> = None;
    loop {
        let Ok(order) = message::read(&mut orders) else {
            // The parent process has died: nobody else removes the unpacked archive.
            drop(instance);
            if let Some(folder) = folder {
                remove(&folder);
            }
            return Ok(());
        };
        let answer = match (order, &mut instance) {
            (Order::Load(fmu), _) => {
                watch_over(&fmu);
                folder = Some(fmu.folder.clone());
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
                return message::write(
                    &mut answers,
                    &Reply { result: Ok(Vec::new()), notes: Vec::new() },
                );
            }
            (_, None) => Reply::failed("there is no instance".to_owned()),
        };
        message::write(&mut answers, &answer)?;
    }
}

/// Removes an unpacked archive, of which nothing may be left. The main thread and the watching one
/// may both come here.
fn remove(folder: &Path) {
    static ONE: Mutex<()> = Mutex::new(());
    let _one = ONE.lock().unwrap_or_else(PoisonError::into_inner);
    // There is nobody to tell where it cannot be removed.
    let _ = std::fs::remove_dir_all(folder);
}

/// Ends this process, and removes the unpacked archive, where the parent process is gone: it may
/// have been killed while the FMU computes.
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
