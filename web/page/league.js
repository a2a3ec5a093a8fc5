// SPDX-License-Identifier: MIT
//
// Keeps a page of a league up to date while it is played, and lists the legs that are being played.
// `mirocup league serve` puts it into the pages that it serves.

function element(tag, text) {
  const made = document.createElement(tag);
  if (text !== undefined) made.textContent = text;
  return made;
}

function showPlaying(playing) {
  document.getElementById('playing')?.remove();
  if (playing.length === 0) return;
  const list = element('ul');
  for (const { name, fixture, leg, blue, yellow } of playing) {
    const link = element('a', `${blue} – ${yellow}`);
    link.href = new URL(`live/${encodeURIComponent(name)}/`, import.meta.url);
    const item = element('li');
    item.append(link, ` (${fixture}, leg ${leg})`);
    list.append(item);
  }
  const section = element('section');
  section.id = 'playing';
  section.append(element('h2', 'Being played'), list);
  section.className = 'card';
  document.querySelector('main').prepend(section);
}

let shown;  // version of the page
new EventSource(new URL('events', import.meta.url)).addEventListener('league', async ({ data }) => {
  const { version, playing } = JSON.parse(data);
  if (shown !== undefined && version !== shown) {
    const answer = await fetch(location.pathname);
    const page = new DOMParser().parseFromString(await answer.text(), 'text/html');
    document.body.replaceWith(page.body);  // its scripts do not run
    document.dispatchEvent(new Event('mirocup:page'));
  }
  shown = version;
  showPlaying(playing);
});
