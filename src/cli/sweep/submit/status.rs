//! `cordon sweep status`: the state of a submitted sweep, and how to run what is left.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use super::{kubernetes, scripts, slurm};
use cordon_core::{Error, Outcome, Result, text};
use cordon_proof::sweep::shard::{Part, parts};
use cordon_proof::sweep::store::{Header, is_being_written, read};

/// Arguments of `cordon sweep status`.
#[derive(clap::Args, Debug)]
pub(in super::super) struct Args {
    /// Folder of a submitted sweep
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

/// Most parts that are listed individually.
const SHOWN: usize = 40;

/// Longest line of a log that is shown, in characters.
const LINE: usize = 200;

/// The state of a part.
enum State {
    Finished,
    /// A process has its result file open.
    Running,
    /// Its job has ended with this exit code and this last line of its log.
    Failed(String, String),
    /// Its result file cannot be read.
    Damaged(String),
    /// Neither finished nor running: not started, queued, or killed.
    Open,
}

/// Exit code 0 if all parts are finished, 3 otherwise.
pub(in super::super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    let folder = &args.folder;
    let header = any_header(folder)?;
    let of = header.shard.of;
    let parts = parts(&header.config, header.config.items()?, of)?;
    let mut states = Vec::with_capacity(of);
    for (number, part) in (1..).zip(&parts) {
        states.push(state(folder, number, part)?);
    }
    let count = |wanted: fn(&State) -> bool| states.iter().filter(|(s, _)| wanted(s)).count();
    let finished = count(|s| matches!(s, State::Finished));
    let running = count(|s| matches!(s, State::Running));
    let failed = count(|s| matches!(s, State::Failed(..) | State::Damaged(_)));
    writeln!(
        out,
        "{of} parts: {finished} finished, {running} running, {failed} failed, {} waiting or interrupted; {} of {} work items",
        of - finished - running - failed,
        states.iter().map(|(_, done)| done).sum::<usize>(),
        header.items
    )?;
    let unfinished =
        || (1usize..).zip(&parts).zip(&states).filter(|(_, (s, _))| !matches!(s, State::Finished));
    for ((number, part), (state, done)) in unfinished().take(SHOWN) {
        let why = match state {
            State::Failed(code, last) => format!("failed with exit code {code}: {last}"),
            State::Damaged(why) => format!("failed: {why}"),
            State::Running => "running".to_owned(),
            State::Finished | State::Open => "waiting or interrupted".to_owned(),
        };
        writeln!(out, "part {number}: {done} of {} work items, {why}", part.items.len())?;
    }
    if finished + SHOWN < of {
        writeln!(out, "and {} more", of - finished - SHOWN)?;
    }
    let rerun: Vec<usize> = unfinished()
        .filter(|(_, (state, _))| !matches!(state, State::Running))
        .map(|((number, _), _)| number)
        .collect();
    if !rerun.is_empty() {
        let command = match folder.join(slurm::SUBMIT) {
            submit if submit.exists() => format!("sh {} {}", shown(&submit), listed(&rerun)),
            _ => format!(
                "kubectl replace --force --filename {}",
                shown(&folder.join(kubernetes::SWEEP))
            ),
        };
        writeln!(out, "to run what no job is waiting for: {command}")?;
    } else if finished == of && !folder.join(scripts::MERGED).exists() {
        let (parts, merged) = (shown(folder), shown(&folder.join(scripts::MERGED)));
        writeln!(out, "to merge: cordon sweep merge {parts}/part-*.jsonl --out {merged}")?;
    }
    Ok(if finished == of { Outcome::Holds } else { Outcome::Inconclusive })
}

fn shown(path: &Path) -> String {
    text::shell_word(&path.display().to_string()).into_owned()
}

/// The header of the first part whose result file can be read.
fn any_header(folder: &Path) -> Result<Header> {
    let names = fs::read_dir(folder).map_err(|e| Error::file("read", folder, e))?;
    let mut numbers: Vec<usize> = names
        .filter_map(|entry| {
            let name = entry.ok()?.file_name();
            name.to_str()?.strip_prefix("part-")?.strip_suffix(".jsonl")?.parse().ok()
        })
        .collect();
    numbers.sort_unstable();
    let headers = numbers.iter().filter_map(|&i| read(&scripts::result(folder, i)).ok());
    headers.map(|part| part.header).next().ok_or_else(|| {
        Error::input(format!(
            "`{}`: expected the folder of a submitted sweep, with files like part-1.jsonl",
            folder.display()
        ))
    })
}

/// The state of a part, and how many of its work items are done.
fn state(folder: &Path, number: usize, part: &Part) -> Result<(State, usize)> {
    let path = scripts::result(folder, number);
    if !path.exists() {
        return Ok((State::Open, 0));
    }
    let done = match read(&path) {
        Ok(part) => part.findings.len(),
        Err(e) => return Ok((State::Damaged(e.to_string()), 0)),
    };
    let state = if done == part.items.len() {
        State::Finished
    } else if is_being_written(&path)? {
        State::Running
    } else {
        // A job that was killed leaves no exit code.
        let code = fs::read_to_string(scripts::code(folder, number)).unwrap_or_default();
        match code.trim() {
            "" => State::Open,
            code => State::Failed(code.to_owned(), last_line(&scripts::log(folder, number))),
        }
    };
    Ok((state, done))
}

/// The last line of a log, shortened.
fn last_line(log: &Path) -> String {
    let said = fs::read(log).unwrap_or_default();
    let said = String::from_utf8_lossy(&said);
    let last = said.lines().rfind(|line| !line.trim().is_empty());
    last.map_or_else(|| "nothing is in its log".to_owned(), |line| text::cut(line, LINE))
}

/// Numbers in ascending order in Slurm's notation: `3,7-9`.
fn listed(numbers: &[usize]) -> String {
    let runs = numbers.chunk_by(|a, b| a + 1 == *b);
    let texts = runs.map(|run| match run {
        [first, .., last] => format!("{first}-{last}"),
        _ => run.iter().map(usize::to_string).collect(),
    });
    texts.collect::<Vec<_>>().join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_listed_as_a_job_array_takes_them() {
        assert_eq!(listed(&[3, 7, 8, 9, 11, 12]), "3,7-9,11-12");
        assert_eq!(listed(&[1]), "1");
    }
}
