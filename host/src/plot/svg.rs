//! How does a scene become SVG? Reads a scene; writes SVG text.

use super::scene::{Colour, Item, Rect, Scene, Stroke};
use anyhow::Result;
use base64::Engine;
use std::fmt::Write;
use tiny_skia::{Path, PathSegment};

/// The scene as a stand-alone SVG document.
pub(super) fn encode(scene: &Scene) -> Result<String> {
    let (w, h) = (scene.width, scene.height);
    let mut text = String::new();
    writeln!(
        text,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{w}pt" height="{h}pt" viewBox="0 0 {w} {h}">"#
    )?;
    writeln!(text, r##"<rect width="{w}" height="{h}" fill="#ffffff"/>"##)?;
    let mut clips: Vec<Rect> = Vec::new();
    for item in &scene.items {
        write_item(&mut text, item, &mut clips)?;
    }
    text.push_str("</svg>\n");
    Ok(text)
}

fn write_item(text: &mut String, item: &Item, clips: &mut Vec<Rect>) -> Result<()> {
    match item {
        Item::Shape { path, fill, stroke, clip } => {
            let clip = clip.map(|clip| clip_number(text, clip, clips)).transpose()?;
            text.push_str("<path");
            if let Some(number) = clip {
                write!(text, r#" clip-path="url(#c{number})""#)?;
            }
            write_fill(text, *fill)?;
            if let Some(stroke) = stroke {
                write_stroke(text, stroke)?;
            }
            text.push_str(" d=\"");
            write_path(text, path)?;
            text.push_str("\"/>\n");
        }
        Item::Pixels { place: r, size, rgba } => {
            let png = super::png::pixels(*size, rgba)?.encode_png()?;
            let data = base64::engine::general_purpose::STANDARD.encode(png);
            writeln!(
                text,
                r#"<image x="{}" y="{}" width="{}" height="{}" preserveAspectRatio="none" href="data:image/png;base64,{data}"/>"#,
                r.x, r.y, r.width, r.height
            )?;
        }
    }
    Ok(())
}

/// The number of a clip rectangle, defined where it is first used.
fn clip_number(text: &mut String, clip: Rect, clips: &mut Vec<Rect>) -> Result<usize> {
    if let Some(number) = clips.iter().position(|known| *known == clip) {
        return Ok(number);
    }
    clips.push(clip);
    let number = clips.len() - 1;
    writeln!(
        text,
        r#"<clipPath id="c{number}"><rect x="{}" y="{}" width="{}" height="{}"/></clipPath>"#,
        clip.x, clip.y, clip.width, clip.height
    )?;
    Ok(number)
}

fn hex(colour: Colour) -> String {
    let [r, g, b] = colour.rgb;
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn write_fill(text: &mut String, fill: Option<Colour>) -> Result<()> {
    match fill {
        Some(colour) if colour.opacity < 1.0 => {
            write!(text, r#" fill="{}" fill-opacity="{}""#, hex(colour), colour.opacity)?;
        }
        Some(colour) => write!(text, r#" fill="{}""#, hex(colour))?,
        None => text.push_str(r#" fill="none""#),
    }
    Ok(())
}

fn write_stroke(text: &mut String, stroke: &Stroke) -> Result<()> {
    write!(
        text,
        r#" stroke="{}" stroke-width="{}" stroke-linejoin="round""#,
        hex(stroke.colour),
        stroke.width
    )?;
    if stroke.colour.opacity < 1.0 {
        write!(text, r#" stroke-opacity="{}""#, stroke.colour.opacity)?;
    }
    if let Some([dash, gap]) = stroke.dash {
        write!(text, r#" stroke-dasharray="{dash} {gap}""#)?;
    }
    Ok(())
}

fn write_path(text: &mut String, path: &Path) -> Result<()> {
    for segment in path.segments() {
        match segment {
            PathSegment::MoveTo(p) => write!(text, "M{:.2} {:.2}", p.x, p.y)?,
            PathSegment::LineTo(p) => write!(text, "L{:.2} {:.2}", p.x, p.y)?,
            PathSegment::QuadTo(a, p) => {
                write!(text, "Q{:.2} {:.2} {:.2} {:.2}", a.x, a.y, p.x, p.y)?;
            }
            PathSegment::CubicTo(a, b, p) => {
                let (ax, ay, bx, by) = (a.x, a.y, b.x, b.y);
                write!(text, "C{ax:.2} {ay:.2} {bx:.2} {by:.2} {:.2} {:.2}", p.x, p.y)?;
            }
            PathSegment::Close => text.push('Z'),
        }
    }
    Ok(())
}
