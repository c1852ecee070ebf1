//! What the stages share on the GPU: layout, buffers, capabilities.
