// Ground sweep (O section 3): which cells of a grid over the ground a view may see. Column by column,
// the rows whose cells meet the part of the frustum that lies between the lowest and the highest
// plane of the grid.

struct GpuSweep {
    // Lowest x and z of the grid, and the size of a cell, metres
    origin: vec2<f32>,
    cell: vec2<f32>,
    columns: u32,
    rows: u32,
    // Planes that hold all that belongs to any cell, metres
    low: f32,
    high: f32,
    // How far what belongs to a cell may reach beyond its edges, along x and z, metres
    margin: vec2<f32>,
    // z over w of the farthest depth that matters: the far plane, or the grid's own end
    far_value: f32,
    // Share by which far corners are moved out, for what f32 loses between near and far
    push: f32,
    // 0 corners, 1 a test of every cell
    method: u32,
    reserved_a: u32,
    reserved_b: u32,
    reserved_c: u32,
}

@group(2) @binding(1) var<uniform> sweep: GpuSweep;

// A plane's (x, y, z, w) by its length.
fn unit_plane(plane: vec4<f32>) -> vec4<f32> {
    return plane / max(length(plane.xyz), 1e-20);
}

// O's mixed system (1) on the plane y: known are the point's clip x, z and w, up to their scale, and
// its y; unknown its x and z, its clip y and the scale. The scale goes out first: with it as clip w,
// clip x = side w and clip z = value w are two planes. Clip y and the scale then follow, unasked.
fn ground_corner(side: f32, value: f32, y: f32) -> vec2<f32> {
    let m = transpose(view.clip_from_world);
    let p = unit_plane(m[0] - side * m[3]);
    let q = unit_plane(m[2] - value * m[3]);
    let right = -vec2<f32>(p.y * y + p.w, q.y * y + q.w);
    // Never 0: the host takes the other method before
    let det = p.x * q.z - p.z * q.x;
    return vec2<f32>(right.x * q.z - p.z * right.y, p.x * right.y - right.x * q.x) / det;
}

// Corners on one plane, in a ring: left near, right near, right far, left far.
fn ground_ring(y: f32) -> array<vec2<f32>, 4> {
    let a = ground_corner(-1.0, 0.0, y);
    let b = ground_corner(1.0, 0.0, y);
    let c = ground_corner(1.0, sweep.far_value, y);
    let d = ground_corner(-1.0, sweep.far_value, y);
    return array<vec2<f32>, 4>(a, b, c + (c - b) * sweep.push, d + (d - a) * sweep.push);
}

// Lowest and highest z; none where the first is above the second.
struct Span {
    low: f32,
    high: f32,
}

// The span widened by the part of an edge that lies between two x.
fn with_edge(span: Span, from_corner: vec2<f32>, to_corner: vec2<f32>, x: vec2<f32>) -> Span {
    if max(from_corner.x, to_corner.x) < x.x || min(from_corner.x, to_corner.x) > x.y {
        return span;
    }
    let along = to_corner.x - from_corner.x;
    var t = vec2<f32>(0.0, 1.0);
    if abs(along) > 1e-6 {
        t = clamp((x - from_corner.x) / along, vec2<f32>(0.0), vec2<f32>(1.0));
    }
    let z = mix(vec2<f32>(from_corner.y), vec2<f32>(to_corner.y), t);
    return Span(min(span.low, min(z.x, z.y)), max(span.high, max(z.x, z.y)));
}

// z that what lies between two x may have inside a plane, whatever its height.
fn within_plane(span: Span, plane: vec4<f32>, x: vec2<f32>) -> Span {
    let best = max(plane.x * x.x, plane.x * x.y)
        + max(plane.y * sweep.low, plane.y * sweep.high) + plane.w;
    if abs(plane.z) < 1e-6 {
        // Level along z: all or nothing, with room for rounding
        return Span(span.low, select(span.high, span.low - 1.0, best < -1e-3));
    }
    let end = -best / plane.z;
    if plane.z > 0.0 {
        return Span(max(span.low, end), span.high);
    }
    return Span(span.low, min(span.high, end));
}

// Rows of a column: the first, and how many.
fn rows_of(span: Span) -> vec2<u32> {
    let from_row = (span.low - sweep.margin.y - sweep.origin.y) / sweep.cell.y;
    let to_row = (span.high + sweep.margin.y - sweep.origin.y) / sweep.cell.y;
    let last_row = f32(sweep.rows) - 1.0;
    if !(span.low <= span.high) || to_row < 0.0 || from_row > last_row + 1.0 {
        return vec2<u32>(0u);
    }
    let begin = u32(clamp(floor(from_row), 0.0, last_row));
    let end = u32(clamp(floor(to_row), 0.0, last_row));
    return vec2<u32>(begin, end + 1u - begin);
}

fn column_x(column: u32) -> vec2<f32> {
    let x = sweep.origin.x + f32(column) * sweep.cell.x;
    return vec2<f32>(x - sweep.margin.x, x + sweep.cell.x + sweep.margin.x);
}

// O's way: between the edges of the quadrilateral. The part of the frustum between two planes is a
// prism, whose shadow on the ground the edges of its two quadrilaterals and those between bound.
fn swept_rows(column: u32) -> vec2<u32> {
    let x = column_x(column);
    var below = ground_ring(sweep.low);
    var above = ground_ring(sweep.high);
    var span = Span(3e38, -3e38);
    for (var i = 0u; i < 4u; i++) {
        let next = (i + 1u) % 4u;
        span = with_edge(span, below[i], below[next], x);
        span = with_edge(span, above[i], above[next], x);
        span = with_edge(span, below[i], above[i], x);
    }
    // Ours: the paper's corners know no bottom and no top of the picture
    span = within_plane(span, view.planes[2], x);
    span = within_plane(span, view.planes[3], x);
    return rows_of(span);
}

fn cell_meets_frustum(column: u32, row: u32) -> bool {
    let x = column_x(column);
    let z = sweep.origin.y + f32(row) * sweep.cell.y;
    let low = vec3<f32>(x.x, sweep.low, z - sweep.margin.y);
    let high = vec3<f32>(x.y, sweep.high, z + sweep.cell.y + sweep.margin.y);
    for (var i = 0u; i < 6u; i++) {
        let plane = view.planes[i];
        let corner = select(low, high, plane.xyz > vec3<f32>(0.0));
        if dot(plane.xyz, corner) + plane.w < 0.0 {
            return false;
        }
    }
    return true;
}

// The way for any camera. A plane keeps the rows on one side of one of them, so that what six
// planes keep is a run of rows.
fn tested_rows(column: u32) -> vec2<u32> {
    var begin = 0u;
    while begin < sweep.rows && !cell_meets_frustum(column, begin) {
        begin++;
    }
    var end = begin;
    while end < sweep.rows && cell_meets_frustum(column, end) {
        end++;
    }
    return vec2<u32>(begin, end - begin);
}

fn visible_rows(column: u32) -> vec2<u32> {
    if sweep.method == 0u {
        return swept_rows(column);
    }
    return tested_rows(column);
}
