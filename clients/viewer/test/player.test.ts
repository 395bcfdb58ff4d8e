// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { FrameStore } from '../src/player/frame_store';
import { Player } from '../src/player/player';

function filled(count: number, bound?: number): FrameStore {
  const store = new FrameStore(bound);
  for (let index = 0; index < count; ++index) {
    if (index % store.stride === 0) store.add({ index, t: index / 10, q: new Float64Array(10) });
  }
  return store;
}

describe('FrameStore', () => {
  it('finds the frame of a time', () => {
    const store = filled(5);
    expect([-1, 0, 0.05, 0.1, 0.39, 9].map((t) => store.placeAt(t))).toEqual([0, 0, 0, 1, 3, 4]);
  });
  it('takes no frame twice', () => {
    const store = filled(3);
    store.add({ index: 1, t: 0.1, q: new Float64Array(10) });
    expect(store.count).toBe(3);
  });
  it('stays within its bound and still spans all the time', () => {
    const store = filled(1000, 80 * 100);
    expect(store.count).toBeLessThanOrEqual(100);
    expect(store.stride).toBe(16);
    expect(store.first?.index).toBe(0);
    expect(store.last?.index).toBeGreaterThan(980);
    for (let place = 0; place < store.count; ++place) expect(store.at(place)?.index).toBe(16 * place);
  });
});

describe('Player', () => {
  it('follows the newest frame until told otherwise', () => {
    const store = filled(3);
    const player = new Player(store);
    player.framesCame();
    expect(player.place).toBe(2);
    player.seek(0);
    store.add({ index: 3, t: 0.3, q: new Float64Array(10) });
    player.framesCame();
    expect(player.place).toBe(0);
    player.follow();
    expect(player.place).toBe(3);
  });
  it('plays in simulated time and stops at the end', () => {
    const player = new Player(filled(5));
    player.seek(0);
    player.speed = 0.5;
    player.play();
    expect(player.advance(0.1)).toBe(false);
    expect(player.advance(0.1)).toBe(true);
    expect(player.place).toBe(1);
    for (let i = 0; i < 10; ++i) player.advance(0.2);
    expect([player.place, player.playing]).toEqual([4, false]);
    player.play();
    expect(player.place).toBe(0);
  });
  it('makes up for no more than a quarter of a second', () => {
    const player = new Player(filled(50));
    player.seek(0);
    player.speed = 1;
    player.play();
    player.advance(60);
    expect(player.place).toBe(2);
  });
  it('stays at the frame that is looked at, or the nearest kept, while others are dropped', () => {
    const store = filled(0, 80 * 10);
    const player = new Player(store);
    const shown: (number | undefined)[] = [];
    for (let index = 0; index < 100; ++index) {
      if (index % store.stride !== 0) continue;
      store.add({ index, t: index / 10, q: new Float64Array(10) });
      if (index === 9) player.seek(7);
      player.framesCame();
      const frame = store.at(player.place)?.index;
      if (index >= 9 && shown[shown.length - 1] !== frame) shown.push(frame);
    }
    expect(store.stride).toBe(16);
    expect(shown).toEqual([7, 6, 8, 0]);  // of 6 and 8 at stride 2, 4 and 8 at strides 4 and 8, 0 and 16 at 16
  });
  it('stays where it was paused, and at its end, when frames come', () => {
    const store = filled(5);
    const player = new Player(store);
    player.seek(1);
    player.speed = 1;
    player.play();
    player.advance(0.09);
    player.pause();
    store.add({ index: 5, t: 0.5, q: new Float64Array(10) });
    player.framesCame();
    expect(player.place).toBe(1);
    player.play();
    for (let turn = 0; turn < 9; ++turn) player.advance(0.24);
    expect([player.place, player.playing]).toEqual([5, false]);
    for (let index = 6; index < 9; ++index) store.add({ index, t: index / 10, q: new Float64Array(10) });
    player.framesCame();
    expect(player.place).toBe(5);
  });
  it('goes on playing from its time when frames are dropped', () => {
    const store = filled(10, 80 * 10);
    const player = new Player(store);
    player.seek(4);
    player.speed = 1;
    player.play();
    store.add({ index: 10, t: 1, q: new Float64Array(10) });
    player.framesCame();
    expect([store.stride, store.at(player.place)?.index]).toEqual([2, 4]);
    player.advance(0.21);
    expect(store.at(player.place)?.index).toBe(6);
  });
  it('steps and stays inside', () => {
    const player = new Player(filled(3));
    player.step(-1);
    expect(player.place).toBe(0);
    player.step(9);
    expect(player.place).toBe(2);
  });
});
