//! How does a field become colours? Reads values on a grid; writes pixels and a colour bar to a scene.

use super::axes::{Axis, Panel};
use super::colour;
use super::scene::{Item, Rect, Scene};

/// Values on a grid, row by row from the bottom; NaN is left white.
#[derive(Clone, Debug)]
pub struct Field {
    /// Columns.
    pub columns: usize,
    /// The values.
    pub values: Vec<f64>,
}

impl Field {
    /// Draws the field over `place`, `low` as the darkest colour and `high` as the lightest.
    pub fn draw(&self, scene: &mut Scene, place: Rect, low: f64, high: f64) {
        let columns = self.columns.max(1);
        let rows = self.values.len() / columns;
        let mut rgba = Vec::with_capacity(4 * self.values.len());
        for row in self.values.chunks_exact(columns).rev() {
            for value in row {
                if value.is_nan() {
                    rgba.extend([255, 255, 255, 0]);
                } else {
                    let [r, g, b] = colour::scale((value - low) / (high - low)).rgb;
                    rgba.extend([r, g, b, 255]);
                }
            }
        }
        scene.items.push(Item::Pixels { place, size: [columns as u32, rows as u32], rgba });
    }
}

/// A horizontal colour bar from `low` to `high` with about three numbers below it.
pub fn colour_bar(scene: &mut Scene, place: Rect, low: f64, high: f64) {
    let columns = 256;
    let values = (0..columns).map(|k| k as f64 / (columns - 1) as f64).collect();
    Field { columns, values }.draw(scene, place, 0.0, 1.0);
    // Numbers with two decimals need more room.
    let x = Axis::linear(low, high, if high - low < 0.3 { 3 } else { 4 });
    Panel { place, x, y: Axis::with_ticks(0.0, 1.0, Vec::new()) }.frame(scene);
}
