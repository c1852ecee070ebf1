//! The bytes behind a glTF file: container, buffers, images and accessors, every offset checked.

use crate::SceneError;
use gltf::accessor::{DataType, Dimensions};
use std::path::Path;

/// Most elements of one accessor: above what a 1 GiB file can hold, below what fills the memory.
const MAX_COUNT: usize = 90_000_000;

/// A file's document and bytes.
pub(crate) struct Data<'a> {
    pub(crate) file: &'a Path,
    pub(crate) buffers: Vec<Vec<u8>>,
}

/// Splits a GLB container into its JSON and its binary chunk; a `.gltf` is all JSON.
pub(crate) fn split(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), String> {
    if !bytes.starts_with(b"glTF") {
        return Ok((bytes, None));
    }
    let word = |at: usize| {
        let word = bytes.get(at..at + 4).and_then(|b| b.try_into().ok());
        word.map(u32::from_le_bytes).ok_or("truncated GLB: export it again")
    };
    if word(4)? != 2 {
        return Err(format!("GLB version {}; only 2 is read: export as glTF 2.0", word(4)?));
    }
    let length = word(8)? as usize;
    if length > bytes.len() {
        let has = bytes.len();
        return Err(format!("truncated GLB: {has} of {length} bytes; copy or export it again"));
    }
    let chunk = |at: usize, kind: &[u8]| -> Result<&[u8], String> {
        let size = word(at)? as usize;
        if bytes.get(at + 4..at + 8) != Some(kind) {
            return Err("broken GLB: a chunk is missing; export it again".into());
        }
        let end = (at + 8).checked_add(size);
        end.and_then(|end| bytes.get(at + 8..end)).ok_or_else(|| "truncated GLB chunk".into())
    };
    let json = chunk(12, b"JSON")?;
    let next = 20 + json.len().next_multiple_of(4);
    let binary = if next < length { Some(chunk(next, b"BIN\0")?) } else { None };
    Ok((json, binary))
}

/// Bytes at a URI: a base64 data URI, or a file beside the glTF.
pub(crate) fn resolve(file: &Path, uri: &str, what: &str) -> Result<Vec<u8>, SceneError> {
    if let Some(data) = uri.strip_prefix("data:") {
        let encoded = data.split_once(";base64,").map(|(_, encoded)| encoded);
        return encoded.and_then(from_base64).ok_or_else(|| {
            SceneError::asset(file, format!("{what}: broken base64 data; export it again"))
        });
    }
    let name = percent_decoded(uri);
    if uri.contains("://") {
        return Err(SceneError::asset(file, format!("{what}: '{uri}' is not a file beside it")));
    }
    let beside = file.parent().unwrap_or(Path::new("")).join(name);
    super::read(&beside).map_err(|error| SceneError::asset(file, format!("{what}: {error}")))
}

fn from_base64(text: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3);
    let (mut bits, mut count) = (0_u32, 0);
    for byte in text.trim_end_matches('=').bytes() {
        let value = match byte {
            b'A'..=b'Z' => byte - b'A',
            b'a'..=b'z' => byte - b'a' + 26,
            b'0'..=b'9' => byte - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            _ => return None,
        };
        bits = (bits << 6) | u32::from(value);
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count) as u8);
        }
    }
    Some(bytes)
}

fn percent_decoded(uri: &str) -> String {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let Some((&first, tail)) = rest.split_first() {
        let code = tail.get(..2).filter(|_| first == b'%');
        let code = code.and_then(|hex| std::str::from_utf8(hex).ok());
        match code.and_then(|hex| u8::from_str_radix(hex, 16).ok()) {
            Some(byte) => {
                bytes.push(byte);
                rest = tail.get(2..).unwrap_or(&[]);
            }
            None => {
                bytes.push(first);
                rest = tail;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Where the elements of an accessor lie.
struct Elements<'a> {
    bytes: &'a [u8],
    stride: usize,
    kind: DataType,
    normalized: bool,
    components: usize,
}

impl Elements<'_> {
    fn component(&self, element: usize, component: usize) -> f64 {
        let size = self.kind.size();
        let at = element * self.stride + component * size;
        let mut raw = [0; 4];
        let bytes = self.bytes.get(at..at + size).unwrap_or(&[]);
        raw.iter_mut().zip(bytes).for_each(|(to, from)| *to = *from);
        let integer = u32::from_le_bytes(raw);
        let (value, most) = match self.kind {
            DataType::I8 => (f64::from(integer as u8 as i8), 127.0),
            DataType::U8 => (f64::from(integer), 255.0),
            DataType::I16 => (f64::from(integer as u16 as i16), 32767.0),
            DataType::U16 => (f64::from(integer), 65535.0),
            DataType::U32 => (f64::from(integer), f64::from(u32::MAX)),
            DataType::F32 => return f64::from(f32::from_bits(integer)),
        };
        if self.normalized { (value / most).max(-1.0) } else { value }
    }
}

impl Data<'_> {
    /// The bytes of a view, from `offset`.
    pub(crate) fn view(&self, view: &gltf::buffer::View, offset: usize) -> Result<&[u8], String> {
        let buffer = self.buffers.get(view.buffer().index()).map_or(&[][..], Vec::as_slice);
        let end = view.offset().checked_add(view.length());
        let bytes = end.and_then(|end| buffer.get(view.offset()..end));
        bytes.and_then(|bytes| bytes.get(offset..)).ok_or_else(|| {
            format!("buffer view {} reaches past its buffer: the file is truncated", view.index())
        })
    }

    /// The elements of an accessor as rows of `N` numbers; components that it lacks are `fill`.
    pub(crate) fn rows<const N: usize>(
        &self,
        accessor: &gltf::Accessor,
        fill: f64,
    ) -> Result<Vec<[f64; N]>, String> {
        let (count, index) = (accessor.count(), accessor.index());
        if count > MAX_COUNT {
            return Err(format!(
                "accessor {index} has {count} elements; at most {MAX_COUNT} are read"
            ));
        }
        let components = match accessor.dimensions() {
            Dimensions::Scalar => 1,
            Dimensions::Vec2 => 2,
            Dimensions::Vec3 => 3,
            Dimensions::Vec4 => 4,
            _ => return Err(format!("accessor {index} holds matrices where vectors are needed")),
        };
        let layout = |bytes, stride, kind| Elements {
            bytes,
            stride,
            kind,
            normalized: accessor.normalized(),
            components,
        };
        let mut rows = Vec::new();
        if let Some(view) = accessor.view() {
            let size = components * accessor.data_type().size();
            let stride = view.stride().unwrap_or(size);
            let bytes = self.view(&view, accessor.offset())?;
            // Before room is made: a small file can ask for gigabytes
            check_extent(bytes, count, stride, size, index)?;
            rows = vec![[fill; N]; count];
            let elements = layout(bytes, stride, accessor.data_type());
            for (i, row) in rows.iter_mut().enumerate() {
                fill_row(row, &elements, i);
            }
        } else {
            rows.resize(count, [0.0; N]);
        }
        if let Some(sparse) = accessor.sparse() {
            let size = components * accessor.data_type().size();
            let values = sparse.values();
            let bytes = self.view(&values.view(), values.offset())?;
            check_extent(bytes, sparse.count(), size, size, index)?;
            let elements = layout(bytes, size, accessor.data_type());
            for (i, place) in self.sparse_places(&sparse, index)?.into_iter().enumerate() {
                let row = rows.get_mut(place).ok_or_else(|| {
                    format!("accessor {index}: sparse index {place} is out of range: {count}")
                })?;
                fill_row(row, &elements, i);
            }
        }
        Ok(rows)
    }

    /// The elements that a sparse accessor replaces.
    fn sparse_places(
        &self,
        sparse: &gltf::accessor::sparse::Sparse,
        index: usize,
    ) -> Result<Vec<usize>, String> {
        use gltf::accessor::sparse::IndexType;
        let indices = sparse.indices();
        let kind = match indices.index_type() {
            IndexType::U8 => DataType::U8,
            IndexType::U16 => DataType::U16,
            IndexType::U32 => DataType::U32,
        };
        let (bytes, stride) = (self.view(&indices.view(), indices.offset())?, kind.size());
        check_extent(bytes, sparse.count(), stride, stride, index)?;
        let places = Elements { bytes, stride, kind, normalized: false, components: 1 };
        Ok((0..sparse.count()).map(|i| places.component(i, 0) as usize).collect())
    }
}

fn fill_row<const N: usize>(row: &mut [f64; N], elements: &Elements, element: usize) {
    for (c, value) in row.iter_mut().enumerate().take(elements.components) {
        *value = elements.component(element, c);
    }
}

fn check_extent(
    bytes: &[u8],
    count: usize,
    stride: usize,
    size: usize,
    index: usize,
) -> Result<(), String> {
    let last = count.saturating_sub(1).checked_mul(stride);
    let end = if count == 0 { Some(0) } else { last.and_then(|last| last.checked_add(size)) };
    match end {
        Some(end) if end <= bytes.len() => Ok(()),
        _ => Err(format!(
            "accessor {index} reaches past its buffer view: the file is truncated or broken"
        )),
    }
}
