//! Every struct that host and shaders share, compared member by member through naga.

use super::layout::*;
use super::quantize::SEGMENTS;
use super::shaders::Shader;
use super::view;
use crate::frame::collide::primitive::{self, GpuPrimitive};
use crate::frame::debug::{CORNER_STRIDE, GpuDebug};
use crate::frame::draw::topology::BLADES_PER_INSTANCE;
use crate::frame::sweep::plan::GpuSweep;
use crate::frame::wind::GpuWindSource;
use crate::{Billboard, Form, Plant, Strip, Technique};
use std::mem::{offset_of, size_of};

struct Expected {
    name: &'static str,
    size: usize,
    members: Vec<(&'static str, usize)>,
}

macro_rules! expected {
    ($type:ident { $($member:ident),+ $(,)? }) => {
        Expected {
            name: stringify!($type),
            size: size_of::<$type>(),
            members: vec![$((stringify!($member), offset_of!($type, $member))),+],
        }
    };
}

/// Of the step: what all blades share.
fn structs_of_the_step() -> Vec<Expected> {
    vec![
        expected!(GpuFrame {
            gravity_direction,
            gravity_center,
            to_sun,
            sun,
            sky,
            ground,
            haze,
            sway,
            shade,
            dt_s,
            gravity_blend,
            crush_decay,
            physics_model,
            wind_count,
            chunk_count,
            step,
            ticks,
            resting_chunks,
            keep_resting,
            shade_x,
            shade_y,
            wind_sources,
        }),
        expected!(GpuPrimitive { a, b }),
        expected!(GpuWindSource {
            kind,
            seed,
            direction,
            strength,
            frequency,
            rate,
            phase,
            radius,
            range,
            position,
            turbulence,
            velocity,
            spread,
            flow,
            carried,
            spokes,
            spoke_rate,
            spoke_wind,
            pulse,
            map_row,
            map_size,
            reserved,
        }),
    ]
}

/// Of the field: blades, and what is counted of them.
fn structs_of_the_field() -> Vec<Expected> {
    vec![
        expected!(GpuField {
            blade_count,
            patch_count,
            patch_size,
            first_id,
            cluster,
            layers,
            reserved_a,
            reserved_b
        }),
        expected!(GpuPage { field, species }),
        expected!(GpuPatch { origin, edge, reach_min, cell, reach_max, max_width }),
        expected!(GpuSpecies {
            height,
            width,
            response,
            droop,
            gust,
            arch,
            first_bucket,
            tint,
            form,
            area_scale,
            colors,
            look,
            look_values,
        }),
        expected!(GpuBand { step, ticks, culled, tested, counts, anchor_step, anchor_ticks, sway }),
        expected!(GpuBlock { buckets, counted }),
        expected!(GpuDraw { start, count, dropped, reserved }),
    ]
}

/// Of a view, and of the light of what it sees.
fn structs_of_the_view() -> Vec<Expected> {
    vec![
        expected!(GpuView {
            clip_from_world,
            eye,
            depth_row,
            planes,
            depth_from_value,
            size,
            focal,
            detail,
            least_width,
            max_distance,
            flags,
            capacity,
            level_height,
            cluster_height,
            technique,
            least_cluster,
            far_share,
            far_size,
            bands,
            level_scale,
            reserved_a,
            reserved_b,
            reserved_c,
        }),
        expected!(GpuLook { waves, around, tilt }),
        expected!(GpuBent { mean, first, second, third, across, across_double }),
        expected!(GpuCanopyRow { shown, rest, winds }),
        expected!(GpuCanopy { size, pose, tint, tint_mean, cards, rows }),
        expected!(GpuSweep {
            origin,
            cell,
            columns,
            rows,
            low,
            high,
            margin,
            far_value,
            push,
            method,
            reserved_a,
            reserved_b,
            reserved_c,
        }),
        expected!(GpuDebug { mode, reserved_a, reserved_b, reserved_c, palette }),
    ]
}

/// Name, span, members (name, offset).
type ShaderStruct = (String, usize, Vec<(String, usize)>);

/// Every struct of a module.
fn shader_structs(shader: Shader) -> Vec<ShaderStruct> {
    let module =
        naga::front::wgsl::parse_str(&shader.source()).expect("valid, as another test shows");
    module
        .types
        .iter()
        .filter_map(|(_, ty)| {
            let naga::TypeInner::Struct { members, span } = &ty.inner else { return None };
            let list = members
                .iter()
                .map(|m| (m.name.clone().unwrap_or_default(), m.offset as usize))
                .collect();
            Some((ty.name.clone()?, *span as usize, list))
        })
        .collect()
}

#[test]
fn structs_agree_with_the_shaders() {
    let mut seen = std::collections::BTreeSet::new();
    let structs = [structs_of_the_step(), structs_of_the_field(), structs_of_the_view()];
    let expected = structs.into_iter().flatten().collect::<Vec<_>>();
    for shader in Shader::ALL {
        for (name, span, members) in shader_structs(shader) {
            let Some(own) = expected.iter().find(|e| e.name == name) else {
                assert!(!name.starts_with("Gpu"), "{name} of {shader:?} has no counterpart here");
                continue;
            };
            let list: Vec<_> = own.members.iter().map(|(n, o)| (n.to_string(), *o)).collect();
            assert_eq!(members, list, "{name} of {shader:?}");
            assert_eq!(span, own.size, "span of {name} of {shader:?}");
            seen.insert(name);
        }
    }
    assert_eq!(seen.len(), expected.len(), "some struct is in no shader: {seen:?}");
}

/// Constants that the host repeats, by their value in every shader that has them.
#[test]
fn constants_agree_with_the_shaders() {
    let expected = [
        ("BAND", BAND),
        ("BUCKETS", BUCKETS as u32),
        ("CLUSTER_BUCKET", CLUSTER_BUCKET as u32),
        ("STRIP_BUCKET", STRIP_BUCKETS[0] as u32),
        ("BILLBOARD_BUCKET", BILLBOARD_BUCKETS[0] as u32),
        ("FAR_BILLBOARD_BUCKET", BILLBOARD_BUCKETS[1] as u32),
        ("MODEL_BUCKET", MODEL_BUCKET as u32),
        ("BLADES", Technique::Blades as u32),
        ("STRIPS", Technique::Strips as u32),
        ("BILLBOARDS", Technique::Billboards as u32),
        ("CONTINUUM", Technique::Continuum as u32),
        ("FORM_BLADE", Form::Blade.number()),
        ("FORM_STRIP", Form::Strip(Strip::default()).number()),
        ("FORM_BILLBOARD", Form::Billboard(Billboard::new(Plant::Daisy)).number()),
        ("BLOCK", BLOCK),
        ("NEAR_STRIDE", NEAR_STRIDE),
        ("NEAR_SLOTS", NEAR_SLOTS),
        ("CHUNK_STRIDE", CHUNK_STRIDE as u32),
        ("CAPSULE", primitive::CAPSULE),
        ("SWEPT", primitive::SWEPT),
        ("CUBOID", primitive::CUBOID),
        ("CULL_FRUSTUM", view::FRUSTUM),
        ("CULL_DISTANCE", view::DISTANCE),
        ("CULL_ORIENTATION", view::ORIENTATION),
        ("CULL_OCCLUSION", view::OCCLUSION),
        ("CULL_PAPER", view::PAPER),
        ("WIDTH_CORRECTION", view::WIDTH_CORRECTION),
        ("HAS_DEPTH", view::HAS_DEPTH),
        ("GROUND_SWEPT", view::GROUND_SWEPT),
        ("LEVELS", SEGMENTS.len() as u32),
        ("CORNER_STRIDE", CORNER_STRIDE as u32),
    ];
    let mut seen = std::collections::BTreeSet::new();
    for shader in Shader::ALL {
        let module = naga::front::wgsl::parse_str(&shader.source()).expect("valid");
        for (_, constant) in module.constants.iter() {
            let name = constant.name.as_deref().unwrap_or_default();
            let Some((name, value)) = expected.iter().find(|(n, _)| *n == name) else { continue };
            let found = &module.global_expressions[constant.init];
            let literal = naga::Expression::Literal(naga::Literal::U32(*value));
            assert_eq!(format!("{found:?}"), format!("{literal:?}"), "{name} of {shader:?}");
            seen.insert(*name);
        }
    }
    assert_eq!(seen.len(), expected.len(), "some constant is in no shader: {seen:?}");
    assert_eq!(BLADES_PER_INSTANCE, BAND, "an instance is a band's worth of blades");
}

/// Mesa 22.3's lavapipe notes which uniforms a branch hangs on in a table with room for four buffers, the
/// first of which holds push constants; it writes past its end for the fourth of ours and those after it, and
/// crashes later. So what branches ask for lies in the first three.
#[test]
fn groups_begin_with_one_uniform() {
    let expected = [("frame", [0, 0]), ("page", [1, 0]), ("view", [2, 0])];
    let mut seen = std::collections::BTreeSet::new();
    for shader in Shader::ALL {
        let module = naga::front::wgsl::parse_str(&shader.source()).expect("valid");
        for (_, variable) in module.global_variables.iter() {
            let (naga::AddressSpace::Uniform, Some(at)) = (variable.space, &variable.binding)
            else {
                continue;
            };
            let name = variable.name.as_deref().unwrap_or_default();
            let place = [at.group, at.binding];
            let stands = expected.iter().find(|e| e.0 == name || e.1 == place);
            assert!(at.group > 1 || stands.is_some(), "{name} of {shader:?}");
            let Some(stands) = stands else { continue };
            assert_eq!(*stands, (name, place), "{shader:?}");
            seen.insert(name.to_owned());
        }
    }
    assert_eq!(seen.len(), expected.len());
}
