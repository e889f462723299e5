"""Shows the device of a run of Taut in ParaView: the deformed film coloured by a
field, its edge in the mesh as an outline, frames as solid strips.

As a macro: Macros > Import new macro, choose this file; then open the fields.pvd
of a run, select it in the pipeline browser and call the macro. It adds ordinary
filters, so that field, colours and scale can be changed as usual.

`taut render` draws its pictures with the same functions and writes
open_in_paraview.py, which is this file with the run's own field and range.
"""

from paraview import simple as pv

FRAME_COLOUR = [0.30, 0.33, 0.38]
OUTLINE_COLOUR = [0.45, 0.47, 0.50]
PLAIN_FILM_COLOUR = [0.80, 0.82, 0.84]
COLOURS = "Viridis (matplotlib)"

# What the two filters below share: the grids of the input, and the
# displacement together with a share of the shape of a vibration mode.
COMMON_SCRIPT = '''
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

MODE_SCALE = {mode_scale!r}

def list_grids(data):
    """The grids of all blocks and pieces."""
    if not isinstance(data, vtk.vtkCompositeDataSet):
        return [data]
    iterator, grids = data.NewIterator(), []
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        grids.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return grids

def append_grids(of_beams):
    wanted = [grid for grid in list_grids(self.GetInputDataObject(0, 0))
              if grid.GetPointData().HasArray("axis_1") == of_beams]
    if not wanted:
        return vtk.vtkUnstructuredGrid()
    appended = vtk.vtkAppendFilter()
    for grid in wanted:
        appended.AddInputData(grid)
    appended.Update()
    return appended.GetOutput()

def get_array(grid, name):
    return vtk_to_numpy(grid.GetPointData().GetArray(name)).astype(float)

def compute_motion(grid):
    motion = get_array(grid, "displacement")
    if MODE_SCALE and grid.GetPointData().HasArray("mode"):
        motion = motion + MODE_SCALE * get_array(grid, "mode")
    return motion
'''

FILM_SCRIPT = COMMON_SCRIPT + '''
film = append_grids(False)
if film.GetNumberOfPoints():
    motion = numpy_to_vtk(compute_motion(film), deep=True)
    motion.SetName("motion")
    film.GetPointData().AddArray(motion)
self.GetOutputDataObject(0).ShallowCopy(film)
'''

# A section is drawn with the normals of its sides, so that a strip is smooth
# along its axis and has sharp edges.
STRIP_SCRIPT = COMMON_SCRIPT + '''
def make_sides(section, radius):
    """Corners of the sides of a section, and their normals, in its axes."""
    width, thickness = section / 2
    if not width > 0:
        turns = np.linspace(0, 2 * np.pi, 13)
        round_ = np.column_stack([np.cos(turns), np.sin(turns)])
        return [(radius * a, radius * b, a, b)
                for a, b in zip(round_, round_[1:])]
    thickness = thickness if thickness > 0 else 0.02 * width
    corners = [np.array(c) for c in ((width, -thickness), (width, thickness),
               (-width, thickness), (-width, -thickness))]
    normals = [np.array(n) for n in ((1, 0), (0, 1), (-1, 0), (0, -1))]
    return [(corners[i], corners[(i + 1) % 4], normals[i], normals[i])
            for i in range(4)]

def build(beams, radius):
    places = vtk_to_numpy(beams.GetPoints().GetData()).astype(float)
    places = places + compute_motion(beams)
    across, through = get_array(beams, "axis_2"), get_array(beams, "axis_3")
    sections = np.column_stack([get_array(beams, "width"),
                                get_array(beams, "thickness")])
    points, normals, origins, quads = [], [], [], vtk.vtkCellArray()

    def add(node, corner, normal):
        points.append(places[node] + corner[0] * across[node]
                      + corner[1] * through[node])
        normals.append(normal)
        origins.append(node)
        return len(points) - 1

    def add_quad(corners):
        quads.InsertNextCell(4, corners)

    def outward(node, normal):
        return normal[0] * across[node] + normal[1] * through[node]

    lines = [(cell.GetPointId(i), cell.GetPointId(i + 1))
             for cell in map(beams.GetCell, range(beams.GetNumberOfCells()))
             for i in range(cell.GetNumberOfPoints() - 1)]
    degree = np.zeros(len(places), dtype=int)
    for line in lines:
        degree[list(line)] += 1
    for line in lines:
        sides = make_sides(sections[line[0]], radius)
        for a, b, normal_a, normal_b in sides:
            add_quad([add(node, corner, outward(node, normal))
                      for node, corner, normal in (
                          (line[0], a, normal_a), (line[0], b, normal_b),
                          (line[1], b, normal_b), (line[1], a, normal_a))])
        along = places[line[1]] - places[line[0]]
        for node in line:
            if degree[node] == 1 and len(sides) == 4:
                add_quad([add(node, side[0], along) for side in sides])
    return points, normals, origins, quads

beams = append_grids(True)
output = self.GetOutputDataObject(0)
if beams.GetNumberOfPoints():
    # Of a frame whose section is not known.
    radius = np.ptp(vtk_to_numpy(beams.GetPoints().GetData()), axis=0)
    radius = float(np.amax(radius)) / 150
    points, normals, origins, quads = build(beams, radius)
    vertices = vtk.vtkPoints()
    vertices.SetData(numpy_to_vtk(np.array(points), deep=True))
    output.SetPoints(vertices)
    output.SetPolys(quads)
    arrow = numpy_to_vtk(np.array(normals), deep=True)
    arrow.SetName("Normals")
    output.GetPointData().SetNormals(arrow)
    for i in range(beams.GetPointData().GetNumberOfArrays()):
        array = beams.GetPointData().GetArray(i)
        copy = numpy_to_vtk(vtk_to_numpy(array)[origins], deep=True)
        copy.SetName(array.GetName())
        output.GetPointData().AddArray(copy)
'''


def make_filter(source, name, kind, script):
    """A filter of a few lines of Python, named in the pipeline browser."""
    made = pv.ProgrammableFilter(registrationName=name, Input=source)
    made.OutputDataSetType = kind
    made.Script = script
    return made


class Device:
    """The filters that show a run; `film` and `strips` are where the field is
    looked for, `moved` is the film in its place."""

    def __init__(self, source, mode_scale=0.0):
        self.film = make_filter(source, "film", "vtkUnstructuredGrid", "")
        self.strips = make_filter(source, "frames", "vtkPolyData", "")
        self.set_mode_scale(mode_scale)
        self.film.UpdatePipeline()
        self.strips.UpdatePipeline()
        self.moved = pv.WarpByVector(registrationName="deformed film",
                                     Input=self.film)
        if self.has_film():
            self.moved.Vectors = ["POINTS", "motion"]

    def set_mode_scale(self, scale):
        """How much of the shape of a mode is added to the displacement."""
        self.film.Script = FILM_SCRIPT.format(mode_scale=scale)
        self.strips.Script = STRIP_SCRIPT.format(mode_scale=scale)

    def has_film(self):
        return self.film.GetDataInformation().GetNumberOfPoints() > 0

    def has_frames(self):
        return self.strips.GetDataInformation().GetNumberOfPoints() > 0

    def list_fields(self):
        return set(self.film.PointData.keys()) | set(
            self.strips.PointData.keys())


def paint(display, colour):
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = colour


def set_light(display):
    """Little shade, so that the colours are those of the colour bar."""
    display.Ambient, display.Diffuse, display.Specular = 0.45, 0.6, 0.0


def colour_by(display, view, field, limits):
    pv.ColorBy(display, ("POINTS", field))
    table = pv.GetColorTransferFunction(field)
    table.ApplyPreset(COLOURS, True)
    # Not above and below: the colours of a clipped range are those of its ends.
    if limits:
        table.RescaleTransferFunction(*limits)
    bar = pv.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = field.replace("_", " "), ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = bar.RangeLabelFormat = "%.3g"
    display.SetScalarBarVisibility(view, True)


def show_film(device, view):
    display = pv.Show(device.moved, view)
    display.NonlinearSubdivisionLevel = 2
    set_light(display)
    paint(display, PLAIN_FILM_COLOUR)
    whole = pv.CleantoGrid(registrationName="mesh", Input=device.film)
    edges = pv.FeatureEdges(registrationName="edge of the mesh",
                            Input=pv.ExtractSurface(Input=whole))
    edges.FeatureEdges = 0
    line = pv.Show(edges, view)
    paint(line, OUTLINE_COLOUR)
    line.LineWidth = 2
    return display


def show_frames(device, view):
    display = pv.Show(device.strips, view)
    set_light(display)
    paint(display, FRAME_COLOUR)
    return display


def set_background(view):
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesLabelColor = [0, 0, 0]


def show(source, view, field=None, limits=None, mode_scale=0.0):
    """Shows a fields.pvd, coloured by `field` within `limits`; the usual field
    if none is named."""
    device = Device(source, mode_scale)
    set_background(view)
    field = field or choose_field(device.list_fields())
    displays = []
    if device.has_film():
        displays.append((show_film(device, view), device.film))
    if device.has_frames():
        displays.append((show_frames(device, view), device.strips))
    for display, part in displays:
        # What the film shows, its frame need not.
        if field in part.PointData.keys():
            colour_by(display, view, field, limits)
            break
    pv.Hide(source, view)
    return device


def choose_field(fields):
    """The first that is there of what is usually looked at."""
    usual = ("mode", "true_field", "stress_1", "strain")
    return next((field for field in usual if field in fields), None)


def run_macro():
    source = pv.GetActiveSource()
    if source is None:
        print("Taut: open the fields.pvd of a run and select it first")
        return
    view = pv.GetActiveViewOrCreate("RenderView")
    show(source, view)
    pv.ResetCamera(view)
    pv.Render(view)


# A macro is run, taut_render imports.
if __name__ in ("__main__", "__vtkconsole__") and "SETTINGS" not in globals():
    run_macro()
