// SPDX-License-Identifier: MIT
//
// Hands in as a student does, in a browser: the token, the form, the answer, the log-out. Catches a form that says nothing, a
// page that a phone cannot show, text of a team that becomes markup, and a page that a strange site could use. Then looks at legs
// as the staff does.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { copyFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { closeBrowser, folder, openPage, run, serve, sticksOut, violations } from './support.js';

const league = join(folder, 'handing-in');
after(closeBrowser);

async function logIn(page, token) {
  await page.fill('#token', token);
  await page.click('form button');
}

async function handIn(page, path, answer) {
  await page.setInputFiles('#file', path);
  await page.click('#hand-in button');
  await page.waitForFunction((text) => document.getElementById('answer').textContent.includes(text), answer);
}

// What is wrong with the page in both schemes and widths.
async function complaints(page) {
  const found = [];
  const size = page.viewportSize();
  for (const width of [1280, 390]) {
    for (const colorScheme of ['light', 'dark']) {
      await page.setViewportSize({ width, height: 800 });
      await page.emulateMedia({ colorScheme });
      found.push(...await violations(page));
      if (await sticksOut(page)) found.push(`${page.url()} sticks out at ${width} px`);
    }
  }
  await page.setViewportSize(size);
  return found;
}

test('a student hands in and reads the answer', async () => {
  run('league', 'init', league, '--team', 'alpha=house:chaser', '--team', 'beta=house:keeper', '--half', '2');
  const token = run('league', 'token', league, 'alpha').trim();
  const { place } = await serve(league, '--hand-in');
  const good = join(folder, '<img src=x>.so');
  copyFileSync(join(process.env.MIROCUP_BUILD, 'house', 'striker.so'), good);
  const bad = join(folder, 'notes.txt');
  writeFileSync(bad, 'no library');

  const page = await openPage(place);
  await page.click('a[href="hand-in"]');
  await page.waitForSelector('#token');
  assert.deepEqual(await complaints(page), []);
  await logIn(page, 'WRONG');
  await page.waitForSelector('[role=alert]');
  assert.match(await page.textContent('[role=alert]'), /no team has this token/);
  await logIn(page, token);
  assert.equal(await page.textContent('h1'), 'alpha');

  await handIn(page, good, 'alpha: entry 2 was accepted');
  await page.waitForFunction(() => document.querySelector('#entry-2')?.textContent.includes('accepted'));
  assert.ok((await page.textContent('#entry-2')).includes('<img src=x>.so'));
  assert.equal(await page.locator('#entries img').count(), 0);
  await handIn(page, bad, 'entry 2 plays on');
  await page.waitForFunction(() => document.querySelector('#entry-3')?.textContent.includes('refused'));

  assert.deepEqual(await complaints(page), []);
  await page.setViewportSize({ width: 390, height: 800 });

  // What the check has seen of an entry, and its leg.
  await page.click('#entry-2 a');
  await page.waitForSelector('.verdict');
  await page.waitForLoadState();
  assert.match(await page.textContent('main'), /Slowest tick/);
  assert.deepEqual(await complaints(page), []);
  const replay = await page.getAttribute('a[href$=replay]', 'href');
  await page.goto(new URL(replay, place).href);
  await page.waitForSelector('svg');
  await page.goto(`${place}hand-in`);

  await page.click('#entry-1 [data-pin]');
  await page.waitForFunction(() => document.querySelector('#entry-1')?.textContent.includes('pinned'));
  await page.selectOption('#opponent', 'beta');
  await page.click('#friendly button');
  await page.waitForFunction(() => [...document.querySelectorAll('#friendlies tr')]
    .some((row) => row.textContent.includes('beta') && row.querySelector('a[href$=replay]')));

  // The cookie is of no use to a script, and the page loads nothing from elsewhere.
  assert.equal(await page.evaluate(() => document.cookie), '');
  assert.deepEqual(page.problems.filter((text) => !text.includes('401')), []);

  await page.click('form[action$=log-out] button');
  await page.waitForSelector('#token');
  await page.goto(`${place}hand-in`);
  assert.equal(await page.locator('#token').count(), 1);
  assert.equal(await page.locator('text=entry 2').count(), 0);
});

test('the staff sees what both teams drew, a team only what it drew itself', async () => {
  const thinking = join(folder, 'thinking');
  writeFileSync(`${thinking}.json`, JSON.stringify({
    schema: 'mirocup/league/1',
    thoughts: true,
    rules: { half_s: 2 },
    teams: [{ name: 'alpha', entry: 'house:navigator' }, { name: 'beta', entry: 'house:striker' }],
  }));
  run('league', 'init', thinking, '--config', `${thinking}.json`);
  run('league', 'start', thinking);
  const staff = run('league', 'token', thinking, '--staff').trim();
  const own = run('league', 'token', thinking, 'alpha').trim();
  const { place: server } = await serve(thinking, '--hand-in');
  const whose = (page) => page.evaluate(() => {
    const { own = {} } = JSON.parse(document.getElementById('leg').textContent);
    return Object.keys(own).filter((team) => own[team].thoughts).sort();
  });

  const page = await openPage(`${server}hand-in`);
  await logIn(page, staff);
  await page.waitForSelector('a[href="hand-in?team=beta"]');
  assert.deepEqual(await complaints(page), []);
  await page.click('a[href="hand-in?team=beta"]');
  await page.waitForSelector('a[href$=".html?team=beta"]');
  assert.deepEqual(await complaints(page), []);
  const replay = await page.getAttribute('a[href$=".html?team=beta"]', 'href');
  await page.click('a[href$=".html?team=beta"]');
  await page.waitForSelector('svg');
  assert.deepEqual(await whose(page), ['blue', 'yellow']);
  // From the replay to the decision about its leg.
  await page.click('text=Decide about this leg');
  await page.waitForSelector('#rule-fixture');
  assert.match(await page.inputValue('#rule-fixture'), /^r1-f1$/);
  assert.equal(await page.inputValue('#void-leg'), /-(\d)-\d\.html/.exec(replay)[1]);
  assert.ok(await page.locator('#rule-score').isVisible(), 'the form is open');
  await page.goto(new URL(replay, server).href);
  await page.waitForSelector('svg');
  assert.deepEqual(page.problems, []);

  await page.context().clearCookies();
  await page.goto(`${server}hand-in`);
  await logIn(page, own);
  await page.waitForSelector('#entries');
  await page.goto(new URL(replay, server).href);
  await page.waitForSelector('svg');
  assert.equal((await whose(page)).length, 1);
  assert.equal((await page.goto(`${server}hand-in?team=beta`)).url().includes('beta'), true);
  assert.equal(await page.locator('a[href*="team=beta"]').count(), 0);
});
