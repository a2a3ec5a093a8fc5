// SPDX-License-Identifier: MIT
//
// The momentum of a leg: for each moment, how far the ball was in the half of the other team in the
// seconds about it. Blue is above the middle line, yellow below.
import { shape } from './text.js';

const span = 6;  // s to each side over which it is smoothed
const most = 240;  // points of the curve
const height = 60;

// Returns a number from -1 (at the line of blue's goal) to 1 (at yellow's) for each point of a leg. `half`: from the middle to a goal
// line, in units of a frame; `leftAt(tick)`: the team that defends the left end.
export function momentum(track, half, leftAt) {
  const { firstTick, lastTick, period } = track;
  const step = Math.max(1, Math.ceil((lastTick - firstTick) / most));
  const raw = [];
  for (let tick = firstTick; tick <= lastTick; tick += step) {
    const x = track.frames[track.indexAt(tick)][1] / half;
    raw.push(leftAt(tick) === 'blue' ? x : -x);
  }
  const reach = Math.max(1, Math.round(span / (step * period)));
  return raw.map((_, i) => {
    let sum = 0;
    let weights = 0;
    for (let j = Math.max(0, i - reach); j <= Math.min(raw.length - 1, i + reach); ++j) {
      const weight = 1 - Math.abs(j - i) / (reach + 1);
      sum += weight * raw[j];
      weights += weight;
    }
    return sum / weights;
  });
}

export class MomentumView {
  // `jump(share)` goes to a moment: 0 is the begin of the leg, 1 its end.
  constructor(place, jump) {
    this.svg = shape('svg', { viewBox: `0 0 1000 ${height}`, preserveAspectRatio: 'none', 'aria-hidden': 'true' });
    this.now = shape('path', { class: 'now' });
    this.svg.addEventListener('click', (event) => {
      const box = this.svg.getBoundingClientRect();
      jump((event.clientX - box.left) / box.width);
    });
    place.replaceChildren(this.svg);
  }

  // `goals`: [{share, team}].
  draw(values, goals) {
    const middle = height / 2;
    const x = (i) => ((1000 * i) / Math.max(values.length - 1, 1)).toFixed(1);
    const area = (team, sign) => shape('path', {
      class: team,
      d: `M0 ${middle}` + values.map((v, i) =>
        `L${x(i)} ${(middle - sign * Math.max(0, sign * v) * middle).toFixed(1)}`).join('') + `L1000 ${middle}Z`,
    });
    const marks = goals.map(({ share, team }) => {
      const at = (1000 * share).toFixed(1);
      const y = team === 'blue' ? 7 : height - 7;
      return shape('path', { class: team, d: `M${at - 4} ${y}L${at} ${y - 7}L${+at + 4} ${y}L${at} ${y + 7}Z` });
    });
    this.svg.replaceChildren(area('blue', 1), area('yellow', -1),
      shape('path', { class: 'half', d: `M0 ${middle}H1000` }), ...marks, this.now);
  }

  show(share) { this.now.setAttribute('d', `M${(1000 * share).toFixed(1)} 0V${height}`); }
}
