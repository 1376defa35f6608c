"""Do tables become frames, HTML and pictures?"""

import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pytest

import carom


@pytest.fixture
def measured(gas: carom.World) -> carom.World:
    gas.run()
    return gas


def test_frames(measured: carom.World) -> None:
    averages = measured.observed["averages"]
    pandas, polars = averages.to_pandas(), averages.to_polars()
    assert list(pandas.columns) == polars.columns == averages.columns
    assert len(pandas) == polars.height == len(averages)
    row = pandas[(pandas["quantity"] == "mean free time") & (pandas["of"] == "all")].iloc[0]
    assert row["unit"] == "s" and row["value"] > 0.0
    rate = 2 * measured.statistics["collisions"] / (len(measured) * measured.time)
    assert row["value"] == pytest.approx(1.0 / rate, rel=1e-12)


def test_columns(measured: carom.World) -> None:
    profile = measured.observed["profile"]
    assert isinstance(profile["x [m]"], np.ndarray) and len(profile["x [m]"]) == 10
    with pytest.raises(KeyError, match="no column is called"):
        profile["y [m]"]


def test_pictures(measured: carom.World, tmp_path: Path) -> None:
    profile = measured.observed["profile"]
    for picture in [
        profile.plot(["temperature"]),
        measured.observed["pair-distribution"].plot(),
        measured.draw(),
    ]:
        assert ElementTree.fromstring(picture.svg).tag.endswith("svg")
        assert picture._repr_svg_() == picture.svg
    for ending, head in [("svg", b"<svg"), ("png", b"\x89PNG"), ("pdf", b"%PDF")]:
        file = tmp_path / f"picture.{ending}"
        picture.save(file)
        assert file.read_bytes().startswith(head)
    with pytest.raises(carom.SimulationError, match=r"ends in \.png, \.svg or \.pdf"):
        picture.save(tmp_path / "picture.jpg")
    with pytest.raises(ValueError, match="no column is called entropy"):
        profile.plot(["entropy"])
    with pytest.raises(ValueError, match="log is"):
        profile.plot(log="z")  # type: ignore[arg-type]


@pytest.mark.parametrize("dimension", [1, 2, 3])
def test_grains_are_drawn_in_every_dimension(dimension: int) -> None:
    at = [[0.5 * (k + 1)] * dimension for k in range(4)]
    scenario = carom.Scenario.from_dict(
        {
            "dimension": dimension,
            "duration": 1.0,
            "sample": 1.0,
            "law": {"kind": "constant", "restitution": 1.0},
            "grain": [{"radius": 0.1, "mass": 1.0, "at": place} for place in at],
        }
    )
    assert carom.World(scenario).draw().svg.count("<path") > 4


def test_html(measured: carom.World) -> None:
    html = measured.observed["averages"]._repr_html_()
    assert html.startswith("<table>") and "mean free time" in html
    assert "kinetic energy" in measured._repr_html_()
    assert "<pre>" in measured.scenario._repr_html_()


def test_events() -> None:
    text = """
    dimension = 1
    duration = 1.0
    sample = 1.0
    options = { events = true }
    law = { kind = "constant", restitution = 1.0 }
    grain = [
      { radius = 0.1, mass = 1.0, at = [0.0], moving = [1.0] },
      { radius = 0.1, mass = 1.0, at = [0.5] },
    ]
    """
    world = carom.World(carom.Scenario(text))
    world.run()
    events = world.take_events().to_pandas()
    assert events["kind"].tolist() == ["collision"] and events["time [s]"][0] == pytest.approx(0.3)
    assert len(world.take_events()) == 0


def test_schema() -> None:
    assert "dimension" in carom.schema()["properties"]
