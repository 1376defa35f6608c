//! How is a world saved and restored? Reads and writes the whole state.

use super::saved_rotation::{NoRotation, SavedRotation};
use super::state::{Progress, World};
use super::statistics::Statistics;
use super::storage::{Buffers, Storage};
use super::{check_rotation, check_snapshot};
use crate::cluster::{Clusters, Settings};
use crate::detect::ScheduledEvent;
use crate::error::Error;
use crate::law::Rule;
use crate::particle::Body;
use crate::resolve::Release;
use crate::scalar::{Clock, Instant, Scalar, Vector};
use crate::space::{ContactState, Grid, SavedBoundary};

/// The whole state of a world but its rule. With the feature `serde` it can be serialised.
///
/// `B` and `Q` hold bodies and scheduled events: slices for saving, anything that owns them for
/// restoring (`heapless::Vec`, `Vec`). A restored world goes on with the same bits.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "S: serde::Serialize, B: serde::Serialize, Q: serde::Serialize, W: serde::Serialize",
        deserialize = "S: serde::Deserialize<'de>, B: serde::Deserialize<'de>, Q: serde::Deserialize<'de>, W: Default + serde::Deserialize<'de>"
    ))
)]
pub struct Snapshot<S: Scalar, const D: usize, B, Q, W = NoRotation<S>> {
    boundary: SavedBoundary<S, D>,
    grid: Option<Grid<S, D>>,
    gravity: Vector<S, D>,
    now: S,
    last_visible: S,
    epoch: Instant,
    release: Release,
    t_c: S,
    settings: Settings<S>,
    settled_gravity: Vector<S, D>,
    clusters: Clusters<S>,
    statistics: Statistics,
    lossy_hops: bool,
    progress: Progress,
    bodies: B,
    events: Q,
    #[cfg_attr(feature = "serde", serde(default))]
    rotation: W,
}

impl<S: Scalar, const D: usize, B, Q, W> Snapshot<S, D, B, Q, W> {
    /// The bodies and the scheduled events.
    #[must_use]
    pub fn arrays(&self) -> (&B, &Q) {
        (&self.bodies, &self.events)
    }

    /// The same state, its bodies and scheduled events kept elsewhere: in memory of one's own.
    ///
    /// ```
    /// use carom::{Grain, Memory, World, law::HardSphere};
    /// let rule = HardSphere { restitution: 0.9 };
    /// let mut memory = Memory::<f32, 1, 1>::new();
    /// let grain = Grain::with_mass(0.5, 1.0).moving([1.0]);
    /// let mut world = World::builder(&mut memory).rule(rule).grain(grain)?.start()?;
    /// let saved = world.save();
    /// let (bodies, events) = saved.arrays();
    /// let (bodies, events) = (bodies.to_vec(), events.to_vec());
    /// let saved = saved.kept_in(bodies, events); // it borrows the world no longer
    /// world.advance_to(1.0)?;
    /// let world = World::restore(&mut memory, rule, &saved)?;
    /// assert_eq!(world.now(), carom::Instant::START);
    /// # Ok::<(), carom::Error>(())
    /// ```
    #[must_use]
    pub fn kept_in<C, P>(self, bodies: C, events: P) -> Snapshot<S, D, C, P> {
        self.all_kept_in(bodies, events, NoRotation::default())
    }

    /// How the grains rotate.
    #[must_use]
    pub fn rotation(&self) -> &W {
        &self.rotation
    }

    /// As [`Snapshot::kept_in`], of grains that rotate: without their [`SavedRotation`] they cannot be restored.
    #[must_use]
    pub fn all_kept_in<C, P, V>(
        self,
        bodies: C,
        events: P,
        rotation: V,
    ) -> Snapshot<S, D, C, P, V> {
        Snapshot {
            boundary: self.boundary,
            grid: self.grid,
            gravity: self.gravity,
            now: self.now,
            last_visible: self.last_visible,
            epoch: self.epoch,
            release: self.release,
            t_c: self.t_c,
            settings: self.settings,
            settled_gravity: self.settled_gravity,
            clusters: self.clusters,
            statistics: self.statistics,
            lossy_hops: self.lossy_hops,
            progress: self.progress,
            bodies,
            events,
            rotation,
        }
    }
}

/// A world's whole state, borrowed from it.
pub type Borrowed<'a, S, const D: usize> = Snapshot<
    S,
    D,
    &'a [Body<S, D>],
    &'a [ScheduledEvent<S>],
    SavedRotation<&'a [S], &'a [ContactState<S>]>,
>;

impl<S: Scalar, const D: usize, R> World<'_, S, D, R> {
    /// The whole state, borrowed.
    #[must_use]
    pub fn save(&self) -> Borrowed<'_, S, D> {
        Snapshot {
            boundary: self.domain.boundary.save(),
            grid: self.particles.cells.grid,
            gravity: *self.domain.gravity(),
            now: self.clock.now,
            last_visible: self.clock.last_visible,
            epoch: self.clock.epoch,
            release: self.parameters.release,
            t_c: self.parameters.t_c,
            settings: self.parameters.settings,
            settled_gravity: self.parameters.settled_gravity,
            clusters: self.clusters,
            statistics: self.statistics,
            lossy_hops: self.parameters.lossy_hops,
            progress: self.progress,
            bodies: &*self.particles.bodies,
            events: &*self.queue.events,
            rotation: SavedRotation {
                velocities: &*self.particles.rotation.velocities,
                accelerations: &*self.particles.rotation.accelerations,
                contacts: &*self.particles.contacts.0,
            },
        }
    }
}

impl<'m, S: Scalar, const D: usize, R: Rule<S>> World<'m, S, D, R> {
    /// Restores a saved world with this rule in this memory.
    ///
    /// # Errors
    /// [`Error::Full`] if the memory is too small, [`Error::Input`] if the state is not that of a world.
    pub fn restore<B, Q, V, C>(
        memory: &'m mut impl Storage<S, D>,
        rule: R,
        saved: &Snapshot<S, D, B, Q, SavedRotation<V, C>>,
    ) -> Result<Self, Error>
    where
        B: AsRef<[Body<S, D>]>,
        Q: AsRef<[ScheduledEvent<S>]>,
        V: AsRef<[S]>,
        C: AsRef<[ContactState<S>]>,
    {
        Self::restore_with(memory.buffers(), rule, saved)
    }

    /// As [`World::restore`], in arrays that are already lent.
    ///
    /// # Errors
    /// As [`World::restore`].
    pub fn restore_with<B, Q, V, C>(
        buffers: Buffers<'m, S, D>,
        rule: R,
        saved: &Snapshot<S, D, B, Q, SavedRotation<V, C>>,
    ) -> Result<Self, Error>
    where
        B: AsRef<[Body<S, D>]>,
        Q: AsRef<[ScheduledEvent<S>]>,
        V: AsRef<[S]>,
        C: AsRef<[ContactState<S>]>,
    {
        let (bodies, events) = (saved.bodies.as_ref(), saved.events.as_ref());
        let planes = [saved.boundary.planes.len(), buffers.obstacles.facets().len()];
        check_snapshot::check(bodies, events, saved.now, planes)?;
        check_snapshot::check_clusters(&saved.clusters, saved.now)?;
        check_snapshot::check_statistics(&saved.statistics)?;
        check_snapshot::check_mode(rule.enduring(), saved.settings.enduring)?;
        let builder = World::builder_with(buffers).rule(rule);
        let mut builder =
            bodies.iter().try_fold(builder, |builder, body| match body.is_vacant() {
                true => builder.reserve(1),
                false => builder.grain(body.as_grain()),
            })?;
        if !builder.boundary.restore(&saved.boundary) {
            return Err(builder.too_many_planes());
        }
        (builder.gravity, builder.settings) = (saved.gravity, saved.settings);
        builder.shear = saved.boundary.shear;
        check_rotation::saved::<S, D>(&saved.rotation, builder.rule.inertia(), bodies.len())?;
        let mut world = builder.release(saved.release).tc(saved.t_c).build()?;
        check_snapshot::check_obstacles(&world.domain.boundary, &saved.boundary)?;
        world.take_over(saved)?;
        Ok(world)
    }
}

impl<S: Scalar, const D: usize, R> World<'_, S, D, R> {
    /// Takes over what a builder does not ask for.
    fn take_over<B, Q, V, C>(
        &mut self,
        saved: &Snapshot<S, D, B, Q, SavedRotation<V, C>>,
    ) -> Result<(), Error>
    where
        B: AsRef<[Body<S, D>]>,
        Q: AsRef<[ScheduledEvent<S>]>,
        V: AsRef<[S]>,
        C: AsRef<[ContactState<S>]>,
    {
        let bodies = saved.bodies.as_ref();
        self.particles.bodies.copy_from_slice(bodies);
        self.particles.supported = bodies.iter().filter(|body| body.is_supported()).count();
        self.parameters.lossy_hops = saved.lossy_hops;
        self.parameters.settings = saved.settings;
        self.parameters.settled_gravity = saved.settled_gravity;
        self.clusters = saved.clusters;
        self.clusters.relink(self.particles.bodies);
        let Snapshot { now, last_visible, epoch, .. } = *saved;
        self.clock = Clock { now, last_visible, epoch };
        self.domain.boundary.set_epoch(saved.epoch);
        self.particles.restore_cells(saved.grid, &self.domain, saved.now)?;
        (self.statistics, self.progress) = (saved.statistics, saved.progress);
        self.queue.events.copy_from_slice(saved.events.as_ref());
        self.queue.rebuild();
        let rotation = &mut self.particles.rotation;
        rotation.velocities.copy_from_slice(saved.rotation.velocities.as_ref());
        rotation.accelerations.copy_from_slice(saved.rotation.accelerations.as_ref());
        self.particles.contacts.restore(saved.rotation.contacts.as_ref())
    }
}
