// One side of the page: a camera, and what turns it by pointers and keys.

import { MathUtils, OrthographicCamera, Quaternion, Raycaster, Vector2, Vector3 } from "three";
import { TrackballControls } from "three/addons/controls/TrackballControls.js";

const HALF_HEIGHT = 1.05; // of what is seen of a side
const STEP = MathUtils.degToRad(6);
const ZOOM_STEP = 1.15;

export class View {
  // Calls onTurn(view) when the camera has moved, and onPoint(view, x, y) with a place between -1 and 1.
  constructor(element, start, { onTurn, onPoint }) {
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
    this.controls.addEventListener("change", () => onTurn(this));
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
      if (pressed?.distanceTo(new Vector2(event.clientX, event.clientY)) < 4) point(event);
      pressed = null;
    });
    element.addEventListener("keydown", (event) => {
      const turns = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0] }[event.key];
      const zoom = { "+": ZOOM_STEP, "=": ZOOM_STEP, "-": 1 / ZOOM_STEP }[event.key];
      if (turns) this.#turn(...turns);
      else if (zoom)
        this.camera.zoom = MathUtils.clamp(this.camera.zoom * zoom, this.controls.minZoom, this.controls.maxZoom);
      else if (event.key === "Enter") onPoint(this, 0, 0);
      else return;
      event.preventDefault();
      this.camera.updateProjectionMatrix();
      onTurn(this);
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

  // Turns and zooms like another view; each keeps what it has been shifted by.
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

  // Where a point is seen, between -1 and 1
  project(point) {
    this.camera.updateMatrixWorld();
    return new Vector3(...point).project(this.camera);
  }

  #turn(down, right) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const side = this.camera.up.clone().cross(offset).normalize();
    const up = offset.clone().cross(side).normalize();
    const turn = new Quaternion().setFromAxisAngle(up, -STEP * right);
    turn.multiply(new Quaternion().setFromAxisAngle(side, -STEP * down));
    this.camera.up.copy(up).applyQuaternion(turn);
    this.camera.position.copy(this.controls.target).add(offset.applyQuaternion(turn));
    this.camera.lookAt(this.controls.target);
  }
}

// Enlarges sides, by the same factor, to the size at which they are just seen as a whole at the start; not by more than a quarter, as
// tips would be cut off when they are turned.
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

// Along the thinnest extent of the surface, as the figures of the manual; the second axis is up, or else the third one.
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
