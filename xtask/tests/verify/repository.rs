//! A repository with tools of its own.

use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;

pub struct Repository {
    dir: TempDir,
}

impl Repository {
    pub fn new() -> Self {
        let this = Self { dir: tempfile::tempdir().unwrap() };
        this.write("spec/src/lib.rs", "// the spec");
        this.write("src/export/mod.rs", "// an engine");
        this.write("proofs/rocq/theorems.tsv", "id\tform\n7.2\tsharp\n7.2\tpaper\n7.4\tpaper\n");
        this.write("proofs/rocq/theories/A.v", "Theorem a.");
        this.script("proofs/rocq/check.sh", "echo progress >&2; echo '3 passed, 0 failed'");
        this.script("bin/coqc", "echo 'a Rocq for tests, 0.1'");
        this.script("bin/z3", "if [ \"$1\" = --version ]; then echo 'a z3 for tests'; else cat >/dev/null; echo unsat; fi");
        this
    }

    pub fn root(&self) -> &Path {
        self.dir.path()
    }

    pub fn write(&self, name: &str, text: &str) {
        let path = self.root().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }

    pub fn script(&self, name: &str, body: &str) {
        self.write(name, &format!("#!/bin/sh\n{body}\n"));
        let path = self.root().join(name);
        std::fs::set_permissions(path, PermissionsExt::from_mode(0o755)).unwrap();
    }

    pub fn verify(&self, args: &[&str]) -> Output {
        let path = format!("{}:/usr/bin:/bin", self.root().join("bin").display());
        Command::new(env!("CARGO_BIN_EXE_xtask"))
            .arg("verify")
            .args(["--root", self.root().to_str().unwrap()])
            .args(args)
            .env("PATH", path)
            .output()
            .unwrap()
    }

    pub fn json(&self, args: &[&str], code: i32) -> Value {
        let out = self.verify(&[args, &["--format", "json"]].concat());
        let said = String::from_utf8_lossy(&out.stderr);
        assert_eq!(out.status.code(), Some(code), "{args:?}: {said}");
        let page: Value = serde_json::from_slice(&out.stdout).unwrap();
        assert_eq!(page["schema"], "cordon-verify/1");
        assert_eq!(page["exit"], code);
        page
    }

    pub fn error(&self, args: &[&str]) -> String {
        let out = self.verify(args);
        assert_eq!(out.status.code(), Some(2), "{args:?}");
        assert!(out.stdout.is_empty());
        String::from_utf8(out.stderr).unwrap()
    }
}
