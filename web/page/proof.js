// SPDX-License-Identifier: MIT
//
// "Prove it": the leg is simulated again in this browser, by the module of browser/ in a worker, and compared with the record.
import { by, element } from './text.js';
import { unpackBytes, unpackText } from './thoughts.js';

// The worker runs the module's script, which is here as a text, and this.
const work = `
onmessage = async ({ data }) => {
  try {
    const mirocup = await loadMirocup(data.wasm);
    const begin = performance.now();
    const found = mirocup.verify(data.record, data.replay);
    postMessage({ found, seconds: (performance.now() - begin) / 1000 });
  } catch (error) {
    postMessage({ problem: error.message });
  }
};`;

// Starts a worker with the module's script and `code` behind it.
export async function startWorker(module, code) {
  const script = (await unpackText(module.script)).replace(/^export /gm, '');
  const address = URL.createObjectURL(new Blob([script, code], { type: 'text/javascript' }));
  const worker = new Worker(address);
  URL.revokeObjectURL(address);
  return worker;
}

// Runs a script file beside the page, which sets a global value, and returns the value.
function valueOf(file, name) {
  return new Promise((resolve, reject) => {
    const script = element('script');
    script.src = file;
    script.addEventListener('load', () => (globalThis[name] ? resolve(globalThis[name]) : reject(new Error(`${file} was changed after it was written`))));
    script.addEventListener('error', () => reject(new Error(`the file ${file} is not beside this page`)));
    document.head.append(script);
  });
}

// What this page, or files beside it, have for a simulation: {module, record, replay}.
export async function proofData() {
  const { module_file: file, commands_file: commands, ...inside } = JSON.parse(by('proof').textContent);
  const module = file ? { module: await valueOf(file, 'mirocup_module') } : {};
  return { ...inside, ...module, ...(commands ? await valueOf(commands, 'mirocup_commands') : {}) };
}

async function prove({ module, record, replay }) {
  const worker = await startWorker(module, work);
  const message = { wasm: await unpackBytes(module.wasm), record: await unpackText(record), replay: await unpackBytes(replay) };
  const answer = await new Promise((resolve, reject) => {
    worker.addEventListener('message', ({ data }) => resolve(data));
    worker.addEventListener('error', (event) => reject(new Error(event.message || 'the worker ended')));
    worker.postMessage(message);
  });
  worker.terminate();
  if (answer.problem) throw new Error(answer.problem);
  return answer;
}

function showAnswer(place, { found, seconds }, seek) {
  const line = (text, look) => place.append(element('p', look, text));
  if (found.reproduced) {
    line(`Reproduced: all ${found.ticks} ticks, in ${seconds.toFixed(2)} s.`, 'good');
  } else {
    line(`Differs from tick ${found.tick} on: ${found.what}.`, 'bad');
    const button = element('button', '', `Go to tick ${found.tick}`);
    button.addEventListener('click', () => seek(found.tick));
    place.append(button);
  }
  line(`State hash found here: ${found.found}`);
  line(`State hash of the record: ${found.state_hash}`);
}

// Connects the button, if this page can be proved. `seek(tick)` shows a moment.
export function offerProof(seek) {
  if (!by('proof')) return;
  const button = by('prove');
  const place = by('proof_found');
  button.addEventListener('click', async () => {
    button.disabled = true;
    place.replaceChildren(element('p', 'small', 'Simulating …'));
    try {
      const answer = await prove(await proofData());
      place.replaceChildren();
      showAnswer(place, answer, seek);
    } catch (error) {
      place.replaceChildren(element('p', 'bad', `It cannot be proved here: ${error.message}.`));
    }
    button.disabled = false;
  });
}
