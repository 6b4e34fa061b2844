//! An Indexed Job of Kubernetes, and a Job that waits for it and merges.

use std::io::Write;
use std::path::Path;

use super::Jobs;
use cordon_core::text::shell_word;
use cordon_core::{Error, Result};

/// The file for `kubectl`.
pub(super) const SWEEP: &str = "sweep.yaml";

const CONTAINERFILE: &str = "\
# The programs of a sweep; its result files are in a volume.
FROM docker.io/library/debian:stable-slim
COPY cordon part.sh merge.sh /cordon/
WORKDIR /sweep
";

/// # Errors
/// A limit that only Slurm has.
pub(super) fn files(jobs: &Jobs<'_>) -> Result<Vec<(&'static str, String)>> {
    for (flag, value) in jobs.limits {
        if let Some(value) = value {
            return Err(Error::input(format!("{flag}: `{value}`: expected `--submit slurm`")));
        }
    }
    let Jobs { name, parts, threads, .. } = jobs;
    let indexed = format!(
        "  completionMode: Indexed
  completions: {parts}
  parallelism: {parts}
  backoffLimitPerIndex: 3
  podFailurePolicy:
    rules:
      - action: Ignore
        onPodConditions:
          - type: DisruptionTarget
            status: \"True\"
"
    );
    // The Job's index counts from 0.
    let part = r#"exec sh /cordon/part.sh "$((JOB_COMPLETION_INDEX + 1))""#;
    let merge = "until /cordon/cordon sweep status . >/dev/null 2>&1; do sleep 30; done; \
                 exec sh /cordon/merge.sh";
    let jobs = [
        job(name, name, &indexed, *threads, part),
        job(&format!("{name}-merge"), name, "  backoffLimit: 3\n", 1, merge),
    ];
    Ok(vec![(SWEEP, jobs.join("---\n")), ("Containerfile", CONTAINERFILE.to_owned())])
}

fn job(name: &str, image: &str, kind: &str, cores: usize, script: &str) -> String {
    format!(
        "apiVersion: batch/v1
kind: Job
metadata:
  name: {name}
spec:
{kind}  template:
    spec:
      restartPolicy: Never
      containers:
        - name: cordon
          image: {image}
          workingDir: /sweep
          command:
            - sh
            - -c
            - >-
              {script}
          resources:
            requests:
              cpu: \"{cores}\"
          volumeMounts:
            - name: sweep
              mountPath: /sweep
      volumes:
        - name: sweep
          persistentVolumeClaim:
            claimName: cordon-sweep
"
    )
}

/// Prints the remaining manual steps.
pub(super) fn next(jobs: &Jobs<'_>, folder: &Path, out: &mut dyn Write) -> Result<()> {
    let folder = folder.display().to_string();
    let folder = shell_word(&folder);
    writeln!(
        out,
        "with a volume claim `cordon-sweep` and a registry that the cluster reads:
  docker build --tag {} --file {folder}/Containerfile {folder}
  kubectl apply --filename {folder}/{SWEEP}",
        jobs.name
    )?;
    Ok(())
}
