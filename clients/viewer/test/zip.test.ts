// SPDX-License-Identifier: MIT
import { expect, it } from 'vitest';
import { crc32, zip, type ZipEntry } from '../src/jobs/zip';

/// Reads an archive by its directory, as unpackers do.
function unzip(archive: Uint8Array): ZipEntry[] {
  const view = new DataView(archive.buffer, archive.byteOffset);
  const tail = archive.length - 22;
  expect(view.getUint32(tail, true)).toBe(0x06054b50);
  let at = view.getUint32(tail + 16, true);
  const text = (from: number, length: number): string => new TextDecoder().decode(archive.subarray(from, from + length));
  const entries = Array.from({ length: view.getUint16(tail + 10, true) }, () => {
    expect(view.getUint32(at, true)).toBe(0x02014b50);
    const [size, nameLength, local] = [view.getUint32(at + 24, true), view.getUint16(at + 28, true), view.getUint32(at + 42, true)];
    const name = text(at + 46, nameLength);
    const checksum = view.getUint32(at + 16, true);
    at += 46 + nameLength;
    expect(view.getUint32(local, true)).toBe(0x04034b50);
    expect([view.getUint32(local + 14, true), view.getUint32(local + 18, true), text(local + 30, nameLength)]).toEqual([checksum, size, name]);
    const bytes = archive.slice(local + 30 + nameLength, local + 30 + nameLength + size);
    expect(crc32(bytes)).toBe(checksum);
    return { name, bytes };
  });
  expect(at).toBe(tail);
  return entries;
}

it('has the checksum of the standard', () => expect(crc32(new TextEncoder().encode('123456789'))).toBe(0xcbf43926));

it('makes archives that can be read', () => {
  const entries = [{ name: 'a.txt', bytes: new TextEncoder().encode('one\n') }, { name: 'ü.bin', bytes: Uint8Array.of(0, 255) }];
  expect(unzip(new Uint8Array(Buffer.concat(zip(entries))))).toEqual(entries);
});
