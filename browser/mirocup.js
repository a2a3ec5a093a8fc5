// SPDX-License-Identifier: MIT
//
// The game as a module for browsers and node: legs, their state, their records. It imports nothing, so that a page that is
// opened from disk can run it in a worker. docs/browser.md has examples.
//
// Units: m, rad, s; wheels rad/s; the field's frame, in which left attacks +x. Teams are 'blue' and 'yellow'. A function that
// gets something wrong throws a MirocupError with a sentence and the exit code that `mirocup` would have.

export class MirocupError extends Error {
  constructor({ code, what }) {
    super(what);
    this.code = code;
  }
}

const teamNumber = (team) => ['blue', 'yellow'].indexOf(team);
const magic = new TextEncoder().encode('mirocup/replay/2\n');
const maxPlain = 1 << 30;  // bytes of an unpacked replay

// Loads the module. `source`: bytes or a WebAssembly.Module. `teams` plays the team 'mine': {create, decide, destroy, place} of
// browser/outside.cpp, each with the module's memory before the arguments. Without it that team refuses to play.
export async function loadMirocup(source, teams = {}) {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
  const imports = {};
  let exports;
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    // The C library calls the other functions of a system. They answer 0, because there is no clock, file or argument here.
    (imports[from] ??= {})[name] = (...values) => {
      if (name === 'proc_exit') throw new Error('the module has ended');
      return from === 'outside' && teams[name] ? teams[name](exports.memory.buffer, ...values) : 0;
    };
  }
  ({ exports } = await WebAssembly.instantiate(module, imports));
  exports._initialize();
  return new Mirocup(exports);
}

export class Mirocup {
  #m;

  constructor(exports) { this.#m = exports; }

  // Verifies a record as `mirocup verify` does. `record`: its text; `replay`: bytes of its replay, unpacked; `isWhole`: false if
  // a digest is not right. Returns {reproduced, tick, what, ticks, state_hash, found}: `tick` is the first one that differs.
  verify(record, replay, isWhole = true, name = 'the record') {
    return this.with([record, replay, name], (text, bytes, path) =>
      this.answer(this.#m.verify(text, bytes, isWhole ? 1 : 0, path)));
  }

  // The SHA-256 of bytes or a text, in hexadecimal digits.
  sha256(bytes) { return this.with([bytes], (text) => this.text(this.#m.sha256(text))); }

  // Makes a leg. `options`: {league, rules, stage, seed, conditions, pitch, situation, drill, teams: {blue, yellow}}, as in
  // records; a team is the name of a house team, or '' for robots that stand until they are driven.
  leg(options) {
    const made = this.with([JSON.stringify(options)], (text) => this.answer(this.#m.leg_make(text)));
    return new Leg(this, this.#m, made.leg);
  }

  // Plays a recorded leg up to `tick`, from where `teams` go on: a house team each, 'recorded', or ''.
  goOn(record, replay, tick, teams) {
    const made = this.with([record, replay, JSON.stringify(teams)], (text, bytes, names) =>
      this.answer(this.#m.leg_go_on(text, bytes, tick, names)));
    return new Leg(this, this.#m, made.leg);
  }

  // The rest is for Leg. A text of the module becomes a string or bytes, and is freed.
  bytes(text) {
    const bytes = new Uint8Array(this.#m.memory.buffer, this.#m.text_data(text), this.#m.text_size(text)).slice();
    this.#m.text_free(text);
    return bytes;
  }

  text(text) { return new TextDecoder().decode(this.bytes(text)); }

  answer(text) {
    const answer = JSON.parse(this.text(text));
    if (answer.error) throw new MirocupError(answer.error);
    return answer;
  }

  give(value) {
    const bytes = typeof value === 'string' ? new TextEncoder().encode(value) : value;
    const text = this.#m.text_new(bytes.length);
    new Uint8Array(this.#m.memory.buffer, this.#m.text_data(text), bytes.length).set(bytes);
    return text;
  }

  with(values, act) {
    const texts = values.map((value) => this.give(value));
    try {
      return act(...texts);
    } finally {
      texts.forEach((text) => this.#m.text_free(text));
    }
  }
}

// A leg that is played in the module. free() ends it.
export class Leg {
  #mirocup;
  #m;
  #leg;

  constructor(mirocup, exports, leg) {
    this.#mirocup = mirocup;
    this.#m = exports;
    this.#leg = leg;
  }

  // Keeps impacts, pairs that press and thoughts from now on, for status() and thoughts(). It costs a quarter of the speed.
  watch() { this.#m.leg_watch(this.#leg); }

  // Plays so many ticks, or until the leg or the try of its drill is over. Returns the number of ticks played.
  play(ticks = 1) { return this.#m.leg_play(this.#leg, ticks); }

  // Drives a robot by hand from the next tick on, rad/s; release() gives it back to its team.
  drive(team, robot, left, right) { this.#m.leg_drive(this.#leg, teamNumber(team), robot, left, right, 1); }
  release(team, robot) { this.#m.leg_drive(this.#leg, teamNumber(team), robot, 0, 0, 0); }

  // Gives the robots to other teams from the next tick on; a team whose name stays keeps its memory.
  seat(teams) { this.#mirocup.with([JSON.stringify(teams)], (text) => this.#mirocup.answer(this.#m.leg_seat(this.#leg, text))); }

  // The number of the next tick.
  get tick() { return this.#m.leg_tick(this.#leg) >>> 0; }

  // {tick, time, clock, state, phase, left, score, over, keepers, counts, impacts, pressing, decisions from number `first` on,
  // result, drill}; browser/game.hpp describes them.
  status(first = 0) { return this.#mirocup.answer(this.#m.leg_status(this.#leg, first)); }

  // Why a team of a leg that is over did not do better: [{drill, why}], as `mirocup stats` advises.
  advice(team) { return this.#mirocup.answer(this.#m.leg_advice(this.#leg, teamNumber(team))); }

  // The bodies: [x, y of the ball, then x, y, heading of each of blue's robots and of yellow's].
  bodies() { return new Float64Array(this.#mirocup.bytes(this.#m.leg_bodies(this.#leg)).buffer); }

  // What a team drew in its last tick, as lines of mirocup/thoughts/1; watch() comes before.
  thoughts(team) { return this.#mirocup.text(this.#m.leg_thoughts(this.#leg, teamNumber(team))); }

  // Everything but teams and start, with the keys that leg() takes.
  setup() { return this.#mirocup.answer(this.#m.leg_setup(this.#leg)); }

  // The situation as the text of a file (docs/situations.md), from which a leg can start.
  situation() { return this.#mirocup.text(this.#m.leg_situation(this.#leg)); }

  // The state hash of all ticks played, 16 hexadecimal digits.
  get hash() { return BigInt.asUintN(64, this.#m.leg_hash(this.#leg)).toString(16).padStart(16, '0'); }

  // Ends the leg if it is not over, and returns its record and its replay file: {record: text, replay: bytes}. `mirocup verify`
  // reproduces them from files NAME.json and NAME.replay.zst.
  save(name = 'leg') {
    this.#m.leg_stop(this.#leg);
    const replay = packReplay(this.#mirocup.bytes(this.#m.leg_replay(this.#leg)));
    const [file, bytes] = [this.#mirocup.give(`${name}.replay.zst`), this.#mirocup.give(replay)];
    const record = this.#mirocup.text(this.#m.leg_record(this.#leg, file, bytes));
    [file, bytes].forEach((text) => this.#m.text_free(text));
    return { record, replay };
  }

  free() { this.#m.leg_free(this.#leg); }
}

// A leg that is played by hand: it can go back, bodies can be moved, and it goes on after it was saved. `start`: {options}, as for
// leg(), or {record, replay, tick, teams}, as for goOn(), with `substitutes` for recorded teams, which cannot play on from a
// situation that never was. To go back, the leg is played again from its start with the same hands on the same robots, so teams
// are as they were.
export class Session {
  #mirocup;
  #parts = [];  // {start, first, last, teams, acts: [[tick, name, arguments]]}; moving a body begins a part
  #held = null;  // {team, robot, left, right}

  constructor(mirocup, start) {
    this.#mirocup = mirocup;
    this.#begin(start);
  }

  get #part() { return this.#parts[this.#parts.length - 1]; }
  get teams() { return this.#part.teams; }

  #make(start) {
    const { options, record, replay, tick, teams } = start;
    const leg = options ? this.#mirocup.leg(options) : this.#mirocup.goOn(record, replay, tick, teams);
    leg.watch();
    return leg;
  }

  #begin(start) {
    const leg = this.#make(start);
    this.leg?.free();
    this.leg = leg;
    this.#held = null;
    this.#parts.push({ start, first: leg.tick, teams: (start.options ?? start).teams, acts: [] });
  }

  #act(name, ...values) {
    this.leg[name](...values);
    this.#part.acts.push([this.leg.tick, name, values]);
    if (name === 'seat') [this.#part.teams] = values;
  }

  // Plays the last part again up to a tick. What was done at that tick has not been done.
  #again(to) {
    const part = this.#part;
    const acts = part.acts.filter(([tick]) => tick < to);
    this.leg.free();
    this.leg = this.#make(part.start);
    this.#held = null;
    Object.assign(part, { acts: [], teams: (part.start.options ?? part.start).teams });
    for (const [tick, name, values] of acts) {
      this.leg.play(tick - this.leg.tick);
      this.#act(name, ...values);
      if (name !== 'seat') this.#held = name === 'drive' ? values : null;
    }
    this.leg.play(to - this.leg.tick);
  }

  // Drives one robot from the next tick on, `hand`: [team, robot, left, right], rad/s; null gives it back to its team.
  hold(hand) {
    if (String(hand) === String(this.#held)) return;
    const isOther = this.#held && (!hand || hand[0] !== this.#held[0] || hand[1] !== this.#held[1]);
    if (isOther) this.#act('release', this.#held[0], this.#held[1]);
    if (hand) this.#act('drive', ...hand);
    this.#held = hand;
  }

  // Gives the robots to other teams, {blue, yellow}.
  seat(teams) {
    this.hold(null);
    this.#act('seat', teams);
  }

  play(ticks = 1) { return this.leg.play(ticks); }

  // Goes back by so many ticks, and from the start of a part to the end of the part before. Returns false at the very beginning.
  back(ticks = 1) {
    const to = this.leg.tick - ticks;
    if (to >= this.#part.first) {
      this.#again(to);
    } else if (this.#parts.length > 1) {
      this.#parts.pop();
      this.#again(this.#part.last);
    } else {
      return false;
    }
    return true;
  }

  // Puts a robot, or without `team` the ball, somewhere at rest. Play is on from there.
  move({ team, robot, x, y, heading }) {
    const situation = JSON.parse(this.leg.situation());
    if (team) situation[team][robot] = { ...situation[team][robot], pose: [x, y, heading], twist: [0, 0, 0], wheels: [0, 0] };
    else situation.ball = { position: [x, y] };
    situation.restart = null;
    const teams = { ...this.teams };
    for (const colour of ['blue', 'yellow']) {
      if (teams[colour] === 'recorded') teams[colour] = this.#part.start.substitutes?.[colour] ?? '';
    }
    this.#part.last = this.leg.tick;
    this.#begin({ options: { ...this.leg.setup(), situation, teams } });
  }

  // Leg.save(); the session goes on.
  save(name) {
    const tick = this.leg.tick;
    const saved = this.leg.save(name);
    this.#again(tick);
    return saved;
  }

  free() { this.leg.free(); }
}

// Returns the functions of a worker that plays, by the name under which a page (web/page/play.js) asks for them. A worker sets
// onmessage = answering(handActs()).
export function handActs(load = loadMirocup) {
  let mirocup;
  let session;
  let told;
  const bodies = () => [session.leg.tick, ...session.leg.bodies()];
  const look = (more) => {
    const status = session.leg.status(told);
    told += status.decisions.length;
    return { frames: [bodies()], status, teams: session.teams, thoughts: ['blue', 'yellow'].map((team) => session.leg.thoughts(team)), ...more };
  };
  const lookAnew = (more) => {
    told = 0;
    return look({ isNew: true, period: session.leg.setup().pitch.control_period, league: session.leg.setup().league, ...more });
  };
  return {
    async load({ wasm }) { mirocup = await load(wasm); },
    begin({ start }) {
      const next = new Session(mirocup, start);
      session?.free();
      session = next;
      return lookAnew();
    },
    play({ ticks, hand }) {
      session.hold(hand);
      const frames = [];
      while (frames.length < ticks && session.play(1) === 1) frames.push(bodies());
      return look({ frames });
    },
    back({ ticks }) {
      const { teams } = session;
      if (!session.back(Math.max(1, Math.min(ticks, session.leg.tick)))) return look();
      if (JSON.stringify(session.teams) !== JSON.stringify(teams)) session.seat(teams);
      return lookAnew({ isBack: true });
    },
    seat({ teams }) {
      session.seat(teams);
      return look();
    },
    move({ body }) {
      session.move(body);
      return lookAnew();
    },
    save({ name }) { return session.save(name); },
    situation() { return session.leg.situation(); },
    hash() { return session.leg.hash; },
    advice({ team }) { return session.leg.advice(team); },
  };
}

// A worker's onmessage that answers {act, …} by one of `acts`.
export function answering(acts) {
  return async ({ data }) => {
    try {
      postMessage({ answer: await acts[data.act](data) });
    } catch (error) {
      postMessage({ problem: error.message });
    }
  };
}

// Packs a replay as blocks of zstd that are not compressed (RFC 8878, section 3.1.1).
export function packReplay(plain) {
  const most = 1 << 17;
  const blocks = Math.max(1, Math.ceil(plain.length / most));
  const out = new Uint8Array(magic.length + 13 + 3 * blocks + plain.length);
  const view = new DataView(out.buffer);
  out.set(magic);
  let at = magic.length;
  view.setUint32(at, 0xfd2fb528, true);
  out[at + 4] = 0xe0;  // one segment, its size in 8 bytes, no checksum
  view.setBigUint64(at + 5, BigInt(plain.length), true);
  at += 13;
  for (let i = 0; i < blocks; ++i) {
    const part = plain.subarray(i * most, (i + 1) * most);
    const head = (part.length << 3) | (i === blocks - 1 ? 1 : 0);
    out.set([head & 255, (head >> 8) & 255, head >> 16], at);
    out.set(part, at + 3);
    at += 3 + part.length;
  }
  return out;
}

// Unpacks a replay file with `decompress(frame, target)`, that of fzstd. The frame must say its size, as ours do.
export function unpackReplay(bytes, decompress, name = 'the replay') {
  const damaged = (what) => { throw new MirocupError({ code: 4, what: `${name}: ${what}` }); };
  if (!magic.every((byte, i) => bytes[i] === byte)) damaged('this is not a replay of version 2');
  const frame = bytes.subarray(magic.length);
  if (frame.length < 14) damaged('the compressed data is damaged');
  const view = new DataView(frame.buffer, frame.byteOffset, frame.length);
  const [sizeCode, isSegment] = [frame[4] >> 6, (frame[4] >> 5) & 1];
  const at = 5 + (isSegment ? 0 : 1) + [0, 1, 2, 4][frame[4] & 3];
  const size = [() => (isSegment ? view.getUint8(at) : -1), () => view.getUint16(at, true) + 256,
    () => view.getUint32(at, true), () => Number(view.getBigUint64(at, true))][sizeCode]();
  if (view.getUint32(0, true) !== 0xfd2fb528 || size < 0 || size > maxPlain) damaged('the compressed data is damaged');
  try {
    const plain = decompress(frame, new Uint8Array(size));
    if (plain.length === size) return plain;
  } catch { /* told below */ }
  return damaged('the compressed data is damaged');
}
