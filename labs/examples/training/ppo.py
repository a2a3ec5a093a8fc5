#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""A team learns by PPO (Schulman et al., arXiv 1707.06347): to score against an idle keeper, then to play.

    ppo.py score --minutes 30                     one robot, the ball anywhere, the opponents stand
    ppo.py play --minutes 480 --from score        three robots against themselves and past selves
    ppo.py score again --steps 20e6 --seed 2      a run that gives the same network each time
    ppo.py test score                             the share of 1000 episodes in which it scores
    mirocup export score/policy.npz -o learned.cpp

A run is a folder. Started again, it continues from its last checkpoint as if it had not been stopped; Ctrl-C saves one
first. labs/docs/training.md
"""
from __future__ import annotations

import argparse
import json
import os
import signal
import sys
import time
from pathlib import Path
from typing import Any

os.environ.setdefault("OMP_WAIT_POLICY", "passive")  # two programs on one machine do not wait in circles

import numpy as np  # noqa: E402
import torch  # noqa: E402
from torch import nn  # noqa: E402

import mirocup  # noqa: E402
from mirocup import AutoresetMode, VectorEnv  # noqa: E402

# ---- what is learned

ANYWHERE = [{"from": -0.68, "to": 0.68}, {"from": -0.58, "to": 0.58}]
TURNED = {"from": -3.14, "to": 3.14}
# Blue's robot 1 and the ball lie anywhere; yellow's keeper stands across the middle of its goal.
SCORE_START = {
    "ball": {"position": ANYWHERE},
    "blue": [{"pose": [-0.7, 0.0, 1.57]}, {"pose": [*ANYWHERE, TURNED]}],
    "yellow": [{"pose": [0.7, 0.0, 1.57]}],
}
# The robot is behind the ball already. Half of the episodes of training start so: they show early what a goal is worth.
EASY_START = {
    **SCORE_START,
    "ball": {"position": [{"from": 0.1, "to": 0.6}, {"from": -0.3, "to": 0.3}]},
    "blue": [{"pose": [-0.7, 0.0, 1.57]},
             {"pose": [{"from": -0.2, "to": 0.0}, {"from": -0.3, "to": 0.3}, {"from": -0.8, "to": 0.8}]}],
}
PLAY_START = {
    "ball": {"position": ANYWHERE},
    "blue": [{"pose": [-0.7, {"from": -0.15, "to": 0.15}, 1.57]}] + 2 * [{"pose": [*ANYWHERE, TURNED]}],
    "yellow": [{"pose": [0.7, {"from": -0.15, "to": 0.15}, 1.57]}] + 2 * [{"pose": [*ANYWHERE, TURNED]}],
}
COMMON = {"agents": "robot", "observation": "relative", "ticks_per_step": 2, "autoreset_mode": AutoresetMode.SAME_STEP}
TASKS: dict[str, dict[str, Any]] = {
    "score": {**COMMON, "learners": [1], "opponent": "idle", "referee": "goals",
              "start": [SCORE_START, EASY_START], "episode_seconds": 10.0,
              "rewards": {"goal": 4.0, "ball_to_goal": 2.0, "behind_ball": 1.0, "time": 0.05}},
    "play": {**COMMON, "opponent": "self", "start": [PLAY_START, {}], "episode_seconds": 20.0,
             "rewards": {"goal": 4.0, "ball_to_goal": 2.0, "behind_ball": 0.2, "foul": 0.4}},
}

ENVIRONMENTS = 576      # rows: learners that act at once
STEPS = 56              # of each environment between two updates
# Few uses of a step waste it: 3 epochs of 8 minibatches scored in 70 % of episodes after six minutes, these in 85 %
# after four.
EPOCHS, MINIBATCHES = 6, 16
GAMMA, LAMBDA = 0.985, 0.95
CLIP, ENTROPY = 0.2, 0.002
LEARNING_RATE = 1e-3    # falls to a tenth of it over the run, by its steps or by its time
HIDDEN = 64
# What is drawn is forward and turn; wheels of full speed against each other turn so fast that a robot which tries them out
# at random only spins.
WHEELS = torch.tensor([[1.0, -0.25], [1.0, 0.25]])  # left and right from forward and turn
PAST_SELVES = 20        # kept as opponents
CHECKPOINT_S, REPORT_S = 60.0, 10.0


def layers(inputs: int, outputs: int, gain: float) -> nn.Sequential:
    """inputs -> HIDDEN -> HIDDEN -> outputs with tanh between them."""
    sizes = [inputs, HIDDEN, HIDDEN, outputs]
    parts: list[nn.Module] = []
    for i in range(3):
        linear = nn.Linear(sizes[i], sizes[i + 1])
        nn.init.orthogonal_(linear.weight, gain if i == 2 else 2**0.5)
        nn.init.zeros_(linear.bias)
        parts += [linear] if i == 2 else [linear, nn.Tanh()]
    return nn.Sequential(*parts)


class Learner(nn.Module):
    """The mean of the actions, their spread, and the value of a state."""

    def __init__(self, observation: int, action: int) -> None:
        super().__init__()
        self.mean = layers(observation, action, 0.01)
        self.value = layers(observation, 1, 1.0)
        self.log_std = nn.Parameter(torch.full((action,), -0.5))

    def distribution(self, observations: torch.Tensor) -> torch.distributions.Normal:
        return torch.distributions.Normal(self.mean(observations), self.log_std.exp())


def save_policy(learner: Learner, envs: VectorEnv, path: Path) -> None:
    """Writes the mean of the actions as a policy, which `mirocup export` and mirocup.Policy read."""
    linear = [part for part in learner.mean if isinstance(part, nn.Linear)]
    with torch.no_grad():
        weights = [(part.weight.numpy(), part.bias.numpy()) for part in linear[:-1]]
        weights.append(((WHEELS @ linear[-1].weight).numpy(), (WHEELS @ linear[-1].bias).numpy()))
    mirocup.Policy(envs.batch.spec, weights, "tanh").save(path)


# ---- who acts

class Opponents:
    """The rows that learn, and past selves that act in the others.

    In the first half of the matches the learner steers both teams. In the other half it steers blue, and a past self
    steers yellow.
    """

    def __init__(self, envs: VectorEnv) -> None:
        slots = envs.batch.spec["slots"]
        is_yellow = np.array([slot["team"] == "yellow" for slot in slots])
        matches = envs.batch.matches
        self.past: list[dict[str, torch.Tensor]] = []
        self.against_past = np.zeros((matches, len(slots)), bool)
        self.against_past[matches // 2:] = is_yellow
        self.against_past = self.against_past.ravel()
        self.has_opponents = bool(is_yellow.any())
        self._actor: Learner | None = None

    def learning(self) -> np.ndarray:
        return ~self.against_past if self.past else np.ones_like(self.against_past)

    def remember(self, learner: Learner, random: np.random.Generator) -> None:
        if not self.has_opponents:
            return
        self.past.append({k: v.detach().clone() for k, v in learner.state_dict().items()})
        if len(self.past) > PAST_SELVES:
            del self.past[int(random.integers(1, PAST_SELVES))]

    def choose(self, learner: Learner, random: np.random.Generator) -> None:
        """Takes another past self, for one collection."""
        if self.past:
            self._actor = Learner(learner.mean[0].in_features, learner.log_std.shape[0])
            self._actor.load_state_dict(self.past[int(random.integers(len(self.past)))])

    def act(self, observations: torch.Tensor, actions: np.ndarray) -> None:
        if self._actor is not None:
            with torch.no_grad():
                drawn = self._actor.distribution(observations[self.against_past]).sample()
                actions[self.against_past] = (drawn @ WHEELS.T).numpy()


# ---- PPO

def collect(envs: VectorEnv, learner: Learner, opponents: Opponents, observations: np.ndarray,
            episodes: list[dict[str, float]]) -> tuple[dict[str, torch.Tensor], np.ndarray]:
    """Plays STEPS steps. Returns what was seen, done and gained, (STEPS, rows, ...), and the last observations."""
    rows = envs.num_envs
    seen = torch.zeros(STEPS, rows, observations.shape[1])
    done = torch.zeros(STEPS, rows, envs.single_action_space.shape[0])
    chance, value, gain, end = (torch.zeros(STEPS, rows) for _ in range(4))
    for t in range(STEPS):
        now = torch.from_numpy(observations)
        with torch.no_grad():
            distribution = learner.distribution(now)
            action = distribution.sample()
            seen[t], done[t], value[t] = now, action, learner.value(now)[:, 0]
            chance[t] = distribution.log_prob(action).sum(1)
        actions = (action @ WHEELS.T).numpy()
        opponents.act(now, actions)
        observations, rewards, terminations, truncations, infos = envs.step(actions)
        gain[t] = torch.from_numpy(rewards.astype(np.float32))
        ended = terminations | truncations
        end[t] = torch.from_numpy(ended.astype(np.float32))
        if not ended.any():
            continue
        cut = np.flatnonzero(truncations)
        if cut.size:  # what would have come after the cut
            with torch.no_grad():
                gain[t, cut] += GAMMA * learner.value(torch.from_numpy(infos["final_obs"][cut]))[:, 0]
        for i in np.flatnonzero(ended):
            episodes.append({name: float(infos["statistics"][name][i]) for name in ("return", "goal")})
    with torch.no_grad():
        after = learner.value(torch.from_numpy(observations))[:, 0]
    advantage, running = torch.zeros_like(gain), torch.zeros(rows)
    for t in reversed(range(STEPS)):
        goes_on = 1.0 - end[t]
        delta = gain[t] + GAMMA * goes_on * (after if t == STEPS - 1 else value[t + 1]) - value[t]
        running = delta + GAMMA * LAMBDA * goes_on * running
        advantage[t] = running
    learning = torch.from_numpy(opponents.learning())
    batch = {"seen": seen, "done": done, "chance": chance, "advantage": advantage, "target": advantage + value}
    return {name: tensor[:, learning].flatten(0, 1) for name, tensor in batch.items()}, observations


def update(learner: Learner, optimizer: torch.optim.Optimizer, batch: dict[str, torch.Tensor]) -> None:
    """Improves the learner on one collection: the clipped objective, the value's error, the entropy."""
    advantage = batch["advantage"]
    advantage = (advantage - advantage.mean()) / (advantage.std() + 1e-8)
    for _ in range(EPOCHS):
        for part in torch.randperm(len(advantage)).chunk(MINIBATCHES):
            distribution = learner.distribution(batch["seen"][part])
            ratio = (distribution.log_prob(batch["done"][part]).sum(1) - batch["chance"][part]).exp()
            a = advantage[part]
            objective = torch.min(ratio * a, ratio.clamp(1.0 - CLIP, 1.0 + CLIP) * a).mean()
            error = (learner.value(batch["seen"][part])[:, 0] - batch["target"][part]).square().mean()
            optimizer.zero_grad()
            (error / 2.0 - objective - ENTROPY * learner.log_std.sum()).backward()
            # Apart, so that a large error of the value does not hide what the actions learn.
            nn.utils.clip_grad_norm_([*learner.mean.parameters(), learner.log_std], 0.5)
            nn.utils.clip_grad_norm_(learner.value.parameters(), 1.0)
            optimizer.step()


# ---- what a run keeps

def replace(path: Path, write: Any) -> None:
    """Writes a file so that a crash leaves the old one or the new one."""
    temporary = path.with_name(path.name + ".new")
    with open(temporary, "wb") as file:
        write(file)
        file.flush()
        os.fsync(file.fileno())
    os.replace(temporary, path)


def draw(path: Path, course: list[dict[str, float]], names: dict[str, str]) -> None:
    """Draws curves over the time of training as an SVG."""
    width, height, gap = 640, 150, 40
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width + 90} {(height + gap) * len(names) + 20}" '
             'font-family="sans-serif" font-size="12"><rect width="100%" height="100%" fill="white"/>']
    last = max(course[-1]["minutes"], 1e-9)
    for k, (name, title) in enumerate(names.items()):
        points = [(row["minutes"], row[name]) for row in course if name in row]
        if not points:
            continue
        low, high = min(0.0, min(v for _, v in points)), max(v for _, v in points)
        high = high if high > low else low + 1.0
        top = gap * (k + 1) + height * k

        def place(minutes: float, value: float) -> str:
            return f"{50 + width * minutes / last:.1f},{top + height * (high - value) / (high - low):.1f}"

        lines.append(f'<text x="50" y="{top - 8}" font-weight="bold">{title}: {points[-1][1]:.3g}</text>'
                     f'<path d="M50,{top} V{top + height} H{50 + width}" fill="none" stroke="#999"/>'
                     f'<text x="44" y="{top + 10}" text-anchor="end">{high:.3g}</text>'
                     f'<text x="44" y="{top + height}" text-anchor="end">{low:.3g}</text>'
                     f'<text x="{50 + width}" y="{top + height + 16}" text-anchor="end">{last:.1f} min</text>'
                     f'<polyline fill="none" stroke="#06c" stroke-width="1.5" points="'
                     f'{" ".join(place(*p) for p in points)}"/>')
    lines.append("</svg>\n")
    replace(path, lambda file: file.write("\n".join(lines).encode()))


class Run:
    """A folder with checkpoint.pt, policy.npz, course.jsonl's rows and curves.svg."""

    def __init__(self, folder: Path, task: str, start_from: Path | None, threads: int, seed: int) -> None:
        self.folder, self.task = folder, task
        folder.mkdir(parents=True, exist_ok=True)
        self.envs = VectorEnv(ENVIRONMENTS, **TASKS[task], threads=threads)
        observation = self.envs.single_observation_space.shape[0]
        self.learner = Learner(observation, self.envs.single_action_space.shape[0])
        self.optimizer = torch.optim.Adam(self.learner.parameters(), lr=LEARNING_RATE, eps=1e-5)
        self.opponents = Opponents(self.envs)
        self.seed, self.random = seed, np.random.default_rng(seed)
        self.observations, _ = self.envs.reset(seed=1_000_000 * seed)
        self.course: list[dict[str, float]] = []
        self.seconds, self.cpu, self.steps, self.updates = 0.0, 0.0, 0, 0
        checkpoint = folder / "checkpoint.pt"
        if checkpoint.exists():
            self._load(torch.load(checkpoint, weights_only=False))
        elif start_from is not None:
            self.learner.load_state_dict(torch.load(start_from / "checkpoint.pt", weights_only=False)["learner"])
            with torch.no_grad():
                self.learner.log_std.fill_(-1.0)

    def _load(self, state: dict[str, Any]) -> None:
        for name, here in (("task", self.task), ("seed", self.seed)):
            if state[name] != here:
                sys.exit(f"{self.folder}: this run has the {name} {state[name]}, not {here}")
        self.learner.load_state_dict(state["learner"])
        self.optimizer.load_state_dict(state["optimizer"])
        self.opponents.past = state["past"]
        self.course = state["course"]
        self.seconds, self.cpu = state["seconds"], state["cpu"]
        self.steps, self.updates = state["steps"], state["updates"]
        self.random.bit_generator.state = state["random"]
        torch.set_rng_state(state["torch"])
        for match, copy in enumerate(state["matches"]):
            self.envs.restore(copy, match)
        self.observations = self.envs.batch.observations.copy()

    def save(self) -> None:
        state = {"task": self.task, "seed": self.seed, "learner": self.learner.state_dict(),
                 "optimizer": self.optimizer.state_dict(), "past": self.opponents.past, "course": self.course,
                 "seconds": self.seconds, "cpu": self.cpu, "steps": self.steps, "updates": self.updates,
                 "random": self.random.bit_generator.state, "torch": torch.get_rng_state(),
                 "matches": [self.envs.save(match) for match in range(self.envs.batch.matches)]}
        replace(self.folder / "checkpoint.pt", lambda file: torch.save(state, file))
        save_policy(self.learner, self.envs, self.folder / "policy.npz")
        if self.course:
            draw(self.folder / "curves.svg", self.course,
                 {"goal": "goals of an episode", "return": "return of an episode", "steps_s": "steps a second",
                  "spread": "spread of the actions", "chaser": "goals for minus against, a minute, against chaser"})

    def report(self, episodes: list[dict[str, float]], done: float, rate: float) -> None:
        row = {"minutes": self.seconds / 60.0, "cpu_minutes": self.cpu / 60.0, "steps": float(self.steps), "steps_s": rate,
               "spread": float(self.learner.log_std.exp().mean())}
        if episodes:
            row |= {name: float(np.mean([e[name] for e in episodes])) for name in ("goal", "return")}
        self.course.append(row)
        print(f"{row['minutes']:6.1f} min ({row['cpu_minutes']:.1f} of processors)  {self.steps / 1e6:7.2f} M steps  "
              f"{rate:7.0f}/s  "
              f"goals {row.get('goal', np.nan):5.2f}  return {row.get('return', np.nan):6.2f}  "
              f"spread {row['spread']:.2f}  {done:.1%} done", flush=True)


def train(run: Run, minutes: float, steps: float | None, stop_after: float) -> None:
    """Learns until the run has had that many minutes or steps in all, for `stop_after` minutes, or until it is interrupted."""
    stops: list[int] = []
    for name in (signal.SIGINT, signal.SIGTERM):
        signal.signal(name, lambda number, frame: stops.append(number))
    pause = run.seconds + 60.0 * stop_after

    def done() -> float:  # the share of the run; by steps it is the same in each run
        return run.seconds / (60.0 * minutes) if steps is None else run.steps / steps

    episodes: list[dict[str, float]] = []
    saved = reported = run.seconds
    steps_reported = run.steps
    while done() < 1.0 and run.seconds < pause and not stops:
        begin, cpu = time.monotonic(), time.process_time()
        for group in run.optimizer.param_groups:
            group["lr"] = LEARNING_RATE * max(0.1, 1.0 - done())
        run.opponents.choose(run.learner, run.random)
        batch, run.observations = collect(run.envs, run.learner, run.opponents, run.observations, episodes)
        update(run.learner, run.optimizer, batch)
        run.updates += 1
        run.steps += STEPS * ENVIRONMENTS
        if run.updates % 25 == 0:
            run.opponents.remember(run.learner, run.random)
        run.seconds += time.monotonic() - begin
        run.cpu += time.process_time() - cpu
        if run.seconds - reported >= REPORT_S:
            run.report(episodes, done(), (run.steps - steps_reported) / (run.seconds - reported))
            reported, steps_reported, episodes = run.seconds, run.steps, []
        if run.seconds - saved >= CHECKPOINT_S:
            if run.task == "play":
                run.course[-1]["chaser"] = against(run.folder / "policy.npz", "chaser", 16) if saved > 0.0 else 0.0
            run.save()
            saved = run.seconds
    run.save()
    if stops:
        print(f"{run.folder}: saved; the same command continues", file=sys.stderr)
        sys.exit(130)


# ---- how good it is

def scores(policy: Path, episodes: int, seed: int) -> dict[str, float]:
    """Plays episodes of the task `score` that training has not seen."""
    act = mirocup.Policy.load(policy)
    envs = VectorEnv(episodes, **{**TASKS["score"], "start": SCORE_START, "autoreset_mode": AutoresetMode.DISABLED})
    observations, _ = envs.reset(seed=seed)
    goals = np.zeros(episodes)
    ended = np.zeros(episodes, bool)
    while not ended.all():
        observations, _, terminations, truncations, infos = envs.step(act(observations))
        new = (terminations | truncations) & ~ended
        if new.any():
            goals[new] = infos["statistics"]["goal"][new]
        ended |= new
    share = float((goals > 0).mean())
    error = 1.96 * (share * (1.0 - share) / episodes) ** 0.5
    return {"episodes": episodes, "scored": share, "low": share - error, "high": share + error,
            "own_goals": float((goals < 0).mean())}


def against(policy: Path, opponent: str, matches: int) -> float:
    """Goals for minus goals against in a minute of play from kick-offs, on average."""
    act = mirocup.Policy.load(policy)
    arguments = {**COMMON, "autoreset_mode": AutoresetMode.DISABLED}
    envs = VectorEnv(3 * matches, **arguments, opponent=opponent, ends_at_goal=False, episode_seconds=60.0)
    observations, _ = envs.reset(seed=77)
    while True:
        observations, _, terminations, truncations, infos = envs.step(act(observations))
        if (terminations | truncations).all():
            return float((infos["statistics"]["score"] - infos["statistics"]["opponent_score"]).mean())


def main() -> None:
    parser = argparse.ArgumentParser(description="A team learns by PPO.")
    parser.add_argument("task", choices=[*TASKS, "test"])
    parser.add_argument("folder", nargs="?", help="folder of the run (default: the name of the task)")
    parser.add_argument("--minutes", type=float, default=30.0, help="minutes of training, with those of earlier starts")
    parser.add_argument("--steps", type=float, help="steps of training of all learners together, instead of minutes")
    parser.add_argument("--stop-after", type=float, default=float("inf"), metavar="MINUTES",
                        help="end this start after MINUTES; the same command continues the run (for jobs with a time limit)")
    parser.add_argument("--from", dest="start_from", type=Path, help="run whose network this run begins with")
    parser.add_argument("--threads", type=int, default=0, help="number of threads (0: one for each processor)")
    parser.add_argument("--seed", type=int, default=1, help="of networks, episodes and actions (default: 1)")
    arguments = parser.parse_args()
    folder = Path(arguments.folder or ("score" if arguments.task == "test" else arguments.task))
    torch.set_num_threads(arguments.threads or os.cpu_count() or 1)
    if arguments.task == "test":
        print(json.dumps(scores(folder / "policy.npz", 1000, 900_000_000)))
        return
    torch.manual_seed(arguments.seed)
    run = Run(folder, arguments.task, arguments.start_from, arguments.threads, arguments.seed)
    train(run, arguments.minutes, arguments.steps, arguments.stop_after)


if __name__ == "__main__":
    main()
