// SPDX-License-Identifier: MIT
// One instance is a piece of yarn between two drawn points: the half of a tube that faces the camera, expanded here from
// four successive points. Its cross-sections depend on their own point only, so neighbours meet without a gap.

export const tubeVertexShader = /* glsl */ `
in vec4 before;
in vec4 start;
in vec4 finish;
in vec4 behind;
in float lengthHere;
in float mark;
in float thickHere;
in float thickNext;
uniform float radius;
uniform float lowest;
uniform float highest;
out vec3 surfaceNormal;
out vec3 toCamera;
out float value;
flat out float known;   // 1 where both ends have a value: in between there is no half of one
out float marked;
out vec2 ply;       // length along the yarn in radii, angle around it

void main() {
  float end = position.y;
  vec4 here = mix(start, finish, end);
  vec3 tangent = end < 0.5 ? finish.xyz - before.xyz : behind.xyz - start.xyz;
  tangent = normalize(tangent + vec3(1e-12));
  vec3 eye = normalize(cameraPosition - here.xyz);
  vec3 side = cross(tangent, eye);
  float sine = length(side);
  side = sine > 1e-4 ? side / sine : normalize(cross(tangent, vec3(0.31, 0.87, 0.39)));
  vec3 up = cross(side, tangent);
  float angle = position.x * 1.6;
  surfaceNormal = sin(angle) * side + cos(angle) * up;
  vec3 surface = here.xyz + radius * mix(thickHere, thickNext, end) * surfaceNormal;
  toCamera = cameraPosition - surface;
  known = min(start.w, finish.w) < -1e29 ? 0.0 : 1.0;
  value = clamp((here.w - lowest) / (highest - lowest), 0.0, 1.0);
  marked = mark;
  ply = vec2((lengthHere + end * distance(start.xyz, finish.xyz)) / radius, angle);
  gl_Position = projectionMatrix * viewMatrix * vec4(surface, 1.0);
  if (lengthHere < 0.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // between two yarns: outside the picture
}
`;

export const tubeFragmentShader = /* glsl */ `
precision highp float;
in vec3 surfaceNormal;
in vec3 toCamera;
in float value;
flat in float known;
in float marked;
in vec2 ply;
uniform sampler2D colours;
uniform vec3 yarnColour;
uniform vec3 lightFrom;
uniform float useColours;
out vec4 fragment;

vec3 linear(vec3 colour) { return pow(colour, vec3(2.2)); }

void main() {
  vec3 eye = normalize(toCamera);
  // Twisted plies: grooves that wind around the yarn.
  float twist = ply.x * 0.9 + 2.0 * ply.y;
  float groove = 0.5 + 0.5 * cos(twist * 2.0);
  vec3 along = normalize(cross(surfaceNormal, eye) + vec3(1e-6));
  vec3 normal = normalize(surfaceNormal + 0.16 * sin(twist * 2.0) * along);
  float facing = clamp(dot(surfaceNormal, eye), 0.0, 1.0);
  float light = clamp(dot(normal, lightFrom), 0.0, 1.0);
  float sky = 0.5 + 0.5 * normal.y;
  // Yarn lies against yarn where it turns away from the eye: darker there, which is what tells loops apart.
  float occlusion = mix(0.16, 1.0, smoothstep(0.0, 0.75, facing)) * (0.86 + 0.14 * groove);
  vec3 base = yarnColour;
  if (useColours > 0.5) base = known < 0.5 ? vec3(0.45) : linear(texture(colours, vec2(value, 0.5)).rgb);
  base = mix(base, vec3(0.95, 0.12, 0.45), 0.75 * marked);
  vec3 lit = base * occlusion * (0.34 + 0.2 * sky + 0.62 * light);
  fragment = vec4(pow(lit, vec3(1.0 / 2.2)), 1.0);
}
`;
