//! What does the box look like? Reads the disks; draws them on any display of `embedded-graphics`.

use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{Circle, PrimitiveStyle};

use crate::scene::{Disks, Number, SIDES};

/// The picture that the box is made for. On others it is scaled.
pub const PIXELS: Size = Size::new(128, 64);

/// Draws the disks, as large as the display allows, on a dark ground: what moves is filled, what sleeps is a ring.
///
/// # Errors
/// Those of the display.
pub fn draw<D>(disks: &Disks<'_>, display: &mut D) -> Result<(), D::Error>
where
    D: DrawTarget,
    D::Color: From<BinaryColor>,
{
    let area = display.bounding_box();
    let scale = pixels_a_millimetre(area.size);
    let light = BinaryColor::On.into();
    display.clear(BinaryColor::Off.into())?;
    let view = disks.view();
    for number in 0..view.len() {
        let Some(disk) = view.grain(number) else { continue };
        let corner =
            [disk.position.x, SIDES[1] - disk.position.y].map(|middle| middle - disk.radius);
        let [left, top] = corner.map(|length| pixels(length, scale));
        let style = if view.is_at_rest(number) {
            PrimitiveStyle::with_stroke(light, 1)
        } else {
            PrimitiveStyle::with_fill(light)
        };
        let diameter = pixels(2.0 * disk.radius, scale).unsigned_abs();
        Circle::new(area.top_left + Point::new(left, top), diameter)
            .into_styled(style)
            .draw(display)?;
    }
    Ok(())
}

fn pixels(length: Number, scale: Number) -> i32 {
    (length * scale) as i32
}

/// The scale at which the whole box fits into the display.
fn pixels_a_millimetre(size: Size) -> Number {
    let [width, height] = SIDES;
    (size.width as Number / width).min(size.height as Number / height)
}
