// How much of the picture is drawn: all of it at rest, and while it moves what the machine can draw
// in time. Without a graphics card the edges are not smoothed then, what is played has fewer faces,
// and in the end the canvas has fewer pixels.
import { Mesh, NoBlending, OrthographicCamera, PlaneGeometry, Scene, ShaderMaterial, Vector2, WebGLRenderTarget } from "three";

const kSamples = 4; // of a pixel, as browsers take where a canvas is smoothed
const kQuick = 50, kSlow = 70; // ms: the whole picture is drawn while it moves; fewer pixels are
const kTimes = 4; // the whole picture takes about as many times what the quick one does
const kLeast = 0.35; // pixels of a side that are always left
const kSettled = 180; // ms

const kCopyVertex = "varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }";
const kCopyFragment = "uniform sampler2D picture; varying vec2 at; void main() { gl_FragColor = texture2D(picture, at); }";

export class Pace {
  /// `rest()` brings the whole picture.
  constructor(renderer, rest) {
    Object.assign(this, { renderer, rest, moves: false, reduced: false, script: 0, last: 0, share: 1 });
    this.whole = {}; // ms that all of the picture takes, by what is shown; unknown before it was drawn
    this.target = new WebGLRenderTarget(1, 1, { samples: kSamples });
    this.size = new Vector2();
    this.copy = new Scene();
    this.copy.add(new Mesh(new PlaneGeometry(2, 2), new ShaderMaterial({ uniforms: { picture: { value: this.target.texture } }, vertexShader: kCopyVertex, fragmentShader: kCopyFragment, blending: NoBlending, depthTest: false, depthWrite: false })));
    this.flat = new OrthographicCamera();
  }
  /// Whether all of the picture is drawn. `shown`: "part" or "run".
  full(shown) { return !this.moves || this.whole[shown] < kQuick; }
  /// Pixels of the canvas for each of the screen, by side.
  sharpness(shown) { return this.full(shown) ? 1 : this.share; }
  /// Does what moves the picture; the whole of it follows once nothing has moved for a while.
  move(act = () => {}) {
    this.moves = true;
    this.run(act);
    clearTimeout(this.settling);
    this.settling = setTimeout(() => this.settle(), Math.max(kSettled, 2 * this.last));
  }
  settle() {
    clearTimeout(this.settling);
    this.moves = false;
    if (this.reduced) this.run(this.rest);
  }
  run(act) {
    const begin = performance.now();
    act();
    this.script = performance.now() - begin;
  }
  draw(scene, camera, shown) {
    const begin = performance.now() - this.script, full = this.full(shown), { renderer } = this;
    this.script = 0;
    this.reduced = !full;
    if (full) {
      renderer.getDrawingBufferSize(this.size);
      this.target.setSize(this.size.x, this.size.y);
      renderer.setRenderTarget(this.target);
    }
    renderer.render(scene, camera);
    if (full) {
      renderer.setRenderTarget(null);
      renderer.render(this.copy, this.flat);
    }
    this.time((ms) => this.learn(ms, full, shown), begin);
  }
  // Calls when all that was asked for is drawn.
  time(done, begin) {
    const gl = this.renderer.getContext();
    if (this.waits) return;
    this.waits = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    const look = () => {
      if (gl.clientWaitSync(this.waits, 0, 0) === gl.TIMEOUT_EXPIRED) return setTimeout(look, 1);
      gl.deleteSync(this.waits);
      this.waits = null;
      done(performance.now() - begin);
    };
    setTimeout(look, 0);
  }
  learn(ms, full, shown) {
    if (full) { this.whole[shown] = ms; return; }
    this.last = Math.min(ms, 400);
    this.whole[shown] ??= kTimes * ms < kQuick ? kTimes * ms : undefined;
    if (ms > kSlow) this.share = Math.max(kLeast, 0.8 * this.share);
    else if (ms < kSlow / 2) this.share = Math.min(1, this.share / 0.8);
  }
}
