# SPDX-License-Identifier: MIT
"""Catches a result that differs between C and Python: training_header.c plays the same, and both print the same bits.

Run with PYTHONPATH=BUILD/python and the path of training_header as argument."""
import subprocess
import sys

import numpy as np

import mirocup

envs = mirocup.VectorEnv(num_envs=6, opponent="chaser", episode_seconds=2.0, threads=1)
observations, _ = envs.reset(seed=11)
rewards = np.zeros(6)
size = envs.action_space.low.size
for step in range(100):
    actions = (((np.arange(size) * 37 + step * 11) % 65) - 32) / 32.0
    observations, rewards, *_ = envs.step(actions.reshape(envs.action_space.shape))
printed = subprocess.run([sys.argv[1]], check=True, capture_output=True, text=True).stdout.split()
in_c = [float.fromhex(number) for number in printed]
in_python = [*observations.ravel().tolist(), *rewards.tolist()]
if in_c != in_python:
    differ = sum(a != b for a, b in zip(in_c, in_python))
    sys.exit(f"{differ} of {len(in_python)} numbers differ between C and Python")
