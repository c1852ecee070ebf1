// Rows that a view may see of each column: what patch culling asks for a patch's cell.

@group(2) @binding(2) var<storage, read_write> columns: array<vec2<u32>>;

@compute @workgroup_size(64)
fn sweep_columns(@builtin(global_invocation_id) thread: vec3<u32>) {
    if thread.x < sweep.columns {
        columns[thread.x] = visible_rows(thread.x);
    }
}
