// SPDX-License-Identifier: MIT
//
// A match that is being played: what the server sends goes into the same track and lists that a
// replay fills at once. Joining in the middle, or again after a lost connection, is the same.

export function listen(url, { onStart, onFrame, onCall, onStatistics, onEnd, onLost }) {
  const source = new EventSource(url);
  const on = (name, handle) =>
    source.addEventListener(name, (event) => handle(JSON.parse(event.data)));
  on('start', onStart);
  on('frame', onFrame);
  on('call', onCall);
  on('statistics', onStatistics);
  on('end', (end) => {
    source.close();
    onEnd(end);
  });
  source.addEventListener('error', onLost);
}
