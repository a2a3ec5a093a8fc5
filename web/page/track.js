// SPDX-License-Identifier: MIT
//
// The positions of all bodies, tick by tick. A frame is an array of whole numbers: clock, ball x and
// y, then x, y and heading of each robot, blue ones first (web/track_encoder.hpp).

const lengthUnit = 0.5;  // mm
const clockUnit = 0.001;  // s
const headingUnit = 360 / 2048;  // degrees
const jump = 400;  // units: a body that moves further within a tick was lifted, not driven

// Decodes the rows of ColumnEncoder: columns of zigzag numbers, each the change of a change.
function unpack(text, frameCount, columnCount) {
  return unpackBytesOf(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)), frameCount, columnCount);
}

// The same from bytes: ColumnEncoder.
export function unpackBytesOf(bytes, frameCount, columnCount) {
  const frames = Array.from({ length: frameCount }, () => new Int32Array(columnCount));
  let at = 0;
  for (let column = 0; column < columnCount; ++column) {
    let value = 0;
    let change = 0;
    for (let i = 0; i < frameCount; ++i) {
      let bits = 0;
      let shift = 0;
      let byte;
      do {
        byte = bytes[at++];
        bits |= (byte & 0x7f) << shift;
        shift += 7;
      } while (byte & 0x80);
      change += (bits >>> 1) ^ -(bits & 1);
      value += change;
      frames[i][column] = value;
    }
  }
  return frames;
}

// Returns the index of the last element whose tick is at or before a tick; 0: none.
export function lastAt(all, tick, tickOf = (one) => one) {
  let low = 0;
  let high = all.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (tickOf(all[middle]) <= tick) low = middle;
    else high = middle;
  }
  return low;
}

export class Track {
  constructor(period) {
    this.period = period;
    this.ticks = [];
    this.frames = [];
  }

  add(tick, frame) {
    if (this.ticks.length > 0 && tick <= this.lastTick) return;
    this.ticks.push(tick);
    this.frames.push(frame);
  }

  // Takes over a whole leg, or a part of it: a track as JSON of a page.
  load({ packed, frames }, robots) {
    unpack(packed, frames, 3 + 6 * robots).forEach((frame, tick) => this.add(tick, frame));
  }

  get isEmpty() { return this.ticks.length === 0; }
  get firstTick() { return this.ticks[0] ?? 0; }
  get lastTick() { return this.ticks[this.ticks.length - 1] ?? 0; }
  get lastClock() { return (this.frames[this.frames.length - 1]?.[0] ?? 0) * clockUnit; }

  // Returns the last frame at or before the tick.
  indexAt(tick) { return lastAt(this.ticks, tick); }

  // Returns all positions at a time (s), interpolated linearly between two frames: mm with y
  // downwards, degrees clockwise.
  at(time) {
    const place = Math.min(Math.max(time / this.period, this.firstTick), this.lastTick);
    const index = this.indexAt(place + 1e-6);
    const now = this.frames[index];
    const next = this.frames[Math.min(index + 1, this.frames.length - 1)];
    const gap = (this.ticks[index + 1] ?? this.ticks[index] + 1) - this.ticks[index];
    const part = Math.min(Math.max((place - this.ticks[index]) / gap, 0), 1);
    const lifted = (i) => Math.abs(next[i] - now[i]) + Math.abs(next[i + 1] - now[i + 1]) > jump * gap;
    const between = (i, stays) => (stays ? now[i] : now[i] + (next[i] - now[i]) * part);
    const point = (i) => {
      const stays = lifted(i);
      return { x: between(i, stays) * lengthUnit, y: -between(i + 1, stays) * lengthUnit, stays };
    };
    const robots = [];
    for (let i = 3; i < now.length; i += 3) {
      const { x, y, stays } = point(i);
      robots.push({ x, y, stays, degrees: -between(i + 2, stays) * headingUnit });
    }
    return { tick: this.ticks[index], clock: now[0] * clockUnit, ball: point(1), robots };
  }

  // Returns the trail in the seconds before of the ball, or of the body whose x is that column: runs
  // of points, split where the body was lifted.
  trail(time, seconds, column = 1) {
    const runs = [[]];
    const last = this.indexAt(time / this.period + 1e-6);
    const first = this.indexAt(Math.max((time - seconds) / this.period, this.firstTick));
    for (let i = first; i <= last; ++i) {
      const [x, y] = [this.frames[i][column], this.frames[i][column + 1]];
      const before = this.frames[Math.max(i - 1, first)];
      if (Math.abs(x - before[column]) + Math.abs(y - before[column + 1]) > jump) runs.push([]);
      runs[runs.length - 1].push([x * lengthUnit, -y * lengthUnit]);
    }
    return runs;
  }

  // Returns place and velocity (mm and mm/s, y downwards) of the ball and of each robot, from the
  // frames before and after; nothing for a body that was lifted.
  velocities(time) {
    const i = this.indexAt(time / this.period + 1e-6);
    const j = Math.min(i + 1, this.frames.length - 1);
    const [now, next] = [this.frames[i], this.frames[j]];
    const seconds = Math.max(this.ticks[j] - this.ticks[i], 1) * this.period;
    const scene = this.at(time);
    return [scene.ball, ...scene.robots].map(({ x, y, stays }, body) => {
      const column = body === 0 ? 1 : 3 * body;
      const moved = [next[column] - now[column], next[column + 1] - now[column + 1]];
      if (stays || Math.abs(moved[0]) + Math.abs(moved[1]) > jump) return null;
      return { x, y, dx: (moved[0] * lengthUnit) / seconds, dy: (-moved[1] * lengthUnit) / seconds };
    });
  }
}
