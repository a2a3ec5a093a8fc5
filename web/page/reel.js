// SPDX-License-Identifier: MIT
//
// The reel: goals only. It plays the seconds before and after each goal, the moment of the goal in
// slow motion, then jumps to the next.

const before = 4;  // s shown before a goal
const after = 1.5;  // s shown after it
const slowBefore = 0.7;  // s before the goal from which time is slow
const slowAfter = 0.5;
const slow = 0.25;  // of the chosen speed

export class Reel {
  // `goals()`: the seconds of the goals so far, in order.
  constructor(goals) {
    this.goals = goals;
    this.isOn = false;
  }

  // Returns the runs that are shown, goals close to each other in one: [{from, to}].
  runs() {
    const runs = [];
    for (const goal of this.goals()) {
      const last = runs[runs.length - 1];
      if (last && goal - before <= last.to) last.to = goal + after;
      else runs.push({ from: Math.max(goal - before, 0), to: goal + after });
    }
    return runs;
  }

  isSlow(time) {
    return this.isOn && this.goals().some((goal) => time > goal - slowBefore && time < goal + slowAfter);
  }

  // Returns the speed at a time, as a factor of the chosen one.
  speedAt(time) { return this.isSlow(time) ? slow : 1; }

  // Returns where the reel goes on from a time: that time inside a run, else the begin of the next
  // one; nothing after the last.
  next(time) {
    const run = this.runs().find(({ to }) => time < to);
    return run && Math.max(time, run.from);
  }

  get first() { return this.runs()[0]?.from; }
}
