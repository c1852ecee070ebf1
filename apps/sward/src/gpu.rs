//! A device without a window.

use anyhow::{Context, Result, anyhow, bail};
use std::sync::{Arc, Mutex, PoisonError};

/// Format of the colour that everything is drawn to, in linear light.
pub const COLOR_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
/// Format of the depth.
pub const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

const NO_ADAPTER: &str = "no Vulkan/Metal/DX12 adapter found; on Debian or Ubuntu: apt-get install \
                          mesa-vulkan-drivers";

/// An adapter with its device and queue.
#[derive(Debug, Clone)]
pub struct Gpu {
    /// The adapter.
    pub adapter: wgpu::Adapter,
    /// The device, with default limits only.
    pub device: wgpu::Device,
    /// Its queue.
    pub queue: wgpu::Queue,
    errors: Arc<Mutex<Option<String>>>,
}

impl Gpu {
    /// Opens an adapter: `WGPU_BACKEND`, `WGPU_ADAPTER_NAME` and `WGPU_POWER_PREF` choose; without
    /// them the fastest one.
    ///
    /// # Errors
    /// Where there is no adapter (the message says what to install), none of the name asked for, or
    /// it lacks the default limits.
    pub fn headless() -> Result<Self> {
        pollster::block_on(Self::open())
    }

    async fn open() -> Result<Self> {
        let descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
        let adapter = adapter(&wgpu::Instance::new(descriptor)).await?;
        // Sample counts other than 1 and 4 are not in WebGPU: they need this feature.
        let optional = wgpu::Features::TEXTURE_ADAPTER_SPECIFIC_FORMAT_FEATURES;
        let (device, queue) = adapter
            .request_device(&wgpu::DeviceDescriptor {
                label: Some("sward"),
                required_features: adapter.features() & optional,
                required_limits: wgpu::Limits::defaults(),
                ..Default::default()
            })
            .await
            .with_context(|| {
                format!("adapter '{}' cannot give WebGPU's default limits", adapter.get_info().name)
            })?;
        let errors = Arc::new(Mutex::new(None));
        let slot = errors.clone();
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            let text = error.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
            // The first error is the cause; later ones only follow from it.
            slot.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(text);
        }));
        Ok(Self { adapter, device, queue, errors })
    }

    /// Sample counts that both targets can have.
    pub fn sample_counts(&self) -> Vec<u32> {
        let special = wgpu::Features::TEXTURE_ADAPTER_SPECIFIC_FORMAT_FEATURES;
        let free = self.device.features().contains(special);
        let flags = |format| self.adapter.get_texture_format_features(format).flags;
        let (color, depth) = (flags(COLOR_FORMAT), flags(DEPTH_FORMAT));
        [1, 2, 4, 8, 16]
            .into_iter()
            .filter(|&n| free || n == 1 || n == 4)
            .filter(|&n| color.sample_count_supported(n) && depth.sample_count_supported(n))
            .collect()
    }

    /// The sample count to use: the one asked for, else 4 where there is 4, else 1.
    ///
    /// # Errors
    /// Where the adapter has not what was asked for; the message lists what works.
    pub fn choose_samples(&self, asked: Option<u32>) -> Result<u32> {
        let counts = self.sample_counts();
        match asked {
            None => Ok(if counts.contains(&4) { 4 } else { 1 }),
            Some(samples) if counts.contains(&samples) => Ok(samples),
            Some(samples) => bail!(
                "--samples {samples}: this adapter has {}",
                counts.iter().map(u32::to_string).collect::<Vec<_>>().join(", ")
            ),
        }
    }

    /// Checks that a picture fits the device.
    ///
    /// # Errors
    /// Where it does not; the message names the limit.
    pub fn check_size(&self, [width, height]: [u32; 2]) -> Result<()> {
        let most = self.device.limits().max_texture_dimension_2d;
        if width > most || height > most {
            bail!("--size {width}x{height}: at most {most} a side (max_texture_dimension_2d)");
        }
        Ok(())
    }

    /// Waits until the device has done all that was submitted.
    ///
    /// # Errors
    /// Where the device is lost, or reported an error since the last call.
    pub fn wait(&self) -> Result<()> {
        self.device.poll(wgpu::PollType::wait_indefinitely()).context("the device stopped")?;
        match self.errors.lock().unwrap_or_else(PoisonError::into_inner).take() {
            Some(error) => Err(anyhow!("the graphics device reported: {error}")),
            None => Ok(()),
        }
    }
}

async fn adapter(instance: &wgpu::Instance) -> Result<wgpu::Adapter> {
    if let Ok(name) = std::env::var("WGPU_ADAPTER_NAME") {
        return named_adapter(instance, &name).await;
    }
    let options = wgpu::RequestAdapterOptions {
        power_preference: wgpu::PowerPreference::from_env()
            .unwrap_or(wgpu::PowerPreference::HighPerformance),
        ..Default::default()
    };
    // wgpu's own account is long, of many lines, and holds no remedy.
    instance.request_adapter(&options).await.map_err(|_| anyhow!("{}", no_adapter()))
}

async fn named_adapter(instance: &wgpu::Instance, name: &str) -> Result<wgpu::Adapter> {
    let adapters = instance.enumerate_adapters(wgpu::Backends::all()).await;
    if adapters.is_empty() {
        bail!("{}", no_adapter());
    }
    let names: Vec<_> = adapters.iter().map(|adapter| adapter.get_info().name).collect();
    let wanted = name.to_lowercase();
    adapters
        .into_iter()
        .find(|adapter| adapter.get_info().name.to_lowercase().contains(&wanted))
        .ok_or_else(|| {
            anyhow!("WGPU_ADAPTER_NAME={name}: no such adapter; there are: {}", names.join(", "))
        })
}

fn no_adapter() -> String {
    match std::env::var("WGPU_BACKEND") {
        Ok(backend) => format!("{NO_ADAPTER} (WGPU_BACKEND={backend} is set: it may rule it out)"),
        Err(_) => NO_ADAPTER.into(),
    }
}
