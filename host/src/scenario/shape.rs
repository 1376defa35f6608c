//! Does a file have the fields it must have, and no others? Reads a TOML tree and the JSON Schema of a type; writes a list of problems.

use super::problem::{Problem, named};
use serde_json::Value as Json;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// What a tree lacks or has too much of, by a schema and its definitions.
pub struct Shape<'s> {
    root: &'s Json,
    /// What was found.
    pub problems: Vec<Problem>,
}

impl<'s> Shape<'s> {
    /// Compares the outermost table with the schema.
    pub fn check(schema: &'s Json, table: &DeTable<'_>) -> Vec<Problem> {
        let mut shape = Self { root: schema, problems: Vec::new() };
        shape.table(schema, table, "", 0);
        shape.problems
    }

    fn note(&mut self, path: &str, offset: usize, message: String) {
        self.problems.push(Problem { path: path.to_owned(), offset: Some(offset), message });
    }

    /// The schema itself, where it only names another.
    fn resolved(&self, schema: &'s Json) -> &'s Json {
        let name = schema["$ref"].as_str().and_then(|name| name.strip_prefix('#'));
        name.and_then(|pointer| self.root.pointer(pointer)).unwrap_or(schema)
    }

    /// The schemas of which one must fit, "nothing" left out.
    fn branches(&self, schema: &'s Json) -> Vec<&'s Json> {
        let list = schema["oneOf"].as_array().or_else(|| schema["anyOf"].as_array());
        let branches = list.into_iter().flatten().map(|branch| self.resolved(branch));
        branches.filter(|branch| branch["type"] != "null").collect()
    }

    fn value(&mut self, schema: &'s Json, value: &Spanned<DeValue<'_>>, path: &str) {
        let schema = self.resolved(schema);
        let branches = self.branches(schema);
        let offset = value.span().start;
        match (&branches[..], value.get_ref()) {
            ([], _) => self.plain(schema, value, path),
            ([only], _) => self.value(only, value, path),
            (_, DeValue::Table(table)) if branches.iter().any(|b| b["type"] == "object") => {
                if let Some(branch) = self.chosen(&branches, table, path, offset) {
                    self.table(branch, table, path, offset);
                }
            }
            (_, DeValue::String(word)) if branches.iter().any(|b| b["type"] == "string") => {
                self.word(&branches, word, path, offset);
            }
            _ => match branches.iter().find(|branch| fits(branch, value.get_ref())) {
                Some(branch) => self.plain(branch, value, path),
                None => self.wrong(path, &branches, value),
            },
        }
    }

    fn wrong(&mut self, path: &str, branches: &[&Json], value: &Spanned<DeValue<'_>>) {
        let mut wanted: Vec<String> = Vec::new();
        for branch in branches {
            let one = kind_of_schema(branch);
            if !wanted.contains(&one) {
                wanted.push(one);
            }
        }
        let [name, is] = [named(path), kind_of(value.get_ref()).to_owned()];
        let message = format!("{name} is {is}, must be {}", wanted.join(" or "));
        self.note(path, value.span().start, message);
    }

    /// One of several words.
    fn word(&mut self, branches: &[&'s Json], word: &str, path: &str, offset: usize) {
        let words: Vec<&str> = branches.iter().flat_map(|branch| words(branch)).collect();
        if words.is_empty() || words.contains(&word) {
            return;
        }
        let message = format!("{}: unknown variant `{word}`; {}", named(path), near(word, &words));
        self.note(path, offset, message);
    }

    /// The schema that a table means: by its kind, or by the fields that it has.
    fn chosen(
        &mut self,
        branches: &[&'s Json],
        table: &DeTable<'_>,
        path: &str,
        offset: usize,
    ) -> Option<&'s Json> {
        let kind = |branch: &'s Json| branch["properties"]["kind"]["const"].as_str();
        let kinds: Vec<&str> = branches.iter().filter_map(|branch| kind(branch)).collect();
        if kinds.is_empty() {
            let known = |branch: &&&'s Json| {
                table
                    .keys()
                    .filter(|key| branch["properties"].get(key.get_ref().as_ref()).is_some())
                    .count()
            };
            let tables = branches.iter().filter(|branch| branch["type"] == "object");
            return tables.rev().max_by_key(known).copied();
        }
        let Some((key, value)) = table.get_key_value("kind") else {
            let message = format!("{}: kind is missing, must be {}", named(path), any_of(&kinds));
            self.note(path, offset, message);
            return None;
        };
        let said = value.get_ref().as_str().unwrap_or_default();
        let found = branches.iter().find(|branch| kind(branch) == Some(said));
        if found.is_none() {
            let [name, near] = [named(path), near(said, &kinds)];
            let message = format!("{name}: unknown variant `{said}`; {near}");
            self.note(&format!("{path}.kind"), key.span().start, message);
        }
        found.copied()
    }

    /// What is one thing only.
    fn plain(&mut self, schema: &'s Json, value: &Spanned<DeValue<'_>>, path: &str) {
        let offset = value.span().start;
        if !fits(schema, value.get_ref()) {
            return self.wrong(path, &[schema], value);
        }
        match value.get_ref() {
            DeValue::Table(table) => self.table(schema, table, path, offset),
            DeValue::Array(list) => {
                let (least, most) = (schema["minItems"].as_u64(), schema["maxItems"].as_u64());
                let length = list.len() as u64;
                if least.is_some_and(|least| length < least)
                    || most.is_some_and(|most| length > most)
                {
                    let (name, wanted) = (named(path), kind_of_schema(schema));
                    let message = format!("{name} has {length} entries, must be {wanted}");
                    self.note(path, offset, message);
                }
                for (k, entry) in list.iter().enumerate() {
                    self.value(&schema["items"], entry, &format!("{path}.{k}"));
                }
            }
            DeValue::String(word) => self.word(&[schema], word, path, offset),
            DeValue::Integer(number) => {
                let is_negative = number.as_str().starts_with('-');
                if schema["minimum"].as_f64() == Some(0.0) && is_negative {
                    let message = format!("{} is {number}, must be at least 0", named(path));
                    self.note(path, offset, message);
                }
            }
            _ => {}
        }
    }

    fn table(&mut self, schema: &'s Json, table: &DeTable<'_>, path: &str, offset: usize) {
        let properties = schema["properties"].as_object();
        let fields: Vec<&str> =
            properties.into_iter().flat_map(|fields| fields.keys().map(String::as_str)).collect();
        let below =
            |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
        for (key, value) in table {
            let name = key.get_ref().as_ref();
            match schema["properties"].get(name) {
                Some(field) => self.value(field, value, &below(name)),
                None => {
                    let place = if path.is_empty() { String::new() } else { named(path) + ": " };
                    let message = format!("{place}unknown field `{name}`; {}", near(name, &fields));
                    self.note(&below(name), key.span().start, message);
                }
            }
        }
        let required = schema["required"].as_array().into_iter().flatten();
        for name in required.filter_map(Json::as_str).filter(|name| !table.contains_key(*name)) {
            self.note(path, offset, format!("{} is missing", named(&below(name))));
        }
    }
}

/// The words that a schema allows.
fn words(schema: &Json) -> Vec<&str> {
    let list = schema["enum"].as_array().into_iter().flatten();
    list.chain(schema.get("const")).filter_map(Json::as_str).collect()
}

/// Whether a value can be what the schema wants, one level deep.
fn fits(schema: &Json, value: &DeValue<'_>) -> bool {
    let is = |name: &str| match &schema["type"] {
        Json::Array(names) => names.iter().any(|one| one == name),
        one => one == name,
    };
    match value {
        DeValue::String(_) => is("string"),
        DeValue::Integer(_) => is("integer") || is("number"),
        DeValue::Float(_) => is("number"),
        DeValue::Boolean(_) => is("boolean"),
        DeValue::Array(_) => is("array"),
        DeValue::Table(_) => is("object"),
        DeValue::Datetime(_) => false,
    }
}

fn kind_of(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
        DeValue::Datetime(_) => "a date",
    }
}

fn kind_of_schema(schema: &Json) -> String {
    let name = match &schema["type"] {
        Json::Array(names) => names.iter().filter_map(Json::as_str).find(|name| *name != "null"),
        name => name.as_str(),
    };
    match name {
        Some("string") if !words(schema).is_empty() => any_of(&words(schema)),
        Some("string") => "a text".to_owned(),
        Some("integer") => "a whole number".to_owned(),
        Some("number") => "a number".to_owned(),
        Some("boolean") => "true or false".to_owned(),
        Some("array") => match schema["minItems"].as_u64() {
            Some(length) => format!("a list of {length}"),
            None => "a list".to_owned(),
        },
        Some("object") => match schema["required"].as_array().and_then(|list| list.first()) {
            Some(Json::String(name)) => format!("a table with {name}"),
            _ => "a table".to_owned(),
        },
        _ => "something else".to_owned(),
    }
}

/// "a, b or c".
pub fn any_of(names: &[&str]) -> String {
    match names {
        [] => "nothing".to_owned(),
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} or {last}", first.join(", ")),
    }
}

/// Which name was meant, or which there are.
pub fn near(name: &str, names: &[&str]) -> String {
    let distance = |other: &&&str| strsim::damerau_levenshtein(name, other);
    match names.iter().min_by_key(distance) {
        Some(nearest) if distance(&nearest) <= (name.chars().count() / 2).max(1) => {
            format!("the nearest is `{nearest}`")
        }
        _ => format!("there is {}", any_of(names)),
    }
}
