"""Is a run from Python the same, to the last bit, as one from Rust?"""

import json
import pickle
from collections.abc import Callable
from pathlib import Path

import pytest

import carom
from conftest import GAS, SCENARIOS


def from_rust(program: Callable[..., str], scenario: Path, method: str, out: Path) -> int:
    words = ["run", scenario, "--method", method, "--json", "--out", out]
    run = json.loads(program(*words))["runs"][0]
    return int(run["digest"], 16)


@pytest.mark.parametrize("how", ["run", "samples", "advance", "step", "saved"])
def test_the_same_digest_as_from_rust(
    how: str, program: Callable[..., str], tmp_path: Path
) -> None:
    file = tmp_path / "gas.toml"
    file.write_text(GAS)
    world = carom.World(carom.Scenario.read(file))
    match how:
        case "run":
            world.run()
        case "samples":
            assert list(world.samples()) == [0.25 * k for k in range(9)]
        case "advance":
            for k in range(1, 8):
                world.advance_to(0.27 * k)
            world.advance_by(2.0 - world.time)
        case "step":
            assert world.step(1000) and 0.0 < world.time < 2.0
            world.run()
        case "saved":
            world.advance_to(0.7)
            world = pickle.loads(pickle.dumps(world))
            assert world.time == 0.7
            world.run()
    assert world.time == 2.0
    assert world.digest == from_rust(program, file, "emd", tmp_path / "out")


@pytest.mark.parametrize(("name", "method"), [("fig6", "emd*"), ("column", "emd"), ("beads", "emd*")])
def test_the_papers_scenarios_have_the_same_digest(
    name: str, method: str, program: Callable[..., str], tmp_path: Path
) -> None:
    file = SCENARIOS / f"{name}.toml"
    world = carom.World(carom.Scenario.read(file), method)
    world.run()
    assert world.digest == from_rust(program, file, method, tmp_path)


def test_what_is_measured_is_what_the_program_writes(
    program: Callable[..., str], tmp_path: Path
) -> None:
    import polars

    file = tmp_path / "gas.toml"
    file.write_text(GAS)
    program("run", file, "--out", tmp_path)
    world = carom.World(carom.Scenario.read(file))
    world.run()
    assert set(world.observed) == {"averages", "blocks", "profile", "pair-distribution"}
    for name, table in world.observed.items():
        written = polars.read_parquet(tmp_path / f"emd-{name}.parquet")
        assert table.to_polars().equals(written, null_equal=True), name
