// Draws the surface of the page, and answers clicks. Requires three.js, drawing.js, cut_surface.js and
// exact_path.js.
(function () {
  "use strict";

  const data = JSON.parse(document.getElementById("data").textContent);
  const canvas = document.getElementById("surface");
  const answer = document.getElementById("answer");
  let greeting = "Click on the surface for the distance there, and a second time for the exact path between both "
    + "points. Drag to turn.";
  const { ROLES, UNREACHED, AVOIDED, NO_CELL, MOST_NUMBERS, limits, points, triangles, distances, cells, isAvoided,
    normals, resolution, decode, rounded, css, bandColor, cellColor, surfaceGeometry, surfaceMaterial, lineMesh,
    lineMeshOf, dots, numberedDots } = PageDrawing(data);

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

  const scene = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
  const turned = new THREE.Group(); // turns around the center of the surface
  scene.add(turned);
  const surface = new THREE.Mesh(surfaceGeometry(), surfaceMaterial());
  turned.add(surface);
  // The lines and dots of a role, and the objects that draw them. A group may have none, such as that of curves.
  const parts = [];
  function addPart(role, kind, objects) {
    objects.forEach((object) => turned.add(object));
    parts.push({ role: role, kind: kind, objects: objects });
  }
  data.lines.filter((group) => group.points).forEach((group) => {
    const role = ROLES[group.role], widths = [[role.around || "#000000", role.outline], [role.color, role.width]];
    addPart(role, "line", widths.filter(([, width]) => width).map(([color, width]) => lineMesh(group, color, width)));
  });
  data.dots.filter((group) => group.points).forEach((group) => {
    const xyz = decode(group.points, Float32Array), role = ROLES[group.role];
    addPart(role, "dot", [group.role === "site" && xyz.length <= 3 * MOST_NUMBERS ? numberedDots(xyz, role.color, 22)
      : dots(xyz, role.color, 11)]);
  });
  const pickedDots = [0, 1].map(() => dots(new Float32Array(3), "#ff2fd6", 13));
  pickedDots.forEach((marker) => {
    marker.visible = false;
    turned.add(marker);
  });

  const radius = data.radius || 1;
  turned.scale.setScalar(1 / radius);
  const isFlat = points.every((x, i) => i % 3 !== 2 || Math.abs(x) < 0.02 * radius);
  const view = { distance: 1, x: 0, y: 0, isFilled: false }; // filled: chosen by fill(), and not moved since

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
    fitRamp();
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

  let up = 1; // the axis that points upward: x, y or z

  // The rotation that turns a direction to the viewer, with the axis `up` upward as far as possible.
  function turnTo(direction) {
    const axis = new THREE.Vector3().setComponent(up, 1), along = direction.clone().normalize().dot(axis);
    if (Math.abs(along) > 0.99) axis.set(0, 0, 0).setComponent((up + 1) % 3, -Math.sign(along));
    const axes = new THREE.Matrix4().lookAt(direction, new THREE.Vector3(), axis);
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

  // The whole surface in the window, as large as possible.
  function fill() {
    const slope = Math.tan(camera.fov * Math.PI / 360), p = new THREE.Vector3();
    const box = new THREE.Box3();
    const each = (use) => {
      for (let i = 0; i < points.length; i += 3)
        use(p.fromArray(points, i).multiplyScalar(1 / radius).applyQuaternion(turned.quaternion));
    };
    each(() => box.expandByPoint(p));
    const middle = box.getCenter(new THREE.Vector3());
    let wanted = 0;
    each(() => {
      const half = Math.max(Math.abs(p.y - middle.y), Math.abs(p.x - middle.x) / camera.aspect);
      wanted = Math.max(wanted, p.z + half / slope);
    });
    Object.assign(view, { distance: Math.max(1.06 * wanted, 0.05), x: middle.x, y: middle.y, isFilled: true });
    drawSoon();
  }

  // Turns the surface so that a point faces the viewer.
  function show(point) {
    view.distance = 4;
    const turns = turnsFor(point);
    turned.quaternion.copy(turns.find((turn) => isSeen(point, turn)) || turns[0]);
    fill();
  }

  // The view along an axis, from its positive end or from its negative one.
  function showAlong(axis, sign) {
    turned.quaternion.copy(turnTo(new THREE.Vector3().setComponent(axis, sign)));
    fill();
  }

  function nextUp() {
    up = (up + 1) % 3;
    document.getElementById("up").textContent = "xyz"[up] + " up";
    reset();
  }

  // The first view shows the first source or site.
  const firstDots = data.dots.find((group) => group.role !== "target");
  const firstPoint = new THREE.Vector3().fromArray(decode(firstDots.points, Float32Array));
  function reset() {
    show(firstPoint);
  }

  // --- mouse, fingers and keys ---------------------------------------------------------------------------------------

  function turn(dx, dy) {
    view.isFilled = false;
    const axis = new THREE.Vector3(dy, dx, 0), angle = axis.length();
    if (angle > 0) turned.quaternion.premultiply(new THREE.Quaternion().setFromAxisAngle(axis.normalize(), angle));
    drawSoon();
  }

  function move(dx, dy) {
    view.isFilled = false;
    const scale = 2 * view.distance * Math.tan(camera.fov * Math.PI / 360) / canvas.clientHeight;
    view.x -= dx * scale;
    view.y += dy * scale;
    drawSoon();
  }

  function zoom(factor) {
    view.isFilled = false;
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
    if (pointers.size === 2) { // two fingers: each moves the middle between them by half its way
      zoom(oldSpread / Math.max(spread(), 1));
      move(dx / 2, dy / 2);
    }
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
  canvas.addEventListener("dblclick", () => { // its two clicks are no question
    forget();
    answer.textContent = greeting;
    reset();
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(Math.sign(event.deltaY) * 0.12));
  }, { passive: false });
  document.addEventListener("keydown", (event) => {
    if (event.target.tagName === "INPUT" || event.ctrlKey || event.metaKey || event.altKey) return;
    if (help.open && event.key === "Escape") return; // the browser closes the help
    const keys = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
    const actions = { "+": () => zoom(0.9), "-": () => zoom(1.1), Home: reset, r: reset, u: nextUp, s: savePicture,
      d: switchTheme, l: () => legend.toggleAttribute("open"), h: toggleHelp, "?": toggleHelp, Escape: forget };
    const axis = "xyz".indexOf(event.key.toLowerCase());
    if (keys[event.key]) turn(keys[event.key][0], keys[event.key][1]);
    else if (event.key.length === 1 && axis >= 0) showAlong(axis, event.shiftKey ? -1 : 1);
    else if (actions[event.key]) actions[event.key]();
    else return;
    event.preventDefault();
  });
  window.addEventListener("resize", () => {
    fit();
    if (view.isFilled) fill(); // a window of another shape needs another distance
  });

  // --- clicks --------------------------------------------------------------------------------------------------------

  // The mesh of the file, with its numbers of vertices and faces; the surface that is drawn may have smaller triangles.
  const mesh = data.mesh
    ? { points: decode(data.mesh.points, Float32Array), triangles: decode(data.mesh.triangles, Uint32Array) }
    : { points: points, triangles: triangles };
  const avoidedFaces = new Set(decode((data.mesh || data).avoided || "", Uint32Array)); // of the mesh
  const walls = decode(data.walls || "", Uint32Array); // pairs of its vertices

  function rayAt(x, y) {
    const box = canvas.getBoundingClientRect();
    const point = new THREE.Vector2(2 * (x - box.left) / box.width - 1, 1 - 2 * (y - box.top) / box.height);
    draw(); // updates all matrices to the current view
    const ray = new THREE.Raycaster();
    ray.setFromCamera(point, camera);
    const origin = turned.worldToLocal(ray.ray.origin.clone());
    const direction = turned.worldToLocal(ray.ray.origin.clone().add(ray.ray.direction)).sub(origin);
    return new THREE.Ray(origin, direction.normalize());
  }

  // The first triangle that a ray meets, and the barycentric coordinates there; null if it meets none.
  function firstHit(ray, xyz, corners) {
    const [ox, oy, oz] = ray.origin.toArray(), [dx, dy, dz] = ray.direction.toArray();
    let nearest = Infinity, result = null;
    for (let i = 0; i < corners.length; i += 3) {
      const a = 3 * corners[i], b = 3 * corners[i + 1], c = 3 * corners[i + 2];
      const ux = xyz[b] - xyz[a], uy = xyz[b + 1] - xyz[a + 1], uz = xyz[b + 2] - xyz[a + 2];
      const vx = xyz[c] - xyz[a], vy = xyz[c + 1] - xyz[a + 1], vz = xyz[c + 2] - xyz[a + 2];
      const px = dy * vz - dz * vy, py = dz * vx - dx * vz, pz = dx * vy - dy * vx;
      const divisor = ux * px + uy * py + uz * pz;
      if (divisor === 0) continue;
      const sx = ox - xyz[a], sy = oy - xyz[a + 1], sz = oz - xyz[a + 2];
      const s = (sx * px + sy * py + sz * pz) / divisor;
      if (s < 0 || s > 1) continue;
      const qx = sy * uz - sz * uy, qy = sz * ux - sx * uz, qz = sx * uy - sy * ux;
      const t = (dx * qx + dy * qy + dz * qz) / divisor;
      if (t < 0 || s + t > 1) continue;
      const way = (vx * qx + vy * qy + vz * qz) / divisor;
      if (way > 0 && way < nearest) {
        nearest = way;
        result = { face: i / 3, b: [1 - s - t, s, t] };
      }
    }
    if (result) result.point = ray.at(nearest, new THREE.Vector3());
    return result;
  }

  function pick(x, y) {
    const ray = rayAt(x, y), drawn = firstHit(ray, points, triangles);
    const place = data.mesh ? firstHit(ray, mesh.points, mesh.triangles) : drawn;
    if (!drawn || !place) {
      answer.textContent = "There is no surface here.";
      return;
    }
    if (isAvoided[drawn.face] || avoidedFaces.has(place.face)) {
      answer.textContent = "Paths avoid face " + place.face + ": it has no distance, and no path begins or ends here.";
      return;
    }
    if (clicks.length === 2) forget();
    clicks.push(place);
    const marker = pickedDots[clicks.length - 1];
    place.point.toArray(marker.geometry.attributes.position.array);
    marker.geometry.attributes.position.needsUpdate = true;
    marker.visible = true;
    tell(drawn, place);
    drawSoon();
    if (clicks.length === 2) findPath();
  }

  function tell(drawn, place) {
    const lines = [];
    if (cells)
      lines.push(cells[drawn.face] === NO_CELL ? "in no cell" : "in the cell of site " + cells[drawn.face]);
    const d = [0, 1, 2].reduce((sum, k) => sum + drawn.b[k] * distances[triangles[3 * drawn.face + k]], 0);
    lines.push(isFinite(d) ? "distance " + rounded(d) : "not reached");
    const isRounding = (x) => Math.abs(x) < 1e-7 * radius; // by the matrices of the view
    const coordinates = place.point.toArray().map((x, k) => x + data.center[k])
      .map((x) => (isRounding(x) ? "0" : rounded(x)));
    lines.push("at (" + coordinates.join(", ") + ")");
    const nearest = place.b.indexOf(Math.max(...place.b));
    lines.push("face " + place.face + ", near vertex " + mesh.triangles[3 * place.face + nearest]);
    if (clicks.length === 1) lines.push("A second click shows the exact path to it.");
    answer.innerText = lines.join("\n");
  }

  // --- the path between two clicks -----------------------------------------------------------------------------------

  const clicks = [];
  let pathMeshes = [], connections = null, search = null;

  function forget() {
    clicks.length = 0;
    search = null;
    pickedDots.forEach((marker) => { marker.visible = false; });
    pathMeshes.forEach((object) => turned.remove(object));
    pathMeshes = [];
    delete document.body.dataset.path;
    drawSoon();
  }

  // Works in slices, so that the page stays alive.
  function findPath() {
    const line = element("div", answer, "looking for the path ...");
    const mine = {};
    search = mine;
    window.setTimeout(() => {
      if (search !== mine) return; // the clicks are forgotten
      connections = connections || new CutSurface(mesh.points, mesh.triangles, avoidedFaces, walls);
      const work = new ExactPath.Search(connections, clicks[0], clicks[1]);
      const go = () => {
        if (search !== mine) return;
        if (work.step(40)) finish(work.result(), line);
        else window.setTimeout(go, 0);
      };
      go();
    }, 20);
  }

  function finish(path, line) {
    line.textContent = path ? "exact path between the two clicks: " + rounded(path.length)
      : "no path joins the two clicks" + (avoidedFaces.size + walls.length > 0 ? " around what paths avoid" : "");
    document.body.dataset.path = path ? path.length : "none";
    document.body.dataset.ends = clicks.map((c) => c.face + " " + c.b.join(" ")).join("|");
    if (!path) return;
    const role = ROLES.clicked, xyz = new Float32Array(path.points.flat());
    pathMeshes = [["#000000", role.outline], [role.color, role.width]]
      .map(([color, width]) => lineMeshOf(xyz, new Uint32Array([path.points.length]), color, width));
    pathMeshes.forEach((object) => turned.add(object));
    drawSoon();
  }

  // --- cells under the mouse -----------------------------------------------------------------------------------------

  const hint = document.getElementById("hint");
  let isLooking = false;
  function choose(cell) {
    surface.material.uniforms.chosenCell.value = cell;
    drawSoon();
  }
  canvas.addEventListener("pointermove", (event) => {
    if (!cells || event.pointerType !== "mouse" || event.buttons !== 0 || isLooking || triangles.length > 2e6) return;
    isLooking = true;
    window.requestAnimationFrame(() => {
      isLooking = false;
      const hit = firstHit(rayAt(event.clientX, event.clientY), points, triangles);
      const cell = hit && cells[hit.face] !== NO_CELL ? cells[hit.face] : -2;
      hint.hidden = cell < 0;
      hint.textContent = "site " + cell;
      hint.style.left = event.clientX + 14 + "px";
      hint.style.top = event.clientY + 10 + "px";
      choose(cell);
    });
  });

  // --- buttons -------------------------------------------------------------------------------------------------------

  const legend = document.getElementById("legend"), help = document.getElementById("help");

  function toggleHelp() {
    if (help.open) help.close(); else help.showModal();
  }

  function savePicture() {
    draw();
    canvas.toBlob((blob) => {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(blob);
      link.download = "surface.png";
      link.click();
      window.setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    });
  }

  function applyTheme() {
    const color = getComputedStyle(document.documentElement).getPropertyValue("--ground").trim();
    renderer.setClearColor(new THREE.Color(color));
    drawSoon();
  }

  function switchTheme() {
    const isDark = document.documentElement.dataset.theme
      ? document.documentElement.dataset.theme === "dark" : window.matchMedia("(prefers-color-scheme: dark)").matches;
    document.documentElement.dataset.theme = isDark ? "light" : "dark";
    applyTheme();
  }

  function connectButtons() {
    const actions = { reset: reset, up: nextUp, picture: savePicture, theme: switchTheme, "show-help": toggleHelp,
      along: () => { showAlong(nextAxis, 1); nextAxis = (nextAxis + 1) % 3; } };
    let nextAxis = 0;
    Object.keys(actions).forEach((id) => document.getElementById(id).addEventListener("click", actions[id]));
    document.getElementById("close-help").addEventListener("click", () => help.close());
    document.getElementById("copy").addEventListener("click", () => {
      if (navigator.clipboard) navigator.clipboard.writeText(data.command);
    });
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", applyTheme);
    legend.addEventListener("toggle", fitRamp);
  }

  // --- title and legend ----------------------------------------------------------------------------------------------

  function element(tag, parent, text, style) {
    const e = document.createElement(tag);
    if (text) e.textContent = text;
    Object.assign(e.style, style || {});
    parent.appendChild(e);
    return e;
  }

  function key(parent, kind, style, text) {
    const line = element("div", parent);
    line.className = "key";
    element("span", line, "", style).className = kind;
    element("div", line, text);
    return line;
  }

  // A click on the key of lines or dots hides them, and another one shows them again.
  function keyOfPart(parent, part) {
    const { color, around, text } = part.role;
    const line = key(parent, part.kind, part.kind === "dot" ? { background: color }
      : { borderColor: color, boxShadow: around ? "0 0 0 1.5px " + around : "" }, text);
    Object.assign(line, { tabIndex: 0, title: "hide or show" });
    line.setAttribute("role", "switch");
    const show = (isShown) => {
      line.setAttribute("aria-checked", isShown);
      part.objects.forEach((object) => { object.visible = isShown; });
      drawSoon();
    };
    const change = () => show(line.getAttribute("aria-checked") !== "true");
    line.addEventListener("click", change);
    line.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      change();
    });
    show(true);
  }

  // Values stand at the borders of the bands; the lowest one is 0.
  function drawRamp(keys) {
    element("b", keys, "distance");
    element("div", keys, "in the unit of the mesh").className = "unit";
    const list = element("div", keys);
    list.className = "ramp";
    element("small", list, "largest " + Number(data.largest.toPrecision(4)));
    for (let i = limits.length; i >= 0; --i) {
      const row = element("div", list);
      element("span", row, "", { background: css(bandColor(i)) });
      element("small", row, rounded(i === 0 ? 0 : limits[i - 1]));
    }
  }

  // Makes the bands of the legend so low that all of them are in the window, and leaves out labels that do not fit. The
  // label of 0, in the last row, stays.
  function fitRamp() {
    const rows = [...document.querySelectorAll(".ramp div")], highest = 15, label = 12;
    const setHeight = (h) => rows.forEach((row) => { row.style.height = h + "px"; });
    setHeight(highest);
    const excess = Math.max(0, legend.scrollHeight - legend.clientHeight);
    const height = Math.max(2, highest - excess / rows.length);
    setHeight(height);
    const step = Math.max(Math.ceil(rows.length / 12), Math.ceil(label / height));
    rows.forEach((row, i) => {
      row.lastChild.style.visibility = (rows.length - 1 - i) % step === 0 ? "" : "hidden";
    });
  }

  function drawCells(keys) {
    const n = data.cellColors.length, sites = decode(firstDots.points, Float32Array);
    element("b", keys, n + (n === 1 ? " cell" : " cells"));
    const label = element("label", element("div", keys), "site ");
    const input = element("input", label);
    Object.assign(input, { id: "site", type: "number", min: 0, max: n - 1, placeholder: "0 to " + (n - 1) });
    input.addEventListener("input", () => {
      const i = Number(input.value);
      if (input.value === "" || !(i >= 0 && i < n)) return choose(-2);
      choose(i);
      show(new THREE.Vector3().fromArray(sites, 3 * i));
    });
    element("p", keys, "Point at a cell to see its site.", { margin: "4px 0 0" });
    if (limits.length > 0) element("p", keys, "shaded in bands of " + rounded(limits[0]), { margin: "4px 0 0" });
  }

  // Is there a triangle that no source reaches, although paths do not avoid it?
  function isMissing() {
    return triangles.some((v, i) => !isFinite(distances[v]) && !isAvoided[Math.floor(i / 3)]);
  }

  function write() {
    document.querySelector("#title h1").textContent = data.title;
    document.querySelector("#title p").textContent = data.subtitle;
    document.getElementById("command").textContent = data.command;
    const keys = document.getElementById("keys");
    if (cells) drawCells(keys); else drawRamp(keys);
    parts.forEach((part) => keyOfPart(keys, part));
    if (isMissing()) key(keys, "", { background: UNREACHED }, "not reached");
    const stripes = AVOIDED.map((color, i) => color + " " + 3 * i + "px " + 3 * (i + 1) + "px").join(", ");
    if (data.avoided)
      key(keys, "", { background: "repeating-linear-gradient(-45deg, " + stripes + ")" }, "faces that paths avoid");
    if (window.matchMedia("(max-width: 700px)").matches) legend.open = false;
    if (window.matchMedia("(pointer: coarse)").matches)
      greeting = "Tap the surface for the distance there, and a second time for the exact path between both points. "
        + "One finger turns, two move and zoom.";
    answer.textContent = greeting;
  }

  connectButtons();
  applyTheme();
  write();
  fit();
  reset();
  draw();
  document.body.dataset.state = "ready";
})();
