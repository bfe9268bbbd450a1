// The two sides of the page: a mesh with two points for each vertex, from the data in the page.

// Below this cosine of the angle between the normals of a vertex and a face, the face has a sharp edge there.
const SMOOTH = Math.cos((40 * Math.PI) / 180);

function bytesOf(id) {
  const text = document.getElementById(id).textContent;
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

const floatsOf = (id) => new Float32Array(bytesOf(id).buffer);

function rotate(points, rotation) {
  for (let i = 0; i < points.length; i += 3) {
    const [x, y, z] = points.subarray(i, i + 3);
    for (let k = 0; k < 3; ++k) points[i + k] = rotation[3 * k] * x + rotation[3 * k + 1] * y + rotation[3 * k + 2] * z;
  }
}

// The points and normals of the corners of all faces: normals of vertices, or at sharp edges those of faces.
function cornersOf(points, vertices) {
  const corners = new Float32Array(3 * vertices.length);
  for (let i = 0; i < vertices.length; ++i) corners.set(points.subarray(3 * vertices[i], 3 * vertices[i] + 3), 3 * i);

  const ofFaces = new Float32Array(vertices.length);
  const ofVertices = new Float32Array(points.length);
  for (let i = 0; i < corners.length; i += 9) {
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = corners.subarray(i, i + 9);
    const normal = [
      (by - ay) * (cz - az) - (bz - az) * (cy - ay),
      (bz - az) * (cx - ax) - (bx - ax) * (cz - az),
      (bx - ax) * (cy - ay) - (by - ay) * (cx - ax),
    ];
    for (let k = 0; k < 3; ++k) {
      ofFaces[i / 3 + k] = normal[k];
      for (let j = 0; j < 3; ++j) ofVertices[3 * vertices[i / 3 + j] + k] += normal[k];
    }
  }
  const normals = new Int16Array(corners.length);
  const unit = (array, i) => {
    const length = Math.hypot(array[i], array[i + 1], array[i + 2]) || 1;
    return [array[i] / length, array[i + 1] / length, array[i + 2] / length];
  };
  for (let i = 0; i < vertices.length; ++i) {
    const smooth = unit(ofVertices, 3 * vertices[i]);
    const flat = unit(ofFaces, 3 * Math.floor(i / 3));
    const isSmooth = smooth[0] * flat[0] + smooth[1] * flat[1] + smooth[2] * flat[2] > SMOOTH;
    const normal = isSmooth ? smooth : flat;
    for (let k = 0; k < 3; ++k) normals[3 * i + k] = Math.round(32767 * normal[k]);
  }
  return { corners, normals };
}

export function readSurfaces() {
  const facts = JSON.parse(document.getElementById("facts").textContent);
  const bytes = bytesOf("corners");
  const vertices = facts.vertices > 65536 ? new Uint32Array(bytes.buffer) : new Uint16Array(bytes.buffer);
  const sides = ["left", "right"].map((name) => {
    const points = floatsOf(name);
    rotate(points, facts[name].rotation);
    return { ...facts[name], ...cornersOf(points, vertices) };
  });
  const measures = Object.entries(facts.measures).map(([name, fact]) => ({ name, ...fact, values: floatsOf(name) }));
  for (const [name, fact] of Object.entries(facts.classes))
    measures.push({ name, ...fact, values: new Uint16Array(bytesOf(name).buffer) });
  // The drawn faces may be parts of faces of the files.
  const numbers = facts.has_numbers
    ? ["left_faces", "right_faces"].map((id) => new Uint32Array(bytesOf(id).buffer))
    : null;
  return { facts, vertices, sides, measures, numbers, inverted: new Uint32Array(bytesOf("inverted").buffer) };
}

// The point with these barycentric coordinates in a face, interpolated between the left side (0) and the right one (1).
export function pointOf({ sides }, { face, weights }, morph) {
  return [0, 1, 2].map((k) => {
    let sum = 0;
    for (let j = 0; j < 3; ++j) {
      const i = 9 * face + 3 * j + k;
      sum += weights[j] * (sides[0].corners[i] + morph * (sides[1].corners[i] - sides[0].corners[i]));
    }
    return sum;
  });
}

// The first face on a ray, and the barycentric coordinates of the intersection; null if there is none.
export function firstOnRay({ sides }, { origin, direction }, morph) {
  const [from, to] = sides.map((side) => side.corners);
  const p = new Float64Array(9);
  let nearest = Infinity;
  let hit = null;
  for (let i = 0; i < from.length; i += 9) {
    for (let k = 0; k < 9; ++k) p[k] = from[i + k] + morph * (to[i + k] - from[i + k]);
    const ux = p[3] - p[0],
      uy = p[4] - p[1],
      uz = p[5] - p[2];
    const vx = p[6] - p[0],
      vy = p[7] - p[1],
      vz = p[8] - p[2];
    const cx = direction.y * vz - direction.z * vy;
    const cy = direction.z * vx - direction.x * vz;
    const cz = direction.x * vy - direction.y * vx;
    const volume = ux * cx + uy * cy + uz * cz;
    if (volume === 0) continue;
    const ox = origin.x - p[0],
      oy = origin.y - p[1],
      oz = origin.z - p[2];
    const b = (ox * cx + oy * cy + oz * cz) / volume;
    if (!(b >= 0 && b <= 1)) continue;
    const dx = oy * uz - oz * uy,
      dy = oz * ux - ox * uz,
      dz = ox * uy - oy * ux;
    const c = (direction.x * dx + direction.y * dy + direction.z * dz) / volume;
    if (!(c >= 0 && b + c <= 1)) continue;
    const distance = (vx * dx + vy * dy + vz * dz) / volume;
    if (distance < nearest) {
      nearest = distance;
      hit = { face: i / 9, weights: [1 - b - c, b, c] };
    }
  }
  return hit;
}
