//! How are arrays of any dimension saved? Reads and writes arrays as lists, which serde knows for any length.

/// One array.
pub mod array {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub fn serialize<T: Serialize, S: Serializer, const D: usize>(
        array: &[T; D],
        to: S,
    ) -> Result<S::Ok, S::Error> {
        array.as_slice().serialize(to)
    }

    pub fn deserialize<'de, T: Deserialize<'de>, S: Deserializer<'de>, const D: usize>(
        from: S,
    ) -> Result<[T; D], S::Error> {
        let list = Vec::<T>::deserialize(from)?;
        let length = list.len();
        list.try_into().map_err(|_| S::Error::invalid_length(length, &"as many as axes"))
    }
}

/// A list of arrays of numbers, one after the other.
pub mod arrays {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub fn serialize<S: Serializer, const D: usize>(
        arrays: &[[f64; D]],
        to: S,
    ) -> Result<S::Ok, S::Error> {
        arrays.as_flattened().serialize(to)
    }

    pub fn deserialize<'de, S: Deserializer<'de>, const D: usize>(
        from: S,
    ) -> Result<Vec<[f64; D]>, S::Error> {
        let list = Vec::<f64>::deserialize(from)?;
        let parts = list.chunks_exact(D);
        if !parts.remainder().is_empty() {
            return Err(S::Error::invalid_length(list.len(), &"a multiple of the axes"));
        }
        Ok(parts.map(|part| std::array::from_fn(|axis| part[axis])).collect())
    }
}
