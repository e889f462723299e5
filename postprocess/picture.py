"""A picture of a run's film, drawn by ParaView without a screen.

    xvfb-run -a pvbatch postprocess/picture.py DIR PICTURE.png [FIELD [TIME]]

DIR is the folder of a run, FIELD a scalar of its fields (see README.md; the
smaller principal stress by default), TIME the time in s (the last frame by
default). The film is drawn deformed, its frame of rest as an outline.
"""

import sys

from paraview import servermanager
from paraview import simple as pv

TITLES = {
    "stress_1": "larger principal stress (kPa)",
    "stress_2": "smaller principal stress (kPa)",
    "stretch_1": "larger principal stretch",
    "stretch_2": "smaller principal stretch",
    "true_field": "true field (MV/m)",
}
SCALES = {"kPa": 1e-3, "MV/m": 1e-6}


def scale_of(title):
    for unit, scale in SCALES.items():
        if unit in title:
            return scale
    return 1.0


def middle_of(source):
    """The range of all but the lowest and highest hundredth of the values."""
    data = servermanager.Fetch(source)
    array = data.GetPointData().GetArray("drawn")
    values = sorted(array.GetValue(i) for i in range(array.GetNumberOfValues()))
    cut = len(values) // 100
    return values[cut], values[-1 - cut]


def draw(folder, picture, field, time):
    reader = pv.PVDReader(FileName=folder + "/fields.pvd")
    reader.UpdatePipelineInformation()
    times = reader.TimestepValues
    time = times[-1] if time is None else min(times, key=lambda t: abs(t - time))
    reader.UpdatePipeline(time)

    warp = pv.WarpByVector(Input=reader)
    warp.Vectors = ["POINTS", "displacement"]
    title = TITLES.get(field, field.replace("_", " "))
    values = pv.Calculator(Input=warp)
    values.ResultArrayName = "drawn"
    values.Function = "%g*%s" % (scale_of(title), field)
    values.UpdatePipeline(time)

    view = pv.CreateView("RenderView")
    view.ViewSize = [1200, 900]
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    view.ViewTime = time

    film = pv.Show(values, view)
    film.NonlinearSubdivisionLevel = 2
    pv.ColorBy(film, ("POINTS", "drawn"))
    film.SetScalarBarVisibility(view, True)
    table = pv.GetColorTransferFunction("drawn")
    table.ApplyPreset("Viridis (matplotlib)", True)
    # Corners are singular: the colours span what the rest of the film shows.
    table.RescaleTransferFunction(*middle_of(values))
    bar = pv.GetScalarBar(table, view)
    bar.Title = title
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

    cells = pv.FeatureEdges(Input=reader)
    edges = pv.Show(cells, view)
    edges.ColorArrayName = ["POINTS", ""]
    edges.AmbientColor = edges.DiffuseColor = [0.2, 0.2, 0.2]
    edges.LineWidth = 2

    mesh = pv.Show(warp, view)
    mesh.SetRepresentationType("Wireframe")
    mesh.ColorArrayName = ["POINTS", ""]
    mesh.AmbientColor = mesh.DiffuseColor = [0.1, 0.1, 0.1]
    mesh.Opacity = 0.35

    text = pv.Text(Text="t = %.4g s" % time)
    label = pv.Show(text, view)
    label.Color = [0, 0, 0]
    label.FontSize = 22
    label.WindowLocation = "Any Location"
    label.Position = [0.02, 0.92]

    view.CameraParallelProjection = 1
    pv.ResetCamera(view)
    view.CameraParallelScale *= 0.8
    pv.SaveScreenshot(picture, view)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    draw(
        sys.argv[1],
        sys.argv[2],
        sys.argv[3] if len(sys.argv) > 3 else "stress_2",
        float(sys.argv[4]) if len(sys.argv) > 4 else None,
    )
