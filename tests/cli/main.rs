//! The program as a user meets it: commands, files, exit codes, documents.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../common/mod.rs"]
mod common;

mod at;
mod bad_input;
mod commands;
mod cosim;
mod documents;
mod export_pvs;
mod files;
mod files_read;
#[cfg(feature = "fmi-import")]
mod fmi_import;
mod fmpy;
mod fmu;
#[cfg(all(feature = "fmi-import", unix))]
mod foreign;
mod golden;
mod help;
mod messages;
mod own_runs;
mod own_verdicts;
mod replay;
mod schemas;
mod separation;
mod slave;
#[cfg(unix)]
mod submit;
mod sweep;
mod sweep_files;
mod trace;
mod trust_lines;
