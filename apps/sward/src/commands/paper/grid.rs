//! A table with a head, written as Markdown or as HTML.

use std::fmt::Write;

/// Title, remark, and cells; the first column is text, the others are numbers.
#[derive(Debug, Clone, Default)]
pub struct Grid {
    pub title: String,
    pub note: String,
    pub head: Vec<String>,
    pub rows: Vec<Vec<String>>,
}

impl Grid {
    /// With its heading.
    pub fn markdown(&self) -> String {
        let mut text = format!("### {}\n\n", self.title);
        if !self.note.is_empty() {
            let _ = write!(text, "{}\n\n", self.note);
        }
        let line = |cells: &[String]| {
            let cells: Vec<_> = cells.iter().map(|cell| cell.replace('|', "\\|")).collect();
            format!("| {} |\n", cells.join(" | "))
        };
        text += &line(&self.head);
        let rule: Vec<_> =
            (0..self.head.len()).map(|i| if i == 0 { "---" } else { "--:" }).collect();
        let _ = writeln!(text, "|{}|", rule.join("|"));
        for row in &self.rows {
            text += &line(row);
        }
        text
    }

    /// With its heading.
    pub fn html(&self) -> String {
        let mut text = format!("<h3>{}</h3>\n", escape(&self.title));
        if !self.note.is_empty() {
            let _ = writeln!(text, "<p>{}</p>", escape(&self.note));
        }
        let line = |cells: &[String], tag: &str| {
            let cells = cells.iter().map(|cell| format!("<{tag}>{}</{tag}>", escape(cell)));
            format!("<tr>{}</tr>\n", cells.collect::<String>())
        };
        text += "<table>\n";
        text += &line(&self.head, "th");
        for row in &self.rows {
            text += &line(row, "td");
        }
        text + "</table>\n"
    }
}

/// Text inside HTML, attributes included.
pub fn escape(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    text.replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_forms() {
        let cells = |cells: [&str; 2]| cells.map(String::from).to_vec();
        let grid = Grid {
            title: "A & B".into(),
            note: "Why.".into(),
            head: cells(["", "a|b"]),
            rows: vec![cells(["x", "<1>"])],
        };
        assert_eq!(grid.markdown(), "### A & B\n\nWhy.\n\n|  | a\\|b |\n|---|--:|\n| x | <1> |\n");
        assert_eq!(
            grid.html(),
            "<h3>A &amp; B</h3>\n<p>Why.</p>\n<table>\n<tr><th></th><th>a|b</th></tr>\n\
             <tr><td>x</td><td>&lt;1&gt;</td></tr>\n</table>\n"
        );
    }
}
