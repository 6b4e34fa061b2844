//! A job array of Slurm, and the merge that depends on it.

use super::Jobs;
use cordon_core::exact::shortened;
use cordon_core::text::shell_word;
use cordon_core::{Error, Result};

/// The script that submits the sweep, or some parts of it.
pub(super) const SUBMIT: &str = "submit.sh";

/// Refuses what `sbatch` would refuse, or take for something else.
///
/// # Errors
/// A time or a partition is not written as `sbatch` reads it.
fn check(limits: &[(&'static str, Option<&str>)]) -> Result<()> {
    for (flag, value) in limits.iter().filter_map(|(flag, value)| Some((*flag, (*value)?))) {
        let (is_right, expected) = match flag {
            "time" => (
                is_time(value),
                "minutes, minutes:seconds, hours:minutes:seconds, days-hours, days-hours:minutes or \
                 days-hours:minutes:seconds",
            ),
            _ => (
                value.split(',').all(is_partition),
                "names of partitions, of letters, digits, `_`, `-` and `.`, separated by commas",
            ),
        };
        if !is_right {
            let given = shortened(value);
            return Err(Error::input(format!("{flag}: `{given}`: expected {expected}")));
        }
    }
    Ok(())
}

/// Whether a time is written in one of the six forms that `sbatch` documents; it adds up what the parts say,
/// however large they are.
fn is_time(text: &str) -> bool {
    let whole = |part: &str| part.parse::<u32>().is_ok() && !part.starts_with('+');
    let (days, rest) = match text.split_once('-') {
        Some((days, rest)) => (Some(days), rest),
        None => (None, text),
    };
    days.is_none_or(whole) && rest.split(':').count() <= 3 && rest.split(':').all(whole)
}

fn is_partition(name: &str) -> bool {
    let is_of_name = |c: char| c.is_alphanumeric() || "_-.".contains(c);
    !name.is_empty() && !name.starts_with('-') && name.chars().all(is_of_name)
}

/// # Errors
/// A limit is not written as Slurm reads it.
pub(super) fn files(jobs: &Jobs<'_>) -> Result<Vec<(&'static str, String)>> {
    let Jobs { name, parts, threads, limits, .. } = jobs;
    check(limits)?;
    let limits: String = limits
        .iter()
        .filter_map(|(flag, value)| Some(format!(" --{flag}={}", shell_word((*value)?))))
        .collect();
    let text = format!(
        r#"#!/bin/sh
# Submits the {parts} parts of a sweep as a job array of Slurm, and their merge once all have ended
# well. `sh submit.sh 3,7-9` submits these parts only, and the merge.
set -eu
cd "$(dirname "$0")"
parts=$(sbatch --parsable --job-name={name} --array="${{1:-1-{parts}}}" --cpus-per-task={threads}{limits} \
    --requeue --open-mode=append --output=part-%a.log --wrap='exec sh ./part.sh "$SLURM_ARRAY_TASK_ID"')
merge=$(sbatch --parsable --job-name={name}-merge --dependency="afterok:${{parts%%;*}}" --kill-on-invalid-dep=yes{limits} \
    --requeue --open-mode=append --output=merge.log --wrap='exec sh ./merge.sh')
echo "submitted: job array $parts, and job $merge, which merges"
"#
    );
    Ok(vec![(SUBMIT, text)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_in_one_of_six_forms() {
        for right in ["90", "0", "90:30", "0:90", "100:59:00", "2-12", "2-12:30", "2-12:30:15"] {
            assert!(is_time(right), "{right}");
        }
        for wrong in [
            "",
            "bogus",
            "1h",
            "-1",
            "+5",
            "1:",
            ":30",
            "1:2:3:4",
            "1.5",
            "2-",
            "-12",
            "2-1-3",
            "2-12:",
            "1 ",
            "99999999999",
        ] {
            assert!(!is_time(wrong), "{wrong}");
        }
    }

    #[test]
    fn partitions_are_names() {
        let all = |text: &str| text.split(',').all(is_partition);
        assert!(all("short") && all("gpu_a100,cpu-2.x"));
        for wrong in ["", "a b", "a,,b", "--x", "a;b", "a\"b", "a\u{202e}b"] {
            assert!(!all(wrong), "{wrong}");
        }
    }
}
