// SPDX-License-Identifier: MIT
//
// The numbers of one robot at the shown tick, in the frame of its team, beside those of another tick that the reader keeps; and
// what its team thought and printed then.
import { metres } from './situation.js';
import { element, shape } from './text.js';
import { unpackBytes } from './thoughts.js';
import { unpackBytesOf } from './track.js';

const clickReach = 0.06;  // m: a robot that is closer to a click is meant
const ringRadius = 64;  // mm
const aboutReach = 0.12;  // m: a text of the thoughts that is closer is about the robot
const wheelUnit = 0.1;  // rad/s, as web/page.cpp has it

const halfTurned = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));
const withUnit = (value, digits, unit) => (Number.isNaN(value) ? '–' : `${(Math.abs(value) < 0.5 * 10 ** -digits ? 0 : value).toFixed(digits)} ${unit}`);

export class Inspector {
  // `place`: for the numbers; `body`: the choice of robots; `names`: of the teams. `wheels`: packed rows of the page's data, or nothing; `own(team, tick)`:
  // {shapes, lines} of the team in that tick, or null; `changed()` is called when another robot or tick is to be shown.
  constructor({ place, body, names }, viewer, wheels, own, changed) {
    Object.assign(this, { place, body, names, viewer, own, changed, index: -1, kept: null, rows: null });
    this.ring = shape('circle', { class: 'inspected', r: ringRadius });
    this.ring.style.display = 'none';
    viewer.svg.append(this.ring);
    body.append(new Option('no robot', -1));
    for (let i = 0; i < 2 * viewer.robots; ++i) body.append(new Option(`${this.nameOf(i)}`, i));
    body.addEventListener('change', () => this.choose(Number(body.value)));
    this.table = element('table', 'numbers');
    this.said = element('div', 'said_then');
    this.keep = element('button', 'button', 'Keep this tick');
    this.keep.title = 'Keep the numbers of this tick beside those of others (X)';
    this.keep.addEventListener('click', () => this.toggleKept());
    place.append(this.table, this.keep, this.said);
    if (wheels) unpackBytes(wheels).then((bytes) => {
      this.rows = unpackBytesOf(bytes, viewer.track.frames.length, 10 * viewer.robots);
      changed();
    });
  }

  teamOf(index) { return index < this.viewer.robots ? 'blue' : 'yellow'; }
  nameOf(index) { return `${this.names[this.teamOf(index)]} ${index % this.viewer.robots} (${this.teamOf(index)})`; }

  choose(index) {
    this.index = index;
    this.kept = null;
    this.body.value = index;
    this.changed();
  }

  next() { this.choose(this.index + 1 < 2 * this.viewer.robots ? this.index + 1 : -1); }

  // Chooses the robot at a place in the picture; returns false if there is none.
  chooseAt({ x, y }, time) {
    const far = this.viewer.track.at(time).robots.map((robot) => Math.hypot(robot.x / 1000 - x, robot.y / -1000 - y));
    const index = far.indexOf(Math.min(...far));
    if (far[index] > clickReach) return false;
    this.choose(index === this.index ? -1 : index);
    return true;
  }

  toggleKept() {
    if (this.index < 0) return;
    this.kept = this.kept ? null : this.numbersAt(this.tick);
    this.changed();
  }

  // The numbers of the robot in a tick, in the frame of its team, which attacks +x.
  numbersAt(tick) {
    const { track } = this.viewer;
    const at = track.indexAt(tick);
    const before = Math.max(at - 1, 0);
    const team = this.teamOf(this.index);
    const sign = this.viewer.momentAt(tick).left === team ? 1 : -1;
    const [{ robots: old }, { robots, ball }] = [before, at].map((i) => metres(track.frames[i]));
    const { x, y, angle } = robots[this.index];
    const [dx, dy] = [x - old[this.index].x, y - old[this.index].y];
    // A robot that was lifted to its place has no speed.
    const { stays } = track.at((track.ticks[at] - 0.5) * track.period).robots[this.index];
    const seconds = stays ? NaN : Math.max(track.ticks[at] - track.ticks[before], 1) * track.period;
    const row = this.rows && [...this.rows[at]].slice(5 * this.index, 5 * this.index + 5);
    return {
      tick, team, x: sign * x, y: sign * y, heading: halfTurned(angle + (sign < 0 ? Math.PI : 0)),
      speed: (dx * Math.cos(angle) + dy * Math.sin(angle)) / seconds, turn: (angle - old[this.index].angle) / seconds,
      toBall: halfTurned(Math.atan2(ball.y - y, ball.x - x) - angle), far: Math.hypot(ball.x - x, ball.y - y),
      asked: row?.slice(0, 2).map((speed) => speed * wheelUnit), driven: row?.slice(2, 4).map((speed) => speed * wheelUnit), age: row?.[4],
    };
  }

  show(time) {
    const { track } = this.viewer;
    this.tick = Math.floor(time / track.period + 1e-6);
    const isOn = this.index >= 0;
    this.place.hidden = !isOn;
    this.ring.style.display = isOn ? '' : 'none';
    if (!isOn) return;
    const { x, y } = track.at(time).robots[this.index];
    this.ring.setAttribute('transform', `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
    this.#showNumbers(this.numbersAt(this.tick));
    this.keep.textContent = this.kept ? 'Drop the kept tick' : 'Keep this tick';
  }

  #showNumbers(now) {
    const columns = this.kept ? [this.kept, now] : [now];
    const degrees = (angle) => withUnit((angle * 180) / Math.PI, 1, '°');
    const pair = (values) => (values ? `${values[0].toFixed(1)}  ${values[1].toFixed(1)} rad/s` : '');
    const lines = [
      ['x, y', (n) => `${n.x.toFixed(3)}  ${n.y.toFixed(3)} m`], ['Heading', (n) => degrees(n.heading)],
      ['Speed', (n) => withUnit(n.speed, 2, 'm/s')], ['Turn', (n) => withUnit(n.turn, 1, 'rad/s')],
      ['Ball', (n) => `${n.far.toFixed(3)} m, ${degrees(n.toBall)}`],
      ...(this.rows ? [['Wheels asked', (n) => pair(n.asked)], ['Wheels driven', (n) => pair(n.driven)],
        ['Age of the picture', (n) => `${n.age} ticks`]] : []),
    ];
    const head = element('tr');
    head.append(element('td'), ...columns.map(({ tick }) => element('th', '', `tick ${tick}`)));
    this.table.replaceChildren(element('caption', '', `${this.nameOf(this.index)}, as its team sees the field: it attacks +x`), head,
      ...lines.map(([name, text]) => {
        const row = element('tr');
        const label = element('th', '', name);
        label.scope = 'row';
        row.append(label, ...columns.map((numbers) => element('td', '', text(numbers))));
        return row;
      }));
    this.said.replaceChildren(...columns.flatMap((numbers) => this.#saidThen(numbers)));
  }

  #saidThen({ tick, team, x, y }) {
    const own = this.own(team, tick);
    if (!own) return [];
    const about = own.shapes.filter(({ text }) => text && Math.hypot(text[0] - x, text[1] - y) < aboutReach).map(({ text }) => text[2]);
    const line = (what, text) => element('p', 'small', `Tick ${tick}, ${what}: ${text}`);
    return [...(about.length > 0 ? [line('thinks', about.join(' · '))] : []), ...own.lines.map((text) => line('printed', text))];
  }
}
