//! Packed meshes in files beside their meshes, so that each is packed once.
//!
//! A file is a header, the spheres, and a checksum over both, all little-endian:
//! `"SWARDPK1"`, hash (16 bytes) of mesh, settings and version, number of spheres (`u32`), coverage
//! and bulge (`f32`), then x, y, z and radius of each sphere (`f32`), then the checksum (16 bytes).
//! Nothing in it is trusted: what does not fit is packed anew and the file written again.

use crate::build::Context;
use crate::error::one_line;
use glam::Vec3;
use std::ffi::OsString;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Instant;
use sward::{Mesh, PackDesc, Packing, Solid, Sphere};

const MAGIC: &[u8; 8] = b"SWARDPK1";
/// Rises when the packer finds other spheres for the same mesh (a test notices).
const VERSION: u32 = 2;
const HEADER: usize = 36;
const SPHERE: usize = 16;
const CHECKSUM: usize = 16;

/// Packs a mesh, or takes the spheres that were found before. `file` is the mesh's file; without
/// one nothing is kept.
pub(crate) fn pack(
    context: &mut Context,
    file: Option<&Path>,
    name: &str,
    mesh: &Mesh,
    solid: &Solid,
    desc: &PackDesc,
) -> Result<Packing, String> {
    let hash = hash(mesh, desc);
    let kept = file.map(|file| pack_file(file, hash));
    let found = kept.as_ref().map(|kept| read(kept, hash, desc, solid));
    if let Some(Ok(packing)) = found {
        return Ok(packing);
    }
    let start = Instant::now();
    let packing = solid.pack(desc).map_err(|error| one_line(&error.to_string()))?;
    let (Some(kept), Some(Err(why))) = (kept, found) else { return Ok(packing) };
    let (spheres, seconds) = (packing.spheres.len(), start.elapsed().as_secs_f64());
    let mut note = format!(
        "packed '{name}' into {spheres} spheres: covers {:.1} %, {seconds:.1} s",
        packing.coverage * 100.0
    );
    if solid.open_edges() > 0 {
        note += &format!("; it is open at {} edges, taken as closed", solid.open_edges());
    }
    if let Some(why) = why {
        note += &format!("; the kept file {why}");
    }
    if let Err(error) = write(&kept, &encode(hash, &packing)) {
        let (file, error) = (kept.display(), one_line(&error.to_string()));
        note += &format!("; not kept, as {file} cannot be written: {error}");
    }
    context.note(note);
    Ok(packing)
}

/// `bunny.obj` -> `bunny.obj.0123456789abcdef.pack`.
fn pack_file(file: &Path, hash: u128) -> PathBuf {
    let mut name = OsString::from(file.file_name().unwrap_or_default());
    name.push(format!(".{:016x}.pack", (hash >> 64) as u64));
    file.with_file_name(name)
}

/// What the spheres depend on.
fn hash(mesh: &Mesh, desc: &PackDesc) -> u128 {
    let mut hash = Fnv::new();
    hash.add(MAGIC);
    hash.add(&VERSION.to_le_bytes());
    hash.add(&desc.spheres.to_le_bytes());
    hash.add(&desc.bulge.to_le_bytes());
    hash.add(&(mesh.positions.len() as u64).to_le_bytes());
    for position in &mesh.positions {
        position.to_array().iter().for_each(|x| hash.add(&x.to_le_bytes()));
    }
    for triangle in &mesh.triangles {
        triangle.iter().for_each(|v| hash.add(&v.to_le_bytes()));
    }
    hash.0
}

/// FNV-1a with 128 bits (G. Fowler, L. C. Noll, K.-P. Vo).
struct Fnv(u128);

impl Fnv {
    fn new() -> Self {
        Self(0x6c62_272e_07bb_0142_62b8_2175_6295_c58d)
    }
    fn add(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u128::from(byte)).wrapping_mul(0x0100_0000_0000_0000_0000_013b);
        }
    }
    fn of(bytes: &[u8]) -> u128 {
        let mut hash = Self::new();
        hash.add(bytes);
        hash.0
    }
}

fn encode(hash: u128, packing: &Packing) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(HEADER + packing.spheres.len() * SPHERE + CHECKSUM);
    bytes.extend(MAGIC);
    bytes.extend(hash.to_le_bytes());
    bytes.extend((packing.spheres.len() as u32).to_le_bytes());
    bytes.extend(packing.coverage.to_le_bytes());
    bytes.extend(packing.bulge_m.to_le_bytes());
    for Sphere { center, radius } in &packing.spheres {
        [center.x, center.y, center.z, *radius].iter().for_each(|x| bytes.extend(x.to_le_bytes()));
    }
    bytes.extend(Fnv::of(&bytes).to_le_bytes());
    bytes
}

/// What was kept; else why it is of no use, where there is a file at all.
fn read(
    file: &Path,
    hash: u128,
    desc: &PackDesc,
    solid: &Solid,
) -> Result<Packing, Option<String>> {
    let most = HEADER + desc.spheres as usize * SPHERE + CHECKSUM;
    let mut bytes = Vec::new();
    let opened = std::fs::File::open(file);
    match opened.and_then(|file| file.take(most as u64 + 1).read_to_end(&mut bytes)) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Err(None),
        Err(error) => {
            return Err(Some(format!("cannot be read: {}", one_line(&error.to_string()))));
        }
        Ok(length) if length > most => return Err(Some("is too long".into())),
        Ok(_) => {}
    }
    decode(&bytes, hash, desc, solid).map_err(|why| Some(why.into()))
}

fn decode(
    bytes: &[u8],
    hash: u128,
    desc: &PackDesc,
    solid: &Solid,
) -> Result<Packing, &'static str> {
    let (magic, rest) = bytes.split_first_chunk::<8>().ok_or("is cut off")?;
    if magic != MAGIC {
        return Err("is of another version, or no pack file");
    }
    let (own_hash, rest) = rest.split_first_chunk::<16>().ok_or("is cut off")?;
    if u128::from_le_bytes(*own_hash) != hash {
        return Err("is of another mesh, setting or version");
    }
    let (numbers, rest) = rest.split_first_chunk::<12>().ok_or("is cut off")?;
    let [count, coverage, bulge] = words(numbers);
    let (count, coverage) = (u32::from_le_bytes(count), f32::from_le_bytes(coverage));
    let bulge_m = f32::from_le_bytes(bulge);
    if count == 0 || count > desc.spheres || rest.len() != count as usize * SPHERE + CHECKSUM {
        return Err("is cut off, or its number of spheres is wrong");
    }
    let (spheres, checksum) = rest.split_last_chunk::<16>().ok_or("is cut off")?;
    let body = bytes.len() - CHECKSUM;
    if Fnv::of(bytes.get(..body).unwrap_or_default()) != u128::from_le_bytes(*checksum) {
        return Err("is damaged: its checksum is wrong");
    }
    let (low, high) = solid.bounds();
    let mut packing = Packing { spheres: Vec::with_capacity(count as usize), coverage, bulge_m };
    let fits = (0.0..=1.0).contains(&coverage) && bulge_m.is_finite();
    for sphere in spheres.chunks_exact(SPHERE) {
        let mut numbers = [0.0; 4];
        for (number, bytes) in numbers.iter_mut().zip(sphere.chunks_exact(4)) {
            *number = bytes.try_into().map(f32::from_le_bytes).unwrap_or(f32::NAN);
        }
        let [x, y, z, radius] = numbers;
        let center = Vec3::new(x, y, z);
        // Also false for NaN
        let inside = center.cmpge(low).all() && center.cmple(high).all();
        if !(fits && inside && radius > 0.0 && radius <= low.distance(high)) {
            return Err("holds a sphere that is none of the mesh's");
        }
        packing.spheres.push(Sphere { center, radius });
    }
    Ok(packing)
}

fn words(bytes: &[u8; 12]) -> [[u8; 4]; 3] {
    let word = |i: usize| std::array::from_fn(|k| bytes[i * 4 + k]);
    [word(0), word(1), word(2)]
}

/// All of it or nothing: a reader never sees half a file.
fn write(file: &Path, bytes: &[u8]) -> std::io::Result<()> {
    static NEXT: AtomicU32 = AtomicU32::new(0);
    let number = NEXT.fetch_add(1, Ordering::Relaxed);
    let mut name = OsString::from(file.file_name().unwrap_or_default());
    name.push(format!(".{}-{number}.partial", std::process::id()));
    let partial = file.with_file_name(name);
    let written = std::fs::write(&partial, bytes).and_then(|()| std::fs::rename(&partial, file));
    if written.is_err() {
        // It may not be there; there is nothing more to do about it.
        let _ = std::fs::remove_file(&partial);
    }
    written
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A crooked tetrahedron's spheres, in short.
    fn packed() -> [f64; 4] {
        let mesh = Mesh {
            positions: vec![Vec3::ZERO, Vec3::X * 1.3, Vec3::new(0.3, 0.2, 1.1), Vec3::Y * 0.9],
            triangles: vec![[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]],
            ..Mesh::default()
        };
        let desc = PackDesc { spheres: 40, bulge: 0.002 };
        let packing = Solid::new(&mesh).unwrap().pack(&desc).unwrap();
        let sum = |of: fn(&Sphere) -> f32| packing.spheres.iter().map(|s| f64::from(of(s))).sum();
        let places = sum(|s| s.center.dot(Vec3::new(1.0, 2.0, 3.0)) * s.radius);
        [packing.spheres.len() as f64, sum(|s| s.radius), places, packing.coverage.into()]
    }

    #[test]
    fn other_spheres_are_another_version() {
        let found = packed();
        println!("{found:?}");
        let pinned = (2, [40.0, 4.615_676, 8.236_439, 0.746_501]);
        let same = found.iter().zip(pinned.1).all(|(a, b): (&f64, f64)| (a - b).abs() < 1e-4);
        assert!(
            same && VERSION == pinned.0,
            "the packer finds other spheres than version {}: raise VERSION, so that no kept file \
             is taken for what it would find now, and pin {found:?}",
            pinned.0
        );
    }
}
