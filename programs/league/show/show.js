// SPDX-License-Identifier: MIT
//
// The show: announces each leg of a round, plays it from its record, shows each goal once more, and
// then what it changes in the table or the bracket; or two or four legs side by side. What is still to come is not in
// the page before its turn.
import { FieldView } from '/page/field.js';
import { by, element, minutes, words } from '/page/text.js';
import { Track } from '/page/track.js';

const announceSeconds = 5;
const resultSeconds = 4;
const tableSeconds = 6;
const flagSeconds = 1.2;  // of "Goal" before it is shown again
const againBefore = 3;  // s of a goal that are shown again
const againAfter = 0.4;
const againSpeed = 0.6;  // of real time
const speeds = [0.5, 1, 2, 4, 8, 16];

const asked = Number(new URLSearchParams(location.search).get('speed'));
const state = { isHeld: true, isSkipped: false, speed: asked > 0 ? asked : 1, atOnce: 1 };

function showTempo() {
  const several = state.atOnce > 1 ? ` · ${state.atOnce} at once` : '';
  by('tempo').textContent = `${state.isHeld ? 'held · ' : ''}${state.speed} ×${several}`;
}

// How many legs are shown at once counts from the next ones on.
const commands = {
  one() { state.atOnce = 1; },
  two() { state.atOnce = 2; },
  four() { state.atOnce = 4; },
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
  for (const part of ['card', 'leg', 'standing', 'champion']) by(part).hidden = part !== id;
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
  const rows = by('standing').querySelectorAll('tr[data-name]');
  by('standing').style.setProperty('--rows', rows.length + 1);  // so that all of them are on the projector
  for (const row of rows) {
    const before = ranks.get(row.dataset.name);
    if (before > +row.dataset.rank) row.classList.add('up');
    if (before < +row.dataset.rank) row.classList.add('down');
  }
}

// Where both teams are in the table; nothing in a knockout, which has none.
function places(...names) {
  const rows = [...by('standing').querySelectorAll('tr[data-name]')];
  return names.map((name) => rows.find((row) => row.dataset.name === name)).filter((row) => row)
    .map(({ dataset: { name, rank, points } }) => `${name}: rank ${rank}, ${points} points`).join(' · ');
}

function announce(heading, legs) {
  by('heading').textContent = heading;
  by('pairs').replaceChildren(...legs.flatMap((leg) => [
    element('p', 'pair', `${leg.blue} – ${leg.yellow}`),
    element('p', 'places', places(leg.blue, leg.yellow)),
  ]));
  by('pairs').dataset.pairs = legs.length;
  showOnly('card');
}

// One leg in a panel of its own. advance() is called for each picture; a goal stops the leg until it
// was shown again, and the other panels go on.
class LegPanel {
  constructor(data) {
    this.data = data;
    this.names = { blue: data.teams.blue.name, yellow: data.teams.yellow.name };
    this.track = new Track(data.period);
    this.track.load(data.track, data.robots);
    this.panel = by('panel').content.firstElementChild.cloneNode(true);
    this.panel.setAttribute('aria-label', `${this.names.blue} – ${this.names.yellow}`);
    this.part('picture').replaceChildren(...parsed(data.picture).childNodes);
    this.field = new FieldView(this.part('picture').querySelector('svg'));
    this.end = this.track.lastTick * data.period;
    this.goals = data.decisions.filter((call) => call.decision === 'GOAL');
    this.part('name.blue').textContent = this.names.blue;
    this.part('name.yellow').textContent = this.names.yellow;
    this.time = 0;  // s, of the leg
    this.phase = 'play';
    this.show();
  }

  part(cssClass) {
    return this.panel.querySelector(`.${cssClass}`);
  }

  get isOver() {
    return this.phase === 'over';
  }

  momentAt(time) {
    const tick = Math.floor(time / this.data.period + 1e-6);
    return this.data.moments.findLast((moment) => moment.tick <= tick) ?? this.data.moments[0];
  }

  show(score) {
    const moment = this.momentAt(this.time);
    const scene = this.field.show(this.track, this.time, moment.left);
    const shown = score ?? moment.score;
    this.part('score').textContent = `${shown.blue} : ${shown.yellow}`;
    this.part('when').textContent = `${words(moment.phase)} ${minutes(scene.clock)}`;
  }

  flag(text, cssClass = '') {
    const flag = this.part('flag');
    flag.hidden = !text;
    flag.textContent = text;
    flag.className = `flag ${cssClass}`;
  }

  advance(passed) {
    if (this.phase === 'play') this.#play(passed);
    else if (this.phase === 'goal') this.#announceGoal(passed);
    else if (this.phase === 'again') this.#showAgain(passed);
    return this.isOver;
  }

  #play(passed) {
    const goal = this.goals[0];
    const until = goal ? goal.tick * this.data.period : this.end;
    this.time = Math.min(this.time + passed * state.speed, until);
    this.show();
    if (this.time < until) return;
    if (!goal) {
      this.showResult();
      return;
    }
    const team = goal.gainer ?? goal.team;
    this.after = this.momentAt(until + 2 * this.data.period).score;
    this.left = flagSeconds;
    this.phase = 'goal';
    this.show(this.after);
    this.flag(`Goal · ${this.names[team]}${goal.own_goal ? ' (own goal)' : ''}`, team);
  }

  #announceGoal(passed) {
    this.left -= passed;
    if (this.left > 0) return;
    this.time = Math.max(this.time - againBefore, 0);
    this.phase = 'again';
    this.flag('Once more', 'again');
  }

  #showAgain(passed) {
    const at = this.goals[0].tick * this.data.period;
    const until = Math.min(at + againAfter, this.end);
    this.time = Math.min(this.time + passed * againSpeed, until);
    this.show(this.after);
    if (this.time >= until) this.leaveGoal();
  }

  // Goes on after a goal. Returns false if none is shown.
  leaveGoal() {
    if (this.phase !== 'goal' && this.phase !== 'again') return false;
    this.time = this.goals.shift().tick * this.data.period;
    this.phase = 'play';
    this.flag('');
    return true;
  }

  showResult() {
    const { score, end, fault } = this.data.result;
    this.phase = 'over';
    this.panel.classList.add('over');
    this.time = this.end;
    this.flag('');
    this.show(score);
    this.part('when').textContent = words(end) + (fault ? ` · ${this.names[fault.team]}: ${fault.text}` : '');
  }
}

// Plays all panels at once until each leg is over. What is skipped is the goal that is shown again,
// if there is one panel, and otherwise the rest of the legs.
async function playPanels(panels) {
  const step = (passed) => panels.map((panel) => panel.advance(passed)).every((isOver) => isOver);
  while (!await during(step)) {
    if (panels.length === 1 && panels[0].leaveGoal()) continue;
    for (const panel of panels) panel.showResult();
    return;
  }
}

// Shows the legs, of which the first one is that number of the round.
async function playLegs(legs, number, count) {
  const last = number + legs.length - 1;
  const which = legs.length === 1 ? `leg ${number} of ${count}: ${legs[0].where}` : `legs ${number} to ${last} of ${count}`;
  announce(`Next, ${which}`, legs);
  const loading = Promise.allSettled(legs.map(async (leg) => new LegPanel(await (await load(leg.data)).json())));
  await wait(announceSeconds);
  const loaded = await loading;
  const missing = legs.filter((leg, i) => loaded[i].status === 'rejected');
  if (missing.length > 0) {
    announce('Cannot be shown here; the table has the result', missing);
    await wait(resultSeconds);
  }
  const panels = loaded.filter(({ status }) => status === 'fulfilled').map(({ value }) => value);
  if (panels.length > 0) await showPanels(panels);
  await loadStanding(last);
  if (!legs.some((leg) => leg.has_standing)) return;
  showOnly('standing');
  await wait(tableSeconds);
}

async function showPanels(panels) {
  by('leg').replaceChildren(...panels.map(({ panel }) => panel));
  by('leg').dataset.panels = panels.length;
  showOnly('leg');
  await playPanels(panels);
  await wait(resultSeconds);
}

async function run() {
  const programme = await (await load('/programme.json')).json();
  state.atOnce = programme.at_once;
  await loadStanding(0);
  showTempo();
  await during(() => true);
  const { legs } = programme;
  for (let shown = 0; shown < legs.length;) {
    const next = legs.slice(shown, shown + state.atOnce);
    await playLegs(next, shown + 1, legs.length);
    shown += next.length;
  }
  document.body.classList.add('over');
  by('title').textContent = `${programme.round} is over`;
  by('champion').replaceChildren(...parsed(await (await load('/champion.html')).text()).childNodes);
  if (by('champion').firstElementChild) showOnly('champion');
  const next = await (await load('/next.json')).json();
  if (next.length > 0) by('standing').append(element('p', '', `Next: ${next.join(', ')}`));
}

by('begin').addEventListener('click', () => obey('toggle'));
document.addEventListener('keydown', (event) => {
  const command = { ' ': 'toggle', n: 'skip', '+': 'faster', '-': 'slower', 1: 'one', 2: 'two', 4: 'four' }[event.key];
  if (!command || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  obey(command);
});
new EventSource('/events').addEventListener('command', ({ data }) => JSON.parse(data).forEach(obey));
run();
