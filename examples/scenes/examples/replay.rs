//! Which digests does this machine get? Reads the number of events, or a scene, a scalar and a range of events; writes lines.
//!
//! `replay 100000` prints `scene scalar events digest` after each thousand events of every scene;
//! `replay box16 f32 2000 3000` prints it after each event of that range.

use std::error::Error;

use carom::scalar::I32F32;
use carom_scenes::replay::{Selection, replay};
use carom_scenes::{EventDigest, Scene};

fn scalar(name: &str, scene: Scene, selection: Selection) -> Result<(), Box<dyn Error>> {
    let mut report = |EventDigest { event, digest }: EventDigest| {
        println!("{} {name} {event} {digest:016x}", scene.name());
    };
    match name {
        "f32" => replay::<f32>(scene)(selection, &mut report)?,
        "f64" => replay::<f64>(scene)(selection, &mut report)?,
        "I32F32" => replay::<I32F32>(scene)(selection, &mut report)?,
        _ => return Err(format!("{name}: the scalars are f32, f64, I32F32").into()),
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    if let [scene, name, from, last] = words.as_slice() {
        let scene = Scene::ALL.into_iter().find(|s| s.name() == scene).ok_or("no such scene")?;
        return scalar(name, scene, Selection::each(from.parse()?, last.parse()?));
    }
    let last = words.first().map_or(Ok(10_000), |word| word.parse())?;
    for scene in Scene::ALL {
        for name in ["f32", "f64", "I32F32"] {
            scalar(name, scene, Selection::every_thousandth(last))?;
        }
    }
    Ok(())
}
