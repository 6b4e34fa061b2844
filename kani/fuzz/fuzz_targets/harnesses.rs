//! Every harness that has to hold: the first byte chooses one, its body reads the rest.
#![no_main]

use cordon_kani::source::Bytes;
use cordon_kani::{Expected, all};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Some((which, rest)) = bytes.split_first() else { return };
    let count = all().filter(|h| h.expected == Expected::Holds).count();
    let chosen = all().filter(|h| h.expected == Expected::Holds).nth(usize::from(*which) % count);
    if let Some(harness) = chosen {
        let _ = (harness.from_bytes)(&mut Bytes::new(rest));
    }
});
