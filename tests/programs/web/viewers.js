// SPDX-License-Identifier: MIT
//
// Measures whether viewers delay a match. Matches without viewers and with fifty viewers that read everything take turns,
// at four times real time, so that there are enough ticks for a quantile of 99.9 %. Prints the lateness of their ticks from
// their records. It does not judge the numbers, since they depend on the machine. The teams play in the process of the
// match, so that only viewers are measured. The viewers run at idle priority, because real viewers use other computers.
// Usage: node tests/programs/web/viewers.js BUILD [SECONDS of a match [ROUNDS]]
import { fork, spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const FACTOR = 4;
const AUDIENCE = 50;

// Runs in a child process, which reports the amount that it has read.
function view(url) {
  let viewers = 0;
  let bytes = 0;
  for (let i = 0; i < AUDIENCE; i += 1) {
    http.get(`${url}events`, (response) => {
      viewers += 1;
      response.on('data', (part) => { bytes += part.length; });
      response.on('error', () => {});
    }).on('error', () => {});
  }
  process.on('beforeExit', () => { if (process.connected) process.send({ viewers, bytes }, () => process.disconnect()); });
}

async function match(build, folder, seconds, isWatched) {
  const record = join(folder, 'leg.json');
  const server = spawn(join(build, 'mirocup'), ['match', '--blue', 'keeper', '--yellow', 'keeper', '--trusted', '--speed',
    String(FACTOR), '--half', String(FACTOR * seconds / 2), '--watch', '--record', record], { stdio: ['ignore', 'ignore', 'pipe'] });
  let seen = Promise.resolve({ viewers: 0, bytes: 0 });
  server.stderr.on('data', (text) => {
    const url = /http:\S+/.exec(text);
    if (!url || !isWatched) return;
    const audience = fork(fileURLToPath(import.meta.url), ['view', url[0]],
      { execPath: 'chrt', execArgv: ['--idle', '0', process.execPath] });
    seen = new Promise((resolve) => { audience.on('message', resolve); });
  });
  await new Promise((resolve) => { server.on('exit', resolve); });
  const { viewers, bytes } = await seen;
  const { pace: { lateness }, ticks } = JSON.parse(readFileSync(record, 'utf8'));
  return { viewers, bytes, ticks, lateness };
}

const us = (time) => `${(1e6 * time).toFixed(0)} us`;
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

function report(name, matches) {
  const at = (share) => us(median(matches.map((one) => one.lateness[share])));
  const sum = (what) => matches.reduce((all, one) => all + one[what], 0);
  console.log(`${name}: ${matches.map((one) => one.viewers).join(', ')} viewers, ${(sum('bytes') / 1e6).toFixed(1)} MB, `
    + `${sum('ticks')} ticks, medians of the rounds: 50 % late by ${at('p50')}, 99 % ${at('p99')}, 99.9 % ${at('p999')}, longest `
    + `${at('longest')}; 99.9 % of each: ${matches.map((one) => us(one.lateness.p999)).join(', ')}`);
}

async function measure(build, seconds = '60', rounds = '3') {
  const folder = mkdtempSync(join(os.tmpdir(), 'mirocup-viewers-'));
  process.on('exit', () => rmSync(folder, { recursive: true }));
  const alone = [];
  const watched = [];
  for (let i = 0; i < Number(rounds); i += 1) {
    alone.push(await match(build, folder, Number(seconds), false));
    watched.push(await match(build, folder, Number(seconds), true));
  }
  report('without viewers', alone);
  report('with viewers', watched);
}

const [first, ...more] = process.argv.slice(2);
if (first === 'view') view(...more);
else await measure(first, ...more);
