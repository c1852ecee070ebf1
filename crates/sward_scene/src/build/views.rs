//! Cameras and spheres.

use crate::check::{Key, MAX_M, Problem};
use crate::objects::{Placed, find};
use crate::schema::{CameraFile, SceneFile, SphereFile};
use crate::{Camera, MovingSphere, Path, motion};
use glam::{Vec3, Vec3Swizzles};

pub(super) fn cameras(
    file: &SceneFile,
    placed: &[Placed],
    hosts: &[usize],
) -> Result<Vec<Camera>, Problem> {
    let mut cameras = Vec::with_capacity(file.cameras.len().max(1));
    for (index, camera) in file.cameras.iter().enumerate() {
        let key = Key::list("cameras", index);
        let camera = self::camera(camera, index, &key, placed)?;
        if cameras.iter().any(|other: &Camera| other.name == camera.name) {
            let cause = format!("the name '{}' is taken by a camera before it", camera.name);
            return Err(key.at("name").problem(cause));
        }
        cameras.push(camera);
    }
    if cameras.is_empty() {
        let host = hosts.first().and_then(|&host| placed.get(host));
        cameras.extend(host.map(framing));
    }
    Ok(cameras)
}

fn camera(
    file: &CameraFile,
    index: usize,
    key: &Key,
    placed: &[Placed],
) -> Result<Camera, Problem> {
    let mut eye = key.at("eye").vector(file.eye)?;
    let mut target = key.at("target").vector(file.target)?;
    if let Some(name) = &file.above {
        let ground = find(placed, name, &key.at("above"))?.ground();
        eye.y += ground.height(eye.xz()).ok_or_else(|| {
            key.at("eye").problem(format!("{eye} is not above the object '{name}'"))
        })?;
        // What one looks at may lie beyond the ground's rim.
        target.y += ground.height(target.xz()).unwrap_or((ground.min.y + ground.max.y) / 2.0);
    }
    let up = Vec3::from(key.at("up").direction(file.up)?).normalize_or(Vec3::Y);
    let Some(ahead) = (target - eye).try_normalize() else {
        return Err(key.at("target").problem("is where the eye is: move one of them"));
    };
    if ahead.cross(up).length() < 1e-3 {
        return Err(key.at("up").problem("is along the line of sight: choose another"));
    }
    let near_m = key.at("near_m").above_zero(file.near_m, MAX_M)?;
    let far_m = key.at("far_m").within(file.far_m, 0.0, 10.0 * MAX_M)?;
    if far_m <= near_m {
        return Err(key.at("far_m").problem(format!("{far_m} must be above near_m, {near_m}")));
    }
    Ok(Camera {
        name: file.name.clone().unwrap_or_else(|| format!("camera {index}")),
        eye,
        target,
        up,
        vertical_fov_deg: key.at("vertical_fov_deg").within(file.vertical_fov_deg, 1.0, 170.0)?,
        near_m,
        far_m,
    })
}

/// A camera for a scene that gives none: on flat ground a man's height above its near part, looking
/// across; else at a distance from which the whole object is seen.
fn framing(host: &Placed) -> Camera {
    let ground = host.ground();
    let (center, extent) = ((ground.min + ground.max) / 2.0, ground.max - ground.min);
    let radius = (extent.length() / 2.0).max(1e-3);
    let flat = extent.y < 0.3 * extent.x.min(extent.z);
    let standing = center + Vec3::Z * extent.z * 0.35;
    let height = ground.height(standing.xz()).filter(|_| flat && extent.x > 8.0);
    let (eye, target) = match height {
        Some(height) => {
            let across = center - Vec3::Z * extent.z * 0.15;
            let floor = ground.height(across.xz()).unwrap_or(center.y);
            (standing.with_y(height + 1.7), across.with_y(floor + 0.5))
        }
        None => (center + Vec3::new(0.45, 0.4, 1.0).normalize() * radius * 2.6, center),
    };
    Camera {
        name: "default".into(),
        eye,
        target,
        up: Vec3::Y,
        vertical_fov_deg: 50.0,
        near_m: (radius * 0.01).clamp(1e-3, 0.1),
        far_m: radius * 10.0,
    }
}

pub(super) fn spheres(file: &SceneFile, placed: &[Placed]) -> Result<Vec<MovingSphere>, Problem> {
    let spheres = file.spheres.iter().enumerate();
    spheres.map(|(index, sphere)| self::sphere(sphere, index, placed)).collect()
}

fn sphere(file: &SphereFile, index: usize, placed: &[Placed]) -> Result<MovingSphere, Problem> {
    let key = Key::list("spheres", index);
    let radius = key.at("radius_m").above_zero(file.radius_m, MAX_M)?;
    let mut path = match &file.path {
        Some(path) => Path::from_file(path, &key.at("path"))?,
        None => Path::still(key.at("at").vector(file.at)?),
    };
    if let Some(name) = &file.above {
        let ground = find(placed, name, &key.at("above"))?.ground();
        let followed = motion::along_ground(&path, ground, radius, &key.at("path"))?;
        path = motion::rolling(&followed, &path, ground, radius);
    }
    let stripes = file.stripe_color.map(|color| key.at("stripe_color").color(color));
    Ok(MovingSphere {
        name: file.name.clone().unwrap_or_else(|| format!("sphere {index}")),
        radius,
        path,
        visible: file.visible,
        base_color: key.at("base_color").color(file.base_color)?,
        stripe_color: stripes.transpose()?,
        roughness: key.at("roughness").within(file.roughness, 0.0, 1.0)?,
    })
}
