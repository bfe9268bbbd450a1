// Draws both sides into one canvas: with WebGL or, more slowly, without.

import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  DoubleSide,
  Mesh,
  Scene,
  ShaderMaterial,
  WebGLRenderer,
} from "three";

export const PAINTS = { measure: 0, pattern: 1, plain: 2 };

const PLAIN = [185, 190, 201];

// The light of the figures of the manual, in the axes of the camera
const AMBIENT = 0.56;
const LIGHTS = [
  [0.42, [-0.408, 0.589, 0.725]],
  [0.14, [0.784, -0.196, 0.588]],
];

const VERTEX_SHADER = `
  attribute vec3 right, rightNormal;
  attribute float shade;
  uniform float morph;
  varying vec3 vNormal, vLeft, vRight;
  flat varying float vShade;

  void main() {
    vNormal = normalMatrix * mix(normal, rightNormal, morph);
    vLeft = position;
    vRight = right;
    vShade = shade;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(mix(position, right, morph), 1.);
  }`;

// The pattern of a sphere has a hue for each longitude and is lighter to the north, with meridians and parallels; near the poles, there are
// fewer meridians. The pattern of two surfaces is defined on the left one: planes, and hues around the second axis.
const FRAGMENT_SHADER = `
  uniform sampler2D palette;
  uniform int paint;
  uniform bool has_sphere;
  varying vec3 vNormal, vLeft, vRight;
  flat varying float vShade;

  vec3 from_oklab(float lightness, float chroma, float hue) {
    vec2 c = chroma * vec2(cos(hue), sin(hue));
    vec3 lms = lightness + mat2x3(0.3963, -0.1056, -0.0895, 0.2158, -0.0639, -1.2915) * c;
    vec3 rgb = mat3(4.0767, -1.2684, -0.0042, -3.3077, 2.6098, -0.7034, 0.2310, -0.3413, 1.7076) * (lms * lms * lms);
    return pow(clamp(rgb, 0., 1.), vec3(1. / 2.2));
  }

  float distance_to_grid(float angle, float grid) {
    return abs(angle - grid * round(angle / grid));
  }

  vec3 globe(vec3 p) {
    const float grid = radians(15.);
    float longitude = atan(p.x, p.z), latitude = asin(clamp(p.y, -1., 1.));
    vec3 colour = from_oklab(0.76 + 0.083 * latitude, 0.13 * sqrt(cos(latitude)), longitude);
    float to_meridian = distance_to_grid(longitude, abs(latitude) > radians(60.) ? 2. * grid : grid) * cos(latitude);
    float to_parallel = distance_to_grid(latitude, grid);
    float to_line = min(to_meridian, to_parallel), pixel = max(fwidth(to_line), 1e-6);
    float line = clamp(0.5 + (max(radians(0.3), 0.5 * pixel) - to_line) / pixel, 0., 1.);
    return mix(colour, 0.35 * colour, abs(latitude) < radians(82.5) ? line : 0.);
  }

  vec3 planes(vec3 p) {
    vec3 colour = from_oklab(0.76 + 0.08 * p.y, 0.13 * smoothstep(0., 0.3, length(p.xz)), atan(p.x, p.z));
    const float grid = 0.125;
    vec3 to_line = abs(p - grid * round(p / grid)) / max(fwidth(p), 1e-6); // in pixels
    float line = 1. - smoothstep(0.5, 1.2, min(min(to_line.x, to_line.y), to_line.z));
    return mix(colour, 0.35 * colour, line);
  }

  void main() {
    vec3 colour = paint == ${PAINTS.measure} ? texelFetch(palette, ivec2(int(vShade + 0.5), 0), 0).rgb
                : paint == ${PAINTS.pattern} ? (has_sphere ? globe(normalize(vRight)) : planes(vLeft))
                : vec3(${PLAIN.map((value) => (value / 255).toFixed(3))});
    vec3 n = normalize(vNormal);
    n *= n.z < 0. ? -1. : 1.;
    float light = ${AMBIENT}${LIGHTS.map(([strength, v]) => `+ ${strength} * max(dot(n, vec3(${v})), 0.)`).join("")};
    gl_FragColor = vec4(colour * light, 1.);
  }`;

export class WebGLPainter {
  constructor(canvas, surfaces) {
    this.renderer = new WebGLRenderer({ canvas, alpha: true, antialias: true });
    this.renderer.debug.onShaderError = (gl, program, vertex, fragment) => {
      throw new Error([vertex, fragment].map((shader) => gl.getShaderInfoLog(shader)).join("\n"));
    };
    const [left, right] = surfaces.sides;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(left.corners, 3));
    geometry.setAttribute("normal", new BufferAttribute(left.normals, 3, true));
    geometry.setAttribute("right", new BufferAttribute(right.corners, 3));
    geometry.setAttribute("rightNormal", new BufferAttribute(right.normals, 3, true));
    this.shades = new BufferAttribute(new Uint16Array(surfaces.vertices.length), 1);
    geometry.setAttribute("shade", this.shades);
    this.palette = { value: null };
    this.scenes = surfaces.sides.map(() => {
      const uniforms = {
        morph: { value: 0 },
        paint: { value: 0 },
        palette: this.palette,
        has_sphere: { value: surfaces.facts.has_sphere },
      };
      const material = new ShaderMaterial({
        uniforms,
        vertexShader: VERTEX_SHADER,
        fragmentShader: FRAGMENT_SHADER,
        side: DoubleSide,
      });
      const mesh = new Mesh(geometry, material);
      mesh.frustumCulled = false;
      return new Scene().add(mesh);
    });
  }

  paintFaces({ shades, colours }) {
    this.palette.value?.dispose();
    this.palette.value = new DataTexture(new Uint8Array(colours.flatMap((c) => [...c, 255])), colours.length, 1);
    this.palette.value.needsUpdate = true;
    for (let i = 0; i < this.shades.array.length; ++i) this.shades.array[i] = shades[Math.floor(i / 3)];
    this.shades.needsUpdate = true;
  }

  resize(width, height) {
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
  }

  draw(views, morphs, paint) {
    const { clientHeight } = this.renderer.domElement;
    this.renderer.setScissorTest(true); // again, because the browser may have lost and restored the device
    views.forEach(({ camera, element }, i) => {
      const { uniforms } = this.scenes[i].children[0].material;
      uniforms.morph.value = morphs[i];
      uniforms.paint.value = paint;
      const { offsetLeft: x, offsetTop: y, offsetWidth: width, offsetHeight: height } = element;
      const box = [x, clientHeight - y - height, width, height];
      this.renderer.setViewport(...box);
      this.renderer.setScissor(...box);
      this.renderer.render(this.scenes[i], camera);
    });
  }
}

// Draws faces from back to front, each in one colour; without the pattern, which is finer than faces.
export class CanvasPainter {
  constructor(canvas, surfaces) {
    this.context = canvas.getContext("2d");
    this.surfaces = surfaces;
  }

  paintFaces({ shades, colours }) {
    Object.assign(this, { shades, colours });
  }

  resize(width, height) {
    Object.assign(this.context.canvas, { width, height });
  }

  draw(views, morphs, paint) {
    this.context.clearRect(0, 0, this.context.canvas.width, this.context.canvas.height);
    views.forEach((view, i) => {
      this.context.save();
      this.context.translate(view.element.offsetLeft, view.element.offsetTop);
      this.#drawSide(view, morphs[i], paint);
      this.context.restore();
    });
  }

  #drawSide({ camera, element }, morph, paint) {
    const [from, to] = this.surfaces.sides.map((side) => side.corners);
    const { offsetWidth: width, offsetHeight: height } = element;
    camera.updateMatrixWorld();
    const m = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse).elements;
    const seen = new Float32Array(from.length);
    for (let i = 0; i < from.length; i += 3) {
      const [x, y, z] = [0, 1, 2].map((k) => from[i + k] + morph * (to[i + k] - from[i + k]));
      seen[i] = (0.5 + 0.5 * (m[0] * x + m[4] * y + m[8] * z + m[12])) * width;
      seen[i + 1] = (0.5 - 0.5 * (m[1] * x + m[5] * y + m[9] * z + m[13])) * height;
      seen[i + 2] = -(m[2] * x + m[6] * y + m[10] * z + m[14]) * 0.5 * (camera.far - camera.near);
    }
    const unit = ((0.5 * width) / camera.right) * camera.zoom; // pixels
    const depths = new Float32Array(seen.length / 9).map((_, f) => seen[9 * f + 2] + seen[9 * f + 5] + seen[9 * f + 8]);
    const order = Uint32Array.from(depths.keys()).sort((f, g) => depths[f] - depths[g]);
    const { context } = this;
    for (const f of order) {
      const [ax, ay, az, bx, by, bz, cx, cy, cz] = seen.subarray(9 * f, 9 * f + 9);
      const u = [(bx - ax) / unit, (ay - by) / unit, bz - az],
        v = [(cx - ax) / unit, (ay - cy) / unit, cz - az];
      const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      const length = (Math.hypot(...n) || 1) * (n[2] < 0 ? -1 : 1);
      const light = LIGHTS.reduce((sum, [strength, to]) => {
        return sum + strength * Math.max((n[0] * to[0] + n[1] * to[1] + n[2] * to[2]) / length, 0);
      }, AMBIENT);
      const colour = paint === PAINTS.measure ? this.colours[this.shades[f]] : PLAIN;
      context.fillStyle = context.strokeStyle = `rgb(${colour.map((value) => value * light).join(" ")})`;
      context.beginPath();
      context.moveTo(ax, ay);
      context.lineTo(bx, by);
      context.lineTo(cx, cy);
      context.closePath();
      context.fill();
      context.stroke();
    }
  }
}
