// Prints the lengths of the paths that pages compute: page_paths.js <folder of the page> <mesh.off> <file with pairs>
// <file with faces to avoid> <file with walls>. Each line of the pairs has two locations: FACE B0 B1 B2 FACE B0 B1 B2.
// The length of the polyline is printed, too.
"use strict";
const fs = require("fs"), path = require("path");
const folder = path.resolve(process.argv[2]);
const { CutSurface } = require(path.join(folder, "cut_surface.js"));
const { ExactPath } = require(path.join(folder, "exact_path.js"));

const linesOf = (file) => fs.readFileSync(file, "utf8").split("\n").map((line) => line.replace(/#.*/, "").trim())
  .filter((line) => line !== "");
const numbersOf = (file) => linesOf(file).flatMap((line) => line.split(/[\s,;]+/).map(Number));
const lines = linesOf(process.argv[3]);
const [n, m] = lines[1].split(/\s+/).map(Number);
const points = Float64Array.from(lines.slice(2, 2 + n).flatMap((line) => line.split(/\s+/).slice(0, 3).map(Number)));
const triangles = Uint32Array.from(lines.slice(2 + n, 2 + n + m)
  .flatMap((line) => line.split(/\s+/).slice(1, 4).map(Number)));
const avoided = numbersOf(process.argv[5]), walls = numbersOf(process.argv[6]);
const surface = new CutSurface(points, triangles, avoided, walls);

linesOf(process.argv[4]).forEach((line) => {
  const x = line.split(/\s+/).map(Number);
  const search = new ExactPath.Search(surface, { face: x[0], b: x.slice(1, 4) }, { face: x[4], b: x.slice(5, 8) });
  while (!search.step(1000)) ;
  const found = search.result();
  let sum = 0;
  if (found)
    found.points.forEach((p, i) => { if (i > 0) sum += Math.hypot(...p.map((a, j) => a - found.points[i - 1][j])); });
  console.log(found ? found.length + " " + sum : "inf inf");
});
