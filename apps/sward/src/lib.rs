//! The parts of the `sward` command that other programs share.
