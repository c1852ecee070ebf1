//! Pictures of plants.

use super::Context;
use crate::assets;
use crate::error::SceneError;
use crate::schema::PictureFile;
use std::path::Path;
use sward::Picture;

/// A picture and its normals. One without a transparent pixel is told: it would be drawn as a whole
/// square.
pub(super) fn picture(context: &mut Context, file: &PictureFile) -> Result<Picture, SceneError> {
    let path = context.resolve(&file.color);
    let (size, rgba) = read(&path)?;
    if rgba.iter().skip(3).step_by(4).all(|alpha| *alpha == 255) {
        let shown = path.display();
        context.note(format!(
            "{shown}: has no transparent pixel, so that the whole square is drawn; cut the plant out"
        ));
    }
    let picture = Picture::new(size, rgba).map_err(|error| refused(&path, &error))?;
    let Some(normal) = &file.normal else { return Ok(picture) };
    let path = context.resolve(normal);
    let (size, rgba) = read(&path)?;
    picture.with_normals(size, rgba).map_err(|error| refused(&path, &error))
}

fn read(path: &Path) -> Result<([u32; 2], Vec<u8>), SceneError> {
    let image = assets::image::picture(path, &assets::read(path)?)?;
    Ok(([image.width, image.height], image.pixels))
}

fn refused(path: &Path, error: &sward::Error) -> SceneError {
    match error {
        sward::Error::Setting { cause, .. } => SceneError::asset(path, cause.as_str()),
        other => SceneError::asset(path, other.to_string()),
    }
}
