//! The C interface of the standards: types of the functions that are called here.

use std::ffi::{c_char, c_int, c_uint, c_void};

pub(crate) type Instance = *mut c_void;
pub(crate) type Status = c_int;

/// The callbacks of an importer, `fmi2CallbackFunctions`.
#[repr(C)]
pub(crate) struct Callbacks {
    pub logger: Logger2,
    pub allocate_memory: unsafe extern "C" fn(usize, usize) -> *mut c_void,
    pub free_memory: unsafe extern "C" fn(*mut c_void),
    pub step_finished: Option<unsafe extern "C" fn(*mut c_void, Status)>,
    pub environment: *mut c_void,
}

pub(crate) type Logger2 =
    unsafe extern "C" fn(*mut c_void, *const c_char, Status, *const c_char, *const c_char, ...);

unsafe extern "C" {
    pub(crate) fn cordon_fmi2_logger(
        environment: *mut c_void,
        instance: *const c_char,
        status: Status,
        category: *const c_char,
        message: *const c_char,
        ...
    );
    pub(crate) fn calloc(count: usize, size: usize) -> *mut c_void;
    pub(crate) fn free(memory: *mut c_void);
}

pub(crate) type Plain = unsafe extern "C" fn(Instance) -> Status;
pub(crate) type Free = unsafe extern "C" fn(Instance);

pub(crate) type Instantiate2 = unsafe extern "C" fn(
    name: *const c_char,
    fmu_type: c_int,
    guid: *const c_char,
    resources: *const c_char,
    functions: *const Callbacks,
    visible: c_int,
    logging_on: c_int,
) -> Instance;
pub(crate) type SetUp2 = unsafe extern "C" fn(Instance, c_int, f64, f64, c_int, f64) -> Status;
pub(crate) type Step2 = unsafe extern "C" fn(Instance, f64, f64, c_int) -> Status;
pub(crate) type Status2 = unsafe extern "C" fn(Instance, c_int, *mut Status) -> Status;
pub(crate) type Get2<T> = unsafe extern "C" fn(Instance, *const c_uint, usize, *mut T) -> Status;
pub(crate) type Set2<T> = unsafe extern "C" fn(Instance, *const c_uint, usize, *const T) -> Status;

pub(crate) type LogMessage3 =
    unsafe extern "C" fn(*mut c_void, Status, *const c_char, *const c_char);
pub(crate) type Instantiate3 = unsafe extern "C" fn(
    name: *const c_char,
    token: *const c_char,
    resources: *const c_char,
    visible: bool,
    logging_on: bool,
    event_mode_used: bool,
    early_return_allowed: bool,
    intermediate_variables: *const c_uint,
    intermediate_count: usize,
    environment: *mut c_void,
    log_message: LogMessage3,
    intermediate_update: Option<unsafe extern "C" fn()>,
) -> Instance;
pub(crate) type Enter3 = unsafe extern "C" fn(Instance, bool, f64, f64, bool, f64) -> Status;
pub(crate) type Step3 = unsafe extern "C" fn(
    Instance,
    f64,
    f64,
    bool,
    *mut bool,
    *mut bool,
    *mut bool,
    *mut f64,
) -> Status;
pub(crate) type Get3<T> =
    unsafe extern "C" fn(Instance, *const c_uint, usize, *mut T, usize) -> Status;
pub(crate) type Set3<T> =
    unsafe extern "C" fn(Instance, *const c_uint, usize, *const T, usize) -> Status;
