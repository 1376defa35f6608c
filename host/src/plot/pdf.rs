//! How does a scene become a PDF? Reads a scene; writes one page of its size, in outlines: letters too, so no font is needed to print it.

use super::scene::{Colour, Item, Rect, Scene, Stroke};
use anyhow::{Context, Result};
use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Ref};
use tiny_skia::{Path, PathSegment, Point};

/// Of zlib: the usual compromise of time and size.
const COMPRESSION: u8 = 6;
const CATALOGUE: Ref = Ref::new(1);
const PAGES: Ref = Ref::new(2);
const PAGE: Ref = Ref::new(3);
const CONTENT: Ref = Ref::new(4);
/// The first of those that pictures and opacities take.
const FIRST: i32 = 5;

/// The scene as a PDF file.
///
/// # Errors
/// A heat map that has too few pixels, or more than PDF can say.
pub(super) fn pdf(scene: &Scene) -> Result<Vec<u8>> {
    let mut page = Page { content: Content::new(), opacities: Vec::new(), images: Vec::new() };
    // PDF counts upwards.
    page.content.transform([1.0, 0.0, 0.0, -1.0, 0.0, scene.height as f32]);
    page.content.set_line_join(LineJoinStyle::RoundJoin).set_line_cap(LineCapStyle::ButtCap);
    scene.items.iter().for_each(|item| page.draw(item));
    page.finish(scene)
}

/// A page as it is filled.
struct Page<'a> {
    content: Content,
    /// Those that are in use.
    opacities: Vec<f32>,
    /// Size and pixels.
    images: Vec<([u32; 2], &'a [u8])>,
}

impl<'a> Page<'a> {
    fn draw(&mut self, item: &'a Item) {
        self.content.save_state();
        match item {
            Item::Shape { path, fill, stroke, clip } => {
                self.clip(*clip);
                if let Some(colour) = fill {
                    self.fill(path, *colour);
                }
                if let Some(stroke) = stroke {
                    self.stroke(path, stroke);
                }
            }
            Item::Letters { path, colour, .. } => self.fill(path, *colour),
            Item::Pixels { place, size, rgba } => {
                let [x, y, width, height] =
                    [place.x, place.y, place.width, place.height].map(|x| x as f32);
                self.content.transform([width, 0.0, 0.0, -height, x, y + height]);
                self.content.x_object(Name(image_name(self.images.len()).as_bytes()));
                self.images.push((*size, rgba));
            }
        }
        self.content.restore_state();
    }

    fn clip(&mut self, clip: Option<Rect>) {
        if let Some(Rect { x, y, width, height }) = clip {
            let [x, y, width, height] = [x, y, width, height].map(|x| x as f32);
            self.content.rect(x, y, width, height).clip_nonzero().end_path();
        }
    }

    fn fill(&mut self, path: &Path, colour: Colour) {
        let [red, green, blue] = parts(colour);
        self.opacity(colour.opacity);
        self.content.set_fill_rgb(red, green, blue);
        trace(&mut self.content, path);
        self.content.fill_nonzero();
    }

    fn stroke(&mut self, path: &Path, stroke: &Stroke) {
        let [red, green, blue] = parts(stroke.colour);
        self.opacity(stroke.colour.opacity);
        self.content.set_stroke_rgb(red, green, blue).set_line_width(stroke.width);
        if let Some(dash) = stroke.dash {
            self.content.set_dash_pattern(dash, 0.0);
        }
        trace(&mut self.content, path);
        self.content.stroke();
    }

    fn opacity(&mut self, opacity: f32) {
        let known = self.opacities.iter().position(|one| *one == opacity);
        let number = known.unwrap_or(self.opacities.len());
        if known.is_none() {
            self.opacities.push(opacity);
        }
        self.content.set_parameters(Name(opacity_name(number).as_bytes()));
    }

    fn finish(self, scene: &Scene) -> Result<Vec<u8>> {
        let mut pdf = Pdf::new();
        pdf.catalog(CATALOGUE).pages(PAGES);
        pdf.pages(PAGES).kids([PAGE]).count(1);
        let mut references = (FIRST..).map(Ref::new);
        let opacities: Vec<(Ref, f32)> = references.by_ref().zip(self.opacities).collect();
        let images: Vec<_> =
            self.images.iter().map(|image| (references.next(), references.next(), image)).collect();
        let mut page = pdf.page(PAGE);
        let [width, height] = [scene.width, scene.height].map(|x| x as f32);
        page.media_box(pdf_writer::Rect::new(0.0, 0.0, width, height));
        page.parent(PAGES).contents(CONTENT);
        let mut resources = page.resources();
        let mut states = resources.ext_g_states();
        for (number, (reference, _)) in opacities.iter().enumerate() {
            states.pair(Name(opacity_name(number).as_bytes()), *reference);
        }
        states.finish();
        let mut objects = resources.x_objects();
        for (number, (reference, ..)) in images.iter().enumerate() {
            if let Some(reference) = reference {
                objects.pair(Name(image_name(number).as_bytes()), *reference);
            }
        }
        objects.finish();
        resources.finish();
        page.finish();
        let content = compress_to_vec_zlib(&self.content.finish(), COMPRESSION);
        pdf.stream(CONTENT, &content).filter(Filter::FlateDecode);
        for (reference, opacity) in opacities {
            pdf.ext_graphics(reference).non_stroking_alpha(opacity).stroking_alpha(opacity);
        }
        for (reference, mask, (size, rgba)) in images {
            if let (Some(reference), Some(mask)) = (reference, mask) {
                write_image(&mut pdf, [reference, mask], *size, rgba)?;
            }
        }
        Ok(pdf.finish())
    }
}

/// An image and, apart, its opacity.
fn write_image(
    pdf: &mut Pdf,
    [reference, mask]: [Ref; 2],
    size: [u32; 2],
    rgba: &[u8],
) -> Result<()> {
    let [width, height] = size.map(|x| i32::try_from(x).ok());
    let (width, height) = width.zip(height).context("a heat map is too large")?;
    let pixels = rgba.chunks_exact(4);
    let colours: Vec<u8> = pixels.clone().flat_map(|pixel| &pixel[..3]).copied().collect();
    let opacity: Vec<u8> = pixels.map(|pixel| pixel[3]).collect();
    let [colours, opacity] =
        [colours, opacity].map(|data| compress_to_vec_zlib(&data, COMPRESSION));
    let mut image = pdf.image_xobject(reference, &colours);
    image.filter(Filter::FlateDecode);
    image.width(width).height(height).bits_per_component(8);
    image.color_space().device_rgb();
    image.s_mask(mask);
    image.finish();
    let mut image = pdf.image_xobject(mask, &opacity);
    image.filter(Filter::FlateDecode);
    image.width(width).height(height).bits_per_component(8);
    image.color_space().device_gray();
    image.finish();
    Ok(())
}

fn image_name(number: usize) -> String {
    format!("I{number}")
}

fn opacity_name(number: usize) -> String {
    format!("G{number}")
}

fn parts(colour: Colour) -> [f32; 3] {
    colour.rgb.map(|part| f32::from(part) / 255.0)
}

fn trace(content: &mut Content, path: &Path) {
    let mut last = Point::default();
    for segment in path.segments() {
        match segment {
            PathSegment::MoveTo(p) => {
                content.move_to(p.x, p.y);
                last = p;
            }
            PathSegment::LineTo(p) => {
                content.line_to(p.x, p.y);
                last = p;
            }
            PathSegment::QuadTo(a, p) => {
                // A cubic curve whose handles are two thirds of the way to the one there is.
                let near = |end: Point| {
                    (end.x + (a.x - end.x) * 2.0 / 3.0, end.y + (a.y - end.y) * 2.0 / 3.0)
                };
                let ((ax, ay), (bx, by)) = (near(last), near(p));
                content.cubic_to(ax, ay, bx, by, p.x, p.y);
                last = p;
            }
            PathSegment::CubicTo(a, b, p) => {
                content.cubic_to(a.x, a.y, b.x, b.y, p.x, p.y);
                last = p;
            }
            PathSegment::Close => {
                content.close_path();
            }
        }
    }
}
