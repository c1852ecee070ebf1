//! The cull stage.
