"""What a run has written for pictures: frames, fields and their units."""

import json
import re
import xml.etree.ElementTree as xml
from dataclasses import dataclass, field
from pathlib import Path

from .refusal import Refusal, suggest

TITLES = {
    "stress_1": "larger principal stress",
    "stress_2": "smaller principal stress",
    "stretch_1": "larger principal stretch",
    "stretch_2": "smaller principal stretch",
    "true_field": "true field",
    "breakdown_margin": "distance to breakdown",
    "wrinkle_strain": "wrinkle strain",
    "tension": "tension (0 slack, 1 wrinkled, 2 taut)",
    "strain": "largest strain of the frame",
    "mode": "shape of the mode, relative",
}
# What places and turns the device, and is no result.
NOT_SHOWN = {"axis_1", "axis_2", "axis_3", "width", "stress_direction_1",
             "wrinkle_direction"}
GEOMETRY = {"connectivity", "offsets", "types", "TIME"}


@dataclass
class Frames:
    """Of a folder: times, fields with their units, whether frames are modes."""

    times: list
    units: dict
    is_modes: bool
    names: dict = field(default_factory=dict)

    def name(self, time):
        """What is written above the picture of a time."""
        return self.names.get(time, f"t = {time:.4g} s")


def read_data_sets(file):
    """(time, path) of the files that a fields.pvd names."""
    try:
        sets = list(xml.parse(file).getroot().iter("DataSet"))
    except (OSError, xml.ParseError) as error:
        raise Refusal(f"{file}: the list of frames cannot be read: {error}")
    return [(float(data.get("timestep")), file.parent / data.get("file"))
            for data in sets]


def read_units(file):
    """Fields of a .vtu or .pvtu and their units; numbers without one have ""."""
    try:
        text = file.read_bytes().decode("latin-1")
    except OSError as error:
        raise Refusal(f"{file}: cannot be read: {error.strerror}")
    units = {}
    for tag in re.findall(r"<P?DataArray\b[^>]*>", text):
        words = dict(re.findall(r'(\w+)="([^"]*)"', tag))
        if "Name" in words and words["Name"] not in GEOMETRY:
            units[words["Name"]] = words.get("units", "")
    return units


def name_modes(folder, times):
    """Labels of the frames of `taut modes`: frame 0 is the state."""
    file = folder / "run.json"
    modes = {}
    if file.is_file():
        modes = json.loads(file.read_text(encoding="utf-8")).get("modes") or {}
    names = {0.0: "the state"}
    for number, frequency in enumerate(modes.get("frequencies", []), start=1):
        if isinstance(frequency, (int, float)):
            names[float(number)] = f"mode {number}: {frequency:.4g} Hz"
    for time in times:
        names.setdefault(time, f"mode {time:.0f}")
    return names


def read_frames(folder):
    folder = Path(folder)
    file = folder / "fields.pvd"
    if not file.is_file():
        raise Refusal(f"{folder}: there is no fields.pvd, so there is nothing "
                      "to draw; lumped models and studies have no fields, "
                      "`taut report` shows what they have")
    data_sets = read_data_sets(file)
    times = sorted({time for time, _ in data_sets})
    if not times:
        raise Refusal(f"{file}: there is no frame in it: the run ended before "
                      "its first one")
    last = [path for time, path in data_sets if time == times[-1]]
    units = {}
    for path in last:
        units.update(read_units(path))
    is_modes = (folder / "modes.csv").is_file() and "mode" in units
    names = name_modes(folder, times) if is_modes else {}
    return Frames(times, units, is_modes, names)


def has_voltage(folder):
    """Whether the case has electrodes."""
    file = Path(folder) / "run.json"
    if not file.is_file():
        return False
    changed = json.loads(file.read_text(encoding="utf-8")).get(
        "parameters_changed", {})
    return any(key.startswith("Electrode ") for key in changed)


def choose_field(frames, folder):
    """The mode's shape, or the true field if there are electrodes, or the
    larger stress; of frames alone their strain."""
    usual = ["mode"] if frames.is_modes else []
    usual += ["true_field"] if has_voltage(folder) else []
    for name in usual + ["stress_1", "strain"]:
        if name in frames.units:
            return name
    return next(iter(sorted(frames.units)), None)


def check_field(frames, name):
    if name not in frames.units:
        known = sorted(set(frames.units) - NOT_SHOWN)
        raise Refusal(f"there is no field '{name}'{suggest(name, known)}; there "
                      f"are: {', '.join(known)}")
    return name


def get_title(name):
    return TITLES.get(name, name.replace("_", " "))
