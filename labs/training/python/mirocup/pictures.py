# SPDX-License-Identifier: MIT
"""A match as a picture: an array of pixels, drawn with numpy alone."""
from __future__ import annotations

from typing import Any

import numpy as np

_AROUND = (38, 50, 56)
_FIELD = (46, 94, 62)
_LINE = (224, 232, 226)
_BLUE = (66, 133, 244)
_YELLOW = (251, 205, 60)
_BALL = (255, 125, 40)
_FRONT = (250, 250, 250)
_LINE_WIDTH = 0.006  # m


def draw(spec: dict[str, Any], bodies: np.ndarray, width: int) -> np.ndarray:
    """The field with its bodies, seen from above: uint8 (height, width, 3).

    spec    of the batch
    bodies  float64 (2 * robots + 1, 6), as Batch.bodies()
    width   pixels
    """
    field, sizes = spec["field"], spec["bodies"]
    margin = 0.04
    half_x = field["half_length"] + field["goal_depth"] + margin
    half_y = field["half_width"] + margin
    pixel = 2.0 * half_x / width
    height = int(round(2.0 * half_y / pixel))
    x = (np.arange(width) + 0.5) * pixel - half_x
    y = half_y - (np.arange(height) + 0.5) * pixel
    x, y = np.meshgrid(x, y)
    picture = np.empty((height, width, 3), np.uint8)
    picture[:] = _AROUND
    picture[_is_field(field, x, y)] = _FIELD
    picture[_is_line(field, x, y, max(_LINE_WIDTH, pixel))] = _LINE
    robots = field["robots"]
    for i in range(2 * robots):
        _draw_robot(picture, x, y, bodies[i], sizes["robot_side"], _BLUE if i < robots else _YELLOW)
    ball = bodies[2 * robots]
    picture[np.hypot(x - ball[0], y - ball[1]) <= sizes["ball_radius"]] = _BALL
    return picture


def _is_field(field: dict[str, Any], x: np.ndarray, y: np.ndarray) -> np.ndarray:
    far_x, far_y = np.abs(x), np.abs(y)
    length, width, corner = field["half_length"], field["half_width"], field["corner_leg"]
    inside = (far_x <= length) & (far_y <= width) & (far_x + far_y <= length + width - corner)
    in_goal = (far_x <= length + field["goal_depth"]) & (far_y <= field["goal_half_width"])
    return inside | in_goal


def _is_line(field: dict[str, Any], x: np.ndarray, y: np.ndarray, width: float) -> np.ndarray:
    half = width / 2.0
    far_x, far_y = np.abs(x), np.abs(y)
    length, across = field["half_length"], field["half_width"]
    inside = (far_x <= length) & (far_y <= across)
    middle = (far_x <= half) & inside
    circle = np.abs(np.hypot(x, y) - field["centre_circle_radius"]) <= half
    front = length - field["goal_area_depth"]
    area = (np.abs(far_x - front) <= half) & (far_y <= field["goal_area_half_width"])
    sides = (np.abs(far_y - field["goal_area_half_width"]) <= half) & (far_x >= front) & (far_x <= length)
    goal = (np.abs(far_x - length) <= half) & (far_y <= field["goal_half_width"])
    return middle | circle | area | sides | goal


def _draw_robot(picture: np.ndarray, x: np.ndarray, y: np.ndarray, body: np.ndarray, side: float,
                colour: tuple[int, int, int]) -> None:
    cos, sin = np.cos(body[2]), np.sin(body[2])
    along = (x - body[0]) * cos + (y - body[1]) * sin
    across = (y - body[1]) * cos - (x - body[0]) * sin
    inside = (np.abs(along) <= side / 2.0) & (np.abs(across) <= side / 2.0)
    picture[inside] = colour
    picture[inside & (along > 0.3 * side)] = _FRONT
