// Draws the surface of the page, and answers clicks. Requires three.js only.
(function () {
  "use strict";

  // Dark violet to light yellow, with increasing lightness: the order is visible without distinguishing red from green.
  const RAMP = [[76, 40, 140], [56, 96, 174], [30, 138, 160], [62, 178, 122], [168, 208, 70], [252, 232, 92]];
  const UNREACHED = "#9a9a9a";
  const ROLES = {
    isoline: { color: "#1a1a1a", width: 1.2, text: "lines of equal distance" },
    path: { color: "#d55e00", width: 3, outline: 5.5, text: "shortest paths" },
    arc: { color: "#000000", width: 2.2, text: "boundaries of the cells" },
    source: { color: "#ffffff", text: "sources" },
    target: { color: "#d55e00", text: "targets" },
    site: { color: "#ffffff", text: "sites" }
  };
  const NO_CELL = 0xffffffff;
  const MOST_NUMBERS = 200; // more would hide the surface

  const data = JSON.parse(document.getElementById("data").textContent);
  const canvas = document.getElementById("surface");
  const answer = document.getElementById("answer");

  // --- numbers -------------------------------------------------------------------------------------------------------

  function decode(text, Type) {
    const bytes = atob(text);
    const array = new Uint8Array(bytes.length);
    for (let i = 0; i < bytes.length; ++i) array[i] = bytes.charCodeAt(i);
    return new Type(array.buffer); // lowest byte first, as on all machines with browsers
  }

  function rounded(x) {
    return String(Number(x.toPrecision(5)));
  }

  function ramp(t) {
    const s = Math.min(Math.max(t, 0), 1) * (RAMP.length - 1);
    const i = Math.min(Math.floor(s), RAMP.length - 2);
    return RAMP[i].map((c, k) => c + (s - i) * (RAMP[i + 1][k] - c));
  }

  function css(rgb) {
    return "rgb(" + rgb.map(Math.round).join(",") + ")";
  }

  // Band i lies between the isolines i - 1 and i.
  const limits = data.isolines;
  function bandColor(i) {
    return ramp(limits.length > 0 ? i / limits.length : 0);
  }

  // --- the surface ---------------------------------------------------------------------------------------------------

  const points = decode(data.points, Float32Array);
  const triangles = decode(data.triangles, Uint32Array);
  const distances = decode(data.distances, Float32Array);
  const cells = data.cells ? decode(data.cells, Uint32Array) : null;

  // The sum of the normals of the faces around each point, weighted by area.
  function smoothNormals() {
    const normals = new Float32Array(points.length);
    const a = new THREE.Vector3(), b = new THREE.Vector3(), c = new THREE.Vector3();
    for (let i = 0; i < triangles.length; i += 3) {
      a.fromArray(points, 3 * triangles[i]);
      b.fromArray(points, 3 * triangles[i + 1]).sub(a);
      c.fromArray(points, 3 * triangles[i + 2]).sub(a);
      b.cross(c);
      for (let k = 0; k < 3; ++k) {
        const v = 3 * triangles[i + k];
        normals[v] += b.x;
        normals[v + 1] += b.y;
        normals[v + 2] += b.z;
      }
    }
    return normals;
  }
  const normals = smoothNormals();

  // Each triangle has its own corners, because its color is that of its cell, or gray if a corner is not reached.
  function surfaceGeometry() {
    const n = triangles.length;
    const position = new Float32Array(3 * n), normal = new Float32Array(3 * n);
    const distance = new Float32Array(n), color = new Float32Array(3 * n);
    const shade = new THREE.Color();
    for (let i = 0; i < n; i += 3) {
      const corners = [triangles[i], triangles[i + 1], triangles[i + 2]];
      const isReached = corners.every((v) => isFinite(distances[v]));
      if (cells) shade.set(cells[i / 3] === NO_CELL ? UNREACHED : cellColor(cells[i / 3]));
      corners.forEach((v, k) => {
        for (let j = 0; j < 3; ++j) {
          position[3 * (i + k) + j] = points[3 * v + j];
          normal[3 * (i + k) + j] = normals[3 * v + j];
        }
        shade.toArray(color, 3 * (i + k));
        distance[i + k] = isReached ? distances[v] : -1;
      });
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(normal, 3));
    geometry.setAttribute("distance", new THREE.BufferAttribute(distance, 1));
    geometry.setAttribute("cellColor", new THREE.BufferAttribute(color, 3));
    return geometry;
  }

  function cellColor(cell) {
    return data.cellColors[cell];
  }

  // A texture with the colors of all bands in a row, indexed by the number of the band.
  function bandTexture() {
    const n = limits.length + 1, texels = new Uint8Array(3 * n);
    for (let i = 0; i < n; ++i) texels.set(bandColor(i).map(Math.round), 3 * i);
    const texture = new THREE.DataTexture(texels, n, 1, THREE.RGBFormat);
    texture.unpackAlignment = 1; // rows of three bytes
    texture.needsUpdate = true;
    return texture;
  }

  function surfaceMaterial() {
    return new THREE.ShaderMaterial({
      uniforms: {
        bands: { value: bandTexture() },
        numberOfBands: { value: limits.length + 1 },
        spacing: { value: limits.length > 0 ? limits[0] : 1 },
        hasCells: { value: cells !== null }
      },
      vertexShader: `
        attribute float distance;
        attribute vec3 cellColor;
        varying float vDistance;
        varying vec3 vNormal, vCellColor;
        void main() {
          vDistance = distance;
          vCellColor = cellColor;
          vNormal = normalMatrix * normal;
          gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        }`,
      fragmentShader: `
        uniform sampler2D bands;
        uniform float numberOfBands, spacing;
        uniform bool hasCells;
        varying float vDistance;
        varying vec3 vNormal, vCellColor;
        void main() {
          float band = clamp(floor(vDistance / spacing), 0.0, numberOfBands - 1.0);
          vec3 color = texture2D(bands, vec2((band + 0.5) / numberOfBands, 0.5)).rgb;
          if(hasCells)
            color = vCellColor * (mod(band, 2.0) < 0.5 ? 1.0 : 0.88);
          else if(vDistance < 0.0)
            color = vec3(0.6);
          // light from the eye, a little from above; the same on both sides
          float light = abs(dot(normalize(vNormal), normalize(vec3(0.2, 0.35, 1.0))));
          gl_FragColor = vec4(color * (0.6 + 0.4 * light), 1.0);
        }`,
      side: THREE.DoubleSide,
      polygonOffset: true, // behind the lines on the surface
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1
    });
  }

  // --- lines and dots ------------------------------------------------------------------------------------------------

  const resolution = { value: new THREE.Vector2(1, 1) }; // of the canvas, in pixels

  let numberOfLayers = 0;
  function inOrder(object) {
    object.renderOrder = ++numberOfLayers;
    object.frustumCulled = false;
    return object;
  }

  // Lines some pixels wide: each segment is a rectangle that the vertex shader turns to the eye.
  function lineMesh(group, color, width) {
    const xyz = decode(group.points, Float32Array), lengths = decode(group.lengths, Uint32Array);
    let segments = 0;
    lengths.forEach((n) => { segments += n - 1; });
    const position = new Float32Array(12 * segments), other = new Float32Array(12 * segments);
    const side = new Float32Array(4 * segments), index = new Uint32Array(6 * segments);
    let s = 0, first = 0;
    lengths.forEach((n) => {
      for (let i = first; i + 1 < first + n; ++i, ++s)
        for (let k = 0; k < 4; ++k) {
          const here = k < 2 ? i : i + 1, there = k < 2 ? i + 1 : i;
          for (let j = 0; j < 3; ++j) {
            position[12 * s + 3 * k + j] = xyz[3 * here + j];
            other[12 * s + 3 * k + j] = xyz[3 * there + j];
          }
          side[4 * s + k] = k === 0 || k === 3 ? 1 : -1; // seen from the other end, left and right change
        }
      first += n;
    });
    for (let i = 0; i < segments; ++i)
      index.set([0, 1, 2, 2, 1, 3].map((k) => 4 * i + k), 6 * i);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
    geometry.setAttribute("other", new THREE.BufferAttribute(other, 3));
    geometry.setAttribute("side", new THREE.BufferAttribute(side, 1));
    geometry.setIndex(new THREE.BufferAttribute(index, 1));
    const material = new THREE.ShaderMaterial({
      uniforms: { resolution: resolution, color: { value: new THREE.Color(color) },
        width: { value: width * window.devicePixelRatio } },
      vertexShader: `
        attribute vec3 other;
        attribute float side;
        uniform vec2 resolution;
        uniform float width;
        void main() {
          vec4 p = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
          vec4 q = projectionMatrix * modelViewMatrix * vec4(other, 1.0);
          vec2 along = (q.xy / q.w - p.xy / p.w) * resolution;
          float size = length(along);
          along = size > 0.0 ? along / size : vec2(1.0, 0.0);
          vec2 offset = side * vec2(-along.y, along.x) - 0.4 * along; // a little longer, so that bends have no gaps
          p.xy += offset * width / resolution * p.w;
          p.z -= 0.001 * p.w; // in front of the surface
          gl_Position = p;
        }`,
      fragmentShader: "uniform vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }",
      side: THREE.DoubleSide,
      depthWrite: false // lines hide each other in the order in which they are drawn
    });
    return inOrder(new THREE.Mesh(geometry, material));
  }

  function dots(xyz, color, size) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(xyz, 3));
    const material = new THREE.ShaderMaterial({
      uniforms: {
        color: { value: new THREE.Color(color) },
        size: { value: size * window.devicePixelRatio },
        lift: { value: 0.0015 * size } // about the radius of a dot, so that no surface cuts it off
      },
      vertexShader: `
        uniform float size, lift;
        void main() {
          vec4 p = modelViewMatrix * vec4(position, 1.0);
          gl_Position = projectionMatrix * p;
          p.xyz *= 1.0 - min(lift / length(p.xyz), 0.5);
          vec4 q = projectionMatrix * p;
          gl_Position.z = q.z / q.w * gl_Position.w;
          gl_PointSize = size;
        }`,
      fragmentShader: `
        uniform vec3 color;
        void main() {
          float r = 2.0 * length(gl_PointCoord - vec2(0.5));
          if(r > 1.0)
            discard;
          gl_FragColor = vec4(r > 0.65 ? vec3(0.0) : color, 1.0);
        }`
    });
    material.depthWrite = false;
    return inOrder(new THREE.Points(geometry, material));
  }

  // Dots with their indices, from 0, drawn from one texture with all of them.
  function numberedDots(xyz, color, size) {
    const n = xyz.length / 3, columns = Math.ceil(Math.sqrt(n)), side = 64;
    const picture = document.createElement("canvas");
    picture.width = picture.height = columns * side;
    const context = picture.getContext("2d");
    context.textAlign = "center";
    context.textBaseline = "middle";
    const cell = new Float32Array(2 * n);
    for (let i = 0; i < n; ++i) {
      cell.set([i % columns, Math.floor(i / columns)], 2 * i);
      context.font = "bold " + [44, 38, 28][String(i).length - 1] + "px sans-serif";
      context.fillText(String(i), (cell[2 * i] + 0.5) * side, (cell[2 * i + 1] + 0.53) * side);
    }
    const texture = new THREE.CanvasTexture(picture);
    texture.flipY = false;
    texture.generateMipmaps = false;
    texture.minFilter = THREE.LinearFilter;
    const object = dots(xyz, color, size), material = object.material;
    object.geometry.setAttribute("cell", new THREE.BufferAttribute(cell, 2));
    Object.assign(material.uniforms, { numbers: { value: texture }, columns: { value: columns } });
    material.vertexShader = "attribute vec2 cell; varying vec2 vCell;"
      + material.vertexShader.replace("void main() {", "void main() { vCell = cell;");
    material.fragmentShader = `
      uniform vec3 color;
      uniform sampler2D numbers;
      uniform float columns;
      varying vec2 vCell;
      void main() {
        float r = 2.0 * length(gl_PointCoord - vec2(0.5));
        if(r > 1.0)
          discard;
        float ink = texture2D(numbers, (vCell + gl_PointCoord) / columns).a;
        gl_FragColor = vec4(color * (1.0 - max(ink, smoothstep(0.82, 0.92, r))), 1.0);
      }`;
    return object;
  }

  // --- the scene -----------------------------------------------------------------------------------------------------

  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({ canvas: canvas, antialias: true });
  } catch (error) {
    answer.textContent = "This browser cannot draw in three dimensions: WebGL is switched off or missing.";
    document.body.dataset.state = "no WebGL";
    return;
  }
  renderer.setPixelRatio(window.devicePixelRatio);
  renderer.setClearColor(0xf4f4f2);

  const scene = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
  const turned = new THREE.Group(); // turns around the center of the surface
  scene.add(turned);
  const surface = new THREE.Mesh(surfaceGeometry(), surfaceMaterial());
  turned.add(surface);
  data.lines.forEach((group) => {
    const role = ROLES[group.role];
    if (role.outline) turned.add(lineMesh(group, "#000000", role.outline));
    turned.add(lineMesh(group, role.color, role.width));
  });
  data.dots.forEach((group) => {
    const xyz = decode(group.points, Float32Array), color = ROLES[group.role].color;
    turned.add(group.role === "site" && xyz.length <= 3 * MOST_NUMBERS ? numberedDots(xyz, color, 22)
      : dots(xyz, color, 11));
  });
  const picked = dots(new Float32Array(3), "#ff2fd6", 13);
  picked.visible = false;
  turned.add(picked);

  const radius = data.radius || 1;
  turned.scale.setScalar(1 / radius);
  const isFlat = points.every((x, i) => i % 3 !== 2 || Math.abs(x) < 0.02 * radius);
  const view = { distance: 1, x: 0, y: 0 };

  function draw() {
    camera.position.set(view.x, view.y, view.distance);
    camera.near = Math.max(view.distance - 1.2, 0.001);
    camera.far = view.distance + 1.2;
    camera.updateProjectionMatrix();
    renderer.render(scene, camera);
  }

  let isWaiting = false;
  function drawSoon() {
    if (isWaiting) return;
    isWaiting = true;
    window.requestAnimationFrame(() => { isWaiting = false; draw(); });
  }

  function fit() {
    const w = canvas.clientWidth, h = canvas.clientHeight;
    renderer.setSize(w, h, false);
    resolution.value.set(canvas.width, canvas.height);
    camera.aspect = w / h;
    drawSoon();
  }

  // --- the view of a point -------------------------------------------------------------------------------------------

  // The normal at a point of the surface: that of the nearest vertices, which several triangles may share.
  function normalAt(p) {
    const q = new THREE.Vector3(), normal = new THREE.Vector3();
    let nearest = Infinity;
    for (let i = 0; i < points.length; i += 3)
      nearest = Math.min(nearest, q.fromArray(points, i).distanceTo(p));
    for (let i = 0; i < points.length; i += 3)
      if (q.fromArray(points, i).distanceTo(p) <= nearest + 1e-5 * radius)
        normal.add(q.fromArray(normals, i));
    return normal.normalize();
  }

  // The rotation that turns a direction to the viewer, with y upward as far as possible.
  function turnTo(direction) {
    const up = Math.abs(direction.y) < 0.99 ? new THREE.Vector3(0, 1, 0)
      : new THREE.Vector3(0, 0, -Math.sign(direction.y));
    const axes = new THREE.Matrix4().lookAt(direction, new THREE.Vector3(), up);
    return new THREE.Quaternion().setFromRotationMatrix(axes).conjugate();
  }

  // Is a point visible under a rotation?
  function isSeen(point, quaternion) {
    turned.quaternion.copy(quaternion);
    turned.updateMatrixWorld(true);
    const p = surface.localToWorld(point.clone());
    const direction = new THREE.Vector3(0, 0, view.distance).sub(p).normalize();
    const ray = new THREE.Raycaster(p.addScaledVector(direction, 0.003), direction);
    return ray.intersectObject(surface).length === 0;
  }

  // Rotations under which a point may be visible, the best ones first: a flat surface lies in the plane of the picture;
  // a solid is viewed along the normal or a little from the side, then from all sides, if other parts hide the point.
  function turnsFor(point) {
    const turns = isFlat ? [new THREE.Quaternion(), turnTo(new THREE.Vector3(0, 0, -1))] : [];
    const normal = normalAt(point), directions = [normal, point.clone().normalize(), normal.clone().negate()];
    for (let k = 0; k < 27; ++k)
      directions.push(new THREE.Vector3(k % 3 - 1, Math.floor(k / 3) % 3 - 1, Math.floor(k / 9) - 1).normalize());
    const aside = new THREE.Quaternion().setFromEuler(new THREE.Euler(0.25, -0.3, 0));
    directions.filter((d) => d.length() > 0.5).forEach((d) => {
      const turn = turnTo(d);
      turns.push(aside.clone().multiply(turn), turn);
    });
    return turns;
  }

  // Turns the surface so that a point faces the viewer, with the whole surface in the window.
  function show(point) {
    const wanted = 1.02 / Math.sin(camera.fov * Math.PI / 360);
    Object.assign(view, { distance: wanted / Math.min(camera.aspect, 1), x: 0, y: 0 });
    const turns = turnsFor(point);
    turned.quaternion.copy(turns.find((turn) => isSeen(point, turn)) || turns[0]);
    drawSoon();
  }

  // The first view shows the first source or site.
  const firstDots = data.dots.find((group) => group.role !== "target");
  const firstPoint = new THREE.Vector3().fromArray(decode(firstDots.points, Float32Array));
  function reset() {
    show(firstPoint);
  }

  // --- mouse, fingers and keys ---------------------------------------------------------------------------------------

  function turn(dx, dy) {
    const axis = new THREE.Vector3(dy, dx, 0), angle = axis.length();
    if (angle > 0) turned.quaternion.premultiply(new THREE.Quaternion().setFromAxisAngle(axis.normalize(), angle));
    drawSoon();
  }

  function move(dx, dy) {
    const scale = 2 * view.distance * Math.tan(camera.fov * Math.PI / 360) / canvas.clientHeight;
    view.x -= dx * scale;
    view.y += dy * scale;
    drawSoon();
  }

  function zoom(factor) {
    view.distance = Math.min(Math.max(view.distance * factor, 0.05), 50);
    drawSoon();
  }

  const pointers = new Map();
  let hasMoved = false;

  function spread() {
    const [a, b] = Array.from(pointers.values());
    return Math.hypot(a.x - b.x, a.y - b.y);
  }

  canvas.addEventListener("pointerdown", (event) => {
    try {
      canvas.setPointerCapture(event.pointerId);
    } catch (error) { /* the pointer has gone already */ }
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (pointers.size === 1) hasMoved = false;
  });

  canvas.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const dx = event.clientX - before.x, dy = event.clientY - before.y;
    if (!hasMoved && Math.hypot(dx, dy) < 4) return; // a click with a shaking hand
    hasMoved = true;
    const oldSpread = pointers.size === 2 ? spread() : 0;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (pointers.size === 2) zoom(oldSpread / Math.max(spread(), 1));
    else if (event.buttons === 2 || event.shiftKey) move(dx, dy);
    else turn(dx * 0.008, dy * 0.008);
  });

  function release(event) {
    const wasAlone = pointers.size === 1 && pointers.has(event.pointerId);
    pointers.delete(event.pointerId);
    if (wasAlone && !hasMoved && event.type === "pointerup" && event.button === 0)
      pick(event.clientX, event.clientY);
  }
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("dblclick", reset);
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(Math.sign(event.deltaY) * 0.12));
  }, { passive: false });
  canvas.addEventListener("keydown", (event) => {
    const keys = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
    if (keys[event.key]) turn(keys[event.key][0], keys[event.key][1]);
    else if (event.key === "+") zoom(0.9);
    else if (event.key === "-") zoom(1.1);
    else if (event.key === "Home") reset();
    else return;
    event.preventDefault();
  });
  window.addEventListener("resize", fit);

  // --- clicks --------------------------------------------------------------------------------------------------------

  function pick(x, y) {
    const box = canvas.getBoundingClientRect();
    const point = new THREE.Vector2(2 * (x - box.left) / box.width - 1, 1 - 2 * (y - box.top) / box.height);
    draw(); // updates all matrices to the current view
    const ray = new THREE.Raycaster();
    ray.setFromCamera(point, camera);
    const hit = ray.intersectObject(surface)[0];
    picked.visible = Boolean(hit);
    if (hit) {
      const local = surface.worldToLocal(hit.point.clone());
      local.toArray(picked.geometry.attributes.position.array);
      picked.geometry.attributes.position.needsUpdate = true;
      tell(hit.face.a / 3, local);
    } else {
      answer.textContent = "There is no surface here.";
    }
    drawSoon();
  }

  function tell(triangle, p) {
    const corners = [0, 1, 2].map((k) => triangles[3 * triangle + k]);
    const [a, b, c] = corners.map((v) => new THREE.Vector3().fromArray(points, 3 * v));
    const weights = THREE.Triangle.getBarycoord(p, a, b, c, new THREE.Vector3()).toArray();
    const d = corners.reduce((sum, v, k) => sum + weights[k] * distances[v], 0);
    const lines = [];
    if (cells) lines.push(cells[triangle] === NO_CELL ? "in no cell" : "in the cell of site " + cells[triangle]);
    lines.push(isFinite(d) ? "distance " + rounded(d) : "not reached");
    const isRounding = (x) => Math.abs(x) < 1e-7 * radius; // by the matrices of the view
    const coordinates = p.toArray().map((x, k) => x + data.center[k]).map((x) => (isRounding(x) ? "0" : rounded(x)));
    lines.push("at (" + coordinates.join(", ") + ")");
    answer.innerText = lines.join("\n");
  }

  // --- title and legend ----------------------------------------------------------------------------------------------

  function element(tag, parent, text, style) {
    const e = document.createElement(tag);
    if (text) e.textContent = text;
    Object.assign(e.style, style || {});
    parent.appendChild(e);
    return e;
  }

  function key(parent, kind, color, text, tag) {
    const line = element(tag || "div", parent);
    line.className = "key";
    const sign = element("span", line, "", kind === "line" ? { borderColor: color } : { background: color });
    sign.className = kind;
    element(tag ? "b" : "div", line, text);
    return line;
  }

  function drawRamp(legend) {
    element("b", legend, "distance");
    const list = element("div", legend);
    list.className = "ramp";
    const step = Math.ceil((limits.length + 1) / 12); // labels that fit
    for (let i = limits.length; i >= 0; --i) {
      const row = element("div", list);
      element("span", row, "", { background: css(bandColor(i)) });
      const limit = i === limits.length ? data.largest : limits[i];
      element("small", row, i === limits.length || (i + 1) % step === 0 ? "≤ " + rounded(limit) : "");
    }
  }

  function drawCells(legend) {
    element("b", legend, "cells, with the indices of their sites");
    const list = element("div", legend);
    list.id = "cells";
    const sites = decode(firstDots.points, Float32Array);
    data.cellColors.slice(0, MOST_NUMBERS).forEach((_, i) => {
      const entry = key(list, "", cellColor(i), String(i), "button");
      entry.title = "show site " + i;
      entry.addEventListener("click", () => show(new THREE.Vector3().fromArray(sites, 3 * i)));
    });
    if (data.cellColors.length > MOST_NUMBERS) element("div", list, "…");
    element("p", legend, "Click on a number to turn its cell to the front.", { margin: "4px 0 0" });
    if (limits.length > 0) element("p", legend, "shaded in bands of " + rounded(limits[0]), { margin: "4px 0 0" });
  }

  function write() {
    document.querySelector("#title h1").textContent = data.title;
    document.querySelector("#title p").textContent = data.subtitle;
    const legend = document.getElementById("legend");
    if (cells) drawCells(legend); else drawRamp(legend);
    data.lines.forEach((group) => key(legend, "line", ROLES[group.role].color, ROLES[group.role].text));
    data.dots.forEach((group) => key(legend, "dot", ROLES[group.role].color, ROLES[group.role].text));
    if (distances.some((d) => !isFinite(d))) key(legend, "", UNREACHED, "not reached");
  }

  write();
  fit();
  reset();
  draw();
  document.body.dataset.state = "ready";
})();
