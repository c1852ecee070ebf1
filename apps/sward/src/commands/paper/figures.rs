//! The pictures: which there are, and how each is made. A picture is made by the very command that
//! the page shows beside it, run inside this program.

use crate::progress::Progress;
use anyhow::{Result, anyhow, bail};
use clap::Parser;
use serde::Deserialize;
use std::path::Path;

/// A figure of the page.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Figure {
    /// Its number in the paper, where that is known for certain.
    pub number: Option<u32>,
    /// What it shows, in a few words.
    pub title: String,
    /// What to see in it.
    pub caption: String,
    /// Its pictures, side by side.
    pub pictures: Vec<Picture>,
}

/// One picture of a figure.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Picture {
    /// File name.
    pub file: String,
    /// Under the picture, where a figure has several.
    #[serde(default)]
    pub label: String,
    /// For those who do not see it.
    pub alt: String,
    /// How it is made.
    pub made: Made,
}

/// How a picture is made.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub enum Made {
    /// By this command: subcommand, scene file of the folder, options. Output and size follow.
    By(String),
    /// It cannot be made yet.
    NotBuiltYet,
}

/// What became of a picture.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// It lies in the folder; this command makes it.
    Drawn(String),
    /// Why it does not.
    Missing(String),
}

/// All figures, in the order of the page.
pub fn all() -> Result<Vec<Figure>> {
    ron::from_str(include_str!("figures.ron")).map_err(|e| anyhow!("figures.ron: {e}"))
}

/// Number of pictures.
pub fn count(figures: &[Figure]) -> usize {
    figures.iter().map(|figure| figure.pictures.len()).sum()
}

/// Where pictures come from and go.
#[derive(Debug, Clone, Copy)]
pub struct Folders<'a> {
    pub scenes: &'a Path,
    pub output: &'a Path,
    pub size: [u32; 2],
}

/// Draws all pictures; one list of outcomes a figure.
pub fn draw(figures: &[Figure], folders: Folders, bar: &Progress) -> Vec<Vec<Outcome>> {
    let one = |picture: &Picture| {
        let outcome = draw_one(picture, folders);
        bar.step();
        outcome.unwrap_or_else(|error| Outcome::Missing(format!("{error:#}")))
    };
    figures.iter().map(|figure| figure.pictures.iter().map(one).collect()).collect()
}

fn draw_one(picture: &Picture, folders: Folders) -> Result<Outcome> {
    let Made::By(command) = &picture.made else {
        return Ok(Outcome::Missing("not built yet".into()));
    };
    let Some((subcommand, scene, options)) = parts(command) else {
        bail!("'{command}' names no scene");
    };
    if !folders.scenes.join(scene).is_file() {
        return Ok(Outcome::Missing(format!("there is no {scene} among the scenes")));
    }
    let arguments = |scene: &Path, file: &Path| -> Vec<String> {
        let [width, height] = folders.size;
        let (scene, file) = (scene.display().to_string(), file.display().to_string());
        let head = [subcommand.to_string(), scene];
        let tail = ["--size".into(), format!("{width}x{height}"), "-o".into(), file];
        let options = options.split_whitespace().map(String::from);
        head.into_iter().chain(options).chain(tail).collect()
    };
    let run = arguments(&folders.scenes.join(scene), &folders.output.join(&picture.file));
    let command = parse(&run)?;
    super::super::run(command, true)?;
    let shown = arguments(&Path::new("scenes").join(scene), Path::new(&picture.file));
    Ok(Outcome::Drawn(format!("sward {}", shown.join(" "))))
}

/// Subcommand, scene file and options of a command.
fn parts(command: &str) -> Option<(&str, &str, &str)> {
    let (subcommand, rest) = command.split_once(' ')?;
    let (scene, options) = rest.split_once(' ').unwrap_or((rest, ""));
    Some((subcommand, scene, options))
}

fn parse(arguments: &[String]) -> Result<super::super::Command> {
    let words = std::iter::once("sward").chain(arguments.iter().map(String::as_str));
    match crate::Cli::try_parse_from(words) {
        Ok(cli) => Ok(cli.command),
        Err(error) => bail!("{}", crate::args::one_line(&error)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_figure_is_described_and_every_command_is_one() {
        let figures = all().unwrap();
        let mut files = Vec::new();
        for figure in &figures {
            assert!(!figure.title.is_empty() && figure.caption.ends_with('.'), "{figure:?}");
            assert!(!figure.pictures.is_empty(), "{figure:?}");
            for picture in &figure.pictures {
                assert!(picture.alt.len() > 20 && picture.file.ends_with(".png"), "{picture:?}");
                assert!(figure.pictures.len() == 1 || !picture.label.is_empty(), "{picture:?}");
                files.push(&picture.file);
                if let Made::By(command) = &picture.made {
                    let (subcommand, scene, options) = parts(command).unwrap();
                    let words = [subcommand, scene].into_iter().chain(options.split_whitespace());
                    let words: Vec<_> = words.chain(["-o", "a.png"]).map(String::from).collect();
                    parse(&words).unwrap_or_else(|error| panic!("{command}: {error}"));
                }
            }
        }
        let count = files.len();
        files.sort();
        files.dedup();
        assert_eq!(files.len(), count, "two pictures share a file");
    }

    /// The figures whose content is known, and no other.
    #[test]
    fn numbers_are_claimed_where_they_are_known() {
        let numbers: Vec<_> = all().unwrap().iter().filter_map(|figure| figure.number).collect();
        assert_eq!(numbers, [1, 4, 8, 9, 14, 17]);
    }
}
