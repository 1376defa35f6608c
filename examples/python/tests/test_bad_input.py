"""Does everything that is wrong get an exception that says what is wrong, in the program's words?"""

import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import carom
from conftest import GAS

WRONG = GAS.replace("restitution = 0.9", "restitution = 1.5")


def test_the_words_are_the_programs(program: Callable[..., str], tmp_path: Path) -> None:
    file = tmp_path / "wrong.toml"
    file.write_text(WRONG)
    with pytest.raises(subprocess.CalledProcessError) as failed:
        program("run", file, "--out", tmp_path / "out")
    with pytest.raises(carom.ScenarioError) as refused:
        carom.Scenario.read(file)
    assert failed.value.stderr == f"carom: {refused.value}\n"
    assert str(refused.value).endswith("material 0: restitution is 1.5, must be from 0 to 1")


def test_all_problems_are_there() -> None:
    text = WRONG.replace("sample = 0.25", "sample = -0.25")
    problems = carom.Scenario.check(text)
    assert [problem.field for problem in problems] == ["sample", "material.0.restitution"]
    assert text.splitlines()[problems[0].line - 1] == "sample = -0.25"
    with pytest.raises(carom.ScenarioError, match=r"sample is -0.25, must be .*\(1 more\)") as refused:
        carom.Scenario(text)
    assert [problem.message for problem in refused.value.problems] == [
        problem.message for problem in problems
    ]
    assert carom.Scenario.check(GAS) == []


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "no grains|missing|dimension"),
        ("dimension = ", "line 1: "),
        (GAS.replace("duration", "duratoin"), "duratoin.*duration"),
        (GAS.replace("radius = 0.02", 'radius = 0.02\nmaterial = "steel"'), "steel"),
        (GAS.replace('axis = "x"', 'axis = "w"'), "w"),
    ],
)
def test_bad_text(text: str, words: str) -> None:
    with pytest.raises(carom.ScenarioError, match=words):
        carom.Scenario(text)


def test_what_the_box_cannot_hold() -> None:
    scenario = carom.Scenario(GAS.replace("packing_fraction = 0.2", "packing_fraction = 0.95"))
    with pytest.raises(carom.ScenarioError) as refused:
        carom.World(scenario)
    assert len(refused.value.problems) == 1


def test_what_cannot_be_measured() -> None:
    with pytest.raises(carom.ScenarioError, match="observe.profile.axis is z, but dimension is 2"):
        carom.World(carom.Scenario(GAS.replace('axis = "x"', 'axis = "z"')))


def test_files() -> None:
    with pytest.raises(FileNotFoundError, match=r"cannot read nowhere\.toml"):
        carom.Scenario.read("nowhere.toml")
    with pytest.raises(IsADirectoryError):
        carom.Scenario.read("/")


def test_methods() -> None:
    scenario = carom.Scenario(GAS)
    assert scenario.methods == ["emd"]
    with pytest.raises(ValueError, match='method is "verlet", must be md, md-exact, emd or emd'):
        carom.World(scenario, "verlet")
    with pytest.raises(carom.ScenarioError, match="MD needs a force law, but law.kind is constant"):
        carom.World(scenario, "md")


@pytest.mark.parametrize("bad", [float("nan"), float("inf"), -1.0])
def test_times_that_are_none(bad: float, gas: carom.World) -> None:
    gas.advance_to(0.1)
    digest = gas.digest
    with pytest.raises(carom.SimulationError):
        gas.advance_to(bad)
    assert gas.digest == digest and gas.time == 0.1
    gas.advance_to(0.2)


def test_states_that_are_none(gas: carom.World) -> None:
    state = gas.save()
    for bad in [b"", b"nothing", state[: len(state) // 2]]:
        with pytest.raises((carom.SimulationError, carom.ScenarioError)):
            carom.World.restore(bad)


def test_what_is_not_measured(gas: carom.World) -> None:
    with pytest.raises(carom.SimulationError, match="nothing was measured yet"):
        _ = gas.observed
    without = carom.World(carom.Scenario(GAS.split("[observe]")[0]))
    with pytest.raises(carom.SimulationError, match=re.escape("no [observe]")):
        _ = without.observed


FIELDS: dict[str, Any] = {
    "dimension": 1,
    "duration": 1,
    "sample": 0.5,
    "gravity": None,
    "law": {"kind": "constant", "restitution": 0.5},
    "grain": [{"radius": 0.1, "mass": 1.0, "at": [0.0]}],
}


def test_dictionaries() -> None:
    grain = {"radius": np.float64(0.1), "mass": np.int64(1), "at": np.array([1.0])}
    scenario = carom.Scenario.from_dict({**FIELDS, "grain": [FIELDS["grain"][0], grain]})
    assert len(carom.World(scenario)) == 2
    assert carom.Scenario(scenario.text).dimension == 1


@pytest.mark.parametrize(
    ("field", "value", "error", "words"),
    [
        ("dimension", 4, carom.ScenarioError, "^dimension is 4, must be 1, 2 or 3$"),
        ("dimension", 2**80, ValueError, "dimension is .*, which is too large"),
        ("dimension", object(), TypeError, "dimension is a object, must be"),
        ("sample", float("nan"), carom.ScenarioError, "sample is NaN"),
        ("grains", [], carom.ScenarioError, "grains.*grain"),
        ("law", {1: 2}, TypeError, "law: keys must be words"),
    ],
)
def test_bad_dictionaries(field: str, value: Any, error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words):
        carom.Scenario.from_dict({**FIELDS, field: value})
