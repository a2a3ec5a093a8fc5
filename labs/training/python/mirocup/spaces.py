# SPDX-License-Identifier: MIT
"""Spaces: gymnasium's where it is installed, otherwise a Box with the same methods and results."""
from __future__ import annotations

from typing import Any

import numpy as np

try:
    from gymnasium.spaces import Box
except ImportError:

    class Box:  # type: ignore[no-redef]
        """A bounded box of floats, as gymnasium.spaces.Box.

        low, high  arrays of `shape`
        shape      tuple of int
        dtype      numpy.dtype
        """

        def __init__(self, low: Any, high: Any, shape: tuple[int, ...] | None = None, dtype: Any = np.float32) -> None:
            self.dtype = np.dtype(dtype)
            self.shape = tuple(shape) if shape is not None else np.broadcast_shapes(np.shape(low), np.shape(high))
            self.low = np.broadcast_to(np.asarray(low, self.dtype), self.shape).copy()
            self.high = np.broadcast_to(np.asarray(high, self.dtype), self.shape).copy()
            self._np_random: np.random.Generator | None = None

        @property
        def np_random(self) -> np.random.Generator:
            if self._np_random is None:
                self.seed()
            assert self._np_random is not None
            return self._np_random

        def seed(self, seed: int | None = None) -> int:
            """Seeds sample(), and returns the seed."""
            sequence = np.random.SeedSequence(seed)
            self._np_random = np.random.Generator(np.random.PCG64(sequence))
            return int(sequence.entropy)  # type: ignore[arg-type]

        def sample(self, mask: None = None) -> np.ndarray:
            """A uniform sample: array of `shape` and `dtype`."""
            return self.np_random.uniform(self.low, self.high, self.shape).astype(self.dtype)

        def contains(self, x: Any) -> bool:
            """True if x has the shape, a type that can be cast, and is within the bounds."""
            x = np.asarray(x)
            return bool(
                np.can_cast(x.dtype, self.dtype) and x.shape == self.shape and np.all(x >= self.low) and
                np.all(x <= self.high))

        def __contains__(self, x: Any) -> bool:
            return self.contains(x)

        def __eq__(self, other: object) -> bool:
            return (isinstance(other, Box) and self.shape == other.shape and np.allclose(self.low, other.low) and
                    np.allclose(self.high, other.high))

        __hash__ = None  # type: ignore[assignment]

        def __repr__(self) -> str:
            return f"Box({self.low.min()}, {self.high.max()}, {self.shape}, {self.dtype})"


def box_of(quantities: list[dict[str, Any]]) -> Box:
    """The space of one row, from the spec's list of its numbers."""
    low = np.array([q["low"] for q in quantities], np.float32)
    high = np.array([q["high"] for q in quantities], np.float32)
    return Box(low, high, dtype=np.float32)


def batched(space: Box, rows: int) -> Box:
    """The space of `rows` rows: shape (rows, *space.shape)."""
    return Box(np.tile(space.low, (rows, 1)), np.tile(space.high, (rows, 1)), dtype=np.float32)
