// SPDX-License-Identifier: MIT
//
// The workbench, below a path of a server that has nothing but files, and in a league. Catches a compiled team that plays another
// leg than its library, a message without its line, a team that cannot be stopped, a lost text, a worker that a policy stops, and
// parts that cannot be read or reached.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { execFileSync, spawn } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { closeBrowser, folder, inAllViews, openPage, readJson, run, serve, sticksOut, violations } from './support.js';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const options = { skip: existsSync(join(process.env.MIROCUP_BUILD, 'browser/workbench/packed')) ? false : 'the target mirocup-workbench was not built' };
const server = spawn('python3', ['-u', '-m', 'http.server', '0', '--bind', '127.0.0.1', '--directory', folder], { stdio: ['ignore', 'pipe', 'ignore'] });
const [, port] = /port ([0-9]+)/.exec(await new Promise((resolve) => { server.stdout.once('data', resolve); }));
const address = `http://127.0.0.1:${port}/bench/index.html`;
if (!options.skip) run('workbench', '-o', join(folder, 'bench'));
after(() => server.kill() && closeBrowser());

async function runTyped(page, source) {
  await page.click('#editor .ace_content');
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(source);
  await page.keyboard.press('Control+Enter');
}

const told = (page, text, id = 'code_told') => page.waitForFunction(([words, place]) => document.getElementById(place).textContent.includes(words), [text, id]);

// The lines of the editor that end below its scroll bar.
function hiddenLines() {
  const end = document.querySelector('.ace_sb-v').getBoundingClientRect().left;
  return [...document.querySelectorAll('.ace_text-layer .ace_line')].filter((line) => {
    const range = document.createRange();
    range.selectNodeContents(line);
    return range.getBoundingClientRect().right > end;
  }).map((line) => line.textContent);
}

// Plays a leg in the page, and by the program with the team's library.
async function expectSameLeg(page, source, half, seed, opponent) {
  for (const [id, value] of [['half', half], ['seed', seed]]) await page.fill(`#${id}`, String(value));
  await page.selectOption('#opponent', opponent);
  await runTyped(page, source);
  await page.click('#finish:enabled');
  await told(page, 'state hash');
  const mine = join(folder, 'mine');
  writeFileSync(`${mine}.cpp`, source);
  execFileSync('g++', ['-std=c++20', '-O2', '-ffp-contract=off', '-shared', '-fPIC', `-I${root}/plugins/include`, `${mine}.cpp`, '-o', `${mine}.so`]);
  run('match', '--blue', `${mine}.so`, '--yellow', opponent, '--half', String(half), '--seed', String(seed), '--record', `${mine}.json`);
  assert.equal(/state hash: ([0-9a-f]{16})/.exec(await page.textContent('#code_told'))[1], readJson(`${mine}.json`).state_hash, opponent);
}

test('a typed team plays the leg of its library, is stopped, and is told its mistakes at their lines', options, async () => {
  const [, source] = /```cpp\n([^]*?)```/.exec(readFileSync(join(root, 'README.md'), 'utf8'));
  const first = 'command.wheels[0]';
  const page = await openPage(address);
  await expectSameLeg(page, source.replace(' private:', '  void place(const Observation&, Placement& all) override { all.robots[2].y += 0.1; }\n private:'), 20, 3, 'tactician');
  await expectSameLeg(page, source, 60, 1, 'chaser');
  assert.deepEqual(await violations(page), [], 'after a leg');
  await page.click('#why button');  // a drill against what cost the team most
  await told(page, 'Drill under way', 'hand_told');

  await runTyped(page, source.replace(first, `setup().log(setup().host, "begins");\n    for (volatile int i = 0; now.tick > 30;) i = 1;\n    ${first}`));
  await page.waitForSelector('#log li:has-text("begins")');
  await page.click('#stop');
  await told(page, 'it was stopped');
  await runTyped(page, source.replace(first, `__builtin_trap();\n    ${first}`));
  await told(page, 'your team crashed in decide() at tick 0: it called abort');
  await runTyped(page, source.replace('now.own[0]);', 'now.own[0])'));
  await page.waitForSelector('.ace_gutter-cell.ace_error:has-text("10")');
  assert.match(await page.textContent('#errors'), /team\.cpp:10:[0-9]+: error: expected ';'/);
  await page.reload();  // the text is kept
  assert.match(await page.evaluate(() => globalThis.ace.edit('editor').getValue()), /now\.own\[0\]\)  \/\/ you/);
  assert.deepEqual(page.problems, []);
});

test('the page of a league hands in, and its workers run under the policy of the server', options, async () => {
  const league = join(folder, 'league');
  run('league', 'init', league, '--team', 'alpha=house:chaser', '--team', 'beta=house:keeper', '--half', '2');
  const { place } = await serve(league, '--hand-in');
  const page = await openPage(`${place}hand-in`);
  await page.fill('#token', run('league', 'token', league, 'alpha').trim());
  await page.click('form button');
  await page.waitForSelector('#hand-in button');
  await page.goto(place);
  await page.click('a[href="workbench"]');
  await page.waitForSelector('.ace_content');
  await page.click('#hand_in');
  await told(page, 'alpha: entry 2 was accepted', 'verdict');
  await page.click('#run');
  await told(page, 'Compiled');
  assert.deepEqual(page.problems, []);
});

test('everything can be read and reached, at 1280 and 390 px; from disk it says what it needs', options, async () => {
  await inAllViews(address, async (page, how) => {
    await page.waitForSelector('.ace_sb-v');
    assert.deepEqual(await violations(page), [], how);
    assert.equal(await sticksOut(page), false, how);
    assert.deepEqual(await page.evaluate(hiddenLines), [], how);
    assert.deepEqual(page.problems, []);
  });
  await told(await openPage(`file://${join(folder, 'bench/index.html')}`), 'Run needs a web server');
});
