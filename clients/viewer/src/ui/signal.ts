// SPDX-License-Identifier: MIT

/// A value and those who want to know when it changes.
export class Signal<T> {
  private readonly listeners = new Set<(value: T) => void>();

  constructor(private current: T) {}

  get value(): T {
    return this.current;
  }

  set(value: T): void {
    if (Object.is(value, this.current)) return;
    this.current = value;
    this.notify();
  }

  /// The same value has changed inside.
  notify(): void {
    for (const listener of [...this.listeners]) listener(this.current);
  }

  /// Calls at once and on every change, until the answer is called.
  subscribe(listener: (value: T) => void): () => void {
    this.listeners.add(listener);
    listener(this.current);
    return () => this.listeners.delete(listener);
  }
}
