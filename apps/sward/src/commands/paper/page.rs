//! The index page, as HTML and as Markdown.

use super::figures::{Figure, Outcome, Picture};
use super::grid::escape;
use super::tables::Results;

const STYLE: &str = "\
:root { color-scheme: light dark; }
body { font: 17px/1.5 system-ui, sans-serif; max-width: 70rem; margin: 2rem auto; padding: 0 1rem; }
table { border-collapse: collapse; font-size: 0.9em; display: block; overflow-x: auto; }
th, td { border-bottom: 1px solid #8886; padding: 0.25em 0.8em; text-align: right; }
th:first-child, td:first-child { text-align: left; }
figure { margin: 2.5rem 0; }
figure h3, .row p { margin: 0 0 0.4em; }
.row { display: flex; flex-wrap: wrap; gap: 1rem; }
.row > div { flex: 1 1 24rem; min-width: 0; }
img { max-width: 100%; height: auto; display: block; }
pre { white-space: pre-wrap; overflow-wrap: anywhere; background: #8882; padding: 0.4em 0.8em;
  font-size: 0.85em; }
.missing { border: 1px dashed #888; padding: 2rem 1rem; text-align: center; }
";

const ABOUT: &str = "The evaluation of Jahrmann and Wimmer's \"Responsive Real-Time Grass Rendering \
for General 3D Scenes\" (I3D 2017), run again with sward by one command, sward paper. Figures that \
bear a number show what the paper's figure of that number shows. The others show a part of the paper \
each and bear its name: which numbers they have in print was not at hand. All pictures and captions \
are sward's own.";

/// Figures with what became of their pictures.
pub struct Page<'a> {
    pub results: &'a Results,
    pub figures: &'a [Figure],
    pub outcomes: &'a [Vec<Outcome>],
}

fn heading(figure: &Figure) -> String {
    match figure.number {
        Some(number) => format!("Figure {number}. {}", figure.title),
        None => figure.title.clone(),
    }
}

impl Page<'_> {
    fn figures(&self) -> impl Iterator<Item = (&Figure, Vec<(&Picture, &Outcome)>)> {
        self.figures
            .iter()
            .zip(self.outcomes)
            .map(|(figure, outcomes)| (figure, figure.pictures.iter().zip(outcomes).collect()))
    }

    /// `index.html`.
    pub fn html(&self) -> String {
        let mut body =
            format!("<h1>sward: the paper's evaluation</h1>\n<p>{}</p>\n", escape(ABOUT));
        body += "<p>The same as text: <a href=\"index.md\">index.md</a>. The numbers: \
                 <a href=\"tables.md\">tables.md</a>, <a href=\"tables.json\">tables.json</a>.</p>\n";
        body += "<h2>Figures</h2>\n";
        for (figure, pictures) in self.figures() {
            body +=
                &format!("<figure>\n<h3>{}</h3>\n<div class=\"row\">\n", escape(&heading(figure)));
            for (picture, outcome) in pictures {
                body += &html_picture(picture, outcome);
            }
            let caption = escape(&figure.caption);
            body += &format!("</div>\n<figcaption>{caption}</figcaption>\n</figure>\n");
        }
        body += &format!("<h2>Tables</h2>\n<p>{}</p>\n", escape(&self.results.published.paper));
        for line in self.results.circumstances() {
            body += &format!("<p>{}</p>\n", escape(&line));
        }
        for grid in self.results.grids() {
            body += &grid.html();
        }
        body += "<h3>Sources of the paper's columns</h3>\n<ul>\n";
        for line in self.results.sources() {
            body += &format!("<li>{}</li>\n", escape(&line));
        }
        body += "</ul>\n";
        format!(
            "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>sward: the paper's evaluation</title>\n<style>\n{STYLE}</style>\n</head>\n\
             <body>\n{body}</body>\n</html>\n"
        )
    }

    /// `index.md`.
    pub fn markdown(&self) -> String {
        let mut text = format!("# sward: the paper's evaluation\n\n{ABOUT}\n\n");
        text += "The same with layout: [index.html](index.html). The numbers: \
                 [tables.md](tables.md), [tables.json](tables.json).\n\n## Figures\n";
        for (figure, pictures) in self.figures() {
            text += &format!("\n### {}\n\n{}\n", heading(figure), figure.caption);
            for (picture, outcome) in pictures {
                text += &markdown_picture(picture, outcome);
            }
        }
        text + "\n" + &self.results.markdown()
    }
}

fn html_picture(picture: &Picture, outcome: &Outcome) -> String {
    let label = match picture.label.as_str() {
        "" => String::new(),
        label => format!("<p>{}</p>\n", escape(label)),
    };
    let content = match outcome {
        Outcome::Drawn(command) => format!(
            "<a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\" loading=\"lazy\"></a>\n<pre>{2}</pre>\n",
            escape(&picture.file),
            escape(&picture.alt),
            escape(command)
        ),
        Outcome::Missing(why) => format!("<p class=\"missing\">{}</p>\n", escape(why)),
    };
    format!("<div>\n{label}{content}</div>\n")
}

fn markdown_picture(picture: &Picture, outcome: &Outcome) -> String {
    let label = match picture.label.as_str() {
        "" => String::new(),
        label => format!("\n{label}:\n"),
    };
    match outcome {
        Outcome::Drawn(command) => {
            format!("{label}\n![{}]({})\n\n    {command}\n", picture.alt, picture.file)
        }
        Outcome::Missing(why) => format!("{label}\n*({why})*\n"),
    }
}
