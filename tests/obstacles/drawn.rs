//! Can any obstacles break the engine? Random bytes through the body that fuzzing hammers.

#[path = "../fuzz/body/input.rs"]
#[allow(dead_code, reason = "worlds from bytes use more of it")]
mod input;
#[path = "../fuzz/body/mesh.rs"]
mod mesh;

use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn nobody_leaks_or_hangs_among_drawn_obstacles(bytes in prop::collection::vec(any::<u8>(), 40..240)) {
        let _ = mesh::run(&bytes);
    }
}
