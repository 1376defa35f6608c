"""What the compiled part of carom offers."""

from collections.abc import Iterator, Mapping, Sequence
from os import PathLike
from typing import Any, Literal, final

import numpy as np
import pandas
import polars
from numpy.typing import NDArray

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

__version__: str

class ScenarioError(ValueError):
    """A scenario that cannot be. `problems` has all that is wrong with it."""

    problems: list[Problem]

class SimulationError(RuntimeError):
    """A run that cannot go on, or cannot do what it was asked."""

@final
class Problem:
    """One thing that is wrong with a scenario."""

    @property
    def field(self) -> str:
        """The field, as in `grain.3.radius`; empty if it is all of the scenario."""
    @property
    def message(self) -> str:
        """What is wrong, and what would be right."""
    @property
    def line(self) -> int:
        """The line, from 1; 0 where there is none."""
    @property
    def column(self) -> int:
        """The column, from 1; 0 where there is none."""

@final
class Scenario:
    """What is to be simulated: the fields of a scenario file, checked.

    Files that it names are looked for in `folder`.
    """

    def __new__(cls, text: str, folder: str | PathLike[str] = ...) -> Scenario: ...
    @staticmethod
    def read(path: str | PathLike[str]) -> Scenario:
        """Reads a scenario file."""
    @staticmethod
    def from_dict(fields: dict[str, Any], folder: str | PathLike[str] = ...) -> Scenario:
        """The scenario of a dictionary, with the keys that a file has."""
    @staticmethod
    def check(text: str, folder: str | PathLike[str] = ...) -> list[Problem]:
        """All that is wrong with a text; nothing if it is a scenario."""
    @property
    def text(self) -> str:
        """The scenario as a file says it."""
    @property
    def folder(self) -> PathLike[str]:
        """Where files are looked for that it names."""
    @property
    def title(self) -> str:
        """One line about it."""
    @property
    def dimension(self) -> Literal[1, 2, 3]:
        """1, 2 or 3."""
    @property
    def duration(self) -> float | None:
        """How long it runs (s), if it says so."""
    @property
    def sample(self) -> float:
        """Time between two samples (s)."""
    @property
    def methods(self) -> list[str]:
        """The methods that `carom run` would run."""
    def _repr_html_(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class World:
    """A scenario that runs by one method.

    While it computes, other threads of Python go on, and Ctrl-C stops it between two events: it can go on from
    there. One thread at a time can work with it.

    `method` is md, md-exact, emd or emd*; the last that the scenario asks for or allows if left out.
    """

    def __new__(cls, scenario: Scenario, method: str | None = None) -> World: ...
    @staticmethod
    def restore(state: bytes) -> World:
        """A world that `save` has saved."""
    def save(self) -> bytes:
        """The whole state, from which `restore` goes on with the same bits."""
    def advance_to(self, time: float) -> None:
        """Goes on to an instant (s)."""
    def advance_by(self, span: float) -> None:
        """Goes on by a span of time (s)."""
    def step(self, events: int = 1) -> bool:
        """So many events happen, a grain's way into another cell among them; false if nothing ever happens any more."""
    def run(self) -> None:
        """Goes on to the scenario's end."""
    def samples(self) -> Samples:
        """Goes on from sample to sample, each time the loop asks for the next one, to the scenario's end; yields times (s)."""
    @property
    def scenario(self) -> Scenario:
        """The scenario."""
    @property
    def method(self) -> str:
        """The method: md, md-exact, emd or emd*."""
    @property
    def dimension(self) -> Literal[1, 2, 3]:
        """1, 2 or 3."""
    @property
    def time(self) -> float:
        """The present (s)."""
    @property
    def positions(self) -> NDArray[np.float64]:
        """Where the grains are (m), a row each: an array that stays the same and changes when the world goes on."""
    @property
    def velocities(self) -> NDArray[np.float64]:
        """How fast they are (m/s), as `positions`."""
    @property
    def radii(self) -> NDArray[np.float64]:
        """The grains' radii (m)."""
    @property
    def masses(self) -> NDArray[np.float64]:
        """The grains' masses (kg)."""
    @property
    def species(self) -> NDArray[np.uint16]:
        """Of which species each grain is: numbers of `species_names`."""
    @property
    def species_names(self) -> list[str]:
        """What species are called."""
    @property
    def kinetic_energy(self) -> float:
        """Kinetic energy (J)."""
    @property
    def collisions(self) -> int:
        """Contacts begun so far, with grains and walls."""
    @property
    def statistics(self) -> dict[str, int]:
        """How often everything happened."""
    @property
    def motions(self) -> dict[str, int]:
        """How many grains move in which way."""
    @property
    def digest(self) -> int | None:
        """A digest of the whole state: the same on every machine, and from Rust. None for force-based methods."""
    @property
    def observed(self) -> dict[str, Table]:
        """What `[observe]` has measured so far: tables by their names."""
    def take_events(self) -> Table:
        """The events since the last call, if `options.events` is true."""
    def draw(self) -> Picture:
        """The grains as they are now, in colours of their species."""
    def _repr_html_(self) -> str: ...
    def __len__(self) -> int: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Samples:
    """The samples of a run, one after the other."""

    def __iter__(self) -> Iterator[float]: ...
    def __next__(self) -> float: ...

@final
class Table:
    """Columns, whose heads have units, and rows."""

    @property
    def name(self) -> str:
        """What it is."""
    @property
    def columns(self) -> list[str]:
        """The heads of its columns, with units."""
    def to_dict(self) -> dict[str, NDArray[np.float64] | list[str | None]]:
        """Each column under its head: an array of numbers, or a list of words."""
    def to_pandas(self) -> pandas.DataFrame:
        """As a frame of pandas, which must be installed."""
    def to_polars(self) -> polars.DataFrame:
        """As a frame of polars, which must be installed."""
    def plot(self, show: Sequence[str] = ..., *, log: Literal["", "x", "y", "xy"] = "") -> Picture:
        """Curves over the first column, those whose heads have one of these words in them; with logarithmic axes "x", "y" or "xy"."""
    def __len__(self) -> int: ...
    def __getitem__(self, head: str, /) -> Any: ...
    def _repr_html_(self) -> str: ...

@final
class Picture:
    """A picture. A notebook shows it."""

    @property
    def svg(self) -> str:
        """As an SVG document."""
    def save(self, path: str | PathLike[str]) -> None:
        """Writes it, as its name ends: in .svg, .png or .pdf."""
    def _repr_svg_(self) -> str: ...

def schema() -> Mapping[str, Any]:
    """JSON Schema of a scenario, as a dictionary."""
