// SPDX-License-Identifier: MIT
//
// Plays legs and opens pages for the tests of this folder.
import { execFileSync, spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const modules = createRequire(join(process.env.MIROCUP_WEB_MODULES, 'x'));
const { chromium } = modules('playwright-core');
export const moduleFile = (name) => modules.resolve(name);
export const mirocup = join(process.env.MIROCUP_BUILD, 'mirocup');

export const folder = mkdtempSync(join(tmpdir(), 'mirocup-web-'));
process.on('exit', () => rmSync(folder, { recursive: true }));

export const evil = '<img src=x onerror="document.title=\'written by a team\'">';

export function run(...args) {
  return execFileSync(mirocup, args, { encoding: 'utf8' });
}

export function match(...more) {
  return ['match', '--blue', 'striker', '--yellow', 'chaser', '--blue-name', evil, ...more];
}

export function readJson(path) {
  return JSON.parse(readFileSync(path, 'utf8'));
}

// A match that is being played and watched: {url, ended}.
export function watched(...more) {
  const child = spawn(mirocup, match('--watch', ...more));
  const ended = new Promise((resolve) => { child.on('exit', resolve); });
  const url = new Promise((resolve) => {
    let text = '';
    child.stderr.on('data', (part) => {
      text += part;
      const found = /http:\S+/.exec(text);
      if (found) resolve(found[0]);
    });
  });
  return { url, ended, child };
}

const servers = [];

// Starts `league serve` and returns its address and its process, which ends with the tests at the latest.
export async function serve(league, ...more) {
  const server = spawn(mirocup, ['league', 'serve', league, ...more]);
  servers.push(server);
  const text = await new Promise((resolve) => { server.stdout.once('data', resolve); });
  return { place: String(text).trim(), server };
}

// ms; a browser on a busy machine may be slow.
const patience = 300_000;

let browser;
export async function openPage(url, viewport = { width: 1280, height: 800 }, more = {}) {
  browser ??= await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox'] });
  const page = await browser.newPage({ viewport, ...more });
  page.setDefaultTimeout(patience);
  page.problems = [];
  page.on('pageerror', (error) => page.problems.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error' && !message.text().includes('favicon')) page.problems.push(message.text());
  });
  await page.goto(url);
  return page;
}

// Ends all that this file has started.
export async function closeBrowser() {
  servers.forEach((server) => server.kill('SIGTERM'));
  await browser?.close();
}

// Returns what axe-core finds wrong with the page as it is shown: "rule: element, element".
export async function violations(page) {
  await page.evaluate(readFileSync(modules.resolve('axe-core/axe.min.js'), 'utf8'));
  const found = await page.evaluate(async () => (await globalThis.axe.run(document, { preload: false })).violations);
  return found.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target.join(' ')).slice(0, 5).join(', ')}`);
}

// Text that is wider than the window would have to be pushed aside with a finger.
export function sticksOut(page) {
  return page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth);
}

// Calls `check(page, how)` with the page in each width and each scheme that people use. No width of a page depends on its scheme.
export async function inAllViews(url, check) {
  for (const [width, height, colorScheme] of [[1280, 800, 'light'], [390, 844, 'dark']]) {
    const page = await openPage(url, { width, height }, { colorScheme });
    await check(page, `${url} at ${width} px, ${colorScheme}`);
    await page.close();
  }
}
