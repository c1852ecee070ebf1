//! The canopy's light, by its shipped text, against the mean of the blades' own light.

use super::ask::{self, Entry};
use crate::bake::color::{tone_at, tones};
use crate::bake::cover::{Cover, look, sine};
use crate::bake::stand::Stands;
use crate::gpu::layout::GpuField;
use crate::gpu::quantize::{pack_color, species_table, unpack_color};
use crate::gpu::shaders::Shader;
use crate::plants::layers::PlantLayers;
use crate::{Canopy, Field, FieldDesc, Light, Mesh, Surface, canopy};
use bytemuck::Zeroable;
use glam::{UVec2, Vec2, Vec3, Vec4};
use wgpu::BufferUsages as U;

const FRAME: &str = "
struct Frame { to_sun: vec4<f32>, sun: vec4<f32>, sky: vec4<f32>, ground: vec4<f32>, haze: vec4<f32> }
@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var<uniform> canopy: GpuCanopy;
@group(0) @binding(2) var<storage, read> given: array<vec4<f32>>;
@group(0) @binding(3) var<storage, read_write> found: array<vec4<f32>>;
";

/// The radiance of a canopy from directions (`xyz`), and that of surfaces: three vectors each, the
/// direction; normal and height; albedo and lean.
const RUN: &str = "
@compute @workgroup_size(1)
fn of_canopy(@builtin(global_invocation_id) id: vec3<u32>) {
    let up = vec3<f32>(0.0, 1.0, 0.0);
    let eye = given[id.x].xyz;
    found[id.x] = vec4<f32>(canopy_radiance(up, eye, vec3<f32>(0.0), 0.25), canopy_coverage(up, eye, vec3<f32>(0.0)));
}

@compute @workgroup_size(1)
fn of_clear_canopy(@builtin(global_invocation_id) id: vec3<u32>) {
    let up = vec3<f32>(0.0, 1.0, 0.0);
    let eye = given[2u * id.x].xyz;
    let sway = given[2u * id.x + 1u].xyz;
    found[id.x] = vec4<f32>(canopy_radiance(up, eye, sway, 0.0), canopy_coverage(up, eye, sway));
}

@compute @workgroup_size(1)
fn of_blades(@builtin(global_invocation_id) id: vec3<u32>) {
    let normal = given[3u * id.x + 1u];
    let albedo = given[3u * id.x + 2u];
    let up = vec3<f32>(0.0, 1.0, 0.0);
    let surface =
        BladeSurface(albedo.xyz, normal.xyz, up, normal.w, canopy.size.w, albedo.w, 0.25, 0.0, 0.0);
    found[id.x] = vec4<f32>(shade_blade(surface, given[3u * id.x].xyz), 1.0);
}
";

fn light(to_sun: Vec3) -> Light {
    Light { to_sun: to_sun.normalize(), ..Light::default() }
}

/// Runs an entry point on `given`; so many results.
fn run(name: &str, canopy: &Canopy, light: &Light, given: &[[f32; 4]], count: usize) -> Vec<Vec4> {
    let source = format!("{}{FRAME}{RUN}", canopy::WGSL);
    let v = |v: Vec3| v.extend(0.0).to_array();
    let values = [v(light.to_sun), v(light.sun), v(light.sky), v(light.ground), v(light.haze)];
    let given = [
        (0, 0, U::UNIFORM, bytemuck::cast_slice(&values)),
        (0, 1, U::UNIFORM, canopy.uniform()),
        (0, 2, U::STORAGE, bytemuck::cast_slice(given)),
    ];
    let entry = Entry { source, name, constants: &[] };
    ask::run(&entry, &given, ((0, 3), count), count as u32)
}

/// Radiance and coverage of a canopy in clear air, from that direction.
pub(super) fn of_canopy(canopy: &Canopy, light: &Light, to_eye: Vec3, sway: Vec3) -> Vec4 {
    let given = [to_eye, sway].map(|v| v.extend(0.0).to_array());
    run("of_clear_canopy", canopy, light, &given, 1)[0]
}

fn meadow() -> Field {
    let mesh = Mesh::plane(Vec2::splat(15.0), UVec2::ONE).expect("a plane");
    let surface = Surface::new(mesh).expect("a surface");
    Field::grow(&surface, &FieldDesc { density: 300.0, ..Default::default() }).expect("a field")
}

/// All that shows from an elevation, as `of_blades` takes it.
fn all_that_shows(stands: &Stands, row: usize, to_eye: Vec3) -> Vec<[f32; 4]> {
    let toward = Vec3::new(to_eye.x, 0.0, to_eye.z).normalize();
    let right = Vec3::Y.cross(toward);
    let mut cover = Cover::default();
    for stand in stands.fitted() {
        cover = cover.with(look(&stand.posed(0), stand.period, stand.downwind - 1.0, row, 64));
    }
    cover
        .shown
        .iter()
        .flat_map(|s| {
            let n = right * s.normal.x + Vec3::Y * s.normal.y + toward * s.normal.z;
            [to_eye.extend(0.0), n.extend(s.height_share), s.albedo.extend(s.lean)]
        })
        .map(|v| v.to_array())
        .collect()
}

/// The functions on the sphere give the mean of the light on all that shows, for suns high and low,
/// before the eye and behind it.
#[test]
fn canopy_light_is_the_mean_of_the_blades() {
    let field = meadow();
    let stands = Stands::of(&field);
    let canopy = field.canopy();
    let suns = [Vec3::new(0.3, 1.0, 0.2), Vec3::new(0.8, 0.3, 0.0), Vec3::new(-0.2, 0.4, -0.9)];
    let mut worst = 0.0_f32;
    for row in [0, 2, 4] {
        let s = sine(row);
        let to_eye = Vec3::new(0.6 * (1.0 - s * s).sqrt(), s, 0.8 * (1.0 - s * s).sqrt());
        for sun in suns {
            let given = all_that_shows(&stands, row, to_eye);
            let each = run("of_blades", &canopy, &light(sun), &given, given.len() / 3);
            let mean = each.iter().map(|v| v.truncate()).sum::<Vec3>() / each.len() as f32;
            let found = run("of_canopy", &canopy, &light(sun), &[to_eye.extend(0.0).to_array()], 1);
            let found = found[0].truncate();
            let off = (found / mean - 1.0).abs().max_element();
            println!("elevation {row}, sun {sun}: {found} of {mean}, {:.2} %", off * 100.0);
            worst = worst.max(off);
        }
    }
    assert!(worst < 0.03, "{worst}");
}

/// `Canopy::coverage` is the shader's.
#[test]
fn structs_of_the_canopy_agree() {
    let source = format!("{}{FRAME}", canopy::WGSL);
    let module = naga::front::wgsl::parse_str(&source).expect("valid");
    let size = |name: &str| {
        module.types.iter().find_map(|(_, ty)| match &ty.inner {
            naga::TypeInner::Struct { span, .. } if ty.name.as_deref() == Some(name) => Some(*span),
            _ => None,
        })
    };
    use crate::gpu::layout::{GpuCanopy, GpuLook};
    assert_eq!(size("GpuCanopy"), Some(size_of::<GpuCanopy>() as u32));
    assert_eq!(size("GpuLook"), Some(size_of::<GpuLook>() as u32));
}

const COLORS: &str = "
@group(3) @binding(0) var<storage, read_write> colors: array<vec4<f32>>;
@compute @workgroup_size(1)
fn of_colors(@builtin(global_invocation_id) id: vec3<u32>) {
    var ids = array<u32, 5>(0u, 1u, 77u, 4000u, 123456u);
    var tones = array<f32, 3>(0.0, 0.3, 1.0);
    var blade: Blade;
    blade.id = ids[id.x];
    for (var i = 0u; i < 3u; i++) {
        colors[id.x * 3u + i] = vec4<f32>(blade_color(blade, tones[i]), 1.0);
    }
}
";

/// The colours that are baked are those that blades are drawn in, by the shipped text.
#[test]
fn baked_colors_are_the_blades() {
    let (ids, tone_list) = ([0_u32, 1, 77, 4000, 123_456], [0.0_f32, 0.3, 1.0]);
    let field = meadow();
    let mut table = species_table(&field, &PlantLayers::new(std::iter::empty()));
    table[0].tint = 0.6;
    let packed = pack_color([0.3, 0.2, 0.7]);
    let surface = Vec3::from(unpack_color(packed));
    // Its first blade's id is 0
    let (counts, tints): (GpuField, _) = (Zeroable::zeroed(), vec![packed; 123_457]);
    let page = [bytemuck::bytes_of(&counts), bytemuck::cast_slice(&table)].concat();
    let given = [(1, 0, U::UNIFORM, &page[..]), (1, 4, U::STORAGE, bytemuck::cast_slice(&tints))];
    for (tinted, tint) in [(0.0, 0.0), (1.0, 0.6)] {
        let source = Shader::Draw.source() + COLORS;
        let entry = Entry { source, name: "of_colors", constants: &[("TINTED", tinted)] };
        let found = ask::run(&entry, &given, ((3, 0), 15), ids.len() as u32);
        for (id, at) in ids.iter().zip(found.chunks(tone_list.len())) {
            let own = tones(&field.species()[0], *id, tint).on(surface);
            for (tone, at) in tone_list.iter().zip(at) {
                let expected = own[0].lerp(own[1], *tone);
                let off = (at.truncate() - expected).abs().max_element();
                assert!(off < 1e-4, "blade {id}, tone {tone}: {at:?} of {expected}");
            }
        }
    }
    assert_eq!(tone_at(1.0), 1.0);
}
