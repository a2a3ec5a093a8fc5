// SPDX-License-Identifier: MIT
//
// "Prove it" in a replay page, opened from disk under its own policy. Catches a module that plays something else in a browser, a
// policy that stops it, a changed command that is not found, and a public page that shows how a team drives.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { existsSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync, gzipSync } from 'node:zlib';
import { closeBrowser, folder, match, openPage, readJson, run, violations } from './support.js';

after(closeBrowser);

const isBuilt = existsSync(join(process.env.MIROCUP_BUILD, 'browser/mirocup.wasm'));
const options = { skip: isBuilt ? false : 'the module for browsers was not built' };
const record = join(folder, 'proved.json');
run(...match('--record', record, '--half', '5', '--seed', '4'));

// Presses the button and returns what is told.
async function prove(page) {
  await page.click('#prove');
  await page.waitForFunction(() => document.querySelector('#proof_found .good, #proof_found .bad'));
  return page.textContent('#proof_found');
}

test('a page proves its leg, and a page without a proof is smaller', options, async () => {
  const path = join(folder, 'proved.html');
  run('replay', record, '-o', path);
  for (const width of [1280, 390]) {
    const page = await openPage(`file://${path}`, { width, height: 800 });
    const told = await prove(page);
    const { ticks, state_hash: hash } = readJson(record);
    assert.match(told, new RegExp(`Reproduced: all ${ticks} ticks.*found here: ${hash}.*of the record: ${hash}`));
    assert.deepEqual(page.problems, []);
    assert.deepEqual(await violations(page), []);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false);
    await page.close();
  }
  const bare = join(folder, 'bare.html');
  run('replay', record, '-o', bare, '--no-proof');
  assert.ok(statSync(bare).size < statSync(path).size - 300_000);
  assert.equal(readFileSync(bare, 'utf8').includes('wasm-unsafe-eval'), false);
});

test('a changed command is found with its tick', options, async () => {
  const path = join(folder, 'changed.html');
  run('replay', record, '-o', path);
  const html = readFileSync(path, 'utf8').replace(/("replay":")([^"]+)"/, (all, key, packed) => {
    const plain = gunzipSync(Buffer.from(packed, 'base64'));
    plain[16 + 2 * 100] ^= 8;  // a wheel of blue's robot 0 from tick 100 on
    return `${key}${gzipSync(plain).toString('base64')}"`;
  });
  writeFileSync(path, html);
  const page = await openPage(`file://${path}`);
  assert.match(await prove(page), /Differs from tick 10[0-9] on: the state differs/);
  await page.click('#proof_found button');
  assert.match(await page.textContent('#time'), /tick 10[0-9]/);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('a page for the public has no commands of a team', options, async () => {
  const path = join(folder, 'public.html');
  run('replay', record, '-o', path, '--public');
  const page = await openPage(`file://${path}`);
  assert.equal(await page.locator('#prove').count(), 0);
  assert.equal(readFileSync(path, 'utf8').includes('wasm-unsafe-eval'), false);
  assert.deepEqual(page.problems, []);
  await page.close();
});
