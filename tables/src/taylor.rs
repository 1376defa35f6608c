//! What are the Taylor coefficients of the next step? Reads the state of a contact; writes its power series in the step variable.

/// Number of coefficients of a power series in the step variable, lowest first.
pub(crate) const PRECISE_TERMS: usize = 23;
/// Fewer coefficients for a looser tolerance.
pub(crate) const QUICK_TERMS: usize = 11;

/// Coefficient `n` of the product of two series (Cauchy). Plain indices: build scripts run unoptimised.
#[inline(always)]
fn product<const N: usize>(a: &[f64; N], b: &[f64; N], n: usize) -> f64 {
    let mut sum = 0.0;
    let mut i = 0;
    while i <= n {
        sum += a[i] * b[n - i];
        i += 1;
    }
    sum
}

/// The value of a series at `h` (Horner).
pub(crate) fn value<const N: usize>(a: &[f64; N], h: f64) -> f64 {
    let mut sum = 0.0;
    let mut i = N;
    while i > 0 {
        i -= 1;
        sum = sum * h + a[i];
    }
    sum
}

/// The parameters of one contact: `kappa = tan^2(alpha) eta`, softness, damping, and the acceleration that
/// something else, as gravity, adds to the compression.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parameters {
    pub kappa: f64,
    pub eta: f64,
    pub c_dis: f64,
    pub load: f64,
}

/// The unknowns of a contact as power series.
///
/// `q = r/l` and `u = l/r` are both carried (each keeps its own relative precision), and so are
/// the velocity `v` and `p = x + c_dis v`, whose zero ends the contact.
/// `depth` is the compression `x` (linear) or `s = sqrt(x)` (viscoelastic).
#[derive(Clone, Debug)]
pub(crate) struct Trajectory<const N: usize> {
    pub depth: [f64; N],
    pub q: [f64; N],
    pub u: [f64; N],
    pub v: [f64; N],
    pub p: [f64; N],
    pub time: [f64; N],
    pub rotation: [f64; N],
}

impl<const N: usize> Trajectory<N> {
    /// The first touch: `x = 0`, `x' = 1`.
    pub fn at_first_touch(c: &Parameters) -> Self {
        let at = |value: f64| {
            let mut series = [0.0; N];
            series[0] = value;
            series
        };
        let (zero, one) = (at(0.0), at(1.0));
        Trajectory {
            depth: zero,
            q: one,
            u: one,
            v: one,
            p: at(c.c_dis),
            time: zero,
            rotation: zero,
        }
    }

    /// Linear spring-dashpot with `dt = q ds`: every right-hand side is a polynomial.
    pub fn expand_linear(&mut self, c: &Parameters) {
        for n in 0..N - 1 {
            let next = 1.0 / (n + 1) as f64;
            let vq = product(&self.v, &self.q, n);
            let force = c.load * self.q[n]
                - c.kappa * product(&self.u, &self.u, n)
                - product(&self.q, &self.p, n);
            self.u[n + 1] = c.eta * product(&self.v, &self.u, n) * next;
            self.q[n + 1] = -c.eta * vq * next;
            self.depth[n + 1] = vq * next;
            self.v[n + 1] = force * next;
            self.p[n + 1] = (vq + c.c_dis * force) * next;
            self.time[n + 1] = self.q[n] * next;
            self.rotation[n + 1] = self.u[n] * next;
        }
    }

    /// Viscoelastic law with `x = s^2` and `dt = 2 s q dsigma`: the root is gone, all is a polynomial.
    pub fn expand_viscoelastic(&mut self, c: &Parameters) {
        let (mut sq, mut su, mut pull) = ([0.0; N], [0.0; N], [0.0; N]);
        for n in 0..N - 1 {
            let next = 1.0 / (n + 1) as f64;
            sq[n] = product(&self.depth, &self.q, n);
            su[n] = product(&self.depth, &self.u, n);
            pull[n] = c.kappa * product(&self.u, &self.u, n) + product(&sq, &self.p, n)
                - c.load * self.q[n];
            let svq = product(&sq, &self.v, n);
            let force = -2.0 * product(&self.depth, &pull, n);
            self.u[n + 1] = 2.0 * c.eta * product(&su, &self.v, n) * next;
            self.q[n + 1] = -2.0 * c.eta * svq * next;
            self.time[n + 1] = 2.0 * sq[n] * next;
            self.rotation[n + 1] = 2.0 * su[n] * next;
            self.depth[n + 1] = product(&self.q, &self.v, n) * next;
            self.v[n + 1] = force * next;
            self.p[n + 1] = (2.0 * svq + c.c_dis * force) * next;
        }
    }

    /// The largest step at which the last two terms of every series are negligible.
    ///
    /// Depth and velocity against the size they reach in this contact; of `v` and `p` only the
    /// one that is carried on, and `p` against its own size, however small it has become.
    pub fn step(&self, longest: f64, tolerance: f64, scale: f64, c: &Parameters) -> f64 {
        let mut h = limit(&self.depth, longest, tolerance, scale);
        h = limit(&self.q, h, tolerance, 0.0);
        h = limit(&self.u, h, tolerance, 0.0);
        if c.c_dis < 1.0 {
            limit(&self.v, h, tolerance, 1.0)
        } else {
            limit(&self.p, h, tolerance, 0.0)
        }
    }

    /// Moves the origin of every series by `h`; only the constant terms are set.
    pub fn advance(&mut self, h: f64) {
        for series in [
            &mut self.depth,
            &mut self.q,
            &mut self.u,
            &mut self.v,
            &mut self.p,
            &mut self.time,
            &mut self.rotation,
        ] {
            series[0] = value(series, h);
        }
    }
}

/// Shortens `h` until the tail of one series is negligible.
fn limit<const N: usize>(series: &[f64; N], mut h: f64, tolerance: f64, scale: f64) -> f64 {
    for _ in 0..40 {
        let (mut power, mut largest, mut last, mut before) = (1.0, scale, 0.0, 0.0);
        let mut i = 0;
        while i < N {
            before = last;
            last = (series[i] * power).abs();
            if last > largest {
                largest = last;
            }
            power *= h;
            i += 1;
        }
        let tail = if last > before { last } else { before };
        if tail <= tolerance * largest {
            return h;
        }
        let shrink = libm::pow(tolerance * largest / tail, 1.0 / N as f64);
        h *= if shrink > 1e-3 { if shrink < 0.98 { shrink } else { 0.98 } } else { 1e-3 };
    }
    h
}
