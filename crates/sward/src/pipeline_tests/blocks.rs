//! Blocks of patches that a view may see: none that it sees is missed, and few that it does not.

use super::rig::Rig;
use super::scenes::{random_field, random_view};
use crate::{Culling, Stage, Technique, View};

const EXTENT_M: f32 = 40.0;

/// 49 blocks: patches of 3 bands, so that a block's group of the scan has lanes to spare.
fn rig() -> Rig {
    Rig::new(random_field(21, 800_000, EXTENT_M, 192))
}

/// Culls as `Renderer::cull`, but of every block.
fn cull_every_block(rig: &mut Rig, view: &View) {
    rig.submit(|renderer, (device, _), encoder| {
        renderer.prepare_view(device, encoder, 0, view).expect("a valid view");
        renderer.see_every_block(device, encoder, 0);
        for stage in [Stage::PatchCull, Stage::Update, Stage::Light, Stage::Compact] {
            renderer.encode_stage(device, encoder, stage, 0, view);
        }
    });
}

/// Blocks that hold a patch which the view sees, as the shader finds them.
fn needed(rig: &Rig) -> usize {
    let each = rig.page(0).patches_a_block();
    let mut blocks: Vec<u32> = rig.all_work().iter().map(|(patch, ..)| patch / each).collect();
    blocks.dedup();
    blocks.len()
}

#[test]
fn what_a_view_sees_does_not_depend_on_blocks() {
    let mut rig = rig();
    let (mut run, mut seen, mut all) = (0, 0, 0);
    for seed in 0..8 {
        let technique = if seed < 4 { Technique::Continuum } else { Technique::Blades };
        let culling = Culling { max_distance_m: 25.0, ..Culling::default() };
        let view = View { technique, culling, ..random_view(seed, EXTENT_M) };
        rig.cull(&[view]);
        let (work, list) = (rig.all_work(), rig.list(0));
        run += rig.lists(0).seen.count as usize;
        seen += needed(&rig);
        cull_every_block(&mut rig, &view);
        assert_eq!(work, rig.all_work(), "view {seed}");
        assert_eq!(list, rig.list(0), "view {seed}");
        all += rig.page(0).block_count() as usize;
    }
    assert!(seen > 40 && run < 2 * seen && 2 * run < all, "{seen} of {run} of {all}");
}

#[test]
fn a_page_out_of_view_is_not_drawn() {
    let mut rig = rig();
    rig.cull(&[random_view(0, EXTENT_M)]);
    assert!(rig.statistics().blades_drawn > 0);
    rig.cull(&[super::scenes::see_none()]);
    assert_eq!(rig.lists(0).seen.count, 0);
    assert_eq!(rig.statistics().blades_drawn, 0);
}
