//! WGSL functions of the light stage, which `update` and `draw` call.
