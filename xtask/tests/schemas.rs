//! Every JSON that `cargo xtask` writes meets its schema in `schemas/`.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;
#[path = "../../tests/common/schema.rs"]
mod schema;

use schema::{meets, parsed};

#[test]
fn what_xtask_prints_meets_its_schema() {
    let calls: [(&str, &[&str]); 3] = [
        ("cordon-verify/1", &["verify", "--tiers", "kani,certificate,rocq", "--format", "json"]),
        ("cordon-vectors/2", &["vectors", "--to", "json"]),
        ("cordon-harnesses/1", &["kani", "--list", "--format", "json"]),
    ];
    for (format, args) in calls {
        let page = parsed(&common::run(args).1);
        assert_eq!(page["schema"], format);
        meets(format, &page, &args.join(" "));
    }
}
