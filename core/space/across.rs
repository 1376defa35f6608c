//! Whom does a grain see across a sheared face? All that lie along it, wherever their images are by now; reads lists, writes nothing.
//!
//! Images move along the flow, so any column may come to stand above any other: all are looked at, and no crossing of
//! cells along the flow brings anybody new. That costs a look at the faces of a box as many cells as it is long.

use super::cells::Cells;
use super::grid::{Grid, NOWHERE};
use super::link::{END, MORE};
use crate::scalar::Scalar;

impl<S: Scalar, const D: usize> Cells<'_, S, D> {
    /// Visits all grains that one in a cell may touch across a sheared face, each with the row of its image that can be
    /// touched there: above the box (1) or below it (−1). Without a grid both of all.
    pub fn for_each_across(&self, at: &[u32; D], visit: &mut dyn FnMut(usize, S)) {
        let Some(shear) = self.sheared.get() else { return };
        let Some(grid) = &self.grid else {
            for grain in (0_u32..).zip(&*self.links).filter(|(k, link)| link.is_of(*k)).map(|x| x.0)
            {
                visit(grain as usize, S::one());
                visit(grain as usize, -S::one());
            }
            return;
        };
        if let Some((row, up)) = grid.row_across(at, shear.gradient) {
            let rows = if up { S::one() } else { -S::one() };
            grid.along(row, [shear.flow, shear.gradient], &mut |list| {
                self.list_of(list, &mut |grain| visit(grain, rows));
            });
        }
    }

    /// Whether a grain in a cell may touch others across a sheared face. Without a grid all may.
    pub fn is_at_sheared_face(&self, at: &[u32; D]) -> bool {
        let is_at_face = |gradient| {
            self.grid.as_ref().is_none_or(|grid| grid.row_across(at, gradient).is_some())
        };
        self.sheared.get().is_some_and(|shear| is_at_face(shear.gradient))
    }

    /// The same as [`Cells::for_each_across`] for those who look around in cells: without a grid they see all anyway.
    pub(super) fn and_across(&self, at: &[u32; D], visit: &mut dyn FnMut(usize)) {
        if self.sheared.get().is_some() && self.grid.is_some() {
            self.for_each_across(at, &mut |grain, _| visit(grain));
        }
    }

    /// Visits the grains of a list.
    fn list_of(&self, list: u32, visit: &mut dyn FnMut(usize)) {
        let head = self.heads.get(list as usize).map_or(END, |head| head.get());
        let mut grain = head & !MORE;
        while let Some(link) = self.links.get(grain as usize) {
            visit(grain as usize);
            grain = link.next.get();
        }
    }
}

impl<S: Scalar, const D: usize> Grid<S, D> {
    /// The cell at the other side of a sheared box, if this one is at its face, and whether that is the one above.
    fn row_across(&self, at: &[u32; D], gradient: usize) -> Option<([u32; D], bool)> {
        let last = self.axes().get(gradient)?.count - 1;
        let mut row = *at;
        let c = row.get_mut(gradient)?;
        let up = *c == last;
        if !up && *c > 0 {
            return None;
        }
        *c = if up { 0 } else { last };
        Some((row, up))
    }

    /// Visits all cells along the flow beside one, and those next to them along the axis that is neither.
    fn along(&self, at: [u32; D], [flow, gradient]: [usize; 2], visit: &mut dyn FnMut(u32)) {
        let around = self.around(&at);
        let (mut first, mut scale, mut beside) = (0, [0, 1], [0, NOWHERE, NOWHERE]);
        for (axis, (along, &c)) in self.axes().iter().zip(&at).enumerate() {
            let [_, step] = scale;
            match axis {
                _ if axis == flow => scale = [step, step * along.count],
                _ if axis == gradient => {
                    (first, scale) = (first + c * step, [scale[0], step * along.count]);
                }
                _ => {
                    beside = around.steps.get(axis).copied().unwrap_or(beside);
                    scale = [scale[0], step * along.count];
                }
            }
        }
        let columns = self.axes().get(flow).map_or(0, |along| along.count);
        for beside in beside.iter().filter(|beside| **beside < NOWHERE) {
            (0..columns).for_each(|column| visit(first + beside + column * scale[0]));
        }
    }
}
