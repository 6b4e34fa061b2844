//! FMI 2.0.

use std::ffi::{CStr, c_char, c_int, c_uint, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};

use cordon_cosim::fmi::interface::FmiVersion;
use cordon_cosim::fmi::slave::{Refusal, Slave};
use cordon_cosim::fmi::uri;
use cordon_cosim::unit::Value;

use crate::component::{self, Component, LOG_CATEGORY, Log, Status};
use crate::convert;

/// `fmi2Component`.
type Instance = *mut c_void;
/// `fmi2FMUstate`.
type State = *mut c_void;

/// `fmi2CallbackLogger`.
type Logger = unsafe extern "C" fn(
    environment: *mut c_void,
    instance: *const c_char,
    status: Status,
    category: *const c_char,
    message: *const c_char,
    ...
);

/// `fmi2CallbackFunctions`. The memory functions are not used here, but are part of the layout.
#[repr(C)]
pub struct Callbacks {
    logger: Option<Logger>,
    allocate_memory: Option<unsafe extern "C" fn(usize, usize) -> *mut c_void>,
    free_memory: Option<unsafe extern "C" fn(*mut c_void)>,
    step_finished: Option<unsafe extern "C" fn(*mut c_void, Status)>,
    environment: *mut c_void,
}

/// The importer's logger. Errors are always logged: the standard's `loggingOn` concerns debug messages,
/// of which there are none.
pub struct Log2 {
    logger: Option<Logger>,
    environment: *mut c_void,
}

impl Log for Log2 {
    fn log(&self, instance: &CStr, status: Status, message: &CStr) {
        if let Some(logger) = self.logger {
            // The message is passed to `%s`: it may contain per cent signs.
            let (format, category) = (c"%s".as_ptr(), LOG_CATEGORY.as_ptr());
            let (instance, message) = (instance.as_ptr(), message.as_ptr());
            // SAFETY: the importer passed this function and its environment for this use; the strings
            // are zero-terminated and outlive the call.
            unsafe { logger(self.environment, instance, status, category, format, message) };
        }
    }
}

/// Runs `body` on the instance, see [`component::with`].
///
/// # Safety
/// As for [`component::with`].
unsafe fn with(
    c: Instance,
    body: impl FnOnce(&mut Component<Log2>) -> Result<(), Refusal>,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { component::with(c, body) }
}

/// The version of the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

/// The platform types of the interface, `default`.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

/// Makes an instance; null if that fails, with the reason in the log.
///
/// # Safety
/// The strings are zero-terminated; `functions` is null or points to the importer's functions.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Instantiate(
    instance_name: *const c_char,
    fmu_type: c_int,
    guid: *const c_char,
    resource_location: *const c_char,
    functions: *const Callbacks,
    _visible: c_int,
    _logging_on: c_int,
) -> Instance {
    // SAFETY: the caller vouches for it.
    let log = match unsafe { functions.as_ref() } {
        Some(f) => Log2 { logger: f.logger, environment: f.environment },
        None => Log2 { logger: None, environment: std::ptr::null_mut() },
    };
    // SAFETY: the caller vouches for it.
    let texts =
        || unsafe { Ok::<_, Refusal>((convert::text(instance_name)?, convert::text(guid)?)) };
    let made = catch_unwind(AssertUnwindSafe(|| {
        let (name, guid) = texts()?;
        match fmu_type {
            CO_SIMULATION => {
                // A location that is not a local folder is an error only for units that carry files.
                // SAFETY: as required of the caller.
                let location = unsafe { convert::text(resource_location) }.ok();
                let resources = location.and_then(|location| uri::path(location).ok());
                Ok((name, Slave::instantiate(FmiVersion::V2, name, guid, resources.as_deref())?))
            }
            _ => Err(Refusal::error("this FMU is for co-simulation, not for model exchange")),
        }
    }));
    let refusal = match made {
        Ok(Ok((name, slave))) => {
            let name = component::c_text(name);
            return component::hand_out(Component { name, slave, log, texts: Vec::new() });
        }
        Ok(Err(refusal)) => refusal,
        Err(_) => Refusal::fatal("internal fault: no instance was made"),
    };
    // SAFETY: the caller vouches for it.
    let name = unsafe { convert::text(instance_name) }.unwrap_or("unnamed");
    let status = component::status_of(&refusal);
    log.log(&component::c_text(name), status, &component::c_text(&refusal.message));
    std::ptr::null_mut()
}

/// `fmi2CoSimulation` of `fmi2Type`.
const CO_SIMULATION: c_int = 1;

/// Frees an instance.
///
/// # Safety
/// `c` is null or an instance that was not freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeInstance(c: Instance) {
    // SAFETY: the caller vouches for it.
    unsafe { component::free::<Log2>(c) };
}

/// Switches debug messages, of which there are none.
///
/// # Safety
/// `c` is an instance; `categories` has `count` strings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetDebugLogging(
    c: Instance,
    _logging_on: c_int,
    count: usize,
    categories: *const *const c_char,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |_| component::known_categories(categories, count)) }
}

/// Sets the start of the run and, optionally, its end.
///
/// # Safety
/// `c` is an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetupExperiment(
    c: Instance,
    _tolerance_defined: c_int,
    _tolerance: f64,
    start_time: f64,
    stop_time_defined: c_int,
    stop_time: f64,
) -> Status {
    let stop = (stop_time_defined != 0).then_some(stop_time);
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |c| c.slave.set_up(start_time, stop)) }
}

/// Functions that take only the instance.
macro_rules! plain {
    ($($(#[$doc:meta])* $name:ident => $call:expr;)*) => {$(
        $(#[$doc])*
        ///
        /// # Safety
        /// `c` is an instance.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(c: Instance) -> Status {
            // SAFETY: the caller vouches for it.
            unsafe { with(c, |c| $call(&mut c.slave)) }
        }
    )*};
}

plain! {
    /// Begins the initialisation.
    fmi2EnterInitializationMode => Slave::enter_initialisation;
    /// Ends the initialisation.
    fmi2ExitInitializationMode => Slave::exit_initialisation;
    /// Ends the run.
    fmi2Terminate => Slave::terminate;
    /// Returns to the state after instantiation.
    fmi2Reset => Slave::reset;
    /// Cancels an asynchronous step: there are none, all steps are complete when they return.
    fmi2CancelStep => |_: &mut Slave| Err(Refusal::error("no step is under way"));
}

/// Getters and setters for types with a direct representation in C.
macro_rules! values {
    ($($get:ident, $set:ident, $c_type:ty, $read:path, $to_c:expr, $write:expr;)*) => {$(
        /// Reads variables of this type.
        ///
        /// # Safety
        /// `c` is an instance; `references` and `values` have `count` elements.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $get(
            c: Instance,
            references: *const c_uint,
            count: usize,
            values: *mut $c_type,
        ) -> Status {
            // SAFETY: the caller vouches for it.
            unsafe {
                with(c, |c| {
                    let references = convert::slice(references, count)?;
                    let values = convert::slice_mut(values, count)?;
                    for (reference, place) in references.iter().zip(values) {
                        *place = $to_c($read(&mut c.slave, *reference)?)?;
                    }
                    Ok(())
                })
            }
        }

        /// Sets variables of this type.
        ///
        /// # Safety
        /// `c` is an instance; `references` and `values` have `count` elements.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $set(
            c: Instance,
            references: *const c_uint,
            count: usize,
            values: *const $c_type,
        ) -> Status {
            // SAFETY: the caller vouches for it.
            unsafe {
                with(c, |c| {
                    let references = convert::slice(references, count)?;
                    let values = convert::slice(values, count)?;
                    for (reference, value) in references.iter().zip(values) {
                        c.slave.set(*reference, &$write(*value)?)?;
                    }
                    Ok(())
                })
            }
        }
    )*};
}

values! {
    fmi2GetReal, fmi2SetReal, f64, Slave::real,
        |x: f64| Ok::<_, Refusal>(x), |x: f64| Ok::<_, Refusal>(Value::Real(x));
    fmi2GetInteger, fmi2SetInteger, c_int, Slave::integer,
        |n: i64| c_int::try_from(n).map_err(|_| Refusal::error(format!("`{n}` needs more than 32 bits"))),
        |n: c_int| Ok::<_, Refusal>(Value::Integer(n.into()));
    fmi2GetBoolean, fmi2SetBoolean, c_int, Slave::boolean,
        |b: bool| Ok::<_, Refusal>(c_int::from(b)), |b: c_int| Ok::<_, Refusal>(Value::Boolean(b != 0));
}

/// Reads strings; they are valid until the next call.
///
/// # Safety
/// `c` is an instance; `references` and `values` have `count` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetString(
    c: Instance,
    references: *const c_uint,
    count: usize,
    values: *mut *const c_char,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |c| component::get_texts(c, references, values, count)) }
}

/// Sets strings.
///
/// # Safety
/// `c` is an instance; `references` and `values` have `count` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetString(
    c: Instance,
    references: *const c_uint,
    count: usize,
    values: *const *const c_char,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |c| component::set_texts(c, references, values, count)) }
}

/// Saves the current state.
///
/// # Safety
/// `c` is an instance; `state` points to null or to a state created here.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetFMUstate(c: Instance, state: *mut State) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |c| component::save(c, state)) }
}

/// Restores a saved state.
///
/// # Safety
/// `c` is an instance, `state` a state created here.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetFMUstate(c: Instance, state: State) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |c| c.slave.restore(component::snapshot(state)?)) }
}

/// Frees a state.
///
/// # Safety
/// `c` is an instance; `state` is null or points to null or to a state created here.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeFMUstate(c: Instance, state: *mut State) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |_| component::free_snapshot(state)) }
}

/// The size in bytes of a serialised state.
///
/// # Safety
/// `c` is an instance, `state` a state created here, `size` can be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializedFMUstateSize(
    c: Instance,
    state: State,
    size: *mut usize,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |_| component::serialized_size(state, size)) }
}

/// Serialises a state.
///
/// # Safety
/// `c` is an instance, `state` a state created here, `bytes` has room for `size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializeFMUstate(
    c: Instance,
    state: State,
    bytes: *mut c_char,
    size: usize,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |_| component::serialize(state, bytes.cast(), size)) }
}

/// Deserialises a state.
///
/// # Safety
/// `c` is an instance, `bytes` has `size` bytes, `state` can be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DeSerializeFMUstate(
    c: Instance,
    bytes: *const c_char,
    size: usize,
    state: *mut State,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |c| component::deserialize(c, bytes.cast(), size, state)) }
}

/// Directional derivatives: not provided, as declared in the model description.
///
/// # Safety
/// `c` is an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetDirectionalDerivative(
    c: Instance,
    _unknowns: *const c_uint,
    _unknown_count: usize,
    _knowns: *const c_uint,
    _known_count: usize,
    _known_changes: *const f64,
    _unknown_changes: *mut f64,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |_| Err(Refusal::error("directional derivatives are not provided"))) }
}

/// Derivatives of inputs: not accepted, as declared in the model description.
///
/// # Safety
/// `c` is an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetRealInputDerivatives(
    c: Instance,
    _references: *const c_uint,
    _count: usize,
    _orders: *const c_int,
    _values: *const f64,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |_| Err(Refusal::error("inputs are held, not interpolated"))) }
}

/// Derivatives of outputs: not provided, as declared in the model description.
///
/// # Safety
/// `c` is an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealOutputDerivatives(
    c: Instance,
    _references: *const c_uint,
    _count: usize,
    _orders: *const c_int,
    _values: *mut f64,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |_| Err(Refusal::error("derivatives of outputs are not provided"))) }
}

/// Advances by a step.
///
/// # Safety
/// `c` is an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DoStep(
    c: Instance,
    communication_point: f64,
    step_size: f64,
    _no_set_state_prior: c_int,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |c| c.slave.do_step(communication_point, step_size)) }
}

/// The refusal of questions about a pending step: there never is one.
const NOTHING_PENDING: &str = "no step is under way";

/// Status of an asynchronous step: there are none, all steps are complete when they return.
///
/// # Safety
/// `c` is an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetStatus(c: Instance, _kind: c_int, _value: *mut Status) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |_| Err(Refusal::error(NOTHING_PENDING))) }
}

/// The end time of the last step.
///
/// # Safety
/// `c` is an instance, `value` can be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealStatus(c: Instance, kind: c_int, value: *mut f64) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe {
        with(c, |c| {
            let value = convert::place(value)?;
            if kind != LAST_SUCCESSFUL_TIME {
                return Err(Refusal::error(NOTHING_PENDING));
            }
            *value = c.slave.time();
            Ok(())
        })
    }
}

/// `fmi2LastSuccessfulTime` of `fmi2StatusKind`.
const LAST_SUCCESSFUL_TIME: c_int = 2;
/// `fmi2Terminated` of `fmi2StatusKind`.
const TERMINATED: c_int = 3;

/// Integer status of a pending step: the standard defines none.
///
/// # Safety
/// `c` is an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetIntegerStatus(
    c: Instance,
    _kind: c_int,
    _value: *mut c_int,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |_| Err(Refusal::error(NOTHING_PENDING))) }
}

/// Whether the instance wants the run to end: never.
///
/// # Safety
/// `c` is an instance, `value` can be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBooleanStatus(
    c: Instance,
    kind: c_int,
    value: *mut c_int,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe {
        with(c, |_| {
            let value = convert::place(value)?;
            if kind != TERMINATED {
                return Err(Refusal::error(NOTHING_PENDING));
            }
            *value = 0;
            Ok(())
        })
    }
}

/// String status of a pending step: there never is one.
///
/// # Safety
/// `c` is an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetStringStatus(
    c: Instance,
    _kind: c_int,
    _value: *mut *const c_char,
) -> Status {
    // SAFETY: the caller vouches for it.
    unsafe { with(c, |_| Err(Refusal::error(NOTHING_PENDING))) }
}
