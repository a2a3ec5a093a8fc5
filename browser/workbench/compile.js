// SPDX-License-Identifier: MIT
//
// The worker that compiles a team, by clang as WebAssembly. It is asked {clang: the folder of the compiler, source}, and answers
// {loaded: bytes} for each loaded piece, then {wasm, text, seconds}; without `wasm` the text has the compiler's errors.
import { compiling, linking } from './options.js';

let ready;  // {runClang, include, seat}

const fetchFile = self.fetch.bind(self);
const ownFile = (name) => fetchFile(new URL(name, import.meta.url));

// The bytes of a part of the compiler, from its pieces.
function bytesOf(address, count) {
  let next = 0;
  return new ReadableStream({
    async pull(out) {
      const response = await fetchFile(`${address}.${next}`);
      if (!response.ok) throw new Error(`the compiler cannot be loaded: ${response.status} ${response.url}`);
      const piece = new Uint8Array(await response.arrayBuffer());
      out.enqueue(piece);
      postMessage({ loaded: piece.length });
      if (++next === count) out.close();
    },
  });
}

async function load(clang) {
  const pieces = await (await fetchFile(new URL('pieces.json', clang))).json();
  // The compiler fetches its parts by this function. They are packed so that they are small on every web server.
  self.fetch = async (address) => {
    const name = String(address).slice(clang.length);
    const body = bytesOf(address, pieces[name]).pipeThrough(new DecompressionStream('gzip'));
    return new Response(body, { headers: { 'content-type': name.endsWith('.wasm') ? 'application/wasm' : 'application/octet-stream' } });
  };
  const { runClang } = await import(new URL('bundle.js', clang));
  await runClang(null, {}, { fetchProgress: () => {} });
  return { runClang, include: await (await ownFile('headers.json')).json(), seat: new Uint8Array(await (await ownFile('seat.o')).arrayBuffer()) };
}

async function compile({ clang, source }) {
  ready ??= await load(clang);
  const { runClang, include, seat } = ready;
  const begin = performance.now();
  const decoder = new TextDecoder();
  let text = '';
  const stderr = (bytes) => { text += bytes ? decoder.decode(bytes, { stream: true }) : ''; };
  let files = {};
  try {
    files = await runClang(['clang++', ...compiling, ...linking, 'team.cpp', 'seat.o', '-o', 'team.wasm'],
      { include, 'team.cpp': source, 'seat.o': seat }, { stderr });
  } catch (error) {
    if (error instanceof RangeError) throw new Error('the compiler needs a deeper stack than this browser has, so nest templates less deeply');
    if (!text) throw error;
  }
  return { wasm: files?.['team.wasm'], text, seconds: (performance.now() - begin) / 1000 };
}

onmessage = async ({ data }) => {
  try {
    postMessage(await compile(data));
  } catch (error) {
    postMessage({ problem: error.message });
  }
};
