#!/usr/bin/env python3
"""The behaviour of ./taut, without installing or building anything."""

import fcntl
import shutil
import tempfile
import time
import unittest

from world import World

CHANGING_TOOLS = ("apt-get", "sudo", "cmake", "ninja", "dpkg-query")
MPI = {"OMPI_COMM_WORLD_SIZE": "2", "OMPI_COMM_WORLD_RANK": "0"}


class DoorTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.mkdtemp(prefix="taut door ")
        self.addCleanup(shutil.rmtree, folder)
        self.world = World(folder)

    def expect(self, code, result):
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def build(self):
        self.expect(0, self.world.call("check", "case.prm"))
        self.world.take_calls()


class Handover(DoorTest):
    def test_program_gets_words_directory_and_a_clean_stdout(self):
        result = self.expect(0, self.world.call(
            "run", "my case.prm", "--set", "Film/Thickness = 1e-4",
            directory=self.world.folder))
        lines = result.stdout.splitlines()
        self.assertEqual(lines[:5], [
            f"in {self.world.folder}", "word run", "word my case.prm",
            "word --set", "word Film/Thickness = 1e-4"])
        self.assertNotIn("LINK", result.stdout)
        self.assertIn("LINK", result.stderr)

    def test_exit_codes_of_the_program_pass_through(self):
        for code in (0, 2, 3, 4):
            with self.subTest(code):
                self.expect(code, self.world.call("run", STAND_IN_EXIT=str(code)))

    def test_works_through_chained_symlinks(self):
        first, second = self.world.folder / "one link", self.world.folder / "two"
        first.symlink_to(self.world.tree / "taut")
        second.symlink_to(first.name)
        result = self.world.call("run", door=second, directory="/")
        self.assertIn("in /\n", self.expect(0, result).stdout)

    def test_second_use_asks_ninja_only_and_says_nothing(self):
        self.build()
        result = self.expect(0, self.world.call("run"))
        self.assertEqual(result.stderr, "")
        calls = self.world.take_calls(*CHANGING_TOOLS)
        self.assertEqual(len(calls), 1, calls)
        self.assertRegex(calls[0], r"^ninja .* -n taut_program$")

    def test_changed_sources_are_rebuilt(self):
        self.build()
        (self.world.folder / "built").unlink()
        self.expect(0, self.world.call("run"))
        self.assertEqual(len(self.world.take_calls("ninja")), 2)

    def test_moved_tree_is_configured_anew(self):
        self.build()
        moved = self.world.folder / "another place"
        self.world.tree.rename(moved)
        self.world.tree = moved
        self.expect(0, self.world.call("run"))
        self.assertEqual(len(self.world.take_calls("cmake")), 1)

    def test_threads_of_libraries_are_one_unless_set(self):
        result = self.world.call("run", OMP_NUM_THREADS="3")
        for line in ("OMP_NUM_THREADS=3", "OPENBLAS_NUM_THREADS=1",
                     "DEAL_II_NUM_THREADS=1", "OMPI_ALLOW_RUN_AS_ROOT=1",
                     "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"):
            self.assertIn(line, result.stdout.splitlines())

    def test_normal_users_get_no_root_variables(self):
        self.build()
        self.world.note("uid", "1000")
        self.assertNotIn("ALLOW_RUN_AS_ROOT", self.world.call("run").stdout)

    def test_failed_build_is_exit_code_1(self):
        self.world.note("ninja_fails", "")
        self.assertIn("could not be built",
                      self.expect(1, self.world.call("run")).stderr)
        self.world.note("cmake_fails", "")
        shutil.rmtree(self.world.tree / "build")
        self.assertIn("could not configure",
                      self.expect(1, self.world.call("run")).stderr)


class Packages(DoorTest):
    def test_missing_packages_are_named_before_they_are_installed(self):
        result = self.expect(0, self.world.call("run"))
        announced = result.stderr.index("  libdeal.ii-dev\n")
        installed = result.stderr.index("install --no-install-recommends")
        self.assertLess(announced, installed)
        self.assertIn("APT --yes", result.stderr)

    def test_only_what_is_missing_is_installed(self):
        self.world.call("run")
        installed = (self.world.folder / "installed").read_text(encoding="utf-8")
        self.world.note("installed", installed.replace("libfmt-dev\n", ""))
        shutil.rmtree(self.world.tree / "build")
        self.world.take_calls()
        self.world.call("run")
        install = self.world.take_calls("apt-get")[-1]
        self.assertTrue(install.endswith("--no-install-recommends libfmt-dev"), install)

    def test_sudo_is_used_without_asking(self):
        self.world.note("uid", "1000")
        self.expect(0, self.world.call("run"))
        calls = self.world.take_calls("sudo")
        self.assertTrue(calls)
        for call in calls:
            self.assertIn("--non-interactive", call)

    def test_without_root_the_line_to_type_is_printed(self):
        self.world.note("uid", "1000")
        self.world.note("sudo_refuses", "")
        result = self.expect(2, self.world.call("run"))
        self.assertRegex(result.stderr, r"\nsudo sh -c 'apt-get .*libdeal\.ii-dev.*'\n")
        self.world.remove_tools("sudo")
        result = self.expect(2, self.world.call("run"))
        self.assertRegex(result.stderr, r"\nsu -c 'apt-get .*libdeal\.ii-dev.*'\n")
        self.assertEqual(self.world.take_calls("apt-get", "cmake", "ninja"), [])

    def test_failed_installation_is_refused_and_tried_again(self):
        self.world.add_tool("apt-get", "exit 100")
        self.assertIn("could not be installed",
                      self.expect(2, self.world.call("run")).stderr)
        self.world.take_calls()
        self.expect(2, self.world.call("run"))
        self.assertTrue(self.world.take_calls("apt-get"))

    def test_own_dealii_and_other_openblas_serve(self):
        result = self.world.call("run", DEAL_II_DIR="/opt/dealii")
        self.assertNotIn("libdeal.ii-dev", result.stderr)
        self.assertNotIn("libopenblas0-serial", result.stderr)

    def test_first_use_says_which_blas_runs(self):
        self.assertIn("BLAS /usr/lib/openblas-serial/libblas.so.3",
                      self.world.call("run").stderr)

    def test_slow_blas_is_reported_each_time(self):
        self.build()
        self.world.note("blas", "/usr/lib/blas/libblas.so.3")
        self.assertIn("BLAS in use is /usr/lib/blas", self.world.call("run").stderr)

    def test_other_systems_are_refused_with_what_they_need(self):
        self.world.remove_tools("apt-get", "cmake")
        result = self.expect(2, self.world.call("run"))
        for word in ("no apt-get", "deal.II 9.4", "MPI", "PETSc", "p4est",
                     "SUNDIALS", "gmsh", "DEAL_II_DIR", "podman build"):
            self.assertIn(word, result.stderr)

    def test_other_systems_serve_if_cmake_finds_everything(self):
        self.world.remove_tools("apt-get", "dpkg-query")
        self.expect(0, self.world.call("run"))
        shutil.rmtree(self.world.tree / "build")
        self.world.note("cmake_fails", "")
        self.assertIn("podman", self.expect(2, self.world.call("run")).stderr)


class Pictures(DoorTest):
    """ParaView and a browser are large: installed when used, not before."""

    LARGE = ("paraview", "chromium-headless-shell")

    def get_installed(self):
        file = self.world.folder / "installed"
        return file.read_text(encoding="utf-8").splitlines()

    def add_paraview(self):
        for tool in ("pvbatch", "Xvfb"):
            self.world.add_tool(tool, "")

    def test_other_commands_do_without(self):
        for command in ("run", "compare", "modes", "study", "report", "check"):
            self.expect(0, self.world.call(command, "x"))
        self.expect(0, self.world.call("test", "--quick"))
        self.expect(0, self.world.call("render", "--help"))
        for package in self.LARGE:
            self.assertNotIn(package, self.get_installed())

    def test_render_installs_paraview_and_no_browser(self):
        result = self.expect(0, self.world.call("render", "a run"))
        self.assertIn("word a run", result.stdout)
        for package in ("paraview", "python3-paraview", "xvfb"):
            self.assertIn(package, self.get_installed())
        self.assertNotIn("chromium-headless-shell", self.get_installed())

    def test_what_is_there_is_used(self):
        self.build()
        self.add_paraview()
        self.expect(0, self.world.call("render", "run"))
        self.assertEqual(self.world.take_calls("apt-get", "dpkg-query"), [])

    def test_paraview_that_was_removed_is_installed_again(self):
        self.world.call("render", "run")
        self.world.note("installed", "\n".join(
            set(self.get_installed()) - {"paraview"}) + "\n")
        self.world.call("render", "run")
        self.assertIn("paraview", self.get_installed())

    def test_without_root_the_line_to_type_is_printed(self):
        self.build()
        self.world.note("uid", "1000")
        self.world.note("sudo_refuses", "")
        result = self.expect(2, self.world.call("render", "run"))
        self.assertRegex(result.stderr, r"sudo sh -c 'apt-get .*paraview.*'")

    def test_nothing_is_installed_under_mpi(self):
        self.build()
        self.expect(0, self.world.call("render", "run", **MPI))
        self.assertEqual(self.world.take_calls(*CHANGING_TOOLS), [])

    def test_the_full_tests_install_both(self):
        self.expect(0, self.world.call("test"))
        for package in self.LARGE:
            self.assertIn(package, self.get_installed())

    def test_any_chromium_serves(self):
        self.world.add_tool("chromium", "")
        self.expect(0, self.world.call("test"))
        self.assertNotIn("chromium-headless-shell", self.get_installed())


class Processes(DoorTest):
    def test_nothing_is_installed_or_built_under_mpi(self):
        for variables in (MPI, {"PMI_SIZE": "2"}, {"PMIX_RANK": "0"}):
            for command in ("run", "test", "build", "clean"):
                with self.subTest(command=command, **variables):
                    result = self.world.call(command, **variables)
                    self.assertIn("MPI", self.expect(2, result).stderr)
        self.assertEqual(self.world.take_calls(*CHANGING_TOOLS), [])

    def test_one_rank_speaks_for_all(self):
        other = self.world.call("run", **{**MPI, "OMPI_COMM_WORLD_RANK": "1"})
        self.assertEqual(self.expect(2, other).stderr, "")

    def test_a_built_program_runs_under_mpi(self):
        self.build()
        self.expect(4, self.world.call("run", STAND_IN_EXIT="4", **MPI))
        self.assertEqual(self.world.take_calls(*CHANGING_TOOLS), [])

    def test_a_second_call_waits_for_the_first(self):
        (self.world.tree / "build").mkdir()
        with open(self.world.tree / "build" / ".lock", "w", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            process = self.world.start("run")
            self.assertIn("waiting", process.stderr.readline())
            time.sleep(0.2)
            self.assertIsNone(process.poll())
            self.assertEqual(self.world.take_calls(*CHANGING_TOOLS), [])
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0)

    def test_the_lock_is_free_while_the_program_runs(self):
        self.build()
        self.world.note("program", "#!/bin/sh\nflock -n \"$LOCK\" sh -c 'echo free'\n")
        (self.world.folder / "built").unlink()
        lock = str(self.world.tree / "build" / ".lock")
        self.assertEqual(self.world.call("run", LOCK=lock).stdout, "free\n")


class Commands(DoorTest):
    def test_help_touches_nothing(self):
        for words in ((), ("help",), ("--help",), ("-h",)):
            result = self.expect(0, self.world.call(*words))
            self.assertIn("./taut run CASE.prm", result.stdout)
            self.assertIn("./taut test", result.stdout)
        self.assertEqual(self.world.take_calls(*CHANGING_TOOLS), [])

    def test_unknown_words_are_refused_with_the_nearest(self):
        for word, nearest in [("rum", "run"), ("compre", "compare"),
                              ("tests", "test"), ("descibe", "describe"),
                              ("repot", "report"), ("rendr", "render"),
                              ("mode", "modes"), ("sudy", "study")]:
            with self.subTest(word):
                result = self.expect(2, self.world.call(word))
                self.assertIn(f"did you mean '{nearest}'?", result.stderr)
        result = self.expect(2, self.world.call("xyzzyx"))
        self.assertNotIn("did you mean", result.stderr)
        self.assertIn("known are: run compare", result.stderr)
        self.assertEqual(self.world.take_calls(*CHANGING_TOOLS), [])

    def test_a_case_without_a_command_is_explained(self):
        result = self.expect(2, self.world.call("my case.prm"))
        self.assertIn("did you mean './taut run my case.prm'?", result.stderr)

    def test_labels_of_the_tests(self):
        for words, labels in [((), "^(quick|full)$"), (("--quick",), "^(quick)$"),
                              (("--long",), "^(quick|full|long)$")]:
            with self.subTest(words):
                self.expect(0, self.world.call("test", *words))
                call, = self.world.take_calls("ctest")
                self.assertTrue(call.endswith(f"--label-regex {labels}"), call)

    def test_words_after_two_dashes_reach_ctest(self):
        self.expect(8, self.world.call("test", "--quick", "--", "-R", "film",
                                       STAND_IN_EXIT="8"))
        call, = self.world.take_calls("ctest")
        self.assertTrue(call.endswith("-R film"), call)

    def test_unknown_options_of_test_are_refused_before_any_work(self):
        result = self.expect(2, self.world.call("test", "--fast"))
        self.assertIn("--quick, --long", result.stderr)
        self.assertEqual(self.world.take_calls(*CHANGING_TOOLS), [])

    def test_continuous_integration_runs_the_default_tests(self):
        door = self.world.tree / ".ci" / "run"
        self.expect(0, self.world.call(door=door, directory="/"))
        call, = self.world.take_calls("ctest")
        self.assertTrue(call.endswith("--label-regex ^(quick|full)$"), call)

    def test_clean_removes_what_was_built(self):
        self.build()
        self.expect(0, self.world.call("clean"))
        self.assertFalse((self.world.tree / "build").exists())
        self.assertTrue((self.world.tree / "taut").exists())


if __name__ == "__main__":
    unittest.main()
