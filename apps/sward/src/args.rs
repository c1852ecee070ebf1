//! Values on the command line.

use std::ops::Range;
use std::str::FromStr;

/// A picture's size, as `1280x720`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Size(pub [u32; 2]);

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let form = || "write it as WIDTHxHEIGHT in pixels, such as 1280x720".to_string();
        let (width, height) = text.split_once(['x', 'X']).ok_or_else(form)?;
        let side = |text: &str| text.trim().parse::<u32>().map_err(|_| form());
        match (side(width)?, side(height)?) {
            (0, _) | (_, 0) => Err("a picture needs at least 1 pixel a side".into()),
            (width, height) => Ok(Self([width, height])),
        }
    }
}

/// Frames from A up to, but without, B, as `A..B`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Frames(pub Range<u32>);

impl FromStr for Frames {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let form = || "write it as A..B, such as 0..120 for frames 0 to 119".to_string();
        let (from, to) = text.split_once("..").ok_or_else(form)?;
        let number = |text: &str| text.trim().parse::<u32>().map_err(|_| form());
        let (from, to) = (number(from)?, number(to)?);
        if to <= from {
            return Err(format!("no frames: {to} must be above {from}, and is not drawn itself"));
        }
        Ok(Self(from..to))
    }
}

/// Frames a second.
pub fn fps(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(fps) if (0.001..=100_000.0).contains(&fps) => Ok(fps),
        _ => Err("frames a second are a number from 0.001 to 100000".into()),
    }
}

/// Places from grassland, 0, to garden, 1, with commas between.
#[derive(Debug, Clone, PartialEq)]
pub struct Gardens(pub Vec<f32>);

impl FromStr for Gardens {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let place = |part: &str| match part.trim().parse::<f32>() {
            Ok(garden) if (0.0..=1.0).contains(&garden) => Ok(garden),
            _ => Err(format!("'{part}' is no number from 0, grassland, to 1, garden")),
        };
        let places: Vec<f32> = text.split(',').map(place).collect::<Result<_, _>>()?;
        if places.len() > 16 {
            return Err(format!("{} places: at most 16 are drawn side by side", places.len()));
        }
        Ok(Self(places))
    }
}

/// Seconds from the scene's start.
pub fn time_s(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(time) if (0.0..=86_400.0).contains(&time) => Ok(time),
        _ => Err("the time is a number of seconds from 0 to 86400".into()),
    }
}

/// An angle.
pub fn degrees(text: &str) -> Result<f32, String> {
    match text.parse::<f32>() {
        Ok(angle) if (-3600.0..=3600.0).contains(&angle) => Ok(angle),
        _ => Err("the angle is a number of degrees from -3600 to 3600".into()),
    }
}

/// clap's message without its usage and hints, in one line, without the leading `error:`.
pub fn one_line(error: &clap::Error) -> String {
    if error.kind() == clap::error::ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        return "no subcommand; try --help".into();
    }
    let text = error.to_string();
    let cause = text.split("\n\nUsage:").next().unwrap_or_default();
    let cause = cause.split("\n\nFor more information").next().unwrap_or_default();
    let cause = cause.strip_prefix("error:").unwrap_or(cause).trim();
    format!("{}; try --help", cause.split_whitespace().collect::<Vec<_>>().join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert_eq!("1280x720".parse(), Ok(Size([1280, 720])));
        for bad in ["", "12", "0x0", "5x0", "-1x5", "axb", "1x2x3", "1.5x2", "99999999999x1"] {
            assert!(bad.parse::<Size>().is_err(), "{bad}");
        }
    }

    #[test]
    fn frames() {
        assert_eq!("3..7".parse(), Ok(Frames(3..7)));
        for bad in ["", "3", "3..3", "7..3", "-1..3", "a..b", "1..=3", "1...3"] {
            assert!(bad.parse::<Frames>().is_err(), "{bad}");
        }
    }

    #[test]
    fn gardens() {
        assert_eq!("0, 0.25,1".parse(), Ok(Gardens(vec![0.0, 0.25, 1.0])));
        for bad in ["", "0,", "1.1", "-0.5", "NaN", "0;1", &"0,".repeat(17)[..33]] {
            assert!(bad.parse::<Gardens>().is_err(), "{bad}");
        }
    }

    #[test]
    fn rates_and_times() {
        assert_eq!(fps("30"), Ok(30.0));
        assert_eq!(time_s("0"), Ok(0.0));
        for bad in ["0", "-30", "NaN", "inf", "x", ""] {
            assert!(fps(bad).is_err(), "{bad}");
        }
        for bad in ["-1", "NaN", "inf", "x", ""] {
            assert!(time_s(bad).is_err(), "{bad}");
        }
    }
}
