//! What has a place only where boxes can be sheared? Holds it, or nothing in no memory without the feature `shear`.

/// Something that only a sheared box has. Without the feature `shear` it takes no memory and is never there, and the
/// compiler knows it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct IfSheared<T> {
    #[cfg(feature = "shear")]
    there: Option<T>,
    #[cfg(not(feature = "shear"))]
    never: core::marker::PhantomData<T>,
}

#[cfg(feature = "shear")]
impl<T> IfSheared<T> {
    pub const fn new(there: Option<T>) -> Self {
        Self { there }
    }

    #[inline(always)]
    pub fn get(&self) -> Option<&T> {
        self.there.as_ref()
    }

    #[inline(always)]
    pub fn get_mut(&mut self) -> Option<&mut T> {
        self.there.as_mut()
    }
}

#[cfg(not(feature = "shear"))]
impl<T> IfSheared<T> {
    pub fn new(_: Option<T>) -> Self {
        Self { never: core::marker::PhantomData }
    }

    #[inline(always)]
    pub fn get(&self) -> Option<&T> {
        None
    }

    #[inline(always)]
    pub fn get_mut(&mut self) -> Option<&mut T> {
        None
    }
}
