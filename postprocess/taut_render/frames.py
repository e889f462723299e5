"""What a run has written for pictures: frames, fields and their units."""

import json
import re
import xml.etree.ElementTree as xml
from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import quoteattr

import taut_numbers as numbers

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
    """Of a folder: the file that ParaView reads, its time of each frame, what
    the frame is called, its time or parameter, and the fields with their units.
    """

    source: Path
    keys: list
    names: list
    times: list
    units: dict
    is_modes: bool = False

    def find_nearest(self, time):
        """The first frame as near to the time as any."""
        return min(range(len(self.times)),
                   key=lambda i: abs(self.times[i] - time))


def read_data_sets(file):
    """Times and, by part, files of the frames that a fields.pvd names."""
    try:
        sets = list(xml.parse(file).getroot().iter("DataSet"))
    except (OSError, xml.ParseError) as error:
        raise Refusal(f"{file}: the list of frames cannot be read: {error}")
    found = []
    for data in sets:
        part = int(data.get("part", 0))
        if not found or part <= max(found[-1][1]):
            found.append((float(data.get("timestep")), {}))
        found[-1][1][part] = data.get("file")
    return found


def write_numbered(file, data_sets):
    """A .pvd whose times are the numbers of the frames: the parameter of a path
    comes back to the same values, which ParaView does not follow."""
    lines = ['<?xml version="1.0"?>',
             '<VTKFile type="Collection" version="0.1">', "<Collection>"]
    for number, (_, parts) in enumerate(data_sets):
        lines += [f'<DataSet timestep="{number}" part="{part}" '
                  f'file={quoteattr("../" + name)}/>'
                  for part, name in sorted(parts.items())]
    file.parent.mkdir(exist_ok=True)
    file.write_text("\n".join(lines + ["</Collection>", "</VTKFile>", ""]),
                    encoding="utf-8")


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


def read_summary(folder):
    """run.json, empty if the run did not come to its end."""
    try:
        text = (folder / "run.json").read_text(encoding="utf-8")
        return json.loads(text)
    except (OSError, json.JSONDecodeError):
        return {}


def name_modes(folder, times):
    """Of the frames of `taut modes`, in which 0 is the state."""
    modes = read_summary(folder).get("modes") or {}
    frequencies = modes.get("frequencies") or []
    names = []
    for time in times:
        number = round(time)
        name = f"mode {number}" if number else "the state"
        if 0 < number <= len(frequencies) and isinstance(
                frequencies[number - 1], (int, float)):
            name += f": {frequencies[number - 1]:.4g} Hz"
        names.append(name)
    return names


def is_path(folder):
    """Whether the times are the parameter of a continuation."""
    file = folder / "history.csv"
    if not file.is_file():
        return False
    with open(file, encoding="utf-8") as stream:
        return "negative eigenvalues" in stream.readline()


def read_frames(folder):
    folder = Path(folder)
    file = folder / "fields.pvd"
    if not file.is_file():
        raise Refusal(f"{folder}: there is no fields.pvd, so there is nothing "
                      "to draw; lumped models and studies have no fields, "
                      "`taut report` shows what they have")
    data_sets = read_data_sets(file)
    if not data_sets:
        raise Refusal(f"{file}: there is no frame in it: the run ended before "
                      "its first one")
    times = [time for time, _ in data_sets]
    units = {}
    for name in data_sets[-1][1].values():
        units.update(read_units(folder / name))
    if (folder / "modes.csv").is_file() and "mode" in units:
        return Frames(file, times, name_modes(folder, times), times, units,
                      is_modes=True)
    if is_path(folder):
        numbered = folder / "pictures" / "frames.pvd"
        write_numbered(numbered, data_sets)
        names = [f"frame {i}, parameter {numbers.format_number(time)}"
                 for i, time in enumerate(times)]
        return Frames(numbered, [float(i) for i in range(len(times))], names,
                      times, units)
    return Frames(file, times, [f"t = {time:.4g} s" for time in times], times,
                  units)


def has_voltage(folder):
    """Whether the case has electrodes."""
    changed = read_summary(Path(folder)).get("parameters_changed") or {}
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
