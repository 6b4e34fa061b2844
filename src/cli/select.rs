//! Arguments that several commands share.

use cordon_spec::theorems::Form;

/// Form of a command's output.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutputFormat {
    /// Aligned columns for people.
    Text,
    /// For programs, with a versioned schema.
    Json,
}

/// A form of a theorem, as a flag.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum FormArg {
    /// As printed.
    Paper,
    /// Under the weakest known hypothesis.
    Sharp,
}

impl From<FormArg> for Form {
    fn from(form: FormArg) -> Self {
        match form {
            FormArg::Paper => Self::Paper,
            FormArg::Sharp => Self::Sharp,
        }
    }
}
