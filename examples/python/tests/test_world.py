"""Does a world do what it says: arrays, time, threads, Ctrl-C?"""

import copy
import gc
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
import weakref

import numpy as np
import pytest

import carom
from conftest import GAS, SCENARIOS

ONE = """
dimension = 3
duration = 1.0
sample = 0.5
[law]
kind = "constant"
restitution = 1.0
[[grain]]
radius = 0.1
mass = 2.0
at = [0.0, 1.0, 2.0]
moving = [1.0, 0.0, -1.0]
"""

#: A gas that goes on for long.
LONG = GAS.replace("duration = 2.0", "duration = 1e6").replace("sample = 0.25", "sample = 1e3").replace(
    "restitution = 0.9", "restitution = 1.0"
).split("[observe]")[0]


def test_arrays_follow_the_world() -> None:
    world = carom.World(carom.Scenario(ONE))
    places, speeds = world.positions, world.velocities
    assert places.dtype == np.float64 and places.shape == (1, 3)
    assert places.tolist() == [[0.0, 1.0, 2.0]]
    before = places.copy()
    world.advance_to(0.5)
    assert places.tolist() == [[0.5, 1.0, 1.5]] and before.tolist() == [[0.0, 1.0, 2.0]]
    assert world.positions is places and world.velocities is speeds
    assert speeds.tolist() == [[1.0, 0.0, -1.0]]
    with pytest.raises(ValueError, match="read-only"):
        places[0, 0] = 1.0


def test_arrays_outlive_their_world() -> None:
    world = carom.World(carom.Scenario(ONE))
    places = world.positions
    world.advance_to(0.25)
    del world
    gc.collect()
    assert places.tolist() == [[0.25, 1.0, 1.75]]


def test_worlds_go_when_nobody_holds_them() -> None:
    before = threading.active_count()
    for _ in range(200):
        carom.World(carom.Scenario(GAS)).advance_to(0.01)
    assert threading.active_count() == before


def test_energy_is_that_of_the_arrays(gas: carom.World) -> None:
    gas.advance_to(1.0)
    energy = 0.5 * np.sum(gas.masses[:, None] * gas.velocities**2)
    assert gas.kinetic_energy == pytest.approx(energy, rel=1e-14)
    assert len(gas) == 160 and gas.collisions == gas.statistics["collisions"] > 100
    assert gas.species_names == ["large", "small"]
    assert np.bincount(gas.species).tolist() == [40, 120]
    assert np.all(gas.radii[gas.species == 0] == 0.02)
    assert sum(gas.motions.values()) == 160


def test_every_method_goes_the_same_way() -> None:
    fig6 = carom.Scenario.read(SCENARIOS / "fig6.toml")
    ends = {}
    for method in ["md", "md-exact", "emd*"]:
        world = carom.World(fig6, method)
        world.advance_to(0.3 * fig6.sample * 10)
        ends[method] = world.positions.copy()
        assert (world.digest is None) == method.startswith("md") and world.method == method
    assert np.allclose(ends["md-exact"], ends["emd*"], atol=1e-3)
    assert np.allclose(ends["md-exact"], ends["md"], atol=1e-3)


def test_steps_are_events() -> None:
    two = ONE + "[[grain]]\nradius = 0.1\nmass = 2.0\nat = [1.2, 1.0, 2.0]\nmoving = [0.0, 0.0, -1.0]"
    world = carom.World(carom.Scenario(two))
    while world.collisions == 0:
        assert world.step()
    assert world.time == pytest.approx(1.0, abs=1e-12)
    assert world.velocities.tolist() == [[0.0, 0.0, -1.0], [1.0, 0.0, -1.0]]
    alone = carom.World(carom.Scenario(ONE))
    assert not alone.step() and alone.time == 0.0


def test_a_copy_goes_on_by_itself(gas: carom.World) -> None:
    gas.advance_to(0.5)
    other = copy.deepcopy(gas)
    other.advance_to(1.0)
    assert gas.time == 0.5 and gas.digest != other.digest
    gas.advance_to(1.0)
    assert gas.digest == other.digest


@pytest.mark.parametrize("method", ["md", "md-exact"])
def test_runs_by_forces_can_be_copied(method: str) -> None:
    soft = 'law = { kind = "lsd", stiffness = 1e4, damping = 1.0 }'
    scenario = carom.Scenario(GAS.replace("restitution = 0.9", soft))
    world = carom.World(scenario, method)
    world.advance_to(0.1)
    other = copy.deepcopy(world)
    for each in (world, other):
        each.advance_to(0.15)
    assert other.positions.tolist() == world.positions.tolist() and world.collisions > 0


def digest_in_a_child(state: bytes) -> int | None:
    world = carom.World.restore(state)
    world.advance_to(1.0)
    return world.digest


@pytest.mark.parametrize("how", ["fork", "spawn"])
def test_worlds_work_in_other_processes(how: str, gas: carom.World) -> None:
    gas.advance_to(0.5)
    with multiprocessing.get_context(how).Pool(2) as pool:
        digests = pool.map(digest_in_a_child, [gas.save()] * 3)
    gas.advance_to(1.0)
    assert digests == [gas.digest] * 3


def test_a_forked_world_goes_on() -> None:
    world = carom.World(carom.Scenario(GAS))
    world.advance_to(0.5)
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        world.advance_to(1.0)
        os.write(writer, str(world.digest).encode())
        os._exit(0)
    os.waitpid(child, 0)
    world.advance_to(1.0)
    assert os.read(reader, 99).decode() == str(world.digest)


def test_other_threads_go_on_meanwhile() -> None:
    """Python counts while the world computes: it could not if the lock were held."""
    world = carom.World(carom.Scenario(LONG))
    stopped = threading.Event()
    failures: list[BaseException] = []

    def run() -> None:
        try:
            while not stopped.is_set():
                world.step(10_000)
        except BaseException as why:
            failures.append(why)

    thread = threading.Thread(target=run)
    thread.start()
    refused = 0
    while refused < 3 and thread.is_alive():
        try:
            _ = world.time
        except carom.SimulationError as why:
            assert str(why) == "this world is at work in another thread"
            refused += 1
    stopped.set()
    thread.join()
    assert refused == 3
    # Whoever was refused while the other one computed was heard without its lock.
    assert all("at work" in str(why) for why in failures)


def test_many_worlds_at_once() -> None:
    worlds = [carom.World(carom.Scenario(GAS)) for _ in range(8)]
    threads = [threading.Thread(target=world.advance_to, args=(1.0,)) for world in worlds]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len({world.digest for world in worlds}) == 1


INTERRUPTED = """
import carom, sys
world = carom.World(carom.Scenario(sys.stdin.read()))
places = world.positions
print("begun", flush=True)
try:
    world.run()
except KeyboardInterrupt:
    assert world.time > 0.0
    assert (places != carom.World(world.scenario).positions).all()
    whole = carom.World(world.scenario)
    end = world.time + 0.01
    whole.advance_to(end)
    world.advance_to(end)
    assert world.digest == whole.digest
    print("stopped")
"""


def test_control_c_stops_a_run_that_can_go_on() -> None:
    child = subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert child.stdin and child.stdout
    child.stdin.write(LONG)
    child.stdin.close()
    assert child.stdout.readline() == "begun\n"
    time.sleep(0.3)
    child.send_signal(signal.SIGINT)
    assert child.stdout.read() == "stopped\n"
    assert child.wait() == 0


def test_a_world_is_not_kept_by_its_arrays() -> None:
    scenario = carom.Scenario(ONE)
    world = carom.World(scenario)
    places = world.positions
    gone = weakref.ref(places)
    del places, world
    gc.collect()
    assert gone() is None
