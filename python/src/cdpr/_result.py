"""Base of the classes of answers: the JSON object of an answer, read by attributes."""

from __future__ import annotations

import copy
import json
import os
import pathlib
import shlex
from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar, NoReturn, TypeVar

if TYPE_CHECKING:
    import pandas as pd
    from typing_extensions import Self

__all__ = ["Result", "frame_of"]

R = TypeVar("R", bound="Result")

_MOST_SHOWN = 5
"""Values that a line shows of an object."""
_LONGEST_SHOWN = 32
"""Characters that a line shows of a text."""


class Result:
    """Answer of a command, or a part of one: immutable, with a read-only attribute per key.

    Attributes are named like the keys of the JSON object without their units. They are read when they are asked
    for: objects become results, lists tuples. Keys that a class does not know stay in the object.
    """

    __slots__ = ("_data", "_given", "_line", "_read", "_written")

    _KEYS: ClassVar[tuple[tuple[str, str, bool], ...]] = ()
    """Attributes with their keys, and whether every answer has them."""

    _TABLE: ClassVar[str | None] = None
    """Key of the list that a table shows."""

    _data: dict[str, Any]
    _read: dict[str, Any]
    _written: Mapping[str, bytes]
    _line: tuple[str, ...]
    _given: Mapping[str, bytes]

    def __init__(self) -> None:
        raise TypeError(f"{type(self).__name__} is an answer of a command and not made by hand")

    @classmethod
    def _of(
        cls,
        data: Mapping[str, Any],
        written: Mapping[str, bytes] | None = None,
        line: tuple[str, ...] = (),
        given: Mapping[str, bytes] | None = None,
    ) -> Self:
        """Returns the result of a parsed JSON object, which is its own from then on, with the files that came with it, the words of the command
        line that it answers, and the files that these name."""
        result = object.__new__(cls)
        object.__setattr__(result, "_data", data if isinstance(data, dict) else dict(data))
        object.__setattr__(result, "_read", {})
        object.__setattr__(result, "_written", written or {})
        object.__setattr__(result, "_line", line)
        object.__setattr__(result, "_given", given or {})
        return result

    @staticmethod
    def _class_for(classes: Sequence[type[R]], data: Mapping[str, Any]) -> type[R]:
        """Returns the class whose keys fit the object best, of several forms of an answer."""

        def misfits(cls: type[R]) -> int:
            lacking = sum(is_always and key not in data for _, key, is_always in cls._KEYS)
            return lacking + len(data.keys() - {key for _, key, _ in cls._KEYS})

        return min(classes, key=misfits)

    def _get(self, key: str, part: type[Result] | None = None) -> Any:
        """Returns the value of a key that every answer has."""
        if key in self._data:
            return self._find(key, part)
        raise AttributeError(f"{type(self).__name__} has no key {key!r}: another version wrote it")

    def _find(self, key: str, part: type[Result] | None = None) -> Any:
        """Returns the value of a key, `None` if the answer has none."""
        return self._read[key] if key in self._read else self._converted(key, self._data.get(key), part)

    def _converted(self, key: str, value: Any, part: type[Result] | None) -> Any:
        if isinstance(value, (dict, list)):
            value = _converted(value, part)
            self._read[key] = value
        return value

    def to_dict(self) -> dict[str, Any]:
        """Returns a copy of the JSON object as the command prints it, units in its keys."""
        return copy.deepcopy(self._data)

    def to_json(self, indent: int | None = None) -> str:
        """Returns the JSON object as text, in one line unless an indent is given."""
        return json.dumps(self._data, ensure_ascii=False, indent=indent)

    @property
    def attached(self) -> Mapping[str, bytes]:
        """Files that came with the answer, by name: calibrated robots, tables, figures, pages."""
        return MappingProxyType(dict(self._written))

    @property
    def command_line(self) -> str:
        """The command whose answer this is, as a shell takes it; robots and samples stand in it by names that :meth:`save` gives their files."""
        return shlex.join(["cdpr", *self._line])

    @property
    def html(self) -> str | None:
        """The page of the answer: one HTML file that refers to nothing outside; ``None`` if it has none."""
        pages = [content for name, content in self._written.items() if name.endswith(".html")]
        return pages[0].decode() if pages else None

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Writes the files that came with the answer, ``answer.json``, and those that :attr:`command_line` names, into a folder."""
        from ._robot import save

        given = {name: content for name, content in self._given.items() if not os.path.isabs(name)}
        for name, content in {**given, **self._written, "answer.json": (self.to_json(2) + "\n").encode()}.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            save(path, content)

    def to_pandas(self) -> pd.DataFrame:
        """Returns the rows of the answer as a table (pandas), or the answer as one row; columns are the JSON keys with their units."""
        rows = [self._data] if self._TABLE is None else self._data[self._TABLE]
        return pandas_of([dict(_flat(row, "")) for row in rows])

    def _repr_html_(self) -> str:
        from ._html import of_answer, page_in_frame

        page = self.html
        return of_answer(type(self).__name__, self._data) if page is None else page_in_frame(page)

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> NoReturn:
            from ._robot import meant

            if name in (own for own, _, _ in self._KEYS):
                words = f"has no key for {name!r}: another version wrote it"
            else:
                help = "" if name.startswith("_") else f"; {meant(name, dir(self))}`dir(…)` lists all"
                words = f"has no attribute {name!r}{help}"
            raise AttributeError(f"{type(self).__name__} {words}")

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise AttributeError(f"{type(self).__name__} cannot be changed")

    def __delattr__(self, name: str) -> NoReturn:
        raise AttributeError(f"{type(self).__name__} cannot be changed")

    def __repr__(self) -> str:
        shown: list[str] = []
        names = {key: name for name, key, _ in self._KEYS}
        for key in sorted(self._data, key=lambda key: key != "status"):
            value = self._data[key]
            if key in names and key not in ("program", "layout_version") and _is_shown(value):
                # the words of a finding are what it is
                shown.append(f"{names[key]}={value!r}" if key == "text" else f"{names[key]}={_shown(value)}")
        return f"{type(self).__name__}({', '.join(shown[:_MOST_SHOWN])})"

    def __dir__(self) -> Iterator[str]:
        yield from (name for name in object.__dir__(self) if not name.startswith("_"))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Result):
            return NotImplemented
        return type(self) is type(other) and self._data == other._data

    def __hash__(self) -> int:
        # equal numbers have equal hashes, whichever their type
        return hash((type(self), _frozen(self._data)))

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (type(self), self._data, dict(self._written), self._line, dict(self._given))

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self


def frame_of(rows: Sequence[Result]) -> pd.DataFrame:
    """Returns a table (pandas) with a row per result; columns are the JSON keys with their units.

    Keys of parts are joined with dots, as `validation.position_error_m.mean`; lists stay lists.
    """
    return pandas_of([dict(_flat(row._data, "")) for row in rows])


def pandas_of(rows: list[dict[str, Any]]) -> pd.DataFrame:
    """Returns rows as a table of pandas."""
    try:
        import pandas
    except ImportError as error:
        raise ImportError("tables need pandas: pip install pandas") from error
    table: pd.DataFrame = pandas.DataFrame(rows)
    return table


def _restored(
    cls: type[R],
    data: dict[str, Any],
    written: Mapping[str, bytes],
    line: tuple[str, ...],
    given: Mapping[str, bytes],
) -> R:
    return cls._of(data, written, line, given)


def _converted(value: Any, part: type[Result] | None) -> Any:
    if isinstance(value, list):
        return tuple(_converted(one, part) for one in value)
    if isinstance(value, dict):
        if part is not None:
            return part._of(value)
        return MappingProxyType({key: _converted(one, None) for key, one in value.items()})
    return value


def _frozen(value: Any) -> Any:
    if isinstance(value, dict):
        return frozenset((key, _frozen(one)) for key, one in value.items())
    if isinstance(value, list):
        return tuple(map(_frozen, value))
    return value


def _flat(data: dict[str, Any], prefix: str) -> Iterator[tuple[str, Any]]:
    for key, value in data.items():
        if isinstance(value, dict):
            yield from _flat(value, f"{prefix}{key}.")
        else:
            yield prefix + key, copy.deepcopy(value)


def _is_shown(value: object) -> bool:
    return isinstance(value, (str, bool, int, float)) and value != ""


def _shown(value: object) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, str) and len(value) > _LONGEST_SHOWN:
        return repr(value[: _LONGEST_SHOWN - 1] + "…")
    return repr(value)
