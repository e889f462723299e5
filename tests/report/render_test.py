#!/usr/bin/env python3
"""`taut render` through ParaView.

Usage: render_test.py PROGRAM SOURCE_FOLDER
"""

import csv
import json
import re
import shutil
import subprocess
import sys
import unittest

from pixels import Picture
from program import SOURCE, FolderTest, make_path_without

sys.path.insert(0, str(SOURCE / "postprocess"))
from taut_render.paraview_call import run_script  # noqa: E402

STOPPED_BY_EVENT = 4
# Viridis at its ends (S. van der Walt and N. Smith, Matplotlib 2.0).
LOWEST, HIGHEST = (68, 1, 84), (253, 231, 37)


def read_list(folder):
    return json.loads((folder / "pictures.json").read_text(encoding="utf-8"))


def compute_distance(a, b):
    return max(abs(x - y) for x, y in zip(a, b))


class Film(FolderTest):
    """A sheet in a plane, with one and the same field everywhere, which rises
    from zero until the sheet fails."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.results = cls.run_case("film/failure.prm", "film",
                               code=STOPPED_BY_EVENT)

    def get_field(self, time):
        with open(self.results / "history.csv", encoding="utf-8") as stream:
            row = min(csv.DictReader(stream),
                      key=lambda row: abs(float(row["time [s]"]) - time))
        return float(row["true field [V/m]"])

    def test_stills_show_field_and_motion(self):
        self.expect(0, "render", self.results, "--size", "600x400")
        folder = self.results / "pictures"
        written = read_list(folder)
        self.assertEqual((written["field"], written["unit"]),
                         ("true_field", "V/m"))
        # The range is that of the run, whose largest field is its last.
        last = self.get_field(1e9)
        self.assertAlmostEqual(written["limits"][0], 0, delta=1e-3 * last)
        self.assertAlmostEqual(written["limits"][1] / last, 1, delta=1e-3)
        stills = [Picture(folder / s["file"]) for s in written["stills"]]
        self.assertEqual(len(stills), 4)
        for still in stills:
            self.assertEqual((still.width, still.height), (600, 400))
            # The device and all words are within the picture.
            self.assertEqual(still.find_edge_colours(), {(255, 255, 255)})
        # The sheet covers this place all the time. Light takes up to a tenth.
        self.assertLess(compute_distance(stills[0].get(.5, .6), LOWEST), 30)
        self.assertLess(compute_distance(stills[-1].get(.5, .6), HIGHEST), 30)
        # It grows upwards: above it is white at first.
        self.assertEqual(stills[0].get(.5, .15), (255, 255, 255))
        self.assertLess(compute_distance(stills[-1].get(.5, .15), HIGHEST), 30)
        # One colour bar, though at the time shown the field is uniform.
        bars = {still.get_rows(.83, 1) for still in stills}
        self.assertEqual(len(bars), 1)

    def test_script_and_macro_open_in_paraview(self):
        self.expect(0, "render", self.results, "--times", "12", "--size", "300x200")
        self.assertEqual(len(read_list(self.results / "pictures")["stills"]), 1)
        done = run_script(self.results / "open_in_paraview.py")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(done.stderr, "")
        # A moved folder opens, too.
        moved = self.folder / "moved"
        shutil.copytree(self.results, moved)
        check = self.folder / "macro.py"
        check.write_text(f"""
from paraview import simple as pv
pv.PVDReader(FileName={str(moved / 'fields.pvd')!r})
macro = {str(SOURCE / 'postprocess' / 'taut_macro.py')!r}
exec(compile(open(macro).read(), macro, "exec"))
film = pv.FindSource("deformed film")
film.UpdatePipeline(30)
print("height", film.GetDataInformation().GetBounds()[3])
""", encoding="utf-8")
        done = run_script(check)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(done.stderr, "")
        # 30 mm in the mesh, stretched further by the voltage.
        self.assertGreater(float(done.stdout.split("height")[1]), 0.0305)

    def test_animation_has_all_frames(self):
        count = len(set(re.findall('timestep="([^"]*)"',
                                   (self.results / "fields.pvd").read_text())))
        words = ("render", self.results, "--animation", "--size", "301x201",
                 "--field", "stress_1", "-o", self.folder / "moving")
        self.expect(0, *words)
        written = read_list(self.folder / "moving")
        self.assertEqual(written["animation"],
                         {"file": "animation.mp4", "frames": count})
        done = subprocess.run(
            ["ffprobe", "-v", "error", "-count_frames", "-of", "csv=p=0",
             "-show_entries", "stream=nb_read_frames,pix_fmt",
             self.folder / "moving" / "animation.mp4"],
            capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.strip(), f"yuv420p,{count}")

    def test_animation_without_ffmpeg(self):
        path = make_path_without(self.folder / "tools", "ffmpeg")
        self.expect(0, "render", self.results, "--animation", "--size",
                    "300x200", "-o", self.folder / "webp", PATH=path)
        written = read_list(self.folder / "webp")["animation"]
        picture = Picture(self.folder / "webp" / written["file"])
        self.assertEqual(written["file"], "animation.webp")
        self.assertEqual(picture.frames, written["frames"])

    def test_wrong_words_are_refused(self):
        for fragments, words in [
                (["'stres_1'", "did you mean 'stress_1'"],
                 ["--field", "stres_1"]),
                (["99", "0 to 30.19"], ["--times", "99"]),
                (["not a list"], ["--times", "soon"]),
                (["1200x800"], ["--size", "big"]),
                (["1200x800"], ["--size", "10x10"]),
                (["'tpo'", "oblique"], ["--view", "tpo"]),
                (["--frames"], ["--frames", "0"])]:
            with self.subTest(words):
                self.expect_refused(fragments, "render", self.results, *words)
        self.expect_refused(["no such folder", "did you mean",
                             f"{self.folder}/film"],
                            "render", self.folder / "flim")
        (self.folder / "empty").mkdir(exist_ok=True)
        self.expect_refused(["not the folder"], "render",
                            self.folder / "empty")

    def test_without_paraview_the_line_to_type_is_printed(self):
        path = make_path_without(self.folder / "bare", "pvbatch")
        self.expect_refused(
            ["ParaView", "apt install", "paraview python3-paraview xvfb"],
            "render", self.results, PATH=path)


class Lumped(FolderTest):
    def test_has_nothing_to_draw(self):
        run = self.run_case("demes/lumped.prm", "lumped")
        self.expect_refused(["fields.pvd", "taut report"], "render", run)


class Frame(FolderTest):
    """A film in a frame, bent out of the plane."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.results = cls.run_case("demes/bonded.prm", "bonded")

    def make_modes(self):
        """The folder of one mode whose shape is the displacement itself."""
        folder = self.folder / "modes"
        shutil.copytree(self.results, folder)
        for file in (folder / "fields").glob("*_0000[01].vtu"):
            text = file.read_text(encoding="latin-1")
            shape = re.search(r'<DataArray[^>]*Name="displacement".*?'
                              "</DataArray>", text, re.DOTALL)[0]
            shape = shape.replace('"displacement"', '"mode"')
            file.write_text(text.replace("</PointData>",
                                         shape + "</PointData>"),
                            encoding="latin-1")
        (folder / "fields.pvd").write_text(
            '<VTKFile type="Collection"><Collection>' + "".join(
                f'<DataSet timestep="{i}" part="{part}" '
                f'file="fields/{name}_0000{i}.vtu"/>'
                for i in (0, 1) for part, name in enumerate(("frame", "beams")))
            + "</Collection></VTKFile>", encoding="utf-8")
        (folder / "modes.csv").write_text("mode [1],frequency [Hz]\n1,4.5\n",
                                          encoding="utf-8")
        (folder / "run.json").write_text(
            '{"modes": {"stable": true, "frequencies": [4.5]}}',
            encoding="utf-8")
        return folder

    def test_frame_is_drawn_and_the_device_fills_the_picture(self):
        self.expect(0, "render", self.results, "--frames", "1", "--size",
                    "600x400")
        picture = Picture(self.results / "pictures" / "still_00.png")
        self.assertEqual(picture.find_edge_colours(), {(255, 255, 255)})
        rows = range(40, 320)
        dark = sum(1 for y in rows for x in range(600) if max(
            picture.get((x + .5) / 600, (y + .5) / 400)) < 100 and
            min(picture.get((x + .5) / 600, (y + .5) / 400)) > 30)
        drawn = sum(1 for y in rows for x in range(600) if picture.get(
            (x + .5) / 600, (y + .5) / 400) != (255, 255, 255))
        # Grey strips beside a coloured film.
        self.assertGreater(dark, 0.02 * 600 * 280)
        self.assertGreater(drawn, 0.2 * 600 * 280)

    def test_shapes_of_modes(self):
        folder = self.make_modes()
        self.expect(0, "render", folder, "--size", "300x200", "--animation")
        written = read_list(folder / "pictures")
        self.assertEqual(written["field"], "mode")
        self.assertEqual([still["name"] for still in written["stills"]],
                         ["mode 1: 4.5 Hz"])
        self.assertGreater(written["animation"]["frames"], 10)
        # The mode is added to the state.
        self.expect(0, "render", folder, "--size", "300x200", "--times", "0,1",
                    "--field", "stress_1")
        still = [Picture(folder / "pictures" / f"still_0{i}.png")
                 for i in (0, 1)]
        self.assertNotEqual(still[0].get_rows(.2, .8), still[1].get_rows(.2, .8))
        self.expect_refused(["no mode 7"], "render", folder, "--animation",
                            "--mode", "7")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
