// The blocks of patches that a view may see: see blocks.rs. Needs a variable `seen_blocks`: how many
// there are, then their numbers, ascending.

fn seen_block_count() -> u32 {
    return seen_blocks[0].x;
}

fn seen_block(slot: u32) -> u32 {
    let word = slot + 1u;
    return seen_blocks[word / 4u][word % 4u];
}

// Patch of a thread, one each; beyond the last patch where there is none.
fn seen_patch(thread: u32) -> u32 {
    let each = patches_a_block();
    let slot = thread / each;
    if slot >= seen_block_count() {
        return page.field.patch_count;
    }
    return seen_block(slot) * each + thread % each;
}
