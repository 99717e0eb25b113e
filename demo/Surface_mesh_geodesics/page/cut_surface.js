// The surface on which paths run, cut along what they avoid. Requires nothing but arrays.
//
// Faces to avoid are left out. Each edge of a wall becomes two edges of the border, one for each side, and a vertex
// becomes one vertex for each sector of its faces between walls: a path that touches it may go on in its sector only. A
// path crosses no wall exactly if it is a path of this surface. Faces and halfedges keep their numbers.
(function (root) {
  "use strict";

  // The connections of the triangles. Halfedge 3 f + k leads from corner k of face f to the next one.
  class CutSurface {
    // `avoided` has faces, and `walls` pairs of vertices that edges join.
    constructor(points, triangles, avoided = [], walls = []) {
      this.points = points;
      this.triangles = triangles;
      const m = triangles.length;
      this.isAvoided = new Uint8Array(m / 3);
      avoided.forEach((f) => { this.isAvoided[f] = 1; });
      this.listLeaving();
      this.twin = new Int32Array(m).fill(-1);
      this.length = new Float64Array(m);
      for (let h = 0; h < m; ++h) {
        const u = this.source(h), v = this.target(h);
        this.length[h] = this.distance(u, v);
        if (!this.isLeftOut(h)) this.twin[h] = this.halfedge(v, u);
      }
      this.behind = new Map(); // from a halfedge of a wall to that of the face on the other side
      this.copies = new Map(); // from a vertex that walls divide, or one of its parts, to all of the parts
      if (walls.length > 0) this.cutAlong(walls);
      this.isRoot = this.verticesWherePathsBend();
    }

    // The halfedges that leave vertex v: from leaving[first[v]] on.
    listLeaving() {
      const { triangles } = this, n = this.points.length / 3, m = triangles.length;
      this.first = new Uint32Array(n + 1);
      for (let h = 0; h < m; ++h) if (!this.isLeftOut(h)) ++this.first[triangles[h] + 1];
      for (let v = 0; v < n; ++v) this.first[v + 1] += this.first[v];
      const next = this.first.slice(0, n);
      this.leaving = new Uint32Array(this.first[n]);
      for (let h = 0; h < m; ++h) if (!this.isLeftOut(h)) this.leaving[next[triangles[h]]++] = h;
    }

    isLeftOut(h) { return this.isAvoided[Math.floor(h / 3)] === 1; }

    // The halfedge from one vertex to another, or -1.
    halfedge(u, v) {
      let result = -1;
      for (let i = this.first[u]; i < this.first[u + 1]; ++i)
        if (this.target(this.leaving[i]) === v) result = this.leaving[i];
      return result;
    }

    // --- walls -------------------------------------------------------------------------------------------------------

    cutAlong(walls) {
      const ends = [...new Set(walls)], before = ends.map((v) => this.sectors(v).length), cut = [];
      for (let i = 0; i < walls.length; i += 2) {
        const h = this.halfedge(walls[i], walls[i + 1]);
        if (h >= 0 && this.twin[h] >= 0) cut.push(h, this.twin[h]);
      }
      cut.forEach((h) => this.behind.set(h, this.twin[h]));
      cut.forEach((h) => { this.twin[h] = -1; });
      this.triangles = this.triangles.slice();
      const sources = []; // of the parts of vertices that are new
      ends.forEach((v, i) => {
        const sectors = this.sectors(v);
        if (sectors.length === before[i]) return; // also where faces to avoid touch at v: paths pass between them
        const parts = sectors.map((sector, j) => (j === 0 ? v : this.points.length / 3 + sources.push(v) - 1));
        parts.forEach((part, j) => {
          sectors[j].forEach((h) => { this.triangles[h] = part; });
          this.copies.set(part, parts);
        });
      });
      const points = new this.points.constructor(this.points.length + 3 * sources.length);
      points.set(this.points);
      sources.forEach((v, i) => points.set(this.point(v), this.points.length + 3 * i));
      this.points = points;
      this.listLeaving();
    }

    // The halfedges that leave a vertex, in groups whose faces are connected around it.
    sectors(v) {
      const rest = new Set(this.leaving.slice(this.first[v], this.first[v + 1])), result = [];
      const nextLeft = (h) => this.twin[this.prev(h)];
      const nextRight = (h) => (this.twin[h] < 0 ? -1 : this.next(this.twin[h]));
      for (const h of rest) {
        const sector = [h];
        rest.delete(h);
        [nextLeft, nextRight].forEach((neighbor) => {
          for (let g = neighbor(h); g >= 0 && rest.delete(g); g = neighbor(g)) sector.push(g);
        });
        result.push(sector);
      }
      return result;
    }

    // A location on each side of the walls there; none inside of what is avoided.
    sides(location) {
      const { face, b } = location, zero = b.map((x) => x === 0), number = zero.filter(Boolean).length;
      if (this.isAvoided[face]) return [];
      if (number === 1) {
        const h = 3 * face + (zero.indexOf(true) + 1) % 3;
        return this.behind.has(h) ? [location, this.across(this.behind.get(h), b[h % 3])] : [location];
      }
      const v = number === 2 ? this.triangles[3 * face + zero.indexOf(false)] : -1;
      if (!this.copies.has(v)) return [location];
      return this.copies.get(v).map((part) => this.across(this.leaving[this.first[part]], 0));
    }

    // The point of a halfedge with a weight for its target.
    across(h, weight) {
      const b = [0, 0, 0];
      b[h % 3] = 1 - weight;
      b[(h + 1) % 3] = weight;
      return { face: Math.floor(h / 3), b };
    }

    // --- connections and shapes --------------------------------------------------------------------------------------

    next(h) { return h % 3 === 2 ? h - 2 : h + 1; }
    prev(h) { return h % 3 === 0 ? h + 2 : h - 1; }
    source(h) { return this.triangles[h]; }
    target(h) { return this.triangles[this.next(h)]; }
    corners(face) { return [0, 1, 2].map((k) => this.triangles[3 * face + k]); }
    point(v) { return [this.points[3 * v], this.points[3 * v + 1], this.points[3 * v + 2]]; }

    distance(u, v) {
      const p = this.points;
      return Math.hypot(p[3 * u] - p[3 * v], p[3 * u + 1] - p[3 * v + 1], p[3 * u + 2] - p[3 * v + 2]);
    }

    distanceTo(v, q) {
      const p = this.points;
      return Math.hypot(p[3 * v] - q[0], p[3 * v + 1] - q[1], p[3 * v + 2] - q[2]);
    }

    // The corner opposite a halfedge, in the frame with the halfedge on the first axis. A face without height gets a
    // small one: windows cross it on the right side of the corner, and lengths change by a part of 10^-9 at most.
    apex(h) {
      const p = this.points, u = 3 * this.source(h), v = 3 * this.target(h), w = 3 * this.source(this.prev(h));
      const ex = p[v] - p[u], ey = p[v + 1] - p[u + 1], ez = p[v + 2] - p[u + 2];
      const ax = p[w] - p[u], ay = p[w + 1] - p[u + 1], az = p[w + 2] - p[u + 2], length = this.length[h];
      const height = Math.hypot(ey * az - ez * ay, ez * ax - ex * az, ex * ay - ey * ax) / length;
      return [(ex * ax + ey * ay + ez * az) / length, Math.max(height, 1e-9 * length)];
    }

    // Where the angles around a vertex sum up to 360 degrees or more, and on the border.
    verticesWherePathsBend() {
      const n = this.points.length / 3, angle = new Float64Array(n), result = new Uint8Array(n);
      for (let h = 0; h < this.twin.length; ++h) {
        if (this.isLeftOut(h)) continue;
        const a = this.length[h], b = this.length[this.prev(h)], c = this.length[this.next(h)];
        angle[this.source(h)] += Math.acos(Math.min(Math.max((a * a + b * b - c * c) / (2 * a * b), -1), 1));
        if (this.twin[h] < 0) result[this.source(h)] = result[this.target(h)] = 1;
      }
      for (let v = 0; v < n; ++v) if (angle[v] > 2 * Math.PI - 1e-6) result[v] = 1;
      return result;
    }

    pointAt(face, b) {
      const result = [0, 0, 0];
      for (let k = 0; k < 3; ++k)
        for (let j = 0; j < 3; ++j) result[j] += b[k] * this.points[3 * this.triangles[3 * face + k] + j];
      return result;
    }
  }

  root.CutSurface = CutSurface;
})(typeof module === "undefined" ? window : module.exports);
