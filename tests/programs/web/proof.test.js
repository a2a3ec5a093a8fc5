// SPDX-License-Identifier: MIT
//
// "Prove it" in a replay page, opened from disk under its own policy. Catches a module that plays something else in a browser, a
// policy that stops it, a changed command that is not found, a public page that shows how a team drives, a page of a league whose
// files are not where it looks for them, from disk or from a server, and files that stay when their pages are gone.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { existsSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { deflateSync, inflateSync } from 'node:zlib';
import { closeBrowser, folder, match, openPage, readJson, run, serve, sticksOut, violations } from './support.js';

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

// Changes a wheel of blue's robot 0 from that tick on, in a file with a leg's commands.
function changeWheel(file, tick) {
  writeFileSync(file, readFileSync(file, 'utf8').replace(/("replay":")([^"]+)"/, (all, key, packed) => {
    const plain = inflateSync(Buffer.from(packed, 'base64'));
    plain[16 + 2 * tick] ^= 8;
    return `${key}${deflateSync(plain).toString('base64')}"`;
  }));
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
    assert.equal(await sticksOut(page), false);
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
  changeWheel(path, 100);
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

function playLeague(name, more = {}) {
  const place = join(folder, name);
  writeFileSync(`${place}.json`, JSON.stringify({
    schema: 'mirocup/league/1', rules: { half_s: 3 }, ...more,
    teams: ['striker', 'chaser'].map((team) => ({ name: `the-${team}`, entry: `house:${team}` })),
  }));
  run('league', 'init', place, '--config', `${place}.json`);
  run('league', 'start', place);
  return place;
}

const names = (place) => (existsSync(place) ? readdirSync(place).sort() : []);
const legs = ['r1-f1-1-1', 'r1-f1-2-1'];

test('pages of a league are proved by files beside them, from disk and from a server', options, async () => {
  const place = playLeague('proofs');
  const site = join(place, 'site');
  assert.deepEqual(names(join(site, 'replays')), legs.flatMap((leg) => [`${leg}.html`, `${leg}.league.json`, `${leg}.proof.js`]));
  const modules = names(join(site, 'module'));
  assert.equal(modules.length, 3);
  const wasm = /module\/([0-9a-f]{16}\.js)"/.exec(/"module_file":"[^"]*"/.exec(readFileSync(join(site, `replays/${legs[0]}.html`), 'utf8'))[0])[1];
  const html = statSync(join(site, `replays/${legs[0]}.html`)).size;
  const commands = statSync(join(site, `replays/${legs[0]}.proof.js`)).size;
  console.log(`page ${html} B, its commands ${commands} B, the module ${statSync(join(site, 'module', wasm)).size} B`);
  assert.ok(html < 300_000, `${html}`);
  const hash = readJson(join(place, `records/${legs[1]}.json`)).state_hash;
  const expectProof = async (url) => {
    for (const width of [1280, 390]) {
      const page = await openPage(url, { width, height: 800 });
      assert.match(await prove(page), new RegExp(`Reproduced.*found here: ${hash}`), url);
      assert.deepEqual(page.problems, [], url);
      assert.deepEqual(await violations(page), []);
      await page.close();
    }
  };
  await expectProof(`file://${site}/replays/${legs[1]}.html`);
  let host = await serve(place);
  await expectProof(`${host.place}replays/${legs[1]}.html`);
  host.server.kill();
  const before = readFileSync(join(site, `replays/${legs[0]}.html`));
  rmSync(site, { recursive: true });
  host = await serve(place);  // nothing is on disk: pages, commands and module are made when they are asked for
  await expectProof(`${host.place}replays/${legs[1]}.html`);
  const missing = await fetch(`${host.place}module/0123456789abcdef.js`);
  assert.equal(missing.status, 404);
  host.server.kill();
  run('league', 'publish', place);
  assert.deepEqual(readFileSync(join(site, `replays/${legs[0]}.html`)), before);
  assert.deepEqual(names(join(site, 'module')), modules);

  // A command that was changed is found, and a file that is away is told.
  const file = join(site, `replays/${legs[1]}.proof.js`);
  changeWheel(file, 50);
  let page = await openPage(`file://${site}/replays/${legs[1]}.html`);
  assert.match(await prove(page), /Differs from tick 5[0-9] on/);
  await page.close();
  rmSync(file);
  page = await openPage(`file://${site}/replays/${legs[1]}.html`);
  assert.match(await prove(page), /cannot be proved here: the file r1-f1-2-1.proof.js is not beside this page/);
  await page.close();

  // Files go with their pages: a leg that is void keeps its page as evidence, and a module that no page names is removed.
  for (const end of ['js', 'css']) writeFileSync(join(site, `module/feedfeedfeedfeed.${end}`), '');
  writeFileSync(join(site, 'replays/r9-f1-1-1.proof.js'), '');
  run('league', 'publish', place);
  assert.deepEqual(names(join(site, 'module')), modules);
  assert.equal(existsSync(join(site, 'replays/r9-f1-1-1.proof.js')), false);
});

test('a host who says no has pages without a proof', options, async () => {
  const place = playLeague('private', { proofs: false });
  assert.deepEqual(names(join(place, 'site/replays')), legs.flatMap((leg) => [`${leg}.html`, `${leg}.league.json`]));
  assert.equal(names(join(place, 'site/module')).length, 2, 'script and style of the pages');
  const host = await serve(place);
  assert.equal((await fetch(`${host.place}replays/${legs[0]}.proof.js`)).status, 404);
  assert.equal((await (await fetch(`${host.place}replays/${legs[0]}.html`)).text()).includes('id="prove"'), false);
});
