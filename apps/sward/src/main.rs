//! The `sward` command.

mod args;
mod commands;
mod input;
mod light;
mod measure;
mod output;
mod progress;
mod states;
mod table;
mod technique;
mod video;

use clap::Parser;
use std::io::Write;
use std::process::ExitCode;

/// Exit code for bad input, and for a machine that cannot do what was asked.
const BAD_INPUT: u8 = 2;

/// Pictures, animations and measurements of grass.
#[derive(Debug, Parser)]
#[command(name = "sward", version, max_term_width = 100, after_help = EXAMPLES)]
struct Cli {
    /// No progress and no summary; only errors and what was asked for
    #[arg(long, short, global = true)]
    quiet: bool,
    #[command(subcommand)]
    command: commands::Command,
}

const EXAMPLES: &str = "\
Examples:
  sward render scenes/meadow.ron -o meadow.png
  sward render scenes/meadow.ron --frames 0..120 -o f/%04d.png
  sward sheet -o lights.png
  sward wind scenes/helicopter.ron -o wind.png
  sward texture poppy -o poppy.png
  sward bench scenes/reference.ron --json bench.json
  sward paper -o paper
  sward quality scenes/reference.ron --json quality.json

WGPU_BACKEND and WGPU_ADAPTER_NAME choose the graphics adapter.";

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) if error.use_stderr() => return fail(&args::one_line(&error)),
        Err(help) => {
            // Nothing is left to do where help cannot be printed.
            let _ = help.print();
            return ExitCode::SUCCESS;
        }
    };
    match commands::run(cli.command, cli.quiet) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) if is_closed_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => match error.downcast_ref::<commands::Exceeded>() {
            Some(exceeded) => fail_check(exceeded),
            None => fail(&format!("{error:#}")),
        },
    }
}

/// A line for each limit that was exceeded, on standard error.
fn fail_check(exceeded: &commands::Exceeded) -> ExitCode {
    for line in &exceeded.0 {
        // Nothing is left to do where standard error is closed.
        let _ = writeln!(std::io::stderr(), "error: {line}");
    }
    ExitCode::FAILURE
}

/// One line on standard error.
fn fail(cause: &str) -> ExitCode {
    let line = cause.split_whitespace().collect::<Vec<_>>().join(" ");
    // Nothing is left to do where standard error is closed.
    let _ = writeln!(std::io::stderr(), "error: {line}");
    ExitCode::from(BAD_INPUT)
}

/// `sward bench ... | head` ends early, and well.
fn is_closed_pipe(error: &anyhow::Error) -> bool {
    error
        .downcast_ref::<std::io::Error>()
        .is_some_and(|error| error.kind() == std::io::ErrorKind::BrokenPipe)
}
