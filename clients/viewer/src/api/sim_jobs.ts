// SPDX-License-Identifier: MIT
// The calls of the service SimJobs. Every one throws ApiError.
import { ApiError, errorFromBody } from './api_error';
import type { Artefact, ListSimJobsResponse, SimJob } from './messages';

const root = '/v1/simJobs';

async function request(path: string, init: RequestInit = {}): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(path, { cache: 'no-store', ...init });
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') throw error;
    throw new ApiError(0, { code: 14, message: 'the server cannot be reached' });
  }
  if (!response.ok) throw errorFromBody(response.status, await response.text());
  return response;
}

async function json<T>(path: string, method = 'GET', body?: string, signal?: AbortSignal): Promise<T> {
  const headers: Record<string, string> = body === undefined ? {} : { 'Content-Type': 'application/json' };
  const response = await request(path, { method, headers, body, signal });
  return (await response.json()) as T;
}

export type Work = 'simulate' | 'study' | 'quick study';

/// What is to be done with a scene.
export interface Order {
  work: Work;
  budget_s?: number;  // of a study; absent: none
  threads?: number;   // absent: the server's usual number
}

/// The members of a spec beside its scene, as JSON.
export function orderText({ work, budget_s, threads }: Order): string {
  const order = work === 'simulate' ? { simulate: {} } : { study: { quick: work === 'quick study' || undefined, budget_s } };
  return JSON.stringify({ ...order, threads }).slice(1, -1);
}

export interface CreateOptions {
  order?: Order;  // default: simulate
  requestId?: string;
  validateOnly?: boolean;
  signal?: AbortSignal;
}

/// `sceneText` is the text of a scene file: it goes to the server as it is, so that the server judges its numbers.
export function createSimJob(sceneText: string, options: CreateOptions = {}): Promise<SimJob> {
  const rest = { request_id: options.requestId ?? '', validate_only: options.validateOnly ?? false };
  return json(root, 'POST', `{"spec":{"scene":${sceneText},${orderText(options.order ?? { work: 'simulate' })}},${JSON.stringify(rest).slice(1)}`,
    options.signal);
}

export function getSimJob(id: string): Promise<SimJob> {
  return json(`${root}/${id}`);
}

export function listSimJobs(pageToken: string, state: string): Promise<ListSimJobsResponse> {
  const query = new URLSearchParams({ page_size: '50' });
  if (pageToken) query.set('page_token', pageToken);
  if (state) query.set('state', state);
  return json(`${root}?${query}`);
}

export function cancelSimJob(id: string): Promise<SimJob> {
  return json(`${root}/${id}:cancel`, 'POST');
}

export async function deleteSimJob(id: string): Promise<void> {
  await request(`${root}/${id}`, { method: 'DELETE' });
}

export async function listArtefacts(id: string): Promise<Artefact[]> {
  return (await json<{ artefacts?: Artefact[] }>(`${root}/${id}/artefacts`)).artefacts ?? [];
}

export function artefactAddress(id: string, file: string): string {
  return `${root}/${id}/artefacts/${encodeURIComponent(file)}`;
}

/// Where a browser shows it, as a page of no origin that runs no scripts.
export function shownArtefactAddress(id: string, file: string): string {
  return `${artefactAddress(id, file)}?inline=true`;
}

export async function artefactText(id: string, file: string): Promise<string> {
  return (await request(artefactAddress(id, file))).text();
}

export const frameFormats = ['obj', 'bcc', 'vtp', 'json'] as const;
export type FrameFormat = (typeof frameFormats)[number];

export function frameAddress(id: string, index: number, format: FrameFormat): string {
  return `${root}/${id}/frames/${index}?format=${format}`;
}

export async function frameBytes(id: string, index: number, format: FrameFormat, signal: AbortSignal): Promise<Uint8Array> {
  return new Uint8Array(await (await request(frameAddress(id, index, format), { signal })).arrayBuffer());
}

export interface StreamRange {
  firstIndex: number;
  stride: number;
}

/// A response whose body is a stream of frame records. `follow`: it stays open while the job runs.
export function openFrameStream(id: string, range: StreamRange, follow: boolean, signal: AbortSignal): Promise<Response> {
  const query = new URLSearchParams({
    first_index: String(range.firstIndex),
    stride: String(range.stride),
    follow: String(follow),
  });
  return request(`${root}/${id}/frames:stream?${query}`, { signal });
}
