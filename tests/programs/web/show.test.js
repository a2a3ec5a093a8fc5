// SPDX-License-Identifier: MIT
//
// Runs a show of a round to its end as a projector would, with a remote. Catches a page that tells a result before its
// turn, a table that is not that of the legs shown so far, a remote that anybody may use, and a show that stops by itself.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { after, before, test } from 'node:test';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { closeBrowser, folder, inAllViews, mirocup, openPage, readJson, run, violations } from './support.js';

const league = join(folder, 'shown');
let projector;
let remote;
let server;

before(async () => {
  writeFileSync(`${league}.json`, JSON.stringify({
    schema: 'mirocup/league/1',
    title: 'Show <b>night</b>',
    format: { kind: 'knockout' },
    rules: { half_s: 4 },
    teams: ['striker', 'chaser', 'keeper', 'navigator'].map((house, i) => ({ name: `t${i}`, entry: `house:${house}` })),
  }));
  run('league', 'init', league, '--config', `${league}.json`);
  run('league', 'start', league);
  server = spawn(mirocup, ['league', 'show', league, '--round', 'k1']);
  const text = await new Promise((resolve) => {
    let all = '';
    server.stdout.on('data', (part) => {
      all += part;
      if (all.split('\n').length > 2) resolve(all);
    });
  });
  [projector, remote] = text.trim().split('\n');
});
after(() => {
  server.kill('SIGTERM');
  return closeBrowser();
});

const post = (body) => fetch(new URL('/control', projector), { method: 'POST', body });

test('only the address with the key controls the show', async () => {
  assert.equal((await post('x toggle')).status, 403);
  assert.equal((await post(`${new URL(remote).hash.slice(1)} format`)).status, 403);
  for (const path of ['/league.json', '/legs/99.json', '/legs/-1.json', '/legs/0', '/after/99.html', '/page/main.js', '/../journal.jsonl']) {
    assert.equal((await fetch(new URL(path, projector))).status, 404, path);
  }
});

test('a round is shown to its end, and nothing is told beforehand', async () => {
  const legs = readJson(join(league, 'site', 'legs.json')).legs.filter((leg) => leg.fixture.startsWith('k1'));
  const page = await openPage(`${projector}?speed=16`, undefined, { reducedMotion: 'reduce' });
  await page.locator('#standing tr[data-name]').first().waitFor({ state: 'attached' });
  const table = () => page.locator('#standing tr[data-name]').evaluateAll((rows) => rows.map((row) => row.dataset));
  for (const row of await table()) assert.equal(row.points, '0', 'the table before the round');
  assert.equal(await page.locator('b').count(), 0);
  await page.waitForFunction(() => document.getElementById('tempo').textContent.startsWith('held'));

  const hand = await openPage(remote, { width: 390, height: 844 });
  await hand.locator('button', { hasText: 'Start' }).click();
  for (let number = 1; number <= legs.length; number += 1) {
    await page.locator('#heading', { hasText: `leg ${number} of ${legs.length}` }).waitFor();
    assert.equal(await page.locator('#leg').isVisible(), false, 'no score before the leg');
    await hand.locator('button', { hasText: 'Skip' }).click();  // the announcement
    await page.locator('#leg').waitFor();
    if (number > 1) await hand.locator('button', { hasText: 'Skip' }).click();  // the leg
    await page.locator('#standing').waitFor();
    const points = (await table()).reduce((sum, row) => sum + Number(row.points), 0);
    const expected = legs.slice(0, number).reduce((sum, { score }) => sum + (score.home === score.away ? 2 : 3), 0);
    assert.equal(points, expected, `the table after leg ${number}`);
    if (number < legs.length) await hand.locator('button', { hasText: 'Skip' }).click();  // the table
  }
  await page.waitForFunction(() => document.body.classList.contains('over'));
  assert.match(await page.locator('#title').textContent(), /is over/);
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
