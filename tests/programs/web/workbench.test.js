// SPDX-License-Identifier: MIT
//
// The workbench, below a path of a server that has nothing but files, and in a league. Catches a compiled team that plays another
// leg than its library, a message without its line, a team that cannot be stopped, a lost text, a worker that a policy stops, a team
// that reaches what is not its own, and parts that cannot be read or reached.
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

async function type(page, source) {
  await page.click('#editor .ace_content');
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(source);
}

async function runTyped(page, source) {
  await type(page, source);
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

// Lets the page play its text to the end. Expects the leg that the program plays with the team's library, and returns its record.
async function expectSameLeg(page, half, seed, opponent) {
  for (const [id, value] of [['half', half], ['seed', seed]]) await page.fill(`#${id}`, String(value));
  await page.selectOption('#opponent', opponent);
  await page.click('#run');
  await page.click('#finish:enabled');
  await told(page, 'state hash');
  const mine = join(folder, 'mine');
  writeFileSync(`${mine}.cpp`, await page.evaluate(() => globalThis.ace.edit('editor').getValue()));
  execFileSync('g++', ['-std=c++20', '-O2', '-ffp-contract=off', '-shared', '-fPIC', `-I${root}/plugins/include`, `${mine}.cpp`, '-o', `${mine}.so`]);
  run('match', '--blue', `${mine}.so`, '--yellow', opponent, '--half', String(half), '--seed', String(seed), '--record', `${mine}.json`);
  const record = readJson(`${mine}.json`);
  assert.equal(/state hash: ([0-9a-f]{16})/.exec(await page.textContent('#code_told'))[1], record.state_hash, opponent);
  return record;
}

test('a typed team plays the leg of its library, is stopped, and is told its mistakes at their lines', options, async () => {
  const [, source] = /```cpp\n([^]*?)```/.exec(readFileSync(join(root, 'README.md'), 'utf8'));
  const first = 'command.wheels[0]';
  const page = await openPage(address);
  await type(page, source.replace(' private:', '  void place(const Observation&, Placement& all) override { all.robots[2].y += 0.1; }\n private:'));
  await expectSameLeg(page, 20, 3, 'tactician');
  await type(page, source);
  await expectSameLeg(page, 60, 1, 'chaser');
  await page.selectOption('#inspected', '1');
  await page.fill('#scrub', '300');
  assert.match(await page.textContent('#inspector'), /mine 1 \(blue\).*tick 300.*x, y/, 'the numbers of a robot');
  assert.ok(await page.isVisible('#momentum path.yellow'));
  assert.deepEqual(await violations(page), [], 'after a leg');
  await page.click('#why button');  // a drill against what cost the team most
  await told(page, 'Drill under way', 'hand_told');

  await runTyped(page, source.replace(first, `setup().log(setup().host, "begins");\n    for (volatile int i = 0; now.tick > 30;) i = 1;\n    ${first}`));
  await page.waitForSelector('#log li:has-text("begins")');
  await page.click('#stop');
  await told(page, 'it was stopped');
  // Run, while the worker is asked for the hash of a leg that is over: the next leg runs all the same.
  await page.evaluate(() => {
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function ask(question) {
      if (question.act !== 'hash') return post.call(this, question);
      Worker.prototype.postMessage = post;
      return document.getElementById('run').click();
    };
  });
  await page.selectOption('#start', '');
  await page.fill('#half', '1');
  await runTyped(page, source);
  await told(page, 'state hash');

  await runTyped(page, source.replace(first, `__builtin_trap();\n    ${first}`));
  await told(page, 'your team crashed in decide() at tick 0: it called abort');
  await runTyped(page, source.replace('using namespace', '// using namespace'));
  await told(page, 'do: write using namespace mirocup::strategy; below the includes', 'errors');
  await runTyped(page, source.replace('now.own[0]);', 'now.own[0])'));
  await page.waitForSelector('.ace_gutter-cell.ace_error:has-text("10")');
  assert.match(await page.textContent('#errors'), /team\.cpp:10:[0-9]+: error: expected ';'/);
  await page.reload();  // the text is kept
  assert.match(await page.evaluate(() => globalThis.ace.edit('editor').getValue()), /now\.own\[0\]\)  \/\/ you/);
  assert.deepEqual(page.problems, []);
});

// A team that asks for more than a team may have, and says what it got.
const greedy = `#include "mirocup/strategy.hpp"
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>
#define FROM(object, name) __attribute__((import_module(object), import_name(name)))
extern "C" { FROM("__proto__", "taken") int inherit(int); FROM("constructor", "constructor") int make(int); FROM("mirocup", "constructor") int own(int); }
using namespace mirocup::strategy;
struct Greedy : Team {
  using Team::Team;
  void decide(const Observation& now, Command&) override {
    if (now.tick > 0) return;
    std::printf("%d %d %d, %s, %s, %ld\\n", inherit(1), make(2), own(3), std::getenv("HOME") ? "home" : "no home",
                std::fopen("/etc/passwd", "r") ? "a file" : "no file", static_cast<long>(std::time(nullptr)));
    const std::vector<char> line(200 << 20, 'x');
    std::fwrite(line.data(), 1, line.size(), stdout);
    std::puts("");
  }
};
MIROCUP_EXPORT_TEAM(Greedy, "greedy")
`;

test('in a league, from an empty page to a team that beats chaser and is handed in; a team reaches nothing else', options, async () => {
  const league = join(folder, 'league');
  run('league', 'init', league, '--team', 'alpha=house:chaser', '--team', 'beta=house:keeper', '--half', '2');
  const { place } = await serve(league, '--hand-in', '--base', '/spring');
  const page = await openPage(`${place}spring/hand-in`);
  await page.fill('#token', run('league', 'token', league, 'alpha').trim());
  await page.click('form button');
  await page.waitForSelector('#hand-in button');
  await page.goto(`${place}spring/`);
  await page.click('a[href="workbench"]');
  await page.waitForSelector('.ace_content');
  await type(page, '');
  await page.selectOption('#beginning', '6 Kick-offs, stuck balls and the laws');
  await page.click('#again');
  const { result } = await expectSameLeg(page, 60, 1, 'chaser');
  assert.deepEqual(result.score, { blue: 2, yellow: 0 });
  await page.click('#hand_in');
  await told(page, 'alpha: entry 2 was accepted', 'verdict');
  assert.deepEqual(page.problems, []);

  await runTyped(page, greedy);
  await page.waitForSelector('#log li:has-text("0 52 52 52, no home, no file, 946684800")');
  assert.ok((await page.textContent('#log')).length < 100_000, 'a line of 200 MB');
  const worker = page.workers().find((one) => one.url().endsWith('leg.js'));
  assert.deepEqual(await worker.evaluate(() => [typeof {}.taken, Object.keys(Object.prototype)]), ['undefined', []]);
  assert.match(await worker.evaluate(() => fetch('/spring/api/v1/entries').then(() => 'an answer', String)), /Failed to fetch/);
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
