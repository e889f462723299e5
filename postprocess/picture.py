"""A picture of a run's device, drawn by ParaView without a screen.

    xvfb-run -a pvbatch postprocess/picture.py DIR PICTURE.png [FIELD [TIME]]

DIR is the folder of a run, FIELD a scalar of its fields (see README.md; the
smaller principal stress of a film or, without one, the strain of its frames by
default), TIME the time in s (the last one by default). The device is drawn
deformed, the edge of its film in the mesh as an outline. Frames are strips as
wide as their section, or tubes if that is not known.
"""

import os
import sys
import xml.etree.ElementTree as xml

from paraview import servermanager
from paraview import simple as pv

TITLES = {
    "stress_1": "larger principal stress (kPa)",
    "stress_2": "smaller principal stress (kPa)",
    "stretch_1": "larger principal stretch",
    "stretch_2": "smaller principal stretch",
    "true_field": "true field (MV/m)",
    "strain": "largest strain of the frame",
}
SCALES = {"kPa": 1e-3, "MV/m": 1e-6}
FRAME_COLOUR = [0.35, 0.38, 0.42]
FILM, BEAMS = 0, 1


def scale_of(title):
    for unit, scale in SCALES.items():
        if unit in title:
            return scale
    return 1.0


def list_frames(folder):
    """Times and files by part, as fields.pvd names them."""
    sets = xml.parse(os.path.join(folder, "fields.pvd")).getroot().iter("DataSet")
    frames = []
    for data in sets:
        part = int(data.get("part", 0))
        if not frames or part <= max(frames[-1][1]):
            frames.append((float(data.get("timestep")), {}))
        frames[-1][1][part] = os.path.join(folder, data.get("file"))
    return frames


def read(file):
    """The device in the mesh and deformed."""
    if file.endswith(".pvtu"):
        reader = pv.XMLPartitionedUnstructuredGridReader(FileName=[file])
    else:
        reader = pv.XMLUnstructuredGridReader(FileName=[file])
    warp = pv.WarpByVector(Input=reader)
    warp.Vectors = ["POINTS", "displacement"]
    warp.UpdatePipeline()
    return reader, warp


def values_of(source, name):
    """All values of a scalar, wherever the source keeps them."""
    data = servermanager.Fetch(source)
    array = data.GetPointData().GetArray(name)
    return sorted(array.GetValue(i) for i in range(array.GetNumberOfValues()))


def middle_of(source):
    """The range of all but the lowest and highest hundredth of the values."""
    values = values_of(source, "drawn")
    cut = len(values) // 100
    return values[cut], values[-1 - cut]


def paint(display, colour):
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = colour


def make_view(time):
    view = pv.CreateView("RenderView")
    view.ViewSize = [1200, 900]
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    text = pv.Text(Text="t = %.4g s" % time)
    label = pv.Show(text, view)
    label.Color = [0, 0, 0]
    label.FontSize = 22
    label.WindowLocation = "Any Location"
    label.Position = [0.02, 0.92]
    return view


def title_of(field):
    return TITLES.get(field, field.replace("_", " "))


def add_drawn(source, field):
    """Adds the field as "drawn", in the unit of its title."""
    values = pv.Calculator(Input=source)
    values.ResultArrayName = "drawn"
    values.Function = "%g*%s" % (scale_of(title_of(field)), field)
    return values


def show_drawn(source, field, view):
    """Shows the source coloured by "drawn", with a scale beside it."""
    source.UpdatePipeline()
    display = pv.Show(source, view)
    display.NonlinearSubdivisionLevel = 2
    pv.ColorBy(display, ("POINTS", "drawn"))
    display.SetScalarBarVisibility(view, True)
    table = pv.GetColorTransferFunction("drawn")
    table.ApplyPreset("Viridis (matplotlib)", True)
    # Corners are singular: the colours span what the rest of the film shows.
    table.RescaleTransferFunction(*middle_of(source))
    bar = pv.GetScalarBar(table, view)
    bar.Title = title_of(field)
    bar.ComponentTitle = ""
    # ParaView's own labels are white on white.
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.TitleFontSize = bar.LabelFontSize = 18
    bar.Orientation = "Vertical"
    bar.WindowLocation = "Any Location"
    bar.Position = [0.84, 0.2]
    bar.ScalarBarLength = 0.6
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = bar.RangeLabelFormat = "%.3g"


def show_film(file, field, view):
    in_mesh, deformed = read(file)
    show_drawn(add_drawn(deformed, field), field, view)
    surface = pv.ExtractSurface(Input=in_mesh)
    edges = pv.Show(pv.FeatureEdges(Input=surface), view)
    paint(edges, [0.2, 0.2, 0.2])
    edges.LineWidth = 2
    mesh = pv.Show(deformed, view)
    mesh.SetRepresentationType("Wireframe")
    paint(mesh, [0.1, 0.1, 0.1])
    mesh.Opacity = 0.35
    return deformed


def make_strip(lines, width):
    """Ribbons across the lines, along axis 2 of the sections."""
    strip = pv.Ribbon(Input=lines)
    strip.Vectors = ["POINTS", "axis_3"]
    strip.Width = width / 2
    return strip


def make_tube(lines):
    low_x, high_x, low_y, high_y, low_z, high_z = lines.GetDataInformation().GetBounds()
    size = max(high_x - low_x, high_y - low_y, high_z - low_z)
    return pv.Tube(Input=lines, Radius=size / 100)


def make_bodies(frames):
    """A strip or tube for each frame."""
    bodies = []
    for frame in sorted(set(values_of(frames, "frame"))):
        one = pv.Threshold(Input=frames)
        one.Scalars = ["POINTS", "frame"]
        one.LowerThreshold = one.UpperThreshold = frame
        lines = pv.ExtractSurface(Input=one)
        lines.UpdatePipeline()
        width = values_of(lines, "width")[-1]
        bodies.append(make_strip(lines, width) if width > 0 else make_tube(lines))
    return bodies


def show_beams(file, field, view):
    """Coloured by the field if there is one."""
    deformed = read(file)[1]
    # The ribbons' nameless normals crash the calculator: it comes first.
    lines = add_drawn(deformed, field) if field else deformed
    bodies = pv.AppendGeometry(Input=make_bodies(lines))
    if field:
        show_drawn(bodies, field, view)
    else:
        paint(pv.Show(bodies, view), FRAME_COLOUR)
    return deformed


def place_camera(view, sources):
    """From above on what is flat, from the side on what is bent."""
    bounds = [source.GetDataInformation().GetBounds() for source in sources]
    extents = [
        max(b[2 * c + 1] for b in bounds) - min(b[2 * c] for b in bounds)
        for c in range(3)
    ]
    is_bent = extents[2] > 0.05 * max(extents)
    if is_bent:
        view.CameraPosition = [0.6, -1.6, 0.6]
        view.CameraViewUp = [0, 0, 1]
        view.CameraFocalPoint = [0, 0, 0]
    view.CameraParallelProjection = 1
    pv.ResetCamera(view)
    view.CameraParallelScale *= 0.95 if is_bent else 0.8


def draw(folder, picture, field, time):
    frames = list_frames(folder)
    if time is None:
        time = frames[-1][0]
    time, parts = min(frames, key=lambda frame: abs(frame[0] - time))
    view = make_view(time)
    sources = []
    if FILM in parts:
        sources.append(show_film(parts[FILM], field or "stress_2", view))
    if BEAMS in parts:
        of_beams = None if FILM in parts else field or "strain"
        sources.append(show_beams(parts[BEAMS], of_beams, view))
    place_camera(view, sources)
    pv.SaveScreenshot(picture, view)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    draw(
        sys.argv[1],
        sys.argv[2],
        sys.argv[3] if len(sys.argv) > 3 else None,
        float(sys.argv[4]) if len(sys.argv) > 4 else None,
    )
