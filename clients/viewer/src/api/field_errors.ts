// SPDX-License-Identifier: MIT
import type { ApiError } from './api_error';

/// What is wrong with one field of the scene. `path` is as in a scene file: "yarn.radius_m", "handles[0].where"; empty:
/// the scene as a whole, or what is around it.
export interface FieldError {
  path: string;
  message: string;
}

const sceneRoot = 'spec.scene';

function scenePath(field: string): string | undefined {
  if (field === sceneRoot) return '';
  return field.startsWith(sceneRoot + '.') ? field.slice(sceneRoot.length + 1) : undefined;
}

/// The violations of a refused request as errors of the scene; one without a path says what it is about itself.
export function fieldErrors(error: ApiError): FieldError[] {
  const errors = error.violations.map((violation) => {
    const path = scenePath(violation.field ?? '');
    const message = violation.description ?? 'is refused';
    return path === undefined ? { path: '', message: `${violation.field ?? 'the request'} ${message}` } : { path, message };
  });
  if (errors.length === 0) return [{ path: '', message: error.message }];
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
