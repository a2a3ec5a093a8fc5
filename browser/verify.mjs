// SPDX-License-Identifier: MIT
//
// node verify.mjs RECORD [--json] [--module FILE]: what `mirocup verify` does, by the module. Exit code 0 reproduced, 1 differs, 2
// wrong usage, 3 a file cannot be read, 4 damaged. FILE is the module of another version; only its bytes are read. Without it, the
// module is beside this script or in build/browser, or MIROCUP_BROWSER names its folder.
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { setFlagsFromString } from 'node:v8';
import zlib from 'node:zlib';
import { loadMirocup, MirocupError, unpackReplay } from './mirocup.js';

// The quick first compiler of V8 in node 20 makes code of the module's SIMD instructions that crashes.
setFlagsFromString('--no-liftoff');

const here = dirname(fileURLToPath(import.meta.url));
const built = resolve(process.env.MIROCUP_BROWSER ?? (existsSync(join(here, 'mirocup.wasm')) ? here : join(here, '../build/browser')));

function read(path, cure = '') {
  try {
    return readFileSync(path);
  } catch (error) {
    throw new MirocupError({ code: 3, what: `${path}: it cannot be read (${error.code})${cure}` });
  }
}

// npm's fzstd, which the build installs, from no folder but its own; node has a decoder of its own from 22.15 on.
function decompressor() {
  if (zlib.zstdDecompressSync) {
    return (frame, target) => zlib.zstdDecompressSync(frame, { maxOutputLength: Math.max(target.length, 1) });
  }
  try {
    return createRequire(import.meta.url)(join(built, 'node_modules/fzstd')).decompress;
  } catch {
    throw new MirocupError({ code: 3, what: `fzstd is missing; install it: npm install --prefix ${built} fzstd@0.1.1` });
  }
}

// The last key of a record is the digest of the text before it.
function isWhole(mirocup, text) {
  const end = text.lastIndexOf(',\n');
  return end >= 0 && text.slice(end) === `,\n "sha256": "${mirocup.sha256(text.slice(0, end))}"\n}\n`;
}

async function verify(path, module) {
  const mirocup = await loadMirocup(read(module ?? join(built, 'mirocup.wasm'),
    '; install clang-19 lld-19 wasi-libc libc++-19-dev-wasm32 libclang-rt-19-dev-wasm32 and build the target mirocup_browser'));
  const text = read(path).toString('utf8');
  let named = {};
  try {
    named = JSON.parse(text);
  } catch { /* the module says what is wrong with it */ }
  if (!text.includes('"mirocup/match/')) throw new MirocupError({ code: 4, what: `${path}: it is no match record` });
  const file = join(dirname(path), basename(String(named.replay?.file ?? path.replace(/\.json$/, '.replay.zst'))));
  const packed = read(file);
  if (named.replay && mirocup.sha256(packed) !== named.replay.sha256) {
    throw new MirocupError({ code: 4, what: `${file}: it is not the replay that the record was saved with` });
  }
  return mirocup.verify(text, unpackReplay(packed, decompressor(), file), isWhole(mirocup, text), path);
}

let given;
try {
  given = parseArgs({ allowPositionals: true, options: { json: { type: 'boolean' }, module: { type: 'string' } } });
} catch { /* told below */ }
if (given?.positionals.length !== 1) {
  console.error('usage: node verify.mjs RECORD [--json] [--module FILE]');
  process.exit(2);
}
const [path] = given.positionals;
try {
  const found = await verify(path, given.values.module);
  if (given.values.json) console.log(JSON.stringify({ record: path, reproduced: found.reproduced, tick: found.tick, what: found.what }));
  else if (found.reproduced) console.log(`${path}: reproduced, ${found.ticks} ticks, state hash ${found.state_hash}`);
  else console.log(`${path}: differs from tick ${found.tick} on: ${found.what}`);
  process.exitCode = found.reproduced ? 0 : 1;
} catch (error) {
  const isOurs = error instanceof MirocupError;  // the rest is of a module that is none, or of another interface
  console.error(`mirocup: ${isOurs ? error.message : `${path}: the module has failed: ${error.message}`}`);
  process.exitCode = isOurs ? error.code : 4;
}
