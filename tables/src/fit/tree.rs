//! What has a fit found? Collects leaves, rows and coefficients; reads the columns of a box, writes them in the layout of a table.

use super::column::Column;
use super::cube::Cube;
use crate::read::layout::{Branch, Leaf, Row};

/// The tree of boxes with its expansions, in double precision.
#[derive(Clone, Debug, Default)]
pub(crate) struct FittedTree {
    pub branches: Vec<Branch>,
    pub leaves: Vec<Leaf>,
    pub rows: Vec<Row>,
    pub coefficients: Vec<f64>,
    /// The box of each leaf.
    pub cubes: Vec<Cube>,
    /// Number of coefficients of the largest leaf.
    pub terms: usize,
    /// What the search has decided, depth first: `0`, `1`, `2` bisects that axis, three letters
    /// are a leaf and its nodes along the axes (`a` is none, `b` one, ...).
    pub bisection: String,
}

impl FittedTree {
    /// Appends the rows and coefficients of one leaf.
    pub fn push_rows(&mut self, columns: &[Column; 3], direct_angle: bool) -> Leaf {
        let mut leaf = Leaf {
            first_row: self.rows.len() as u32,
            first_coefficient: self.coefficients.len() as u32,
            rows: [0; 3],
            terms: [2; 3],
            direct_angle,
        };
        for (column, count) in columns.iter().zip(0..3) {
            for (at, &terms) in column.lengths.iter().enumerate() {
                if terms == 0 {
                    continue;
                }
                let (i, j) = (at / column.n[1], at % column.n[1]);
                self.rows.push(Row { orders: (16 * i + j) as u8, terms: terms as u8 });
                self.coefficients.extend(&column.all[at * column.n[2]..][..terms]);
                leaf.rows[count] += 1;
                for (most, terms) in leaf.terms.iter_mut().zip([i + 1, j + 1, terms]) {
                    *most = (*most).max(terms as u8);
                }
            }
        }
        leaf
    }
}
