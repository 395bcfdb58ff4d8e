// SPDX-License-Identifier: MIT
import { h } from './dom';

/// Gives bytes to the person as a file.
export function saveFile(name: string, data: Blob): void {
  const address = URL.createObjectURL(data);
  const link = h('a', { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
