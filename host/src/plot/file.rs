//! How does a scene become a file? Reads a scene; writes SVG, PNG or PDF.

use super::pdf::pdf;
use super::scene::{Colour, Item, Rect, Run, Scene, Stroke};
use crate::output;
use anyhow::{Context, Result, bail};
use base64::Engine;
use std::fmt::Write;
use tiny_skia::{
    FillRule, FilterQuality, IntSize, LineCap, LineJoin, Mask, Paint, Path, PathBuilder,
    PathSegment, Pixmap, PixmapPaint, StrokeDash, Transform,
};

/// Writes the picture; `.png`, `.svg` or `.pdf` at the end of the name decides the format.
///
/// # Errors
/// Another ending, or a file that cannot be written.
pub fn save(scene: &Scene, file: &std::path::Path) -> Result<()> {
    let bytes = match ending(file)? {
        Format::Png => png(scene)?,
        Format::Svg => svg(scene)?.into_bytes(),
        Format::Pdf => pdf(scene)?,
    };
    output::write_file(file, &bytes)
}

/// A picture's file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Pixels.
    Png,
    /// Outlines, letters as text.
    Svg,
    /// Outlines, letters too.
    Pdf,
}

/// The format that a file's name asks for.
///
/// # Errors
/// When the name ends in none of `.png`, `.svg` and `.pdf`.
pub fn ending(file: &std::path::Path) -> Result<Format> {
    match file.extension().and_then(|ending| ending.to_str()) {
        Some(ending) if ending.eq_ignore_ascii_case("png") => Ok(Format::Png),
        Some(ending) if ending.eq_ignore_ascii_case("svg") => Ok(Format::Svg),
        Some(ending) if ending.eq_ignore_ascii_case("pdf") => Ok(Format::Pdf),
        _ => bail!("{}: a picture's name ends in .png, .svg or .pdf", file.display()),
    }
}

/// Letters are as wide as in the first of these, whichever is at hand.
const FONTS: &str = "Noto Sans, DejaVu Sans, Arial, Helvetica, sans-serif";

/// The scene as a stand-alone SVG document.
///
/// # Errors
/// When pixels in it make no picture.
pub fn svg(scene: &Scene) -> Result<String> {
    let (w, h) = (scene.width, scene.height);
    let mut text = String::new();
    writeln!(
        text,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{w}pt" height="{h}pt" viewBox="0 0 {w} {h}" font-family="{FONTS}">"#
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
        Item::Letters { colour, at: [x, y], upright, runs, .. } => {
            let turn = if *upright { " rotate(-90)" } else { "" };
            write!(
                text,
                r#"<text xml:space="preserve" transform="translate({x:.2} {y:.2}){turn}""#
            )?;
            write_fill(text, Some(*colour))?;
            text.push('>');
            runs.iter().try_for_each(|run| write_run(text, run))?;
            text.push_str("</text>\n");
        }
        Item::Pixels { place: r, size, rgba } => {
            let png = pixels(*size, rgba)?.encode_png()?;
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

fn write_run(text: &mut String, run: &Run) -> Result<()> {
    let Run { text: letters, at: [x, y], width, size, italic } = run;
    let slant = if *italic { r#" font-style="italic""# } else { "" };
    let letters = letters.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    write!(
        text,
        r#"<tspan x="{x:.2}" y="{y:.2}" font-size="{size:.2}"{slant} textLength="{width:.2}" lengthAdjust="spacingAndGlyphs">{letters}</tspan>"#
    )?;
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

/// Pixels a point: 144 dots an inch, enough for a screen and for print at half size.
const SCALE: f32 = 2.0;

/// The scene as a PNG file.
fn png(scene: &Scene) -> Result<Vec<u8>> {
    let width = (scene.width as f32 * SCALE).ceil() as u32;
    let height = (scene.height as f32 * SCALE).ceil() as u32;
    let mut canvas = Pixmap::new(width, height).context("the picture has no area")?;
    canvas.fill(tiny_skia::Color::WHITE);
    let mut clip = Clip { rect: None, mask: None };
    for item in &scene.items {
        draw(&mut canvas, item, &mut clip)?;
    }
    Ok(canvas.encode_png()?)
}

/// Pixels with opacity as a pixmap.
fn pixels(size: [u32; 2], rgba: &[u8]) -> Result<Pixmap> {
    let mut data = rgba.to_vec();
    for pixel in data.chunks_exact_mut(4) {
        let opacity = u16::from(pixel[3]);
        for channel in &mut pixel[..3] {
            *channel = (u16::from(*channel) * opacity / 255) as u8;
        }
    }
    let size = IntSize::from_wh(size[0], size[1]).context("a heat map has no area")?;
    Pixmap::from_vec(data, size).context("a heat map has too few pixels")
}

/// The clip in use; lines of one panel share it.
struct Clip {
    rect: Option<Rect>,
    mask: Option<Mask>,
}

impl Clip {
    fn mask(&mut self, rect: Option<Rect>, canvas: &Pixmap) -> Option<&Mask> {
        if rect != self.rect {
            self.rect = rect;
            self.mask = rect.and_then(|rect| {
                let (x, y) = (rect.x as f32, rect.y as f32);
                let place = tiny_skia::Rect::from_xywh(x, y, rect.width as f32, rect.height as f32);
                let path = PathBuilder::from_rect(place?);
                let mut mask = Mask::new(canvas.width(), canvas.height())?;
                mask.fill_path(&path, FillRule::Winding, true, Transform::from_scale(SCALE, SCALE));
                Some(mask)
            });
        }
        self.mask.as_ref()
    }
}

fn draw(canvas: &mut Pixmap, item: &Item, clips: &mut Clip) -> Result<()> {
    let scale = Transform::from_scale(SCALE, SCALE);
    match item {
        Item::Shape { path, fill, stroke, clip } => {
            let mask = clips.mask(*clip, canvas);
            if let Some(colour) = fill {
                canvas.fill_path(path, &paint(*colour), FillRule::Winding, scale, mask);
            }
            if let Some(stroke) = stroke {
                draw_line(canvas, path, stroke, mask);
            }
        }
        Item::Letters { path, colour, .. } => {
            canvas.fill_path(path, &paint(*colour), FillRule::Winding, scale, None);
        }
        Item::Pixels { place, size, rgba } => {
            let (sx, sy) =
                (place.width as f32 / size[0] as f32, place.height as f32 / size[1] as f32);
            let to = Transform::from_row(sx, 0.0, 0.0, sy, place.x as f32, place.y as f32);
            let how = PixmapPaint { quality: FilterQuality::Bilinear, ..PixmapPaint::default() };
            let image = pixels(*size, rgba)?;
            canvas.draw_pixmap(0, 0, image.as_ref(), &how, to.post_concat(scale), None);
        }
    }
    Ok(())
}

fn draw_line(canvas: &mut Pixmap, path: &Path, stroke: &Stroke, mask: Option<&Mask>) {
    let pen = tiny_skia::Stroke {
        width: stroke.width,
        line_cap: LineCap::Butt,
        line_join: LineJoin::Round,
        dash: stroke.dash.and_then(|lengths| StrokeDash::new(lengths.to_vec(), 0.0)),
        ..tiny_skia::Stroke::default()
    };
    let scale = Transform::from_scale(SCALE, SCALE);
    canvas.stroke_path(path, &paint(stroke.colour), &pen, scale, mask);
}

fn paint(colour: Colour) -> Paint<'static> {
    let [r, g, b] = colour.rgb;
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color_rgba8(r, g, b, (colour.opacity * 255.0).round() as u8);
    paint
}
