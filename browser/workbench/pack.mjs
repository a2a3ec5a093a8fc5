// SPDX-License-Identifier: MIT
//
// node pack.mjs FOLDER HEADERS TUTORIAL ADVICE: makes what `mirocup workbench` copies, from the packages of npm in
// FOLDER/node_modules, the headers of teams, docs/first-goal.md, plugins/host/compile_advice.txt, and the files beside this script:
// FOLDER/clang, which changes with the compiler only, and FOLDER/parts.
import { copyFileSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import { compiling } from './options.js';

const [folder, headers, tutorial, advice] = process.argv.slice(2);
const mostBytes = 1 << 20;  // of a file, so that a server need not hold much for a slow browser
const here = dirname(fileURLToPath(import.meta.url));
const [clang, ace] = [join(folder, 'node_modules/@yowasp/clang'), join(folder, 'node_modules/ace-builds')];

// A folder as an object, for the compiler's file system.
const tree = (path) => Object.fromEntries(readdirSync(path).sort().map((name) => {
  const inside = join(path, name);
  return [name, statSync(inside).isDirectory() ? tree(inside) : readFileSync(inside, 'utf8')];
}));

for (const part of ['clang', 'parts']) {
  rmSync(join(folder, part), { recursive: true, force: true });
  mkdirSync(join(folder, part));
}
const pieces = {};  // how many files have a part of the compiler
for (const name of readdirSync(join(clang, 'gen'))) {
  const bytes = readFileSync(join(clang, 'gen', name));
  if (name.endsWith('.js')) {
    writeFileSync(join(folder, 'clang', name), bytes);
    continue;
  }
  const packed = gzipSync(bytes);
  pieces[name] = Math.ceil(packed.length / mostBytes);
  for (let i = 0; i < pieces[name]; ++i) writeFileSync(join(folder, 'clang', `${name}.${i}`), packed.subarray(i * mostBytes, (i + 1) * mostBytes));
}
writeFileSync(join(folder, 'clang', 'pieces.json'), JSON.stringify(pieces));
for (const name of ['ace', 'mode-c_cpp', 'theme-chrome', 'theme-one_dark', 'ext-language_tools', 'ext-searchbox']) {
  copyFileSync(join(ace, 'src-min-noconflict', `${name}.js`), join(folder, 'parts', `${name}.js`));
}
copyFileSync(join(ace, 'LICENSE'), join(folder, 'parts', 'LICENSE.ace'));
for (const name of ['compile.js', 'options.js', 'leg.js', 'teams.js']) copyFileSync(join(here, name), join(folder, 'parts', name));
writeFileSync(join(folder, 'parts', 'headers.json'), JSON.stringify(tree(headers)));

// What each team is linked to, so that a page compiles the team alone.
const { runClang } = await import(pathToFileURL(join(clang, 'gen/bundle.js')));
await runClang(null, {}, { fetchProgress: () => {} });
const { 'seat.o': seat } = await runClang(['clang++', ...compiling, '-c', 'seat.cpp', '-o', 'seat.o'],
  { include: tree(headers), 'seat.cpp': readFileSync(join(here, 'seat.cpp'), 'utf8') });
writeFileSync(join(folder, 'parts', 'seat.o'), seat);

// The functions of the headers in C++ with their comments, which the editor shows: {name: text}.
const texts = (inside) => Object.entries(inside).flatMap(([name, one]) => (typeof one !== 'string' ? texts(one) : name.endsWith('.hpp') ? [one] : []));
const functions = {};
for (const text of texts(tree(headers))) {
  for (const [, comment, head, name] of text.matchAll(/((?:^ *\/\/ .*\n)+)^ *((?:[\w:<>&*]+ )+\*?&?(\w+)\((?:[^;{]|\{\})*?\))(?: const)? ?[;{]/gm)) {
    functions[name] ??= `${head.replace(/\s+/g, ' ').replace('inline ', '')}\n\n${comment.replace(/^ *\/\/ ?/gm, '').trim()}`;
  }
}
writeFileSync(join(folder, 'parts', 'functions.json'), JSON.stringify(functions));

// The steps of the tutorial as whole teams, {title: source}. A step shows what changes in the class of the first step, and says in
// which step another function stands.
const steps = [...readFileSync(tutorial, 'utf8').matchAll(/^## ([0-9]) (.*)\n[^]*?```cpp\n([^]*?)```/gm)];
const [head] = steps[0][3].split(/^.*decide\(/m);
const [, tail] = steps[0][3].split(/(?=^};)/m);
const functionOf = (name, step) => {
  const lines = steps[step - 1][3].split('\n');
  const first = lines.findIndex((line) => line.includes(` ${name}(`) && line.endsWith('{'));
  return lines.slice(first, lines.findIndex((line, i) => i > first && line === '')).join('\n');
};
const beginnings = Object.fromEntries(steps.map(([, number, title, code]) => {
  const own = code.replace(/^ *\/\/ (\w+)\(\) as in step ([0-9])$/gm, (_, name, step) => functionOf(name, Number(step)));
  return [`${number} ${title}`, own.startsWith('#include') ? own : head + own + tail];
}));
writeFileSync(join(folder, 'parts', 'beginnings.json'), JSON.stringify(beginnings));

// The compiler's words for a mistake, and what to do about it: [[words, advice]…].
const rows = readFileSync(advice, 'utf8').split('\n').filter((line) => line && !line.startsWith('#')).map((line) => line.split(' | '));
writeFileSync(join(folder, 'parts', 'advice.json'), JSON.stringify(rows));
