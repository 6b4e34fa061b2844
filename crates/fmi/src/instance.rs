//! An instance of an FMU in this process, and the calls of the standards in the required order.

mod values;

use std::collections::BTreeSet;
use std::ffi::{CString, c_int};
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use crate::c;
use crate::fmu::{Datum, Fmu, Variable, Version};
use crate::library::Library;
use crate::log::{Log, logger_3};
use crate::message::{Beginning, Reply};

/// Instances in one process are called one at a time: many libraries share state between instances.
static CALLS: Mutex<()> = Mutex::new(());

fn one_at_a_time() -> MutexGuard<'static, ()> {
    CALLS.lock().unwrap_or_else(PoisonError::into_inner)
}

const OK: c_int = 0;
const WARNING: c_int = 1;
const FATAL: c_int = 4;
const PENDING: c_int = 5;

/// The value `fmi2CoSimulation` of `fmi2Type`.
const CO_SIMULATION: c_int = 1;
/// The value `fmi2DoStepStatus` of `fmi2StatusKind`.
const DO_STEP_STATUS: c_int = 0;

/// An instance. Dropping it terminates and frees it.
pub struct Instance {
    version: Version,
    library: Library,
    raw: c::Instance,
    log: Log,
    phase: Phase,
    inputs: Vec<Variable>,
    outputs: Vec<Variable>,
    notes: Vec<String>,
    /// Notes made before: each is made once.
    noted: BTreeSet<String>,
    /// FMI 2.0 keeps pointers to these.
    _kept: Box<(c::Callbacks, [CString; 3])>,
}

/// The state of an instance.
#[derive(Clone, Copy, PartialEq)]
enum Phase {
    Made,
    Running,
    /// It failed; it may still be freed.
    Failed,
    /// It returned *fatal*: no further call is allowed.
    Fatal,
}

// SAFETY: the standards allow an instance to move between threads as long as one thread at a time calls
// it; `CALLS` ensures that.
unsafe impl Send for Instance {}

impl Instance {
    /// Loads the binary and makes the instance.
    ///
    /// # Errors
    /// The binary cannot be loaded, lacks functions, or makes no instance; the error is the message.
    pub fn load(fmu: &Fmu) -> Result<Self, String> {
        let _call = one_at_a_time();
        let library = Library::load(&fmu.binary)?;
        let text = |t: &str| CString::new(t).map_err(|_| format!("`{t}`: a text with a zero byte"));
        let resources = resources(&fmu.folder, fmu.version);
        let log = Log::open();
        let callbacks = c::Callbacks {
            logger: c::cordon_fmi2_logger,
            allocate_memory: c::calloc,
            free_memory: c::free,
            step_finished: None,
            environment: log.environment(),
        };
        let texts = [text(&fmu.name)?, text(&fmu.token)?, text(&resources)?];
        let kept = Box::new((callbacks, texts));
        let (callbacks, [name, token, resources]) = &*kept;
        let raw = match fmu.version {
            Version::V2 => {
                // SAFETY: the type is the standard's.
                let make: c::Instantiate2 = unsafe { library.function("fmi2Instantiate") }?;
                let (name, token, resources) = (name.as_ptr(), token.as_ptr(), resources.as_ptr());
                // SAFETY: strings and callbacks live as long as the instance.
                unsafe { make(name, CO_SIMULATION, token, resources, callbacks, 0, 1) }
            }
            Version::V3 => {
                // SAFETY: the type is the standard's.
                let make: c::Instantiate3 =
                    unsafe { library.function("fmi3InstantiateCoSimulation") }?;
                let (name, token, resources) = (name.as_ptr(), token.as_ptr(), resources.as_ptr());
                let (none, environment) = (std::ptr::null(), log.environment());
                // SAFETY: the strings live as long as the instance.
                unsafe {
                    make(
                        name,
                        token,
                        resources,
                        false,
                        true,
                        false,
                        false,
                        none,
                        0,
                        environment,
                        logger_3,
                        None,
                    )
                }
            }
        };
        if raw.is_null() {
            return Err(explained("making an instance: it made none", log.take()));
        }
        Ok(Self {
            version: fmu.version,
            library,
            raw,
            log,
            phase: Phase::Made,
            inputs: Vec::new(),
            outputs: Vec::new(),
            notes: Vec::new(),
            noted: BTreeSet::new(),
            _kept: kept,
        })
    }

    /// Sets the start values, initialises, and reads the outputs.
    pub fn initialise(&mut self, beginning: Beginning) -> Reply {
        let _call = one_at_a_time();
        let result = self.begin(beginning);
        self.answer(result)
    }

    /// Sets the inputs, advances, and reads the outputs.
    pub fn step(&mut self, from: f64, size: f64, inputs: &[Datum]) -> Reply {
        let _call = one_at_a_time();
        let result = self.advance(from, size, inputs);
        self.answer(result)
    }

    fn answer(&mut self, result: Result<Vec<Datum>, String>) -> Reply {
        for said in self.log.take() {
            self.note(said);
        }
        Reply { result, notes: std::mem::take(&mut self.notes) }
    }

    fn note(&mut self, text: String) {
        if self.noted.insert(text.clone()) {
            self.notes.push(text);
        }
    }

    /// Calls in the order of the standards: set up the experiment, set start values, enter
    /// initialisation, set start values again (some FMUs accept them only now), exit initialisation.
    fn begin(&mut self, beginning: Beginning) -> Result<Vec<Datum>, String> {
        let Beginning { parameters, inputs, outputs, stop } = beginning;
        if self.version == Version::V2 {
            // SAFETY: the type is the standard's.
            let set_up: c::SetUp2 = unsafe { self.library.function("fmi2SetupExperiment") }?;
            // SAFETY: the instance is alive.
            let status = unsafe { set_up(self.raw, 0, 0.0, 0.0, 1, stop) };
            self.judge(|| "setting up the experiment".to_owned(), status)?;
        }
        for (variable, value) in parameters.iter().chain(&inputs) {
            self.set(std::slice::from_ref(variable), std::slice::from_ref(value))?;
        }
        let status = match self.version {
            Version::V2 => {
                // SAFETY: the type is the standard's.
                let enter: c::Plain =
                    unsafe { self.library.function("fmi2EnterInitializationMode") }?;
                // SAFETY: the instance is alive.
                unsafe { enter(self.raw) }
            }
            Version::V3 => {
                // SAFETY: the type is the standard's.
                let enter: c::Enter3 =
                    unsafe { self.library.function("fmi3EnterInitializationMode") }?;
                // SAFETY: the instance is alive.
                unsafe { enter(self.raw, false, 0.0, 0.0, true, stop) }
            }
        };
        self.judge(|| "initialising".to_owned(), status)?;
        for (variable, value) in parameters.iter().chain(&inputs) {
            self.set(std::slice::from_ref(variable), std::slice::from_ref(value))?;
        }
        for (variable, value) in &parameters {
            self.read_back(variable, value);
        }
        self.plain("initialising", "ExitInitializationMode")?;
        self.phase = Phase::Running;
        self.inputs = inputs.into_iter().map(|(variable, _)| variable).collect();
        self.outputs = outputs;
        self.outputs()
    }

    fn advance(&mut self, from: f64, size: f64, inputs: &[Datum]) -> Result<Vec<Datum>, String> {
        let variables = std::mem::take(&mut self.inputs);
        let set = self.set(&variables, inputs);
        self.inputs = variables;
        set?;
        match self.version {
            Version::V2 => {
                // SAFETY: the type is the standard's.
                let step: c::Step2 = unsafe { self.library.function("fmi2DoStep") }?;
                // SAFETY: the instance is alive.
                let status = unsafe { step(self.raw, from, size, 1) };
                let status = self.awaited(status)?;
                self.judge(|| "stepping".to_owned(), status)?;
            }
            Version::V3 => {
                let (mut event, mut end, mut early, mut last) = (false, false, false, from);
                // SAFETY: the type is the standard's.
                let step: c::Step3 = unsafe { self.library.function("fmi3DoStep") }?;
                // SAFETY: the instance is alive, and the results can be written.
                let status = unsafe {
                    step(self.raw, from, size, true, &mut event, &mut end, &mut early, &mut last)
                };
                self.judge(|| "stepping".to_owned(), status)?;
                if end || early {
                    return Err(format!("stepping: it stopped at {last} s on its own"));
                }
            }
        }
        self.outputs()
    }

    /// Waits for an asynchronous step.
    fn awaited(&self, mut status: c_int) -> Result<c_int, String> {
        while status == PENDING {
            // SAFETY: the type is the standard's.
            let ask: c::Status2 = unsafe { self.library.function("fmi2GetStatus") }?;
            let mut step = PENDING;
            // SAFETY: the instance is alive, and the status can be written.
            if unsafe { ask(self.raw, DO_STEP_STATUS, &mut step) } > WARNING {
                return Err(explained("waiting for a step: it has no status", self.log.take()));
            }
            status = step;
            if status == PENDING {
                std::thread::sleep(Duration::from_millis(1));
            }
        }
        Ok(status)
    }

    fn outputs(&mut self) -> Result<Vec<Datum>, String> {
        let outputs = std::mem::take(&mut self.outputs);
        let read = self.get(&outputs);
        self.outputs = outputs;
        read
    }

    /// Adds a note if a parameter does not have the value that it was set to.
    fn read_back(&mut self, variable: &Variable, value: &Datum) {
        let name = &variable.name;
        let failed_before = self.phase;
        let note = match self.get(std::slice::from_ref(variable)) {
            Ok(read) if read.first() == Some(value) => return,
            Ok(read) => match read.first() {
                Some(found) => format!(
                    "parameter `{name}` was set to `{}` and reads back as `{}`",
                    values::shown(value),
                    values::shown(found)
                ),
                None => return,
            },
            Err(why) => format!("parameter `{name}` cannot be read back: {why}"),
        };
        if self.phase == Phase::Failed {
            self.phase = failed_before;
        }
        self.note(note);
    }

    /// Calls a function that takes only the instance.
    fn plain(&mut self, call: &str, function: &str) -> Result<(), String> {
        let prefix = match self.version {
            Version::V2 => "fmi2",
            Version::V3 => "fmi3",
        };
        // SAFETY: the type is the standard's.
        let function: c::Plain = unsafe { self.library.function(&format!("{prefix}{function}")) }?;
        // SAFETY: the instance is alive.
        let status = unsafe { function(self.raw) };
        self.judge(|| call.to_owned(), status)
    }

    /// Interprets a status: all but *OK* and *warning* are failures, and a warning is noted.
    fn judge(&mut self, call: impl Fn() -> String, status: c_int) -> Result<(), String> {
        let word = match status {
            OK => return Ok(()),
            WARNING => {
                let said = self.log.take();
                self.note(explained(&format!("{}: warning", call()), said));
                return Ok(());
            }
            2 => "discarded",
            3 => "error",
            FATAL => "fatal",
            PENDING => "pending",
            _ => "a status that the standard does not have",
        };
        self.phase = if status == FATAL { Phase::Fatal } else { Phase::Failed };
        Err(explained(&format!("{}: {word}", call()), self.log.take()))
    }
}

impl Drop for Instance {
    fn drop(&mut self) {
        let _call = one_at_a_time();
        if self.phase == Phase::Running {
            // The run is over; a failure now changes nothing.
            let _ = self.plain("terminating", "Terminate");
        }
        if self.phase == Phase::Fatal {
            return;
        }
        let name = match self.version {
            Version::V2 => "fmi2FreeInstance",
            Version::V3 => "fmi3FreeInstance",
        };
        // SAFETY: the type is the standard's.
        if let Ok(free) = unsafe { self.library.function::<c::Free>(name) } {
            // SAFETY: the instance is alive, and nothing calls it any more.
            unsafe { free(self.raw) };
        }
    }
}

/// The message of a failure, with the FMU's own log messages.
fn explained(what: &str, said: Vec<String>) -> String {
    match said.is_empty() {
        true => format!("{what}, without a message"),
        false => format!("{what}: {}", said.join("; ")),
    }
}

/// The location of the resources in the form required by the standard: a URI, or a path that ends in a
/// separator.
fn resources(folder: &Path, version: Version) -> String {
    let path = folder.join("resources");
    match version {
        Version::V2 => {
            let mut uri = "file://".to_owned();
            for byte in path.to_string_lossy().replace('\\', "/").bytes() {
                match byte {
                    b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'/' | b'-' | b'.' | b'_' | b'~' => {
                        uri.push(char::from(byte));
                    }
                    _ => uri.push_str(&format!("%{byte:02X}")),
                }
            }
            uri
        }
        Version::V3 => format!("{}{}", path.display(), std::path::MAIN_SEPARATOR),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn resources_are_a_uri_or_a_path_with_a_separator_at_its_end() {
        let folder = Path::new("/tmp/a b%");
        assert_eq!(resources(folder, Version::V2), "file:///tmp/a%20b%25/resources");
        assert_eq!(resources(folder, Version::V3), "/tmp/a b%/resources/");
    }
}
