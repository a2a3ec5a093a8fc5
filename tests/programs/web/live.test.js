// SPDX-License-Identifier: MIT
//
// Tests viewers of a running match: joining in the middle, many viewers, and the end of the match.
import assert from 'node:assert/strict';
import http from 'node:http';
import { after, test } from 'node:test';
import { join } from 'node:path';
import { closeBrowser, evil, folder, openPage, readJson, watched } from './support.js';

after(closeBrowser);

// Resolves when a frame of the match at `place` has at least that tick; rejects if the match ends before.
function tickReached(place, tick) {
  return new Promise((resolve, reject) => {
    http.get(`${place}events`, (response) => {
      let text = '';
      response.on('data', (part) => {
        text += part;
        const ticks = [...text.matchAll(/^data: \{"tick":(\d+)/gm)].map((found) => Number(found[1]));
        if (Math.max(...ticks) < tick) return;
        resolve();
        response.destroy();
      });
      response.on('error', () => {});
      response.on('end', () => reject(new Error(`the match ended before tick ${tick}`)));
    }).on('error', reject);
  });
}

test('a viewer who joins in the middle sees the match to its end, beside fifty who do not read', async () => {
  const record = join(folder, 'watched.json');
  const page = await openPage('about:blank');  // a browser may take longer to start than the leg lasts
  const { url, ended } = watched('--half', '6', '--seed', '2', '--record', record);
  const place = await url;
  assert.match(place, /^http:\/\/127\.0\.0\.1:/, 'this host only');
  // These viewers connect and never read a byte.
  const idle = Array.from({ length: 50 }, () => {
    const request = http.get(`${place}events`, (response) => response.pause());
    request.on('error', () => {});
    return request;
  });
  await tickReached(place, 21);

  await page.goto(place);
  const tick = () => page.evaluate(() => Number(/tick (\d+)|$/.exec(document.getElementById('time').textContent)[1] ?? 0));
  await page.waitForFunction(() => /tick/.test(document.getElementById('time').textContent));
  const first = await tick();
  assert.ok(first > 20, `joined in the middle, at tick ${first}`);
  await page.waitForFunction((from) => Number(/tick (\d+)/.exec(document.getElementById('time').textContent)[1]) > from, first);
  assert.equal(await page.locator('.side.blue .name').textContent(), evil);
  assert.equal(await page.locator('img').count(), 0);
  await page.waitForFunction(() => document.body.classList.contains('ended'));
  assert.equal(await ended, 0, 'the match ends as if nobody had watched');
  const leg = readJson(record);
  await page.waitForFunction((score) => document.getElementById('score').textContent === score,
    `${leg.result.score.blue} : ${leg.result.score.yellow}`);
  assert.equal(await page.locator('#calls li').count(), leg.decisions.length, 'calls from before it joined, too');
  idle.forEach((request) => request.destroy());
});

test('there is a page and its events, nothing else, and nothing to change', async () => {
  const { url, child } = watched('--half', '20');
  const { port } = new URL(await url);
  const status = (method, path) => new Promise((resolve, reject) => {
    http.request({ port, host: '127.0.0.1', method, path }, (response) => {
      response.destroy();
      resolve(response.statusCode);
    }).on('error', reject).end();
  });
  assert.equal(await status('GET', '/'), 200);
  for (const path of ['/../../etc/passwd', '/%2e%2e/%2e%2e/etc/passwd', '//etc/passwd', '/leg.json', '/events/x']) {
    assert.equal(await status('GET', path), 404, path);
  }
  for (const method of ['POST', 'PUT', 'DELETE']) assert.notEqual(await status(method, '/'), 200, method);
  child.kill('SIGTERM');
});
