//! How does a state of fifteen numbers go on for a while? Dormand and Prince's step of fifth order; reads a slope, writes nothing.
//!
//! J. Comput. Appl. Math. 6, 19 (1980).

/// Separation, velocity, two rotations and a spring, three numbers each.
pub(crate) const STATE: usize = 15;

pub(crate) type State = [f64; STATE];

pub(crate) type Vector = [f64; 3];

pub(crate) fn dot(a: &Vector, b: &Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn plus(a: &Vector, s: f64, b: &Vector) -> Vector {
    std::array::from_fn(|k| a[k] + s * b[k])
}

pub(crate) fn cross(a: &Vector, b: &Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Separation, velocity, both rotations and the spring.
pub(crate) fn parts(y: &State) -> [Vector; 5] {
    std::array::from_fn(|part| std::array::from_fn(|k| y[3 * part + k]))
}

const A: [&[f64]; 7] = [
    &[],
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];

/// Fifth order less fourth.
const ERROR: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339_200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// The state after a step, and by how much it may be wrong, in units of these: of lengths, speeds and rotations.
pub(crate) fn step(
    y: &State,
    h: f64,
    [length, speed, rotation]: [f64; 3],
    slope: impl Fn(&State) -> State,
) -> (State, f64) {
    let mut slopes = [[0.0; STATE]; 7];
    let mut at = *y;
    for stage in 0..7 {
        at = std::array::from_fn(|k| {
            let sum: f64 = A[stage].iter().zip(&slopes).map(|(a, slope)| a * slope[k]).sum();
            y[k] + h * sum
        });
        slopes[stage] = slope(&at);
    }
    let units = [length, speed, rotation, rotation, length];
    let wrong = |k: usize| {
        let sum: f64 = ERROR.iter().zip(&slopes).map(|(e, slope)| e * slope[k]).sum();
        (h * sum).abs() / units[k / 3]
    };
    (at, (0..STATE).map(wrong).fold(0.0, f64::max))
}
