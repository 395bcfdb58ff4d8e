// SPDX-License-Identifier: MIT
import type { FieldViolation, StatusBody } from './messages';

/// What the server refused, or that it could not be reached (status 0).
export class ApiError extends Error {
  constructor(
    readonly httpStatus: number,
    readonly body: StatusBody,
  ) {
    super(body.message || `the server answered HTTP ${httpStatus}`);
  }

  get reason(): string {
    return this.body.details?.find((detail) => detail.reason)?.reason ?? '';
  }

  get violations(): FieldViolation[] {
    return this.body.details?.flatMap((detail) => detail.field_violations ?? []) ?? [];
  }

  /// Violations that the server only counted.
  get leftOut(): number {
    const count = this.body.details?.find((detail) => detail.metadata?.violations_left_out)?.metadata;
    return Number(count?.violations_left_out ?? 0);
  }
}

/// Any body, also one that is no google.rpc.Status, as from a proxy.
export function errorFromBody(httpStatus: number, text: string): ApiError {
  try {
    const body: unknown = JSON.parse(text);
    if (typeof body === 'object' && body !== null && 'message' in body) return new ApiError(httpStatus, body as StatusBody);
  } catch {
    // Not JSON: the text below is all there is.
  }
  const message = `the server answered HTTP ${httpStatus}` + (text ? `: ${text.slice(0, 200)}` : '');
  return new ApiError(httpStatus, { message });
}
