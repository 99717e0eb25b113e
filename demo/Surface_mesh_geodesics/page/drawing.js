// The parts of the picture: the surface with its colors, lines and dots, from the data of the page. Requires three.js.
function PageDrawing(data) {
  "use strict";

  // Dark violet to light yellow, with increasing lightness: the order is visible without distinguishing red from green.
  const RAMP = [[76, 40, 140], [56, 96, 174], [30, 138, 160], [62, 178, 122], [168, 208, 70], [252, 232, 92]];
  const UNREACHED = "#9a9a9a";
  const AVOIDED = ["#63666b", "#7d8085"]; // stripes, so that no value and no light is taken for it
  const ROLES = {
    wall: { color: "#000000", width: 3.5, outline: 7, around: "#ffffff", text: "walls, which no path crosses" },
    isoline: { color: "#1a1a1a", width: 1.2, text: "lines of equal distance" },
    clicked: { color: "#ff2fd6", width: 3, outline: 5.5, text: "path between two clicks" },
    path: { color: "#d55e00", width: 3, outline: 5.5, text: "shortest paths" },
    curve: { color: "#ffffff", width: 3, outline: 5.5, text: "curves" },
    arc: { color: "#000000", width: 2.2, text: "boundaries of the cells" },
    source: { color: "#ffffff", text: "sources" },
    target: { color: "#d55e00", text: "targets" },
    site: { color: "#ffffff", text: "sites" }
  };
  const NO_CELL = 0xffffffff;
  const MOST_NUMBERS = 200; // more would hide the surface

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
  const isAvoided = new Uint8Array(triangles.length / 3);
  if (data.avoided) decode(data.avoided, Uint32Array).forEach((t) => { isAvoided[t] = 1; });

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

  // Each triangle has its own corners, because its color is that of its cell, or gray if a corner is not reached, or if
  // paths avoid it. Its distances are -1 then, or -2.
  function surfaceGeometry() {
    const n = triangles.length;
    const position = new Float32Array(3 * n), normal = new Float32Array(3 * n);
    const distance = new Float32Array(n), color = new Float32Array(3 * n), cell = new Float32Array(n).fill(-1);
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
        distance[i + k] = isAvoided[i / 3] ? -2 : isReached ? distances[v] : -1;
        if (cells && cells[i / 3] !== NO_CELL) cell[i + k] = cells[i / 3];
      });
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(normal, 3));
    geometry.setAttribute("distance", new THREE.BufferAttribute(distance, 1));
    geometry.setAttribute("cell", new THREE.BufferAttribute(cell, 1));
    geometry.setAttribute("cellColor", new THREE.BufferAttribute(color, 3));
    return geometry;
  }

  // The colors of the files, calmer: mixed with a light gray.
  function cellColor(cell) {
    const color = parseInt(data.cellColors[cell].slice(1), 16);
    return css([16, 8, 0].map((shift) => 0.52 * (color >> shift & 255) + 0.48 * 228));
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
        hasCells: { value: cells !== null },
        avoided: { value: AVOIDED.map((color) => new THREE.Color(color)) },
        pixelRatio: { value: window.devicePixelRatio },
        chosenCell: { value: -2 }
      },
      vertexShader: `
        attribute float distance, cell;
        attribute vec3 cellColor;
        varying float vDistance, vCell;
        varying vec3 vNormal, vCellColor;
        void main() {
          vDistance = distance;
          vCell = cell;
          vCellColor = cellColor;
          vNormal = normalMatrix * normal;
          gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        }`,
      fragmentShader: `
        uniform sampler2D bands;
        uniform float numberOfBands, spacing, chosenCell;
        uniform bool hasCells;
        uniform vec3 avoided[2];
        uniform float pixelRatio;
        varying float vDistance, vCell;
        varying vec3 vNormal, vCellColor;
        void main() {
          float band = clamp(floor(vDistance / spacing), 0.0, numberOfBands - 1.0);
          vec3 color = texture2D(bands, vec2((band + 0.5) / numberOfBands, 0.5)).rgb;
          if(vDistance < -1.5)
            color = mod(gl_FragCoord.x + gl_FragCoord.y, 12.0 * pixelRatio) < 6.0 * pixelRatio
              ? avoided[0] : avoided[1];
          else if(hasCells)
            color = (abs(vCell - chosenCell) < 0.5 ? mix(vCellColor, vec3(1.0), 0.55) : vCellColor)
              * (mod(band, 2.0) < 0.5 ? 1.0 : 0.93);
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
    return lineMeshOf(decode(group.points, Float32Array), decode(group.lengths, Uint32Array), color, width);
  }

  function lineMeshOf(xyz, lengths, color, width) {
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

  return { ROLES, UNREACHED, AVOIDED, NO_CELL, MOST_NUMBERS, limits, points, triangles, distances, cells, isAvoided,
    normals, resolution, decode, rounded, css, bandColor, cellColor, surfaceGeometry, surfaceMaterial, lineMesh,
    lineMeshOf, dots, numberedDots };
}
