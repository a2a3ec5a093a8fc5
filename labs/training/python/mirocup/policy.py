# SPDX-License-Identifier: MIT
"""A learned network as a file, mirocup/policy/1: what it sees and does, and its layers."""
from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any, Callable, Sequence

import numpy as np

_ACTIVATIONS: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "tanh": np.tanh,
    "relu": lambda x: np.maximum(x, 0.0),
}


class Policy:
    """A network of layers: each multiplies with its weights and adds its biases; between two layers stands the
    activation. The last layer's numbers, within [-1, 1], are the action.

    spec        of the environment: envs.batch.spec
    layers      (weights (outputs, inputs), biases (outputs,)) of each layer, as torch.nn.Linear has them
    activation  "tanh" or "relu"

    A call takes observations, (observation,) or (rows, observation), and returns actions of the same rows, float32.
    """

    def __init__(self, spec: dict[str, Any], layers: Sequence[tuple[np.ndarray, np.ndarray]],
                 activation: str = "tanh") -> None:
        if activation not in _ACTIVATIONS:
            raise ValueError(f"activation {activation!r}: one of {', '.join(_ACTIVATIONS)} is expected")
        self.spec = spec
        self.activation = activation
        self.layers = [(np.asarray(w, np.float32), np.asarray(b, np.float32)) for w, b in layers]
        size = len(spec["observation"])
        for i, (weights, biases) in enumerate(self.layers):
            if weights.ndim != 2 or weights.shape[1] != size or biases.shape != weights.shape[:1]:
                raise ValueError(f"layer {i}: weights of shape (outputs, {size}) and biases (outputs,) are expected, "
                                 f"not {weights.shape} and {biases.shape}")
            size = weights.shape[0]
        if size != len(spec["action"]):
            raise ValueError(f"the last layer has {size} outputs, but an action has {len(spec['action'])} numbers")

    def __call__(self, observations: np.ndarray) -> np.ndarray:
        values = np.asarray(observations, np.float64)
        for i, (weights, biases) in enumerate(self.layers):
            if i > 0:
                values = _ACTIVATIONS[self.activation](values)
            values = values @ weights.T.astype(np.float64) + biases
        return np.clip(values, -1.0, 1.0).astype(np.float32)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the policy. A crash leaves the old file or the new one."""
        arrays: dict[str, np.ndarray] = {"schema": np.array("mirocup/policy/1"), "spec": np.array(json.dumps(self.spec)),
                                         "activation": np.array(self.activation)}
        for i, (weights, biases) in enumerate(self.layers):
            arrays |= {f"w{i}": weights, f"b{i}": biases}
        temporary = Path(f"{os.fspath(path)}.new")
        with open(temporary, "wb") as file:
            np.savez(file, **arrays)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Policy:
        """Reads a policy."""
        with np.load(path) as arrays:
            layers = []
            while f"w{len(layers)}" in arrays:
                layers.append((arrays[f"w{len(layers)}"], arrays[f"b{len(layers)}"]))
            return cls(json.loads(str(arrays["spec"])), layers, str(arrays["activation"]))
