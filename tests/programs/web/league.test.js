// SPDX-License-Identifier: MIT
//
// Tests `mirocup league serve`: viewers of a league while it is played, and files that the server must not give out.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import http from 'node:http';
import { after, test } from 'node:test';
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { closeBrowser, folder, mirocup, openPage, readJson, run, serve } from './support.js';

const title = '<img src=x onerror="document.title=\'written by a host\'">';

// A league of three teams. `half`: length of a half, s.
function make(name, half, house) {
  const place = join(folder, name);
  writeFileSync(`${place}.json`, JSON.stringify({
    schema: 'mirocup/league/1',
    title,
    rules: { half_s: half, mercy_goal_diff: 0 },
    teams: ['alpha', 'beta', 'gamma'].map((team, i) => ({ name: team, entry: `house:${house[i]}` })),
  }));
  run('league', 'init', place, '--config', `${place}.json`);
  return place;
}

after(closeBrowser);

// Sends the path unchanged, without the normalisation of a URL.
function get(place, path, method = 'GET') {
  return new Promise((resolve, reject) => {
    http.request({ port: new URL(place).port, host: '127.0.0.1', method, path }, (response) => {
      let text = '';
      response.on('data', (part) => { text += part; });
      response.on('end', () => resolve({ status: response.statusCode, headers: response.headers, text }));
    }).on('error', reject).end();
  });
}

test('a page that is open follows the league, and a leg can be watched while it is played', async () => {
  const league = make('long', 36000, ['chaser', 'chaser', 'chaser']);  // too long to end before a slow browser finds it
  const { place } = await serve(league);
  assert.match(place, /^http:\/\/127\.0\.0\.1:/, 'this host only');
  const page = await openPage(place);
  const playing = spawn(mirocup, ['league', 'start', league, '--watch', '--jobs', '1'], { stdio: 'ignore' });
  const ended = new Promise((resolve) => { playing.on('exit', resolve); });
  const [name, address] = await page.locator('#playing a').evaluate((a) => [a.textContent, a.href]);
  assert.match(name, /^\w+ – \w+$/);
  const live = await openPage(address);
  const tick = () => live.evaluate(() => Number(/tick (\d+)|$/.exec(document.getElementById('time').textContent)[1] ?? 0));
  await live.waitForFunction(() => /tick [1-9]/.test(document.getElementById('time').textContent));
  const first = await tick();
  await live.waitForFunction((from) => Number(/tick (\d+)/.exec(document.getElementById('time').textContent)[1]) > from, first);
  assert.deepEqual(live.problems, []);
  if (process.env.MIROCUP_PICTURES) {
    await page.screenshot({ path: join(process.env.MIROCUP_PICTURES, 'league.png') });
    await live.screenshot({ path: join(process.env.MIROCUP_PICTURES, 'leg.png') });
  }
  run('league', 'stop', league, '--now');
  assert.equal(await ended, 130);

  run('league', 'award', league, 'r1-f1', 'beta', '--leg', '1', '--reason', '<b>glue</b>');
  await page.waitForFunction(() => document.body.textContent.includes('1 of 6 legs played'));
  await page.waitForFunction(() => document.getElementById('playing') === null);
  assert.equal(await page.locator('h1').textContent(), title);
  assert.equal(await page.locator('img, b').count(), 0);
  assert.deepEqual(page.problems, []);
});

test('what is served is what is published, and nothing else', async () => {
  const league = make('short', 1, ['striker', 'chaser', 'keeper']);
  run('league', 'start', league);
  const { place } = await serve(league);
  const leg = readJson(join(league, 'site', 'legs.json')).legs[0];
  const replay = readFileSync(join(league, 'site', leg.replay), 'utf8');
  rmSync(join(league, 'site', 'replays'), { recursive: true });  // the server makes pages that were not published
  assert.equal((await get(place, `/${leg.replay}`)).text, replay);
  const script = /<script type="module" src="(\.\.\/)*league.js"><\/script>\n/;
  for (const path of ['index.html', 'teams/alpha.html', 'rounds/r1.html', 'style.css', 'site.js', 'table.json', 'legs.csv']) {
    const { status, text } = await get(place, `/${path}`);
    assert.equal(status, 200, path);
    assert.equal(text.replace(script, ''), readFileSync(join(league, 'site', path), 'utf8'), path);
  }
  const over = await get(place, '/live/r1-f1-1-1/');
  assert.equal(over.status, 302, 'the address of a leg that is over leads to its replay');
  assert.equal(over.headers.location, '../../replays/r1-f1-1-1.html');
  assert.equal(JSON.parse((await get(place, `/${leg.record}`)).text).state_hash, leg.state_hash);
  assert.match((await get(place, '/')).headers['content-security-policy'], /default-src 'none'/);
  for (const path of ['/league.json', '/journal.jsonl', '/../short.json', '/%2e%2e/short.json', '/records/../league.json',
    '/records/%2e%2e/journal.jsonl', '/records/', `/records/../${leg.record}`, `/${leg.record}.out`, '//etc/passwd', '/etc/passwd',
    '/entries/alpha/1/strategy.so', '/live/../', '/live/%2e%2e/', '/live/r9-f1-1-1/', '/live/x/events', '/records/x%00.json']) {
    assert.equal((await get(place, path)).status, 404, path);
  }
  for (const method of ['POST', 'PUT', 'DELETE', 'PATCH']) assert.notEqual((await get(place, '/', method)).status, 200, method);
});
