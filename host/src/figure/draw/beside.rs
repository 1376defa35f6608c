//! How do two pictures share a page? Reads two scenes; writes one, the second to the right of the first.

use crate::plot::{Item, Rect, Scene};
use tiny_skia::Transform;

/// Puts the second picture to the right of the first.
pub fn beside(first: Scene, second: Scene) -> Scene {
    let shift = first.width;
    let moved = |rect: Rect| Rect { x: rect.x + shift, ..rect };
    let mut page = Scene::new(first.width + second.width, first.height.max(second.height));
    page.items = first.items;
    page.items.extend(second.items.into_iter().filter_map(|item| match item {
        Item::Shape { path, fill, stroke, clip } => {
            let path = path.transform(Transform::from_translate(shift as f32, 0.0))?;
            Some(Item::Shape { path, fill, stroke, clip: clip.map(moved) })
        }
        Item::Pixels { place, size, rgba } => {
            Some(Item::Pixels { place: moved(place), size, rgba })
        }
    }));
    page
}
