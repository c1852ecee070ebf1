// From blades to clusters of them to bare ground.

fn choose_continuum(blade: Blade, size: Size, place: Place) -> Choice {
    return choose_blade(blade, size, place);
}

fn kept_continuum(home: GpuPatch, count: u32, nearest: f32) -> u32 {
    return kept_as_blades(home, count, nearest);
}
