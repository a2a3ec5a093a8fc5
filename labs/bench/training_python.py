# SPDX-License-Identifier: MIT
"""The share of the C library in a step through Python, with 1024 environments and actions that are drawn before.

Prints microseconds of processor time a step of one environment, and the share. Run with PYTHONPATH=BUILD/python."""
import statistics
import time

import numpy as np

import mirocup

ROUNDS, STEPS = 7, 10

envs = mirocup.VectorEnv(num_envs=1024, opponent="self", threads=1)
envs.reset(seed=1)
random = np.random.default_rng(1)
actions = [random.uniform(-1.0, 1.0, envs.action_space.shape).astype(np.float32) / 1.8 for _ in range(STEPS)]
clock = time.thread_time
in_c = 0.0
step = envs.batch._step


def timed_step(handle):
    global in_c
    begin = clock()
    code = step(handle)
    in_c += clock() - begin
    return code


envs.batch._step = timed_step
shares, costs = [], []
for _ in range(ROUNDS):
    in_c = 0.0
    begin = clock()
    for a in actions:
        envs.step(a)
    all_of_it = clock() - begin
    shares.append(in_c / all_of_it)
    costs.append(all_of_it / STEPS / 512)
print(f"{1e6 * statistics.median(costs):.2f} {statistics.median(shares):.4f}")
