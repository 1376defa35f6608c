//! How are both answers written? Reads answers; writes CSV, the engine's and the reference's side by side.

use super::case::Case;
use super::engine::Answer;
use anyhow::Result;
use std::io::Write;

/// The engine's answer, nothing if the two stick; and the reference's, outermost nothing if it knows none.
pub type Both = (Option<Answer>, Option<Option<Answer>>);

/// What is said of a row: its name and, but for bad ones, the case with both answers.
pub struct Row<'a> {
    /// The row's name.
    pub id: &'a str,
    /// The case and both answers.
    pub answers: Option<(&'a Case, Both)>,
}

/// Writes the answers as CSV, each number with as many digits as a double needs.
///
/// # Errors
/// An error of `sink`.
pub fn write<'a>(sink: &mut dyn Write, rows: impl IntoIterator<Item = Row<'a>>) -> Result<()> {
    let mut writer = csv::Writer::from_writer(sink);
    let mut head: Vec<String> = ["id", "engine", "reference"].map(str::to_owned).into();
    for name in ["apart", "vn", "vt", "w1", "w2"] {
        head.extend(["engine", "reference"].map(|by| format!("{name}_{by}")));
    }
    head.push("difference".to_owned());
    writer.write_record(&head)?;
    for Row { id, answers } in rows {
        let mut fields = vec![id.to_owned()];
        match answers {
            None => {
                fields.extend(["bad", "bad"].map(str::to_owned));
                fields.extend(std::iter::repeat_n(String::new(), 11));
            }
            Some((case, (engine, reference))) => {
                fields.extend([status(Some(engine)), status(reference)].map(str::to_owned));
                let both = [numbers(engine), numbers(reference.flatten())];
                fields.extend((0..5).flat_map(|k| both.clone().map(|by| by[k].clone())));
                let off = engine.zip(reference.flatten());
                let off = off.map(|(a, b)| format!("{:?}", difference(case, &a, &b)));
                fields.push(off.unwrap_or_default());
            }
        }
        writer.write_record(&fields)?;
    }
    writer.flush()?;
    Ok(())
}

fn status(answer: Option<Option<Answer>>) -> &'static str {
    match answer {
        Some(Some(_)) => "parts",
        Some(None) => "sticks",
        None => "unknown",
    }
}

fn numbers(answer: Option<Answer>) -> [String; 5] {
    answer.map_or_else(Default::default, |answer| {
        let Answer { apart, velocity: [n, t], spins: [a, b] } = answer;
        [apart, n, t, a, b].map(|x| format!("{x:?}"))
    })
}

/// The largest difference of velocities and of spins times radius, in units of the speed of the impact.
fn difference(case: &Case, a: &Answer, b: &Answer) -> f64 {
    let [u, v] = case.velocity;
    let [r, s] = case.pair.radii;
    let off = [
        a.velocity[0] - b.velocity[0],
        a.velocity[1] - b.velocity[1],
        (a.spins[0] - b.spins[0]) * r,
        (a.spins[1] - b.spins[1]) * s,
    ];
    off.iter().fold(0.0_f64, |most, x| most.max(x.abs())) / u.hypot(v)
}
