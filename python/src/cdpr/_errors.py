"""Exceptions: a caller's mistake is one; a mathematical outcome (not converged, infeasible) is a status."""

from __future__ import annotations

import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Place:
    """Place in a file."""

    file: str
    """The file as the caller named it."""
    line: int | None = None
    """Line from 1; ``None`` if the file as a whole is meant."""
    column: int | None = None
    """Column in characters, from 1; ``None`` if the file as a whole is meant."""

    def __str__(self) -> str:
        parts = [self.file, self.line, self.column]
        return ":".join(str(part) for part in parts if part is not None)


class Error(ValueError):
    """A mistake in what was passed: arguments, arrays, files."""

    code: str
    """Stable short name of the mistake, e.g. ``data::all-equal``; :func:`cdpr.explain` has a page for each."""
    message: str
    """Fault and reason in words, without place and help."""
    help: str | None
    """How to mend it, where the library knows."""
    place: Place | None
    """Place of the fault; ``None`` unless a file is at fault."""

    def __init__(self, code: str, message: str, help: str | None = None, place: Place | None = None) -> None:
        super().__init__(code, message, help, place)
        self.code, self.message, self.help, self.place = code, message, help, place

    def __str__(self) -> str:
        place = f"{self.place}: " if self.place else ""
        help = f"\n  help: {self.help}" if self.help else ""
        return f"{place}{self.message}{help}"


class ReadError(Error):
    """A mistake in a file, at a line of it."""

    place: Place


def refused(
    code: str, message: str, help: str | None, place: tuple[str, int | None, int | None] | None = None
) -> Error:
    """Returns the exception of an error of the library."""
    where = Place(*place) if place else None
    kind = ReadError if where is not None and where.line is not None else Error
    return kind(code, message, help, where)


def in_python(text: str) -> str:
    """Returns words of the command with its options as arguments: ``--tension-min`` becomes ``tension_min=``, ``--model elastic`` in quotes or
    before a colon ``model="elastic"``."""

    def argument(option: re.Match[str]) -> str:
        name, value, colon = option.group(1).replace("-", "_"), option.group(2), option.group(3)
        if colon is not None:
            return f"`{name}=`:"
        return f"{name}=" if value is None else f'{name}="{value}"'

    return re.sub(r"(?<![\w-])--([a-z][a-z-]*)(?:[ =]([^\s`:]+)(?=[`:](?:\s|$|[.,;)]))|(:))?", argument, text)
