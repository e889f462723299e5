#!/usr/bin/env python3
"""`taut report`: its pages in a browser, on a phone and a desk, dark and light.

Usage: report_test.py PROGRAM SOURCE_FOLDER
"""

import csv
import json
import math
import re
import shutil
import sys
import unittest

from browser import Browser
from program import FolderTest, make_path_without

FAILED, STOPPED_BY_EVENT = 3, 4
PHONE, DESK = 360, 1440
# WCAG 2.1: text at least 4.5, lines of charts at least 3.
TEXT_CONTRAST, LINE_CONTRAST = 4.5, 3.0
# px; the smallest text is that of the charts.
SMALLEST_TEXT = 9


class PageTest(FolderTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.browser = cls.enterClassContext(Browser())

    def report(self, folder, *words, **environment):
        self.expect(0, "report", folder, *words, **environment)
        return folder / "report.html"

    def assert_self_contained(self, page):
        """Nothing is loaded but what is in the file."""
        text = page.read_text(encoding="utf-8")
        for address in re.findall(r'(?:src|href|srcset|poster)="([^"]*)"', text):
            self.assertRegex(address, "^(#|data:)")
        self.assertNotRegex(text, r"url\(|@import|<script|<link")
        for target in re.findall(r'href="#(\w+)"', text):
            self.assertIn(f'id="{target}"', text)

    def assert_readable(self, found, scheme):
        self.assertEqual(found["errors"], [])
        self.assertEqual(found["requests"], [])
        self.assertEqual(len(found["files"]), 1)
        self.assertEqual(found["wide"], [])
        self.assertLessEqual(found["scroll_width"], found["width"])
        self.assertGreater(found["texts"], 10)
        self.assertGreaterEqual(found["worst"]["contrast"], TEXT_CONTRAST,
                                found["worst"])
        self.assertGreaterEqual(found["lines"], LINE_CONTRAST)
        self.assertGreaterEqual(found["smallest"], SMALLEST_TEXT)
        self.assertEqual(found["unnamed"], 0)
        self.assertEqual(found["tables_without_caption"], 0)
        self.assertEqual(found["broken_images"], 0)
        brightness = sum(map(int, re.findall(r"\d+", found["background"])))
        self.assertEqual(brightness < 3 * 128, scheme == "dark")

    def assert_good_page(self, page):
        """In all four looks; what is found in the last."""
        self.assert_self_contained(page)
        for width in (PHONE, DESK):
            for scheme in ("light", "dark"):
                with self.subTest(width=width, scheme=scheme):
                    self.browser.open(page, width, scheme)
                    found = self.browser.check()
                    self.assertEqual(found["width"], width)
                    self.assert_readable(found, scheme)
        return found

    def read_heads(self, found):
        return [head[3:] for head in found["headings"] if head[:2] == "H2"]


class Runs(PageTest):
    def test_film_with_pictures_that_an_event_stops(self):
        run = self.run_case("film/failure.prm", "film", code=STOPPED_BY_EVENT)
        page = self.report(run)
        found = self.assert_good_page(page)
        self.assertEqual(self.read_heads(found), [
            "Overview", "Pictures", "Histories", "Events", "Energies",
            "Parameters", "Run"])
        before, after = found["text"].split("Overview", 1)
        self.assertIn("Stopped by an event at t = 30.19 s", before)
        self.assertIn("event 'pull-in' in film", before)
        # What happened, what was set, with units, and what it is not.
        for text in ("26.3 s", "ends the run", "960 kg/m³", "17e6 V/m", "PETSc",
                     "evaluations", "Energy balance"):
            self.assertIn(text, after)
        text = page.read_text(encoding="utf-8")
        self.assertEqual(len(re.findall('<img src="data:image/webp', text)), 4)
        # Pictures are drawn once for a run.
        drawn = run / "pictures" / "still_00.png"
        time = drawn.stat().st_mtime_ns
        self.report(run)
        self.assertEqual(drawn.stat().st_mtime_ns, time)

    def test_film_without_paraview(self):
        run = self.run_case("film/failure.prm", "bare", code=STOPPED_BY_EVENT)
        path = make_path_without(self.folder / "tools", "pvbatch")
        found = self.assert_good_page(self.report(run, PATH=path))
        self.assertIn("apt install --no-install-recommends paraview",
                      found["text"])

    def test_failed_run_says_so_first(self):
        run = self.run_case(
            "film/failure.prm", "failed", "--set",
            "Material acrylic/Dielectric/Breakdown law = stretch(0.63; 1, 1.3)",
            code=FAILED)
        found = self.assert_good_page(self.report(run, "--no-pictures"))
        summary = json.loads((run / "run.json").read_text(encoding="utf-8"))
        before, after = found["text"].split("Overview", 1)
        self.assertIn("Failed at t = ", before)
        self.assertIn(summary["reason"].strip(), before)
        # What came before is shown.
        self.assertIn("Histories", after)

    def test_killed_run_says_so_first(self):
        run = self.run_case("demes/lumped.prm", "killed")
        (run / "run.json").unlink()
        history = (run / "history.csv").read_text(encoding="utf-8")
        lines = history.splitlines()[:101]
        # The last row was cut while it was written.
        (run / "history.csv").write_text("\n".join(lines) + "\n0.5,50",
                                         encoding="utf-8")
        found = self.assert_good_page(self.report(run))
        before, after = found["text"].split("Histories", 1)
        self.assertIn("Did not finish", before)
        self.assertIn("495 ms, after 100 rows", before)
        self.assertIn("Energies", after)

    def test_folder_with_little_more_than_parameters(self):
        run = self.run_case("demes/lumped.prm", "early")
        for name in ("run.json", "history.csv", "events.csv", "log.txt"):
            (run / name).unlink()
        self.expect(0, "report", run)
        text = (run / "report.html").read_text(encoding="utf-8")
        self.assertIn("It wrote no history", text)

    def test_interrupted_run_says_how_to_go_on(self):
        run = self.run_case("demes/lumped.prm", "interrupted")
        summary = json.loads((run / "run.json").read_text(encoding="utf-8"))
        summary["status"] = "interrupted"
        (run / "run.json").write_text(json.dumps(summary), encoding="utf-8")
        found = self.assert_good_page(self.report(run))
        before = found["text"].split("Overview", 1)[0]
        self.assertIn("Interrupted at t = 5 s", before)
        self.assertIn("--resume", before)

    def test_lumped_run_shows_its_extremes(self):
        run = self.run_case("demes/lumped.prm", "lumped")
        page = self.report(run)
        found = self.assert_good_page(page)
        self.assertIn("Completed at t = 5 s", found["text"])
        self.assertNotIn("Pictures", self.read_heads(found))
        with open(run / "history.csv", encoding="utf-8") as stream:
            angles = [float(row["angle [rad]"])
                      for row in csv.DictReader(stream)]
        self.assertIn(f"{min(angles):.4g} to {max(angles):.4g} rad",
                      found["text"])

    def test_path_has_unstable_parts(self):
        run = self.run_case("film/gent_snap.prm", "path")
        page = self.report(run, "--no-pictures")
        found = self.assert_good_page(page)
        self.assertIn("dashed: unstable", found["text"])
        self.assertIn("limit point", found["text"])
        self.assertIn('stroke-dasharray="5 3"',
                      page.read_text(encoding="utf-8"))


class Tables(PageTest):
    """Folders written by hand."""

    def make_run(self, name, summary, **tables):
        run = self.folder / name
        run.mkdir()
        (run / "run.json").write_text(json.dumps(summary), encoding="utf-8")
        for stem, text in tables.items():
            (run / f"{stem}.csv").write_text(text, encoding="utf-8")
        return run

    def test_what_users_write_is_text(self):
        nasty = "<script>alert('x')</script> & \"quoted\" <b>"
        run = self.make_run("nasty", {
            "status": "failed", "reason": nasty, "time_reached": 1.0,
            "notes": [nasty], "parameters_changed": {
                f"Film {nasty}/Title": {"default": nasty, "value": nasty}}},
            history=f"time [s],{nasty.replace(chr(34), '')} [1]\n0,1\n1,2\n")
        (run / "log.txt").write_text(nasty, encoding="utf-8")
        (run / "parameters.prm").write_text(f"set Title = {nasty}\n",
                                            encoding="utf-8")
        found = self.assert_good_page(self.report(run))
        self.assertEqual(found["headings"][0], f"H1 {nasty}")
        self.assertGreaterEqual(found["text"].count(nasty), 6)

    def test_long_history_is_thinned_but_keeps_its_peak(self):
        rows = [f"{i * 1e-4:.4f},{math.sin(i * 0.01):.6f}"
                for i in range(100_000)]
        rows[54_321] = "5.4321,7.5"
        run = self.make_run("long", {"status": "completed"},
                            history="time [s],swing [m]\n" + "\n".join(rows))
        page = self.report(run)
        self.assert_good_page(page)
        text = page.read_text(encoding="utf-8")
        self.assertLess(len(text), 100_000)
        curve = re.search(r'<path d="(M[^"]*)"[^>]*class="curve"', text)[1]
        places = [tuple(map(float, pair.split())) for pair in
                  re.split("[ML]", curve) if pair]
        # The peak is the highest place, 54 % of the way, alone.
        highest = min(places, key=lambda place: place[1])
        left, right = places[0][0], places[-1][0]
        self.assertAlmostEqual((highest[0] - left) / (right - left), .54321,
                               delta=.01)
        others = sorted(place[1] for place in places)
        self.assertGreater(others[1], highest[1] + 50)

    def test_modes_motion_and_response(self):
        run = self.make_run(
            "findings",
            {"status": "completed",
             "modes": {"stable": False, "frequencies": [None, 12.5]},
             "motion": {"class": "quasi-periodic", "lyapunov_exponent": -0.25,
                        "reproducible": True}},
            modes="mode [1],frequency [Hz],effective mass x [kg]\n"
                  "1,,0.001\n2,12.5,0.002\n",
            section="time [s],angle [rad],angular velocity [rad/s]\n"
                    "1,0.1,2\n2,0.2,3\n3,0.15,1\n",
            spectrum="frequency [Hz],amplitude [rad]\n0,0\n1,0.5\n2,0.1\n",
            response="frequency [Hz],direction [1],amplitude [rad],settled [1]\n"
                     "1,1,0.1,1\n2,1,0.4,1\n2,-1,0.2,1\n1,-1,0.1,1\n")
        found = self.assert_good_page(self.report(run))
        for text in ("not stable", "12.5", "quasi-periodic", "Lyapunov".lower(),
                     "up", "down"):
            self.assertIn(text, found["text"])
        self.assertEqual(self.read_heads(found)[1:],
                         ["Modes", "Motion", "Frequency response"])

    def test_comparison(self):
        run = self.make_run("comparison", {"status": "completed"},
                            compare="time [s],voltage [V],stretch film [1],"
                                    "stretch lumped [1]\n0,0,2,2\n1,5,2.2,2.4\n")
        (run / "compare.json").write_text(json.dumps({
            "quantities": [{"name": "stretch", "max_relative_difference": 0.083,
                            "rms_relative_difference": 0.05,
                            "time_of_max": 1.0}]}), encoding="utf-8")
        found = self.assert_good_page(self.report(run))
        for text in ("against lumped models", "0.083", "film", "lumped"):
            self.assertIn(text, found["text"])

    def make_study(self, name, bad):
        """A grid of three voltages and forty frequencies."""
        folder = self.folder / name
        folder.mkdir()
        rows = []
        for case in range(120):
            voltage, frequency = 1000 * (case // 40 + 1), 0.5 + case % 40 / 10
            status, reason, angle = "completed", "", 0.1 * (case % 7)
            if case in bad:
                status, reason, angle = "failed", f"limit <{case}>", ""
            rows.append(f"{case},{voltage},{frequency},{angle},5,0.01,{status},"
                        f'"{reason}","voltage={voltage}, frequency={frequency}"')
        (folder / "study.csv").write_text(
            "case [1],voltage [V],frequency [Hz],angle [rad],time reached [s],"
            "seconds [s],status,reason,folder\n" + "\n".join(rows) + "\n",
            encoding="utf-8")
        (folder / "study.json").write_text(json.dumps({
            "title": "Three voltages", "status": "completed",
            "cases": {"total": 120}, "case_file": "case.prm",
            "command": "run", "seconds": 3.5, "variables": [
                {"name": "voltage", "unit": "V", "key": "Electrode a/Voltage",
                 "values": ["1000", "2000", "3000"]},
                {"name": "frequency", "unit": "Hz", "key": "Signal/Frequency",
                 "values": ["0.5", "0.6"]}]}), encoding="utf-8")
        return folder

    def test_study_names_its_failures_first(self):
        study = self.make_study("study", bad={7, 50})
        (study / "figure.svg").write_text(
            '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>',
            encoding="utf-8")
        page = self.report(study)
        found = self.assert_good_page(page)
        before = found["text"].split("Failed cases", 1)[0]
        self.assertIn("2 of 120 cases did not succeed", before)
        self.assertEqual(self.read_heads(found), [
            "Failed cases", "Overview", "Plots of the study", "Results",
            "Cases"])
        for text in ("limit <7>", "limit <50>", "voltage = 2 kV",
                     "Electrode a/Voltage"):
            self.assertIn(text, found["text"])
        text = page.read_text(encoding="utf-8")
        # One curve for each voltage, and a row for each case.
        self.assertEqual(len(set(re.findall(r"stroke:var\(--series-\d\)",
                                            text))), 3)
        self.assertEqual(text.count("<td class=\"words\">completed"), 118)

    def test_study_without_failures_and_unfinished(self):
        study = self.make_study("good", bad=set())
        self.report(study)
        text = (study / "report.html").read_text(encoding="utf-8")
        self.assertIn("All 120 cases done", text)
        (study / "study.json").unlink()
        found = self.assert_good_page(self.report(study))
        self.assertIn("Not finished", found["text"].split("Results")[0])

    def test_wrong_folders_are_refused(self):
        self.expect_refused(["no such folder"], "report",
                            self.folder / "nowhere")
        (self.folder / "nothing").mkdir()
        self.expect_refused(["not the folder of a run"], "report",
                            self.folder / "nothing")

    def test_without_python_the_line_to_type_is_printed(self):
        run = self.make_run("no python", {"status": "completed"})
        self.expect_refused(["python3-matplotlib"], "report", run,
                            TAUT_PYTHON="/bin/false")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
