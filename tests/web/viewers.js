// SPDX-License-Identifier: MIT
//
// Do viewers make a match late? A team logs how late it is asked in every tick, in one match without viewers and in one
// with fifty who read all. Prints both; a judgement is the reader's, since it depends on the machine.
// Usage: node tests/web/viewers.js BUILD [SECONDS]; where others need the processor, too: chrt -r 1 node ...
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import http from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const [, , build, seconds = '20'] = process.argv;
const folder = mkdtempSync(join(tmpdir(), 'mirocup-viewers-'));
process.on('exit', () => rmSync(folder, { recursive: true }));

async function lateness(viewers) {
  const record = join(folder, `${viewers}.json`);
  const child = spawn(join(build, 'mirocup'), ['match', '--blue', join(build, 'teams/punctual.so'), '--yellow', 'chaser',
    '--half', String(Number(seconds) / 2), '--watch', '--record', record]);
  let watched = 0;
  let bytes = 0;
  child.stderr.on('data', (text) => {
    const url = /http:\S+/.exec(text);
    if (!url) return;
    for (let i = 0; i < viewers; i += 1) {
      http.get(`${url[0]}events`, (response) => {
        watched += 1;
        response.on('data', (part) => { bytes += part.length; });
        response.on('error', () => {});
      }).on('error', () => {});
    }
  });
  await new Promise((resolve) => { child.on('exit', resolve); });
  const late = [...readFileSync(`${record}.blue.log`, 'utf8').matchAll(/late (-?\d+) us/g)]
    .map((found) => Number(found[1])).sort((a, b) => a - b);
  // Against the most punctual tick: the first one is slow, for it is the first.
  const at = (share) => late[Math.floor(share * (late.length - 1))] - late[0];
  const { budget } = JSON.parse(readFileSync(record, 'utf8'));
  console.log(`${watched} viewers, ${(bytes / 1e6).toFixed(1)} MB: ${late.length} ticks, late by ${at(0.5)} us (median), `
    + `${at(0.99)} us (99 %), ${at(1)} us (most); answers too late: ${budget.blue.late_ticks}, ${budget.yellow.late_ticks}`);
}

await lateness(0);
await lateness(50);
