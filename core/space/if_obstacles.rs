//! What has a place only where there can be obstacles? Holds it, or nothing in no memory without the feature `obstacles`.

/// Something that only a world with obstacles has. Without the feature `obstacles` it takes no memory and is never
/// there, and the compiler knows it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct IfObstacles<T> {
    #[cfg(feature = "obstacles")]
    there: Option<T>,
    #[cfg(not(feature = "obstacles"))]
    never: core::marker::PhantomData<T>,
}

#[cfg(feature = "obstacles")]
impl<T> IfObstacles<T> {
    pub const fn new(there: Option<T>) -> Self {
        Self { there }
    }

    #[inline(always)]
    pub fn get(&self) -> Option<&T> {
        self.there.as_ref()
    }

    pub fn get_mut(&mut self) -> Option<&mut T> {
        self.there.as_mut()
    }
}

#[cfg(not(feature = "obstacles"))]
impl<T> IfObstacles<T> {
    pub fn new(_: Option<T>) -> Self {
        Self { never: core::marker::PhantomData }
    }

    #[inline(always)]
    pub fn get(&self) -> Option<&T> {
        None
    }

    pub fn get_mut(&mut self) -> Option<&mut T> {
        None
    }
}
