// Three bands of distance (Wang and Yao).

fn choose_band(blade: Blade, size: Size, place: Place) -> Choice {
    return choose_blade(blade, size, place);
}

fn kept_bands(home: GpuPatch, count: u32, nearest: f32) -> u32 {
    return kept_as_blades(home, count, nearest);
}
