"""A camera that shows the whole motion of a device, with room for labels."""

import math
from dataclasses import dataclass

import numpy as np

# Where the camera stands, seen from the device, and what is up.
VIEWS = {
    "top": ((0, 0, 1), (0, 1, 0)),
    "front": ((0, -1, 0), (0, 0, 1)),
    "side": ((1, 0, 0), (0, 0, 1)),
    "oblique": ((0.6, -1.6, 0.6), (0, 0, 1)),
}
# A device thinner than this, relative to its size, is looked at along its
# thinnest direction.
FLAT = 0.07
# Shares of the picture's height that the labels take below and above.
BELOW, ABOVE, BESIDE = 0.19, 0.08, 0.05


@dataclass
class Camera:
    """A parallel projection."""

    direction: np.ndarray
    up: np.ndarray
    focus: np.ndarray
    half_height: float


def choose_view(places):
    extents = np.ptp(places, axis=0)
    thinnest = int(np.argmin(extents))
    if extents[thinnest] > FLAT * np.max(extents):
        return "oblique"
    return ("side", "front", "top")[thinnest]


def find_direction(view):
    """Direction and up of a named view or of "azimuth,elevation" in degrees:
    0,0 is the front, 90,0 the side."""
    if view in VIEWS:
        direction, up = VIEWS[view]
    else:
        azimuth, elevation = (math.radians(float(x)) for x in view.split(","))
        direction = (math.sin(azimuth) * math.cos(elevation),
                     -math.cos(azimuth) * math.cos(elevation),
                     math.sin(elevation))
        up = (0, 1, 0) if abs(direction[2]) > 0.999 else (0, 0, 1)
    direction = np.array(direction, dtype=float)
    return direction / np.linalg.norm(direction), np.array(up, dtype=float)


def place_camera(places, view, aspect):
    """`places`: all points of the motion; `aspect`: width over height."""
    if view == "auto":
        view = choose_view(places)
    direction, up = find_direction(view)
    right = np.cross(up, direction)
    right /= np.linalg.norm(right)
    upright = np.cross(direction, right)
    across, along = places @ right, places @ upright
    height, width = np.ptp(along), np.ptp(across)
    half_height = 0.5 * max(height / (1 - BELOW - ABOVE),
                            width / (aspect * (1 - 2 * BESIDE)), 1e-9)
    middle_across = 0.5 * (across.min() + across.max())
    # The device is in the middle of what the labels leave.
    middle_along = (0.5 * (along.min() + along.max())
                    - half_height * (BELOW - ABOVE))
    depth = 0.5 * ((places @ direction).min() + (places @ direction).max())
    focus = (middle_across * right + middle_along * upright
             + depth * direction)
    return Camera(direction, upright, focus, half_height)
