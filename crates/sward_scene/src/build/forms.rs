//! What plants are drawn as.

use crate::check::{Key, Problem};
use crate::schema::{FormFile, StripFile};
use sward::{Form, Strip};

pub(super) fn form(form: &FormFile, key: &Key) -> Result<Form, Problem> {
    Ok(match form {
        FormFile::Blade => Form::Blade,
        FormFile::Strip(file) => Form::Strip(strip(file, key)?),
    })
}

fn strip(file: &StripFile, key: &Key) -> Result<Strip, Problem> {
    Ok(Strip {
        fold_deg: key.at("fold_deg").within(file.fold_deg, 0.0, 150.0)?,
        sway: key.at("sway").within(file.sway, 0.0, 1.0)?,
        orange: key.at("orange").within(file.orange, 0.0, 1.0)?,
        few_rings_px: key.at("few_rings_px").above_zero(file.few_rings_px, 1e6)?,
    })
}
