// Prints the lengths of the paths that pages compute: page_paths.js <exact_path.js> <mesh.off> <file with pairs>. Each
// line of the file has two locations, FACE B0 B1 B2 FACE B0 B1 B2. The length of the polyline is printed, too.
"use strict";
const fs = require("fs");
const { ExactPath } = require(require("path").resolve(process.argv[2]));
const lines = fs.readFileSync(process.argv[3], "utf8").split("\n").map((line) => line.replace(/#.*/, "").trim())
  .filter((line) => line !== "");
const [n, m] = lines[1].split(/\s+/).map(Number);
const points = Float64Array.from(lines.slice(2, 2 + n).flatMap((line) => line.split(/\s+/).slice(0, 3).map(Number)));
const triangles = Uint32Array.from(lines.slice(2 + n, 2 + n + m)
  .flatMap((line) => line.split(/\s+/).slice(1, 4).map(Number)));
const surface = new ExactPath.Surface(points, triangles);
fs.readFileSync(process.argv[4], "utf8").trim().split("\n").forEach((line) => {
  const x = line.split(/\s+/).map(Number);
  const search = new ExactPath.Search(surface, { face: x[0], b: x.slice(1, 4) }, { face: x[4], b: x.slice(5, 8) });
  while (!search.step(1000)) ;
  const path = search.result();
  let sum = 0;
  if (path)
    path.points.forEach((p, i) => { if (i > 0) sum += Math.hypot(...p.map((a, j) => a - path.points[i - 1][j])); });
  console.log(path ? path.length + " " + sum : "inf inf");
});
