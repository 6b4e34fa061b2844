//! A job array of Slurm, and the merge that depends on it.

use super::Jobs;
use cordon_core::text::shell_word;

/// The script that submits the sweep, or some parts of it.
pub(super) const SUBMIT: &str = "submit.sh";

pub(super) fn files(jobs: &Jobs<'_>) -> Vec<(&'static str, String)> {
    let Jobs { name, parts, threads, limits, .. } = jobs;
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
    vec![(SUBMIT, text)]
}
