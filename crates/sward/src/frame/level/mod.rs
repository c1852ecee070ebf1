//! WGSL functions of the level stage, which `update` and `draw` call.
