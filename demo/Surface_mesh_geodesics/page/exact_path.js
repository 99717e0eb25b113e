// Exact shortest paths between two points of the surface, computed in the page. Requires a CutSurface.
//
// Windows are propagated from the source across the edges, as in the algorithm of Chen and Han with the improvements of
// Xin and Wang: a queue with the nearest windows first, distances at vertices that reject windows, and two children of
// a window only where it gives the vertex opposite its edge the smallest distance. Since there is one target, windows
// are left out whose shortest way to it is longer than a path that is known; the first one follows edges.
(function (root) {
  "use strict";

  const EPSILON = 1e-12;

  // A binary heap of numbers with keys.
  class Queue {
    constructor() { this.keys = []; this.items = []; }
    get size() { return this.keys.length; }
    push(key, item) {
      const { keys, items } = this;
      let i = keys.length;
      keys.push(key);
      items.push(item);
      while (i > 0) {
        const up = (i - 1) >> 1;
        if (keys[up] <= key) break;
        keys[i] = keys[up];
        items[i] = items[up];
        i = up;
      }
      keys[i] = key;
      items[i] = item;
    }
    pop() {
      const { keys, items } = this, result = items[0], key = keys.pop(), item = items.pop(), n = keys.length;
      let i = 0;
      if (n === 0) return result;
      for (let down = 1; down < n; down = 2 * i + 1) {
        if (down + 1 < n && keys[down + 1] < keys[down]) ++down;
        if (keys[down] >= key) break;
        keys[i] = keys[down];
        items[i] = items[down];
        i = down;
      }
      keys[i] = key;
      items[i] = item;
      return result;
    }
  }

  // One search. step() works for some time and returns true when the path is known.
  class Search {
    // `source` and `target` are { face, b } with barycentric coordinates. On a wall they are on all of its sides.
    constructor(surface, source, target) {
      const n = surface.points.length / 3;
      const [sources, targets] = [source, target].map((location) => surface.sides(exactly(location)));
      Object.assign(this, { surface, sources, queue: new Queue() });
      this.sourcePoint = surface.pointAt(source.face, exactly(source).b);
      this.targetPoint = surface.pointAt(target.face, exactly(target).b);
      this.facesOfTarget = targets.flatMap((t) => this.facesAt(t));
      this.cornersOfTarget = targets.flatMap((t) => surface.corners(t.face));
      this.distance = new Float64Array(n).fill(Infinity);
      this.from = new Array(n).fill(null); // how the path reaches a vertex
      this.bestAtApex = new Float64Array(surface.twin.length).fill(Infinity);
      this.placeAtApex = new Float64Array(surface.twin.length);
      this.windows = [];
      this.best = Infinity;
      this.bestPath = null; // an array of points, or how to find them
      this.numberOfWindows = 0;
      this.begin();
    }

    begin() {
      const { surface } = this;
      this.boundByEdges();
      const faces = this.sources.flatMap((s) => this.facesAt(s));
      this.facesOfTarget.forEach((t) => faces.forEach((s) => {
        if (s.face === t.face) this.offer(distance(this.sourcePoint, this.targetPoint), { kind: "source" });
      }));
      faces.forEach(({ face, b }) => {
        for (let k = 0; k < 3; ++k) {
          const h = 3 * face + k;
          this.reach(surface.triangles[h], surface.distanceTo(surface.triangles[h], this.sourcePoint),
            { kind: "source" });
          if (b[(k + 2) % 3] > 0) this.addWholeEdge(h, this.planePoint(h, b), 0, -1);
        }
      });
      this.sources.forEach((s) => {
        const vertex = s.b.indexOf(1);
        if (vertex >= 0) this.spread(surface.triangles[3 * s.face + vertex]);
      });
    }

    // The location in each face that has it: two on an edge, several at a vertex.
    facesAt(location) {
      const { surface } = this, { face, b } = location, result = [location], zero = b.map((x) => x === 0);
      const number = zero.filter(Boolean).length;
      if (number === 1) {
        const h = 3 * face + (zero.indexOf(true) + 1) % 3, twin = surface.twin[h];
        if (twin >= 0) result.push(surface.across(twin, b[h % 3]));
      } else if (number === 2) {
        const v = surface.triangles[3 * face + zero.indexOf(false)];
        result.length = 0;
        for (let i = surface.first[v]; i < surface.first[v + 1]; ++i)
          result.push(surface.across(surface.leaving[i], 0));
      }
      return result;
    }

    // A point of the face of h in the frame of h.
    planePoint(h, b) {
      const apex = this.surface.apex(h);
      return [b[(h + 1) % 3] * this.surface.length[h] + b[(h + 2) % 3] * apex[0], b[(h + 2) % 3] * apex[1]];
    }

    // Dijkstra's algorithm along edges: a path that is not too long bounds the search.
    boundByEdges() {
      const { surface, targetPoint } = this, n = surface.points.length / 3;
      const d = new Float64Array(n).fill(Infinity), before = new Int32Array(n).fill(-1), queue = new Queue();
      const offer = (v, x, u) => {
        if (x >= d[v]) return;
        d[v] = x;
        before[v] = u;
        queue.push(x + surface.distanceTo(v, targetPoint), v);
      };
      this.sources.forEach((s) => surface.corners(s.face)
        .forEach((v) => offer(v, surface.distanceTo(v, this.sourcePoint), -1)));
      const isDone = new Uint8Array(n);
      let last = -1;
      while (queue.size > 0) {
        const key = queue.keys[0], v = queue.pop();
        if (isDone[v]) continue;
        if (key >= this.best) break;
        isDone[v] = 1;
        if (this.cornersOfTarget.includes(v)) {
          const whole = d[v] + surface.distanceTo(v, targetPoint);
          if (whole < this.best) { this.best = whole; last = v; }
        }
        for (let i = surface.first[v]; i < surface.first[v + 1]; ++i) {
          const h = surface.leaving[i], into = surface.prev(h);
          offer(surface.target(h), d[v] + surface.length[h], v);
          offer(surface.source(into), d[v] + surface.length[into], v);
        }
      }
      this.bestPath = [this.targetPoint];
      for (let v = last; v >= 0; v = before[v]) this.bestPath.push(surface.point(v));
      this.bestPath.push(this.sourcePoint);
    }

    offer(d, how) {
      if (!(d < this.best * (1 - EPSILON))) return;
      this.best = d;
      this.bestPath = how;
    }

    // A path with the length d leads to vertex v.
    reach(v, d, how) {
      if (!(d < this.distance[v])) return;
      const { surface } = this;
      this.distance[v] = d;
      this.from[v] = how;
      const rest = surface.distanceTo(v, this.targetPoint);
      if (this.cornersOfTarget.includes(v))
        this.offer(d + rest, { kind: "vertex", vertex: v });
      if (surface.isRoot[v] && d + rest < this.best) this.queue.push(d + rest, { vertex: v, distance: d });
    }

    // Paths go on from a vertex: along its edges and through its faces.
    spread(v) {
      const { surface } = this, d = this.distance[v];
      for (let i = surface.first[v]; i < surface.first[v + 1]; ++i) {
        const h = surface.leaving[i], across = surface.next(h), into = surface.prev(h);
        this.reach(surface.target(h), d + surface.length[h], { kind: "vertex", vertex: v });
        this.reach(surface.source(into), d + surface.length[into], { kind: "vertex", vertex: v });
        this.addWholeEdge(across, surface.apex(across), d, v);
      }
    }

    // The source of a window is a point of the face of h, seen from the other side of the edge.
    addWholeEdge(h, p, sigma, vertex) {
      const { surface } = this, twin = surface.twin[h];
      if (twin < 0 || !(p[1] > 0)) return;
      this.add(twin, 0, surface.length[h], surface.length[h] - p[0], -p[1], sigma, -1, vertex);
    }

    // A window on halfedge h, from b0 to b1, will enter the face of h. Its source is at (x, y), below the edge.
    add(h, b0, b1, x, y, sigma, parent, vertex) {
      const { surface, distance } = this, length = surface.length[h];
      if (!(b1 - b0 > EPSILON * length)) return;
      const d0 = sigma + Math.hypot(b0 - x, y), d1 = sigma + Math.hypot(b1 - x, y), most = 1 + EPSILON;
      if (distance[surface.source(h)] + b1 < d1 / most || distance[surface.target(h)] + length - b0 < d0 / most)
        return; // one of the two vertices gives every point of the window a smaller distance
      const near = Math.min(Math.max(x, b0), b1), nearest = sigma + Math.hypot(near - x, y);
      const key = Math.max(nearest + this.rest(h, b0, b1), nearest);
      if (key >= this.best) return;
      const w = { h, b0, b1, x, y, sigma, parent, vertex };
      this.facesOfTarget.forEach((t) => { if (Math.floor(h / 3) === t.face) this.arrive(w, t.b); });
      this.windows.push(w);
      this.queue.push(key, { window: this.windows.length - 1 });
    }

    // No point of a part of an edge is nearer to the target than this.
    rest(h, b0, b1) {
      const p = this.surface.point(this.surface.source(h)), q = this.surface.point(this.surface.target(h));
      const t = (b0 + b1) / 2 / this.surface.length[h];
      return Math.max(distance(this.targetPoint, p.map((a, j) => a + t * (q[j] - a))) - (b1 - b0) / 2, 0) * (1 - 1e-9);
    }

    // Does the straight line from the source of the window to the target cross the window?
    arrive(w, b) {
      const t = this.planePoint(w.h, b), x = crossing(w, t), slack = 1e-9 * this.surface.length[w.h];
      if (x >= w.b0 - slack && x <= w.b1 + slack)
        this.offer(w.sigma + Math.hypot(t[0] - w.x, t[1] - w.y), { kind: "window", window: w, point: t });
    }

    cross(index) {
      const { surface } = this, w = this.windows[index], h = w.h, length = surface.length[h];
      const apex = surface.apex(h), right = surface.next(h), left = surface.prev(h);
      // positive: the apex is to the left of the ray
      const side = (b) => (b - w.x) * (apex[1] - w.y) + w.y * (apex[0] - w.x);
      const scale = 1e-10 * length * (apex[1] - w.y), side0 = side(w.b0), side1 = side(w.b1);
      let hasLeft = side0 < 0, hasRight = side1 > 0;
      if (side0 <= scale && side1 >= -scale) {
        const d = w.sigma + Math.hypot(apex[0] - w.x, apex[1] - w.y), place = crossing(w, apex);
        this.reach(surface.source(left), d, { kind: "window", window: w, point: apex });
        if (d < this.bestAtApex[h]) {
          this.bestAtApex[h] = d;
          this.placeAtApex[h] = place;
        } else if (hasLeft && hasRight && d > this.bestAtApex[h] * (1 + EPSILON)) {
          if (place < this.placeAtApex[h]) hasRight = false; else hasLeft = false;
        }
      }
      if (hasRight && surface.twin[right] >= 0)
        this.addChild(index, right, apex, [length, 0], side0 > 0 ? w.b0 : NaN, w.b1);
      if (hasLeft && surface.twin[left] >= 0)
        this.addChild(index, left, [0, 0], apex, w.b0, side1 < 0 ? w.b1 : NaN);
    }

    // The child on the edge from p to q, as its neighbor sees it, between the rays through b0 and b1; NaN: to the end.
    addChild(index, h, p, q, b0, b1) {
      const w = this.windows[index], length = this.surface.length[h];
      const ux = (q[0] - p[0]) / length, uy = (q[1] - p[1]) / length;
      const x = (w.x - p[0]) * ux + (w.y - p[1]) * uy, y = ux * (w.y - p[1]) - uy * (w.x - p[0]);
      const hit = (b) => {
        const dx = b - w.x, dy = -w.y, divisor = dx * uy - dy * ux;
        const t = ((w.y - p[1]) * dx - (w.x - p[0]) * dy) / divisor;
        return Math.min(Math.max(t, 0), length);
      };
      // toward the apex, the child ends with its edge
      const isRight = this.surface.next(w.h) === h;
      const low = isRight ? (isNaN(b0) ? 0 : hit(b0)) : hit(b0);
      const high = isRight ? hit(b1) : (isNaN(b1) ? length : hit(b1));
      if (y < 0) this.add(this.surface.twin[h], low, high, x, y, w.sigma, index, w.vertex);
    }

    // Works until the clock says so. Returns true at the end.
    step(milliseconds) {
      const end = Date.now() + milliseconds;
      for (let i = 0; this.queue.size > 0; ++i) {
        if (i % 512 === 511 && Date.now() > end) return false;
        if (this.queue.keys[0] >= this.best) break;
        const event = this.queue.pop();
        if (event.window !== undefined) {
          ++this.numberOfWindows;
          this.cross(event.window);
        } else if (event.distance === this.distance[event.vertex]) {
          this.spread(event.vertex);
        }
      }
      return true;
    }

    // The length, and the points from the target to the source. Null if there is no path.
    result() {
      if (!isFinite(this.best)) return null;
      if (Array.isArray(this.bestPath)) return { length: this.best, points: withoutRepetition(this.bestPath) };
      const points = [this.targetPoint];
      for (let how = this.bestPath; how.kind !== "source";) {
        if (how.kind === "vertex") {
          points.push(this.surface.point(how.vertex));
          how = this.from[how.vertex];
        } else {
          how = this.trace(how.window, how.point, points);
        }
      }
      points.push(this.sourcePoint);
      return { length: this.best, points: withoutRepetition(points) };
    }

    // Follows the straight line from a point back through the windows. Returns how the path reached their source.
    trace(w, point, points) {
      const { surface } = this;
      for (;;) {
        const x = Math.min(Math.max(crossing(w, point), w.b0), w.b1), s = x / surface.length[w.h];
        const p = surface.point(surface.source(w.h)), q = surface.point(surface.target(w.h));
        points.push(p.map((a, j) => a + s * (q[j] - a)));
        if (w.parent < 0) return w.vertex < 0 ? { kind: "source" } : { kind: "vertex", vertex: w.vertex };
        const parent = this.windows[w.parent], apex = surface.apex(parent.h);
        // the same point in the frame of the parent, which has the other halfedge of this edge
        point = surface.twin[surface.next(parent.h)] === w.h
          ? [apex[0] + s * (surface.length[parent.h] - apex[0]), apex[1] * (1 - s)] : [apex[0] * s, apex[1] * s];
        w = parent;
      }
    }
  }

  function crossing(w, t) {
    return w.x + (t[0] - w.x) * -w.y / (t[1] - w.y);
  }

  function distance(p, q) {
    return Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  // Coordinates that are nearly zero are zero: the location is on an edge or at a vertex.
  function exactly(location) {
    const b = location.b.map((x) => (x < 1e-9 ? 0 : x)), sum = b[0] + b[1] + b[2];
    return { face: location.face, b: b.map((x) => x / sum) };
  }

  function withoutRepetition(points) {
    return points.filter((p, i) => i === 0 || distance(p, points[i - 1]) > 0);
  }

  root.ExactPath = { Search };
})(typeof module === "undefined" ? window : module.exports);
