// The run in the picture: the stock at a moment, its ghost, the tool and the path.
import { BoxGeometry, BufferAttribute, BufferGeometry, Color, CylinderGeometry, DoubleSide, DynamicDrawUsage, EdgesGeometry, ExtrudeGeometry, FrontSide,
  Group, LatheGeometry, LineSegments, Matrix4, Mesh, Quaternion, ShaderMaterial, Shape, Vector2, Vector3 } from "three";
import { kRapid } from "./play.js";
import { PlayMesh } from "./play_mesh.js";
import { PlaySurface } from "./play_surface.js";

const kMostPath = 8000; // ends of straight pieces: longer paths show their last part unless asked
const kTail = 800;
const kMostFaces = 70000, kCoarseSegments = 36; // of the surface while it moves; of the rings of a turned part

const kSolidVertex = "varying vec3 vNormal; void main() { vNormal = normalMatrix * normal; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }";
// A little farther from the eye than the surface, whose places are rounded.
const kGhostVertex = "uniform float size; varying vec3 vNormal; void main() { vNormal = normalMatrix * normal; vec4 p = modelViewMatrix * vec4(position, 1.0); p.xyz *= 1.0 + 0.0008 * size / length(p.xyz); gl_Position = projectionMatrix * p; }";
const kSolidFragment = `uniform vec3 color; uniform float alpha; varying vec3 vNormal;
void main() { vec3 n = normalize(vNormal); if (!gl_FrontFacing) n = -n; gl_FragColor = vec4(color * (0.5 + 0.5 * max(n.z, 0.0)), alpha); }`;
const kLineVertex = "uniform float size; attribute float rapid; varying float vRapid; void main() { vRapid = rapid; vec4 p = modelViewMatrix * vec4(position, 1.0); p.xyz *= 1.0 - 0.003 * size / length(p.xyz); gl_Position = projectionMatrix * p; }";
const kLineFragment = "uniform vec3 cut; uniform vec3 rapidColor; varying float vRapid; void main() { gl_FragColor = vec4(mix(cut, rapidColor, vRapid), mix(0.9, 0.55, vRapid)); }";

const plainColor = (r, g, b) => new Color(r / 255, g / 255, b / 255);
const kToolColors = { cutter: plainColor(44, 104, 190), insert: plainColor(44, 104, 190), shank: plainColor(140, 146, 150), holder: plainColor(84, 90, 94) };

const kSeenThrough = { shank: 0.6, holder: 0.3 };

const solid = (color, alpha = 1) => new ShaderMaterial({ uniforms: { color: { value: color }, alpha: { value: alpha } }, vertexShader: kSolidVertex, fragmentShader: kSolidFragment, side: DoubleSide, transparent: alpha < 1, depthWrite: alpha === 1 });

// A convex polygon thickened by `round`: an arc about each corner.
function insertShape({ points, round }) {
  const n = points.length, out = [];
  const outward = (a, b) => Math.atan2(-(b[0] - a[0]), b[1] - a[1]);
  for (let i = 0; i < n; ++i) {
    const [x, z] = points[i];
    if (round <= 0) { out.push(new Vector2(x, z)); continue; }
    const from = n > 1 ? outward(points[(i + n - 1) % n], points[i]) : 0;
    let turn = n > 1 ? outward(points[i], points[(i + 1) % n]) - from : 2 * Math.PI;
    if (turn < 0) turn += 2 * Math.PI;
    for (let k = 0; k <= 16; ++k) out.push(new Vector2(x + round * Math.cos(from + (turn * k) / 16), z + round * Math.sin(from + (turn * k) / 16)));
  }
  return new Shape(out);
}

function toolGroup(tool) {
  const group = new Group();
  for (const piece of tool.pieces) {
    let geometry;
    if (piece.insert) {
      const shape = insertShape(piece), xs = shape.getPoints().map((p) => p.x), thick = 0.25 * (Math.max(...xs) - Math.min(...xs));
      geometry = new ExtrudeGeometry(shape, { depth: thick, bevelEnabled: false });
      geometry.rotateX(Math.PI / 2); // the shape's (x, y) become X and Z, the plate lies below the plane of turning
    } else {
      geometry = new LatheGeometry(piece.points.map(([r, z]) => new Vector2(Math.max(r, 0), z)), 40);
      geometry.rotateX(Math.PI / 2);
    }
    // What is not to cut is seen through: it stands before the cutter and the part.
    const mesh = new Mesh(geometry, solid(kToolColors[piece.part] ?? kToolColors.cutter, piece.part in kSeenThrough ? kSeenThrough[piece.part] : 1));
    mesh.renderOrder = piece.part in kSeenThrough ? 3 : 0;
    group.add(mesh);
  }
  return group;
}

function stockGeometry(stock, play) {
  const size = [0, 1, 2].map((k) => stock.hi[k] - stock.lo[k]), middle = [0, 1, 2].map((k) => (stock.hi[k] + stock.lo[k]) / 2);
  let geometry;
  if (stock.kind === "cylinder" || stock.kind === "tube") geometry = new CylinderGeometry(stock.outer, stock.outer, size[2], 72, 1).rotateX(Math.PI / 2);
  else geometry = new BoxGeometry(...size);
  return geometry.translate(...middle);
}

export class PlayView {
  constructor(view, play, transform, keyOf) {
    Object.assign(this, { view, play, at: play.end, stockWanted: true });
    this.group = new Group();
    const [a, b, c] = transform.rotation, t = transform.shift;
    this.group.matrixAutoUpdate = false;
    this.group.matrix = new Matrix4().set(a[0], a[1], a[2], t[0], b[0], b[1], b[2], t[1], c[0], c[1], c[2], t[2], 0, 0, 0, 1);
    this.fine = new PlaySurface(new PlayMesh(play, keyOf));
    this.coarse = play.coarse.map((coarse) => new PlaySurface(new PlayMesh(coarse, keyOf, kCoarseSegments)));
    this.material = view.material.clone();
    for (const key of Object.keys(view.material.uniforms)) this.material.uniforms[key] = key === "byDeviation" ? { value: 0 } : view.material.uniforms[key];
    view.materials.push(this.material);
    this.surface = new Mesh(new BufferGeometry(), this.material);
    this.surface.frustumCulled = false;
    this.addGhost();
    this.tools = play.tools.map(toolGroup);
    this.addPath();
    if (play.stock) view.seen.push(this.ghost.children[0].geometry.attributes.position.clone().applyMatrix4(this.group.matrix).array);
    this.group.add(this.surface, this.ghost, this.path, ...this.tools);
    view.scene.add(this.group);
    view.onRest = () => this.refine();
    this.show(play.end);
  }
  addGhost() {
    this.ghost = new Group();
    if (!this.play.stock) return;
    const geometry = stockGeometry(this.play.stock, this.play);
    this.ghostFill = solid(plainColor(150, 158, 164), 0.1);
    Object.assign(this.ghostFill, { side: FrontSide, vertexShader: kGhostVertex });
    this.ghostFill.uniforms.size = { value: this.view.bounds.size };
    this.ghostLine = new ShaderMaterial({ uniforms: { ink: { value: new Color() }, size: { value: this.view.bounds.size } }, vertexShader: "uniform float size; void main() { vec4 p = modelViewMatrix * vec4(position, 1.0); p.xyz *= 1.0 - 0.0016 * size / length(p.xyz); gl_Position = projectionMatrix * p; }", fragmentShader: "uniform vec3 ink; void main() { gl_FragColor = vec4(ink, 0.5); }", transparent: true });
    const fill = new Mesh(geometry, this.ghostFill);
    fill.renderOrder = 3;
    this.ghost.add(fill, new LineSegments(new EdgesGeometry(geometry, 30), this.ghostLine));
  }
  // Two points for each straight piece, in the order of the motions.
  addPath() {
    const { play } = this, { motions } = play, places = [], rapid = [];
    this.pathEnd = new Uint32Array(motions.count + 1);
    for (let i = 0; i < motions.count; ++i) {
      if (!motions.assumed[i]) {
        const arc = motions.arcs.get(i), pieces = arc ? Math.min(256, Math.max(2, Math.ceil(Math.abs(arc.sweep) / 0.13))) : 1;
        for (let k = 0; k < pieces; ++k) {
          places.push(...play.placeOn(i, k / pieces), ...play.placeOn(i, (k + 1) / pieces));
          const quick = motions.kind[i] === kRapid ? 1 : 0;
          rapid.push(quick, quick);
        }
      }
      this.pathEnd[i + 1] = rapid.length;
    }
    this.pathWanted = !play.stock || rapid.length <= kMostPath;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(places), 3).setUsage(DynamicDrawUsage));
    geometry.setAttribute("rapid", new BufferAttribute(new Float32Array(rapid), 1));
    this.path = new LineSegments(geometry, new ShaderMaterial({ uniforms: { size: { value: this.view.bounds.size }, cut: { value: plainColor(20, 60, 130) }, rapidColor: { value: plainColor(190, 110, 20) } }, vertexShader: kLineVertex, fragmentShader: kLineFragment, transparent: true }));
    this.path.frustumCulled = false;
    this.path.renderOrder = 2;
    if (play.stock) return;
    // What is chosen of a path that is shown as a whole: drawn over it.
    this.chosen = new LineSegments(geometry.clone(), new ShaderMaterial({ vertexShader: kLineVertex, fragmentShader: "void main() { gl_FragColor = vec4(0.82, 0.1, 0.15, 1.0); }", uniforms: { size: { value: 2 * this.view.bounds.size } }, depthTest: false }));
    this.chosen.frustumCulled = this.chosen.visible = false;
    this.chosen.renderOrder = 5;
    this.group.add(this.chosen);
  }
  setInk(ink, dark) {
    this.ghostLine?.uniforms.ink.value.copy(ink);
    const u = this.path.material.uniforms;
    u.cut.value.copy(dark ? plainColor(130, 180, 255) : plainColor(20, 60, 130));
    u.rapidColor.value.copy(dark ? plainColor(240, 170, 80) : plainColor(190, 110, 20));
  }
  /// Goes to a place on the time line. `marked`: at the end, a motion whose tool is shown.
  show(at, marked = -1) {
    this.at = at;
    const { play } = this, ended = at >= play.end;
    this.view.showPart(ended);
    this.surface.visible = !ended;
    if (!ended) this.showSurface(play.momentAt(at), this.view.pace.full("run"));
    this.ghost.visible = this.stockWanted && !ended;
    const from = ended ? marked : Math.floor(at), place = ended ? marked + 1 : at;
    this.placeTool(from, place);
    this.drawPath(ended ? marked : -1);
    this.view.draw();
  }
  /// `whole`: with all its faces, which may take longer than what moves has time for.
  showSurface(moment, whole = true) {
    this.onShow = whole ? this.fine : this.coarse.find(({ mesh }) => mesh.gather(moment) <= kMostFaces) ?? this.coarse.at(-1);
    this.onShow.show(moment);
    this.surface.geometry = this.onShow.geometry;
  }
  /// Draws some moments. The first time takes ten times as long as later ones, because shaders are
  /// compiled: better before anyone waits for it.
  warmUp() {
    const { view, play } = this;
    for (const share of [0.4, 0.5, 0.6]) {
      view.pace.move(() => this.show(share * play.end));
      view.drawNow();
    }
    this.show(play.end);
    view.pace.settle();
  }
  /// All faces of the moment that is shown.
  refine() {
    if (this.surface.visible) this.showSurface(this.play.momentAt(this.at));
  }
  placeTool(motion, at) {
    const { play } = this, tool = motion >= 0 && motion < play.end ? play.motions.tool[motion] : -1;
    this.tools.forEach((group, i) => { group.visible = i === tool; });
    if (tool < 0) return;
    const group = this.tools[tool];
    group.position.set(...play.placeOn(motion, at - motion));
    group.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...play.toolAxis(motion)).normalize()));
  }
  /// mm: the largest of the tool of a motion.
  toolRadius(motion) {
    const pieces = this.play.tools[this.play.motions.tool[motion]]?.pieces ?? [];
    return Math.max(0, ...pieces.flatMap((piece) => piece.points.map(([r]) => Math.abs(r) + piece.round)));
  }
  drawPath(marked) {
    const { play, at, path } = this, motion = Math.min(Math.floor(at), play.end - 1), whole = !play.stock && at >= play.end;
    path.visible = whole || at < play.end || marked >= 0;
    if (this.chosen) this.chosen.visible = marked >= 0;
    if (!path.visible) return;
    if (marked >= 0) {
      const [first, end] = play.blockOf(marked);
      (this.chosen ?? path).geometry.setDrawRange(this.pathEnd[first], this.pathEnd[end] - this.pathEnd[first]);
    }
    if (marked >= 0 || whole) {
      this.bend(-1);
      if (whole) path.geometry.setDrawRange(0, Infinity);
      return;
    }
    const done = this.pathEnd[motion], first = this.pathWanted ? 0 : Math.max(0, done - kTail);
    const pieces = (this.pathEnd[motion + 1] - done) / 2, shown = Math.min(pieces, Math.ceil(pieces * (at - motion)));
    this.bend(shown > 0 ? done + 2 * shown - 1 : -1, play.placeAt(at));
    path.geometry.setDrawRange(first, done + 2 * shown - first);
  }
  // The path ends at the tool: the last point that is drawn is moved there, and back afterwards.
  bend(point, place) {
    const attribute = this.path.geometry.attributes.position, { array } = attribute;
    attribute.clearUpdateRanges();
    const put = (at, values) => { array.set(values, 3 * at); attribute.addUpdateRange(3 * at, 3); attribute.needsUpdate = true; };
    if (this.bent) put(this.bent.point, this.bent.place);
    this.bent = point < 0 ? null : { point, place: [...array.subarray(3 * point, 3 * point + 3)] };
    if (this.bent) put(point, place);
  }
  /// The piece of the path nearest to a place on the canvas, within ten pixels, of what is drawn.
  pickPath(x, y) {
    const { array } = this.path.geometry.attributes.position, { start, count } = this.path.geometry.drawRange, seen = [];
    let best = 10, hit = null;
    const end = Math.min(array.length / 3, start + count);
    for (let i = start; i < end; i += 2) {
      for (const k of [0, 1]) seen[k] = this.view.project([array[3 * (i + k)], array[3 * (i + k) + 1], array[3 * (i + k) + 2]]);
      const [a, b] = seen, dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
      const t = square > 0 ? Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / square)) : 0, apart = Math.hypot(a.x + t * dx - x, a.y + t * dy - y);
      if (apart >= best || !a.front || !b.front) continue;
      best = apart;
      hit = { point: i, place: [0, 1, 2].map((k) => array[3 * i + k] + t * (array[3 * i + 3 + k] - array[3 * i + k])) };
    }
    if (!hit) return null;
    let low = 0, high = this.play.end;
    while (high - low > 1) { const middle = (low + high) >> 1; if (this.pathEnd[middle] <= hit.point) low = middle; else high = middle; }
    return { motion: low, place: hit.place };
  }
  /// What is under a place on the canvas: { face, place, motion }, or null.
  pick(x, y) {
    const { origin, direction } = this.view.ray(x, y), inverse = new Matrix4().copy(this.group.matrix).invert();
    const o = origin.clone().applyMatrix4(inverse), d = direction.clone().transformDirection(inverse), w = this.view.plane;
    const outside = (p) => { const q = new Vector3(...p).applyMatrix4(this.group.matrix); return w.x * q.x + w.y * q.y + w.z * q.z > w.w; };
    this.refine();
    const hit = this.fine.mesh.pick(o, d, (p) => !outside(p));
    if (!hit) return null;
    const place = o.addScaledVector(d, hit.t).applyMatrix4(this.group.matrix);
    return { face: hit.face, place: place.toArray(), motion: this.play.motionOf[this.play.faces.birth[hit.face]] };
  }
}
