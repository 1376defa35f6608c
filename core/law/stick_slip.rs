//! What do the surfaces of a stiff contact come to? Reads its normal force over time, spring and friction; writes the impulse.
//!
//! Surfaces stick, and a linear spring between them swings, or they slide, and friction slows them. Both are known in
//! closed form, but for the normal force, which is read from a [`History`](carom_tables::read::History); where one
//! ends and the other begins is searched for. So there is no table of β: it has edges, which no polynomial follows.

use super::rule::{Impact, Rule};
use super::tangential::Tangential;
use crate::scalar::Scalar;
use carom_tables::read::Compression;

/// Where the search looks for the next change.
const PHASES: u16 = 64;
/// More changes than any contact has whose spring swings as slowly as [`Grip::impulse`] allows.
const MAX_CHANGES: usize = 64;

/// What holds two surfaces, in the scales of the contact: times in T, and the sliding at the touch is 1.
pub(crate) struct Grip<S> {
    /// The frequency (k_t/m_t)^½ T of the spring across the normal, with 1/m_t = (1 + 1/q)/m_eff.
    pub frequency: S,
    /// μ m_eff v_n/(m_t g_t): what friction can do in units of what there is to stop.
    pub friction: S,
}

/// Surfaces at an instant.
#[derive(Clone, Copy)]
struct Moment<S> {
    phase: S,
    /// How fast they slide.
    sliding: S,
    /// How long the spring is.
    spring: S,
}

impl<S: Scalar> Grip<S> {
    /// 1 + β: the impulse in units of m_t g_t. None for a spring that swings more than four times in the contact.
    pub fn impulse(&self, contact: &Compression<S>) -> Option<S> {
        if !(self.frequency * contact.duration <= S::from_f32(24.0)) {
            return None;
        }
        let mut now = Moment { phase: S::zero(), sliding: S::one(), spring: S::zero() };
        for _ in 0..MAX_CHANGES / 2 {
            now = self.stick(contact, now);
            if now.phase < S::one() {
                now = self.slide(contact, now);
            }
            if !(now.phase < S::one()) {
                return Some(S::one() - now.sliding);
            }
        }
        None
    }

    /// Until friction no longer holds the spring.
    fn stick(&self, contact: &Compression<S>, from: Moment<S>) -> Moment<S> {
        let (w, begin) = (self.frequency, contact.time(from.phase));
        let at = |phase: S| {
            let (sin, cos) = (w * (contact.time(phase) - begin)).sin_cos();
            Moment {
                phase,
                sliding: from.sliding * cos - w * from.spring * sin,
                spring: from.spring * cos + from.sliding / w * sin,
            }
        };
        at(next(from.phase, |phase| self.longest(contact, phase) - at(phase).spring.abs()))
    }

    /// Until the spring that friction can hold grows faster than surfaces slide.
    fn slide(&self, contact: &Compression<S>, from: Moment<S>) -> Moment<S> {
        let forward = if from.spring == S::zero() { from.sliding } else { from.spring };
        let sign = if forward < S::zero() { -S::one() } else { S::one() };
        let begin = contact.rate(from.phase);
        let at = |phase: S| from.sliding - sign * self.friction * (begin - contact.rate(phase));
        let aside = S::from_f64(1.0 / 256.0);
        let phase = next(from.phase, |phase| {
            // Per unit of phase: the slope of the force over time has no bound at the touch.
            let pace = contact.duration * S::from_f32(6.0) * phase * (S::one() - phase);
            let [before, after] = [(phase - aside).max(S::zero()), (phase + aside).min(S::one())];
            let growth = self.longest(contact, after) - self.longest(contact, before);
            sign * at(phase) * pace - growth / (after - before)
        });
        Moment { phase, sliding: at(phase), spring: sign * self.longest(contact, phase) }
    }

    /// The longest spring that friction holds.
    fn longest(&self, contact: &Compression<S>, phase: S) -> S {
        self.friction * contact.force(phase) / (self.frequency * self.frequency)
    }
}

/// The first phase after this one at which `rest` is below zero; the last one if it never is. What begins here goes on
/// for a little, however rounding sees it.
fn next<S: Scalar>(from: S, rest: impl Fn(S) -> S) -> S {
    let phases = S::from_count(u32::from(PHASES));
    let mut low = (from + S::from_f64(1.0 / 1024.0)).min(S::one());
    let first = (low * phases).floor().to_count() + 1;
    // The last two values: between them it may have been below zero and is above again.
    let mut before = [S::NEVER; 2];
    for k in first..=u32::from(PHASES) {
        let high = S::from_count(k) / phases;
        let at_high = rest(high);
        let lowest = lowest([before[0], before[1], at_high]).map(|step| low + step / phases);
        if let Some(between) = lowest.filter(|_| k > first + 1) {
            let there = rest(between);
            if there < S::zero() {
                let begin = if between < low { low - S::one() / phases } else { low };
                return change([begin, between], there, rest);
            }
        }
        if at_high < S::zero() {
            return change([low, high], at_high, rest);
        }
        (low, before) = (high, [before[1], at_high]);
    }
    S::one()
}

/// Where a parabola through three values, one step apart, is the lowest, in steps from the one in the middle; none if that
/// is not the smallest of the three.
fn lowest<S: Scalar>([a, b, c]: [S; 3]) -> Option<S> {
    let bend = (a - b) + (c - b);
    (b < a && b < c && bend.is_finite()).then(|| (a - c) * S::half() / bend)
}

/// Where `rest` falls below zero between these two, by the Illinois rule; where it begins, if it is below zero there.
fn change<S: Scalar>([mut low, mut high]: [S; 2], mut at_high: S, rest: impl Fn(S) -> S) -> S {
    let mut at_low = rest(low);
    if !(at_low > S::zero()) {
        return low;
    }
    // The end that stays again counts half.
    let (mut stayed_low, mut stayed_high) = (false, false);
    for _ in 0..10 {
        let middle = low + (high - low) * (at_low / (at_low - at_high));
        let here = rest(middle);
        if here < S::zero() {
            (high, at_high) = (middle, here);
            at_low *= if stayed_low { S::half() } else { S::one() };
            (stayed_low, stayed_high) = (true, false);
        } else {
            (low, at_low) = (middle, here);
            at_high *= if stayed_high { S::half() } else { S::one() };
            (stayed_low, stayed_high) = (false, true);
        }
    }
    high
}

/// What is known of the contact of two rough surfaces before it begins.
pub(crate) struct SurfaceContact<S> {
    /// In units of R₁ + R₂, how far apart the centres are while it lasts: the mean, as the normal force weighs it.
    pub distance: S,
    course: Option<(S, Compression<S>)>,
}

impl<S: Scalar> SurfaceContact<S> {
    /// None where the contact has to be integrated.
    pub fn new(rule: &impl Rule<S>, impact: &Impact<S>) -> Option<Self> {
        if rule.tangential(impact.materials).is_none() {
            return Some(Self { distance: S::one(), course: None });
        }
        let (time, contact) = rule.course(impact)?;
        let softness = time * impact.normal_speed / impact.contact_distance;
        let distance = S::one() - softness * contact.mean_overlap();
        Some(Self { distance, course: Some((time, contact)) })
    }

    /// m_t (1 + β) in units of m_eff, where surfaces slide so fast: their impulse over m_eff g_t. 1/m_t is
    /// (1 + a²/q)/m_eff, the centres being a (R₁ + R₂) apart.
    pub fn impulse(&self, rule: &impl Rule<S>, impact: &Impact<S>, sliding: S) -> Option<S> {
        let (Some(q), Some(law), Some((time, contact))) =
            (rule.inertia(), rule.tangential(impact.materials), &self.course)
        else {
            return Some(S::zero());
        };
        let share = q / (q + self.distance * self.distance);
        let normal = impact.normal_speed / (share * sliding);
        Some(share * part(&law, (impact, share), normal, (*time, contact))?)
    }
}

/// 1 + β, the impulse of the spring in units of m_t g_t included; `normal` is m_eff v_n/(m_t g_t).
fn part<S: Scalar>(
    law: &Tangential<S>,
    (impact, share): (&Impact<S>, S),
    normal: S,
    (time, contact): (S, &Compression<S>),
) -> Option<S> {
    match *law {
        Tangential::Constant { .. } | Tangential::Walton { .. } => {
            Some(law.impulse((S::one() - contact.rate(S::one())) * normal))
        }
        Tangential::Spring { mu, stiffness, damping } if damping == S::zero() => {
            let swing = (share * impact.reduced_mass).sqrt_of_ratio(stiffness);
            Grip { frequency: time / swing, friction: mu * normal }.impulse(contact)
        }
        Tangential::Spring { .. } => None,
    }
}
