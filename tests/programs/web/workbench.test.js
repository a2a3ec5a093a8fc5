// SPDX-License-Identifier: MIT
//
// The workbench, below a path of a server that has nothing but files. Catches a compiled team that
// plays another leg than its library, a message without its line, a team that cannot be stopped, a lost text, and parts that
// cannot be read or reached.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { execFileSync, spawn } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { closeBrowser, folder, inAllViews, openPage, readJson, run, sticksOut, violations } from './support.js';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const isBuilt = existsSync(join(process.env.MIROCUP_BUILD, 'browser/workbench/packed'));
const options = { skip: isBuilt ? false : 'the target mirocup-workbench was not built' };
const server = spawn('python3', ['-u', '-m', 'http.server', '0', '--bind', '127.0.0.1', '--directory', folder], { stdio: ['ignore', 'pipe', 'ignore'] });
const [, port] = /port ([0-9]+)/.exec(await new Promise((resolve) => { server.stdout.once('data', resolve); }));
const address = `http://127.0.0.1:${port}/bench/index.html`;
if (isBuilt) run('workbench', '-o', join(folder, 'bench'));
after(async () => {
  await closeBrowser();
  server.kill();
});

async function write(page, source) {
  await page.click('#editor .ace_content');
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(source);
}

const told = (page, text, id = 'code_told') => page.waitForFunction(([words, place]) => document.getElementById(place).textContent.includes(words), [text, id]);

// The hash of a leg in the page, and by the program.
async function playedHash(page, half, seed, opponent) {
  await page.fill('#half', String(half));
  await page.fill('#seed', String(seed));
  await page.selectOption('#opponent', opponent);
  await page.click('#run');
  await page.waitForSelector('#finish:enabled');
  await page.click('#finish');
  await told(page, 'state hash');
  return /state hash: ([0-9a-f]{16})/.exec(await page.textContent('#code_told'))[1];
}

function nativeHash(half, seed, yellow, blue) {
  run('match', '--blue', blue, '--yellow', yellow, '--half', String(half), '--seed', String(seed), '--record', join(folder, 'native.json'));
  return readJson(join(folder, 'native.json')).state_hash;
}

test('a typed team plays the leg of its library, is stopped, and is told its mistakes at their lines', options, async () => {
  const [, source] = /```cpp\n([^]*?)```/.exec(readFileSync(join(root, 'README.md'), 'utf8'));
  const [mine, first] = [join(folder, 'mine'), 'command.wheels[0]'];
  writeFileSync(`${mine}.cpp`, source);
  execFileSync('g++', ['-std=c++20', '-O2', '-ffp-contract=off', '-shared', '-fPIC', `-I${root}/plugins/include`, `${mine}.cpp`, '-o', `${mine}.so`]);
  const page = await openPage(address);
  await write(page, readFileSync(join(root, 'plugins/house/striker.cpp'), 'utf8'));  // it has place()
  assert.equal(await playedHash(page, 20, 3, 'tactician'), nativeHash(20, 3, 'tactician', 'striker'));
  await write(page, source);
  assert.equal(await playedHash(page, 60, 1, 'chaser'), nativeHash(60, 1, 'chaser', `${mine}.so`));
  await page.click('#why button');  // a drill against what cost the team most
  await told(page, 'Drill under way', 'hand_told');

  const loop = `std::printf("in %u\\n", now.tick);\n    for (volatile int i = 0; now.tick > 5;) i = 1;\n    ${first}`;
  await write(page, `#include <cstdio>\n${source.replace(first, loop)}`);
  await page.click('#run');
  await page.waitForSelector('#log li:has-text("in 0")');
  await page.click('#stop');
  await told(page, 'it was stopped');
  await write(page, source.replace(first, `__builtin_trap();\n    ${first}`));
  await page.click('#run');
  await told(page, 'your team crashed in decide() at tick 0: it called abort');
  await write(page, source.replace('now.own[0]);', 'now.own[0])'));
  await page.keyboard.press('Control+Enter');
  await page.waitForSelector('.ace_gutter-cell.ace_error:has-text("10")');
  assert.match(await page.textContent('#errors'), /team\.cpp:10:[0-9]+: error: expected ';'/);
  await page.reload();  // the text is kept
  assert.match(await page.evaluate(() => globalThis.ace.edit('editor').getValue()), /now\.own\[0\]\)  \/\/ you/);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test('everything can be read and reached, at 1280 and 390 px; from disk it says what it needs', options, async () => {
  await inAllViews(address, async (page, how) => {
    await page.waitForSelector('.ace_content');
    assert.deepEqual(await violations(page), [], how);
    assert.equal(await sticksOut(page), false, how);
    assert.deepEqual(page.problems, []);
  });
  const page = await openPage(`file://${join(folder, 'bench/index.html')}`);
  await told(page, 'Run needs a web server');
  assert.equal(await page.isDisabled('#run'), true);
});
