//! Commands that need the repository and have moved into it.

use cordon_core::Error;

/// The arguments of the command as it was called before it moved.
#[derive(clap::Args, Debug)]
pub struct Args {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, hide = true)]
    _rest: Vec<String>,
}

/// The error that names the command's new place.
pub(super) fn to(name: &str) -> Error {
    let own = match name {
        "verify" => "; for a protocol file `cordon theorems --protocol FILE --check`",
        _ => "",
    };
    Error::input(format!(
        "`cordon {name}` works inside the repository only: expected `cargo xtask {name}`, in its folder{own}"
    ))
}
