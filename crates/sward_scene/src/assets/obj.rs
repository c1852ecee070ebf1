//! Wavefront OBJ: `v` (with colours), `vt`, `vn` and `f` with any number of corners; negative
//! indices count back. Other lines (groups, materials, curves) are passed over. Read here and not by
//! another crate, because an error must name its line.

use crate::SceneError;
use glam::{Vec2, Vec3};
use std::collections::HashMap;
use std::path::Path;
use sward::Mesh;

/// A corner: position, and perhaps texture coordinate and normal, as indices from 0.
type Corner = (usize, Option<usize>, Option<usize>);

#[derive(Default)]
struct Reader {
    positions: Vec<Vec3>,
    colors: Vec<[f32; 4]>,
    uvs: Vec<Vec2>,
    normals: Vec<Vec3>,
    /// Corners of each triangle, with the line of its face.
    triangles: Vec<[Corner; 3]>,
}

/// Reads an OBJ file.
pub(crate) fn parse(file: &Path, bytes: &[u8]) -> Result<Mesh, SceneError> {
    let mut reader = Reader::default();
    let text = String::from_utf8_lossy(bytes);
    let mut joined = String::new();
    for (number, line) in text.lines().enumerate() {
        // A backslash at the end continues the line.
        if let Some(part) = line.trim_end().strip_suffix('\\') {
            joined.push_str(part);
            joined.push(' ');
            continue;
        }
        joined.push_str(line);
        reader
            .line(&joined)
            .map_err(|cause| SceneError::asset(file, format!("line {}: {cause}", number + 1)))?;
        joined.clear();
    }
    Ok(reader.finish())
}

impl Reader {
    fn line(&mut self, line: &str) -> Result<(), String> {
        let line = line.split('#').next().unwrap_or("");
        let mut words = line.split_ascii_whitespace();
        match words.next() {
            Some("v") => self.vertex(&numbers(words)?),
            Some("vt") => match numbers(words)?.as_slice() {
                // OBJ's v runs up from the image's bottom; ours runs down from its top.
                [u, v, ..] => {
                    self.uvs.push(Vec2::new(*u, 1.0 - v));
                    Ok(())
                }
                [u] => {
                    self.uvs.push(Vec2::new(*u, 0.0));
                    Ok(())
                }
                [] => Err("a texture coordinate needs 'vt u v'".into()),
            },
            Some("vn") => match numbers(words)?.as_slice() {
                [x, y, z, ..] => {
                    self.normals.push(Vec3::new(*x, *y, *z));
                    Ok(())
                }
                _ => Err("a normal needs 'vn x y z'".into()),
            },
            Some("f") => self.face(words),
            _ => Ok(()),
        }
    }

    fn vertex(&mut self, numbers: &[f32]) -> Result<(), String> {
        let &[x, y, z, ..] = numbers else {
            return Err("a vertex needs 'v x y z'".into());
        };
        if !(x.is_finite() && y.is_finite() && z.is_finite()) {
            return Err(format!("position {x} {y} {z} is not a finite number"));
        }
        self.positions.push(Vec3::new(x, y, z));
        let color = match numbers {
            [_, _, _, r, g, b, ..] => [*r, *g, *b, 1.0].map(|c| c.clamp(0.0, 1.0)),
            _ => [1.0; 4],
        };
        // Files with colours have them on every vertex; the list is kept only where one has.
        if numbers.len() >= 6 || !self.colors.is_empty() {
            self.colors.resize(self.positions.len() - 1, [1.0; 4]);
            self.colors.push(color);
        }
        Ok(())
    }

    fn face<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> Result<(), String> {
        let corners = words.map(|word| self.corner(word)).collect::<Result<Vec<_>, _>>()?;
        let [first, rest @ ..] = corners.as_slice() else {
            return Err("a face needs at least 3 corners, this has 0".into());
        };
        if rest.len() < 2 {
            return Err(format!("a face needs at least 3 corners, this has {}", corners.len()));
        }
        let pairs = rest.iter().zip(rest.iter().skip(1));
        self.triangles.extend(pairs.map(|(second, third)| [*first, *second, *third]));
        Ok(())
    }

    fn corner(&self, word: &str) -> Result<Corner, String> {
        let mut fields = word.split('/');
        let position = fields.next().unwrap_or("");
        let position = index(position, self.positions.len(), "vertex")?
            .ok_or_else(|| format!("face corner '{word}' names no vertex"))?;
        let uv = index(fields.next().unwrap_or(""), self.uvs.len(), "texture coordinate")?;
        let normal = index(fields.next().unwrap_or(""), self.normals.len(), "normal")?;
        Ok((position, uv, normal))
    }

    /// One vertex for each different corner.
    fn finish(self) -> Mesh {
        let mut mesh = Mesh::default();
        let mut known: HashMap<Corner, u32> = HashMap::new();
        let every = |f: fn(&Corner) -> bool| self.triangles.iter().flatten().all(f);
        let (with_uvs, with_normals) = (every(|c| c.1.is_some()), every(|c| c.2.is_some()));
        for triangle in &self.triangles {
            let indices = triangle.map(|corner| {
                let corner =
                    (corner.0, corner.1.filter(|_| with_uvs), corner.2.filter(|_| with_normals));
                *known.entry(corner).or_insert_with(|| {
                    let get = |i: usize| self.positions.get(i).copied().unwrap_or(Vec3::ZERO);
                    mesh.positions.push(get(corner.0));
                    mesh.uvs.extend(corner.1.and_then(|i| self.uvs.get(i)));
                    mesh.normals.extend(corner.2.and_then(|i| self.normals.get(i)));
                    mesh.colors.extend(self.colors.get(corner.0));
                    (mesh.positions.len() - 1) as u32
                })
            });
            mesh.triangles.push(indices);
        }
        if mesh.colors.len() != mesh.positions.len() {
            mesh.colors.clear();
        }
        if !mesh.uvs.iter().all(|uv| uv.is_finite()) {
            mesh.uvs.clear();
        }
        super::mesh::drop_broken_normals(&mut mesh);
        mesh
    }
}

fn numbers<'a>(words: impl Iterator<Item = &'a str>) -> Result<Vec<f32>, String> {
    words.map(|word| word.parse().map_err(|_| format!("'{word}' is not a number"))).collect()
}

/// An index of the file (from 1, or counted back from the end) as one from 0.
fn index(text: &str, count: usize, of: &str) -> Result<Option<usize>, String> {
    if text.is_empty() {
        return Ok(None);
    }
    let number: i64 = text.parse().map_err(|_| format!("{of} index '{text}' is not a number"))?;
    let from_zero = if number < 0 { count as i64 + number } else { number - 1 };
    match usize::try_from(from_zero) {
        Ok(i) if i < count => Ok(Some(i)),
        _ => Err(format!("{of} index {number} is out of range: {count} so far")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Mesh, String> {
        parse(Path::new("a.obj"), text.as_bytes()).map_err(|e| e.to_string())
    }

    #[test]
    fn faces_of_any_size_shared_corners_and_colours() {
        let mesh = read(
            "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 1\n\
             vt 0 0\nvt 1 0.25\nvn 0 0 1\nf 1/1/1 2/2/1 3/2/1 \\\n -1/1/-1\n",
        )
        .expect("a quad");
        assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(mesh.positions.len(), 4);
        assert_eq!(mesh.uvs[1], Vec2::new(1.0, 0.75));
        assert_eq!(mesh.colors[1], [0.0, 1.0, 0.0, 1.0]);
        assert_eq!(mesh.normals, [Vec3::Z; 4]);
    }

    #[test]
    fn errors_name_the_line() {
        let cases = [
            ("v 0 0", "line 1: a vertex needs"),
            ("v 0 0 0\nv 0 x 0", "line 2: 'x' is not a number"),
            ("v 0 nan 0", "line 1: position"),
            ("v 0 inf 0", "line 1: position"),
            ("v 0 0 0\nf 1 1 2", "line 2: vertex index 2 is out of range: 1 so far"),
            ("v 0 0 0\nf 1 1 -2", "line 2: vertex index -2 is out of range"),
            ("v 0 0 0\nf 0 1 1", "line 2: vertex index 0 is out of range"),
            ("v 0 0 0\nf 1/1 1 1", "line 2: texture coordinate index 1"),
            ("v 0 0 0\nf 1//9 1 1", "line 2: normal index 9"),
            ("v 0 0 0\n\nf 1 1", "line 3: a face needs at least 3 corners, this has 2"),
            ("v 0 0 0\nf /1 1 1", "line 2: face corner '/1' names no vertex"),
        ];
        for (text, expected) in cases {
            let error = read(text).expect_err(text);
            assert!(error.starts_with("a.obj: ") && error.contains(expected), "{text}: {error}");
        }
    }
}
