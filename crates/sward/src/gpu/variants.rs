//! Compute pipelines that are made when they are first needed.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::{Mutex, PoisonError};

/// Pipelines of one stage, by what they are made for.
#[derive(Debug)]
pub struct Variants<K>(Mutex<HashMap<K, wgpu::ComputePipeline>>);

impl<K> Default for Variants<K> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<K: Eq + Hash> Variants<K> {
    /// The one for `key`, made now if there is none.
    pub fn get(
        &self,
        key: K,
        make: impl FnOnce() -> wgpu::ComputePipeline,
    ) -> wgpu::ComputePipeline {
        let mut made = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        made.entry(key).or_insert_with(make).clone()
    }
}
