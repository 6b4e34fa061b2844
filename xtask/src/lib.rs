//! Tasks that work only inside the repository: the matrix of evidence, the model checker's runner, the
//! test vectors of the mechanised mirrors.

pub mod cli;
pub mod model_check;
pub mod vectors;
pub mod verify;
