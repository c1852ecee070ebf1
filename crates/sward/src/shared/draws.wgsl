// A bucket's part of the draw list.

struct GpuDraw {
    // Range of the list
    start: u32,
    count: u32,
    dropped: u32,
    reserved: u32,
}
