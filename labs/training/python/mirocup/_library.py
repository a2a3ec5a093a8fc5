# SPDX-License-Identifier: MIT
"""libmirocup_training, called with ctypes. training.h says what each function does."""
from __future__ import annotations

import ctypes
import json
import os
from pathlib import Path
from typing import Any

import numpy as np

_NAME = "libmirocup_training.so"


class TrainingError(RuntimeError):
    """What the library complains of, as a sentence."""


def _candidates() -> list[Path]:
    """Where the library is: beside this package in a build tree, below the prefix of an installation."""
    package = Path(__file__).absolute().parent
    found = [package.parent.parent / _NAME]  # BUILD/python/mirocup
    for above in package.parents:  # PREFIX/lib/python3/dist-packages/mirocup
        found += [above / "lib" / _NAME, *sorted(above.glob(f"lib/*-linux-gnu/{_NAME}")), above / "build" / _NAME]
    return found


def library_path() -> Path:
    """The path of the library: MIROCUP_TRAINING_LIBRARY, or where it was built or installed."""
    named = os.environ.get("MIROCUP_TRAINING_LIBRARY")
    if named:
        return Path(named)
    for path in _candidates():
        if path.exists():
            return path
    raise TrainingError(
        f"{_NAME} was not found: build it (cmake -D MIROCUP_LABS=ON build && cmake --build build --target mirocup_training), "
        "or name it in MIROCUP_TRAINING_LIBRARY")


class _Buffers(ctypes.Structure):
    """mirocup_training_buffers."""

    NAMES = ("actions", "observations", "rewards", "terminations", "truncations", "final_observations", "terms",
             "statistics")
    _fields_ = [("size", ctypes.c_uint32), *((name, ctypes.c_void_p) for name in NAMES)]


_VERSION = 1  # of training.h


def _load() -> ctypes.CDLL:
    path = library_path()
    try:
        library = ctypes.CDLL(str(path))
    except OSError as e:
        raise TrainingError(f"{path} does not load: {e}") from None
    version = library.mirocup_training_version()
    if version != _VERSION:
        raise TrainingError(f"{path} is of version {version} of training.h, this package of version {_VERSION}: take both "
                            "from one mirocup")
    handle, size = ctypes.c_void_p, ctypes.c_size_t
    for name, result, arguments in (
        ("create", handle, [ctypes.c_char_p, ctypes.c_char_p, size]),
        ("destroy", None, [handle]),
        ("spec", ctypes.c_char_p, [handle]),
        ("error", ctypes.c_char_p, [handle]),
        ("bind", ctypes.c_int32, [handle, ctypes.POINTER(_Buffers)]),
        ("reset", ctypes.c_int32, [handle, ctypes.c_void_p, ctypes.c_void_p]),
        ("step", ctypes.c_int32, [handle]),
        ("set_weights", ctypes.c_int32, [handle, ctypes.c_void_p]),
        ("bodies", ctypes.c_int32, [handle, ctypes.c_int32, ctypes.c_void_p]),
        ("record", ctypes.c_int32, [handle, ctypes.c_int32, ctypes.c_int32, ctypes.c_char_p]),
        ("save", size, [handle, ctypes.c_int32, ctypes.c_char_p, size]),
        ("restore", ctypes.c_int32, [handle, ctypes.c_int32, ctypes.c_char_p, size]),
    ):
        function = getattr(library, f"mirocup_training_{name}")
        function.restype = result
        function.argtypes = arguments
    return library


_loaded: ctypes.CDLL | None = None


def _library() -> ctypes.CDLL:
    global _loaded
    if _loaded is None:
        _loaded = _load()
    return _loaded


class Batch:
    """A batch of matches and its buffers, which every call reads or writes in place.

    A row of a buffer belongs to one learner: row = match * slots + slot.

    actions             (rows, action)       float32 in [-1, 1]
    observations        (rows, observation)  float32
    rewards             (rows,)              float32
    terminations        (rows,)              bool
    truncations         (rows,)              bool
    final_observations  (rows, observation)  float32
    terms               (rows, terms)        float32, without weights
    statistics          (rows, statistics)   float32, of the episode that ended last
    """

    def __init__(self, configuration: dict[str, Any]) -> None:
        self._library = _library()
        self._handle: int | None = None
        self._process = os.getpid()
        error = ctypes.create_string_buffer(2000)
        self._handle = self._library.mirocup_training_create(json.dumps(configuration).encode(), error, len(error))
        if not self._handle:
            raise TrainingError(error.value.decode(errors="replace"))
        self.spec: dict[str, Any] = json.loads(self._library.mirocup_training_spec(self._handle))
        self.matches: int = self.spec["matches"]
        self.slots = len(self.spec["slots"])
        self.rows = self.matches * self.slots
        self.bodies_count: int = 2 * self.spec["field"]["robots"] + 1
        rows, observation = self.rows, len(self.spec["observation"])
        self.actions = np.zeros((rows, len(self.spec["action"])), np.float32)
        self.observations = np.zeros((rows, observation), np.float32)
        self.rewards = np.zeros(rows, np.float32)
        self.terminations = np.zeros(rows, np.bool_)
        self.truncations = np.zeros(rows, np.bool_)
        self.final_observations = np.zeros((rows, observation), np.float32)
        self.terms = np.zeros((rows, len(self.spec["rewards"])), np.float32)
        self.statistics = np.zeros((rows, len(self.spec["statistics"])), np.float32)
        pointers = _Buffers(ctypes.sizeof(_Buffers), *(getattr(self, name).ctypes.data for name in _Buffers.NAMES))
        self._check(self._library.mirocup_training_bind(self._handle, ctypes.byref(pointers)))
        self._step = self._library.mirocup_training_step

    def _check(self, code: int) -> None:
        if code != 0:
            raise TrainingError(self._library.mirocup_training_error(self._open()).decode(errors="replace"))

    def _open(self) -> int:
        if self._handle is None:
            raise TrainingError("the environment is closed")
        if self._process != os.getpid():
            raise TrainingError(f"the environment was made by process {self._process}, and its threads are there: make "
                                "one after the fork, in the process that uses it")
        return self._handle

    def __reduce__(self) -> Any:
        raise TrainingError("an environment cannot be copied or pickled: make another one with the same arguments; "
                            "save() and restore() copy its matches")

    def reset(self, mask: np.ndarray | None = None, seeds: np.ndarray | None = None) -> None:
        """Starts episodes: of the matches where `mask` (matches,) is true, from `seeds` (matches,)."""
        handle = self._open()
        mask = None if mask is None else np.ascontiguousarray(mask, np.uint8)
        seeds = None if seeds is None else np.ascontiguousarray(seeds, np.uint64)
        self._check(self._library.mirocup_training_reset(
            handle, None if mask is None else mask.ctypes.data, None if seeds is None else seeds.ctypes.data))

    def step(self) -> None:
        if self._step(self._open()) != 0:
            self._check(1)

    def set_weights(self, weights: np.ndarray) -> None:
        weights = np.ascontiguousarray(weights, np.float64)
        self._check(self._library.mirocup_training_set_weights(self._open(), weights.ctypes.data))

    def bodies(self, match: int) -> np.ndarray:
        """(2 * robots + 1, 6): x, y (m), heading (rad), vx, vy (m/s), turn (rad/s) in the field's frame."""
        bodies = np.zeros((self.bodies_count, 6))
        self._check(self._library.mirocup_training_bodies(self._open(), match, bodies.ctypes.data))
        return bodies

    def record(self, match: int, last: bool, path: str) -> None:
        self._check(self._library.mirocup_training_record(self._open(), match, int(last), os.fsencode(path)))

    def save(self, match: int) -> bytes:
        size = self._library.mirocup_training_save(self._open(), match, None, 0)
        if size == 0:
            self._check(1)
        copy = ctypes.create_string_buffer(size)
        self._library.mirocup_training_save(self._open(), match, copy, size)
        return copy.raw

    def restore(self, match: int, copy: bytes) -> None:
        self._check(self._library.mirocup_training_restore(self._open(), match, copy, len(copy)))

    def close(self) -> None:
        if self._handle is not None and self._process == os.getpid():
            self._library.mirocup_training_destroy(self._handle)
        self._handle = None

    def __del__(self) -> None:
        if getattr(self, "_handle", None) is not None:
            self.close()
