// SPDX-License-Identifier: MIT
//
// The show: announces each leg of a round, plays it from its record, shows each goal once more, and
// then what it changes in the table. What is still to come is not in the page before its turn.
import { FieldView } from '/page/field.js';
import { element, minutes, words } from '/page/text.js';
import { Track, unpack } from '/page/track.js';

const announceSeconds = 5;
const resultSeconds = 4;
const tableSeconds = 6;
const flagSeconds = 1.2;  // of "Goal" before it is shown again
const againBefore = 3;  // s of a goal that are shown again
const againAfter = 0.4;
const againSpeed = 0.6;  // of real time
const speeds = [0.5, 1, 2, 4, 8, 16];

const by = (id) => document.getElementById(id);
const asked = Number(new URLSearchParams(location.search).get('speed'));
const state = { isHeld: true, isSkipped: false, speed: asked > 0 ? asked : 1 };

function showTempo() {
  by('tempo').textContent = `${state.isHeld ? 'held · ' : ''}${state.speed} ×`;
}

const commands = {
  toggle() { state.isHeld = !state.isHeld; },
  skip() { state.isSkipped = true; state.isHeld = false; },
  faster() { state.speed = speeds.find((speed) => speed > state.speed) ?? state.speed; },
  slower() { state.speed = speeds.findLast((speed) => speed < state.speed) ?? state.speed; },
};

function obey(command) {
  commands[command]?.();
  by('begin').hidden = by('begin').hidden || !state.isHeld;
  showTempo();
}

// Calls step(seconds passed) for each picture until it returns true. Holding stops the time;
// skipping ends it at once, and then the answer is false.
function during(step) {
  return new Promise((resolve) => {
    let before = performance.now();
    const frame = (now) => {
      const passed = Math.max(now - before, 0) / 1000;
      before = now;
      if (state.isSkipped) {
        state.isSkipped = false;
        resolve(false);
      } else if (!state.isHeld && step(passed)) {
        resolve(true);
      } else {
        requestAnimationFrame(frame);
      }
    };
    requestAnimationFrame(frame);
  });
}

function wait(seconds) {
  let left = seconds;
  return during((passed) => (left -= passed) <= 0);
}

function showOnly(id) {
  for (const part of ['card', 'leg', 'standing']) by(part).hidden = part !== id;
}

async function load(path) {
  const answer = await fetch(path);
  if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
  return answer;
}

const parsed = (html) => new DOMParser().parseFromString(html, 'text/html').body;

// Shows the table after that many legs; rows that moved are marked.
async function loadStanding(legs) {
  const ranks = new Map([...by('standing').querySelectorAll('tr[data-name]')].map((row) => [row.dataset.name, +row.dataset.rank]));
  by('standing').replaceChildren(...parsed(await (await load(`/after/${legs}.html`)).text()).childNodes);
  for (const row of by('standing').querySelectorAll('tr[data-name]')) {
    const before = ranks.get(row.dataset.name);
    if (before > +row.dataset.rank) row.classList.add('up');
    if (before < +row.dataset.rank) row.classList.add('down');
  }
}

function placeOf(name) {
  const row = [...by('standing').querySelectorAll('tr[data-name]')].find((one) => one.dataset.name === name);
  return row ? `${name}: rank ${row.dataset.rank}, ${row.dataset.points} points` : name;
}

function announce(heading, leg) {
  by('heading').textContent = heading;
  by('pair').textContent = leg ? `${leg.blue} – ${leg.yellow}` : '';
  by('places').textContent = leg ? `${placeOf(leg.blue)} · ${placeOf(leg.yellow)}` : '';
  showOnly('card');
}

function flag(text, cssClass) {
  by('flag').hidden = !text;
  by('flag').textContent = text;
  by('flag').className = cssClass ?? '';
}

class LegShow {
  constructor(data) {
    this.data = data;
    this.names = { blue: data.teams.blue.name, yellow: data.teams.yellow.name };
    this.track = new Track(data.period);
    unpack(data.track.packed, data.track.frames, 3 + 6 * data.robots).forEach((frame, tick) => this.track.add(tick, frame));
    by('field').replaceChildren(...parsed(data.picture).childNodes);
    this.field = new FieldView(by('field').querySelector('svg'));
    this.end = this.track.lastTick * data.period;
    this.goals = data.decisions.filter((call) => call.decision === 'GOAL');
    by('blue').textContent = this.names.blue;
    by('yellow').textContent = this.names.yellow;
    this.show(0);
  }

  momentAt(time) {
    const tick = Math.floor(time / this.data.period + 1e-6);
    return this.data.moments.findLast((moment) => moment.tick <= tick) ?? this.data.moments[0];
  }

  show(time, score) {
    const moment = this.momentAt(time);
    const scene = this.field.show(this.track, time, moment.left);
    const shown = score ?? moment.score;
    by('score').textContent = `${shown.blue} : ${shown.yellow}`;
    by('when').textContent = `${words(moment.phase)} ${minutes(scene.clock)}`;
  }

  // Plays the seconds at a speed, which may change meanwhile.
  run(from, to, speed, score) {
    let time = from;
    return during((passed) => {
      time = Math.min(time + passed * speed(), to);
      this.show(time, score);
      return time >= to;
    });
  }

  async showGoal(goal) {
    const at = goal.tick * this.data.period;
    const team = goal.gainer ?? goal.team;
    const after = this.momentAt(at + 2 * this.data.period).score;
    this.show(at, after);
    flag(`Goal · ${this.names[team]}${goal.own_goal ? ' (own goal)' : ''}`, team);
    if (await wait(flagSeconds)) {
      flag('Once more', 'again');
      await this.run(Math.max(at - againBefore, 0), Math.min(at + againAfter, this.end), () => againSpeed, after);
    }
    flag('');
  }

  async play() {
    let from = 0;
    for (const goal of this.goals) {
      const at = goal.tick * this.data.period;
      if (!await this.run(from, at, () => state.speed)) return;
      await this.showGoal(goal);
      from = at;
    }
    await this.run(from, this.end, () => state.speed);
  }

  showResult() {
    const { score, end, fault } = this.data.result;
    this.show(this.end, score);
    by('when').textContent = words(end) + (fault ? ` · ${this.names[fault.team]}: ${fault.text}` : '');
  }
}

async function playLeg(leg, number, count) {
  announce(`Next, leg ${number} of ${count}: ${leg.where}`, leg);
  const loading = load(leg.data).then((answer) => answer.json());
  await wait(announceSeconds);
  const show = new LegShow(await loading);
  showOnly('leg');
  await show.play();
  flag('');
  show.showResult();
  await wait(resultSeconds);
  await loadStanding(number);
  showOnly('standing');
  await wait(tableSeconds);
}

async function run() {
  const programme = await (await load('/programme.json')).json();
  await loadStanding(0);
  showTempo();
  await during(() => true);
  for (const [i, leg] of programme.legs.entries()) await playLeg(leg, i + 1, programme.legs.length);
  document.body.classList.add('over');
  by('title').textContent = `${programme.round} is over`;
  const next = await (await load('/next.json')).json();
  if (next.length > 0) by('standing').append(element('p', '', `Next: ${next.join(', ')}`));
}

by('begin').addEventListener('click', () => obey('toggle'));
document.addEventListener('keydown', (event) => {
  const command = { ' ': 'toggle', n: 'skip', '+': 'faster', '-': 'slower' }[event.key];
  if (!command || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  obey(command);
});
new EventSource('/events').addEventListener('command', ({ data }) => JSON.parse(data).forEach(obey));
run();
