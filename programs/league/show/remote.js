// SPDX-License-Identifier: MIT
//
// The remote of a show: sends commands to the server, which passes them to the projector. The key
// that allows it is in the address, behind "#".
const said = document.getElementById('said');

async function send(command) {
  const answer = await fetch('/control', { method: 'POST', body: `${location.hash.slice(1)} ${command}` });
  said.textContent = answer.ok ? 'Sent.' : 'This address may not control the show: open the one that `league show` printed.';
}

for (const button of document.querySelectorAll('[data-command]')) {
  button.addEventListener('click', () => send(button.dataset.command));
}
