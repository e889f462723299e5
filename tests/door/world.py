"""A world of stand-ins around ./taut: every tool that installs or builds is a
small script that notes its call, so that nothing real is ever touched."""

import os
import shutil
import subprocess
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]

REAL_TOOLS = ["awk", "bash", "cat", "chmod", "dirname", "env", "find", "flock",
              "grep", "head", "mkdir", "nproc", "readlink", "rm", "sed", "sh",
              "sort", "tail", "uname"]

STAND_INS = {
    "id": 'cat "$WORLD/uid"',
    "dpkg-query": '''
for package in "$@"; do
  grep -qx -e "$package" "$WORLD/installed" && echo "installed $package"
done''',
    "apt-get": '''
echo "APT $*" >&2
for word in "$@"; do echo "$word" >>"$WORLD/installed"; done''',
    "sudo": '''
[ -e "$WORLD/sudo_refuses" ] && exit 1
while [ "${1#-}" != "$1" ]; do shift; done
"$@"''',
    "cmake": '''
[ "$1" = --version ] && echo "cmake version 3.25.1" && exit 0
[ -e "$WORLD/cmake_fails" ] && exit 1
mkdir -p "$TREE/build/release"
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$TREE" >"$TREE/build/release/CMakeCache.txt"
: >"$TREE/build/release/build.ninja"''',
    "ninja": '''
case " $* " in *" -n "*)
  [ -e "$WORLD/built" ] && echo "ninja: no work to do." || echo "[1/1] CXX"
  exit 0 ;;
esac
[ -e "$WORLD/ninja_fails" ] && exit 1
mkdir -p "$TREE/build/release/source/app"
cat "$WORLD/program" >"$TREE/build/release/source/app/taut"
chmod +x "$TREE/build/release/source/app/taut"
echo "[1/1] LINK taut"
: >"$WORLD/built"''',
    "ctest": 'exit "${STAND_IN_EXIT:-0}"',
    "c++": "echo 12.2.0",
    "update-alternatives": 'echo "Value: $(cat "$WORLD/blas")"',
}

PROGRAM = '''#!/bin/sh
echo "in $(pwd)"
for word in "$@"; do echo "word $word"; done
env | sort | grep -E '^(OMP_|OMPI_|OPENBLAS_|DEAL_II_)'
exit "${STAND_IN_EXIT:-0}"
'''


class World:
    """A copy of the door in a folder with spaces, a PATH and a call log."""

    def __init__(self, folder):
        self.folder = Path(folder).resolve()
        self.tree = self.folder / "a tree with spaces"
        self.tools = self.folder / "tools"
        (self.tree / ".ci").mkdir(parents=True)
        self.tools.mkdir()
        shutil.copy(SOURCE / "taut", self.tree / "taut")
        shutil.copy(SOURCE / ".ci" / "run", self.tree / ".ci" / "run")
        self.note("uid", "0")
        self.note("blas", "/usr/lib/openblas-serial/libblas.so.3")
        self.note("installed", "")
        self.note("program", PROGRAM)
        for tool in REAL_TOOLS:
            (self.tools / tool).symlink_to(shutil.which(tool))
        for tool, body in STAND_INS.items():
            self.add_tool(tool, body)

    def note(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def add_tool(self, name, body):
        script = self.tools / name
        script.write_text(f'#!/bin/sh\necho "{name} $*" >>"$WORLD/calls"\n{body}\n',
                          encoding="utf-8")
        script.chmod(0o755)

    def remove_tools(self, *names):
        for name in names:
            (self.tools / name).unlink()

    def get_environment(self, **extra):
        return {"PATH": str(self.tools), "WORLD": str(self.folder),
                "TREE": str(self.tree), "HOME": str(self.folder), **extra}

    def start(self, *words, door=None, directory=None, **extra):
        """The process of ./taut WORDS with the variables `extra`."""
        return subprocess.Popen(
            [str(door or self.tree / "taut"), *words],
            cwd=directory or self.tree, env=self.get_environment(**extra),
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True)

    def call(self, *words, **options):
        """Runs ./taut WORDS; the result has returncode, stdout, stderr."""
        process = self.start(*words, **options)
        stdout, stderr = process.communicate(timeout=60)
        return subprocess.CompletedProcess(words, process.returncode, stdout, stderr)

    def take_calls(self, *names):
        """The calls noted since the last time, of the tools `names` or all."""
        log = self.folder / "calls"
        lines = log.read_text(encoding="utf-8").splitlines() if log.exists() else []
        log.unlink(missing_ok=True)
        return [line for line in lines if not names or line.split()[0] in names]
