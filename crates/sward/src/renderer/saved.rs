//! Saved states: a run that is cut in two and goes on, bit for bit.

use super::Renderer;
use super::clock::SavedClock;
use crate::gpu::fingerprint::{fold, of};
use crate::gpu::page::Page;
use crate::gpu::{read, shaders};
use crate::{Error, PhysicsModel};
use bytemuck::{Pod, Zeroable};

/// Changes whenever the bytes mean something else.
const VERSION: u32 = 1;
const MAGIC: [u8; 8] = *b"swardsav";

/// What comes before the pages.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
struct Header {
    magic: [u8; 8],
    version: u32,
    /// 0 sward, 1 paper.
    model: u32,
    /// Of all fields, and of the shaders that move them.
    fields: u64,
    clock: SavedClock,
    page_count: u32,
    reserved: u32,
    /// Of the pages that follow.
    content: u64,
}

const HEADER: usize = size_of::<Header>();

impl Renderer {
    /// The state of the simulation as bytes: how every blade is bent, and since when; with the same
    /// fields added in the same order, [`Renderer::restore_state`] goes on from it as if nothing
    /// had come between. 8 bytes a blade and 48 for 64 of them. Wind, colliders and views are
    /// the host's, and not in it.
    ///
    /// Waits for the device; not for every frame.
    ///
    /// # Errors
    /// [`Error::State`] where the device is lost.
    pub fn save_state(&self, device: &wgpu::Device, queue: &wgpu::Queue) -> Result<Vec<u8>, Error> {
        let mut content = Vec::new();
        for page in &self.pages {
            for buffer in page.state() {
                read::append(device, queue, buffer, &mut content)?;
            }
        }
        let header = Header { content: of(&content), ..self.header() };
        Ok([bytemuck::bytes_of(&header), &content].concat())
    }

    /// Goes on from a saved state. The fields must be those that it was saved with, in that order,
    /// and what was encoded before must have been submitted. What changes on refusal: nothing.
    ///
    /// # Errors
    /// [`Error::State`] for bytes that are damaged, cut short, of another version of the library,
    /// or of other fields.
    pub fn restore_state(&mut self, queue: &wgpu::Queue, saved: &[u8]) -> Result<(), Error> {
        let (header, content) = self.check_state(saved)?;
        let mut rest = content;
        for page in &self.pages {
            for buffer in page.state() {
                let (own, after) = split(rest, buffer.size())?;
                queue.write_buffer(buffer, 0, own);
                rest = after;
            }
        }
        self.clock.restore(header.clock);
        // The lists of what is near each patch are of another time: they are made anew
        self.inputs.make_lists_anew();
        self.model = if header.model == 0 { PhysicsModel::Sward } else { PhysicsModel::Paper };
        Ok(())
    }

    fn header(&self) -> Header {
        Header {
            magic: MAGIC,
            version: VERSION,
            model: u32::from(self.model == PhysicsModel::Paper),
            fields: self
                .pages
                .iter()
                .fold(shaders::fingerprint(), |print, page| fold(print, page.fingerprint)),
            clock: self.clock.saved(),
            page_count: self.pages.len() as u32,
            reserved: 0,
            content: 0,
        }
    }

    fn check_state<'s>(&self, saved: &'s [u8]) -> Result<(Header, &'s [u8]), Error> {
        let (head, content) = split(saved, HEADER as u64)?;
        let header: Header = bytemuck::pod_read_unaligned(head);
        let own = self.header();
        if header.magic != MAGIC {
            return Err(Error::state("is none"));
        }
        if header.version != VERSION {
            let cause = format!("is of version {}, this library reads {VERSION}", header.version);
            return Err(Error::state(cause));
        }
        if header.fields != own.fields || header.page_count != own.page_count {
            return Err(Error::state("is of other fields, or of another release of this library"));
        }
        let expected: u64 = self.pages.iter().flat_map(Page::state).map(wgpu::Buffer::size).sum();
        if (content.len() as u64) < expected {
            return Err(Error::state("is cut short"));
        }
        if content.len() as u64 != expected || header.content != of(content) || header.model > 1 {
            return Err(Error::state("is damaged"));
        }
        if !header.clock.is_sound() {
            return Err(Error::state("is damaged: its time is none"));
        }
        Ok((header, content))
    }
}

fn split(bytes: &[u8], at: u64) -> Result<(&[u8], &[u8]), Error> {
    let at = usize::try_from(at).unwrap_or(usize::MAX);
    bytes.split_at_checked(at).ok_or_else(|| Error::state("is cut short"))
}
