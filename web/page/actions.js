// SPDX-License-Identifier: MIT
//
// Shots and passes of the leg as marks in the picture (docs/statistics.md says what counts as one).
// A mark stands where the team had the ball, seen with the ends as they are at the shown moment. What
// is still to come is faint.
import { shape } from './text.js';

const radius = 22;  // mm, of a shot
const head = 30;  // mm, of an arrow

// The place of a team, which attacks +x, in the picture: mm, y downwards.
function placed([x, y], isLeft) {
  const mm = isLeft ? 1000 : -1000;
  return [mm * x, -mm * y];
}

function shotPath({ place }, isLeft) {
  const [x, y] = placed(place, isLeft);
  return `M${x - radius} ${y}a${radius} ${radius} 0 1 0 ${2 * radius} 0a${radius} ${radius} 0 1 0 ${-2 * radius} 0`;
}

function passPath({ from, to }, isLeft) {
  const [x1, y1] = placed(from, isLeft);
  const [x2, y2] = placed(to, isLeft);
  const way = Math.atan2(y2 - y1, x2 - x1);
  const barb = (turn) => `${(x2 - head * Math.cos(way + turn)).toFixed(1)} ${(y2 - head * Math.sin(way + turn)).toFixed(1)}`;
  return `M${x1} ${y1}L${x2} ${y2}M${barb(0.5)}L${x2} ${y2}L${barb(-0.5)}`;
}

class Marks {
  constructor(group, classOf, pathOf) {
    Object.assign(this, { group, classOf, pathOf, all: [] });
    group.style.display = 'none';
  }

  set(all) {
    this.all = all;
    this.left = undefined;
    this.group.replaceChildren(...all.map((one) => shape('path', { class: this.classOf(one) })));
  }

  show(isOn, tick, left) {
    this.group.style.display = isOn ? '' : 'none';
    if (!isOn) return;
    this.all.forEach((one, i) => {
      const path = this.group.children[i];
      if (left !== this.left) path.setAttribute('d', this.pathOf(one, one.team === left));
      path.classList.toggle('later', one.tick > tick);
    });
    this.left = left;
  }
}

export class Actions {
  // The marks stand below the element `above` of the picture.
  constructor(above) {
    const group = (name) => {
      const made = shape('g', { class: name });
      above.before(made);
      return made;
    };
    this.passes = new Marks(group('passes'), ({ team }) => `pass ${team}`, passPath);
    this.shots = new Marks(group('shots'), (one) =>
      `shot ${one.team}${one.on_goal ? ' on_goal' : ''}${one.goal ? ' scored' : ''}`, shotPath);
  }

  set({ shots, passes }) {
    this.shots.set(shots);
    this.passes.set(passes);
  }

  show(isOn, tick, left) {
    this.passes.show(isOn.passes, tick, left);
    this.shots.show(isOn.shots, tick, left);
  }
}
