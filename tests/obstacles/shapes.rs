//! Which obstacles are tested? Polygons and meshes, and worlds in them.

use carom::particle::Index;
use carom::scalar::Scalar;
use carom::space::{Facet, Surface, mesh};
use carom::world::WithObstacles;
use carom::{Grain, HeapMemory};

/// Memory for so many grains among these facets, with enough places for lists.
pub type Room<S, const D: usize> = WithObstacles<HeapMemory<S, D>, Vec<Facet<S, D>>, Vec<Index>>;

pub fn room<S: Scalar, const D: usize>(grains: usize, facets: Vec<Facet<S, D>>) -> Room<S, D> {
    let lists = vec![Index::default(); 64 * facets.len() + 64];
    WithObstacles::new(HeapMemory::with_capacity(grains), facets, lists)
}

/// A closed polygon through any number of corners.
pub fn ring(corners: &[[f64; 2]], surface: Surface<f64>) -> Vec<Facet<f64, 2>> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(&a, &b)| Facet::new([a, b], surface)).collect()
}

/// A circle of so many corners.
pub fn circle([x, y]: [f64; 2], radius: f64, corners: usize) -> Vec<[f64; 2]> {
    let at = |k: usize| {
        let angle = std::f64::consts::TAU * k as f64 / corners as f64;
        [x + radius * angle.cos(), y + radius * angle.sin()]
    };
    (0..corners).map(at).collect()
}

/// The box [0, 1]³ as twelve triangles.
pub fn cube(surface: Surface<f64>) -> Vec<Facet<f64, 3>> {
    let vertices: Vec<[f64; 3]> =
        (0..8).map(|k| [k & 1, k >> 1 & 1, k >> 2 & 1].map(|x| x as f64)).collect();
    let sides =
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    let triangles: Vec<_> = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    mesh(&vertices, &triangles, surface).collect()
}

/// A regular tetrahedron about the origin, its corners on the unit sphere.
pub fn tetrahedron(surface: Surface<f64>) -> Vec<Facet<f64, 3>> {
    let s = 3.0_f64.sqrt().recip();
    let vertices = [[s, s, s], [s, -s, -s], [-s, s, -s], [-s, -s, s]];
    mesh(&vertices, &[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]], surface).collect()
}

/// A sphere about the origin: an icosahedron whose faces were divided in four so often.
pub fn icosphere(radius: f64, rounds: usize, surface: Surface<f64>) -> Vec<Facet<f64, 3>> {
    let (p, mut vertices) = ((1.0 + 5.0_f64.sqrt()) / 2.0, Vec::new());
    for (a, b) in [(1.0, p), (1.0, -p), (-1.0, p), (-1.0, -p)] {
        vertices.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
    }
    let distance = |a: &[f64; 3], b: &[f64; 3]| -> f64 {
        a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
    };
    let near = |a: usize, b: usize, v: &[[f64; 3]]| (distance(&v[a], &v[b]) - 2.0).abs() < 1e-9;
    let mut faces = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b, &vertices) && near(b, c, &vertices) && near(a, c, &vertices) {
                    faces.push([vertices[a], vertices[b], vertices[c]]);
                }
            }
        }
    }
    assert_eq!(faces.len(), 20);
    let on_sphere = |v: [f64; 3]| v.map(|x| x / v.iter().map(|x| x * x).sum::<f64>().sqrt());
    // The sum of two numbers is the same in either order: neighbours share corners to the last bit.
    let middle =
        |a: [f64; 3], b: [f64; 3]| on_sphere(std::array::from_fn(|axis| a[axis] + b[axis]));
    faces.iter_mut().for_each(|face| *face = face.map(on_sphere));
    for _ in 0..rounds {
        faces = faces
            .into_iter()
            .flat_map(|[a, b, c]| {
                let [d, e, f] = [middle(a, b), middle(b, c), middle(c, a)];
                [[a, d, f], [b, e, d], [c, f, e], [d, e, f]]
            })
            .collect();
    }
    let scaled = |v: [f64; 3]| v.map(|x| x * radius);
    faces.into_iter().map(|face| Facet::new(face.map(scaled), surface)).collect()
}

/// Numbers from 0 to 1 that are always the same.
pub struct Draw(pub u64);

impl Draw {
    pub fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// A direction in any dimension.
    pub fn direction<const D: usize>(&mut self) -> [f64; D] {
        loop {
            let v: [f64; D] = std::array::from_fn(|_| self.between(-1.0, 1.0));
            let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
            if length > 0.1 && length < 1.0 {
                return v.map(|x| x / length);
            }
        }
    }
}

/// A grain of this radius at the origin, moving so.
pub fn ball<const D: usize>(radius: f64, velocity: [f64; D]) -> Grain<f64, D> {
    Grain::with_mass(radius, 1.0).moving(velocity)
}
