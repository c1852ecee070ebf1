//! Where a field's blades take their colours from.

use super::Context;
use crate::assets::{self, Part, TextureImage};
use crate::check::Key;
use crate::error::SceneError;
use crate::objects::Placed;
use crate::schema::{ColorFile, FieldFile, SceneFile, linear_from_srgb};
use sward::{ColorImage, ColorMap, FieldDesc};

/// Sets each field's map; `hosts` are the indices of the objects that they grow on.
pub(super) fn set_maps(
    context: &Context,
    file: &SceneFile,
    placed: &[Placed],
    hosts: &[usize],
    descs: &mut [FieldDesc],
) -> Result<(), SceneError> {
    for (index, (field, desc)) in file.fields.iter().zip(descs).enumerate() {
        let key = Key::list("fields", index);
        desc.color_map = map(context, field, &placed[hosts[index]], &key)?;
    }
    Ok(())
}

/// The map of a field that grows on `host`.
fn map(
    context: &Context,
    field: &FieldFile,
    host: &Placed,
    key: &Key,
) -> Result<Option<ColorMap>, SceneError> {
    let Some(color) = &field.color else { return Ok(None) };
    let key = key.at("color");
    if field.inside.is_some() && !matches!(color, ColorFile::VertexColor) {
        let cause =
            "`inside` maps its part anew, so that no texture fits it: leave one of them out";
        return Err(context.error(key.problem(cause)));
    }
    match color {
        ColorFile::VertexColor => Ok(Some(ColorMap::VertexColor)),
        ColorFile::Texture(file) => {
            let file = context.resolve(file);
            let image = assets::image::texture(&file, &assets::read(&file)?)?;
            Ok(Some(ColorMap::Texture(linear(&image, [1.0; 3]))))
        }
        ColorFile::Surface => match materials(host) {
            Some(map) => Ok(Some(map)),
            None => {
                let cause = format!(
                    "object '{}' has no colour, texture or vertex colours of its own; give it some",
                    host.name
                );
                Err(context.error(key.problem(cause)))
            }
        },
    }
}

/// The materials of an object's parts, in the order in which they are merged; `None` where a part
/// has none.
fn materials(host: &Placed) -> Option<ColorMap> {
    let images = host.parts.iter().map(material).collect::<Option<Vec<_>>>()?;
    let vertices = |(i, part): (u32, &Part)| std::iter::repeat_n(i, part.mesh.positions.len());
    let of_vertex = (0..).zip(&host.parts).flat_map(vertices).collect();
    Some(ColorMap::Materials { images, of_vertex })
}

fn material(part: &Part) -> Option<ColorImage> {
    let color = part.base_color.unwrap_or([1.0; 3]);
    match &part.texture {
        Some(texture) if !part.mesh.uvs.is_empty() => Some(linear(texture, color)),
        _ if part.base_color.is_none() && part.mesh.colors.is_empty() => None,
        _ => Some(ColorImage { width: 1, height: 1, texels: vec![color] }),
    }
}

/// An image in linear light, times a colour.
fn linear(image: &TextureImage, color: [f32; 3]) -> ColorImage {
    let values: Vec<f32> = (0..=255_u8).map(|v| linear_from_srgb(f32::from(v) / 255.0)).collect();
    let texel = |rgba: &[u8]| {
        let channel = |i: usize| rgba.get(i).map_or(0.0, |v| values[usize::from(*v)] * color[i]);
        [channel(0), channel(1), channel(2)]
    };
    let texels = image.pixels.chunks_exact(4).map(texel).collect();
    ColorImage { width: image.width, height: image.height, texels }
}
