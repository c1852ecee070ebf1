//! The shipped WGSL, assembled by concatenation: each stage lists the parts that it is made of.

macro_rules! part {
    ($path:literal) => {
        include_str!(concat!("../", $path))
    };
}

const FRAME: &str = part!("shared/frame.wgsl");
const NOISE: &str = part!("shared/noise.wgsl");
const BLADE: &str = part!("shared/blade.wgsl");
const CURVE: &str = part!("shared/curve.wgsl");
const FIELD: &str = part!("shared/field.wgsl");
const STATE: &str = part!("shared/state.wgsl");
const VIEW: &str = part!("shared/view.wgsl");
const BAND: &str = part!("shared/band.wgsl");
const WORK: &str = part!("shared/work.wgsl");
const DRAWS: &str = part!("shared/draws.wgsl");
const DEPTH_SINGLE: &str = part!("shared/depth_single.wgsl");
const DEPTH_MULTISAMPLED: &str = part!("shared/depth_multisampled.wgsl");
const WIND: &str = part!("frame/wind/wind.wgsl");
const PRIMITIVE: &str = part!("frame/collide/primitive.wgsl");
const NEAR: &str = part!("frame/collide/near.wgsl");
const CUBOID: &str = part!("frame/collide/cuboid.wgsl");
const WIND_TEXTURED: &str = part!("frame/wind/textured.wgsl");
const WIND_PLACED: &str = part!("frame/wind/placed.wgsl");
const CONTACT: &str = part!("frame/collide/contact.wgsl");
const COLLIDE: &str = part!("frame/collide/collide.wgsl");
const PHYSICS: &str = part!("frame/physics/physics.wgsl");
const PAPER: &str = part!("frame/physics/paper.wgsl");
const TESTS: &str = part!("frame/cull/tests.wgsl");
const PATCH: &str = part!("frame/cull/patch.wgsl");
const BLOCKS: &str = part!("frame/cull/blocks.wgsl");
const CULL: &str = part!("frame/cull/cull.wgsl");
const LEVEL: &str = part!("frame/level/level.wgsl");
const FORM: &str = part!("frame/level/form.wgsl");
const ENOUGH: &str = part!("frame/level/enough.wgsl");
const CONTINUUM: &str = part!("frame/level/continuum.wgsl");
const STRIPS: &str = part!("frame/level/strips.wgsl");
const BANDS: &str = part!("frame/level/bands.wgsl");
const DECIDE: &str = part!("frame/update/decide.wgsl");
const EXPLAIN: &str = part!("frame/debug/explain.wgsl");
const DEBUG_COLORS: &str = part!("frame/debug/colors.wgsl");
const DEBUG_CLUSTER: &str = part!("frame/debug/cluster.wgsl");
const DEBUG_CARDS: &str = part!("frame/debug/cards.wgsl");
const DEBUG_BILLBOARD: &str = part!("frame/debug/billboard.wgsl");
const DEBUG_STRIP: &str = part!("frame/debug/strip.wgsl");
const DEBUG_MODEL: &str = part!("frame/debug/model.wgsl");
const DEBUG: &str = part!("frame/debug/debug.wgsl");
const TASK: &str = part!("frame/update/task.wgsl");
const UPDATE: &str = part!("frame/update/update.wgsl");
const SCAN: &str = part!("frame/compact/scan.wgsl");
const COMPACT: &str = part!("frame/compact/compact.wgsl");
const LIGHT: &str = part!("frame/light/light.wgsl");
const SHADE: &str = part!("frame/light/shade.wgsl");
const SUNLIGHT: &str = part!("frame/light/sunlight.wgsl");
const CANOPY: &str = part!("frame/light/canopy.wgsl");
const CANOPY_LIGHT: &str = part!("frame/light/canopy_light.wgsl");
const END: &str = part!("frame/light/end.wgsl");
const PATCH_LIGHT: &str = part!("frame/light/patch_light.wgsl");
const THIN: &str = part!("frame/draw/thin.wgsl");
const CARDS: &str = part!("frame/draw/cards.wgsl");
const CLUSTER: &str = part!("frame/draw/cluster.wgsl");
const PLANT: &str = part!("frame/draw/plant.wgsl");
const PICTURES: &str = part!("frame/draw/pictures.wgsl");
const QUADS: &str = part!("frame/draw/quads.wgsl");
const STRIP_LOOK: &str = part!("frame/draw/strip_look.wgsl");
const STRIP_SHAPE: &str = part!("frame/draw/strip_shape.wgsl");
const STRIP: &str = part!("frame/draw/strip.wgsl");
const BILLBOARD: &str = part!("frame/draw/billboard.wgsl");
const OUTLINE: &str = part!("frame/draw/outline.wgsl");
const LOBES: &str = part!("frame/draw/lobes.wgsl");
const LOBED: &str = part!("frame/draw/lobed.wgsl");
const BLADE_POINT: &str = part!("frame/draw/blade_point.wgsl");
const DRAW: &str = part!("frame/draw/draw.wgsl");
const SWEEP: &str = part!("frame/sweep/sweep.wgsl");
const SWEEP_COLUMNS: &str = part!("frame/sweep/columns.wgsl");
const SWEEP_TERRAIN: &str = part!("frame/sweep/terrain.wgsl");
const LOOK: &str = part!("frame/draw/look.wgsl");
const MODEL: &str = part!("frame/draw/model.wgsl");

/// One shader module of the library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shader {
    /// Colliders near each patch.
    Collide,
    /// Patches that a view sees.
    Cull,
    /// Physics, blade tests and level, reading a single-sampled depth.
    Update,
    /// The same, reading a multisampled depth.
    UpdateMultisampled,
    /// The mean light of patches.
    PatchLight,
    /// Prefix sums.
    Scan,
    /// The draw list.
    Compact,
    /// Blades.
    Draw,
    /// Blades with lobes.
    DrawLobed,
    /// Clusters.
    DrawCluster,
    /// Modelled plants.
    DrawModel,
    /// Plants as quads.
    DrawBillboard,
    /// Plants as strips.
    DrawStrip,
    /// Why each blade is drawn or not, reading a single-sampled depth.
    Explain,
    /// The same, reading a multisampled depth.
    ExplainMultisampled,
    /// Blades as a debug view shows them.
    DrawDebug,
    /// Clusters likewise.
    DrawDebugCluster,
    /// Plants as quads likewise.
    DrawDebugBillboard,
    /// Strips likewise.
    DrawDebugStrip,
    /// Modelled plants likewise.
    DrawDebugModel,
    /// Rows of cells that a view may see.
    SweepColumns,
    /// Cells and triangles of a terrain that a view may see.
    SweepTerrain,
}

impl Shader {
    /// Every module.
    pub const ALL: [Self; 22] = [
        Self::Collide,
        Self::Cull,
        Self::Update,
        Self::UpdateMultisampled,
        Self::PatchLight,
        Self::Scan,
        Self::Compact,
        Self::Draw,
        Self::DrawLobed,
        Self::DrawCluster,
        Self::DrawModel,
        Self::DrawBillboard,
        Self::DrawStrip,
        Self::Explain,
        Self::ExplainMultisampled,
        Self::DrawDebug,
        Self::DrawDebugCluster,
        Self::DrawDebugBillboard,
        Self::DrawDebugStrip,
        Self::DrawDebugModel,
        Self::SweepColumns,
        Self::SweepTerrain,
    ];

    /// Label in debuggers: `sward.` and the stage's stem.
    pub fn label(self) -> &'static str {
        match self {
            Self::Collide => "sward.collide",
            Self::Cull => "sward.cull",
            Self::Update | Self::UpdateMultisampled => "sward.update",
            Self::PatchLight => "sward.patch_light",
            Self::Scan => "sward.scan",
            Self::Compact => "sward.compact",
            Self::Draw
            | Self::DrawLobed
            | Self::DrawCluster
            | Self::DrawModel
            | Self::DrawBillboard
            | Self::DrawStrip => "sward.draw",
            Self::Explain | Self::ExplainMultisampled => "sward.explain",
            Self::DrawDebug
            | Self::DrawDebugCluster
            | Self::DrawDebugBillboard
            | Self::DrawDebugStrip
            | Self::DrawDebugModel => "sward.debug",
            Self::SweepColumns | Self::SweepTerrain => "sward.sweep",
        }
    }

    fn parts(self) -> Vec<&'static str> {
        let light = [SHADE, SUNLIGHT, LIGHT];
        let thin = [CANOPY, PLANT, THIN];
        let blade = [
            &[STATE, DRAWS, VIEW, LEVEL][..],
            &light,
            &thin,
            &[ENOUGH, OUTLINE, BLADE_POINT, DRAW],
        ];
        let draw = blade.concat();
        let level = [LEVEL, END, FORM, ENOUGH, CONTINUUM, STRIP_LOOK, STRIPS, BANDS];
        let plant =
            [&[STATE, BAND, DRAWS, VIEW, LEVEL, FORM, BANDS][..], &light, &[PLANT, PICTURES]];
        let plant = plant.concat();
        let (billboard, model) = ([LOOK, QUADS, BILLBOARD], [LOOK, MODEL]);
        let strip = [STRIP_LOOK, STRIP_SHAPE, STRIP];
        let cards = [DEBUG_COLORS, DEBUG_CARDS];
        let cluster =
            [&[STATE, BAND, DRAWS, VIEW][..], &level, &light, &thin, &[PICTURES, CARDS, CLUSTER]];
        let cluster = cluster.concat();
        let collide = [PRIMITIVE, NEAR, CUBOID, CONTACT];
        let motion = [STATE, BAND, VIEW, WIND, WIND_PLACED, WIND_TEXTURED, PHYSICS, PAPER];
        let update = [&motion[..], &level, &[TESTS, WORK, TASK, DECIDE, UPDATE]].concat();
        let explain = [&[STATE, BAND, VIEW][..], &level, &[TESTS, DECIDE, PATCH, EXPLAIN]].concat();
        let rest: &[&[&str]] = match self {
            Self::Collide => &[&[BAND, WORK, PRIMITIVE, COLLIDE]],
            Self::Cull => &[&[BAND, WORK, VIEW], &level, &[PATCH, BLOCKS, CULL]],
            Self::Update => &[&[DEPTH_SINGLE], &collide, &update],
            Self::UpdateMultisampled => &[&[DEPTH_MULTISAMPLED], &collide, &update],
            Self::PatchLight => &[
                &[BAND, VIEW],
                &level,
                &light,
                &[CANOPY, CANOPY_LIGHT, PATCH, BLOCKS, PATCH_LIGHT],
            ],
            Self::Scan => &[&[BAND, DRAWS, VIEW, BLOCKS, SCAN]],
            Self::Compact => &[&[BAND, WORK, TASK, VIEW, COMPACT]],
            Self::Draw => &[&draw],
            Self::DrawLobed => &[&draw, &[LOBES, LOBED]],
            Self::DrawBillboard => &[&plant, &billboard],
            Self::DrawModel => &[&plant, &model],
            Self::DrawStrip => &[&plant, &strip],
            Self::Explain => &[&[DEPTH_SINGLE], &explain],
            Self::ExplainMultisampled => &[&[DEPTH_MULTISAMPLED], &explain],
            Self::DrawDebug => &[&draw, &[LOBES, LOBED, DEBUG_COLORS, DEBUG]],
            Self::DrawCluster => &[&cluster],
            Self::DrawDebugCluster => &[&cluster, &[DEBUG_COLORS, DEBUG_CLUSTER]],
            Self::DrawDebugBillboard => &[&plant, &billboard, &cards, &[DEBUG_BILLBOARD]],
            Self::DrawDebugStrip => &[&plant, &strip, &cards, &[DEBUG_STRIP]],
            Self::DrawDebugModel => &[&plant, &model, &cards, &[DEBUG_MODEL]],
            // These know the ground and a view, and no field
            Self::SweepColumns => return vec![VIEW, SWEEP, SWEEP_COLUMNS],
            Self::SweepTerrain => return vec![VIEW, SWEEP, SWEEP_TERRAIN],
        };
        let field = [FRAME, NOISE, BLADE, CURVE, FIELD];
        [&field[..], &rest.concat()].concat()
    }

    /// The whole source.
    pub fn source(self) -> String {
        self.parts().concat()
    }

    /// Compiles the module.
    pub fn module(self, device: &wgpu::Device) -> wgpu::ShaderModule {
        device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(self.label()),
            source: wgpu::ShaderSource::Wgsl(self.source().into()),
        })
    }
}

/// Stands for all source: what one release of the shaders saved, another does not go on from.
pub fn fingerprint() -> u64 {
    let of = |shader: &Shader| super::fingerprint::of(shader.source().as_bytes());
    Shader::ALL.iter().map(of).fold(0, super::fingerprint::fold)
}

#[cfg(test)]
mod tests {
    use super::Shader;
    use naga::valid::{Capabilities, ValidationFlags, Validator};

    #[test]
    fn every_shader_is_valid() {
        for shader in Shader::ALL {
            let source = shader.source();
            let module = naga::front::wgsl::parse_str(&source)
                .unwrap_or_else(|e| panic!("{shader:?}: {}", e.emit_to_string(&source)));
            Validator::new(ValidationFlags::all(), Capabilities::default())
                .validate(&module)
                .unwrap_or_else(|e| panic!("{shader:?}: {}", e.emit_to_string(&source)));
        }
    }
}
