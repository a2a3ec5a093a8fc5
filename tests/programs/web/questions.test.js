// SPDX-License-Identifier: MIT
//
// Ten questions that people ask about a league, each answered from its front page by at most two clicks. Catches an answer that
// has moved further away, or is gone.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { after, before, test } from 'node:test';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { closeBrowser, folder, mirocup, openPage, run } from './support.js';

const league = join(folder, 'questions');
let server;
let front;
let page;

before(async () => {
  writeFileSync(`${league}.json`, JSON.stringify({
    schema: 'mirocup/league/1',
    title: 'Class',
    thoughts: true,
    format: { kind: 'round_robin' },
    rules: { half_s: 90 },  // long enough for calls in every leg
    teams: ['striker', 'chaser', 'tactician', 'navigator'].map((house) => ({ name: `the-${house}`, entry: `house:${house}` })),
  }));
  run('league', 'init', league, '--config', `${league}.json`);
  run('league', 'start', league);
  run('league', 'void', league, 'r3-f1', '--leg', '2', '--reason', 'the last one is played on Friday');
  server = spawn(mirocup, ['league', 'serve', league, '--hand-in']);
  front = String(await new Promise((resolve) => { server.stdout.once('data', resolve); })).trim();
  page = await openPage(front);
});
after(() => {
  server.kill('SIGTERM');
  return closeBrowser();
});

// Starts at the front page, clicks what is named, and returns the text of the answer.
async function answer(clicks, where) {
  assert.ok(clicks.length <= 2);
  await page.goto(front);
  for (const target of clicks) {
    await page.locator(target).first().click();
    await page.waitForLoadState();
  }
  return (await page.locator(where).first().innerText()).replace(/\s+/g, ' ');
}

const first = '#table tbody tr th a';
const last = '#table tbody tr:last-child th a';
const leg = '#worth li a';

test('who is best, and how sure is that', async () => {
  assert.match(await answer([], '#table tbody tr'), /^1 the-\w+ .*[0-9]+ \(-?[0-9]+ … -?[0-9]+\)/);
});

test('why did we lose, and where do we lose the ball', async () => {
  const text = await answer([last], '#statistics');
  assert.match(text, /It lost the ball [0-9]+ times: [0-9]+ in its own third/);
  assert.match(text, /How goals fell against it .*kick off/);
  assert.match(await answer([first], '#statistics'), /It lost the ball/);
});

test('who scored, and what was that whistle', async () => {
  assert.match(await answer([leg], '#calls .goal'), /Goal for the-\w+, [0-9]+ : [0-9]+ – .*the-\w+ [0-9]/);
  assert.match(await answer([leg], '#calls'), /(Kick off|Goal kick|Free ball|Free kick|Penalty kick) for the-\w+/);
});

test('which keeper is best', async () => {
  assert.match(await answer([], '#bests'), /Best goalkeeper [0-9]+ % the-\w+ saved [0-9]+ of [0-9]+ shots on goal/);
});

test('which leg should I watch', async () => {
  assert.match(await answer([], '#worth li'), /[0-9]+:[0-9]+ the-\w+ – the-\w+ Round/);
});

test('what did robot 2 want there', async () => {
  const token = run('league', 'token', league, 'the-tactician').trim();
  await page.goto(new URL('/hand-in', front).href);
  await page.fill('#token', token);
  await page.click('form button');
  const own = await answer(['a[href="/hand-in"]', 'a[href^="/hand-in/replays/"]'], '#own');
  assert.match(own, /Thoughts of the-tactician Layers of the thoughts .*roles/);
  assert.equal(await page.locator('#own h2').count(), 1, 'those of the other team are not here');
  const replay = page.url();
  // Nor are they for a stranger.
  const stranger = await openPage(replay);
  assert.equal(await stranger.locator('#own').count(), 0);
  await stranger.close();
});

test('how do I send this goal to a friend', async () => {
  await answer([leg, '#calls .goal button'], '#link');
  // On a busy machine the address may still be that of the first moment.
  await page.waitForFunction(() => Number(/^#t=([0-9.]+)$/.exec(location.hash)?.[1]) > 0);
  const friend = await openPage(page.url());
  await friend.waitForFunction(() => /Goal for/.test(document.getElementById('banner').textContent));
  await friend.close();
  assert.equal(await page.locator('#clip').isVisible(), true);
});

test('what happens next', async () => {
  assert.match(await answer([], 'section[aria-labelledby=next]'), /Round 3 next .*the-\w+/);
});
