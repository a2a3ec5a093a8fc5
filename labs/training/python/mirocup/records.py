# SPDX-License-Identifier: MIT
"""Episodes as records and as pages."""
from __future__ import annotations

import shutil
import subprocess
import tempfile
from pathlib import Path

from ._library import Batch, TrainingError, library_path


def is_last(episode: str) -> bool:
    """True for "last", False for "current"."""
    if episode not in ("last", "current"):
        raise ValueError(f"episode {episode!r}: 'last' or 'current' is expected")
    return episode == "last"


def program() -> str:
    """The path of the program mirocup: beside the library, in bin of its prefix, or on the PATH."""
    folder = library_path().absolute().parent
    for path in (folder / "mirocup", folder.parent / "bin" / "mirocup", folder.parent.parent / "bin" / "mirocup"):
        if path.is_file():
            return str(path)
    found = shutil.which("mirocup")
    if found is None:
        raise TrainingError(f"the program mirocup is not there: neither near {folder} nor on the PATH")
    return found


def write_page(batch: Batch, match: int, episode: str, path: str) -> None:
    """Writes an episode as a page."""
    with tempfile.TemporaryDirectory() as folder:
        record = str(Path(folder) / "episode.json")
        batch.record(match, is_last(episode), record)
        result = subprocess.run([program(), "replay", record, "-o", path], capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise TrainingError(result.stderr.strip() or f"mirocup replay ended with {result.returncode}")
