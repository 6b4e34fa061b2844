//! FMI 3.0: the functions that these units do not support. The standard requires all functions to
//! exist; these log what is not provided and return *error*.

use std::ffi::{c_char, c_uint, c_void};

use cordon_cosim::fmi::slave::Refusal;

use crate::component::Status;
use crate::fmi3::{Instance, Log3, refuse, with};

/// `fmi3LogMessageCallback`.
type LogMessage = unsafe extern "C" fn(*mut c_void, Status, *const c_char, *const c_char);

/// Functions that refuse, with the standard's arguments.
macro_rules! refused {
    ($($name:ident ( $($argument:ty),* ) $what:literal;)*) => {$(
        #[doc = concat!("Refuses: ", $what, ".")]
        ///
        /// # Safety
        /// The first argument is an instance.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(instance: Instance $(, _: $argument)*) -> Status {
            // SAFETY: the caller vouches for it.
            unsafe { with(instance, |_| Err(Refusal::error($what))) }
        }
    )*};
}

/// Getters and setters for types that no variable has: with no variables they succeed.
macro_rules! types_unused {
    ($($get:ident, $set:ident, $c_type:ty;)*) => {$(
        types_unused!(@one $get, *mut $c_type);
        types_unused!(@one $set, *const $c_type);
    )*};
    (@one $name:ident, $pointer:ty) => {
        /// Refuses: no variable has this type.
        ///
        /// # Safety
        /// The first argument is an instance.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            instance: Instance,
            _references: *const c_uint,
            count: usize,
            _values: $pointer,
            _value_count: usize,
        ) -> Status {
            // SAFETY: the caller vouches for it.
            unsafe { with(instance, |_| none_of_this_type(count)) }
        }
    };
}

fn none_of_this_type(count: usize) -> Result<(), Refusal> {
    if count == 0 {
        return Ok(());
    }
    Err(Refusal::error("no variable has this type: expected Float64, Int64, Boolean or String"))
}

types_unused! {
    fmi3GetFloat32, fmi3SetFloat32, f32;
    fmi3GetInt8, fmi3SetInt8, i8;
    fmi3GetUInt8, fmi3SetUInt8, u8;
    fmi3GetInt16, fmi3SetInt16, i16;
    fmi3GetUInt16, fmi3SetUInt16, u16;
    fmi3GetInt32, fmi3SetInt32, i32;
    fmi3GetUInt32, fmi3SetUInt32, u32;
    fmi3GetUInt64, fmi3SetUInt64, u64;
}

type References = *const c_uint;
type Sizes = *mut usize;
type Binaries = *mut *const u8;
type Doubles = *mut f64;
type ConstDoubles = *const f64;
type Counts = *mut u64;
type ConstCounts = *const u64;

refused! {
    fmi3GetBinary(References, usize, Sizes, Binaries, usize) "no variable is binary";
    fmi3SetBinary(References, usize, *const usize, *const *const u8, usize) "no variable is binary";
    fmi3GetClock(References, usize, *mut bool) "there are no clocks";
    fmi3SetClock(References, usize, *const bool) "there are no clocks";
    fmi3GetIntervalDecimal(References, usize, Doubles, *mut i32) "there are no clocks";
    fmi3GetIntervalFraction(References, usize, Counts, Counts, *mut i32) "there are no clocks";
    fmi3GetShiftDecimal(References, usize, Doubles) "there are no clocks";
    fmi3GetShiftFraction(References, usize, Counts, Counts) "there are no clocks";
    fmi3SetIntervalDecimal(References, usize, ConstDoubles) "there are no clocks";
    fmi3SetIntervalFraction(References, usize, ConstCounts, ConstCounts) "there are no clocks";
    fmi3SetShiftDecimal(References, usize, ConstDoubles) "there are no clocks";
    fmi3SetShiftFraction(References, usize, ConstCounts, ConstCounts) "there are no clocks";
    fmi3ActivateModelPartition(c_uint, f64) "there are no model partitions";
    fmi3EnterEventMode() "there is no event mode";
    fmi3EnterStepMode() "there is no event mode to leave";
    fmi3EvaluateDiscreteStates() "there is no event mode";
    fmi3UpdateDiscreteStates(*mut bool, *mut bool, *mut bool, *mut bool, *mut bool, Doubles)
        "there is no event mode";
    fmi3EnterConfigurationMode() "there are no structural parameters";
    fmi3ExitConfigurationMode() "there are no structural parameters";
    fmi3GetNumberOfVariableDependencies(c_uint, *mut usize)
        "dependencies do not change: read them from the model description";
    fmi3GetVariableDependencies(
        c_uint, *mut usize, *mut c_uint, *mut usize, *mut i32, usize
    ) "dependencies do not change: read them from the model description";
    fmi3GetDirectionalDerivative(
        References, usize, References, usize, ConstDoubles, usize, Doubles, usize
    ) "directional derivatives are not provided";
    fmi3GetAdjointDerivative(
        References, usize, References, usize, ConstDoubles, usize, Doubles, usize
    ) "adjoint derivatives are not provided";
    fmi3GetOutputDerivatives(References, usize, *const i32, Doubles, usize)
        "derivatives of outputs are not provided";
    fmi3EnterContinuousTimeMode() "this FMU is for co-simulation";
    fmi3CompletedIntegratorStep(bool, *mut bool, *mut bool) "this FMU is for co-simulation";
    fmi3SetTime(f64) "this FMU is for co-simulation";
    fmi3SetContinuousStates(ConstDoubles, usize) "this FMU is for co-simulation";
    fmi3GetContinuousStateDerivatives(Doubles, usize) "this FMU is for co-simulation";
    fmi3GetEventIndicators(Doubles, usize) "this FMU is for co-simulation";
    fmi3GetContinuousStates(Doubles, usize) "this FMU is for co-simulation";
    fmi3GetNominalsOfContinuousStates(Doubles, usize) "this FMU is for co-simulation";
    fmi3GetNumberOfEventIndicators(*mut usize) "this FMU is for co-simulation";
    fmi3GetNumberOfContinuousStates(*mut usize) "this FMU is for co-simulation";
}

/// Refuses: this FMU is for co-simulation.
///
/// # Safety
/// The function is the importer's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateModelExchange(
    _instance_name: *const c_char,
    _token: *const c_char,
    _resource_path: *const c_char,
    _visible: bool,
    logging_on: bool,
    environment: *mut c_void,
    log_message: Option<LogMessage>,
) -> Instance {
    let log = Log3::of(log_message, environment, logging_on);
    refuse(&log, &Refusal::error("this FMU is for co-simulation, not for model exchange"))
}

/// Refuses: this FMU is for co-simulation.
///
/// # Safety
/// The functions are the importer's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateScheduledExecution(
    _instance_name: *const c_char,
    _token: *const c_char,
    _resource_path: *const c_char,
    _visible: bool,
    logging_on: bool,
    environment: *mut c_void,
    log_message: Option<LogMessage>,
    _clock_update: Option<unsafe extern "C" fn()>,
    _lock_preemption: Option<unsafe extern "C" fn()>,
    _unlock_preemption: Option<unsafe extern "C" fn()>,
) -> Instance {
    let log = Log3::of(log_message, environment, logging_on);
    refuse(&log, &Refusal::error("this FMU is for co-simulation, not for scheduled execution"))
}
