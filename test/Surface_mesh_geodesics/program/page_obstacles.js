// Checks a page with obstacles: page_obstacles.js <page.html> <x> <top> <low>. The surface is the unit square with a
// source at (0, 0), a wall from (x, 0) to (x, top) or none if `top` is 0, and faces to avoid in the corner with
// coordinates from `low` on. So a shortest path is a segment, or two that meet at the end of the wall; if `top` is 1, no
// path leads behind the wall. Prints what is wrong, and exits with 1 then.
"use strict";
const fs = require("fs");
const [x, top, low] = process.argv.slice(3).map(Number);
const text = fs.readFileSync(process.argv[2], "utf8");
const data = JSON.parse(text.match(/<script id="data" type="application\/json">(.*?)<\/script>/)[1]);
const EPSILON = 2e-6; // coordinates and distances have 32 bits

function bytes(code) {
  const buffer = Buffer.from(code, "base64");
  return buffer.buffer.slice(buffer.byteOffset, buffer.byteOffset + buffer.length);
}
const floats = (code) => new Float32Array(bytes(code)), indices = (code) => new Uint32Array(bytes(code));
function pointsOf(code) {
  const xyz = floats(code);
  return Array.from({ length: xyz.length / 3 }, (_, i) => [0, 1].map((k) => xyz[3 * i + k] + data.center[k]));
}
function check(isRight, what) {
  if (isRight) return;
  console.log("wrong: " + what);
  process.exit(1);
}

// The distance of a point, as it is on the side of the wall where `near` is.
function distance([a, b], near) {
  if (top === 1 && near[0] > x) return Infinity;
  const isBehind = near[0] > x && b * x < top * a - 1e-12;
  return isBehind ? Math.hypot(x, top) + Math.hypot(a - x, b - top) : Math.hypot(a, b);
}
const middle = (corners) => [0, 1].map((k) => corners.reduce((sum, p) => sum + p[k], 0) / corners.length);
const isInside = (p) => p[0] > low + EPSILON && p[1] > low + EPSILON;

// Triangles: each corner has the distance on the side of its triangle, but those to avoid are listed.
const points = pointsOf(data.points), triangles = indices(data.triangles), distances = floats(data.distances);
const avoided = new Set(indices(data.avoided));
let numberBehind = 0;
for (let t = 0; 3 * t < triangles.length; ++t) {
  const ids = [...triangles.slice(3 * t, 3 * t + 3)], corners = ids.map((v) => points[v]), near = middle(corners);
  check(avoided.has(t) === isInside(near), "triangle " + t + " at " + near + (avoided.has(t) ? " avoided" : ""));
  if (avoided.has(t)) continue;
  if (distance(near, near) > Math.hypot(...near)) ++numberBehind;
  ids.forEach((v, k) => {
    const expected = distance(corners[k], near);
    check(distances[v] === expected || Math.abs(distances[v] - expected) < EPSILON,
      "distance " + distances[v] + " instead of " + expected + " at " + corners[k] + " near " + near);
  });
}
check(avoided.size > 0 && (numberBehind > 0) === (top > 0), "no triangle avoided, or none behind the wall");

// The mesh of the file, for paths: its faces and the ends of the wall.
const vertices = pointsOf(data.mesh.points), walls = indices(data.walls || "");
const corners = indices(data.mesh.triangles);
const faces = indices(data.mesh.avoided);
check(faces.every((f) => isInside(middle([0, 1, 2].map((k) => vertices[corners[3 * f + k]])))), "faces to avoid");
check(walls.every((v) => Math.abs(vertices[v][0] - x) < EPSILON && vertices[v][1] < top + EPSILON), "ends of walls");

// Lines do not cross the wall, nor the faces. Isolines end at the wall on both of its sides.
const roles = data.lines.map((group) => group.role);
check(roles.includes("isoline") || top === 0 || data.cells !== undefined, "there are no isolines");
check(roles.includes("wall") === (top > 0) && (walls.length > 0) === (top > 0), "roles are " + roles);
data.lines.forEach(({ role, lengths, points: code }) => {
  const all = pointsOf(code);
  let i = 0, height = 0, left = 0, right = 0;
  indices(lengths).forEach((n) => {
    for (let k = 0; k + 1 < n; ++k) {
      const p = all[i + k], q = all[i + k + 1];
      check(!isInside(middle([p, q])), role + " in faces to avoid, at " + p + " and " + q);
      const [a, b] = [p, q].map(([u]) => (Math.abs(u - x) < EPSILON ? 0 : u - x)), isLow = Math.min(p[1], q[1]) < top;
      if (role === "wall") {
        check(a === 0 && b === 0 && Math.max(p[1], q[1]) < top + EPSILON, "wall at " + p + " and " + q);
        height += Math.abs(p[1] - q[1]);
      } else {
        check(a * b >= 0 || (p[1] * b - q[1] * a) / (b - a) > top - EPSILON, role + " across the wall at " + p);
        if (isLow && a * b === 0 && a + b < 0) ++left;
        if (isLow && a * b === 0 && a + b > 0) ++right;
      }
    }
    i += n;
  });
  if (role === "wall") check(Math.abs(height - top) < EPSILON, "the wall has the height " + height);
  if (role === "isoline") check(left > 2 && (right > 2) === (top < 1), left + " and " + right + " ends of isolines at the wall");
});
