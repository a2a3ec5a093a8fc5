// SPDX-License-Identifier: MIT
//
// Runs a show of a round to its end as a projector would, with a remote. Catches a page that tells a result before its
// turn, a bracket that is not that of the legs shown so far, a remote that anybody may use, and a show that stops by itself.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { after, before, test } from 'node:test';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { closeBrowser, folder, inAllViews, mirocup, openPage, readJson, run, violations } from './support.js';

const league = join(folder, 'shown');
let projector;
let remote;
const servers = [];

before(async () => {
  writeFileSync(`${league}.json`, JSON.stringify({
    schema: 'mirocup/league/1',
    title: 'Show <b>night</b>',
    seed: 26,  // a leg of the first round has a goal
    format: { kind: 'knockout' },
    rules: { half_s: 4 },
    teams: ['striker', 'chaser', 'keeper', 'navigator'].map((house, i) => ({ name: `t${i}`, entry: `house:${house}` })),
  }));
  run('league', 'init', league, '--config', `${league}.json`);
  run('league', 'start', league);
  [projector, remote] = await show('--round', 'k2');
});
after(() => {
  for (const server of servers) server.kill('SIGTERM');
  return closeBrowser();
});

// Starts a show. Returns the addresses of the projector and of the remote.
async function show(...options) {
  const server = spawn(mirocup, ['league', 'show', league, ...options]);
  servers.push(server);
  const text = await new Promise((resolve) => {
    let all = '';
    server.stdout.on('data', (part) => {
      all += part;
      if (all.split('\n').length > 2) resolve(all);
    });
  });
  return text.trim().split('\n');
}

const json = async (path) => (await fetch(new URL(path, projector))).json();

const post = (body) => fetch(new URL('/control', projector), { method: 'POST', body });

test('only the address with the key controls the show', async () => {
  assert.equal((await post('x toggle')).status, 403);
  assert.equal((await post(`${new URL(remote).hash.slice(1)} format`)).status, 403);
  for (const path of ['/league.json', '/legs/99.json', '/legs/-1.json', '/legs/0', '/after/99.html', '/page/main.js', '/../journal.jsonl']) {
    assert.equal((await fetch(new URL(path, projector))).status, 404, path);
  }
});

// Catches a final before the third place, a bracket that tells too much, a show that ends without a champion, and a clock that the
// last row cannot read.
test('the last round is shown to its end, and nothing is told beforehand', async () => {
  const { legs } = await json('/programme.json');
  const final = legs.findIndex(({ where }) => !/third/i.test(where));
  assert.ok(final >= 2 && legs.slice(final).every(({ where }) => !/third/i.test(where)), 'the final comes last');
  const page = await openPage(`${projector}?speed=16`, { width: 1920, height: 1080 }, { reducedMotion: 'reduce' });
  const winners = () => page.locator('#standing .bracket text.won:not(.goals)').count();
  await page.waitForFunction(() => document.getElementById('tempo').textContent.startsWith('held'));
  await page.locator('#standing .bracket').waitFor({ state: 'attached' });
  assert.equal(await winners(), 2, 'the semi-finals');
  assert.equal(await page.locator('b').count(), 0);

  const hand = await openPage(remote, { width: 390, height: 844 });
  const skip = () => hand.locator('button', { hasText: 'Skip' }).click();
  await hand.locator('button', { hasText: 'Start' }).click();
  for (let number = 1; number <= legs.length; number += 1) {
    await page.locator('#heading', { hasText: `leg ${number} of ${legs.length}` }).waitFor();
    assert.equal(await page.locator('#leg').isVisible(), false, 'no score before the leg');
    assert.equal(await page.locator('#champion').textContent(), '');
    await skip();  // the announcement
    await page.locator('#leg').waitFor();
    if (number === 1) {
      await page.keyboard.press(' ');  // holds it
      const seen = await page.evaluate(() => {
        for (const over of document.querySelectorAll('.over')) over.classList.remove('over');  // a fast leg may have ended
        const context = document.createElement('canvas').getContext('2d');
        const heights = ['.score', '.when'].map((part) => {
          const { fontWeight, fontSize, fontFamily } = getComputedStyle(document.querySelector(part));
          context.font = `${fontWeight} ${fontSize} ${fontFamily}`;
          return context.measureText('0').actualBoundingBoxAscent;
        });
        return { heights, bottom: document.querySelector('figure').getBoundingClientRect().bottom };
      });
      for (const height of seen.heights) assert.ok(height >= 0.04 * 1080, `digits of ${height} px`);
      assert.ok(seen.bottom <= 1080, 'all of it is on the projector');
      await page.keyboard.press(' ');
    } else {
      await skip();  // the leg
    }
    if (!legs[number - 1].has_standing) continue;
    await page.locator('#standing .bracket').waitFor();
    assert.equal(await page.locator('#standing table').count(), 0, 'points are nothing in a knockout');
    assert.equal(await winners(), number <= final ? 3 : 4, `the bracket after leg ${number}`);
    await skip();  // the bracket
  }
  await page.waitForFunction(() => document.body.classList.contains('over'));
  assert.match(await page.locator('#title').textContent(), /is over/);
  const champion = readJson(join(league, 'site', 'table.json')).table[0].team;
  assert.equal((await page.locator('#champion .pair').innerText()).trim(), champion);
  assert.deepEqual(page.problems, []);
});

test('axe finds nothing on the show and its remote', async () => {
  for (const url of [projector, remote]) {
    await inAllViews(url, async (page, how) => {
      assert.deepEqual(await violations(page), [], how);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > innerWidth), false, how);
    });
  }
});
