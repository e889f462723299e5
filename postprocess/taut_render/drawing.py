"""Draws the pictures of a plan inside ParaView.

The plan names the fields.pvd, the field, the size and view, and the shots: time,
share of the mode's shape (-1 to 1) and file.
"""

import numpy as np
from paraview import servermanager
from paraview import simple as pv
from vtk.util.numpy_support import vtk_to_numpy

import taut_macro

from . import camera

# The largest excursion of a drawn mode, relative to the size of the device.
EXCURSION = 0.12
# Pictures are drawn larger and then reduced, for smooth edges.
OVERSAMPLING = 2
# Corners are singular: the colours span the rest if that is much less.
OUTLIERS = 2.0
MUCH_LESS = 0.8


def fetch(part, time):
    part.UpdatePipeline(time)
    return servermanager.Fetch(part)


def get_values(data, field):
    """All values of a field, magnitudes of a vector; none if it is not there."""
    array = data.GetPointData().GetArray(field)
    if array is None:
        return np.zeros(0)
    values = vtk_to_numpy(array).astype(float)
    if values.ndim > 1:
        values = np.linalg.norm(values, axis=1)
    return values[np.isfinite(values)]


def get_places(data):
    if data.GetNumberOfPoints() == 0:
        return np.zeros((0, 3))
    places = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    motion = data.GetPointData().GetArray("motion")
    if motion is None:
        return places
    # Where the film is and where it was: the outline is drawn, too.
    return np.concatenate([places, places + vtk_to_numpy(motion)])


def find_largest(data, field):
    """The vector of largest magnitude."""
    array = data.GetPointData().GetArray(field)
    if array is None or not array.GetNumberOfTuples():
        return np.zeros(3)
    vectors = vtk_to_numpy(array).astype(float)
    return vectors[np.argmax(np.linalg.norm(vectors, axis=1))]


def find_mode_scale(device, shot):
    """What makes the mode's largest excursion EXCURSION of the device. Its sign
    is free: upwards, or along x or y."""
    if not shot["share"]:
        return 0.0
    parts = [fetch(part, shot["time"]) for part in (device.film, device.strips)]
    largest = max((find_largest(part, "mode") for part in parts),
                  key=np.linalg.norm)
    places = np.concatenate([get_places(part) for part in parts])
    size = np.ptp(places, axis=0).max()
    length = np.linalg.norm(largest)
    if length == 0:
        return 0.0
    sign = np.sign(largest[np.argmax(np.abs(largest))])
    return float(shot["share"] * EXCURSION * size * sign / length)


def survey(device, shots, field):
    """Places and values over all shots; each shot gets its "scale" and, of a
    mode, its "limits"."""
    places, values = [], []
    for shot in shots:
        device.set_mode_scale(0.0)
        shot["scale"] = find_mode_scale(device, shot)
        device.set_mode_scale(shot["scale"])
        parts = [fetch(part, shot["time"])
                 for part in (device.film, device.strips)]
        places += [get_places(part) for part in parts]
        # The film comes first: its frame is not coloured if it is.
        found = [get_values(part, field) for part in parts]
        shown = found[0] if len(found[0]) else found[1]
        values.append(shown)
        if field == "mode":
            shot["limits"] = [0.0, float(shown.max(initial=0.0)) or 1.0]
    return np.concatenate(places), [v for v in values if len(v)]


def find_limits(values):
    """The range of the colours and the whole range, from the values of each
    shot: what only one shot shows is not an outlier."""
    if not values:
        return [0.0, 1.0], [0.0, 1.0]
    whole = [float(min(v.min() for v in values)),
             float(max(v.max() for v in values))]
    limits = [float(min(np.percentile(v, OUTLIERS) for v in values)),
              float(max(np.percentile(v, 100 - OUTLIERS) for v in values))]
    if limits[1] - limits[0] > MUCH_LESS * (whole[1] - whole[0]):
        limits = list(whole)
    # A uniform field has one colour, that of the middle.
    least = 1e-6 * max(abs(limits[0]), abs(limits[1]), 1e-30)
    if limits[1] - limits[0] < least:
        middle = 0.5 * (limits[0] + limits[1])
        half = 0.5 * abs(middle) or 0.5
        limits = [middle - half, middle + half]
    return limits, whole


def make_view(size, found):
    view = pv.CreateView("RenderView")
    view.ViewSize = [OVERSAMPLING * x for x in size]
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    distance = 20 * found.half_height
    view.CameraFocalPoint = list(found.focus)
    view.CameraPosition = list(found.focus + distance * found.direction)
    view.CameraViewUp = list(found.up)
    view.CameraParallelScale = found.half_height
    return view


def draw(plan):
    """The limits of the colours and the range of the field over all shots."""
    source = pv.PVDReader(FileName=plan["source"])
    shots, field = plan["shots"], plan["field"]
    places, values = survey(taut_macro.Device(source), shots, field)
    limits, whole = find_limits(values)
    width, height = plan["size"]
    view = make_view(plan["size"],
                     camera.place_camera(places, plan["view"], width / height))
    device = taut_macro.show(source, view, field, limits)
    table = pv.GetColorTransferFunction(field)
    # Labels are written later, in the size of the picture.
    pv.HideScalarBarIfNotNeeded(table, view)
    pv.GetScalarBar(table, view).Visibility = 0
    for shot in shots:
        device.set_mode_scale(shot["scale"])
        table.RescaleTransferFunction(*shot.get("limits", limits))
        view.ViewTime = shot["time"]
        pv.SaveScreenshot(shot["file"], view, CompressionLevel="1")
    return {"limits": limits, "range": whole}
