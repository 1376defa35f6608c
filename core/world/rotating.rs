//! Where do grains that rotate live, and contacts that last? Memory of any kind, and beside it theirs; reads nothing, lends buffers.

use super::storage::{Buffers, Storage};
use crate::scalar::Scalar;
use crate::space::{ContactState, RotationBuffers};

/// Memory for grains that rotate: any other memory, and three rows with a place for each grain.
///
/// The first row is the angular velocities at the start: a number for each grain in two dimensions, `[x, y, z]` in
/// three. The engine works in the other two. Rows are arrays or vectors.
///
/// ```
/// use carom::world::Rotating;
/// use carom::{HeapMemory, Memory};
/// let disks = Rotating::new(Memory::<f32, 2, 32>::new(), [[0.0_f32; 32]; 3]);
/// let spheres = Rotating::new(HeapMemory::<f64, 3>::with_capacity(1000), [(); 3].map(|()| vec![[0.0; 3]; 1000]));
/// ```
/// In one dimension nothing rotates:
///
/// ```compile_fail
/// use carom::law::{HardSphere, Rough, Tangential};
/// use carom::world::Rotating;
/// use carom::{Memory, World};
/// let mut memory = Rotating::new(Memory::<f64, 1, 2>::new(), [[0.0; 2]; 3]);
/// World::builder(&mut memory);
/// ```
#[derive(Clone, Debug)]
pub struct Rotating<M, Row> {
    /// The memory for all else.
    pub memory: M,
    /// Angular velocities, and two rows that the engine works in.
    pub rows: [Row; 3],
}

impl<M, Row> Rotating<M, Row> {
    /// This memory and these rows. Also in a `static`.
    #[must_use]
    pub const fn new(memory: M, rows: [Row; 3]) -> Self {
        Self { memory, rows }
    }
}

impl<S, M, Row> Storage<S, 2> for Rotating<M, Row>
where
    S: Scalar,
    M: Storage<S, 2>,
    Row: AsMut<[S]>,
{
    fn buffers(&mut self) -> Buffers<'_, S, 2> {
        let [velocities, accelerations, sums] = self.rows.each_mut().map(AsMut::as_mut);
        let rotation = RotationBuffers { velocities, accelerations, sums };
        Buffers { rotation, ..self.memory.buffers() }
    }
}

impl<S, M, Row> Storage<S, 3> for Rotating<M, Row>
where
    S: Scalar,
    M: Storage<S, 3>,
    Row: AsMut<[[S; 3]]>,
{
    fn buffers(&mut self) -> Buffers<'_, S, 3> {
        let rows = self.rows.each_mut();
        let [velocities, accelerations, sums] = rows.map(|row| row.as_mut().as_flattened_mut());
        let rotation = RotationBuffers { velocities, accelerations, sums };
        Buffers { rotation, ..self.memory.buffers() }
    }
}

/// Memory with places for contacts that last, where there is friction, or a force law of your own: as many as there
/// can be at once. Disks of one size have at most 3 each, spheres 6, and one more for each plane that they touch.
///
/// ```
/// use carom::space::ContactState;
/// use carom::world::{Rotating, WithContacts};
/// use carom::Memory;
/// let memory = WithContacts::new(Memory::<f32, 2, 32>::new(), [ContactState::<f32>::VACANT; 128]);
/// let heap = Rotating::new(memory, [[0.0_f32; 32]; 3]);
/// ```
#[derive(Clone, Debug)]
pub struct WithContacts<M, C> {
    /// The memory for all else.
    pub memory: M,
    /// An array or a vector of contacts.
    pub contacts: C,
}

impl<M, C> WithContacts<M, C> {
    /// This memory and these places. Also in a `static`.
    #[must_use]
    pub const fn new(memory: M, contacts: C) -> Self {
        Self { memory, contacts }
    }
}

impl<S, M, C, const D: usize> Storage<S, D> for WithContacts<M, C>
where
    S: Scalar,
    M: Storage<S, D>,
    C: AsMut<[ContactState<S>]>,
{
    fn buffers(&mut self) -> Buffers<'_, S, D> {
        Buffers { contacts: self.contacts.as_mut(), ..self.memory.buffers() }
    }
}
