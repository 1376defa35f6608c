//! What are the Taylor coefficients of the next step? Reads the state of a contact; writes its power series in the step variable.

/// Order of the power series.
pub(crate) const ORDER: usize = 24;
/// Coefficients of a power series in the step variable, lowest first.
pub(crate) type Series = [f64; ORDER + 1];

/// Coefficient `n` of the product of two series (Cauchy).
#[inline]
pub(crate) fn product(a: &Series, b: &Series, n: usize) -> f64 {
    a[..=n].iter().zip(b[..=n].iter().rev()).map(|(x, y)| x * y).sum()
}

/// The value of a series at `h` (Horner).
pub(crate) fn value(a: &Series, h: f64) -> f64 {
    a.iter().rev().fold(0.0, |sum, c| sum * h + c)
}

/// The constants of one contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Constants {
    pub kappa: f64,
    pub eta: f64,
    pub c_dis: f64,
}

/// The unknowns of a contact as power series.
///
/// `q = r/l` and `u = l/r` are both carried (each keeps its own relative precision), and so are
/// the velocity `v` and `p = x + c_dis v`, whose zero ends the contact.
/// `depth` is the compression `x` (linear) or `s = sqrt(x)` (viscoelastic).
#[derive(Clone, Debug)]
pub(crate) struct Path {
    pub depth: Series,
    pub q: Series,
    pub u: Series,
    pub v: Series,
    pub p: Series,
    pub time: Series,
    pub sweep: Series,
}

impl Path {
    /// The first touch: `x = 0`, `x' = 1`.
    pub fn touch(c: &Constants) -> Self {
        let at = |value: f64| {
            let mut series = [0.0; ORDER + 1];
            series[0] = value;
            series
        };
        let (zero, one) = (at(0.0), at(1.0));
        Path { depth: zero, q: one, u: one, v: one, p: at(c.c_dis), time: zero, sweep: zero }
    }

    /// Linear spring-dashpot with `dt = q ds`: every right-hand side is a polynomial.
    pub fn expand_linear(&mut self, c: &Constants) {
        for n in 0..ORDER {
            let next = 1.0 / (n + 1) as f64;
            let vq = product(&self.v, &self.q, n);
            let force = -c.kappa * product(&self.u, &self.u, n) - product(&self.q, &self.p, n);
            self.u[n + 1] = c.eta * product(&self.v, &self.u, n) * next;
            self.q[n + 1] = -c.eta * vq * next;
            self.depth[n + 1] = vq * next;
            self.v[n + 1] = force * next;
            self.p[n + 1] = (vq + c.c_dis * force) * next;
            self.time[n + 1] = self.q[n] * next;
            self.sweep[n + 1] = self.u[n] * next;
        }
    }

    /// Viscoelastic law with `x = s^2` and `dt = 2 s q dsigma`: the root is gone, all is a polynomial.
    pub fn expand_viscoelastic(&mut self, c: &Constants) {
        let (mut x, mut sv, mut uu, mut qp) =
            ([0.0; ORDER + 1], [0.0; ORDER + 1], [0.0; ORDER + 1], [0.0; ORDER + 1]);
        for n in 0..ORDER {
            let next = 1.0 / (n + 1) as f64;
            x[n] = product(&self.depth, &self.depth, n);
            sv[n] = product(&self.depth, &self.v, n);
            uu[n] = product(&self.u, &self.u, n);
            qp[n] = product(&self.q, &self.p, n);
            let svq = product(&sv, &self.q, n);
            let force = -2.0 * (c.kappa * product(&self.depth, &uu, n) + product(&x, &qp, n));
            self.u[n + 1] = 2.0 * c.eta * product(&sv, &self.u, n) * next;
            self.q[n + 1] = -2.0 * c.eta * svq * next;
            self.time[n + 1] = 2.0 * product(&self.depth, &self.q, n) * next;
            self.sweep[n + 1] = 2.0 * product(&self.depth, &self.u, n) * next;
            self.depth[n + 1] = product(&self.q, &self.v, n) * next;
            self.v[n + 1] = force * next;
            self.p[n + 1] = (2.0 * svq + c.c_dis * force) * next;
        }
    }

    /// The largest step at which the last two terms of every series are below `tolerance` of its largest term.
    pub fn step(&self, longest: f64, tolerance: f64) -> f64 {
        let mut h = longest;
        for series in [&self.depth, &self.q, &self.u, &self.v, &self.p] {
            h = limit(series, h, tolerance);
        }
        h
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
            &mut self.sweep,
        ] {
            series[0] = value(series, h);
        }
    }
}

/// Shortens `h` until the tail of one series is negligible.
fn limit(series: &Series, mut h: f64, tolerance: f64) -> f64 {
    for _ in 0..40 {
        let (mut power, mut largest, mut last, mut before) = (1.0, 0.0_f64, 0.0, 0.0);
        for a in series {
            before = last;
            last = (a * power).abs();
            largest = largest.max(last);
            power *= h;
        }
        let tail = last.max(before);
        if !(tail > tolerance * largest) && largest.is_finite() {
            return h;
        }
        let shrink = if tail.is_finite() && largest.is_finite() {
            libm::pow(tolerance * largest / tail, 1.0 / ORDER as f64)
        } else {
            1e-3
        };
        h *= shrink.clamp(1e-3, 0.98);
    }
    h
}
