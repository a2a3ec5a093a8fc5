// SPDX-License-Identifier: MIT
//
// The module for browsers plays bit for bit what the programs play: golden legs, a hundred scenes, sixteen records over all
// leagues, rules, conditions and pitches, in node and in Chromium. Catches a compiler that contracts or reorders, a stack that is
// too small, a file that is read in another way than `mirocup verify` reads it, and a changed byte that is not found.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { after, test } from 'node:test';
import { closeSync, copyFileSync, mkdtempSync, openSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { setFlagsFromString } from 'node:v8';
import { WASI } from 'node:wasi';
import { loadMirocup, packReplay, unpackReplay } from '../../../browser/mirocup.js';
import { closeBrowser, openPage } from '../web/support.js';

setFlagsFromString('--no-liftoff');  // as in browser/verify.mjs
const root = fileURLToPath(new URL('../../..', import.meta.url));
const build = process.env.MIROCUP_BUILD;
const { decompress } = createRequire(join(build, 'browser', 'x'))('fzstd');
const folder = mkdtempSync(join(tmpdir(), 'mirocup-browser-'));
after(async () => {
  await closeBrowser();
  rmSync(folder, { recursive: true });
});
const mirocup = await loadMirocup(readFileSync(join(build, 'browser/mirocup.wasm')));
const digest = (bytes) => createHash('sha256').update(bytes).digest('hex');

// What a program for WASI prints.
async function printed(name, ...args) {
  const out = join(folder, 'out');
  const stdout = openSync(out, 'w');
  const wasi = new WASI({ version: 'preview1', args: [name, ...args], returnOnExit: true, stdout });
  const { instance } = await WebAssembly.instantiate(readFileSync(join(build, `browser/${name}.wasm`)), {
    wasi_snapshot_preview1: wasi.wasiImport,
  });
  assert.equal(wasi.start(instance), 0);
  closeSync(stdout);
  return readFileSync(out, 'utf8').trim();
}

// As `mirocup verify` and its twin answer: {status, text}.
function answers(path) {
  return [[join(build, 'mirocup'), 'verify', path], [process.execPath, join(root, 'browser/verify.mjs'), path]].map(([program, ...args]) => {
    const { status, stdout, stderr } = spawnSync(program, args, {
      encoding: 'utf8', env: { ...process.env, MIROCUP_BROWSER: join(build, 'browser') },
    });
    return { status, text: (stdout + stderr).trim() };
  });
}

function expectSame(path, status) {
  const [program, module] = answers(path);
  assert.equal(program.status, status, program.text);
  assert.deepEqual(module, program);
}

const golden = readFileSync(join(root, 'core/golden_hash.txt'), 'utf8').trim().split('\n').map((line) => line.split(' '));
const scenes = execFileSync(join(build, 'compilers_scenes'), { encoding: 'utf8' }).trim();

test('golden legs and a hundred scenes have their hashes', async () => {
  for (const [hash, what] of golden) assert.equal(await printed('golden_leg', what), hash, what);
  assert.equal(await printed('scenes'), scenes);
});

test('sixteen records are reproduced', () => {
  execFileSync(join(root, 'tests/build/compilers/sixteen_legs.sh'), [build, folder]);
  const records = readdirSync(folder).filter((name) => name.endsWith('.json'));
  assert.equal(records.length, 16);
  for (const name of records) expectSame(join(folder, name), 0);
});

// To be run in a page: what the programs print, a little system being enough for them, and what is found in the records.
async function inPage({ script, wasm, programs, records }) {
  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const compiled = {};
  async function printedHere(name, ...args) {
    compiled[name] ??= await WebAssembly.compile(bytes(wasm[name]));
    let [exports, text] = [null, ''];
    const view = () => new DataView(exports.memory.buffer);
    const words = [name, ...args].map((word) => `${word}\0`);
    const system = {
      args_sizes_get(count, size) {
        view().setUint32(count, words.length, true);
        view().setUint32(size, words.join('').length, true);
        return 0;
      },
      args_get(places, at) {
        words.forEach((word, i) => {
          view().setUint32(places + 4 * i, at, true);
          for (const c of word) view().setUint8(at++, c.charCodeAt(0));
        });
        return 0;
      },
      fd_write(file, parts, count, written) {
        let size = 0;
        for (let i = 0; i < count; ++i) {
          const part = [view().getUint32(parts + 8 * i, true), view().getUint32(parts + 8 * i + 4, true)];
          text += new TextDecoder().decode(new Uint8Array(exports.memory.buffer, ...part));
          size += part[1];
        }
        view().setUint32(written, size, true);
        return 0;
      },
      proc_exit() { throw new Error('ended'); },
    };
    const imports = {};
    for (const { module, name: what } of WebAssembly.Module.imports(compiled[name])) (imports[module] ??= {})[what] = system[what] ?? (() => 0);
    ({ exports } = await WebAssembly.instantiate(compiled[name], imports));
    try {
      exports._start();
    } catch (error) {
      if (error.message !== 'ended') throw error;
    }
    return text.trim();
  }
  const { loadMirocup: load } = await import(URL.createObjectURL(new Blob([script], { type: 'text/javascript' })));
  const here = await load(bytes(wasm.mirocup));
  const found = { printed: [], records: records.map(({ record, replay }) => here.verify(record, bytes(replay))) };
  for (const words of programs) found.printed.push(await printedHere(...words));
  return found;
}

test('Chromium finds the same golden legs, scenes and records', async () => {
  const names = readdirSync(folder).filter((name) => name.endsWith('.json'));
  const base64 = (data) => Buffer.from(data).toString('base64');
  const wasm = Object.fromEntries(['mirocup', 'golden_leg', 'scenes'].map((name) =>
    [name, base64(readFileSync(join(build, `browser/${name}.wasm`)))]));
  const records = names.map((name) => ({
    record: readFileSync(join(folder, name), 'utf8'),
    replay: base64(unpackReplay(readFileSync(join(folder, name.replace('.json', '.replay.zst'))), decompress)),
  }));
  const page = await openPage('about:blank');
  const found = await page.evaluate(inPage, {
    script: readFileSync(join(root, 'browser/mirocup.js'), 'utf8'), wasm, records,
    programs: [...golden.map(([, what]) => ['golden_leg', what]), ['scenes']],
  });
  assert.deepEqual(found.printed, [...golden.map(([hash]) => hash), scenes]);
  assert.equal(found.records.length, 16);
  found.records.forEach((one, i) => {
    assert.equal(one.reproduced, true, names[i]);
    assert.equal(one.found, JSON.parse(records[i].record).state_hash, names[i]);
  });
});

test('what was changed is told as mirocup verify tells it', () => {
  const path = join(folder, 'small-mirosot.json');
  const packed = readFileSync(path.replace('.json', '.replay.zst'));
  const text = readFileSync(path, 'utf8');
  const write = (name, record, replay) => {
    const body = record.slice(0, record.lastIndexOf(',\n')).replace(digest(packed), digest(replay));
    writeFileSync(join(folder, `${name}.json`), `${body},\n "sha256": "${digest(body)}"\n}\n`);
    writeFileSync(join(folder, 'small-mirosot.replay.zst'), replay);
    return join(folder, `${name}.json`);
  };
  const plain = unpackReplay(packed, decompress);
  const changed = plain.slice();
  changed[16 + 2 * 300] ^= 4;  // a wheel of blue's robot 0 in tick 300, and with it those after
  const path_ = write('changed', text, packReplay(changed));
  expectSame(path_, 1);
  assert.match(answers(path_)[1].text, /differs from tick 30[0-9] on: the state differs/);
  assert.equal(mirocup.verify(text, changed).reproduced, false);
  writeFileSync(path.replace('.json', '.replay.zst'), packed);

  expectSame(write('lied', text.replace(/"state_hash": "./, '"state_hash": "z'), packed), 4);
  expectSame(write('moved', text.replace(/"seed": 1/, '"seed": 2'), packed), 1);
  writeFileSync(join(folder, 'cut.json'), text.replace('"isolation"', '"isolatiom"'));
  expectSame(join(folder, 'cut.json'), 4);
  writeFileSync(join(folder, 'other.json'), '{}');
  expectSame(join(folder, 'other.json'), 4);
  const half = packed.subarray(0, packed.length / 2);
  copyFileSync(path, join(folder, 'half.json'));
  expectSame(write('half', text, half), 4);
  assert.equal(answers(join(folder, 'missing.json'))[1].status, 3);
});

test('a leg that is driven by hand is a record that mirocup verify reproduces', () => {
  const leg = mirocup.leg({ seed: 3, rules: { preset: 'mirosot', half_s: 5 }, teams: { blue: '', yellow: 'striker' } });
  for (let tick = 0; tick < 200; ++tick) {
    leg.drive('blue', 1, 20 + tick / 10, 20 - tick / 20);
    leg.play(1);
  }
  const { record, replay } = leg.save('driven');
  writeFileSync(join(folder, 'driven.json'), record);
  writeFileSync(join(folder, 'driven.replay.zst'), replay);
  expectSame(join(folder, 'driven.json'), 0);
  assert.equal(JSON.parse(record).state_hash, leg.hash);
  leg.free();
});

test('a leg goes on from a record, and from its own situation', () => {
  const text = readFileSync(join(folder, 'small-camera.json'), 'utf8');
  const plain = unpackReplay(readFileSync(join(folder, 'small-camera.replay.zst')), decompress);
  const same = mirocup.goOn(text, plain, 100, { blue: 'recorded', yellow: 'recorded' });
  same.play(1e6);
  assert.equal(same.hash, JSON.parse(text).state_hash);
  const other = mirocup.goOn(text, plain, 100, { blue: 'keeper', yellow: 'recorded' });
  other.play(50);
  const again = mirocup.leg({ situation: JSON.parse(other.situation()), conditions: 'exact', teams: { blue: 'keeper', yellow: '' } });
  assert.deepEqual(again.bodies(), other.bodies());
  assert.throws(() => mirocup.goOn(text, plain, 1e6, {}), /the leg is over by then/);
  assert.throws(() => mirocup.leg({ league: 'huge' }), /\/league: one of small, middle, large is expected/);
});

test('a drill that is tried in the module has its marks', () => {
  const drill = readFileSync(join(root, 'plugins/drills/touch-the-ball.json'), 'utf8');
  const leg = mirocup.leg({ drill, seed: 5, teams: { blue: 'chaser' } });
  leg.play(1e5);
  const { drill: result, over } = leg.status();
  assert.equal(over, true);
  assert.equal(result.passed, true, JSON.stringify(result));
});

test('digests are those of FIPS 180-4', () => {
  for (const length of [0, 1, 55, 56, 63, 64, 65, 1000]) {
    const bytes = new Uint8Array(length).fill(length);
    assert.equal(mirocup.sha256(bytes), digest(bytes), `${length} bytes`);
  }
});

test('house teams decide in the module as in a program', () => {
  const pairs = [['striker', 'chaser'], ['tactician', 'navigator'], ['keeper', 'striker'], ['tactician', 'striker'], ['navigator', 'chaser'],
    ['planner', 'striker']];
  let legs = 0;
  const others = [];
  for (const [i, [blue, yellow]] of pairs.entries()) {
    for (const league of ['small', 'middle', 'large']) {
      if (blue === 'planner' && league !== 'small') continue;  // it takes long
      const seed = 100 + 3 * i + legs;
      const half = blue === 'planner' ? 2 : league === 'large' ? 3 : 10;
      const record = join(folder, `house-${seed}.json`);
      execFileSync(join(build, 'mirocup'), ['match', '--blue', blue, '--yellow', yellow, '--league', league, '--seed', String(seed),
        '--half', String(half), '--record', record, '--trusted']);
      const leg = mirocup.leg({ league, seed, rules: { preset: 'mirosot', half_s: half }, teams: { blue, yellow } });
      leg.play(1e6);
      if (leg.hash !== JSON.parse(readFileSync(record, 'utf8')).state_hash) others.push(`${blue} ${yellow} ${league} ${seed}`);
      leg.free();
      ++legs;
    }
  }
  assert.deepEqual(others, [], `of ${legs} legs`);
});
