// SPDX-License-Identifier: MIT
//
// Sends the file of the form on a team's private page, and shows what becomes of it: how much is
// sent, how many checks come before, which check runs, the answer.

// Returns the address of a path of the API: the league may be below a path of the server.
const here = (path) => new URL(path.slice(1), import.meta.url);

const [form, file, sent, answer, log] = ['hand-in', 'file', 'sent', 'answer', 'log'].map((id) => document.getElementById(id));
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

// Takes the lists of the page anew from the server.
async function showLists() {
  const text = await (await fetch(location.pathname + location.search)).text();
  const page = new DOMParser().parseFromString(text, 'text/html');
  for (const id of ['entries', 'friendlies']) {
    const list = page.getElementById(id);
    if (list) document.getElementById(id).replaceWith(list);
  }
}

function end() {
  button.disabled = false;
  showLists();
}

// Follows a check by its events, or by questions if there are none.
function follow({ url, events }) {
  const source = new EventSource(here(events));
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
        const reply = await fetch(here(url));
        if (reply.ok) show(await reply.json());
      } catch {
        say('The server does not answer. Files that it has taken are not lost; this page asks again.');
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
  request.open('PUT', here(`/api/v1/entries?name=${encodeURIComponent(chosen.name)}`));
  request.responseType = 'json';
  request.upload.onprogress = ({ loaded, total }) => { sent.value = total > 0 ? loaded / total : 0; };
  request.onload = () => {
    sent.hidden = true;
    if (request.status === 202) {
      follow(request.response);
      showLists();
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

// A version is pinned, or the pinned one is let go.
document.addEventListener('click', async ({ target }) => {
  const entry = target.dataset?.pin;
  if (!entry) return;
  target.disabled = true;
  const reply = await fetch(here(`/api/v1/pin?entry=${entry}`), { method: 'PUT' });
  if (reply.ok) {
    say(entry === 'latest' ? 'The latest accepted entry plays.' : `Entry ${entry} is pinned: it plays until you unpin it.`);
  } else {
    say(`Not pinned: ${(await reply.json()).error}.`);
  }
  showLists();
});

const friendly = document.getElementById('friendly');
if (friendly) {
  const told = document.getElementById('friendly-answer');
  const opponent = document.getElementById('opponent');
  friendly.addEventListener('submit', async (event) => {
    event.preventDefault();
    const reply = await fetch(here(`/api/v1/friendlies?opponent=${encodeURIComponent(opponent.value)}`), { method: 'POST' });
    told.textContent = reply.ok ? `A leg against ${opponent.value} will be played.` : `Not played: ${(await reply.json()).error}.`;
    showLists();
  });
  friendly.hidden = false;
}

// While legs are to be played, the page asks how they ended.
const legPause = 3000;  // ms
setInterval(() => {
  const waits = [...document.querySelectorAll('#friendlies td')].some(({ textContent }) => textContent === 'waiting' || textContent === 'playing');
  if (waits && !document.hidden) showLists();
}, legPause);

form.hidden = false;
