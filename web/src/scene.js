// The part in three dimensions: one draw call, colours by a texture with a texel for each line.
import { BufferAttribute, BufferGeometry, Color, DataTexture, DoubleSide, FrontSide, LineSegments, Mesh,
  NearestFilter, PerspectiveCamera, RGBAFormat, Scene, ShaderMaterial, UnsignedByteType, Vector3, Vector4, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { cornerNormals } from "./decode.js";
import { schemeOf } from "./colors.js";
import { $ } from "./dom.js";
import { Pace } from "./pace.js";

const kTextureWidth = 1024;
const kPerspective = 28, kParallel = 0.5; // degrees

const kVertex = `
uniform sampler2D palette; uniform vec2 paletteSize;
attribute float dev; attribute float own;
varying float vDev; varying vec3 vNormal; varying vec3 vPlace; flat varying vec4 vTexel;
void main() {
  float i = floor(own + 0.5), y = floor(i / paletteSize.x);
  vTexel = texture2D(palette, (vec2(i - y * paletteSize.x, y) + 0.5) / paletteSize);
  vDev = dev; vNormal = normalMatrix * normal; vPlace = position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const kFragment = `
uniform vec4 plane; uniform float byDeviation; uniform float selecting;
uniform float lo; uniform float hi; uniform vec3 good; uniform vec3 lightExcess; uniform vec3 excess; uniform vec3 lightGouge; uniform vec3 gouge;
uniform vec3 cutFace;
varying float vDev; varying vec3 vNormal; varying vec3 vPlace; flat varying vec4 vTexel;
vec3 deviationColor(float d) {
  float over = max(d - hi, lo - d) / (hi - lo);
  if (over <= 0.0) return good;
  return d > 0.0 ? mix(lightExcess, excess, min(over, 1.0)) : mix(lightGouge, gouge, min(over, 1.0));
}
void main() {
  if (dot(plane.xyz, vPlace) > plane.w) discard;
  vec3 base = mix(vTexel.rgb, deviationColor(vDev), byDeviation);
  if (!gl_FrontFacing) { gl_FragColor = vec4(cutFace * (0.92 + 0.08 * step(0.5, fract((gl_FragCoord.x + gl_FragCoord.y) / 8.0))), 1.0); return; }
  vec3 n = normalize(vNormal);
  float light = 0.46 + 0.42 * max(n.z, 0.0) + 0.16 * max(dot(n, normalize(vec3(-0.5, 0.8, 0.4))), 0.0);
  vec3 c = base * min(light, 1.08);
  if (selecting > 0.5) c = vTexel.a > 0.5 ? c : mix(c, vec3(dot(c, vec3(0.3, 0.59, 0.11))), 0.85) * 0.35 + cutFace * 0.42;
  gl_FragColor = vec4(c, 1.0);
}`;

// What is chosen, through what stands before it.
const kChosenFragment = `
uniform vec4 plane; varying vec3 vPlace; flat varying vec4 vTexel;
void main() {
  if (vTexel.a < 0.5 || dot(plane.xyz, vPlace) > plane.w) discard;
  gl_FragColor = vec4(vTexel.rgb, 0.75);
}`;

const kGhostFragment = `
uniform vec4 plane; uniform vec3 tint; varying vec3 vNormal; varying vec3 vPlace;
void main() {
  if (dot(plane.xyz, vPlace) > plane.w) discard;
  float rim = 1.0 - abs(normalize(vNormal).z);
  gl_FragColor = vec4(tint, 0.16 + 0.4 * rim * rim);
}`;

const bytes = (rgb) => new Color(rgb[0] / 255, rgb[1] / 255, rgb[2] / 255);

function expand(mesh, withOwners) {
  const corners = mesh.index.length, place = new Float32Array(3 * corners);
  const dev = new Float32Array(corners), own = new Float32Array(corners);
  for (let i = 0; i < corners; ++i) {
    const v = mesh.index[i];
    place[3 * i] = mesh.position[3 * v]; place[3 * i + 1] = mesh.position[3 * v + 1]; place[3 * i + 2] = mesh.position[3 * v + 2];
    dev[i] = mesh.deviation[v];
    own[i] = mesh.owner[(i / 3) | 0];
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(place, 3));
  geometry.setAttribute("normal", new BufferAttribute(cornerNormals(mesh), 4, true));
  if (withOwners) {
    geometry.setAttribute("dev", new BufferAttribute(dev, 1));
    geometry.setAttribute("own", new BufferAttribute(own, 1));
  }
  return geometry;
}

function boundsOf(position) {
  const lo = new Vector3(Infinity, Infinity, Infinity), hi = new Vector3(-Infinity, -Infinity, -Infinity);
  for (let i = 0; i < position.length; i += 3) {
    lo.x = Math.min(lo.x, position[i]); lo.y = Math.min(lo.y, position[i + 1]); lo.z = Math.min(lo.z, position[i + 2]);
    hi.x = Math.max(hi.x, position[i]); hi.y = Math.max(hi.y, position[i + 1]); hi.z = Math.max(hi.z, position[i + 2]);
  }
  return { lo, hi, centre: lo.clone().add(hi).multiplyScalar(0.5), size: hi.distanceTo(lo) || 1 };
}

// Lines a little nearer to the eye than their faces, the nominal's faces a little farther than the
// part's: along the line of sight, so that nothing moves in the picture.
const shifted = (by) => `uniform float size; varying vec3 vPlace; varying vec3 vNormal; void main() { vPlace = position; vNormal = normalMatrix * normal; vec4 p = modelViewMatrix * vec4(position, 1.0); p.xyz *= 1.0 - ${by} * size / length(p.xyz); gl_Position = projectionMatrix * p; }`;

function lineObject(mesh, plane, size, { alpha = 0.62, depthTest = true } = {}) {
  const place = new Float32Array(3 * mesh.crease.length);
  mesh.crease.forEach((v, i) => place.set(mesh.position.subarray(3 * v, 3 * v + 3), 3 * i));
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(place, 3));
  const material = new ShaderMaterial({
    uniforms: { plane: { value: plane }, size: { value: size }, ink: { value: new Color() }, alpha: { value: alpha } },
    vertexShader: shifted("0.0016"),
    fragmentShader: "uniform vec4 plane; uniform vec3 ink; uniform float alpha; varying vec3 vPlace; void main() { if (dot(plane.xyz, vPlace) > plane.w) discard; gl_FragColor = vec4(ink, alpha); }",
    transparent: true, depthTest,
  });
  return new LineSegments(geometry, material);
}

export class PartView {
  /// `lies`: of a lathe, whose axis Z is shown from left to right and X upwards.
  constructor(canvas, part, nominal, keyCount, onChange, lies = false) {
    this.lies = lies;
    this.up = lies ? new Vector3(1, 0, 0) : new Vector3(0, 0, 1);
    this.right = lies ? new Vector3(0, 0, 1) : new Vector3(1, 0, 0);
    this.away = this.up.clone().cross(this.right);
    this.canvas = canvas; this.part = part; this.onChange = onChange;
    this.renderer = new WebGLRenderer({ canvas, antialias: false, alpha: true, powerPreference: "high-performance" });
    this.renderer.outputColorSpace = "srgb-linear"; // colours are written as they are measured
    this.pace = new Pace(this.renderer, () => { this.onRest?.(); this.draw(); });
    this.seen = [part.bounds ?? part.position]; // what a view shows all of
    this.bounds = boundsOf(this.seen[0]);
    this.camera = new PerspectiveCamera(kPerspective, 1, this.bounds.size / 500, this.bounds.size * 40);
    this.camera.up.copy(this.up);
    this.scene = new Scene();
    this.plane = new Vector4(0, 0, 0, 1);
    this.rows = Math.max(1, Math.ceil(keyCount / kTextureWidth));
    this.texels = new Uint8Array(4 * kTextureWidth * this.rows);
    this.palette = new DataTexture(this.texels, kTextureWidth, this.rows, RGBAFormat, UnsignedByteType);
    this.palette.minFilter = this.palette.magFilter = NearestFilter;
    this.material = new ShaderMaterial({ vertexShader: kVertex, fragmentShader: kFragment, side: FrontSide, uniforms: {
      palette: { value: this.palette }, paletteSize: { value: { x: kTextureWidth, y: this.rows } }, plane: { value: this.plane },
      byDeviation: { value: 0 }, selecting: { value: 0 }, lo: { value: -0.02 }, hi: { value: 0.02 }, cutFace: { value: new Color(0.6, 0.6, 0.6) },
      good: { value: new Color() }, lightExcess: { value: new Color() }, excess: { value: new Color() }, lightGouge: { value: new Color() }, gouge: { value: new Color() } } });
    this.materials = [this.material];
    this.mesh = new Mesh(expand(part, true), this.material);
    this.scene.add(this.mesh);
    this.overlay = new Mesh(this.mesh.geometry, new ShaderMaterial({ vertexShader: kVertex, fragmentShader: kChosenFragment, uniforms: this.material.uniforms, side: DoubleSide, transparent: true, depthTest: false, depthWrite: false }));
    this.overlay.renderOrder = 4;
    this.overlay.visible = false;
    this.scene.add(this.overlay);
    this.edges = lineObject(part, this.plane, this.bounds.size);
    this.scene.add(this.edges);
    if (nominal) this.addNominal(nominal);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.controls.addEventListener("start", () => { this.turning = true; });
    this.controls.addEventListener("end", () => { this.turning = false; });
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
    this.look("iso", false);
  }
  addNominal(nominal) {
    const material = new ShaderMaterial({ uniforms: { plane: { value: this.plane }, size: { value: this.bounds.size }, tint: { value: new Color(0.1, 0.1, 0.12) } }, transparent: true, depthWrite: false, side: DoubleSide,
      vertexShader: shifted("-0.0012"), fragmentShader: kGhostFragment });
    this.ghost = new Mesh(expand(nominal, false), material);
    // Through the part: what should have been cut away shows as its outline.
    this.ghostEdges = lineObject(nominal, this.plane, this.bounds.size, { alpha: 0.8, depthTest: false });
    for (const o of [this.ghost, this.ghostEdges]) { o.visible = false; o.renderOrder = 2; this.scene.add(o); }
  }
  /// Pixels at the top of the canvas that the buttons lie over.
  get covered() {
    const bar = $("bar").getBoundingClientRect(), box = this.canvas.getBoundingClientRect();
    return Math.max(0, Math.min(bar.bottom - box.top, box.height / 2));
  }
  resize() {
    const w = this.canvas.clientWidth, h = this.canvas.clientHeight;
    if (!w || !h) return;
    this.sharpness = 0; // of the pixels that the canvas has: none yet
    this.camera.aspect = w / h;
    this.camera.setViewOffset(w, h, 0, -this.covered / 2, w, h); // the middle of what is free
    this.draw();
  }
  // As many pixels as the picture at hand is drawn with.
  fitPixels() {
    const sharpness = this.pace.sharpness(this.shown);
    if (sharpness === this.sharpness) return;
    this.sharpness = sharpness;
    this.renderer.setPixelRatio(sharpness * Math.min(devicePixelRatio || 1, 2));
    this.renderer.setSize(this.canvas.clientWidth, this.canvas.clientHeight, false);
  }
  get shown() { return this.mesh.visible ? "part" : "run"; }
  draw() {
    if (this.pending) return;
    this.pending = requestAnimationFrame(() => {
      this.pending = 0;
      if (this.turning) this.pace.move();
      this.drawNow();
      this.onChange();
    });
  }
  drawNow() {
    this.fitPixels();
    this.setDepth();
    this.pace.draw(this.scene, this.camera, this.shown);
  }
  setScheme(safe, band) {
    const u = this.material.uniforms, s = schemeOf(safe);
    u.lo.value = band.lo; u.hi.value = band.hi;
    for (const k of ["good", "lightExcess", "excess", "lightGouge", "gouge"]) u[k].value = bytes(s[k]);
    this.draw();
  }
  setInk(ink, ground) {
    this.edges.material.uniforms.ink.value.set(ink).convertLinearToSRGB();
    if (this.ghost) { this.ghost.material.uniforms.tint.value.set(ink).convertLinearToSRGB(); this.ghostEdges.material.uniforms.ink.value.set(ink).convertLinearToSRGB(); }
    this.material.uniforms.cutFace.value.set(ground).convertLinearToSRGB();
    this.draw();
  }
  setColors(byDeviation, colorOf, count) {
    this.material.uniforms.byDeviation.value = byDeviation ? 1 : 0;
    for (let i = 0; i < count; ++i) this.texels.set(colorOf(i), 4 * i);
    this.palette.needsUpdate = true;
    this.draw();
  }
  select(keys) {
    const chosen = new Set(keys);
    for (let i = 0; i < this.texels.length / 4; ++i) this.texels[4 * i + 3] = chosen.has(i) ? 255 : 0;
    this.material.uniforms.selecting.value = chosen.size ? 1 : 0;
    this.overlay.visible = chosen.size > 0 && this.mesh.visible;
    this.palette.needsUpdate = true;
    this.draw();
  }
  /// The box about the faces of these keys as { lo, hi }, or null.
  boundsOfKeys(keys) {
    const chosen = new Set(keys), { position, index, owner } = this.part, lo = [Infinity, Infinity, Infinity], hi = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < index.length; ++i) {
      if (!chosen.has(owner[(i / 3) | 0])) continue;
      for (let k = 0; k < 3; ++k) { const x = position[3 * index[i] + k]; lo[k] = Math.min(lo[k], x); hi[k] = Math.max(hi[k], x); }
    }
    return lo[0] <= hi[0] ? { lo, hi } : null;
  }
  setPlane(axis, share) {
    const a = "XYZ".indexOf(axis);
    if (!axis) this.plane.set(0, 0, 0, 1);
    else {
      const { lo, hi } = this.bounds, at = lo.getComponent(a) + share * (hi.getComponent(a) - lo.getComponent(a));
      this.plane.set(a === 0 ? 1 : 0, a === 1 ? 1 : 0, a === 2 ? 1 : 0, at);
    }
    // Without a plane no back of a face is ever seen.
    for (const material of this.materials) material.side = axis ? DoubleSide : FrontSide;
    this.draw();
    return this.plane.w;
  }
  showNominal(on) { if (this.ghost) { this.ghost.visible = this.ghostEdges.visible = on; this.draw(); } }
  showEdges(on) { this.edgesWanted = on; this.edges.visible = on && this.mesh.visible; this.draw(); }
  /// The exact part, or nothing of it: what is played is shown in its place.
  showPart(on) { this.mesh.visible = on; this.overlay.visible = on && this.material.uniforms.selecting.value > 0; this.showEdges(this.edgesWanted ?? true); }

  /// Without perspective: from so far away that lines of sight are parallel to the pixel.
  setParallel(on) {
    const { camera, controls } = this, before = Math.tan((camera.fov * Math.PI) / 360);
    camera.fov = on ? kParallel : kPerspective;
    const factor = before / Math.tan((camera.fov * Math.PI) / 360);
    camera.position.sub(controls.target).multiplyScalar(factor).add(controls.target);
    this.draw();
  }
  get parallel() { return this.camera.fov === kParallel; }
  // What is near the part is drawn with all the depth there is.
  setDepth() {
    const { camera, bounds } = this, away = camera.position.distanceTo(bounds.centre), reach = 3 * bounds.size;
    camera.near = Math.max(away - reach, away / 2000);
    camera.far = away + reach;
    camera.updateProjectionMatrix();
  }
  // How far from the centre, in this direction, all of the part is seen.
  fitDistance(away) {
    const { centre: c, size } = this.bounds, side = this.up.clone().cross(away).normalize(), over = away.clone().cross(side);
    const high = Math.tan((this.camera.fov * Math.PI) / 360), wide = 0.92 * high * this.camera.aspect, free = 0.92 * high * (1 - this.covered / this.canvas.clientHeight);
    let distance = 0.1 * size;
    for (const places of this.seen)
      for (let i = 0; i < places.length; i += 3) {
        const x = places[i] - c.x, y = places[i + 1] - c.y, z = places[i + 2] - c.z;
        const right = Math.abs(x * side.x + y * side.y + z * side.z) / wide, up = Math.abs(x * over.x + y * over.y + z * over.z) / free;
        distance = Math.max(distance, x * away.x + y * away.y + z * away.z + Math.max(right, up));
      }
    return distance;
  }
  look(view, glide = true) {
    const from = { iso: this.lies ? [0.4, -0.95, 0.6] : [0.55, -0.95, 0.85], top: [0, -1e-4, 1], front: [0, -1, 0], right: [1, 0, 0] }[view];
    const away = this.inWorld(from).normalize(), eye = away.clone().multiplyScalar(this.fitDistance(away)).add(this.bounds.centre);
    this.fly(eye, this.bounds.centre, glide);
  }
  /// A direction that is given by right, away and up.
  inWorld([right, away, up]) {
    return new Vector3().addScaledVector(this.right, right).addScaledVector(this.away, away).addScaledVector(this.up, up);
  }
  flyTo(place, normal, extent) {
    const target = new Vector3(...place), out = new Vector3(...normal);
    if (out.lengthSq() === 0) out.copy(this.up);
    // Obliquely: straight down a normal every depth looks the same.
    out.add(this.inWorld([0.28, -0.42, 0.55])).normalize();
    const span = Math.hypot(...[0, 1, 2].map((k) => extent[1][k] - extent[0][k]));
    const reach = Math.min(this.fitDistance(out), Math.max(span * 2.4, this.bounds.size * 0.28));
    this.fly(out.multiplyScalar(reach).add(target), target, true);
  }
  fly(eye, target, glide) {
    cancelAnimationFrame(this.flight);
    const calm = !glide || matchMedia("(prefers-reduced-motion: reduce)").matches;
    const eye0 = this.camera.position.clone(), target0 = this.controls ? this.controls.target.clone() : target, begin = performance.now();
    const frame = (now) => {
      const t = calm ? 1 : Math.min(1, (now - begin) / 450), s = t * t * (3 - 2 * t);
      this.camera.position.lerpVectors(eye0, eye, s);
      if (this.controls) { this.controls.target.lerpVectors(target0, target, s); this.controls.update(); }
      this.draw();
      if (t < 1) this.flight = requestAnimationFrame(frame);
    };
    frame(begin);
  }
  turn(dx, dy) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    offset.applyAxisAngle(this.up, dx);
    const side = this.up.clone().cross(offset).normalize(), tilted = offset.clone().applyAxisAngle(side, dy);
    if (Math.abs(tilted.clone().normalize().dot(this.up)) < 0.9995) offset.copy(tilted);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update(); this.draw();
  }
  zoom(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update(); this.draw();
  }
  /// Place on the canvas in pixels, and whether it is in front of the camera.
  project(place) {
    this.camera.updateMatrixWorld(); // a flight may be under way, with its picture still to come
    const p = new Vector3(...place).project(this.camera);
    return { x: ((p.x + 1) / 2) * this.canvas.clientWidth, y: ((1 - p.y) / 2) * this.canvas.clientHeight, front: p.z < 1 };
  }
  /// From the eye through a place on the canvas.
  ray(x, y) {
    this.camera.updateMatrixWorld();
    const origin = this.camera.position.clone();
    const direction = new Vector3((x / this.canvas.clientWidth) * 2 - 1, 1 - (y / this.canvas.clientHeight) * 2, 0.5).unproject(this.camera).sub(origin).normalize();
    return { origin, direction };
  }
  /// The triangle under a place on the canvas (Moeller and Trumbore), not what the section removed.
  pick(x, y) {
    const { origin: o, direction: d } = this.ray(x, y), p = this.part.position, ix = this.part.index, w = this.plane;
    let best = Infinity, hit = null;
    for (let f = 0; f < ix.length; f += 3) {
      const a = 3 * ix[f], b = 3 * ix[f + 1], c = 3 * ix[f + 2];
      const ex = p[b] - p[a], ey = p[b + 1] - p[a + 1], ez = p[b + 2] - p[a + 2], gx = p[c] - p[a], gy = p[c + 1] - p[a + 1], gz = p[c + 2] - p[a + 2];
      const hx = d.y * gz - d.z * gy, hy = d.z * gx - d.x * gz, hz = d.x * gy - d.y * gx, det = ex * hx + ey * hy + ez * hz;
      if (det === 0) continue;
      const sx = o.x - p[a], sy = o.y - p[a + 1], sz = o.z - p[a + 2], u = (sx * hx + sy * hy + sz * hz) / det;
      if (u < 0 || u > 1) continue;
      const qx = sy * ez - sz * ey, qy = sz * ex - sx * ez, qz = sx * ey - sy * ex, v = (d.x * qx + d.y * qy + d.z * qz) / det;
      if (v < 0 || u + v > 1) continue;
      const t = (gx * qx + gy * qy + gz * qz) / det;
      if (t <= 0 || t >= best) continue;
      const place = [o.x + t * d.x, o.y + t * d.y, o.z + t * d.z];
      if (w.x * place[0] + w.y * place[1] + w.z * place[2] > w.w) continue;
      const dev = this.part.deviation;
      best = t;
      hit = { face: f / 3, place, deviation: (1 - u - v) * dev[ix[f]] + u * dev[ix[f + 1]] + v * dev[ix[f + 2]] };
    }
    return hit;
  }
}
