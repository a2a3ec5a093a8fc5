// SPDX-License-Identifier: MIT
//
// Uses the replay page as its readers do, from disk.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { closeBrowser, evil, folder, inAllViews, match, openPage, readJson, run, sticksOut, violations } from './support.js';

const record = join(folder, 'leg.json');
const address = `file://${join(folder, 'leg.html')}`;
let leg;
let goal;

before(() => {
  for (let seed = 3; !goal; ++seed) {  // most legs of 80 s have a goal
    assert.ok(seed < 20, 'no leg has a goal');
    run(...match('--half', '40', '--seed', String(seed), '--record', record));
    leg = readJson(record);
    goal = leg.decisions.find((call) => call.decision === 'GOAL');
  }
  run('replay', record, '-o', join(folder, 'leg.html'));
});
after(closeBrowser);

const seconds = (tick) => (tick * leg.control_period).toFixed(3);
const text = (page, id) => page.locator(`#${id}`).textContent();

test('a link to the second of a goal shows it, and the score after it', async () => {
  const page = await openPage(`${address}#t=${seconds(goal.tick - 0.99)}`);
  assert.equal(await text(page, 'score'), '0 : 0');
  await page.keyboard.press('.');
  assert.match(await text(page, 'banner'), /^Goal/);
  const score = goal.team === 'blue' ? '1 : 0' : '0 : 1';
  assert.equal(await text(page, 'score'), score);
  await page.keyboard.press('.');  // the robots were lifted to their places
  const speeds = [];
  for (let robot = 0; robot < 6; ++robot) {
    await page.selectOption('#inspected', String(robot));
    speeds.push(/Speed\s*(–|-?[\d.]+)/.exec(await text(page, 'inspector'))[1]);
  }
  assert.ok(speeds.includes('–') && speeds.every((speed) => speed === '–' || Math.abs(speed) < 4), speeds.join(' '));
  await page.keyboard.press('End');
  const { blue, yellow } = leg.result.score;
  assert.equal(await text(page, 'score'), `${blue} : ${yellow}`);
  assert.deepEqual(page.problems, []);
});

test('bodies stand where a picture of the moment has them', async () => {
  const page = await openPage(address);
  for (const tick of [0, 7, 200, 333]) {
    await page.goto(`${address}#t=${seconds(tick + 0.01)}`);
    const file = join(folder, 'moment.svg');
    run('replay', record, '--at', seconds(tick - 0.01 > 0 ? tick - 0.01 : 0), '--svg', '-o', file);
    const places = (source) => [...source.matchAll(/class="(?:robot \w+|ball"[^>]*)"?[^>]*translate\((\S+) (\S+)\)/g)]
      .map((found) => [Number(found[1]), Number(found[2])]);
    const still = places(readFileSync(file, 'utf8'));
    const shown = places(await page.locator('.field').evaluate((svg) => svg.outerHTML));
    assert.equal(shown.length, 7);
    assert.equal(still.length, 7);
    shown.forEach(([x, y], i) => {
      assert.ok(Math.hypot(x - still[i][0], y - still[i][1]) < 1.5, `tick ${tick}, body ${i}: ${x} ${y}, not ${still[i]}`);
    });
  }
});

test('keys, buttons and the time line move the time', async () => {
  const page = await openPage(`${address}#t=5`);
  const tick = async () => Number(/tick (\d+)/.exec(await text(page, 'time'))[1]);
  const at = await tick();
  await page.keyboard.press('.');
  assert.equal(await tick(), at + 1);
  await page.keyboard.press(',');
  assert.equal(await tick(), at);
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs((await tick()) - at - 1 / leg.control_period) <= 1);
  await page.keyboard.press('Home');
  assert.equal(await tick(), 0);
  await page.keyboard.press(']');
  assert.equal(await tick(), leg.decisions.find((call) => call.tick > 0).tick);
  await page.locator('#scrub').fill('400');
  assert.equal(await tick(), 400);
  await page.locator('#calls button', { hasText: /Goal(?! kick)/ }).first().click();
  assert.equal(await tick(), goal.tick);
  await page.keyboard.press('Home');
  await page.locator('body').click({ position: { x: 2, y: 2 } });
  await page.keyboard.press(' ');
  await page.waitForFunction(() => Number(/tick (\d+)/.exec(document.getElementById('time').textContent)[1]) > 3);
  assert.equal(await page.locator('#play').getAttribute('aria-label'), 'Pause');
  assert.deepEqual(page.problems, []);
});

// Catches a saved situation that is refused, is that of another tick, or has the wrong score, and a
// command for another moment.
test('a moment is played on from, by a command or by a saved situation', async () => {
  for (const tick of [0, goal.tick - 20, goal.tick + 3, goal.tick + 60]) {
    const page = await openPage(`${address}#t=${seconds(tick + 0.01)}`);
    await page.locator('#play-on').click();
    assert.match(await text(page, 'command'), new RegExp(`^mirocup match --from leg\\.json --tick ${tick} `));
    if (await page.locator('#hand').count() > 0) {  // the page plays on, too, and goes back
      await page.waitForSelector('#play-on[aria-pressed=true]');
      await page.locator('#play-on').click();
      await page.waitForSelector('#play-on[aria-pressed=false]');
    }
    const [saved] = await Promise.all([page.waitForEvent('download'), page.locator('#save').click()]);
    const file = join(folder, `situation-${tick}.json`);
    await saved.saveAs(file);
    const again = join(folder, 'again.json');
    run('match', '--blue', 'idle', '--yellow', 'idle', '--half', '40', '--start', file, '--record', again);
    const { situation } = readJson(again);
    const [blue, yellow] = (await text(page, 'score')).split(' : ').map(Number);
    assert.deepEqual(situation.score, [blue, yellow]);
    assert.equal(situation.restart !== null, tick === 0 || tick === goal.tick + 3, `tick ${tick}`);
    const ball = /translate\((\S+) (\S+)\)/.exec(await page.locator('.ball').first().evaluate((ball) => ball.outerHTML));
    assert.ok(Math.hypot(situation.ball.position[0] * 1e3 - ball[1], situation.ball.position[1] * 1e3 + Number(ball[2])) < 1);
    assert.deepEqual(page.problems, []);
    await page.close();
  }
});

// Catches a page whose numbers differ from what the command prints.
test('the statistics are those of mirocup stats', async () => {
  const { teams, play_s } = JSON.parse(run('stats', record, '--json')).legs[0];
  const page = await openPage(address);
  const rows = await page.locator('#statistics tr').evaluateAll((all) => all
    .map((row) => [...row.cells].map((cell) => cell.textContent))
    .filter((cells) => cells.length === 3));
  const shown = Object.fromEntries(rows.map(([blue, label, yellow]) => [label, [blue, yellow]]));
  const expected = { Shots: 'shots', 'Shots on goal': 'shots_on_goal', Saves: 'saves', Goals: 'goals', Passes: 'passes',
    Interceptions: 'interceptions', 'Ball lost': 'losses', 'Duels won': 'duels_won', Fouls: 'fouls' };
  for (const [label, key] of Object.entries(expected)) {
    assert.deepEqual(shown[label], [String(teams.blue[key]), String(teams.yellow[key])], label);
  }
  assert.equal(shown.Possession[0], `${Math.round(100 * teams.blue.possession)} %`);
  assert.equal(shown.Territory[1], `${Math.round(100 * teams.yellow.territory)} %`);
  assert.match(await page.locator('#statistics caption').textContent(), new RegExp(`^${play_s.toFixed(0)} s of play`));
  const kinds = Object.values(teams.blue.goals_by_kind).reduce((sum, goals) => sum + goals);
  assert.equal(kinds, leg.result.played.blue);
  assert.deepEqual(page.problems, []);
});

test('the name of a team stays text', async () => {
  const page = await openPage(address);
  assert.equal(await page.locator('.side.blue .name').textContent(), evil);
  assert.equal(await page.locator('img').count(), 0);
  assert.equal(await page.title(), `${evil} – chaser`);
  await page.keyboard.press('End');
  assert.deepEqual(page.problems, []);
});

const shownTick = async (page) => Number(/tick (\d+)/.exec(await text(page, 'time'))[1]);

test('layers are off until they are switched on, by click and by key', async () => {
  const page = await openPage(`${address}#t=10`);
  const drawn = (selector) => page.locator(selector).evaluateAll((all) => all.filter((one) => one.getAttribute('d') && one.style.display !== 'none').length);
  for (const [key, box, shapes, most] of [['t', '#trails', '.robot_trail', 6], ['v', '#velocities', '.velocity', 7], ['z', '#zones', '.zone', 2]]) {
    assert.equal(await drawn(shapes), 0);
    await page.keyboard.press(key);
    assert.ok(await page.locator(box).isChecked());
    const count = await drawn(shapes);
    assert.ok(count > 0 && count <= most, `${shapes}: ${count}`);
    await page.locator(box).click();
    assert.equal(await drawn(shapes), 0);
  }
  assert.deepEqual(page.problems, []);
});

test('each name stands at the end that its team defends', async () => {
  const page = await openPage(address);
  for (const where of ['Home', 'End']) {
    await page.keyboard.press(where);
    const left = await page.locator('.end.left').evaluate((end) => [end.classList.contains('blue'), end.textContent]);
    const goal = await page.locator('.goal.left').getAttribute('class');
    assert.equal(left[0], goal.includes('blue'));
    assert.equal(left[1], left[0] ? evil : 'chaser');
  }
});

test('a click on the curve of momentum goes to that moment', async () => {
  const page = await openPage(address);
  await page.locator('#momentum svg').click();  // in its middle
  assert.ok(Math.abs(await shownTick(page) - leg.ticks / 2) < leg.ticks / 50);
});

test('the page saves the last seconds as a video', async () => {
  const page = await openPage(`${address}#t=8`);
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator('#clip').click()]);
  assert.equal(download.suggestedFilename(), 'clip-2-8.webm');
  const bytes = readFileSync(await download.path());
  assert.equal(bytes.readUInt32BE(0), 0x1a45dfa3, 'a WebM file');
  assert.ok(bytes.length > 1_000);  // a busy machine records few pictures
  assert.deepEqual(page.problems, []);
});

test('mirocup replay --clip writes a video, and says what is wrong with a span', () => {
  const gif = join(folder, 'goal.gif');
  run('replay', record, '--clip', '3:3.4', '-o', gif);
  assert.equal(readFileSync(gif).subarray(0, 4).toString(), 'GIF8');
  assert.ok(statSync(gif).size > 5_000);
  for (const span of ['4:3', '4', 'a:b', '0:61', '-1:3']) {
    assert.throws(() => run('replay', record, `--clip=${span}`, '-o', gif), ({ status, stderr }) => status === 2 && /--clip/.test(stderr), span);
  }
});

test('without scripts the page tells the result and the calls', async () => {
  const page = await openPage(address, undefined, { javaScriptEnabled: false });
  assert.equal(await text(page, 'score'), `${leg.result.score.blue} : ${leg.result.score.yellow}`);
  assert.equal(await page.locator('#calls li').count(), leg.decisions.length);
  assert.equal(await page.locator('#calls .goal').count(), leg.decisions.filter((call) => call.decision === 'GOAL').length);
  assert.equal(await page.locator('.controls').first().isVisible(), false, 'no dead buttons');
  assert.equal(await page.locator('img').count(), 0);
});

// Catches numbers of another robot or tick, of the other frame, wheels that are not those of the record, lines of another tick,
// and a kept tick that changes.
test('a click on a robot shows its numbers, its wheels and what its team printed', async () => {
  const printed = join(folder, 'printed.py');
  writeFileSync(printed, `from mirocup.team import Team

class Printer(Team):
    name = "printer"

    def decide(self, now):
        if now.tick % 10 == 0:
            print("tick is", now.tick)
        return [(10.0, 20.0), (0.0, 0.0), (0.0, 0.0)]
`);
  const own = join(folder, 'printed.json');
  run('match', '--blue', 'striker', '--yellow', printed, '--half', '5', '--seed', '1', '--record', own);
  const log = readFileSync(`${own}.yellow.log`, 'utf8').trim().split('\n');
  assert.ok(log.length > 10 && log.every((line) => /^tick (\d+): tick is \1$/.test(line)), log.slice(0, 3).join());
  run('replay', own, '-o', join(folder, 'printed.html'), '--no-proof');
  const page = await openPage(`file://${folder}/printed.html#t=${(100.01 * readJson(own).control_period).toFixed(3)}`);
  await page.waitForFunction(() => document.getElementById('time').textContent === 'tick 100');
  const box = await page.locator('.robot.yellow').first().boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await page.waitForFunction(() => /Wheels asked/.test(document.getElementById('inspector').textContent));
  const numbers = () => page.$$eval('.numbers tr', (rows) => Object.fromEntries(rows.map((row) => [...row.cells].map((cell) => cell.textContent)).map(([name, ...rest]) => [name, rest])));
  const shown = await numbers();
  assert.deepEqual(shown['Wheels asked'], ['10.0  20.0 rad/s']);
  assert.deepEqual(shown[''], ['tick 100']);
  const [left, right] = shown['Wheels driven'][0].split(/[^-\d.]+/).map(Number);
  assert.ok(Math.abs(left - 10) < 4 && Math.abs(right - 20) < 4, shown['Wheels driven'][0]);
  assert.match(await page.textContent('#inspector caption'), /\(yellow\), as its team sees the field/);
  const place = /translate\((\S+) (\S+)\)/.exec(await page.locator('.robot.yellow').first().getAttribute('transform')).slice(1).map(Number);
  const [x, y] = shown['x, y'][0].split('  ').map(parseFloat);
  const sign = (await page.locator('.end.left').getAttribute('class')).includes('yellow') ? 1 : -1;
  assert.ok(Math.hypot(sign * place[0] / 1000 - x, -sign * place[1] / 1000 - y) < 0.002, `${place} ${x} ${y}`);
  assert.match(await page.textContent('.said_then'), /Tick 100, printed: tick is 100/);
  await page.keyboard.press('x');
  for (let i = 0; i < 5; ++i) await page.keyboard.press('.');
  const both = await numbers();
  assert.deepEqual(both[''], ['tick 100', 'tick 105']);
  assert.equal(both['x, y'][0], shown['x, y'][0]);
  await page.locator('.own.yellow summary').click();
  for (let i = 0; i < 5; ++i) await page.keyboard.press('.');
  assert.equal(await page.textContent('.log .now'), '110 tick is 110');
  assert.deepEqual(await violations(page), []);
  await page.keyboard.press('n');  // the last robot of yellow is not this one
  assert.match(await page.textContent('#inspector caption'), / 1 \(yellow\)/);
  await page.locator('#play-on').click();
  assert.match(await page.textContent('#command'), /--yellow YELLOW_FILE --watch {2}# YELLOW_FILE: the file of /);
  assert.deepEqual(page.problems, []);
  await page.close();
  const open = join(folder, 'open.html');
  run('replay', own, '-o', open, '--public');
  const others = await openPage(`file://${open}`);
  await others.selectOption('#inspected', '3');
  assert.match(await others.textContent('#inspector'), /Heading/);
  assert.equal((await others.textContent('#inspector')).includes('Wheels'), false, 'commands are not for the public');
  await others.close();
});

test('the page of the coach has each goal beside a future without it', async () => {
  const file = join(folder, 'goals.html');
  run('coach', record, '--team', goal.team === 'blue' ? 'yellow' : 'blue', '--goal', '1', '--blue', 'striker', '-o', file);
  const page = await openPage(`file://${file}`);
  const place = async (film) => /\((\S+) /.exec(await page.locator(`.${film} .ball`).getAttribute('transform'))[1];
  const [{ marks }] = JSON.parse(await page.locator('#goals').textContent());
  assert.equal(await place('played'), await place('other'), 'until the substitute decides');
  await page.locator('.scrub').fill(String(marks.goal));
  assert.match(await page.locator('.time').textContent(), /^0.00 s/);
  assert.notEqual(await place('played'), await place('other'));
  await page.click('.play');
  await page.locator('.play', { hasText: 'Play' }).waitFor();  // to the end
  assert.deepEqual(page.problems, []);
  await inAllViews(`file://${file}`, async (view, how) => {
    assert.deepEqual(await violations(view), [], how);
    assert.equal(await sticksOut(view), false, how);
  });
});

test('axe finds nothing, and the keyboard reaches every control', async () => {
  await inAllViews(address, async (page, how) => {
    assert.deepEqual(await violations(page), [], how);
    assert.equal(await sticksOut(page), false, how);
  });
  const page = await openPage(address);
  const wanted = await page.locator('button:visible:not([tabindex="-1"]), select:visible, input:visible').evaluateAll((all) => all.length);
  const seen = new Set();
  for (let i = 0; i < wanted + 20; i += 1) {
    await page.keyboard.press('Tab');
    seen.add(await page.evaluate(() => [...document.querySelectorAll('button, select, input')].indexOf(document.activeElement)));
  }
  seen.delete(-1);
  assert.ok(seen.size >= wanted, `${seen.size} of ${wanted}`);
});
