// SPDX-License-Identifier: MIT
import { frameText } from './frame_text';
import type { FrameStore } from './frame_store';
import { speeds, type Player } from './player';
import { button, h, select } from '../ui/dom';

export interface PlayerBar {
  element: HTMLElement;
  update(jobRuns: boolean, planned: number): void;
}

/// `changed`: the player was told something. `update` shows how it stands.
export function playerBar(player: Player, store: FrameStore, changed: () => void): PlayerBar {
  const act = (what: () => void) => (): void => {
    what();
    changed();
  };
  const play = button('Play', act(() => (player.playing ? player.pause() : player.play())), { class: 'primary', 'data-action': 'play' });
  const back = button('‹', act(() => player.step(-1)), { 'aria-label': 'One frame back', title: 'One frame back (,)' });
  const on = button('›', act(() => player.step(1)), { 'aria-label': 'One frame on', title: 'One frame on (.)' });
  const live = button('Live', act(() => player.follow()), { title: 'Follow the newest frame (L)', 'aria-pressed': 'false' });
  const scrubber = h('input', { type: 'range', min: 0, max: 0, value: 0, step: 1, 'aria-label': 'Frame' });
  scrubber.addEventListener('input', act(() => {
    player.pause();
    player.seek(Number(scrubber.value));
  }));
  const speed = select('Speed', speeds.map((value) => [String(value), `${value}×`] as const), String(player.speed), (value) => {
    player.speed = Number(value);
  });
  const place = h('output', { class: 'frame-place' });
  const dropped = h('span', { class: 'note' });
  const element = h('div', { class: 'player', role: 'group', 'aria-label': 'Player' }, play, back, on, scrubber, place, speed, live, dropped);

  const update = (jobRuns: boolean, planned: number): void => {
    const last = Math.max(store.count - 1, 0);
    const frame = store.at(player.place);
    scrubber.max = String(last);
    scrubber.value = String(player.place);
    scrubber.disabled = play.disabled = store.count < 2;
    const text = frameText(frame?.index ?? -1, planned) + (frame ? `, ${Number(frame.t.toPrecision(4))} s` : '');
    if (place.textContent !== text) place.textContent = text;
    scrubber.setAttribute('aria-valuetext', text);
    play.textContent = player.playing ? 'Pause' : 'Play';
    back.disabled = store.count === 0 || player.place === 0;
    on.disabled = store.count === 0 || player.place === last;
    live.hidden = !jobRuns;
    live.setAttribute('aria-pressed', String(player.following));
    dropped.textContent = store.stride > 1 ? `To save memory only every ${store.stride}th frame is kept.` : '';
  };
  return { element, update };
}
