//! Sweeps as jobs: what `cordon sweep --submit` writes, `cordon sweep status`, and a job array on
//! a Slurm that this test starts.
use std::fs;
use std::io::Write;
use std::net::TcpListener;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::Duration;

use serde_json::Value;

use crate::common::schema::{Schema, parsed};
use crate::common::tools::{has_tool, missing};
use crate::common::{cordon, run};

const SMALL: &str = "7.2,7.6ii --form both --drones 3..5 --max-denominator 4 --grid 6 --steps 5";

/// Runs `cordon sweep ARGS`, the arguments in one line.
fn sweep(args: &str) -> (i32, String, String) {
    run(&["sweep"].into_iter().chain(args.split_whitespace()).collect::<Vec<_>>())
}

/// A sweep that is submitted where nobody takes jobs: everything is ready in the folder.
fn ready(args: &str, shards: usize, folder: &Path) {
    // A submission command that finds no scheduler, at once.
    let tools = tempfile::tempdir().unwrap();
    let sbatch = tools.path().join("sbatch");
    fs::write(&sbatch, "#!/bin/sh\necho no controller >&2\nexit 1\n").unwrap();
    fs::set_permissions(&sbatch, fs::Permissions::from_mode(0o755)).unwrap();
    let path = format!("{}:{}", tools.path().display(), std::env::var("PATH").unwrap());
    let out = cordon()
        .arg("sweep")
        .args(args.split_whitespace())
        .args(["--submit", "slurm", "--shards", &shards.to_string(), "--out"])
        .arg(folder)
        .env("PATH", path)
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&out.stderr);
    assert_eq!(out.status.code(), Some(2), "{said}");
    assert!(
        said.contains("--submit: `slurm`: ") && said.contains("everything is ready in"),
        "{said}"
    );
}

/// Runs a script of the folder as a scheduler does.
fn script(folder: &Path, name: &str, args: &[&str]) -> i32 {
    Command::new("sh")
        .arg(format!("./{name}"))
        .args(args)
        .current_dir(folder)
        .status()
        .unwrap()
        .code()
        .unwrap()
}

/// Parts by their scripts, in any order, and their merge are the whole sweep; exit codes that are
/// verdicts end no job badly; what is left is named, and so is who failed and why.
#[test]
fn the_parts_of_a_submitted_sweep_are_the_whole() {
    let folder = tempfile::tempdir().unwrap();
    let whole = folder.path().join("whole.jsonl");
    let (code, report, _) = sweep(&format!("{SMALL} --out {}", whole.display()));
    assert_eq!(code, 1);
    let dir = folder.path().join("a folder");
    ready(SMALL, 5, &dir);
    let status = || run(&["sweep", "status", dir.to_str().unwrap()]);
    let (code, out, _) = status();
    assert_eq!(code, 3);
    assert!(out.starts_with("5 parts: 0 finished, 0 running, 0 failed, 5 waiting or"), "{out}");
    let submit = format!("sh '{}' ", dir.join("submit.sh").display());
    assert!(out.ends_with(&format!("{submit}1-5\n")), "{out}");
    for part in ["4", "1", "2"] {
        assert_eq!(script(&dir, "part.sh", &[part]), 0);
    }
    let (code, out, _) = status();
    assert_eq!(code, 3);
    assert!(out.starts_with("5 parts: 3 finished"), "{out}");
    assert!(out.ends_with(&format!("{submit}3,5\n")), "{out}");
    // A part that cannot be written.
    let damaged = dir.join("part-3.jsonl");
    let header = fs::read_to_string(&damaged).unwrap();
    fs::write(&damaged, header.replace("\"steps\":5", "\"steps\":6")).unwrap();
    assert_eq!(script(&dir, "part.sh", &["3"]), 2);
    let (_, out, _) = status();
    assert!(out.contains("part 3: 0 of 4 work items, failed with exit code 2: "), "{out}");
    assert!(out.contains("holds another sweep: steps is 6 there and 5 here"), "{out}");
    // One that another process is writing: it is left alone, and not submitted again.
    fs::write(&damaged, &header).unwrap();
    let held = fs::File::open(&damaged).unwrap();
    held.lock().unwrap();
    assert_eq!(script(&dir, "part.sh", &["3"]), 2);
    let said = fs::read_to_string(dir.join("part-3.log")).unwrap();
    assert!(said.contains("part-3.jsonl`: another process is writing it"), "{said}");
    let (_, out, _) = status();
    assert!(out.contains("part 3: 0 of 4 work items, running"), "{out}");
    assert!(out.ends_with(&format!("{submit}5\n")), "{out}");
    drop(held);
    // The merge has no gap.
    assert_eq!(script(&dir, "merge.sh", &[]), 2);
    // A header that a crash has torn is one not begun.
    fs::write(&damaged, &header[..header.len() / 2]).unwrap();
    for part in ["5", "3"] {
        assert_eq!(script(&dir, "part.sh", &[part]), 0);
    }
    let (code, out, _) = status();
    assert_eq!(code, 0, "{out}");
    assert!(out.contains("36 of 36 work items\nto merge: cordon sweep merge '"), "{out}");
    assert_eq!(script(&dir, "merge.sh", &[]), 1);
    assert_eq!(fs::read(dir.join("sweep.jsonl")).unwrap(), fs::read(&whole).unwrap());
    assert_eq!(fs::read_to_string(dir.join("report.txt")).unwrap(), report);
    assert!(!status().1.contains("to merge"));
    // Parts of another version, another number of parts, and folders of another sweep.
    let part = fs::read_to_string(dir.join("part-2.jsonl")).unwrap();
    let version = format!("\"version\":\"{}\"", env!("CARGO_PKG_VERSION"));
    assert!(part.contains(&version));
    fs::write(dir.join("part-2.jsonl"), part.replace(&version, "\"version\":\"0.0.9\"")).unwrap();
    assert_eq!(script(&dir, "merge.sh", &[]), 2);
    let files: Vec<_> = (1..=5).map(|i| dir.join(format!("part-{i}.jsonl"))).collect();
    let files = files.iter().map(|f| f.to_str().unwrap());
    let (_, _, err) = run(&["sweep", "merge"].into_iter().chain(files).collect::<Vec<_>>());
    assert!(err.contains("are parts of different sweeps: version is"), "{err}");
    assert_eq!(script(&dir, "part.sh", &["2"]), 2);
    let other = format!("{SMALL} --any-weight --submit slurm --shards 5 --out");
    let args = ["sweep"].into_iter().chain(other.split(' ')).chain([dir.to_str().unwrap()]);
    let (code, _, err) = run(&args.collect::<Vec<_>>());
    assert_eq!(code, 2);
    assert!(err.contains("holds another sweep: only weights of the theorem is true"), "{err}");
}

/// The scripts ask for the sweep that was asked for, whichever kind it is.
#[test]
fn every_kind_of_sweep_travels() {
    for args in [
        "7.2,7.3 --form paper --drones 3..4 --eps-range=-1/2..1/2 --any-weight --grid 4 --steps 3",
        "all --complete --drones 3..4 --eps 1/3,2/5 --steps 4",
        "7.8 --sample 30 --seed 7 --grid 12 --drones 4..5 --eps 1/4,1/3 --steps 3",
    ] {
        let folder = tempfile::tempdir().unwrap();
        let whole = folder.path().join("whole.jsonl");
        sweep(&format!("{args} --out {}", whole.display()));
        let dir = folder.path().join("parts");
        ready(args, 3, &dir);
        for part in ["1", "2", "3"] {
            assert_eq!(script(&dir, "part.sh", &[part]), 0);
        }
        script(&dir, "merge.sh", &[]);
        assert_eq!(fs::read(dir.join("sweep.jsonl")).unwrap(), fs::read(&whole).unwrap(), "{args}");
    }
}

#[test]
fn jobs_that_make_no_sense_are_refused() {
    let refused = |args: &str, says: &str| {
        let (code, out, err) = sweep(args);
        assert_eq!((code, out.as_str()), (2, ""), "{args}: {err}");
        assert!(err.contains(says), "{args}: {err}");
    };
    refused("7.2 --submit slurm", "--submit: expected --shards with it");
    refused("7.2 --shards 4", "expected --submit with it");
    refused("7.2 --submit slurm --shards 0", "--shards: `0`: expected 1 to 27, the sweep's number");
    refused("7.2 --submit slurm --shards 28", "--shards: `28`: expected 1 to 27");
    refused("7.2 --submit slurm --shards 4 --shard 1/4", "cannot be used with");
    refused(
        "7.2 --submit kubernetes --shards 4 --time 1:00",
        "--time: `1:00`: expected `--submit slurm`",
    );
    refused(
        "7.2 --submit slurm --shards 4 --dry-run --time bogus",
        "--time: `bogus`: expected minutes, minutes:seconds, hours:minutes:seconds, days-hours",
    );
    refused("7.2 --submit slurm --shards 4 --dry-run --time 1:2:3:4", "--time: `1:2:3:4`: exp");
    refused(
        "7.2 --submit slurm --shards 4 --dry-run --partition a,,b",
        "--partition: `a,,b`: expected names of partitions",
    );
    refused("status src", "`src`: expected the folder of a submitted sweep");
    // Nothing is written by a dry run.
    let args =
        "7.2 --submit slurm --shards 4 --out no-such-folder --dry-run --time 1-12:30 --partition";
    let args: Vec<_> = ["sweep"].into_iter().chain(args.split(' ')).chain(["short,long"]).collect();
    let (code, out, _) = run(&args);
    assert_eq!(code, 0);
    assert!(out.contains("--cpus-per-task=1 --partition=short,long --time=1-12:30 "), "{out}");
    assert!(!Path::new("no-such-folder").exists());
}

/// The YAML as Python reads it meets the schema of what the API of Kubernetes takes of it.
#[test]
fn jobs_of_kubernetes_meet_their_schema() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path().join("parts");
    let args =
        format!("{SMALL} --threads 2 --submit kubernetes --shards 3 --out {}", dir.display());
    let (code, out, err) = sweep(&args);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("kubectl apply --filename "), "{out}");
    let container = fs::read_to_string(dir.join("Containerfile")).unwrap();
    for name in ["cordon", "part.sh", "merge.sh"] {
        assert!(container.contains(&format!(" {name} ")) && dir.join(name).exists());
    }
    let read =
        "import json, sys, yaml; print(json.dumps(list(yaml.safe_load_all(open(sys.argv[1])))))";
    let read = Command::new("python3").args(["-c", read]).arg(dir.join("sweep.yaml")).output();
    let Ok(Output { status, stdout, .. }) = read else { return missing("Kubernetes", "python3") };
    if !status.success() {
        return missing("Kubernetes", "PyYAML");
    }
    let pages = parsed(&String::from_utf8(stdout).unwrap());
    let [parts, merge] = pages.as_array().unwrap().as_slice() else { panic!("{pages}") };
    let schema = Schema::at("tests/data/kubernetes-job.json");
    for page in [parts, merge] {
        schema.accepts(page).unwrap();
        let mut slip = page.clone();
        slip["spec"]["completionmode"] = "Indexed".into();
        assert!(schema.accepts(&slip).is_err());
    }
    assert_eq!(parts["spec"]["completions"], 3);
    let mut restarted = parts.clone();
    restarted["spec"]["template"]["spec"]["restartPolicy"] = "Always".into();
    assert!(schema.accepts(&restarted).is_err());
    // What the containers run, run here: the index counts from 0, the merge waits for all.
    let script = |page: &Value| {
        let command = &page["spec"]["template"]["spec"]["containers"][0]["command"];
        let text = command[2].as_str().unwrap();
        text.replace("/cordon/", &format!("{}/", dir.display()))
    };
    let sh = |page: &Value, index: &str| {
        let mut sh = Command::new("sh");
        sh.args(["-c", &script(page)]).current_dir(&dir).env("JOB_COMPLETION_INDEX", index);
        sh.status().unwrap().code()
    };
    for index in ["0", "2", "1"] {
        assert_eq!(sh(parts, index), Some(0));
    }
    assert_eq!(sh(merge, ""), Some(1));
    assert!(dir.join("sweep.jsonl").exists());
}

/// A cluster of this one machine, in a folder of its own.
struct Slurm {
    folder: tempfile::TempDir,
    daemons: Vec<Child>,
}

impl Drop for Slurm {
    fn drop(&mut self) {
        for daemon in self.daemons.iter_mut().rev() {
            let _ = daemon.kill();
            let _ = daemon.wait();
        }
    }
}

/// Waits for something that other processes do.
fn until(what: &str, mut done: impl FnMut() -> bool) {
    for _ in 0..30_000 {
        if done() {
            return;
        }
        sleep(Duration::from_millis(20));
    }
    panic!("waited for {what}");
}

impl Slurm {
    fn start() -> Option<Self> {
        for tool in ["slurmctld", "slurmd", "sbatch"] {
            // Without a configuration `-V` fails, and is there all the same.
            let found = Command::new(tool).arg("-V").output().is_ok();
            if !found {
                missing("Slurm", tool);
                return None;
            }
        }
        let output =
            |command: &mut Command| String::from_utf8(command.output().unwrap().stdout).unwrap();
        if output(Command::new("id").arg("-u")).trim() != "0" || !has_tool("setpriv", "Slurm") {
            missing("Slurm", "root");
            return None;
        }
        let host = output(&mut Command::new("hostname"));
        let host = host.trim().split('.').next().unwrap();
        let folder = tempfile::tempdir().unwrap();
        let dir = folder.path();
        fs::set_permissions(dir, fs::Permissions::from_mode(0o755)).unwrap();
        let munge = dir.join("munge");
        fs::create_dir(&munge).unwrap();
        let mut key = fs::File::create(munge.join("key")).unwrap();
        key.set_permissions(fs::Permissions::from_mode(0o600)).unwrap();
        key.write_all(&[7; 64]).unwrap();
        Command::new("chown").args(["-R", "munge:munge"]).arg(&munge).status().unwrap();
        let port = || TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
        let at = dir.display();
        let conf = format!(
            "ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={}
SlurmdPort={}
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={at}/munge/socket
StateSaveLocation={at}/state
SlurmdSpoolDir={at}/spool
SlurmctldPidFile={at}/slurmctld.pid
SlurmdPidFile={at}/slurmd.pid
SlurmctldLogFile={at}/slurmctld.log
SlurmdLogFile={at}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
JobAcctGatherType=jobacct_gather/none
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs=2
PartitionName=test Nodes={host} Default=YES
",
            port(),
            port()
        );
        fs::write(dir.join("slurm.conf"), conf).unwrap();
        for name in ["state", "spool"] {
            fs::create_dir(dir.join(name)).unwrap();
        }
        let mut slurm = Self { folder, daemons: Vec::new() };
        let mut munged = vec![
            "setpriv --reuid munge --regid munge --clear-groups munged --foreground".to_owned(),
        ];
        for (flag, file) in [
            ("key-file", "key"),
            ("socket", "socket"),
            ("log-file", "log"),
            ("pid-file", "pid"),
            ("seed-file", "seed"),
        ] {
            munged.push(format!("--{flag}={}", munge.join(file).display()));
        }
        slurm.daemon(&munged.join(" "));
        until("munged", || munge.join("socket").exists());
        slurm.daemon("slurmctld -D");
        slurm.daemon("slurmd -D");
        until("an idle node", || slurm.says("sinfo -h -o %T").trim() == "idle");
        Some(slurm)
    }

    fn command(&self, line: &str) -> Command {
        let mut words = line.split_whitespace();
        let mut command = Command::new(words.next().unwrap());
        command.args(words).env("SLURM_CONF", self.folder.path().join("slurm.conf"));
        command
    }

    fn daemon(&mut self, line: &str) {
        let mut command = self.command(line);
        let daemon = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        self.daemons.push(daemon.spawn().unwrap());
    }

    fn says(&self, line: &str) -> String {
        String::from_utf8(self.command(line).output().unwrap().stdout).unwrap()
    }
}

/// A part is killed while it runs, queued again, and goes on; the merge is the single-machine run.
#[test]
fn a_job_array_of_slurm_loses_nothing() {
    let Some(slurm) = Slurm::start() else { return };
    let args = "7.2 --form sharp --drones 3..7 --max-denominator 7 --grid 48 --steps 30";
    let dir = slurm.folder.path().join("parts");
    let command = format!("{args} --submit slurm --shards 3 --partition test --time 60 --out");
    let submitted = cordon()
        .arg("sweep")
        .args(command.split(' '))
        .arg(&dir)
        .env("SLURM_CONF", slurm.folder.path().join("slurm.conf"))
        .output()
        .unwrap();
    let said = String::from_utf8(submitted.stdout).unwrap();
    assert!(submitted.status.success(), "{said}{}", String::from_utf8_lossy(&submitted.stderr));
    let array = said.split("job array ").nth(1).unwrap().split(',').next().unwrap().to_owned();
    let part = dir.join("part-1.jsonl");
    let lines = || fs::read_to_string(&part).unwrap().lines().count();
    until("a work item of part 1", || lines() > 1);
    let (_, out, _) = run(&["sweep", "status", dir.to_str().unwrap()]);
    assert!(out.contains("\npart 1: "), "killed too late: {out}");
    slurm.says(&format!("scontrol requeue {array}_1"));
    until("the kill", || slurm.says(&format!("squeue -h -o %T -j {array}_1")).trim() == "PENDING");
    // Slurm lets a job that was queued again wait for two minutes.
    slurm.says(&format!("scontrol update JobId={array}_1 StartTime=now"));
    until("the end of all jobs", || slurm.says("squeue -h").is_empty());
    let log = fs::read_to_string(dir.join("part-1.log")).unwrap();
    assert!(log.contains("CANCELLED") && log.contains("DUE TO JOB REQUEUE"), "{log}");
    assert!(log.contains("work items were finished before"), "{log}");
    let whole = slurm.folder.path().join("whole.jsonl");
    let (code, report, _) = sweep(&format!("{args} --out {}", whole.display()));
    assert_eq!(code, 0);
    assert!(fs::read(dir.join("sweep.jsonl")).unwrap() == fs::read(&whole).unwrap());
    assert_eq!(fs::read_to_string(dir.join("report.txt")).unwrap(), report);
    let (code, out, _) = run(&["sweep", "status", dir.to_str().unwrap()]);
    assert_eq!(code, 0, "{out}");
}
