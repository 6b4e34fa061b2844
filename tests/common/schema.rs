//! JSON held against the schemas of the repository.

use std::fs;
use std::path::{Path, PathBuf};

use boon::{Compiler, Draft, SchemaIndex, Schemas};
use serde_json::{Value, json};

/// A schema, compiled.
pub struct Schema {
    schemas: Schemas,
    index: SchemaIndex,
}

impl Schema {
    /// The schema of a format like `cordon-trace/1`.
    pub fn of(format: &str) -> Self {
        Self::at(path_of(format))
    }

    /// The schema in a file.
    pub fn at(path: impl AsRef<Path>) -> Self {
        let path = path.as_ref();
        let text = fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        let mut schemas = Schemas::new();
        let mut compiler = Compiler::new();
        compiler.set_default_draft(Draft::V2020_12);
        let name = "schema.json";
        compiler.add_resource(name, serde_json::from_str(&text).unwrap()).unwrap();
        let index = compiler.compile(name, &mut schemas).unwrap();
        Self { schemas, index }
    }

    /// Whether a page meets it; what is wrong, if not.
    pub fn accepts(&self, page: &Value) -> Result<(), String> {
        self.schemas.validate(page, self.index).map_err(|e| e.to_string())
    }
}

/// The schema of a format like `cordon-trace/1`, from the repository's root or a folder in it.
pub fn path_of(format: &str) -> PathBuf {
    let name = PathBuf::from("schemas").join(format!("{}.json", format.replace('/', "-")));
    if name.exists() { name } else { PathBuf::from("..").join(name) }
}

/// A text as JSON.
pub fn parsed(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|e| panic!("{e}: {text}"))
}

/// Holds a page against its schema; then adds a field to it, and gives it the name of another format: both
/// have to be noticed.
pub fn meets(format: &str, page: &Value, what: &str) {
    let schema = Schema::of(format);
    schema.accepts(page).unwrap_or_else(|e| panic!("{what}: {e}"));
    let mut more = page.clone();
    more["surplus"] = json!(0);
    assert!(schema.accepts(&more).is_err(), "{what}: a field that the schema does not know");
    let mut other = page.clone();
    if other.get("schema").is_some() {
        other["schema"] = json!("cordon-other/1");
        assert!(schema.accepts(&other).is_err(), "{what}: another format");
    }
}
