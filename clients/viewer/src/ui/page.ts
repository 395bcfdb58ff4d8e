// SPDX-License-Identifier: MIT
/// What a route shows; `leave` ends everything that it started.
export interface Page {
  title: string;
  element: HTMLElement;
  leave(): void;
}
