// SPDX-License-Identifier: MIT
//
// The playground and "Play on" in a replay page, opened from disk under their own policies. Catches a saved leg that
// `mirocup verify` does not reproduce, keys and mouse that drive nothing, a step back that goes elsewhere, a moved body that is
// not there, and parts that cannot be read or reached.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { closeBrowser, folder, inAllViews, match, openPage, readJson, run, sticksOut, violations } from './support.js';

after(closeBrowser);

const isBuilt = existsSync(join(process.env.MIROCUP_BUILD, 'browser/mirocup.wasm'));
const options = { skip: isBuilt ? false : 'the module for browsers was not built' };
const place = join(folder, 'playground');
if (isBuilt) run('playground', '-o', place);
const address = `file://${place}/index.html`;

const tickOf = async (page) => Number(/tick ([0-9]+)/.exec(await page.textContent('#hand_time'))[1]);
const untilTick = (page, tick) => page.waitForFunction((least) =>
  Number(/tick ([0-9]+)/.exec(document.querySelector('#hand_time').textContent)?.[1] ?? -1) >= least, tick);
const poses = (page) => page.$$eval('.field .robot, .field .ball', (all) => all.filter((one) => one.getBoundingClientRect().width > 0)
  .map((one) => one.getAttribute('transform')));

async function begin(page, values = {}) {
  await page.waitForSelector('#hand_time:has-text("tick 0")');
  for (const [id, value] of Object.entries(values)) await (id === 'half' || id === 'seed' ? page.fill(`#${id}`, value) : page.selectOption(`#${id}`, value));
  await page.click('#options .button');
  await page.waitForFunction(() => !document.querySelector('#hand_told').textContent);
}

// Presses a button that offers files, and returns them.
async function saved(page) {
  await page.click('#hand_record');
  await page.waitForFunction(() => /in two files/.test(document.querySelector('#hand_told').textContent));
  const files = {};
  for (const link of await page.locator('#hand_files a').all()) {
    const [download] = await Promise.all([page.waitForEvent('download'), link.click()]);
    files[download.suggestedFilename()] = join(folder, download.suggestedFilename());
    await download.saveAs(files[download.suggestedFilename()]);
  }
  return files;
}

async function savedJson(page, button) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(button)]);
  return readJson(await download.path());
}

test('a leg that is driven by script against striker is reproduced by mirocup verify', options, async () => {
  const page = await openPage(address);
  await begin(page, { hand_yellow: 'striker', half: '20', seed: '3' });
  await page.keyboard.press('1');
  assert.equal(await page.$eval('#hand_body', (one) => one.selectedOptions[0].textContent), 'blue 1');
  await page.keyboard.press('+');
  await page.keyboard.press('+');  // 4 ×
  await page.keyboard.press(' ');
  for (const key of ['ArrowUp', 'ArrowLeft', 'ArrowUp', 'ArrowRight', 'ArrowDown']) {
    const tick = await tickOf(page);
    await page.keyboard.down(key);
    await untilTick(page, tick + 20);
    await page.keyboard.up(key);
  }
  await page.keyboard.press(' ');
  const files = await saved(page);
  const ticks = await tickOf(page);
  const record = Object.keys(files).find((name) => name.endsWith('.json'));
  assert.match(run('verify', files[record]), /reproduced/);
  const { teams, ticks: played } = readJson(files[record]);
  assert.equal(teams.blue.name, 'striker and by hand');
  assert.equal(teams.yellow.name, 'striker');
  assert.equal(played, ticks);
  await page.keyboard.press('.');  // the leg goes on
  await untilTick(page, ticks + 1);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('keys drive, a step back is exact, and the keyboard alone is enough', options, async () => {
  const page = await openPage(address);
  await begin(page, { hand_blue: '', hand_yellow: 'tactician', conditions: 'exact' });
  await page.focus('#hand_play');
  await page.keyboard.press('0');
  await page.keyboard.down('w');
  const seen = [];
  for (let tick = 1; tick <= 45; ++tick) {
    await page.keyboard.press('.');
    await untilTick(page, tick);
    seen.push(await poses(page));
  }
  assert.notDeepEqual(seen[44][0], seen[10][0]);  // it drove
  assert.deepEqual(seen[44][1], seen[0][1]);  // its mate stood
  for (let tick = 44; tick >= 35; --tick) {
    await page.keyboard.press(',');
    await page.waitForFunction((text) => document.querySelector('#hand_time').textContent.endsWith(text), `tick ${tick}`);
    assert.deepEqual(await poses(page), seen[tick - 1], `tick ${tick}`);
  }
  for (let tick = 36; tick <= 45; ++tick) await page.keyboard.press('.');
  await untilTick(page, 45);
  assert.deepEqual(await poses(page), seen[44]);
  await page.keyboard.up('w');
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('bodies are moved by mouse and keys, and a situation and a drill are saved', options, async () => {
  const page = await openPage(address);
  await begin(page, { conditions: 'exact' });
  const box = async (selector) => page.locator(`#pitch_small ${selector}`).first().boundingBox();
  const ball = await box('.ball');
  await page.mouse.move(ball.x + ball.width / 2, ball.y + ball.height / 2);
  await page.mouse.down();
  await page.mouse.move(ball.x + 100, ball.y + 60, { steps: 4 });
  await page.mouse.up();
  await page.waitForFunction(() => document.querySelector('#phase').textContent === 'First half');
  const start = await savedJson(page, '#hand_situation');
  const { ball: moved, restart } = start;
  assert.ok(moved.position[0] > 0.1 && moved.position[1] < -0.05, JSON.stringify(moved));
  assert.equal(restart, null);

  await page.focus('#hand_play');
  await page.keyboard.press('2');
  await page.keyboard.press('Shift+ArrowUp');
  await page.keyboard.press('q');
  await page.keyboard.press('.');
  await page.keyboard.press(',');
  const { blue } = await savedJson(page, '#hand_situation');
  assert.ok(Math.abs(blue[2].pose[1] - start.blue[2].pose[1] - 0.02) < 0.001, JSON.stringify([start.blue[2], blue[2]]));
  assert.notDeepEqual(blue[2].pose[2], start.blue[2].pose[2]);
  assert.deepEqual(blue[1].pose, start.blue[1].pose);
  await page.keyboard.press(',');  // at the first tick after a move, the move itself is taken back
  const { blue: unturned } = await savedJson(page, '#hand_situation');
  assert.deepEqual(unturned[2].pose[2], start.blue[2].pose[2]);
  await page.selectOption('#hand_event', 'touch');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#hand_drill')]);
  const drill = join(folder, 'drill.json');
  await download.saveAs(drill);
  assert.match(run('drill', drill, 'striker', '--tries', '2'), /drill/);
  await page.setInputFiles('#file', drill);
  await page.waitForFunction(() => /Drill under way/.test(document.querySelector('#hand_told').textContent));
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('everything can be read and reached, at 1280 and 390 px', options, async () => {
  await inAllViews(address, async (page, how) => {
    await page.waitForSelector('#hand_time:has-text("tick")');
    await page.check('#hand_thoughts');
    await page.check('#hand_contacts');
    await page.check('#zones');
    await page.keyboard.press('.');
    assert.deepEqual(await violations(page), [], how);
    assert.equal(await sticksOut(page), false, how);
    assert.deepEqual(page.problems, []);
  });
  const html = readFileSync(join(place, 'index.html'), 'utf8');
  const policy = /Content-Security-Policy" content="([^"]*)"/.exec(html)[1].replaceAll('&#39;', "'");
  assert.match(policy, /^default-src 'none'; style-src 'unsafe-inline'; connect-src 'self'; script-src 'sha256-[^']+' 'wasm-unsafe-eval'; worker-src blob:$/);
});

test('a replay is played on in its page, and what comes of it is reproduced', options, async () => {
  const record = join(folder, 'before.json');
  const html = join(folder, 'before.html');
  run(...match('--record', record, '--half', '10', '--seed', '4'));
  run('replay', record, '-o', html);
  for (const width of [1280, 390]) {
    const page = await openPage(`file://${html}#t=5`, { width, height: 800 });
    await page.keyboard.press('p');
    await page.waitForSelector('#hand_time:has-text("tick 151")');
    assert.match(await page.textContent('#command'), /--from before.json --tick 151/);
    await page.selectOption('#hand_yellow', 'keeper');
    await page.focus('#hand_play');
    await page.keyboard.press('1');
    await page.keyboard.down('ArrowUp');
    for (let i = 0; i < 30; ++i) await page.keyboard.press('.');
    await untilTick(page, 181);
    await page.keyboard.up('ArrowUp');
    const files = await saved(page);
    const path = Object.values(files).find((name) => name.endsWith('.json'));
    assert.match(run('verify', path), /reproduced/);
    assert.equal(readJson(path).from.tick, 151);
    assert.deepEqual(await violations(page), []);
    assert.equal(await sticksOut(page), false);
    await page.keyboard.press('p');
    assert.match(await page.textContent('#time'), /tick 151/);
    assert.deepEqual(page.problems, []);
    await page.close();
  }
});
