//! Finds where in a scene's text a key stands, so that an error about its value can say the line.
//!
//! RON's reader knows positions only while it reads. Ranges are checked afterwards, by key path
//! (`fields[0].species[1].height_m`); this walks the text, which has been read without error, along
//! such a path.

/// Line and column, from 1, of the value at a key path; of the deepest part that is there, where the
/// value was left to its default. `None` where not even the first part is there.
pub(crate) fn locate(text: &str, key: &str) -> Option<(usize, usize)> {
    let mut scanner = Scanner { text: text.as_bytes(), at: 0 };
    let mut found = None;
    for step in steps(key) {
        scanner.open()?;
        let reached = match step {
            Step::Key(name) => scanner.seek_key(name),
            Step::Index(index) => scanner.seek_index(index),
        };
        if !reached {
            break;
        }
        found = Some(scanner.at);
    }
    found.map(|at| line_and_column(text, at))
}

enum Step<'a> {
    Key(&'a str),
    Index(usize),
}

fn steps(key: &str) -> impl Iterator<Item = Step<'_>> {
    key.split(['.', '[', ']']).filter(|part| !part.is_empty()).map(|part| match part.parse() {
        Ok(index) => Step::Index(index),
        Err(_) => Step::Key(part),
    })
}

fn line_and_column(text: &str, at: usize) -> (usize, usize) {
    let before = text.get(..at).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |i| i + 1);
    let column = before.get(line_start..).unwrap_or("").chars().count() + 1;
    (before.matches('\n').count() + 1, column)
}

struct Scanner<'a> {
    text: &'a [u8],
    at: usize,
}

impl<'a> Scanner<'a> {
    fn peek(&self) -> Option<u8> {
        self.text.get(self.at).copied()
    }

    /// Skips white space and comments.
    fn skip_blank(&mut self) {
        loop {
            let rest = self.text.get(self.at..).unwrap_or(&[]);
            if rest.starts_with(b"//") {
                self.at += rest.iter().position(|&b| b == b'\n').unwrap_or(rest.len());
            } else if rest.starts_with(b"/*") {
                self.skip_block_comment();
            } else if rest.first().is_some_and(|b| b.is_ascii_whitespace() || !b.is_ascii()) {
                self.at += 1;
            } else {
                return;
            }
        }
    }

    /// Block comments nest in RON.
    fn skip_block_comment(&mut self) {
        let mut depth = 0;
        while let Some(rest) = self.text.get(self.at..).filter(|rest| !rest.is_empty()) {
            let step = match rest {
                [b'/', b'*', ..] => 1,
                [b'*', b'/', ..] => -1,
                _ => 0,
            };
            depth += step;
            self.at += if step == 0 { 1 } else { 2 };
            if depth == 0 {
                return;
            }
        }
    }

    fn word(&mut self) -> &'a [u8] {
        let start = self.at;
        while self.peek().is_some_and(|b| b.is_ascii_alphanumeric() || b"_#".contains(&b)) {
            self.at += 1;
        }
        self.text.get(start..self.at).unwrap_or(&[])
    }

    /// Skips attributes, then steps into the value's bracket: `(`, `[`, `{` or `Name(`.
    fn open(&mut self) -> Option<()> {
        self.skip_blank();
        while self.peek() == Some(b'#') {
            self.at += self.text.get(self.at..)?.iter().position(|&b| b == b']')? + 1;
            self.skip_blank();
        }
        let name = self.word();
        self.skip_blank();
        if !matches!(self.peek()?, b'(' | b'[' | b'{') {
            return None;
        }
        self.at += 1;
        if name == b"Some" { self.open() } else { Some(()) }
    }

    fn seek_key(&mut self, key: &str) -> bool {
        loop {
            self.skip_blank();
            let name = self.word();
            self.skip_blank();
            let named = self.peek() == Some(b':');
            if named {
                self.at += 1;
                self.skip_blank();
            }
            if named && name == key.as_bytes() {
                return true;
            }
            if !self.skip_item() {
                return false;
            }
        }
    }

    fn seek_index(&mut self, index: usize) -> bool {
        for _ in 0..index {
            if !self.skip_item() {
                return false;
            }
        }
        self.skip_blank();
        !matches!(self.peek(), None | Some(b')' | b']' | b'}'))
    }

    /// Skips to behind the next comma of this bracket; false at its end.
    fn skip_item(&mut self) -> bool {
        let mut depth = 0_usize;
        loop {
            self.skip_blank();
            let Some(byte) = self.peek() else { return false };
            match byte {
                b'"' => self.skip_string(),
                b'\'' => self.skip_char(),
                b'(' | b'[' | b'{' => depth += 1,
                b')' | b']' | b'}' if depth == 0 => return false,
                b')' | b']' | b'}' => depth -= 1,
                _ => {}
            }
            self.at += 1;
            if byte == b',' && depth == 0 {
                return true;
            }
        }
    }

    /// Leaves the closing quote to the caller.
    fn skip_string(&mut self) {
        let hashes = self.text.get(..self.at).unwrap_or(&[]).iter().rev();
        let hashes = hashes.take_while(|&&b| b == b'#').count();
        self.at += 1;
        while let Some(byte) = self.peek() {
            let closed = (1..=hashes).all(|i| self.text.get(self.at + i) == Some(&b'#'));
            match byte {
                b'"' if closed => return,
                b'\\' if hashes == 0 => self.at += 2,
                _ => self.at += 1,
            }
        }
    }

    fn skip_char(&mut self) {
        let escaped = self.text.get(self.at + 1) == Some(&b'\\');
        let from = self.at + if escaped { 3 } else { 2 };
        let rest = self.text.get(from..).unwrap_or(&[]);
        self.at = from + rest.iter().position(|&b| b == b'\'').unwrap_or(rest.len());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "#![enable(implicit_some)]\n\
        // fields: no, a comment (\n\
        (name: \"a, (b\", /* [ /* nested */ */\n\
         fields: [\n\
           (on: Terrain(size_m: 60), species: [(), (height_m: (1, 2))]),\n\
           (on: Object(r#\"x \" y\"#),\n\
            density: Some((-3))),\n\
         ])";

    #[test]
    fn finds_keys_through_comments_strings_and_variants() {
        let line = |key| locate(TEXT, key).map(|at| at.0);
        assert_eq!(locate(TEXT, "name"), Some((3, 8)));
        assert_eq!(line("fields"), Some(4));
        assert_eq!(locate(TEXT, "fields[0].on.size_m"), Some((5, 22)));
        assert_eq!(locate(TEXT, "fields[0].species[1].height_m"), Some((5, 52)));
        assert_eq!(line("fields[1].density"), Some(7));
    }

    #[test]
    fn names_the_deepest_part_that_is_there() {
        assert_eq!(locate(TEXT, "fields[0].species[0].width_m"), Some((5, 37)));
        assert_eq!(locate(TEXT, "fields[7].density"), locate(TEXT, "fields"));
        assert_eq!(locate(TEXT, "cameras[0].eye"), None);
        assert_eq!(locate("", "a"), None);
        assert_eq!(locate("((((", "a[0].b"), None);
    }
}
