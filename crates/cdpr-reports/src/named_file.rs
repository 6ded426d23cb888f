//! Files by their names.

/// Content of a file with its name; within a result, its name in the folder.
#[derive(Clone, Debug)]
pub struct NamedFile {
    /// Name.
    pub name: String,
    /// Bytes.
    pub content: Vec<u8>,
}

impl NamedFile {
    /// Content under a name.
    pub fn new(name: impl Into<String>, content: impl Into<Vec<u8>>) -> Self {
        Self { name: name.into(), content: content.into() }
    }
}
