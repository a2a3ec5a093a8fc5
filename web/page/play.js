// SPDX-License-Identifier: MIT
//
// Play by hand, in the playground and from a moment of a replay: play.html. The module of browser/ plays in a worker; this page
// asks it for ticks, one question at a time.
import { placeIn } from './field.js';
import { startWorker } from './proof.js';
import { download } from './situation.js';
import { by, element, minutes, words } from './text.js';
import { ThoughtsCanvas, unpackBytes } from './thoughts.js';
import { Track } from './track.js';

export const houseTeams = ['idle', 'chaser', 'striker', 'navigator', 'tactician', 'planner', 'keeper'];  // from weak to strong; keeper defends
const colours = ['blue', 'yellow'];
const handSpeed = 65;  // rad/s of a wheel: house teams drive as fast
const handTurn = 9;  // rad/s, between the wheels and their mean
const fullSpeed = 80;  // rad/s, the limit of a wheel
const slowMotion = '0.25';  // in which a hand begins to drive
const firstDriven = 3;  // in the list of bodies: blue 1
const mostTicks = 20;  // in one question, so that keys are followed soon
const takenBack = 60;  // ticks, two seconds
const roomAhead = 0.09;  // m, between the middles of two robots that do not push each other
const braking = 200;  // rad/s of a wheel for each metre to an opponent
const shift = 0.02;  // m, by a key
const turn = Math.PI / 12;  // by a key or a button
const reach = 0.06;  // m: a body that is closer is meant
const unit = 2000;  // of a frame, in a metre
const readingTime = 40;  // ms for a letter

const get = (id) => by(`hand_${id}`);

// The angle by which a robot turns towards a place, and 1; or with its back to a place so far behind, and -1.
function turnTo({ x, y }, robot, farBehind) {
  const off = Math.atan2(y - robot.y, x - robot.x) - robot.heading;
  const turned = Math.atan2(Math.sin(off), Math.cos(off));
  return Math.abs(turned) > farBehind ? [turned - Math.sign(turned) * Math.PI, -1] : [turned, 1];
}

// Wheel speeds with which a robot drives to a place, and backwards to one behind it.
function wheelsTo(place, robot) {
  const distance = Math.hypot(place.x - robot.x, place.y - robot.y);
  if (distance < 0.02) return [0, 0];
  const [off, way] = turnTo(place, robot, 0.75 * Math.PI);
  const turning = Math.min(Math.max(14 * off, -handTurn), handTurn);
  const speed = Math.min(handSpeed, 200 * distance) * Math.max(Math.cos(off), 0) * way;
  return [speed - turning, speed + turning];
}

// Wheel speeds with which a robot drives through the ball, as fast as it can.
function wheelsThrough(ball, robot) {
  const [off, way] = turnTo(ball, robot, 0.5 * Math.PI);
  const turning = 20 * off;
  const speed = Math.max(fullSpeed * Math.cos(off) - Math.abs(turning), 0) * way;
  return [speed - turning, speed + turning];
}

// Takes off the speed with which a robot would push an opponent or hit a keeper: one is close ahead, without the ball between.
function withoutPushing([left, right], robot, ball, opponents) {
  const speed = (left + right) / 2;
  const [c, s] = [Math.sign(speed) * Math.cos(robot.heading), Math.sign(speed) * Math.sin(robot.heading)];
  const ahead = ({ x, y }) => {
    const [dx, dy] = [x - robot.x, y - robot.y];
    const way = dx * c + dy * s;
    return way > 0 && Math.abs(dy * c - dx * s) < roomAhead ? way : Infinity;
  };
  const nearest = Math.min(...opponents.map(ahead));
  if (speed === 0 || ahead(ball) < nearest) return [left, right];
  const kept = Math.sign(speed) * Math.min(Math.abs(speed), Math.max(braking * (nearest - roomAhead), 0));
  const turning = (right - left) / 2;
  return [kept - turning, kept + turning];
}

// A drill from a situation, in the frame of blue, which attacks +x.
function drillOf(situation, opponent, event, seconds) {
  const sign = situation.left === 'blue' ? 1 : -1;
  const turned = ([x, y, heading]) => [sign * x, sign * y, ...(heading ? [heading.map((value) => sign * value)] : [])];
  const robots = (list) => list.map(({ pose, twist, broken }) => ({ pose: turned(pose), twist, ...(broken ? { broken } : {}) }));
  const { position, velocity } = situation.ball;
  return {
    schema: 'mirocup/drill/1', title: 'From the playground', league: situation.league,
    situation: { ball: { position: turned(position), velocity: turned(velocity) }, blue: robots(situation.blue), yellow: robots(situation.yellow) },
    opponent, seconds, success: [{ event }],
  };
}

export class Play {
  // `view(league)` returns {svg, field, layers} that show a leg; `shown(left)` is called after each drawing.
  constructor(view, shown = () => {}) {
    this.viewOf = view;
    this.shown = shown;
    this.isOn = this.isPlaying = false;
    this.keepers = [-1, -1];
    this.keys = new Set();
    this.asked = this.moved = Promise.resolve();
    this.canvases = new Map();
    this.#connect();
  }

  // Asks the worker; answers come in the order of questions.
  ask(question) {
    const answer = this.asked.then(() => new Promise((resolve, reject) => {
      this.worker.onmessage = ({ data }) => (data.problem ? reject(new Error(data.problem)) : resolve(data.answer));
      this.worker.onerror = (event) => reject(new Error(event.message || 'the worker ended'));
      this.worker.postMessage(question);
    }));
    this.asked = answer.catch(() => {});
    return answer;
  }

  // Acts, and tells what went wrong.
  async try(act) {
    try {
      await act();
    } catch (error) {
      this.pause();
      get('told').textContent = `${error.message.charAt(0).toUpperCase()}${error.message.slice(1)}.`;
    }
  }

  // Starts the worker, which has handActs() of browser/mirocup.js.
  async connect(module) {
    this.worker = await startWorker(module, 'onmessage = answering(handActs());');
    await this.ask({ act: 'load', wasm: await unpackBytes(module.wasm) });
  }

  // Starts a leg: Session of browser/mirocup.js.
  async begin(module, start) {
    if (!this.worker) await this.connect(module);
    this.pause();
    this.#take(await this.ask({ act: 'begin', start }));
    this.isOn = true;
    by('hand').hidden = false;
    this.show();
  }

  end() {
    this.pause();
    this.isOn = false;
    by('hand').hidden = true;
    for (const canvas of this.canvases.values()) canvas.begin();
  }

  get robots() { return (this.bodies.length - 2) / 6; }
  get lastTime() { return this.track.lastTick * this.track.period; }

  // The chosen body: {index (-1: the ball), team, robot, x, y, heading}, or null.
  #body(value = get('body').value) {
    if (value === '') return null;
    const index = Number(value);
    if (index < 0) return { index, x: this.bodies[0], y: this.bodies[1] };
    const [x, y, heading] = this.bodies.slice(2 + 3 * index, 5 + 3 * index);
    return { index, team: colours[Number(index >= this.robots)], robot: index % this.robots, x, y, heading };
  }

  // What the hand commands now.
  #hand() {
    const body = this.#body();
    if (!body?.team) return null;
    const is = (...names) => Number(names.some((name) => this.keys.has(name)));
    const speed = handSpeed * (is('ArrowUp', 'w') - is('ArrowDown', 's'));
    const turning = handTurn * (is('ArrowLeft', 'a') - is('ArrowRight', 'd'));
    const ball = this.#body('-1');
    const wheels = this.keys.has('f') ? wheelsThrough(ball, body) : this.target ? wheelsTo(this.target, body) : [speed - turning, speed + turning];
    if (!get('fair').checked) return [body.team, body.robot, ...wheels];
    const first = body.team === 'blue' ? this.robots : 0;
    const opponents = Array.from({ length: this.robots }, (_, i) => this.#body(String(first + i)));
    return [body.team, body.robot, ...withoutPushing(wheels, body, ball, opponents)];
  }

  // Takes over what the worker answered.
  #take({ isNew, isBack, period, league, frames, status, teams, thoughts }) {
    const haveChangedEnds = !isNew && this.status && this.status.left !== status.left;
    Object.assign(this, { status, thoughts, teams, keepers: status.keepers });
    if (isNew) {
      get('calls').replaceChildren();
      get('files').replaceChildren();
      if (!isBack || period !== this.track.period) this.track = new Track(period);
      this.league = league ?? this.league;
      this.view = this.viewOf(this.league);
      this.over = null;
    }
    while (!this.track.isEmpty && this.track.lastTick >= status.tick) {
      this.track.ticks.pop();
      this.track.frames.pop();
    }
    for (const [tick, ...bodies] of frames) {
      this.bodies = bodies;
      const frame = bodies.map((value, i) => Math.round(value * (i > 1 && i % 3 === 1 ? 2048 / (2 * Math.PI) : unit)));
      this.track.add(tick, [Math.round(1000 * status.clock), ...frame]);
    }
    if (isNew || !this.isPlaying) this.time = this.lastTime;
    this.#offerBodies();
    this.#offerTeams();
    status.decisions.forEach((call) => this.#tellCall(call, isBack));
    if (haveChangedEnds) this.#tell(`The teams have changed ends. ${this.#aim()}`);
    this.#tellEnd();
  }

  #tellCall(call, isOld) {
    const text = `${minutes(call.clock, 0)} ${words(call.decision)}: ${call.reason}`;
    get('calls').prepend(element('li', call.decision === 'GOAL' ? 'goal' : '', text));
    if (isOld) return;
    this.#tell(text, call.decision === 'GOAL' ? `goal ${call.gainer}` : '');
  }

  // Shows a text on the field, as long as it takes to read it.
  #tell(text, kind = '') {
    const banner = by('banner');
    banner.textContent = text;
    banner.className = kind;
    banner.hidden = false;
    clearTimeout(this.bannerTimer);
    this.bannerTimer = setTimeout(() => { banner.hidden = true; }, 1500 + readingTime * text.length);
  }

  #tellEnd() {
    const { status } = this;
    if (status.drill) {
      const { passed, marks, seconds, why } = status.drill;
      const state = passed ? 'passed' : status.over ? `not passed, missing: ${words(why).toLowerCase()}` : 'under way';
      get('told').textContent = `Drill ${state}: ${Math.round(100 * marks)} of 100 marks, ${seconds.toFixed(1)} s.`;
    } else if (status.over && !this.over) {
      const { blue, yellow } = status.score;
      get('told').textContent = `${words(status.result?.end ?? 'over')}: ${blue} : ${yellow}. ${blue === yellow ? 'A draw' : blue > yellow ? 'Blue wins' : 'Yellow wins'}. Take two seconds back, or begin another leg.`;
    }
    this.over = status.over;
    if (status.over) this.pause();
  }

  #offerBodies() {
    const select = get('body');
    if (select.length === 2 * this.robots + 2) return;
    select.replaceChildren(new Option('nobody', ''), new Option('the ball (move it)', '-1'));
    for (let i = 0; i < 2 * this.robots; ++i) select.append(new Option(`${colours[Number(i >= this.robots)]} ${i % this.robots}`, i));
  }

  #offerTeams() {
    for (const colour of colours) {
      const select = get(colour);
      const name = this.teams[colour] ?? '';
      if (select.length === 0) {
        for (const team of houseTeams) select.append(new Option(team, team));
        select.append(new Option('nobody: robots stand', ''));
      }
      if (![...select.options].some(({ value }) => value === name)) select.prepend(new Option(name === 'recorded' ? 'as recorded' : name, name));
      select.value = name;
      select.disabled = Boolean(this.status.drill) && colour === 'yellow';
    }
  }

  show() {
    const { status, view } = this;
    if (!this.isOn) return;
    const { left } = status;
    view.field.show(this.track, this.time, left);
    if (this.dragged) this.#showDragged();
    view.layers.show(this.track, this.time, left);
    this.#showShapes(left);
    by('score').textContent = `${status.score.blue} : ${status.score.yellow}`;
    by('phase').textContent = status.over ? words(status.result?.end ?? 'over') : status.state === 'READY' ? 'Restart' : words(status.phase);
    by('clock').textContent = minutes(status.clock);
    get('time').textContent = `tick ${status.tick}`;
    get('play').classList.toggle('playing', this.isPlaying);
    get('play').setAttribute('aria-label', this.isPlaying ? 'Pause' : 'Play');
    this.#showCounts();
    get('aim').textContent = this.#aim();
    this.shown(left);
  }

  // The colour of the team of which the visitor drives a robot, or undefined.
  get driven() { return this.#body()?.team; }

  #aim() {
    if (!this.driven) return 'To play, choose a robot under “You drive”.';
    const end = this.driven === this.status.left ? 'right' : 'left';
    return `You score on the ${end}. While the game runs, hold the mouse or a finger where your robot shall go, and hold F or “Shoot” to shoot.`;
  }

  #showDragged() {
    const { index, x, y } = this.dragged;
    const at = index < 0 ? this.view.field.ball : this.view.field.robots[index];
    at.setAttribute('transform', `translate(${(1000 * x).toFixed(1)} ${(-1000 * y).toFixed(1)})`);
  }

  #showCounts() {
    const { stalemate, advantage, ...teams } = this.status.counts;
    const counts = [['ball gets nowhere', stalemate], ['advantage', advantage],
      ...colours.flatMap((colour) => Object.entries(teams[colour]).map(([what, seconds]) => [`${colour}: ${what}`, seconds]))];
    const some = counts.filter(([, seconds]) => seconds > 0).map(([what, seconds]) => `${what} ${seconds.toFixed(1)} s`);
    get('counts').textContent = `The referee counts: ${some.join(', ') || 'nothing'}.`;
  }

  // Draws thoughts, impacts and pairs that press, on a canvas over the picture.
  #showShapes(left) {
    const { svg } = this.view;
    if (!this.canvases.has(svg)) this.canvases.set(svg, new ThoughtsCanvas(svg));
    const canvas = this.canvases.get(svg);
    canvas.begin();
    const driven = this.#body();
    if (driven?.team) {
      canvas.draw({ circle: [driven.x, driven.y, 0.065], colour: '#ffffff' }, false);
      if (this.target) canvas.draw({ line: [driven.x, driven.y, this.target.x, this.target.y], colour: '#ffffffa0' }, false);
    }
    if (get('thoughts').checked) {
      this.thoughts.forEach((lines, i) => lines.split('\n').filter(Boolean).forEach((line) => canvas.draw(JSON.parse(line), colours[i] !== left)));
    }
    if (!get('contacts').checked) return;
    const placeOf = (i) => (i === 2 * this.robots ? this.bodies.slice(0, 2) : this.bodies.slice(2 + 3 * i, 4 + 3 * i));
    for (const [a, b] of this.status.pressing) {
      const [x, y] = placeOf(b);
      canvas.draw(a < 0 ? { circle: [x, y, 0.055], colour: '#ffffffc0' } : { line: [...placeOf(a), x, y], colour: '#ffffffc0' }, false);
    }
    for (const [x, y, nx, ny, impulse] of this.status.impacts) {
      const size = 0.15 * Math.sqrt(impulse);
      canvas.draw({ line: [x - nx * size, y - ny * size, x + nx * size, y + ny * size], colour: '#ff4f4f' }, false);
      canvas.draw({ text: [x, y + 0.05, `${(1000 * impulse).toFixed(0)} mN s`], colour: '#ffd0d0' }, false);
    }
  }

  pause() {
    this.isPlaying = false;
    if (this.track) this.time = this.lastTime;
    this.show();
  }

  toggle() {
    if (this.isPlaying || this.status.over) return this.pause();
    this.isPlaying = true;
    this.before = performance.now();
    requestAnimationFrame((now) => this.#frame(now));
    return this.show();
  }

  async #frame(now) {
    if (!this.isPlaying) return;
    this.time += Math.min(Math.max(now - this.before, 0) / 1000, 0.2) * Number(get('speed').value);
    this.before = now;
    const missing = Math.ceil((this.time - this.lastTime) / this.track.period);
    if (missing > 0 && !this.isBusy) {
      this.isBusy = true;
      await this.try(async () => this.#take(await this.ask({ act: 'play', ticks: Math.min(missing, mostTicks), hand: this.#hand() })));
      this.isBusy = false;
    }
    this.time = Math.min(this.time, this.lastTime);
    this.show();
    if (this.isPlaying) requestAnimationFrame((later) => this.#frame(later));
  }

  // Pauses, asks, and shows the answer.
  act(question) {
    this.pause();
    return this.try(async () => {
      const answer = await this.ask(question);
      if (!this.status.drill) get('told').textContent = '';
      this.#take(answer);
      this.time = this.lastTime;
      this.show();
    });
  }

  // Gives the robots to the teams of the lists, and plays on if the leg ran.
  async seat() {
    const { isPlaying } = this;
    await this.act({ act: 'seat', teams: { blue: get('blue').value, yellow: get('yellow').value } });
    if (isPlaying) this.toggle();
  }

  // Behind all earlier moves.
  step(ticks) {
    this.moved = this.moved.then(() => this.act(ticks < 0 ? { act: 'back', ticks: -ticks } : { act: 'play', ticks, hand: this.#hand() }));
    return this.moved;
  }

  // Moves a body: `change(body)` returns what is other, seen from where all earlier moves have put it.
  move(index, change) {
    this.moved = this.moved.then(() => {
      const body = this.#body(String(index));
      return this.act({ act: 'move', body: { ...body, ...change(body) } });
    });
  }

  turnBy(angle) {
    const body = this.#body();
    if (body?.team) this.move(body.index, ({ heading }) => ({ heading: heading + angle }));
  }

  choose(index) {
    get('body').selectedIndex = (index + get('body').length) % get('body').length;
    this.keys.clear();
    this.#slowDown();
    this.show();
  }

  // A hand begins in slow motion, unless the visitor has chosen a speed.
  #slowDown() {
    if (this.hasSpeed || !this.#body()?.team) return;
    this.hasSpeed = true;
    get('speed').value = slowMotion;
  }

  async save() {
    this.pause();
    const name = `leg-${(await this.ask({ act: 'hash' })).slice(0, 8)}`;
    const { record, replay } = await this.ask({ act: 'save', name });
    const link = (file, data, type) => {
      const made = element('a', '', file);
      Object.assign(made, { download: file, href: URL.createObjectURL(new Blob([data], { type })) });
      return made;
    };
    const first = link(`${name}.json`, record, 'application/json');
    get('files').replaceChildren('Files: ', first, ' and ', link(`${name}.replay.zst`, replay, 'application/zstd'));
    get('told').textContent = `The leg up to here is in two files; keep both in one folder: mirocup verify ${name}.json reproduces them.`;
    first.focus();
  }

  async saveSituation() { download('situation.json', await this.ask({ act: 'situation' })); }

  async saveDrill() {
    const situation = JSON.parse(await this.ask({ act: 'situation' }));
    const opponent = this.teams.yellow === 'recorded' || !this.teams.yellow ? 'idle' : this.teams.yellow;
    download('drill.json', JSON.stringify(drillOf(situation, opponent, get('event').value, Number(get('seconds').value)), null, 1));
  }

  #connect() {
    const on = (id, act) => get(id).addEventListener('click', act);
    on('play', () => this.toggle());
    on('back', () => this.step(-1));
    on('forward', () => this.step(1));
    on('again', () => this.step(-takenBack));
    get('shoot').addEventListener('pointerdown', (event) => {
      if (!this.driven) this.choose(firstDriven);
      this.keys.add('f');
      event.target.setPointerCapture(event.pointerId);
    });
    for (const end of ['pointerup', 'pointercancel']) get('shoot').addEventListener(end, () => this.keys.delete('f'));
    on('left', () => this.turnBy(turn));
    on('right', () => this.turnBy(-turn));
    on('record', () => this.try(() => this.save()));
    on('situation', () => this.try(() => this.saveSituation()));
    on('drill', () => this.try(() => this.saveDrill()));
    for (const id of ['thoughts', 'contacts']) get(id).addEventListener('change', () => this.show());
    for (const colour of colours) {
      get(colour).addEventListener('change', () => this.seat());
    }
    // After a choice with the mouse, arrow keys are for the robot and not for the list.
    let isByMouse = false;
    get('body').addEventListener('pointerdown', () => { isByMouse = true; });
    get('body').addEventListener('keydown', () => { isByMouse = false; });
    get('body').addEventListener('change', () => {
      this.#slowDown();
      if (isByMouse) get('play').focus();
      this.show();
    });
    get('speed').addEventListener('change', () => { this.hasSpeed = true; });
    document.addEventListener('keydown', (event) => this.#onKey(event));
    document.addEventListener('keyup', (event) => this.keys.delete(event.key.length === 1 ? event.key.toLowerCase() : event.key));
    addEventListener('blur', () => this.keys.clear());
    addEventListener('resize', () => this.show());
    this.#connectPointer(document.querySelector('figure'));
  }

  #onKey(event) {
    const { target } = event;
    if (!this.isOn || event.ctrlKey || event.altKey || event.metaKey || target.tagName === 'SELECT' || target.type === 'number') return;
    if (event.key === ' ' && ['BUTTON', 'INPUT', 'A', 'SUMMARY'].includes(target.tagName)) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const acts = {
      ' ': () => this.toggle(), ',': () => this.step(-1), b: () => this.step(-takenBack), '.': () => this.step(1), q: () => this.turnBy(turn), e: () => this.turnBy(-turn),
      n: () => this.choose(get('body').selectedIndex + 1), '-': () => this.#speed(-1), '+': () => this.#speed(1), '=': () => this.#speed(1),
    };
    const body = this.#body();
    const ways = { ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] };
    if (/^[0-9]$/.test(key)) {
      const ofTeam = body?.team === 'yellow' ? this.robots : 0;
      if (Number(key) < this.robots) this.choose(2 + ofTeam + Number(key));
    } else if (event.shiftKey && ways[key]) {
      if (!body || this.isPlaying) return;
      this.move(body.index, ({ x, y }) => ({ x: x + shift * ways[key][0], y: y + shift * ways[key][1] }));
    } else if (ways[key] || 'wasdf'.includes(key)) {
      if (!body?.team) this.choose(firstDriven);
      this.keys.add(key);
    } else if (acts[key]) {
      acts[key]();
    } else {
      return;
    }
    event.preventDefault();
  }

  #speed(direction) {
    this.hasSpeed = true;
    const select = get('speed');
    select.selectedIndex = Math.min(Math.max(select.selectedIndex + direction, 0), select.length - 1);
  }

  // While the leg runs, the chosen robot drives to where the mouse or a finger is held; while it stands, bodies are dragged.
  #connectPointer(figure) {
    const at = (event) => placeIn(this.view.svg, event);
    const nearest = ({ x, y }) => Array.from({ length: 2 * this.robots + 1 }, (_, i) => this.#body(String(i - 1)))
      .map((body) => ({ ...body, far: Math.hypot(body.x - x, body.y - y) }))
      .reduce((a, b) => (b.far < a.far ? b : a));
    figure.addEventListener('pointerdown', (event) => {
      if (!this.isOn) return;
      const place = at(event);
      if (this.isPlaying) {
        if (!this.#body()?.team) this.choose(firstDriven);
        this.target = place;
      } else {
        const body = nearest(place);
        if (body.far > reach) return;
        this.choose(body.index + 2);
        this.dragged = body;
      }
      figure.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    figure.addEventListener('pointermove', (event) => {
      if (this.target) this.target = at(event);
      if (!this.dragged) return;
      Object.assign(this.dragged, at(event), { isMoved: true });
      this.show();
    });
    const release = () => {
      const { dragged } = this;
      this.target = this.dragged = null;
      if (dragged?.isMoved) this.move(dragged.index, () => ({ x: dragged.x, y: dragged.y }));
    };
    for (const end of ['pointerup', 'pointercancel']) figure.addEventListener(end, release);
  }
}
