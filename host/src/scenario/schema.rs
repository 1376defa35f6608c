//! Which fields has a scenario? Reads the types; writes JSON Schema.

use super::spec::Scenario;
use serde_json::Value as Json;
use std::sync::LazyLock;

/// JSON Schema (draft 2020-12) of a scenario file.
pub fn schema() -> &'static Json {
    static SCHEMA: LazyLock<Json> =
        LazyLock::new(|| schemars::schema_for!(Scenario).as_value().clone());
    &SCHEMA
}
