// SPDX-License-Identifier: MIT
// The legs of loops lie nearer to each other than yarns are thick: nodes have no thickness, and at its foot the two legs
// of a loop all but meet. To be drawn they are moved apart along the course, and where four of them share the room of two,
// in depth as well, left legs before right ones.
import { planPosts, type Post } from './posts';
import type { Fabric } from './fabric';
import { separateContact } from './separate';

/// Places along a post, evenly from its low node to its high one.
export const numLevels = 5;

export interface SpreadPlan {
  posts: readonly Post[];
  first: Int32Array;   // of every pair of neighbours the post further left
  second: Int32Array;  // ... further right
  depth: Int8Array;    // 1, -1: whether the second or the first lies before the other; 0: neither, a knit stitch beside a
                       // purl stitch, where what lies before lies behind further up
  around: Int32Array;  // of every pair two posts to its left and two to its right, which tell the course's direction
  sides: Int8Array;    // of every pair and each of its posts 1 for yarn u, 2 for v, 3 for both, 0 for a yarn alone
}

/// Kept from frame to frame: for every post and level three numbers, in m.
export interface SpreadBuffers {
  centre: Float64Array;  // between its yarns
  offset: Float64Array;  // of yarn u from there, and the opposite of v
  push: Float64Array;
  directions: Float64Array;  // of every pair: along the course and towards the face, unit vectors
}

const nearest = 0.8;  // nearer ones are moved apart ...
const beside = 0.4;   // ... along the course, ...
const before = 0.25;  // ... and in depth, were they in one place; all in diameters
const besideOnly = 1;   // along the course where depth does not help
const part = 0.4;     // of what is missing, in one round, by each of two
const rounds = 4;
const halfway = 0.7;  // of a radius: how far from its contact's middle a yarn passes there, where there is least room

const stride = 3 * numLevels;
const top = stride - 3;

/// u and v, or a yarn alone, as factors of the offset.
const factors: readonly (readonly number[])[] = [[0], [1], [-1], [1, -1]];

export function planSpread(fabric: Fabric): SpreadPlan {
  const posts: Post[] = [];
  const [first, depth, around, sides]: number[][] = [[], [], [], []];
  const kind = ({ contact }: Post): string => fabric.contacts[contact]?.kind ?? '';
  const sidesOf = ({ visits }: Post): number => visits.reduce((sum, { side }) => sum + (side > 0 ? 1 : side < 0 ? 2 : 0), 0);
  for (const row of planPosts(fabric)) {
    const at = (k: number): number => posts.length + Math.min(Math.max(k, 0), row.length - 1);
    for (let k = 0; k + 1 < row.length; ++k) {
      const [a, b] = [row[k], row[k + 1]];
      first.push(at(k));
      depth.push(a.stitch === b.stitch ? -1 : kind(a) !== kind(b) ? 0 : 1);
      around.push(at(k - 2), at(k - 1), at(k + 2), at(k + 3));
      sides.push(sidesOf(a), sidesOf(b));
    }
    posts.push(...row);
  }
  return {
    posts,
    first: Int32Array.from(first),
    second: Int32Array.from(first, (post) => post + 1),
    depth: Int8Array.from(depth),
    around: Int32Array.from(around),
    sides: Int8Array.from(sides),
  };
}

export function makeSpreadBuffers({ posts, first }: SpreadPlan): SpreadBuffers {
  const [centre, offset, push] = [0, 1, 2].map(() => new Float64Array(stride * posts.length));
  return { centre, offset, push, directions: new Float64Array(6 * first.length) };
}

const angles = Array.from({ length: numLevels }, (_, level) => (Math.PI * level) / (numLevels - 1));

function placePosts(fabric: Fabric, { posts }: SpreadPlan, q: ArrayLike<number>, { centre, offset }: SpreadBuffers): void {
  posts.forEach(({ low, high, contact }, post) => {
    const at = stride * post;
    for (let level = 0; level < numLevels; ++level) {
      const share = level / (numLevels - 1);
      for (let c = 0; c < 3; ++c) centre[at + 3 * level + c] = (1 - share) * q[3 * low + c] + share * q[3 * high + c];
    }
    if (contact < 0) return;
    const { atQ0, middle, atQ1 } = separateContact(q, fabric.contacts[contact], fabric.radius);
    const atLow = fabric.contacts[contact].q0 === low ? atQ0 : atQ1;
    angles.forEach((angle, level) => {
      for (let c = 0; c < 3; ++c) offset[at + 3 * level + c] = Math.cos(angle) * atLow[c] + halfway * Math.sin(angle) * middle[c];
    });
  });
}

function writeUnit(to: Float64Array, at: number, x: number, y: number, z: number): void {
  const length = Math.sqrt(x * x + y * y + z * z) || 1;
  to[at] = x / length;
  to[at + 1] = y / length;
  to[at + 2] = z / length;
}

function writeDirections({ first, second, around }: SpreadPlan, { centre, directions }: SpreadBuffers): void {
  const middle = top / 2;
  for (let pair = 0; pair < first.length; ++pair) {
    const at = (k: number, c: number): number => centre[stride * around[4 * pair + k] + middle + c];
    const along = (c: number): number => at(2, c) + at(3, c) - at(0, c) - at(1, c);
    const [a, b] = [stride * first[pair], stride * second[pair]];
    const up = (c: number): number => centre[a + top + c] + centre[b + top + c] - centre[a + c] - centre[b + c];
    const [x, y, z, ux, uy, uz] = [along(0), along(1), along(2), up(0), up(1), up(2)];
    writeUnit(directions, 6 * pair, x, y, z);
    writeUnit(directions, 6 * pair + 3, y * uz - z * uy, z * ux - x * uz, x * uy - y * ux);
  }
}

function pushLevel({ centre, offset, push, directions }: SpreadBuffers, a: number, b: number, factorA: number, factorB: number,
                   direction: number, depth: number, diameter: number): void {
  const x = centre[b] - centre[a] + factorB * offset[b] - factorA * offset[a];
  const y = centre[b + 1] - centre[a + 1] + factorB * offset[b + 1] - factorA * offset[a + 1];
  const z = centre[b + 2] - centre[a + 2] + factorB * offset[b + 2] - factorA * offset[a + 2];
  const square = x * x + y * y + z * z;
  const wanted = nearest * diameter;
  if (square >= wanted * wanted) return;
  const [alongCourse, inDepth] = [(depth === 0 ? besideOnly : beside) * diameter, depth * before * diameter];
  const px = x + alongCourse * directions[direction] + inDepth * directions[direction + 3];
  const py = y + alongCourse * directions[direction + 1] + inDepth * directions[direction + 4];
  const pz = z + alongCourse * directions[direction + 2] + inDepth * directions[direction + 5];
  const factor = (part * (wanted - Math.sqrt(square))) / Math.max(Math.sqrt(px * px + py * py + pz * pz), 1e-3 * diameter);
  push[a] -= factor * px;
  push[a + 1] -= factor * py;
  push[a + 2] -= factor * pz;
  push[b] += factor * px;
  push[b + 1] += factor * py;
  push[b + 2] += factor * pz;
}

/// Into `centre` and `offset`: where yarns run along each post. A continuous function of q, of nothing else.
export function spread(fabric: Fabric, plan: SpreadPlan, q: ArrayLike<number>, buffers: SpreadBuffers): void {
  const { centre, push } = buffers;
  placePosts(fabric, plan, q, buffers);
  writeDirections(plan, buffers);
  for (let round = 0; round < rounds; ++round) {
    push.fill(0);
    for (let pair = 0; pair < plan.first.length; ++pair) {
      const [a, b] = [stride * plan.first[pair], stride * plan.second[pair]];
      for (const one of factors[plan.sides[2 * pair]]) {
        for (const other of factors[plan.sides[2 * pair + 1]]) {
          for (let at = 0; at < stride; at += 3) {
            pushLevel(buffers, a + at, b + at, one, other, 6 * pair, plan.depth[pair], 2 * fabric.radius);
          }
        }
      }
    }
    for (let i = 0; i < push.length; ++i) centre[i] += push[i];
  }
}
