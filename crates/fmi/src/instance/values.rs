//! Reading and setting variables, by their types.

use std::ffi::{CStr, CString, c_char, c_int, c_uint};

use super::Instance;
use crate::c;
use crate::fmu::{Datum, Type, Variable, Version};

/// A value for messages.
pub(super) fn shown(value: &Datum) -> String {
    match value {
        // Variables that were never set may have extreme values, with hundreds of zeros.
        Datum::Real(x) if *x != 0.0 && !(1e-6..1e15).contains(&x.abs()) => format!("{x:e}"),
        Datum::Real(x) => x.to_string(),
        Datum::Integer(n) => n.to_string(),
        Datum::Boolean(b) => b.to_string(),
        Datum::Text(t) => t.clone(),
    }
}

fn names(variables: &[Variable]) -> String {
    let names: Vec<_> = variables.iter().map(|v| format!("`{}`", v.name)).collect();
    names.join(", ")
}

/// The integer value in the variable's type.
fn narrow<T: TryFrom<i64>>(variable: &Variable, value: &Datum) -> Result<T, String> {
    match value {
        Datum::Integer(n) => T::try_from(*n).map_err(|_| {
            let Variable { name, kind, .. } = variable;
            format!("setting `{name}`: `{n}`: expected a number that {kind:?} holds")
        }),
        other => Err(unexpected(variable, other)),
    }
}

fn unexpected(variable: &Variable, value: &Datum) -> String {
    let Variable { name, kind, .. } = variable;
    format!("setting `{name}`: `{}`: expected a value of type {kind:?}", shown(value))
}

fn real(variable: &Variable, value: &Datum) -> Result<f64, String> {
    match value {
        Datum::Real(x) => Ok(*x),
        other => Err(unexpected(variable, other)),
    }
}

fn boolean(variable: &Variable, value: &Datum) -> Result<bool, String> {
    match value {
        Datum::Boolean(b) => Ok(*b),
        other => Err(unexpected(variable, other)),
    }
}

fn text(variable: &Variable, value: &Datum) -> Result<CString, String> {
    match value {
        Datum::Text(t) => CString::new(t.as_str())
            .map_err(|_| format!("setting `{}`: a text with a zero byte", variable.name)),
        other => Err(unexpected(variable, other)),
    }
}

impl Instance {
    /// Sets variables, with one call for consecutive variables of one type.
    pub(super) fn set(&mut self, variables: &[Variable], values: &[Datum]) -> Result<(), String> {
        if variables.len() != values.len() {
            return Err(format!("{} values for {} inputs", values.len(), variables.len()));
        }
        let mut from = 0;
        for group in variables.chunk_by(|a, b| a.kind == b.kind) {
            let until = from + group.len();
            self.set_group(group, values.get(from..until).unwrap_or_default())?;
            from = until;
        }
        Ok(())
    }

    fn set_group(&mut self, variables: &[Variable], values: &[Datum]) -> Result<(), String> {
        let Some(first) = variables.first() else {
            return Ok(());
        };
        let pairs = || variables.iter().zip(values);
        match (self.version, first.kind) {
            (Version::V2, Type::Float64) => {
                let list = pairs().map(|(v, x)| real(v, x)).collect::<Result<Vec<f64>, _>>()?;
                self.put2("fmi2SetReal", variables, &list)
            }
            (Version::V2, Type::Int32) => {
                let list = pairs().map(|(v, x)| narrow(v, x)).collect::<Result<Vec<c_int>, _>>()?;
                self.put2("fmi2SetInteger", variables, &list)
            }
            (Version::V2, Type::Boolean) => {
                let list = pairs().map(|(v, x)| boolean(v, x).map(c_int::from));
                self.put2("fmi2SetBoolean", variables, &list.collect::<Result<Vec<_>, _>>()?)
            }
            (Version::V2, Type::String) => {
                let list = pairs().map(|(v, x)| text(v, x)).collect::<Result<Vec<_>, _>>()?;
                let list: Vec<*const c_char> = list.iter().map(|t| t.as_ptr()).collect();
                self.put2("fmi2SetString", variables, &list)
            }
            (Version::V2, kind) => Err(format!("{kind:?} is not a type of FMI 2.0")),
            (Version::V3, Type::Float64) => {
                let list = pairs().map(|(v, x)| real(v, x)).collect::<Result<Vec<f64>, _>>()?;
                self.put3("fmi3SetFloat64", variables, &list)
            }
            (Version::V3, Type::Float32) => {
                let list = pairs().map(|(v, x)| real(v, x).map(|x| x as f32));
                self.put3("fmi3SetFloat32", variables, &list.collect::<Result<Vec<f32>, _>>()?)
            }
            (Version::V3, Type::Boolean) => {
                let list = pairs().map(|(v, x)| boolean(v, x)).collect::<Result<Vec<_>, _>>()?;
                self.put3("fmi3SetBoolean", variables, &list)
            }
            (Version::V3, Type::String) => {
                let list = pairs().map(|(v, x)| text(v, x)).collect::<Result<Vec<_>, _>>()?;
                let list: Vec<*const c_char> = list.iter().map(|t| t.as_ptr()).collect();
                self.put3("fmi3SetString", variables, &list)
            }
            (Version::V3, Type::Int8) => self.put_whole::<i8>("fmi3SetInt8", variables, values),
            (Version::V3, Type::UInt8) => self.put_whole::<u8>("fmi3SetUInt8", variables, values),
            (Version::V3, Type::Int16) => self.put_whole::<i16>("fmi3SetInt16", variables, values),
            (Version::V3, Type::UInt16) => {
                self.put_whole::<u16>("fmi3SetUInt16", variables, values)
            }
            (Version::V3, Type::Int32) => self.put_whole::<i32>("fmi3SetInt32", variables, values),
            (Version::V3, Type::UInt32) => {
                self.put_whole::<u32>("fmi3SetUInt32", variables, values)
            }
            (Version::V3, Type::Int64) => self.put_whole::<i64>("fmi3SetInt64", variables, values),
            (Version::V3, Type::UInt64) => {
                self.put_whole::<u64>("fmi3SetUInt64", variables, values)
            }
        }
    }

    fn put_whole<T: TryFrom<i64>>(
        &mut self,
        function: &str,
        variables: &[Variable],
        values: &[Datum],
    ) -> Result<(), String> {
        let list = variables.iter().zip(values).map(|(v, x)| narrow::<T>(v, x));
        self.put3(function, variables, &list.collect::<Result<Vec<T>, _>>()?)
    }

    fn put2<T>(&mut self, name: &str, variables: &[Variable], list: &[T]) -> Result<(), String> {
        let references: Vec<c_uint> = variables.iter().map(|v| v.reference).collect();
        // SAFETY: the callers pair the standard's name and type.
        let set: c::Set2<T> = unsafe { self.library.function(name) }?;
        // SAFETY: the instance is alive, and both arrays have this length.
        let status = unsafe { set(self.raw, references.as_ptr(), list.len(), list.as_ptr()) };
        self.judge(|| format!("setting {}", names(variables)), status)
    }

    fn put3<T>(&mut self, name: &str, variables: &[Variable], list: &[T]) -> Result<(), String> {
        let references: Vec<c_uint> = variables.iter().map(|v| v.reference).collect();
        // SAFETY: the callers pair the standard's name and type.
        let set: c::Set3<T> = unsafe { self.library.function(name) }?;
        let (first, count) = (list.as_ptr(), list.len());
        // SAFETY: the instance is alive, and both arrays have this length.
        let status = unsafe { set(self.raw, references.as_ptr(), count, first, count) };
        self.judge(|| format!("setting {}", names(variables)), status)
    }

    /// Reads variables, with one call for consecutive variables of one type.
    pub(super) fn get(&mut self, variables: &[Variable]) -> Result<Vec<Datum>, String> {
        let mut read = Vec::with_capacity(variables.len());
        for group in variables.chunk_by(|a, b| a.kind == b.kind) {
            self.get_group(group, &mut read)?;
        }
        Ok(read)
    }

    fn get_group(&mut self, variables: &[Variable], read: &mut Vec<Datum>) -> Result<(), String> {
        let Some(first) = variables.first() else {
            return Ok(());
        };
        let flag = |b: c_int| Datum::Boolean(b != 0);
        match (self.version, first.kind) {
            (Version::V2, Type::Float64) => {
                read.extend(
                    self.take2("fmi2GetReal", variables, 0.0)?.into_iter().map(Datum::Real),
                );
            }
            (Version::V2, Type::Int32) => {
                let list = self.take2("fmi2GetInteger", variables, 0i32)?;
                read.extend(list.into_iter().map(|n| Datum::Integer(n.into())));
            }
            (Version::V2, Type::Boolean) => {
                read.extend(self.take2("fmi2GetBoolean", variables, 0)?.into_iter().map(flag));
            }
            (Version::V2, Type::String) => {
                let list = self.take2("fmi2GetString", variables, std::ptr::null())?;
                read.extend(list.into_iter().map(copied));
            }
            (Version::V2, kind) => return Err(format!("{kind:?} is not a type of FMI 2.0")),
            (Version::V3, Type::Float64) => {
                let list = self.take3("fmi3GetFloat64", variables, 0.0)?;
                read.extend(list.into_iter().map(Datum::Real));
            }
            (Version::V3, Type::Float32) => {
                let list = self.take3("fmi3GetFloat32", variables, 0.0f32)?;
                read.extend(list.into_iter().map(|x| Datum::Real(x.into())));
            }
            (Version::V3, Type::Boolean) => {
                // As bytes: what the FMU wrote may not be a valid bool.
                let list = self.take3("fmi3GetBoolean", variables, 0u8)?;
                read.extend(list.into_iter().map(|b| Datum::Boolean(b != 0)));
            }
            (Version::V3, Type::String) => {
                let list = self.take3("fmi3GetString", variables, std::ptr::null())?;
                read.extend(list.into_iter().map(copied));
            }
            (Version::V3, Type::Int8) => self.take_whole("fmi3GetInt8", variables, 0i8, read)?,
            (Version::V3, Type::UInt8) => self.take_whole("fmi3GetUInt8", variables, 0u8, read)?,
            (Version::V3, Type::Int16) => self.take_whole("fmi3GetInt16", variables, 0i16, read)?,
            (Version::V3, Type::UInt16) => {
                self.take_whole("fmi3GetUInt16", variables, 0u16, read)?;
            }
            (Version::V3, Type::Int32) => self.take_whole("fmi3GetInt32", variables, 0i32, read)?,
            (Version::V3, Type::UInt32) => {
                self.take_whole("fmi3GetUInt32", variables, 0u32, read)?;
            }
            (Version::V3, Type::Int64) => self.take_whole("fmi3GetInt64", variables, 0i64, read)?,
            (Version::V3, Type::UInt64) => {
                self.take_whole("fmi3GetUInt64", variables, 0u64, read)?;
            }
        }
        Ok(())
    }

    fn take_whole<T: Copy + TryInto<i64> + ToString>(
        &mut self,
        function: &str,
        variables: &[Variable],
        blank: T,
        read: &mut Vec<Datum>,
    ) -> Result<(), String> {
        for n in self.take3(function, variables, blank)? {
            let wide = n.try_into().map_err(|_| {
                let names = names(variables);
                format!("reading {names}: `{}`: expected a number of 64 bits", n.to_string())
            });
            read.push(Datum::Integer(wide?));
        }
        Ok(())
    }

    fn take2<T: Copy>(
        &mut self,
        name: &str,
        variables: &[Variable],
        blank: T,
    ) -> Result<Vec<T>, String> {
        let references: Vec<c_uint> = variables.iter().map(|v| v.reference).collect();
        let mut list = vec![blank; references.len()];
        // SAFETY: the callers pair the standard's name and type.
        let get: c::Get2<T> = unsafe { self.library.function(name) }?;
        // SAFETY: the instance is alive, and both arrays have this length.
        let status = unsafe { get(self.raw, references.as_ptr(), list.len(), list.as_mut_ptr()) };
        self.judge(|| format!("reading {}", names(variables)), status)?;
        Ok(list)
    }

    fn take3<T: Copy>(
        &mut self,
        name: &str,
        variables: &[Variable],
        blank: T,
    ) -> Result<Vec<T>, String> {
        let references: Vec<c_uint> = variables.iter().map(|v| v.reference).collect();
        let mut list = vec![blank; references.len()];
        // SAFETY: the callers pair the standard's name and type.
        let get: c::Get3<T> = unsafe { self.library.function(name) }?;
        let (first, count) = (list.as_mut_ptr(), list.len());
        // SAFETY: the instance is alive, and both arrays have this length.
        let status = unsafe { get(self.raw, references.as_ptr(), count, first, count) };
        self.judge(|| format!("reading {}", names(variables)), status)?;
        Ok(list)
    }
}

/// Copies a string returned by an FMU: it is valid until the next call only.
fn copied(text: *const c_char) -> Datum {
    if text.is_null() {
        return Datum::Text(String::new());
    }
    // SAFETY: not null; the FMU guarantees the terminating zero byte.
    Datum::Text(unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned())
}
