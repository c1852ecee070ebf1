//! What plants are drawn as.

use super::{Context, pictures};
use crate::check::{Key, Problem};
use crate::error::SceneError;
use crate::schema::{FormFile, SpeciesFile, StripFile};
use std::sync::Arc;
use sward::{Form, Species, Strip};

pub(super) fn form(form: &FormFile, key: &Key) -> Result<Form, Problem> {
    Ok(match form {
        FormFile::Blade => Form::Blade,
        FormFile::Strip(file) => Form::Strip(strip(file, key)?),
    })
}

/// Reads the pictures of the species' strips.
pub(super) fn read_textures(
    context: &mut Context,
    files: &[SpeciesFile],
    species: &mut [Species],
) -> Result<(), SceneError> {
    for (file, species) in files.iter().zip(species) {
        if let (FormFile::Strip(file), Form::Strip(strip)) = (&file.form, &mut species.form)
            && let Some(texture) = &file.texture
        {
            strip.texture = Some(Arc::new(pictures::picture(context, texture)?));
        }
    }
    Ok(())
}

fn strip(file: &StripFile, key: &Key) -> Result<Strip, Problem> {
    Ok(Strip {
        fold_deg: key.at("fold_deg").within(file.fold_deg, 0.0, 150.0)?,
        sway: key.at("sway").within(file.sway, 0.0, 1.0)?,
        orange: key.at("orange").within(file.orange, 0.0, 1.0)?,
        few_rings_px: key.at("few_rings_px").above_zero(file.few_rings_px, 1e6)?,
        texture: None,
    })
}
