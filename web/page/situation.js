// SPDX-License-Identifier: MIT
//
// A moment of a leg to go on from: the command that plays on from there, and the situation as a
// file (docs/situations.md).

const jumpLength = 0.2;  // m: a body that moves further within a tick was lifted, not driven
const restBelow = 0.02;  // m/s and rad/s: slower than the rounding of positions can tell

const quoted = (word) => (/^[\w.,:/+-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

// The name of the record: `mirocup replay leg.json -o leg.html` makes a page of the same name.
function recordName() {
  const name = decodeURIComponent(location.pathname.split('/').pop());
  return name.endsWith('.html') ? name.replace(/\.html$/, '.json') : 'leg.json';
}

// A record does not know the file that a team came from.
const fileWord = (colour) => `${colour.toUpperCase()}_FILE`;
const teamWord = ({ name, kind }, colour) => (kind === 'plugin' ? fileWord(colour) : quoted(kind === 'dds' ? `dds:${name}` : name));

export function commandAt(tick, teams) {
  const files = ['blue', 'yellow'].filter((colour) => teams[colour].kind === 'plugin')
    .map((colour) => `${fileWord(colour)}: the file of ${teams[colour].name.replace(/[^\w .-]/g, '?')}`);
  return `mirocup match --from ${quoted(recordName())} --tick ${tick}`
    + ` --blue ${teamWord(teams.blue, 'blue')} --yellow ${teamWord(teams.yellow, 'yellow')} --watch`
    + (files.length > 0 ? `  # ${files.join(', ')}` : '');
}

const rounded = (value, digits) => Number(value.toFixed(digits));
const speed = (value) => (Math.abs(value) < restBelow ? 0 : rounded(value, 3));

// The positions of a frame: m and rad, y upwards.
export function metres(frame) {
  const robots = [];
  for (let i = 3; i < frame.length; i += 3) {
    robots.push({ x: frame[i] * 5e-4, y: frame[i + 1] * 5e-4, angle: (frame[i + 2] * 2 * Math.PI) / 2048 });
  }
  return { ball: { x: frame[1] * 5e-4, y: frame[2] * 5e-4 }, robots };
}

const apart = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);

// Returns how a body moves between two frames `seconds` apart.
function motion(from, to, seconds) {
  if (seconds === 0 || apart(from, to) > jumpLength) return { vx: 0, vy: 0, turn: 0 };
  const turned = Math.atan2(Math.sin(to.angle - from.angle), Math.cos(to.angle - from.angle));
  return { vx: (to.x - from.x) / seconds, vy: (to.y - from.y) / seconds, turn: (turned || 0) / seconds };
}

function robotAt(from, at, to, seconds) {
  const { vx, vy, turn } = motion(from, to, seconds);
  const [c, s] = [Math.cos(at.angle), Math.sin(at.angle)];
  return {
    pose: [rounded(at.x, 4), rounded(at.y, 4), rounded(at.angle, 5)],
    twist: [speed(c * vx + s * vy), speed(c * vy - s * vx), speed(turn)],
  };
}

// Returns the situation of a tick as the text of a file. `moment` is the state of the leg, `call` the
// last call with a restart. Speeds are differences of positions.
export function situationAt({ track, tick, moment, call, league }) {
  const isStanding = moment.state === 'READY';
  const index = track.indexAt(tick);
  const first = Math.max(index - 1, 0);
  const last = Math.min(index + 1, track.frames.length - 1);
  const seconds = isStanding ? 0 : (last - first) * track.period;
  const [from, at, to] = [first, index, last].map((i) => metres(track.frames[i]));
  const robots = at.robots.map((robot, i) => robotAt(from.robots[i], robot, to.robots[i], seconds));
  const { vx, vy } = motion(from.ball, to.ball, seconds);
  const half = robots.length / 2;
  return JSON.stringify({
    schema: 'mirocup/situation/1',
    league,
    left: moment.left,
    ball: { position: [rounded(at.ball.x, 4), rounded(at.ball.y, 4)], velocity: [speed(vx), speed(vy)] },
    blue: robots.slice(0, half),
    yellow: robots.slice(half),
    restart: isStanding && call ? { kind: call.restart, taker: call.taker } : null,
    phase: moment.phase,
    clock: rounded(track.frames[index][0] * 1e-3, 3),
    score: [moment.score.blue, moment.score.yellow],
  }, null, 1);
}

// Saves a text or a Blob as a file.
export function download(name, data, type = 'application/json') {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([data], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
