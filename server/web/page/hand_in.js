// SPDX-License-Identifier: MIT
//
// Sends the file of the form on a team's private page, and shows what becomes of it: how much is
// sent, how many checks come before, which check runs, the answer.

const form = document.getElementById('hand-in');
const file = document.getElementById('file');
const sent = document.getElementById('sent');
const answer = document.getElementById('answer');
const log = document.getElementById('log');
const button = form.querySelector('button');

const pause = 2000;  // ms between two questions, where there are no events

function say(text) {
  answer.textContent = text;
}

function inWords({ state, before, step, message, reason }) {
  if (state === 'queued') {
    if (before === 0) return 'Queued: it is the next.';
    return `Queued: ${before} ${before === 1 ? 'check' : 'checks'} before it.`;
  }
  if (state === 'compiling') return 'It is being compiled.';
  if (state === 'checking') {
    return step ? `Check ${step.number} of ${step.of}: ${step.name}.` : 'It is being checked.';
  }
  return message ?? reason ?? state;
}

function isFinal({ state }) {
  return state === 'accepted' || state === 'refused' || state === 'void';
}

async function showEntries() {
  const page = await (await fetch(location.pathname)).text();
  const list = new DOMParser().parseFromString(page, 'text/html').getElementById('entries');
  if (list) document.getElementById('entries').replaceWith(list);
}

function end() {
  button.disabled = false;
  showEntries();
}

// Follows a check by its events, or by questions if there are none.
function follow({ url, events }) {
  const source = new EventSource(events);
  let isOver = false;
  const show = (report) => {
    say(inWords(report));
    isOver = isFinal(report);
    if (isOver) {
      source.close();
      log.textContent = report.log ?? '';
      log.hidden = log.textContent === '';
      end();
    }
  };
  source.addEventListener('state', ({ data }) => show(JSON.parse(data)));
  source.onerror = () => {
    source.close();
    const ask = async () => {
      try {
        const reply = await fetch(url);
        if (reply.ok) show(await reply.json());
      } catch {
        say('The server does not answer. What it has taken is not lost; this page asks again.');
      }
      if (!isOver) setTimeout(ask, pause);
    };
    if (!isOver) setTimeout(ask, pause);
  };
}

form.addEventListener('submit', (event) => {
  event.preventDefault();
  const chosen = file.files[0];
  if (!chosen) return;
  button.disabled = true;
  log.hidden = true;
  sent.hidden = false;
  sent.value = 0;
  say('Sending …');
  const request = new XMLHttpRequest();
  request.open('PUT', `/api/v1/entries?name=${encodeURIComponent(chosen.name)}`);
  request.responseType = 'json';
  request.upload.onprogress = ({ loaded, total }) => { sent.value = total > 0 ? loaded / total : 0; };
  request.onload = () => {
    sent.hidden = true;
    if (request.status === 202) {
      follow(request.response);
      showEntries();
      return;
    }
    say(`Not taken: ${request.response?.error ?? `status ${request.status}`}.`);
    button.disabled = false;
  };
  request.onerror = () => {
    sent.hidden = true;
    say('Not sent: the server does not answer. Try again.');
    button.disabled = false;
  };
  request.send(chosen);
});

form.hidden = false;
