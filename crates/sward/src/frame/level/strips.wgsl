// Every plant a strip (Olofsson and Silven).

fn choose_strip(blade: Blade, size: Size, place: Place) -> Choice {
    return choose_blade(blade, size, place);
}

fn kept_strips(home: GpuPatch, count: u32, nearest: f32) -> u32 {
    return kept_as_blades(home, count, nearest);
}
