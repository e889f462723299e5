#!/usr/bin/env python3
"""Fails when the sources leave the house rules.

Usage: check_layers.py SOURCE_DIRECTORY

The rules: a layer includes only the layers below it; some libraries stay out
of some layers; a header starts with #pragma once; a source file belongs to a
header of its layer; no file grows over MAXIMUM_LINES.
"""

import re
import sys
from pathlib import Path

# What each layer may include besides itself; the diagram is in README.md.
BELOW = {
    "base": set(),
    "material": {"base"},
    "time": {"base"},
    "lumped": {"time", "base"},
    "fe": {"material", "base"},
    "structure": {"fe", "time", "material", "base"},
}
BELOW["study"] = BELOW["structure"] | {"structure", "lumped"}
BELOW["io"] = BELOW["study"] | {"study"}
BELOW["app"] = BELOW["io"] | {"io"}

FILE_LAYERS = {"io", "app"}

# (what it is, pattern of the include, layers that may have it)
RESTRICTED = [
    ("deal.II", re.compile(r"deal\.II/"), set(BELOW) - {"material"}),
    ("ParameterHandler", re.compile(r"deal\.II/base/parameter_handler\.h$"),
     FILE_LAYERS),
    ("file access", re.compile(r"(fstream|filesystem)$"), FILE_LAYERS),
    ("gmsh", re.compile(r"(deal\.II/)?gmsh"), FILE_LAYERS),
    ("VTK", re.compile(r"(deal\.II/)?vtk"), FILE_LAYERS),
    ("SUNDIALS",
     re.compile(r"(deal\.II/)?(sundials|arkode|cvodes?|idas?|kinsol|nvector"
                r"|sunmatrix|sunlinsol|sunnonlinsol)/"),
     {"time"}),
]

TREES = ("include", "source", "tests", "benchmarks")
SUFFIXES = {".h", ".cc", ".py"}
MAXIMUM_LINES = 400
# Files that may be longer, each with its reason.
LONG_FILES = {}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


def get_layer(path):
    """The layer of a path relative to the source directory, or None."""
    parts = path.parts
    if parts[:2] == ("include", "taut"):
        return parts[2] if len(parts) > 3 else ""
    if parts[0] == "source":
        return parts[1] if len(parts) > 2 else ""
    if parts[0] == "tests" and len(parts) > 2 and parts[1] in BELOW:
        return parts[1]
    return None


def get_included_layer(root, path, target):
    """The layer that `target`, included by `path`, lies in, or None."""
    if target.startswith("taut/"):
        return target.split("/")[1]
    for folder in ((root / path).parent, root / "tests", root / "source"):
        found = (folder / target).resolve()
        if found.is_file() and found.is_relative_to(root):
            return get_layer(found.relative_to(root))
    return None


def check_include(root, path, layer, target):
    """The complaints about one include."""
    included = get_included_layer(root, path, target)
    if included is not None and included not in BELOW:
        yield f"<{target}> is in no layer; layers are {', '.join(BELOW)}"
    elif included is not None and included not in BELOW[layer] | {layer}:
        yield f"layer {layer} must not include {included}: <{target}>"
    for name, pattern, layers in RESTRICTED:
        if pattern.match(target) and layer not in layers:
            yield f"layer {layer} must not include {name}: <{target}>"


def check_includes(root, path, text):
    """The complaints about the includes of one file, with their line."""
    layer = get_layer(path)
    if layer not in BELOW:
        return
    for number, line in enumerate(text.splitlines(), start=1):
        match = INCLUDE.match(line)
        if match:
            for complaint in check_include(root, path, layer, match[1]):
                yield f"{path}:{number}: {complaint}"


def check_place(root, path):
    """A layer's file lies where its name says; app has only its sources."""
    layer = get_layer(path)
    if layer is not None and layer not in BELOW:
        yield f"{path}: lies in no layer; layers are {', '.join(BELOW)}"
    elif path.parts[0] == "source" and path.suffix == ".cc" and layer != "app":
        headers = (root / "include" / "taut" / layer).glob("*.h")
        stems = [header.stem for header in headers]
        if not any(f"{path.stem}_".startswith(f"{stem}_") for stem in stems):
            yield f"{path}: implements no header of include/taut/{layer}"


def check_form(path, text):
    """Header guard and length."""
    if path.suffix == ".h":
        if not COMMENT.sub("", text).lstrip().startswith("#pragma once"):
            yield f"{path}:1: a header begins with #pragma once"
    lines = text.count("\n")
    if lines > MAXIMUM_LINES and str(path) not in LONG_FILES:
        yield f"{path}: {lines} lines, more than {MAXIMUM_LINES}: split it"


def check_tree(root):
    """All complaints about the tree below `root`."""
    root = Path(root).resolve()
    complaints = []
    for tree in TREES:
        for file in sorted((root / tree).rglob("*")):
            if file.suffix in SUFFIXES and file.is_file():
                path = file.relative_to(root)
                text = file.read_text(encoding="utf-8")
                complaints += check_includes(root, path, text)
                complaints += check_place(root, path)
                complaints += check_form(path, text)
    return complaints


def main():
    if len(sys.argv) != 2 or not (Path(sys.argv[1]) / "include").is_dir():
        sys.exit(__doc__)
    complaints = check_tree(sys.argv[1])
    print("\n".join(complaints) or "The layers are in order.")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
