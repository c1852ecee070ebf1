// Work: what groups of 64 lanes do, as `cull` and `collide` list it. First come bands, one to a group;
// after room for all of them far patches, of which only the anchors are run, several to a group.

// Words of the sizes of work. Arguments of the dispatch over bands
const BAND_GROUPS: u32 = 0u;
const PATCHES_VISIBLE: u32 = 3u;
// Blades of these patches
const BLADES_VISIBLE: u32 = 4u;
// Arguments of the dispatch over far patches
const FAR_GROUPS: u32 = 5u;
const FAR_PATCHES: u32 = 8u;
// Patches whose list of colliders is full
const PATCHES_CROWDED: u32 = 9u;

// `kept`: blades of the patch's order that are run; `inside`: no part of the patch is out of view.
fn work_entry(patch_index: u32, inside: bool, kept: u32, band: u32) -> vec2<u32> {
    return vec2<u32>(patch_index | (u32(inside) << 31u), kept | (band << 16u));
}

// Lanes that run one patch's anchors: a power of two.
fn anchor_lanes() -> u32 {
    return 1u << (32u - countLeadingZeros(page.field.patch_size / CLUSTER_BLADES - 1u));
}

fn far_patches_a_group() -> u32 {
    return BAND / anchor_lanes();
}

// Where the entries of far patches begin.
fn first_far_entry() -> u32 {
    return page.field.patch_count * bands_per_patch();
}
