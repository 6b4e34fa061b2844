//! The logger of FMI 2.0 takes its arguments as `printf` does, which stable Rust cannot define.

fn main() {
    println!("cargo::rerun-if-changed=src/logger.c");
    cc::Build::new().file("src/logger.c").compile("cordon_fmi_logger");
}
