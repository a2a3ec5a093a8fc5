// SPDX-License-Identifier: MIT
//
// Uses the published pages of leagues as their readers do, from disk. Catches pages that do not fit a phone, that a screen
// reader or a keyboard cannot use, links that lead nowhere, results without a replay, and replays that the policy of a strict server
// makes black.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { dirname, extname, join, resolve } from 'node:path';
import { closeBrowser, folder, inAllViews, openPage, readJson, run, violations } from './support.js';

const names = ['Lions', 'Rovers', 'a-name-of-forty-letters-that-never-ends_', 'Orbit', 'Comets'];
const title = '<b>Spring</b> & friends';
let league;
let cup;
let nightly;
const houses = ['striker', 'chaser', 'keeper', 'navigator'];

// Plays a night of a class of thirty teams with names as long as they may be.
function playNight() {
  const place = join(folder, 'nightly');
  const teams = Array.from({ length: 30 }, (_, i) => `team${i + 1}`);
  writeFileSync(`${place}.json`, JSON.stringify({
    schema: 'mirocup/league/1',
    title,
    format: { kind: 'nightly', opponents: 1 },
    rules: { half_s: 1 },
    teams: teams.map((team, i) => ({ name: team, entry: `house:${houses[i % 4]}` })),
  }));
  writeFileSync(`${place}.csv`, ['team,display', ...teams.map((team) => `${team},${`The Unstoppable Robots of ${team} ${'w'.repeat(60)}`.slice(0, 60)}`)].join('\n'));
  run('league', 'init', place, '--config', `${place}.json`);
  run('league', 'team', place, '--csv', `${place}.csv`);
  writeFileSync(join(place, 'notice.txt'), 'No night on <b>Friday</b>\n');
  run('league', 'nightly', place);
  return place;
}

// Plays a league of house teams with halves of a second, and publishes it.
function play(name, teams, format, half = 1) {
  const place = join(folder, name);
  writeFileSync(`${place}.json`, JSON.stringify({
    schema: 'mirocup/league/1',
    title,
    format: { kind: format },
    rules: { half_s: half },
    teams: teams.map((team, i) => ({ name: team, entry: `house:${houses[i % 4]}` })),
  }));
  run('league', 'init', place, '--config', `${place}.json`);
  run('league', 'start', place);
  return place;
}

const page = (place, path) => `file://${join(place, 'site', path)}`;

before(() => {
  league = play('spring', names, 'double_round_robin', 6);
  cup = play('cup', names.slice(0, 4), 'knockout');
  run('league', 'rule', league, 'r1-f1', '--leg', '1', '--score', '9:0', '--reason', '<i>glue</i>', '--by', 'H');
  run('league', 'publish', league);
  nightly = playNight();
});
after(closeBrowser);

const kinds = () => [page(league, 'index.html'), page(league, 'crosstable.html'), page(league, 'rounds/r1.html'),
  page(league, `teams/${names[2]}.html`), page(cup, 'index.html'), page(cup, 'rounds/k2.html'),
  page(league, 'replays/r2-f1-1-1.html')];

test('axe finds nothing, and nothing sticks out, at any width and in any scheme', async () => {
  for (const url of kinds()) {
    await inAllViews(url, async (shown, how) => {
      assert.deepEqual(await violations(shown), [], how);
      assert.equal(await shown.evaluate(() => document.documentElement.scrollWidth > innerWidth), false, how);
      assert.deepEqual(shown.problems, [], how);
    });
  }
});

test('every link of every page leads somewhere', async () => {
  const seen = new Set();
  const next = [join(league, 'site', 'index.html'), join(cup, 'site', 'index.html')];
  while (next.length > 0) {
    const file = next.pop();
    if (seen.has(file)) continue;
    seen.add(file);
    const html = readFileSync(file, 'utf8');
    for (const [, target] of html.matchAll(/(?:href|src)="([^"]*)"/g)) {
      const [path, mark] = target.replaceAll('&amp;', '&').split('#');
      const there = path === '' ? file : resolve(dirname(file), path);
      assert.ok(existsSync(there), `${file}: ${target}`);
      if (!there.endsWith('.html')) continue;
      if (mark && !mark.startsWith('t=')) assert.ok(readFileSync(there, 'utf8').includes(`id="${mark}"`), `${file}: ${target}`);
      next.push(there);
    }
  }
  const legs = readJson(join(league, 'site', 'legs.json')).legs.filter((leg) => leg.replay);
  for (const leg of legs) assert.ok(seen.has(join(league, 'site', leg.replay)), leg.replay);
});

test('without scripts the front page tells who leads, the results and the decisions', async () => {
  const shown = await openPage(page(league, 'index.html'), undefined, { javaScriptEnabled: false });
  assert.equal(await shown.locator('h1').textContent(), title);
  const table = readJson(join(league, 'site', 'table.json')).table;
  assert.equal(await shown.locator('#table tbody tr').first().locator('th').textContent(), table[0].team);
  assert.equal(await shown.locator('#table tbody tr .points').first().textContent(), String(table[0].points));
  assert.equal(await shown.locator('.winner').textContent(), table[0].team);
  assert.match(await shown.locator('#decisions').textContent(), /9:0.*<i>glue<\/i>.*by H/s);
  assert.equal(await shown.locator('.filter:visible').count(), 0, 'no dead control');
  await shown.locator('details.round summary').first().click();
  assert.ok(await shown.locator('details.round').first().locator('.scores a').first().isVisible());
  assert.equal(await shown.locator('b, i').count(), 0);
});

test('the filter shows the fixtures of one team, on the front page and on that of a round', async () => {
  for (const path of ['index.html', 'rounds/r1.html']) {
    const shown = await openPage(page(league, path));
    await shown.locator('#filter').selectOption({ label: 'Orbit' });
    const lists = path === 'index.html' ? shown.locator('details.round li:visible') : shown.locator('.fixtures li:visible');
    for (const text of await lists.allTextContents()) assert.match(text, /Orbit/);
    assert.ok(await lists.count() > 0, path);
    await shown.locator('#filter').selectOption('');
    assert.equal(await shown.locator('.fixtures li[hidden]').count(), 0);
  }
});

test('a score leads to its replay, and a tie of the bracket to its legs', async () => {
  const shown = await openPage(page(cup, 'index.html'));
  await shown.locator('.bracket a.leg').first().click();
  assert.match(shown.url(), /replays\/k1-f\d-\d-1\.html$/);
  await shown.goto(page(cup, 'index.html'));
  await shown.locator('.bracket a:not(.leg)').first().click();
  assert.match(shown.url(), /rounds\/k1\.html#k1-f\d$/);
  await shown.locator('.scores a').first().click();
  assert.match(shown.url(), /replays\//);
});

test('from a replay the league, both teams and the next leg are one click away', async () => {
  const shown = await openPage(page(league, 'replays/r2-f1-1-1.html'));
  const links = await shown.locator('nav.path a').evaluateAll((all) => all.map((a) => a.getAttribute('href')));
  const { home, away } = readJson(join(league, 'site', 'legs.json')).legs.find((leg) => leg.fixture === 'r2-f1');
  for (const link of ['../index.html', `../teams/${home}.html`, `../teams/${away}.html`, '../rounds/r2.html#r2-f1', '../replays/r2-f1-2-1.html']) {
    assert.ok(links.includes(link), `${link} in ${links}`);
  }
});

// The policies of faculties' servers, of Jenkins and the like.
test('a replay is right where a server forbids what is not in files, and says so where it forbids scripts', async () => {
  const types = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css' };
  let policy;
  const strict = createServer(({ url }, answer) => {
    answer.writeHead(200, { 'content-type': types[extname(url)] ?? 'text/plain', 'content-security-policy': policy });
    answer.end(readFileSync(join(league, 'site', url)));
  });
  await new Promise((listening) => { strict.listen(0, '127.0.0.1', listening); });
  const url = `http://127.0.0.1:${strict.address().port}/replays/r2-f1-1-1.html`;
  const ground = (shown) => shown.locator('.field .ground').first().evaluate((one) => getComputedStyle(one).fill);
  policy = "default-src 'self'";
  let shown = await openPage(url);
  await shown.click('#play');
  await shown.waitForFunction(() => !document.getElementById('time').textContent.startsWith('tick 0'));
  assert.equal(await shown.locator('#waiting').count(), 0);
  assert.equal(await ground(shown), 'rgb(44, 122, 87)');
  assert.deepEqual(shown.problems, []);
  policy = "sandbox; default-src 'none'; img-src 'self'; style-src 'self';";
  shown = await openPage(url);
  assert.match(await shown.locator('#waiting').innerText(), /forbids scripts/);
  assert.equal(await ground(shown), 'rgb(44, 122, 87)');
  strict.close();
});
