// SPDX-FileCopyrightText: 2026 The ESM authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// GLSL 3.30 sources of the preview. Vertex attribute 0 is the position relative to the scene's origin,
/// 1 the normal, 2 the place on the colour map; below 0 means "no value" (kNoValue) and is drawn grey.
namespace esm::shaders {

// === Background: one triangle that covers the screen, a vertical gradient, dithered against banding
inline constexpr const char* kBackgroundVertex = R"(#version 330 core
out float height;
void main() {
  vec2 corner = vec2((gl_VertexID == 1) ? 3.0 : -1.0, (gl_VertexID == 2) ? 3.0 : -1.0);
  height = 0.5 * corner.y + 0.5;
  gl_Position = vec4(corner, 1.0, 1.0);
})";
inline constexpr const char* kBackgroundFragment = R"(#version 330 core
in float height;
uniform vec3 top, bottom;
out vec4 colour;
void main() {
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  colour = vec4(mix(bottom, top, smoothstep(0.0, 1.0, height)) + (noise - 0.5) / 255.0, 1.0);
})";

// === Surface: key, fill and rim light fixed to the eye, both sides lit alike
inline constexpr const char* kSurfaceVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float value;
uniform mat4 toView, toClip;
out vec3 viewPosition, viewNormal;
out float place;
void main() {
  vec4 p = toView * vec4(position, 1.0);
  viewPosition = p.xyz;
  viewNormal = mat3(toView) * normal;
  place = value;
  gl_Position = toClip * p;
})";
inline constexpr const char* kSurfaceFragment = R"(#version 330 core
in vec3 viewPosition, viewNormal;
in float place;
uniform sampler2D colourMap;
uniform vec3 plain;
uniform bool mapped, parallel;
uniform float brightness;
out vec4 colour;
void main() {
  vec3 eye = parallel ? vec3(0.0, 0.0, 1.0) : normalize(-viewPosition);
  vec3 n = normalize(viewNormal + vec3(0.0, 0.0, 1e-12));
  if (dot(n, eye) < 0.0) n = -n;
  vec3 base = plain;
  if (mapped)
    base = place < -0.01 ? vec3(0.62) : texture(colourMap, vec2(clamp(place, 0.002, 0.998), 0.5)).rgb;
  vec3 key = normalize(vec3(-0.45, 0.62, 0.78)), fill = normalize(vec3(0.85, 0.05, 0.45));
  float light = 0.42 + 0.10 * n.y                          // sky above, floor below
              + 0.56 * max(0.0, 0.88 * dot(n, key) + 0.12) // soft at the terminator, like thick tissue
              + 0.16 * max(0.0, dot(n, fill));
  if (mapped) light = mix(light, 1.0, 0.4); // colours that mean something are shaded less
  float grazing = pow(1.0 - max(dot(n, eye), 0.0), 3.0);
  float shine = pow(max(dot(n, normalize(key + eye)), 0.0), 48.0);
  colour = vec4(brightness * (base * light + vec3((mapped ? 0.10 : 0.16) * shine + 0.10 * grazing)), 1.0);
})";

// === Lines: each becomes a quad of `width` pixels with soft edges, since core profiles draw 1 pixel only.
// Drawn twice: the covered core writes the depth buffer, the soft edge only blends over what is there.
// With distance they fade towards the background, so that front and back of a bare net can be told apart.
inline constexpr const char* kLineVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 toView, toClip;
out float viewDepth;
void main() {
  vec4 p = toView * vec4(position, 1.0);
  viewDepth = -p.z;
  gl_Position = toClip * p;
})";
inline constexpr const char* kLineGeometry = R"(#version 330 core
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;
uniform vec2 viewport;      // [pixels]
uniform float width, bias;  // [pixels], share of the depth range towards the eye
uniform samplerBuffer places;
uniform int first;
uniform bool mapped;
in float viewDepth[];
noperspective out float across;
out float depth;
flat out float place;
void corner(vec4 end, vec2 side, float offset, float endDepth) {
  across = offset;
  depth = endDepth;
  gl_Position = end + vec4(side * offset * end.w, 0.0, 0.0);
  EmitVertex();
}
void main() {
  vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;
  float za = viewDepth[0], zb = viewDepth[1];
  float da = a.z + a.w, db = b.z + b.w; // before the near plane where negative
  if (da <= 0.0 && db <= 0.0) return;
  if (da < 0.0) { a = mix(a, b, da / (da - db)); za = mix(za, zb, da / (da - db)); }
  if (db < 0.0) { b = mix(b, a, db / (db - da)); zb = mix(zb, za, db / (db - da)); }
  vec2 along = (b.xy / b.w - a.xy / a.w) * viewport;
  float size = length(along);
  along = size > 1e-6 ? along / size : vec2(1.0, 0.0);
  float reach = 0.5 * width + 1.0;
  vec2 side = vec2(-along.y, along.x) * 2.0 / viewport; // of one pixel, in clip space
  place = mapped ? texelFetch(places, first + gl_PrimitiveIDIn).r : 0.0;
  a.z -= bias * a.w;
  b.z -= bias * b.w;
  corner(a, side, -reach, za);
  corner(a, side, reach, za);
  corner(b, side, -reach, zb);
  corner(b, side, reach, zb);
})";
inline constexpr const char* kLineFragment = R"(#version 330 core
noperspective in float across;
in float depth;
flat in float place;
uniform sampler2D colourMap;
uniform vec3 plain, fogColour;
uniform vec3 fog; // begins at, is full at [m], strength when full
uniform float width, alpha, brightness, lift;
uniform bool mapped, coreOnly, edgeOnly;
out vec4 colour;
void main() {
  float cover = clamp(0.5 * width + 0.5 - abs(across), 0.0, 1.0);
  bool core = cover > 0.7;
  if (cover <= 0.0 || (coreOnly && !core) || (edgeOnly && core)) discard;
  vec3 base = plain;
  if (mapped)
    base = place < -0.01 ? vec3(0.62) : texture(colourMap, vec2(clamp(place, 0.002, 0.998), 0.5)).rgb;
  base = mix(base * brightness, vec3(1.0), lift);
  base = mix(base, fogColour, fog.z * clamp((depth - fog.x) / (fog.y - fog.x), 0.0, 1.0));
  colour = vec4(base, alpha * cover);
})";

// === Points: round, with a rim
inline constexpr const char* kPointVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 toView, toClip;
uniform float size, bias;
void main() {
  gl_Position = toClip * (toView * vec4(position, 1.0));
  gl_Position.z -= bias * gl_Position.w;
  gl_PointSize = size;
})";
inline constexpr const char* kPointFragment = R"(#version 330 core
uniform vec3 plain, rim;
uniform float size;
out vec4 colour;
void main() {
  float radius = length(gl_PointCoord - 0.5) * size; // [pixels]
  float cover = clamp(0.5 * size - radius, 0.0, 1.0);
  if (cover <= 0.0) discard;
  colour = vec4(mix(plain, rim, clamp(radius - 0.5 * size + 1.6, 0.0, 1.0)), cover);
})";

} // namespace esm::shaders
