// What a view may see of a terrain: its cells in order, and their triangles for one indirect draw.

struct IndirectDraw {
    index_count: u32,
    instance_count: u32,
    first_index: u32,
    base_vertex: i32,
    first_instance: u32,
}

// First row, rows, place of the first cell in the list, place of its first triangle
@group(2) @binding(2) var<storage, read_write> columns: array<vec4<u32>>;
// Triangles before each cell, column by column, and one more: all
@group(2) @binding(3) var<storage, read> first_triangle: array<u32>;
// The terrain's indices, by cell
@group(2) @binding(4) var<storage, read> triangles: array<u32>;
@group(2) @binding(5) var<storage, read_write> indices: array<u32>;
// How many, then the cells: column times rows plus row
@group(2) @binding(6) var<storage, read_write> cells: array<u32>;
@group(2) @binding(7) var<storage, read_write> indirect: IndirectDraw;

const LANES: u32 = 256u;

var<workgroup> sums: array<vec2<u32>, 256>;

fn triangles_before(column: u32, row: u32) -> u32 {
    return first_triangle[column * sweep.rows + row];
}

// One workgroup, a run of columns a lane: intervals, then prefix sums of their cells and triangles.
@compute @workgroup_size(256)
fn sweep_terrain(@builtin(local_invocation_index) lane: u32) {
    let run = (sweep.columns + LANES - 1u) / LANES;
    let begin = min(lane * run, sweep.columns);
    let end = min(begin + run, sweep.columns);
    var own = vec2<u32>(0u);
    for (var c = begin; c < end; c++) {
        let rows = visible_rows(c);
        let count = triangles_before(c, rows.x + rows.y) - triangles_before(c, rows.x);
        columns[c] = vec4<u32>(rows, own);
        own += vec2<u32>(rows.y, count);
    }
    sums[lane] = own;
    workgroupBarrier();
    for (var step = 1u; step < LANES; step *= 2u) {
        var below = vec2<u32>(0u);
        if lane >= step {
            below = sums[lane - step];
        }
        workgroupBarrier();
        sums[lane] += below;
        workgroupBarrier();
    }
    let before = sums[lane] - own;
    for (var c = begin; c < end; c++) {
        columns[c] += vec4<u32>(0u, 0u, before);
    }
    if lane == LANES - 1u {
        cells[0] = sums[lane].x;
        indirect = IndirectDraw(sums[lane].y * 3u, 1u, 0u, 0, 0u);
    }
}

// One workgroup a column: its cells and triangles to their places.
@compute @workgroup_size(64)
fn list_terrain(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let column = columns[group.x];
    for (var i = lane; i < column.y; i += 64u) {
        cells[1u + column.z + i] = group.x * sweep.rows + column.x + i;
    }
    let begin = 3u * triangles_before(group.x, column.x);
    let end = 3u * triangles_before(group.x, column.x + column.y);
    for (var i = lane; i < end - begin; i += 64u) {
        indices[3u * column.w + i] = triangles[begin + i];
    }
}
