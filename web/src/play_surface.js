// The surface of a moment as arrays for the graphics card.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from "three";

const kCorner = { position: 3, normal: 4, own: 1 }; // numbers of each corner

export class PlaySurface {
  constructor(mesh) {
    this.mesh = mesh;
    this.geometry = new BufferGeometry();
  }
  /// Brings the geometry to a moment.
  show(moment) {
    const { mesh, geometry } = this;
    if (mesh.moment === moment) return;
    mesh.show(moment);
    if (!geometry.index) this.makeArrays();
    for (const [name, size] of Object.entries(kCorner)) {
      const attribute = geometry.attributes[name];
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, 4 * size * mesh.quads);
      attribute.needsUpdate = true;
    }
    geometry.setDrawRange(0, 6 * mesh.quads);
  }
  makeArrays() {
    const { mesh, geometry } = this, corners = mesh.position.length / 3, index = new Uint32Array(corners * 1.5);
    for (let q = 0, i = 0; 4 * q < corners; ++q) for (const k of [0, 1, 2, 0, 2, 3]) index[i++] = 4 * q + k;
    geometry.setIndex(new BufferAttribute(index, 1));
    for (const [name, values] of [["position", mesh.position], ["normal", mesh.normal], ["own", mesh.owner]])
      geometry.setAttribute(name, new BufferAttribute(values, kCorner[name], name === "normal").setUsage(DynamicDrawUsage));
  }
}
