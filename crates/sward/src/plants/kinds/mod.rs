//! The kinds of plants, each a model of its own.

mod clover;
mod composites;
mod grasses;
mod poppy;

use super::Plant;
use super::builder::Builder;
use super::model::Model;

/// A variant of a kind; the same seed gives the same.
pub(crate) fn model(plant: Plant, seed: u64) -> Model {
    let mut builder = Builder::new(seed, plant as u64);
    match plant {
        Plant::MeadowGrass => grasses::meadow(&mut builder),
        Plant::TallGrass => grasses::tall(&mut builder),
        Plant::FineGrass => grasses::fine(&mut builder),
        Plant::Clover => clover::clover(&mut builder),
        Plant::Daisy => composites::daisy(&mut builder),
        Plant::Poppy => poppy::poppy(&mut builder),
        Plant::Cornflower => composites::cornflower(&mut builder),
        Plant::DandelionClock => composites::dandelion_clock(&mut builder),
    }
    builder.finish(plant.width_share())
}
