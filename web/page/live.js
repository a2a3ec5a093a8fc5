// SPDX-License-Identifier: MIT
//
// The live view of a running match: events from the server fill the same track and lists that a
// replay fills at once. A viewer may join in the middle or again after a lost connection.

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
