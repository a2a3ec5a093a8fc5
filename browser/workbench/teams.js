// SPDX-License-Identifier: MIT
//
// The team 'mine' of a leg (browser/outside.cpp): a compiled team is a WebAssembly module with a memory of its own, in which this
// file copies what the team is told, and out of which it copies the answers. A team can call nothing but the functions below: its
// log, its drawings, its parameters, and a clock that shows the time of the leg.

const maxLog = 64 << 10;  // letters of a leg
const maxShapes = 200;  // of a tick
const maxCorners = 32;
const maxWord = 4096;  // bytes that are read of a text
const kinds = ['line', 'circle', 'polygon', 'text'];
const timeOfDay = 946_684_800;  // s: 1 January 2000, at the beginning of each leg
const [noFile, noFunction] = [8, 52];  // errors of WASI
const reasons = [[/unreachable/, 'it called abort(), or reached code that must not be reached'], [/out of bounds/, 'it read or wrote outside of its memory'],
  [/call stack|stack size/, 'it called itself too often'], [/divide by zero/, 'it divided by 0']];

class Team {
  constructor(module, parameters, said) {
    Object.assign(this, { parameters, said, tick: 0, time: 0, shapes: [], line: '' });
    // A team may name an import as what each object inherits, such as 'constructor'.
    const bare = (functions) => Object.assign(Object.create(null), functions);
    const known = bare({ mirocup: bare(this.#own()), wasi_snapshot_preview1: bare(this.#system()) });
    const imports = bare();
    for (const { module: from, name } of WebAssembly.Module.imports(module)) {
      (imports[from] ??= bare())[name] = known[from]?.[name] ?? (() => noFunction);
    }
    this.exports = new WebAssembly.Instance(module, imports).exports;
    this.call('_initialize');
    this.at = [0, 1, 2, 3].map((what) => this.exports.at(what));
  }

  get #view() { return new DataView(this.exports.memory.buffer); }

  #text(at) {
    const bytes = new Uint8Array(this.exports.memory.buffer, at >>> 0);
    const end = at === 0 ? 0 : bytes.subarray(0, maxWord).indexOf(0);
    return new TextDecoder().decode(bytes.subarray(0, end < 0 ? maxWord : end));
  }

  #own() {
    return {
      log: (text) => this.said(this.tick, this.#text(text)),
      parameter: (name, fallback) => {
        const text = this.#text(name);
        return Object.hasOwn(this.parameters, text) ? this.parameters[text] : fallback;
      },
      draw: (kind, layer, colour, numbers, count, text) => {
        if (!kinds[kind] || this.shapes.length >= maxShapes || count > 2 * maxCorners || (kind === 2 && count < 6) || numbers === 0) return;
        const all = Array.from({ length: count }, (_, i) => this.#view.getFloat64(numbers + 8 * i, true));
        if (!all.every(Number.isFinite)) return;
        const shape = kind === 3 ? [...all, this.#text(text)] : kind === 2 ? all.flatMap((x, i) => (i % 2 ? [] : [[x, all[i + 1]]])) : all;
        this.shapes.push(JSON.stringify({
          tick: this.tick, layer: this.#text(layer), colour: `#${(colour >>> 0).toString(16).padStart(8, '0')}`, [kinds[kind]]: shape,
        }));
      },
    };
  }

  // The functions of WASI that have an answer here.
  #system() {
    return {
      fd_write: (file, parts, count, written) => {
        if (file !== 1 && file !== 2) return noFile;
        let size = 0;
        for (let i = 0; i < count; ++i) {
          const length = this.#view.getUint32(parts + 8 * i + 4, true);
          const bytes = new Uint8Array(this.exports.memory.buffer, this.#view.getUint32(parts + 8 * i, true), length);
          if (this.line.length < 2 * maxLog) this.line += new TextDecoder().decode(bytes.subarray(0, maxLog));
          size += length;
        }
        this.#view.setUint32(written, size, true);
        const lines = this.line.split('\n');
        this.line = lines.pop().slice(0, maxLog);
        lines.forEach((line) => this.said(this.tick, line));
        return 0;
      },
      // A terminal, so that the C library writes each line at once.
      fd_fdstat_get: (file, at) => {
        if (file > 2) return noFile;
        new Uint8Array(this.exports.memory.buffer, at, 24).fill(0);
        this.#view.setUint8(at, 2);
        return 0;
      },
      fd_prestat_get: () => noFile,
      environ_sizes_get: (count, size) => {  // getenv() finds nothing
        this.#view.setUint32(count, 0, true);
        this.#view.setUint32(size, 0, true);
        return 0;
      },
      environ_get: () => 0,
      clock_time_get: (_, precision, at) => {
        this.#view.setBigUint64(at, BigInt(Math.round(1e6 * (timeOfDay + this.time))) * 1000n, true);
        return 0;
      },
      proc_exit: (code) => { throw new Error(`it ended with exit(${code})`); },
    };
  }

  // Copies a structure of strategy.h from one memory into the other.
  take(what, game, at, size) { new Uint8Array(this.exports.memory.buffer, this.at[what], size).set(new Uint8Array(game, at, size)); }
  give(what, game, at, size) { new Uint8Array(game, at, size).set(new Uint8Array(this.exports.memory.buffer, this.at[what], size)); }

  // Calls a function of the team, and says why if it crashes.
  call(name) {
    try {
      return this.exports[name]();
    } catch (error) {
      const [, reason] = reasons.find(([pattern]) => pattern.test(error.message)) ?? [null, error.message];
      throw new Error(`your team crashed in ${name}() at tick ${this.tick}: ${reason}`);
    }
  }
}

// The argument `teams` of loadMirocup(). Each leg gets an instance of the team of its own.
export class Teams {
  #module;
  #teams = new Map();  // what create() returned -> Team
  #last = 0;
  #lines = [];
  #letters = 0;
  slowest = 0;  // ms of the longest call

  constructor(module, parameters = {}) {
    this.#module = module;
    this.parameters = parameters;
  }

  // The name under which the team takes a seat. Throws if it was compiled for another strategy.h.
  get name() {
    const version = new Team(this.#module, {}, () => {}).call('version');
    if (version === 0) throw new Error('the team names another MIROCUP_ABI_VERSION');
    return version & 2 ? 'mine' : 'mine, without place()';
  }

  create(game, setup) {
    const [size, command, placement] = new Uint32Array(game, setup, 3);
    const team = new Team(this.#module, this.parameters, (tick, text) => this.#say(tick, text));
    this.#letters = this.#lines.length = 0;
    team.sizes = { command, placement };
    team.colour = new DataView(game).getInt32(setup + 16, true);
    team.take(0, game, setup, size);
    if (!team.call('create')) throw new Error(`your team refuses to play: create() returned null. ${this.#lines.at(-1)?.text ?? ''}`);
    this.#teams.set(++this.#last, team);
    return this.#last;
  }

  destroy(_, id) { this.#teams.delete(id); }

  decide(game, id, now, command) {
    const team = this.#hear(game, id, now);
    const before = performance.now();
    team.call('decide');
    this.slowest = Math.max(this.slowest, performance.now() - before);
    team.give(2, game, command, team.sizes.command);
  }

  place(game, id, now, places) {
    const team = this.#hear(game, id, now);
    team.take(3, game, places, team.sizes.placement);
    team.call('place');
    team.give(3, game, places, team.sizes.placement);
  }

  // Returns the teams' drawings of the last tick, by colour, and the lines that they have printed since the last call.
  look(thoughts) {
    const drawn = [...thoughts];
    for (const { colour, shapes } of this.#teams.values()) drawn[colour] = shapes.join('\n');
    return { thoughts: drawn, log: this.#lines.splice(0), slowest: this.slowest };
  }

  #hear(game, id, now) {
    const team = this.#teams.get(id);
    const view = new DataView(game);
    const tick = view.getUint32(now + 4, true);
    if (tick !== team.tick) team.shapes = [];
    team.tick = tick;
    team.time = view.getFloat64(now + 8, true);
    team.take(1, game, now, view.getUint32(now, true));
    return team;
  }

  #say(tick, text) {
    if (this.#letters >= maxLog) return;
    this.#letters += text.length;
    this.#lines.push({ tick, text });
  }
}
