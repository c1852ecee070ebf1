//! glTF files made by hand: what they hold is known, and each way of breaking them is refused.

use super::gltf::parse;
use super::mesh::check;
use crate::SceneError;
use glam::Vec3;
use proptest::prelude::*;
use std::path::Path;

/// Positions, normals, colours and indices of a triangle in the plane z = 0, facing +z.
fn buffer() -> Vec<u8> {
    let mut bytes = Vec::new();
    let floats = |bytes: &mut Vec<u8>, values: &[f32]| {
        values.iter().for_each(|v| bytes.extend(v.to_le_bytes()));
    };
    floats(&mut bytes, &[0., 0., 0., 1., 0., 0., 0., 1., 0.]);
    floats(&mut bytes, &[0., 0., 1., 0., 0., 1., 0., 0., 1.]);
    bytes.extend([255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255]);
    [0_u16, 1, 2].iter().for_each(|i| bytes.extend(i.to_le_bytes()));
    bytes.extend([0, 0]);
    bytes
}

const VIEWS: &str = r#""bufferViews":[
    {"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":36},
    {"buffer":0,"byteOffset":72,"byteLength":12},{"buffer":0,"byteOffset":84,"byteLength":6}],
  "accessors":[
    {"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
    {"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"},
    {"bufferView":2,"componentType":5121,"normalized":true,"count":3,"type":"VEC4"},
    {"bufferView":3,"componentType":5123,"count":3,"type":"SCALAR"}]"#;

const PRIMITIVE: &str =
    r#"{"attributes":{"POSITION":0,"NORMAL":1,"COLOR_0":2},"indices":3,"material":0}"#;

fn json(nodes: &str, primitive: &str) -> String {
    format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":{nodes},
        "meshes":[{{"primitives":[{primitive}]}}],"buffers":[{{"byteLength":92}}],
        "materials":[{{"pbrMetallicRoughness":{{"baseColorFactor":[0.5,0.25,1,1],"roughnessFactor":0.3}}}}],
        {VIEWS}}}"#
    )
}

fn glb(json: &str, binary: &[u8]) -> Vec<u8> {
    let mut text = json.as_bytes().to_vec();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut bytes = b"glTF".to_vec();
    let total = 12 + 8 + text.len() + 8 + binary.len();
    bytes.extend(2_u32.to_le_bytes());
    bytes.extend((total as u32).to_le_bytes());
    bytes.extend((text.len() as u32).to_le_bytes());
    bytes.extend(b"JSON");
    bytes.extend(&text);
    bytes.extend((binary.len() as u32).to_le_bytes());
    bytes.extend(b"BIN\0");
    bytes.extend(binary);
    bytes
}

fn read(bytes: &[u8]) -> Result<Vec<super::Part>, SceneError> {
    let file = Path::new("a.glb");
    let parts = parse(file, bytes)?;
    check(parts.iter().map(|part| &part.mesh)).map_err(|cause| SceneError::asset(file, cause))?;
    Ok(parts)
}

fn cause(bytes: &[u8]) -> String {
    let text = read(bytes).expect_err("broken").to_string();
    assert!(text.starts_with("a.glb: ") && !text.contains('\n'), "{text}");
    text
}

#[test]
fn accessors_that_are_not_there_and_other_versions_are_refused() {
    let json = |version: &str| {
        format!(
            r#"{{"asset": {{"version": "{version}"}},
                "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 3}}}}]}}]}}"#
        )
    };
    let error = |version| {
        let parsed = parse(std::path::Path::new("a.gltf"), json(version).as_bytes());
        parsed.expect_err("broken").to_string()
    };
    assert!(error("2.0").contains("a.gltf: mesh 0 primitive 0: accessor 3"), "{}", error("2.0"));
    assert!(error("1.0").contains("a.gltf: glTF version 1.0"), "{}", error("1.0"));
}

#[test]
fn nested_transforms_colours_and_material() {
    let nodes = r#"[{"translation":[10,0,0],"children":[1]},{"scale":[2,2,2],"mesh":0}]"#;
    let parts = read(&glb(&json(nodes, PRIMITIVE), &buffer())).expect("a triangle");
    let part = &parts[0];
    assert_eq!(part.mesh.positions, [Vec3::X * 10.0, Vec3::X * 12.0, Vec3::new(10.0, 2.0, 0.0)]);
    assert_eq!(part.mesh.normals, [Vec3::Z; 3]);
    assert_eq!(part.mesh.colors[1], [0.0, 1.0, 0.0, 1.0]);
    assert_eq!((part.base_color, part.roughness), (Some([0.5, 0.25, 1.0]), Some(0.3)));
}

#[test]
fn a_mirroring_node_turns_its_triangles() {
    let nodes = r#"[{"scale":[-1,1,1],"mesh":0}]"#;
    let parts = read(&glb(&json(nodes, PRIMITIVE), &buffer())).expect("a triangle");
    let mesh = &parts[0].mesh;
    let [a, b, c] = super::mesh::corners(mesh, mesh.triangles[0]);
    assert!((b - a).cross(c - a).dot(mesh.normals[0]) > 0.0);
    assert_eq!(mesh.normals[0], Vec3::Z);
}

#[test]
fn strips_fans_and_no_indices() {
    for (mode, expected) in [(4, 1), (5, 1), (6, 1)] {
        let primitive = format!(r#"{{"attributes":{{"POSITION":0}},"mode":{mode}}}"#);
        let parts = read(&glb(&json(r#"[{"mesh":0}]"#, &primitive), &buffer())).expect("read");
        assert_eq!(parts[0].mesh.triangles, vec![[0, 1, 2]; expected]);
    }
}

#[test]
fn each_break_is_named() {
    let (node, good) = (r#"[{"mesh":0}]"#, buffer());
    let with = |primitive: &str| glb(&json(node, primitive), &buffer());
    let whole = glb(&json(node, PRIMITIVE), &good);
    assert!(cause(&whole[..whole.len() - 40]).contains("truncated"));
    assert!(cause(&whole[..10]).contains("truncated"));
    assert!(cause(b"glTF").contains("truncated"));
    assert!(cause(b"not a glTF file").contains("broken glTF"));
    assert!(cause(b"").contains("broken glTF"));
    assert!(cause(&with(r#"{"attributes":{"NORMAL":1}}"#)).contains("POSITION"));
    assert!(cause(&with(r#"{"attributes":{"POSITION":0},"mode":1}"#)).contains("points or lines"));
    assert!(cause(&with(r#"{"attributes":{"POSITION":0},"indices":9}"#)).contains("invalid glTF"));
    let no_mesh = glb(&json("[{}]", PRIMITIVE), &good);
    assert!(cause(&no_mesh).contains("empty"));
    let looped = glb(&json(r#"[{"children":[1]},{"children":[0],"mesh":0}]"#, PRIMITIVE), &good);
    assert!(cause(&looped).contains("loop"));
    let short = json(node, PRIMITIVE)
        .replace(r#""count":3,"type":"SCALAR""#, r#""count":300,"type":"SCALAR""#);
    assert!(cause(&glb(&short, &good)).contains("accessor 3 reaches past"));
    let huge = json(node, PRIMITIVE)
        .replace(r#""count":3,"type":"SCALAR""#, r#""count":4000000000,"type":"SCALAR""#);
    assert!(cause(&glb(&huge, &good)).contains("accessor 3"));
    let missing = json(node, PRIMITIVE)
        .replace(r#"{"byteLength":92}"#, r#"{"byteLength":92,"uri":"gone.bin"}"#);
    assert!(cause(missing.as_bytes()).contains("gone.bin: no such file"));
}

#[test]
fn bad_numbers_are_named() {
    let json = json(r#"[{"mesh":0}]"#, PRIMITIVE);
    let mut out_of_range = buffer();
    out_of_range[84] = 7;
    assert!(cause(&glb(&json, &out_of_range)).contains("index 7 is out of range: 3 vertices"));
    for bad in [f32::NAN, f32::INFINITY] {
        let mut not_finite = buffer();
        not_finite[16..20].copy_from_slice(&bad.to_le_bytes());
        assert!(cause(&glb(&json, &not_finite)).contains("vertex 1"));
    }
    let mut flat = buffer();
    flat[12..16].copy_from_slice(&0.0_f32.to_le_bytes());
    assert!(cause(&glb(&json, &flat)).contains("no area"));
}

#[test]
fn sparse_accessors_replace_some_elements() {
    // Element 2 of the positions becomes the normal of element 0: (0, 0, 1).
    let sparse = r#""type":"VEC3","min":[0,0,0],"max":[1,1,0],"sparse":{"count":1,
        "indices":{"bufferView":3,"byteOffset":4,"componentType":5123},
        "values":{"bufferView":1}}"#;
    let json = json(r#"[{"mesh":0}]"#, PRIMITIVE)
        .replace(r#""type":"VEC3","min":[0,0,0],"max":[1,1,0]"#, sparse);
    let parts = read(&glb(&json, &buffer())).expect("a triangle");
    assert_eq!(parts[0].mesh.positions, [Vec3::ZERO, Vec3::X, Vec3::Z]);
    let mut beyond = buffer();
    beyond[88] = 9;
    let whole = r#"{"attributes":{"POSITION":0}}"#;
    let json = json.replace(PRIMITIVE, whole);
    assert!(cause(&glb(&json, &beyond)).contains("sparse index 9 is out of range"));
}

#[test]
fn embedded_buffers_are_read() {
    // 92 bytes in base64, with the standard alphabet.
    let alphabet = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for chunk in buffer().chunks(3) {
        let word =
            chunk.iter().fold(0_u32, |w, b| (w << 8) | u32::from(*b)) << (8 * (3 - chunk.len()));
        for i in 0..=chunk.len() {
            text.push(char::from(alphabet[(word >> (18 - 6 * i)) as usize & 63]));
        }
    }
    text.push('=');
    let uri = format!(r#"{{"byteLength":92,"uri":"data:application/octet-stream;base64,{text}"}}"#);
    let json = json(r#"[{"mesh":0}]"#, PRIMITIVE).replace(r#"{"byteLength":92}"#, &uri);
    assert_eq!(read(json.as_bytes()).expect("read")[0].mesh.positions[1], Vec3::X);
    let broken = json.replace("base64,", "base64,!");
    assert!(cause(broken.as_bytes()).contains("base64"));
}

proptest! {
    /// Whatever bytes change, there is a mesh or an error.
    #[test]
    fn damaged_files_never_panic(
        cut in 0_usize..2000,
        flips in prop::collection::vec((0_usize..2000, any::<u8>()), 0..6),
    ) {
        let nodes = r#"[{"translation":[1,0,0],"children":[1]},{"scale":[2,2,2],"mesh":0}]"#;
        let mut bytes = glb(&json(nodes, PRIMITIVE), &buffer());
        for (at, value) in flips {
            let at = at % bytes.len();
            bytes[at] = value;
        }
        if cut < 1000 {
            bytes.truncate(cut);
        }
        let _ = read(&bytes);
    }
}
