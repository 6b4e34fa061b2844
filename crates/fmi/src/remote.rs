//! The parent process of an instance in a child process.

use std::fs::File;
use std::io::{self, BufReader, PipeReader, PipeWriter, Read};
use std::os::fd::AsFd;
use std::os::unix::process::{CommandExt, ExitStatusExt};
use std::process::{Child, Command, ExitStatus};
use std::time::Duration;

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::io::Errno;

use crate::fmu::{Datum, Fmu};
use crate::message::{self, Beginning, Order, Reply};

/// Time allowed for an instance to terminate.
const FAREWELL: Duration = Duration::from_secs(5);

/// An instance in a child process. Dropping it terminates the instance and ends the process.
///
/// Orders and replies go through two pipes, at half the cost of a socket, with one message each way per
/// step. A step can be [begun](Remote::begin_step) without waiting for its end, so that the instances
/// of several processes compute in parallel.
pub struct Remote {
    child: Child,
    orders: PipeWriter,
    answers: BufReader<Patient>,
    /// Whether a reply is outstanding.
    asked: bool,
    dead: bool,
}

/// A pipe that is read with a timeout.
struct Patient {
    pipe: PipeReader,
    limit: Duration,
}

impl Read for Patient {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let limit = Timespec::try_from(self.limit).map_err(io::Error::other)?;
        loop {
            let ready = poll(&mut [PollFd::new(&self.pipe, PollFlags::IN)], Some(&limit));
            match ready {
                Ok(0) => return Err(io::ErrorKind::TimedOut.into()),
                Ok(_) => return self.pipe.read(into),
                Err(Errno::INTR) => {}
                Err(e) => return Err(e.into()),
            }
        }
    }
}

impl Remote {
    /// Starts the program, which has to call [`serve`](crate::host::serve), and makes the instance in
    /// it. A call that takes longer than `limit` is abandoned.
    ///
    /// # Errors
    /// The program cannot be started, or the FMU cannot be loaded.
    pub fn load(mut program: Command, fmu: Fmu, limit: Duration) -> Result<Self, String> {
        let failed = |e: io::Error| format!("starting its process: {e}");
        let (their_orders, orders) = io::pipe().map_err(failed)?;
        let (answers, their_answers) = io::pipe().map_err(failed)?;
        // In its own process group, so that Ctrl-C reaches only this process, which then shuts the
        // child down in order.
        let child = program.stdin(their_orders).stdout(their_answers).process_group(0).spawn();
        let child = child.map_err(failed)?;
        // The command holds the other ends of the pipes; while they are open, the child's death goes
        // unnoticed.
        drop(program);
        let answers = BufReader::new(Patient { pipe: answers, limit });
        let mut remote = Self { child, orders, answers, asked: false, dead: false };
        remote.call(&Order::Load(fmu))?.result?;
        Ok(remote)
    }

    /// Initialises the instance, as [`Instance::initialise`](crate::instance::Instance::initialise).
    pub fn initialise(&mut self, beginning: Beginning) -> Reply {
        self.call(&Order::Initialise(beginning)).unwrap_or_else(Reply::failed)
    }

    /// Begins a step, which runs while this process does something else.
    ///
    /// # Errors
    /// The process has ended.
    pub fn begin_step(&mut self, from: f64, size: f64, inputs: Vec<Datum>) -> Result<(), String> {
        self.ask(&Order::Step { from, size, inputs })
    }

    /// Waits for the end of the step that was [begun](Remote::begin_step), with the reply of
    /// [`Instance::step`](crate::instance::Instance::step).
    pub fn end_step(&mut self) -> Reply {
        self.answer().unwrap_or_else(Reply::failed)
    }

    fn call(&mut self, order: &Order) -> Result<Reply, String> {
        self.ask(order)?;
        self.answer()
    }

    fn ask(&mut self, order: &Order) -> Result<(), String> {
        if self.dead {
            return Err("its process has ended".to_owned());
        }
        let sent = message::write(&mut self.orders, order);
        self.asked = sent.is_ok();
        sent.map_err(|e| self.ended(&e))
    }

    fn answer(&mut self) -> Result<Reply, String> {
        if self.dead {
            return Err("its process has ended".to_owned());
        }
        self.asked = false;
        message::read(&mut self.answers).map_err(|e| self.ended(&e))
    }

    /// Ends a process that gives no reply, and says why.
    fn ended(&mut self, e: &io::Error) -> String {
        self.dead = true;
        // If it is too slow it has to be killed; otherwise it has exited, and this has no effect.
        let _ = self.child.kill();
        match (e.kind() == io::ErrorKind::TimedOut, self.child.wait()) {
            (true, _) => {
                let limit = self.answers.get_ref().limit.as_secs_f64();
                format!("no answer within {limit} s: its process was ended")
            }
            (false, Ok(status)) => died(status),
            (false, Err(e)) => format!("its process has ended: {e}"),
        }
    }
}

impl Drop for Remote {
    fn drop(&mut self) {
        self.answers.get_mut().limit = FAREWELL;
        // A failure at this point changes nothing.
        if self.asked {
            let _ = self.answer();
        }
        let _ = self.call(&Order::Finish);
        if !self.dead {
            let _ = self.child.kill();
            let _ = self.child.wait();
        }
    }
}

/// How a process ended, in words.
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

/// Signals raised by faulty code, by number; these are the same on all Unix systems.
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

/// The pipes to the parent process, in the child: stdin and stdout, as set up by [`Remote::load`]. They
/// are replaced, so that the FMU reads an empty stdin and prints to stderr.
///
/// # Errors
/// Stdin or stdout is closed.
pub fn pipes_to_parent() -> io::Result<(PipeReader, PipeWriter)> {
    let orders = io::stdin().as_fd().try_clone_to_owned()?;
    let answers = io::stdout().as_fd().try_clone_to_owned()?;
    rustix::stdio::dup2_stdin(File::open("/dev/null")?)?;
    rustix::stdio::dup2_stdout(io::stderr())?;
    Ok((orders.into(), answers.into()))
}
