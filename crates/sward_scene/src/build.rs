//! From a scene file to a [`Scene`].

mod colors;
mod fields;
mod forms;
mod inside;
mod pictures;
pub(crate) mod plants;
mod settings;
mod views;
mod wind;

use crate::check::{Key, Problem};
use crate::error::{SceneError, one_line};
use crate::locate::locate;
use crate::objects::{MOST_SHAPES, Placed};
use crate::schema::{FieldFile, SceneFile, Source};
use crate::{Object, Scene, SceneField, assets};
use ron::extensions::Extensions;
use std::path::{Path, PathBuf};

/// Reads a scene file and all that it refers to.
///
/// # Errors
/// [`SceneError`]: one line that names the file, the line or the object, the cause and the remedy.
pub fn load(path: &Path) -> Result<Scene, SceneError> {
    let text = String::from_utf8(assets::read(path)?).map_err(|_| SceneError::Read {
        file: path.into(),
        cause: "is not UTF-8 text; a scene is a RON file".into(),
    })?;
    parse(&text, path)
}

/// Reads a scene from its text. `path` names it in messages, and files are looked up beside it.
///
/// # Errors
/// As [`load`].
pub fn parse(text: &str, path: &Path) -> Result<Scene, SceneError> {
    let options = ron::Options::default()
        .with_default_extension(Extensions::IMPLICIT_SOME)
        .with_default_extension(Extensions::UNWRAP_VARIANT_NEWTYPES);
    let file: SceneFile = options.from_str(text).map_err(|error| syntax(path, &error))?;
    let mut context = Context { path, text, notes: Vec::new() };
    build(&mut context, &file)
}

/// What a scene's parts are built with.
pub(crate) struct Context<'a> {
    path: &'a Path,
    text: &'a str,
    notes: Vec<String>,
}

impl Context<'_> {
    pub(crate) fn resolve(&self, file: &str) -> PathBuf {
        self.path.parent().unwrap_or(Path::new("")).join(file)
    }
    pub(crate) fn note(&mut self, note: String) {
        self.notes.push(note);
    }
    pub(crate) fn error(&self, problem: Problem) -> SceneError {
        SceneError::Value {
            file: self.path.into(),
            at: locate(self.text, &problem.key),
            key: problem.key,
            cause: one_line(&problem.cause),
        }
    }
}

fn syntax(path: &Path, error: &ron::error::SpannedError) -> SceneError {
    use ron::Error::{MissingStructField, NoSuchEnumVariant, NoSuchStructField};
    let list = |words: &[&str]| words.join(", ");
    let cause = match &error.code {
        NoSuchStructField { expected, found, .. } => {
            format!("unknown key '{found}'; known here: {}", list(expected))
        }
        NoSuchEnumVariant { expected, found, .. } => {
            format!("unknown kind '{found}'; known here: {}", list(expected))
        }
        MissingStructField { field, .. } => format!("the key '{field}' is missing"),
        other => one_line(&other.to_string()),
    };
    let at = error.span.start;
    SceneError::Syntax { file: path.into(), line: at.line, column: at.col, cause }
}

fn build(context: &mut Context, file: &SceneFile) -> Result<Scene, SceneError> {
    if file.fields.is_empty() {
        let cause = "the scene grows nothing: write at least `fields: [(on: Terrain(size_m: 60))]`";
        return Err(context.error(Key::name("fields").problem(cause)));
    }
    let (placed, hosts) = place(context, file)?;
    let checked = settings::Settings::check(file).map_err(|problem| context.error(problem))?;
    let cameras =
        views::cameras(file, &placed, &hosts).map_err(|problem| context.error(problem))?;
    let spheres = views::spheres(file, &placed).map_err(|problem| context.error(problem))?;
    let wind = wind::sources(context, file, &placed)?;
    let bodies = crate::bodies::groups(file, &placed).map_err(|problem| context.error(problem))?;
    let mut descs = fields::descriptions(context, file)?;
    for (desc, host) in descs.iter_mut().zip(&hosts) {
        let others = placed.iter().enumerate().filter(|(index, _)| index != host);
        desc.obstacles = others.flat_map(|(_, other)| other.obstacles()).collect();
    }
    colors::set_maps(context, file, &placed, &hosts, &mut descs)?;
    let (objects, surfaces) = finish(context, placed, &hosts, checked.ground.soil)?;
    let fields = scene_fields(context, file, descs, surfaces)?;
    let stem = context.path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    Ok(Scene {
        name: file.name.clone().or(stem).unwrap_or_default(),
        path: context.path.into(),
        objects,
        fields,
        cameras,
        wind,
        spheres,
        bodies,
        light: checked.light,
        sky: checked.sky,
        heavens: checked.heavens,
        tone: checked.tone,
        exposure_ev: checked.exposure_ev,
        fog: checked.fog,
        depth_of_field: checked.depth_of_field,
        gravity: checked.gravity,
        physics: checked.physics,
        technique: checked.technique,
        bands: checked.bands,
        shade: checked.shade,
        culling: checked.culling,
        ground: checked.ground,
        warm_up_s: checked.warm_up_s,
        fps: checked.fps,
        notes: std::mem::take(&mut context.notes),
    })
}

/// The fields, each cut to its part of the surface and with its mix of plants.
fn scene_fields(
    context: &mut Context,
    file: &SceneFile,
    descs: Vec<sward::FieldDesc>,
    surfaces: Surfaces,
) -> Result<Vec<SceneField>, SceneError> {
    let mut fields = Vec::with_capacity(descs.len());
    let described = file.fields.iter().zip(descs).zip(surfaces).enumerate();
    for (index, ((field, mut desc), (object, mut surface))) in described {
        let (name, key) = (field_name(field, index), Key::list("fields", index));
        if let Some(disk) = &field.inside {
            let (part, mask) = inside::cut(surface.mesh(), disk, &key.at("inside"))
                .map_err(|problem| context.error(problem))?;
            surface = self::surface(context, &name, part)?;
            desc.density_map = Some(mask);
        }
        let mix = plants::mix(context, field, &key)?;
        if let Some(mix) = &mix {
            let mixed = plants::mixed(mix, &key).map_err(|problem| context.error(problem))?;
            if let Some(note) = mixed.note {
                context.note(format!("field '{name}': {note}"));
            }
            desc.species = mixed.species;
        }
        fields.push(SceneField { name, object, surface, desc, mix });
    }
    Ok(fields)
}

/// The objects, those that fields bring included, and for each field the index of its object.
fn place(context: &mut Context, file: &SceneFile) -> Result<(Vec<Placed>, Vec<usize>), SceneError> {
    let mut placed = Vec::new();
    let mut shapes = 0;
    for (index, object) in file.objects.iter().enumerate() {
        let carries = |name: &str| {
            file.fields.iter().any(|field| matches!(&field.on, Source::Object(on) if on == name))
        };
        let object = Placed::from_file(context, object, index, &placed, carries)?;
        if placed.iter().any(|other: &Placed| other.name == object.name) {
            let cause = format!("the name '{}' is taken by an object before it", object.name);
            return Err(context.error(Key::list("objects", index).at("name").problem(cause)));
        }
        shapes += object.shapes();
        if shapes > MOST_SHAPES {
            let cause = format!(
                "with the objects before it, {shapes} spheres, capsules and boxes push grass \
                 aside, more than {MOST_SHAPES}; use fewer copies or spheres, or None"
            );
            return Err(context.error(Key::list("objects", index).at("collide").problem(cause)));
        }
        placed.push(object);
    }
    let mut hosts = Vec::new();
    for (index, field) in file.fields.iter().enumerate() {
        hosts.push(host(context, field, index, &mut placed)?);
    }
    Ok((placed, hosts))
}

fn field_name(field: &FieldFile, index: usize) -> String {
    field.name.clone().unwrap_or_else(|| format!("field {index}"))
}

/// Index of the placed object that a field grows on; one of its own where it names none.
fn host(
    context: &mut Context,
    field: &FieldFile,
    index: usize,
    placed: &mut Vec<Placed>,
) -> Result<usize, SceneError> {
    let key = Key::list("fields", index).at("on");
    if let Source::Object(name) = &field.on {
        crate::objects::find(placed, name, &key).map_err(|problem| context.error(problem))?;
        return Ok(placed.iter().position(|object| object.name == *name).unwrap_or(0));
    }
    let name = field.name.clone().unwrap_or_else(|| format!("ground of field {index}"));
    placed.push(Placed::from_source(context, name, &field.on, &key)?);
    Ok(placed.len() - 1)
}

/// For each field its object's index and surface.
type Surfaces = Vec<(usize, sward::Surface)>;

fn finish(
    context: &mut Context,
    placed: Vec<Placed>,
    hosts: &[usize],
    soil: [f32; 3],
) -> Result<(Vec<Object>, Surfaces), SceneError> {
    let (mut objects, mut grown) = (Vec::new(), Vec::new());
    for (index, thing) in placed.into_iter().enumerate() {
        let carries = hosts.contains(&index);
        let name = thing.name.clone();
        let whole = (carries && thing.parts.len() > 1).then(|| thing.merged());
        let first = objects.len();
        for mut object in thing.into_objects(carries, soil) {
            let surface = surface(context, &name, std::mem::take(&mut object.mesh))?;
            object.mesh = surface.mesh().clone();
            object.area_m2 = surface.area_m2();
            object.dropped_triangles = surface.dropped_triangles();
            if carries && whole.is_none() {
                grown.push((index, first, surface));
            }
            objects.push(object);
        }
        // Grass grows over all materials; the whole is there to grow on, its parts to be seen.
        if let Some(whole) = whole {
            let surface = surface(context, &name, whole)?;
            grown.push((index, objects.len(), surface.clone()));
            objects.push(Object {
                name,
                mesh: surface.mesh().clone(),
                base_color: soil,
                roughness: 0.9,
                visible: false,
                carries_grass: true,
                area_m2: surface.area_m2(),
                dropped_triangles: surface.dropped_triangles(),
                texture: None,
                collider: Vec::new(),
                path: None,
            });
        }
    }
    let of = |host: &usize| {
        let found = grown.iter().find(|(index, ..)| index == host);
        found.map(|(_, object, surface)| (*object, surface.clone()))
    };
    let surfaces = hosts.iter().filter_map(of).collect();
    Ok((objects, surfaces))
}

fn surface(context: &Context, name: &str, mesh: sward::Mesh) -> Result<sward::Surface, SceneError> {
    sward::Surface::new(mesh).map_err(|error| {
        let cause = one_line(&error.to_string());
        SceneError::Asset { file: context.path.into(), cause: format!("object '{name}': {cause}") }
    })
}
