// SPDX-License-Identifier: MIT
//
// The player: the shown time stands, runs at some speed, or follows a running match. A reel may leave
// out what is between the goals.

const catchUp = 8;  // 1/s: rate at which a follower closes the gap to the last tick received
const farBehind = 2;  // s: beyond this gap it jumps
const asGoodAs = 0.002;  // s: below this gap the follower is up to date

export class Player {
  // `changed` is called whenever the page must be redrawn.
  constructor(track, reel, changed) {
    Object.assign(this, { track, reel, changed, time: 0, speed: 1, before: 0 });
    this.isLooping = this.isPlaying = this.isFollowing = false;
  }

  get begin() { return this.track.firstTick * this.track.period; }
  get end() { return this.track.lastTick * this.track.period; }

  // Where it begins again.
  get start() { return (this.reel.isOn && this.reel.first) || this.begin; }

  seek(time) {
    this.isFollowing = false;
    this.show(time);
  }

  step(ticks) {
    this.isPlaying = false;
    const tick = Math.floor(this.time / this.track.period + 1e-6);
    this.seek((tick + ticks) * this.track.period);
  }

  toggle() {
    this.isPlaying = !this.isPlaying;
    this.isFollowing = false;
    const next = this.reel.isOn ? this.reel.next(this.time) : this.time;
    if (this.isPlaying && (next === undefined || next >= this.end)) this.time = this.start;
    this.wake();
    this.changed();
  }

  follow() {
    this.isFollowing = true;
    this.isPlaying = false;
    this.wake();
    this.changed();
  }

  show(time) {
    this.time = Math.min(Math.max(time, this.begin), this.end);
    this.changed();
  }

  advance(time) {
    const next = this.reel.isOn ? this.reel.next(time) : time;
    if (next !== undefined && next < this.end) return this.show(next);
    if (!this.isLooping) this.isPlaying = false;
    return this.show(this.isLooping ? this.start : next ?? time);
  }

  wake() {
    if (this.isAwake) return;
    this.isAwake = true;
    this.before = performance.now();
    requestAnimationFrame((now) => this.frame(now));
  }

  frame(now) {
    const passed = Math.max(now - this.before, 0) / 1000;
    this.before = now;
    if (this.isFollowing) {
      const gap = this.end - this.time;
      const jumps = Math.abs(gap) > farBehind || Math.abs(gap) < asGoodAs;
      this.show(jumps ? this.end : this.time + gap * Math.min(1, passed * catchUp));
    } else if (this.isPlaying) {
      this.advance(this.time + passed * this.speed * this.reel.speedAt(this.time));
    }
    this.isAwake = this.isPlaying || this.isFollowing;
    if (this.isAwake) requestAnimationFrame((later) => this.frame(later));
  }
}
