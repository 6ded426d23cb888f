"""The command `cdpr`, as the wheel installs it."""

from __future__ import annotations

import sys

from . import _cdpr


def main() -> int:
    """Runs the command line of the process and returns its exit code."""
    return _cdpr.command(["cdpr", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
