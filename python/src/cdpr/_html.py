"""What notebooks show: pages of results, robots as a small picture."""

from __future__ import annotations

import html
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from ._robot import Robot

MOST = 12
"""Numbers of a list that are shown."""

HEIGHT = 640
"""Height of a page in a notebook (px): its first screen."""


def page_in_frame(page: str) -> str:
    """Returns a page in a frame of its own: several in a notebook do not meet, and none refers to anything outside."""
    text = html.escape(page, quote=True)
    style = f"width:100%;height:{HEIGHT}px;border:1px solid #8884;border-radius:4px"
    return f'<iframe srcdoc="{text}" style="{style}" sandbox="allow-scripts allow-downloads"></iframe>'


def of_answer(title: str, data: Mapping[str, Any]) -> str:
    """Returns an answer without a page: status and warnings first, then its numbers."""
    rows = []
    for key, value in data.items():
        if key in ("program", "layout_version", "warnings", "findings", "status"):
            continue
        if isinstance(value, (str, int, float, bool)) or value is None:
            rows.append((key, "—" if value is None else f"{value:.6g}" if isinstance(value, float) else str(value)))
        elif isinstance(value, list) and 0 < len(value) <= MOST and all(isinstance(own, (int, float)) for own in value):
            rows.append((key, ", ".join(f"{own:.6g}" for own in value)))
        elif isinstance(value, Mapping) and all(isinstance(own, (int, float)) for own in value.values()):
            rows.append((key, ", ".join(f"{name} {own:.4g}" for name, own in value.items())))
    table = "".join(f"<tr><th style='text-align:left'>{html.escape(k)}</th><td>{html.escape(v)}</td></tr>" for k, v in rows)
    warnings = "".join(f"<li>{html.escape(str(words))}</li>" for words in data.get("warnings", []))
    doubts = f"<ul>{warnings}</ul>" if warnings else ""
    return f"<div><b>{html.escape(title)}</b>: {html.escape(str(data.get('status', '')))}{doubts}<table>{table}</table></div>"


def of_robot(robot: Robot) -> str:
    """Returns name, pattern and remarks of a robot, with its anchors and cables at the home pose seen from two sides."""
    frame = robot.frame_anchors
    pose = robot.home
    x, y, z, w = pose[3:]
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    platform = pose[:3] + robot.platform_anchors @ turn.T
    spread = np.ptp(np.vstack([frame, platform]), axis=0)
    flat = [axis for axis in range(3) if spread[axis] > 1e-9 * spread.max()]
    views = [(0, 2), (0, 1)] if len(flat) == 3 else [tuple(flat[:2])]
    drawn = "".join(_view(frame, platform, across, up) for across, up in views)
    notes = "".join(f"<li>{html.escape(words)}</li>" for words in robot.warnings)
    title = f"<b>{html.escape(robot.name)}</b>: {robot.cable_count} cables, {robot.motion_pattern}"
    return f"<div>{title}{f'<ul>{notes}</ul>' if notes else ''}<div>{drawn}</div></div>"


def _view(frame: Any, platform: Any, across: int, up: int) -> str:
    size, margin = 220.0, 16.0
    points = np.vstack([frame, platform])[:, [across, up]]
    low, high = points.min(axis=0), points.max(axis=0)
    scale = (size - 2 * margin) / max(float((high - low).max()), 1e-9)
    middle = 0.5 * (low + high)

    def placed(point: Any) -> tuple[float, float]:
        x, y = (point[[across, up]] - middle) * scale
        return size / 2 + x, size / 2 - y

    lines = []
    for anchor, end in zip(frame, platform, strict=True):
        (x1, y1), (x2, y2) = placed(anchor), placed(end)
        lines.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="#4477aa"/>')
        lines.append(f'<circle cx="{x1:.1f}" cy="{y1:.1f}" r="3" fill="#4477aa"/>')
        lines.append(f'<circle cx="{x2:.1f}" cy="{y2:.1f}" r="3" fill="#cc6677"/>')
    names = "xyz"
    label = f'<text x="4" y="{size - 4:.0f}" font-size="11" fill="currentColor">{names[across]}{names[up]}</text>'
    return f'<svg width="{size:.0f}" height="{size:.0f}" role="img">{"".join(lines)}{label}</svg>'
