//! What the stages share on the GPU: layout, buffers, bindings, capabilities.

pub mod bindings;
pub mod buckets;
pub mod buffers;
pub mod fingerprint;
pub mod layout;
pub mod limits;
pub mod lists;
pub mod packed;
pub mod page;
pub mod pictures;
pub mod quantize;
pub mod read;
pub mod shaders;
pub mod statistics;
pub mod uploads;
pub mod variants;
pub mod view;

#[cfg(test)]
mod layout_tests;
#[cfg(test)]
pub(crate) mod state_twin;
#[cfg(test)]
pub(crate) mod test_device;
