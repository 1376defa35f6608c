"""Event-driven simulation of grains: soft and hard spheres that fly, touch and bounce.

    import carom

    world = carom.World(carom.Scenario.read("gas.toml"))
    world.run()
    world.observed["averages"].to_pandas()
"""

from carom._carom import (
    Picture,
    Problem,
    Samples,
    Scenario,
    ScenarioError,
    SimulationError,
    Table,
    World,
    __version__,
    schema,
)

__all__ = [
    "Picture",
    "Problem",
    "Samples",
    "Scenario",
    "ScenarioError",
    "SimulationError",
    "Table",
    "World",
    "__version__",
    "schema",
]
