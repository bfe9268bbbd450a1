// One side of the page: a camera that is controlled by pointers and keys.

import { MathUtils, OrthographicCamera, Quaternion, Raycaster, Vector2, Vector3 } from "three";
import { TrackballControls } from "three/addons/controls/TrackballControls.js";

const HALF_HEIGHT = 1.05; // of the visible region of a side
const STEP = MathUtils.degToRad(6);
const ZOOM_STEP = 1.15;
const PAN_STEP = 0.1;
const TAP_RADIUS = { mouse: 4, pen: 8, touch: 12 }; // in pixels: a longer way is a drag

export class View {
  // Calls onMove(view) after the camera has moved, onPoint(view, x, y) with coordinates between -1 and 1, and onReset().
  constructor(element, start, { onMove, onPoint, onReset }) {
    this.element = element;
    this.camera = new OrthographicCamera(-1, 1, 1, -1, -100, 100);
    this.camera.position.copy(start.direction).multiplyScalar(10);
    this.camera.up.copy(start.up);
    this.controls = new TrackballControls(this.camera, element);
    this.controls.staticMoving = true;
    this.controls.rotateSpeed = 3;
    this.controls.zoomSpeed = 1.5;
    this.controls.minZoom = 0.3;
    this.controls.maxZoom = 200;
    this.controls.keys = [];
    this.controls.addEventListener("change", () => onMove(this));
    this.resize();

    let pressed = null;
    const point = (event) => {
      const box = element.getBoundingClientRect();
      const x = (2 * (event.clientX - box.left)) / box.width - 1;
      onPoint(this, x, 1 - (2 * (event.clientY - box.top)) / box.height);
    };
    element.addEventListener("pointerdown", (event) => (pressed = new Vector2(event.clientX, event.clientY)));
    element.addEventListener(
      "pointermove",
      (event) => event.buttons === 0 && event.pointerType !== "touch" && point(event),
    );
    element.addEventListener("pointerup", (event) => {
      if (pressed?.distanceTo(new Vector2(event.clientX, event.clientY)) < (TAP_RADIUS[event.pointerType] ?? 4))
        point(event);
      pressed = null;
    });
    element.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      const arrow = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0] }[event.key];
      const zoom = { "+": ZOOM_STEP, "=": ZOOM_STEP, "-": 1 / ZOOM_STEP }[event.key];
      if (arrow && event.shiftKey) this.#pan(...arrow);
      else if (arrow) this.#rotate(...arrow);
      else if (zoom)
        this.camera.zoom = MathUtils.clamp(this.camera.zoom * zoom, this.controls.minZoom, this.controls.maxZoom);
      else if (event.key === "Enter") onPoint(this, 0, 0);
      else if (event.key === "0") onReset();
      else return;
      event.preventDefault();
      this.camera.updateProjectionMatrix();
      onMove(this);
    });
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.element;
    const scale = HALF_HEIGHT / Math.min(width, height);
    Object.assign(this.camera, {
      left: -width * scale,
      right: width * scale,
      top: height * scale,
      bottom: -height * scale,
    });
    this.camera.updateProjectionMatrix();
    this.controls.handleResize();
  }

  reset() {
    this.controls.reset();
  }

  // Copies the rotation and zoom of another view, but not its translation.
  follow({ camera, controls }) {
    this.camera.position.copy(camera.position).sub(controls.target).add(this.controls.target);
    this.camera.up.copy(camera.up);
    this.camera.zoom = camera.zoom;
    this.camera.updateProjectionMatrix();
    this.controls.update();
  }

  ray(x, y) {
    const raycaster = new Raycaster();
    this.camera.updateMatrixWorld();
    raycaster.setFromCamera(new Vector2(x, y), this.camera);
    return raycaster.ray;
  }

  // The position of a point in the view, with coordinates between -1 and 1
  project(point) {
    this.camera.updateMatrixWorld();
    return new Vector3(...point).project(this.camera);
  }

  // The axes to the right and up in the view
  #axes() {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const side = this.camera.up.clone().cross(offset).normalize();
    return { offset, side, up: offset.clone().cross(side).normalize() };
  }

  // Moves the surface.
  #pan(down, right) {
    const { side, up } = this.#axes();
    const shift = side
      .multiplyScalar(-right)
      .addScaledVector(up, down)
      .multiplyScalar(PAN_STEP / this.camera.zoom);
    this.camera.position.add(shift);
    this.controls.target.add(shift);
  }

  #rotate(down, right) {
    const { offset, side, up } = this.#axes();
    const turn = new Quaternion().setFromAxisAngle(up, -STEP * right);
    turn.multiply(new Quaternion().setFromAxisAngle(side, -STEP * down));
    this.camera.up.copy(up).applyQuaternion(turn);
    this.camera.position.copy(this.controls.target).add(offset.applyQuaternion(turn));
    this.camera.lookAt(this.controls.target);
  }
}

// Enlarges sides by the same factor so that they fill the initial view, by at most 25 %, because otherwise tips would be cut off in other
// poses.
export function fit(sides, { direction }) {
  const thinnest = direction.toArray().indexOf(1);
  let extent = 0;
  for (const { corners } of sides)
    corners.forEach((x, i) => i % 3 !== thinnest && (extent = Math.max(extent, Math.abs(x))));
  const factor = Math.min(1 / extent, 1.25);
  for (const side of sides) {
    for (let i = 0; i < side.corners.length; ++i) side.corners[i] *= factor;
    side.scale /= factor;
  }
}

// Looks along the smallest extent of the surface, like the figures of the manual; the second axis is up, or else the third one.
export function startOf({ corners }) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < corners.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], corners[i]);
    high[i % 3] = Math.max(high[i % 3], corners[i]);
  }
  const extents = high.map((value, k) => value - low[k]);
  const thinnest = extents[2] <= Math.min(extents[0], extents[1]) * 1.0001 ? 2 : extents.indexOf(Math.min(...extents));
  const direction = new Vector3().setComponent(thinnest, 1);
  const up = new Vector3().setComponent(thinnest === 1 ? 2 : 1, 1);
  return { direction, up };
}
