//! The parent's side of an instance in a child process.

use std::io::{self, BufReader};
use std::os::fd::{AsFd, OwnedFd};
use std::os::unix::net::UnixStream;
use std::os::unix::process::{CommandExt, ExitStatusExt};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::Duration;

use crate::fmu::{Datum, Fmu};
use crate::message::{self, Beginning, Order, Reply};

/// How long an instance may take to terminate.
const FAREWELL: Duration = Duration::from_secs(5);

/// An instance in a child process. Dropping it terminates the instance and ends the process.
pub struct Remote {
    child: Child,
    /// Reads a message in one call of the system; it is written to as it is.
    stream: BufReader<UnixStream>,
    limit: Duration,
    dead: bool,
}

impl Remote {
    /// Starts the program, which has to call [`serve`](crate::host::serve), and has it make the instance. A call that
    /// takes longer than `limit` is given up.
    ///
    /// # Errors
    /// The program cannot be started, or the FMU cannot be loaded.
    pub fn load(mut program: Command, fmu: Fmu, limit: Duration) -> Result<Self, String> {
        let failed = |e: io::Error| format!("starting its process: {e}");
        let (stream, theirs) = UnixStream::pair().map_err(failed)?;
        stream.set_read_timeout(Some(limit)).map_err(failed)?;
        // The FMU may print; its process group is its own, so that Ctrl-C reaches this process
        // only, which takes the other down in order.
        let child = program
            .stdin(Stdio::from(OwnedFd::from(theirs)))
            .stdout(Stdio::from(io::stderr()))
            .process_group(0)
            .spawn()
            .map_err(failed)?;
        let mut remote = Self { child, stream: BufReader::new(stream), limit, dead: false };
        remote.call(&Order::Load(fmu))?.result?;
        Ok(remote)
    }

    /// As [`Instance::initialise`](crate::instance::Instance::initialise).
    pub fn initialise(&mut self, beginning: Beginning) -> Reply {
        self.answered(&Order::Initialise(beginning))
    }

    /// As [`Instance::step`](crate::instance::Instance::step).
    pub fn step(&mut self, from: f64, size: f64, inputs: Vec<Datum>) -> Reply {
        self.answered(&Order::Step { from, size, inputs })
    }

    fn answered(&mut self, order: &Order) -> Reply {
        let failed = |why| Reply { result: Err(why), notes: Vec::new() };
        self.call(order).unwrap_or_else(failed)
    }

    fn call(&mut self, order: &Order) -> Result<Reply, String> {
        if self.dead {
            return Err("its process has ended".to_owned());
        }
        let sent = message::write(self.stream.get_mut(), order);
        let answer = sent.and_then(|()| message::read(&mut self.stream));
        answer.map_err(|e| {
            self.dead = true;
            let slow = matches!(e.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut);
            // Where it is slow it has to be ended; else it has ended, and this does nothing.
            let _ = self.child.kill();
            let ended = self.child.wait();
            match (slow, ended) {
                (true, _) => format!(
                    "no answer within {} s: its process was ended",
                    self.limit.as_secs_f64()
                ),
                (false, Ok(status)) => died(status),
                (false, Err(e)) => format!("its process has ended: {e}"),
            }
        })
    }
}

impl Drop for Remote {
    fn drop(&mut self) {
        if !self.dead && self.stream.get_ref().set_read_timeout(Some(FAREWELL)).is_ok() {
            // What it says in the end changes nothing.
            let _ = self.call(&Order::Finish);
        }
        if !self.dead {
            let _ = self.child.kill();
            let _ = self.child.wait();
        }
    }
}

/// How a process ended.
fn died(status: ExitStatus) -> String {
    match (status.signal(), status.code()) {
        (Some(signal), _) => match signal_name(signal) {
            Some(name) => format!("its process was killed by signal {signal} ({name})"),
            None => format!("its process was killed by signal {signal}"),
        },
        (None, Some(code)) => format!("it ended its process (exit code {code})"),
        (None, None) => "its process has ended".to_owned(),
    }
}

/// Signals that faulty code dies of, by their numbers, which all Unix systems share.
fn signal_name(signal: i32) -> Option<&'static str> {
    Some(match signal {
        4 => "SIGILL",
        6 => "SIGABRT",
        8 => "SIGFPE",
        9 => "SIGKILL",
        11 => "SIGSEGV",
        15 => "SIGTERM",
        _ => return None,
    })
}

/// The stream to the parent process, in the child: [`Remote::load`] makes it stdin.
///
/// # Errors
/// Stdin is closed.
pub fn stream_to_parent() -> io::Result<UnixStream> {
    Ok(UnixStream::from(io::stdin().as_fd().try_clone_to_owned()?))
}
