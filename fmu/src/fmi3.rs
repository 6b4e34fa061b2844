//! FMI 3.0: the functions for co-simulation. The rest is in [`crate::fmi3_unsupported`].

use std::ffi::{CStr, c_char, c_uint, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use cordon_cosim::fmi::interface::FmiVersion;
use cordon_cosim::fmi::slave::{Refusal, Slave};
use cordon_cosim::unit::Value;

use crate::component::{self, Component, LOG_CATEGORY, Log, Status};
use crate::convert;

/// `fmi3Instance`.
pub type Instance = *mut c_void;
/// `fmi3FMUState`.
type State = *mut c_void;

/// `fmi3LogMessageCallback`.
type LogMessage = unsafe extern "C" fn(
    environment: *mut c_void,
    status: Status,
    category: *const c_char,
    message: *const c_char,
);

/// The importer's logger, silent unless messages were requested.
pub struct Log3 {
    log_message: Option<LogMessage>,
    environment: *mut c_void,
    on: bool,
}

impl Log for Log3 {
    fn log(&self, _instance: &CStr, status: Status, message: &CStr) {
        if let (true, Some(log_message)) = (self.on, self.log_message) {
            let (category, message) = (LOG_CATEGORY.as_ptr(), message.as_ptr());
            // SAFETY: the importer passed this function and its environment for this use; the strings
            // are zero-terminated and outlive the call.
            unsafe { log_message(self.environment, status, category, message) };
        }
    }
}

/// Runs `body` on the instance, see [`component::with`].
///
/// # Safety
/// As for [`component::with`].
pub unsafe fn with(
    instance: Instance,
    body: impl FnOnce(&mut Component<Log3>) -> Result<(), Refusal>,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { component::with(instance, body) }
}

/// The version of the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

/// Makes an instance for co-simulation; null if that fails, with the reason in the log.
///
/// # Safety
/// The strings are zero-terminated; the functions are the importer's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateCoSimulation(
    instance_name: *const c_char,
    token: *const c_char,
    resource_path: *const c_char,
    _visible: bool,
    logging_on: bool,
    event_mode_used: bool,
    _early_return_allowed: bool,
    _intermediate_variables: *const c_uint,
    intermediate_count: usize,
    environment: *mut c_void,
    log_message: Option<LogMessage>,
    _intermediate_update: Option<unsafe extern "C" fn()>,
) -> Instance {
    let log = Log3 { log_message, environment, on: logging_on };
    // SAFETY: the caller vouches for it.
    let texts =
        || unsafe { Ok::<_, Refusal>((convert::text(instance_name)?, convert::text(token)?)) };
    let made = catch_unwind(AssertUnwindSafe(|| {
        let (name, token) = texts()?;
        if event_mode_used {
            return Err(Refusal::error("this FMU has no event mode"));
        }
        if intermediate_count > 0 {
            return Err(Refusal::error("this FMU has no intermediate updates"));
        }
        // SAFETY: the caller vouches for it.
        let resources = unsafe { convert::text(resource_path) }.ok().map(Path::new);
        Ok((name, Slave::instantiate(FmiVersion::V3, name, token, resources)?))
    }));
    let refusal = match made {
        Ok(Ok((name, slave))) => {
            let name = component::c_text(name);
            return component::hand_out(Component { name, slave, log, texts: Vec::new() });
        }
        Ok(Err(refusal)) => refusal,
        Err(_) => Refusal::fatal("internal fault: no instance was made"),
    };
    refuse(&log, &refusal)
}

/// Logs why no instance was made, and returns null.
pub fn refuse(log: &Log3, refusal: &Refusal) -> Instance {
    log.log(c"", component::status_of(refusal), &component::c_text(&refusal.message));
    std::ptr::null_mut()
}

impl Log3 {
    /// The log for a request of an instance of another interface type.
    pub fn of(log_message: Option<LogMessage>, environment: *mut c_void, on: bool) -> Self {
        Self { log_message, environment, on }
    }
}

/// Frees an instance.
///
/// # Safety
/// `instance` is null or was not freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeInstance(instance: Instance) {
    // SAFETY: the caller vouches for it.
    unsafe { component::free::<Log3>(instance) };
}

/// Switches messages on or off.
///
/// # Safety
/// `instance` is one; `categories` has `count` strings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetDebugLogging(
    instance: Instance,
    logging_on: bool,
    count: usize,
    categories: *const *const c_char,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe {
        with(instance, |c| {
            component::known_categories(categories, count)?;
            c.log.on = logging_on;
            Ok(())
        })
    }
}

/// Begins the initialisation.
///
/// # Safety
/// `instance` is one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterInitializationMode(
    instance: Instance,
    _tolerance_defined: bool,
    _tolerance: f64,
    start_time: f64,
    stop_time_defined: bool,
    stop_time: f64,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe {
        with(instance, |c| {
            c.slave.set_up(start_time, stop_time_defined.then_some(stop_time))?;
            c.slave.enter_initialisation()
        })
    }
}

/// Functions that take only the instance.
macro_rules! plain {
    ($($(#[$doc:meta])* $name:ident => $call:expr;)*) => {$(
        $(#[$doc])*
        ///
        /// # Safety
        /// `instance` is one.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(instance: Instance) -> Status {
            // SAFETY: the caller vouches for it.
            unsafe { with(instance, |c| $call(&mut c.slave)) }
        }
    )*};
}

plain! {
    /// Ends the initialisation.
    fmi3ExitInitializationMode => Slave::exit_initialisation;
    /// Ends the run.
    fmi3Terminate => Slave::terminate;
    /// Returns to the state after instantiation.
    fmi3Reset => Slave::reset;
}

/// Getters and setters for types with a direct representation in C.
macro_rules! values {
    ($($get:ident, $set:ident, $c_type:ty, $read:path, $write:path;)*) => {$(
        /// Reads variables of this type.
        ///
        /// # Safety
        /// `instance` is one; the arrays have the stated lengths.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $get(
            instance: Instance,
            references: *const c_uint,
            count: usize,
            values: *mut $c_type,
            value_count: usize,
        ) -> Status {
            // SAFETY: the caller vouches for it.
            unsafe {
                with(instance, |c| {
                    let references = convert::slice(references, count)?;
                    let values = convert::slice_mut(values, value_count)?;
                    same_length(count, value_count)?;
                    for (reference, place) in references.iter().zip(values) {
                        *place = $read(&mut c.slave, *reference)?;
                    }
                    Ok(())
                })
            }
        }

        /// Sets variables of this type.
        ///
        /// # Safety
        /// `instance` is one; the arrays have the stated lengths.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $set(
            instance: Instance,
            references: *const c_uint,
            count: usize,
            values: *const $c_type,
            value_count: usize,
        ) -> Status {
            // SAFETY: the caller vouches for it.
            unsafe {
                with(instance, |c| {
                    let references = convert::slice(references, count)?;
                    let values = convert::slice(values, value_count)?;
                    same_length(count, value_count)?;
                    for (reference, value) in references.iter().zip(values) {
                        c.slave.set(*reference, &$write(*value))?;
                    }
                    Ok(())
                })
            }
        }
    )*};
}

values! {
    fmi3GetFloat64, fmi3SetFloat64, f64, Slave::real, Value::Real;
    fmi3GetInt64, fmi3SetInt64, i64, Slave::integer, Value::Integer;
    fmi3GetBoolean, fmi3SetBoolean, bool, Slave::boolean, Value::Boolean;
}

/// Checks that there is one value per variable: all variables are scalars.
fn same_length(references: usize, values: usize) -> Result<(), Refusal> {
    if references == values {
        return Ok(());
    }
    Err(Refusal::error(format!("{values} values for {references} variables: expected one each")))
}

/// Reads strings; they are valid until the next call.
///
/// # Safety
/// `instance` is one; the arrays have the stated lengths.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetString(
    instance: Instance,
    references: *const c_uint,
    count: usize,
    values: *mut *const c_char,
    value_count: usize,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe {
        with(instance, |c| {
            same_length(count, value_count)?;
            component::get_texts(c, references, values, count)
        })
    }
}

/// Sets strings.
///
/// # Safety
/// `instance` is one; the arrays have the stated lengths.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetString(
    instance: Instance,
    references: *const c_uint,
    count: usize,
    values: *const *const c_char,
    value_count: usize,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe {
        with(instance, |c| {
            same_length(count, value_count)?;
            component::set_texts(c, references, values, count)
        })
    }
}

/// Saves the current state.
///
/// # Safety
/// `instance` is one; `state` points to null or to a state created here.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFMUState(instance: Instance, state: *mut State) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(instance, |c| component::save(c, state)) }
}

/// Restores a saved state.
///
/// # Safety
/// `instance` is one, `state` was created here.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFMUState(instance: Instance, state: State) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(instance, |c| c.slave.restore(component::snapshot(state)?)) }
}

/// Frees a state.
///
/// # Safety
/// `instance` is one; `state` is null or points to null or to a state created here.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeFMUState(instance: Instance, state: *mut State) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(instance, |_| component::free_snapshot(state)) }
}

/// The size in bytes of a serialised state.
///
/// # Safety
/// `instance` is one, `state` was created here, `size` can be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializedFMUStateSize(
    instance: Instance,
    state: State,
    size: *mut usize,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(instance, |_| component::serialized_size(state, size)) }
}

/// Serialises a state.
///
/// # Safety
/// `instance` is one, `state` was created here, `bytes` has room for `size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializeFMUState(
    instance: Instance,
    state: State,
    bytes: *mut u8,
    size: usize,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(instance, |_| component::serialize(state, bytes, size)) }
}

/// Deserialises a state.
///
/// # Safety
/// `instance` is one, `bytes` has `size` bytes, `state` can be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DeserializeFMUState(
    instance: Instance,
    bytes: *const u8,
    size: usize,
    state: *mut State,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(instance, |c| component::deserialize(c, bytes, size, state)) }
}

/// Advances by a step. It never needs event handling, ends the run or returns early.
///
/// # Safety
/// `instance` is one; the results can be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DoStep(
    instance: Instance,
    communication_point: f64,
    step_size: f64,
    _no_set_state_prior: bool,
    event_handling_needed: *mut bool,
    terminate_simulation: *mut bool,
    early_return: *mut bool,
    last_successful_time: *mut f64,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe {
        with(instance, |c| {
            *convert::place(event_handling_needed)? = false;
            *convert::place(terminate_simulation)? = false;
            *convert::place(early_return)? = false;
            let last = convert::place(last_successful_time)?;
            let ended = c.slave.do_step(communication_point, step_size);
            *last = c.slave.time();
            ended
        })
    }
}
