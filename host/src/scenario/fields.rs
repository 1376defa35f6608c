//! Which fields can a scenario have, for people? Reads its JSON Schema; writes tables in Markdown.

use super::schema::schema;
use serde_json::Value as Json;
use std::fmt::Write;

/// All fields as Markdown: a section for each table of the file, the outermost first.
pub fn fields() -> String {
    let root = schema();
    let mut page = Page { root, text: String::new(), waiting: Vec::new(), done: Vec::new() };
    page.rows(root, "the file itself");
    while !page.waiting.is_empty() {
        let (heading, name) = page.waiting.remove(0);
        if !page.done.contains(&name) {
            page.done.push(name.clone());
            page.section(&heading, &root["$defs"][name.as_str()]);
        }
    }
    page.text
}

struct Page<'s> {
    root: &'s Json,
    text: String,
    /// Types that have been named: how they are written in a file, and their name.
    waiting: Vec<(String, String)>,
    done: Vec<String>,
}

impl<'s> Page<'s> {
    fn line(&mut self, line: &str) {
        let _ = writeln!(self.text, "{line}");
    }

    fn section(&mut self, heading: &str, schema: &'s Json) {
        let branches = branches(schema);
        if branches.iter().all(|branch| branch["properties"].is_null()) && !branches.is_empty() {
            return;
        }
        self.line(&format!("\n### `{heading}`\n\n{}", description(schema)));
        if schema["properties"].is_object() {
            self.line("");
            self.rows(schema, heading);
        }
        for branch in branches {
            let kind = branch["properties"]["kind"]["const"].as_str();
            let about = description(branch);
            match kind {
                Some(kind) => self.line(&format!("\n**`kind = \"{kind}\"`.** {about}")),
                None => {
                    let name = self.type_of(branch, "");
                    self.line(&format!("\n**{name}.** {about}"));
                }
            }
            if fields_of(branch).next().is_some() {
                self.line("");
                self.rows(branch, heading);
            }
        }
    }

    fn rows(&mut self, schema: &'s Json, inside: &str) {
        self.line("| field | value | |\n|---|---|---|");
        let is_required = |name: &str| {
            schema["required"].as_array().is_some_and(|list| list.iter().any(|one| one == name))
        };
        let (first, then): (Vec<_>, Vec<_>) =
            fields_of(schema).partition(|(name, _)| is_required(name));
        let count = first.len();
        for (k, (name, field)) in first.into_iter().chain(then).enumerate() {
            let heading = match inside {
                "the file itself" => name.clone(),
                "[box]" => format!("[box] {name}"),
                _ => name.clone(),
            };
            let mut value = self.type_of(field, &heading);
            match &field["default"] {
                _ if k < count => value.push_str(", required"),
                Json::Null => {}
                Json::Array(list) if list.is_empty() => {}
                Json::Object(_) => {}
                Json::String(text) if text.is_empty() => {}
                default => {
                    let _ = write!(value, "; {default} if left out");
                }
            }
            let about = description(field);
            self.line(&format!("| `{name}` | {value} | {about} |"));
        }
    }

    /// What a field holds; tables of a type of their own are noted for a section.
    fn type_of(&mut self, schema: &'s Json, heading: &str) -> String {
        if let Some(name) = schema["$ref"].as_str().and_then(|r| r.strip_prefix("#/$defs/")) {
            let target = &self.root["$defs"][name];
            let words = words(target);
            if !words.is_empty() {
                return words.join(", ");
            }
            let heading = match heading {
                "box" | "options" | "gas" | "law" | "observe" => format!("[{heading}]"),
                "profile" | "pair_distribution" | "correlations" | "surface" => {
                    format!("[observe.{heading}]")
                }
                _ => heading.to_owned(),
            };
            self.waiting.push((heading.clone(), name.to_owned()));
            return format!("see `{}`", self.shown(name, &heading));
        }
        let kinds = branches(schema);
        match &kinds[..] {
            [] => {}
            [only] => return self.type_of(only, heading),
            _ => {
                let names: Vec<String> =
                    kinds.iter().map(|kind| self.type_of(kind, heading)).collect();
                return names.join(" or ");
            }
        }
        let kind = match &schema["type"] {
            Json::Array(names) => names.iter().filter_map(Json::as_str).find(|one| *one != "null"),
            one => one.as_str(),
        };
        match kind {
            Some("array") => {
                let item = &schema["items"];
                if item["$ref"].is_string() && !heading.is_empty() {
                    let plural = format!("[[{heading}]]");
                    let inner = self.type_of(item, &plural);
                    return match inner.strip_prefix("see ") {
                        Some(name) => format!("any number of {name}"),
                        None => format!("list of {inner}"),
                    };
                }
                let of = self.type_of(item, heading);
                match schema["minItems"].as_u64() {
                    Some(length) => format!("list of {length} {}", plural(&of)),
                    None => format!("list of {}", plural(&of)),
                }
            }
            Some("integer") => "whole number".to_owned(),
            Some("boolean") => "true or false".to_owned(),
            Some("string") => "text".to_owned(),
            Some("object") => {
                let names: Vec<String> = fields_of(schema).map(|(name, _)| name.clone()).collect();
                format!("{{ {} }}", names.join(", "))
            }
            Some(kind) => kind.to_owned(),
            None => "anything".to_owned(),
        }
    }

    /// The heading under which a type is, or will be, explained.
    fn shown(&self, name: &str, heading: &str) -> String {
        let first = self.waiting.iter().find(|(_, other)| other == name);
        first.map_or(heading, |(heading, _)| heading).to_owned()
    }
}

/// More than one of something.
fn plural(of: &str) -> String {
    of.strip_prefix("list of ").map_or_else(|| format!("{of}s"), |what| format!("lists of {what}"))
}

/// The schemas of which one must fit, "nothing" left out.
fn branches(schema: &Json) -> Vec<&Json> {
    let list = schema["oneOf"].as_array().or_else(|| schema["anyOf"].as_array());
    list.into_iter().flatten().filter(|branch| branch["type"] != "null").collect()
}

/// Fields but for the kind.
fn fields_of(schema: &Json) -> impl Iterator<Item = (&String, &Json)> {
    let fields = schema["properties"].as_object().into_iter().flatten();
    fields.filter(|(_, field)| field["const"].is_null())
}

/// The words of which a value is one.
fn words(schema: &Json) -> Vec<&str> {
    let plain = schema["enum"].as_array().into_iter().flatten();
    let branches = branches(schema).into_iter();
    plain
        .chain(branches.filter_map(|branch| branch.get("const")))
        .filter_map(Json::as_str)
        .collect()
}

/// A doc comment in one line.
fn description(schema: &Json) -> String {
    let text = schema["description"].as_str().unwrap_or_default();
    text.split_whitespace().collect::<Vec<_>>().join(" ").replace('|', "\\|")
}
