//! The scripts common to all schedulers: one part of a sweep, and the merge of all.

use std::path::{Path, PathBuf};

use super::Jobs;

/// The result file of the whole sweep, after merging.
pub(super) const MERGED: &str = "sweep.jsonl";

/// The result file of a part, counted from 1.
pub(super) fn result(folder: &Path, part: usize) -> PathBuf {
    folder.join(format!("part-{part}.jsonl"))
}

/// The log of a part's jobs.
pub(super) fn log(folder: &Path, part: usize) -> PathBuf {
    folder.join(format!("part-{part}.log"))
}

/// The exit code of a part's last job that was not killed.
pub(super) fn code(folder: &Path, part: usize) -> PathBuf {
    folder.join(format!("part-{part}.code"))
}

/// The scripts, to be run in the folder of the result files.
pub(super) fn files(jobs: &Jobs<'_>) -> Vec<(&'static str, String)> {
    let Jobs { arguments, parts, threads, .. } = jobs;
    let part = format!(
        r#"#!/bin/sh
# Runs part $1 of {parts} of a sweep, or goes on with it.
part=part-$1
rm -f "$part.code"
code=0
"${{0%/*}}/cordon" sweep {arguments} --threads {threads} --shard "$1/{parts}" --out "$part.jsonl" \
    >/dev/null 2>>"$part.log" || code=$?
echo "$code" >"$part.code"
# 1 (refuted) and 3 (vacuous or undecided) are verdicts, on which the merge has the last word.
case $code in
0 | 1 | 3) ;;
*) exit "$code" ;;
esac
"#
    );
    let merge = format!(
        r#"#!/bin/sh
# Puts the parts of a sweep together; the exit code is that of its claims.
exec "${{0%/*}}/cordon" sweep merge part-*.jsonl --out {MERGED} >report.txt
"#
    );
    vec![("part.sh", part), ("merge.sh", merge)]
}
