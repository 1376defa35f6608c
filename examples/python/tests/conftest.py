"""What do the tests share? Scenarios, and the program `carom`, made from the same sources."""

import os
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

import carom

ROOT = Path(__file__).resolve().parents[3]
SCENARIOS = ROOT / "host" / "scenarios"

#: A gas that cools: hard grains, all kinds of tables.
GAS = """
title = "a gas"
dimension = 2
duration = 2.0
sample = 0.25
seed = 5

[box]
packing_fraction = 0.2
x = { kind = "periodic" }
y = { kind = "periodic" }

[[material]]
name = "glass"
density = 2500.0
restitution = 0.9

[[species]]
name = "large"
count = 40
radius = 0.02
temperature = 1e-2

[[species]]
name = "small"
count = 120
radius = 0.01
temperature = 1e-2

[observe]
every = 0.01

[observe.profile]
axis = "x"
bins = 10

[observe.pair_distribution]
to = 0.1
"""


@pytest.fixture
def gas() -> carom.World:
    return carom.World(carom.Scenario(GAS))


@pytest.fixture(scope="session")
def program() -> Callable[..., str]:
    """Runs the program `carom` and returns what it prints: that named by CAROM, or else cargo's."""
    cargo = ["cargo", "run", "--quiet", "--release", "-p", "carom-host", "--"]
    command = [os.environ["CAROM"]] if "CAROM" in os.environ else cargo

    def run(*words: str | Path) -> str:
        done = subprocess.run(
            [*command, *map(str, words)], cwd=ROOT, check=True, capture_output=True, text=True
        )
        return done.stdout

    return run
