"""Questions of the command, asked in this process: arguments become words and files in memory, the answer comes back as JSON."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextvars import ContextVar
from typing import TYPE_CHECKING, Any, Protocol, TypeVar, overload, runtime_checkable

from . import _cdpr
from ._arrays import Progress, plain
from ._errors import Error, in_python, refused

if TYPE_CHECKING:
    from ._result import Result

    R = TypeVar("R", bound=Result)
    S = TypeVar("S", bound=Result)


@runtime_checkable
class Input(Protocol):
    """A value that is a file, and perhaps options, for the command."""

    def _put(self, call: Call) -> str:
        """Puts its files and options into a call, and returns the word that stands for it."""


class Call:
    """Words of a command line and the files that they name."""

    def __init__(self, command: str) -> None:
        self.words: list[str] = command.split()
        self.options: list[str] = []
        self.behind: list[str] = []
        self.files: dict[str, bytes] = {}

    def file(self, name: str, content: bytes) -> str:
        """Keeps a file in memory and returns its name, another one than given if there is another file of this name."""
        free, number = name, 2
        while self.files.get(free, content) != content:
            folder, base = os.path.split(name)
            free, number = os.path.join(folder, f"{number}-{base}"), number + 1
        self.files[free] = content
        return free

    def word(self, value: Any) -> str:
        """Returns the word of a value."""
        from ._model import Model
        from ._robot import Robot

        value = plain(value)
        if isinstance(value, Model):
            self.add("model", value.composition)
            value = value.robot
        if isinstance(value, Robot):
            return self.file(value._name, value._text)
        if isinstance(value, Input):
            return value._put(self)
        if isinstance(value, os.PathLike):
            return str(os.fspath(value))
        if isinstance(value, Mapping):
            return ",".join(f"{key}={self.word(own)}" for key, own in value.items())
        if isinstance(value, (str, int, float)):
            return str(value)
        if isinstance(value, Iterable):
            return ",".join(self.word(own) for own in value)
        raise TypeError(f"{type(value).__name__} cannot be an argument")

    def add(self, option: str, value: Any, repeats: bool = False) -> None:
        """Adds an option unless its value is none."""
        if value is None or value is False:
            return
        if value is True:
            self.options.append(f"--{option}")
        elif repeats and not isinstance(value, (str, os.PathLike, Mapping)):
            for own in value:
                self.options.append(f"--{option}={self.word(own)}")
        else:
            # in one word, so that a minus sign in front is no option
            self.options.append(f"--{option}={self.word(value)}")

    def line(self) -> list[str]:
        """Returns the words of the command line after the name of the program."""
        return [*self.words, *self.options, *self.behind]


@overload
def ask(
    result: type[R],
    command: str,
    positionals: Sequence[Any],
    options: Mapping[str, Any],
    *,
    outputs: Mapping[str, str] | None = None,
    repeating: Iterable[str] = (),
    progress: Progress = None,
    threads: int | None = None,
    controller: Any = None,
    behind: Call | None = None,
) -> R: ...


@overload
def ask(
    result: tuple[type[R], type[S]],
    command: str,
    positionals: Sequence[Any],
    options: Mapping[str, Any],
    *,
    outputs: Mapping[str, str] | None = None,
    repeating: Iterable[str] = (),
    progress: Progress = None,
    threads: int | None = None,
    controller: Any = None,
    behind: Call | None = None,
) -> R | S: ...


def ask(
    result: Any,
    command: str,
    positionals: Sequence[Any],
    options: Mapping[str, Any],
    *,
    outputs: Mapping[str, str] | None = None,
    repeating: Iterable[str] = (),
    progress: Progress = None,
    threads: int | None = None,
    controller: Any = None,
    behind: Call | None = None,
) -> Any:
    """Returns the answer of a command: a ``result``, or that of several which fits it best.

    ``outputs`` are options whose files are kept in memory and go with the result. A wrong argument or file raises
    :class:`cdpr.Error`. ``behind``: a call whose words stand behind two dashes; an answer that is a no is a result, whose status says so.
    """
    call = Call(command)
    words = [call.word(value) for value in positionals if value is not None]
    for name, value in options.items():
        call.add(name, value, name in repeating)
    for name, value in (outputs or {}).items():
        call.add(name, value or None)
    # options that a value brings stand before those that are asked for here; a word that begins with a minus sign is none
    call.words += words
    if behind is not None:
        call.files.update(behind.files)
        call.behind = ["--", *behind.line()]
    planning = PLANNING.get()
    if planning is not None:
        planning(call)
    given = dict(call.files)
    wishes = ["--format=json", "--quiet", *([] if threads is None else [f"--threads={threads}"])]
    asked = [*call.words, *call.options, *wishes, *call.behind]
    observe, close = observer(progress)
    try:
        exit_code, out, err, files = _cdpr.ask(asked, given, observe, controller)
    finally:
        close()
    if exit_code == 130:
        raise KeyboardInterrupt
    try:
        answer = json.loads(out)
    except ValueError:
        raise Error("internal", f"cdpr {command}: no answer (exit code {exit_code}): {err.strip()}") from None
    if exit_code > 1 or answer.get("status") == "error":
        place = (answer["file"], answer.get("line"), answer.get("column")) if "file" in answer else None
        help = answer.get("help")
        raise refused(answer["code"], in_python(answer["reason"]), help and in_python(help), place)
    made = {name: content for name, content in files.items() if given.get(name) != content}
    cls = result[0]._class_for(result, answer) if isinstance(result, tuple) else result
    return cls._of(answer, made, tuple(call.line()), given)


PLANNING: ContextVar[Callable[[Call], None] | None] = ContextVar("PLANNING", default=None)
"""Takes the call of a question instead of asking it, while a plan is made of it."""


def observer(progress: Progress) -> tuple[Any, Any]:
    """Returns the function that takes progress, and the one that ends its line."""
    if progress is None or progress is False:
        return None, lambda: None
    if progress is not True:
        return progress, lambda: None
    shown = [False]

    def show(name: str, done: int, parts: int | None) -> None:
        shown[0] = True
        count = f"{done} of {parts}" if parts else f"{done}" if done else "…"
        sys.stderr.write(f"\r\x1b[K{name}: {count}" if sys.stderr.isatty() else f"\r{name}: {count}   ")
        sys.stderr.flush()

    def close() -> None:
        if shown[0]:
            sys.stderr.write("\n")
            sys.stderr.flush()

    return show, close
