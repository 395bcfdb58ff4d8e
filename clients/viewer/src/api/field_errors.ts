// SPDX-License-Identifier: MIT
import type { ApiError } from './api_error';

/// What is wrong with one field. `path` is as in a scene file: "yarn.radius_m", "handles[0].where"; of a field that is not
/// in the scene its label; empty: the scene as a whole, or what is around it.
export interface FieldError {
  path: string;
  message: string;
  about?: 'order' | 'server';  // rather than the scene: what is to be done with it, or the way there
}

/// Labels of the fields beside the scene.
export const orderLabels = { work: 'Work', budget: 'Budget in s', threads: 'Threads' } as const;

const sceneRoot = 'spec.scene';
const orderPaths: Readonly<Record<string, string>> = {
  'spec.work': orderLabels.work,
  'spec.study.budget_s': orderLabels.budget,
  'spec.threads': orderLabels.threads,
};

function scenePath(field: string): string | undefined {
  if (field === sceneRoot) return '';
  return field.startsWith(sceneRoot + '.') ? field.slice(sceneRoot.length + 1) : undefined;
}

function errorOf(field: string, message: string): FieldError {
  const path = scenePath(field);
  if (path !== undefined) return { path, message };
  if (Object.hasOwn(orderPaths, field)) return { path: orderPaths[field], message, about: 'order' };
  return { path: '', message: `${field} ${message}`, about: 'server' };
}

/// The violations of a refused request; one without a path says what it is about itself.
export function fieldErrors(error: ApiError): FieldError[] {
  const errors = error.violations.map(({ field, description }) => errorOf(field ?? 'the request', description ?? 'is refused'));
  if (errors.length === 0) return [{ path: '', message: error.message, about: 'server' }];
  if (error.leftOut > 0) errors.push({ path: '', message: `and ${error.leftOut} more` });
  return errors;
}

/// The place itself, then each place around it, innermost first: "a.b[2].c", "a.b[2]", "a.b", "a", "".
export function pathAndAncestors(path: string): string[] {
  const paths = [path];
  for (let at = path.length - 1; at > 0; --at) {
    if (path[at] === '.' || path[at] === '[') paths.push(path.slice(0, at));
  }
  if (path !== '') paths.push('');
  return paths;
}

/// Where to show an error: at its own place, else at the nearest place around it that is shown; '' is the summary.
export function placeOf(path: string, isShown: (path: string) => boolean): string {
  return pathAndAncestors(path).find((candidate) => candidate === '' || isShown(candidate)) ?? '';
}
