// SPDX-License-Identifier: MIT
import gifenc from 'gifenc';

const { GIFEncoder, applyPalette, quantize } = gifenc;
const see = 0;  // palette entry that lets the frame before show through

/// Pixels that are (nearly) those of the frame before let it show: long runs of one value, which GIF packs well.
function withHoles(pixels, before, indices) {
  const holed = new Uint8Array(indices.length);
  for (let i = 0; i < indices.length; ++i) {
    const same = before && Math.abs(pixels[4 * i] - before[4 * i]) + Math.abs(pixels[4 * i + 1] - before[4 * i + 1]) +
      Math.abs(pixels[4 * i + 2] - before[4 * i + 2]) < 12;
    holed[i] = same ? see : indices[i] + 1;
  }
  return holed;
}

function encode(frames, { width, height, framesPerSecond }, colours) {
  // One palette from a few frames spread over all of them.
  const sample = new Uint8Array(frames.filter((_, index) => index % Math.ceil(frames.length / 6) === 0).flatMap((frame) => [...frame]));
  const palette = quantize(sample, colours - 1);
  const gif = GIFEncoder();
  let shown;
  frames.forEach((frame, index) => {
    const indices = withHoles(frame, shown, applyPalette(frame, palette));
    // What is shown from here on: the new frame, but for the holes.
    shown = shown ? shown.slice() : frame.slice();
    for (let i = 0; i < indices.length; ++i) if (indices[i] !== see) shown.set(frame.subarray(4 * i, 4 * i + 4), 4 * i);
    const delay = index === frames.length - 1 ? 1500 : 1000 / framesPerSecond;
    gif.writeFrame(indices, width, height, { palette: index === 0 ? [[0, 0, 0], ...palette] : undefined, delay, transparent: true, transparentIndex: see, dispose: 1 });
  });
  gif.finish();
  return gif.bytes();
}

/// Frames of RGBA pixels as an animated GIF with as many colours as `mostBytes` allow.
export function animation(frames, look, mostBytes) {
  for (const colours of [256, 128, 64, 32, 16]) {
    const bytes = encode(frames, look, colours);
    if (bytes.length <= mostBytes) return bytes;
  }
  throw new Error(`the animation does not fit into ${mostBytes} bytes`);
}
