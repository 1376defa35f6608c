//! How does a scene become pixels? Reads a scene; writes PNG bytes.

use super::scene::{Colour, Item, Rect, Scene, Stroke};
use anyhow::{Context, Result};
use tiny_skia::{
    FillRule, FilterQuality, IntSize, LineCap, LineJoin, Mask, Paint, Path, PathBuilder, Pixmap,
    PixmapPaint, StrokeDash, Transform,
};

/// Pixels a point: 144 dots an inch, enough for a screen and for print at half size.
const SCALE: f32 = 2.0;

/// The scene as a PNG file.
pub(super) fn encode(scene: &Scene) -> Result<Vec<u8>> {
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
pub(super) fn pixels(size: [u32; 2], rgba: &[u8]) -> Result<Pixmap> {
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
