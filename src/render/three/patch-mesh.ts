import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  DoubleSide,
  GLSL3,
  type IUniform,
  Matrix3,
  Mesh,
  NearestFilter,
  RawShaderMaterial,
  Vector2,
  Vector3,
} from "three";
import type { PatchMark } from "../../scene/marks.ts";
import { LEVELS, mapColour } from "../colour-map.ts";
import { fragmentShader, MODES, NO_NUMBER, vertexShader } from "./surface-shader.ts";

/** A patch on the graphics card. */
export interface PatchMesh {
  readonly mesh: Mesh;
  readonly rows: number;
  readonly columns: number;
  readonly accent: boolean;
  readonly uniforms: Uniforms;
  /** The largest distance of a sample from the origin. */
  readonly reach: number;
  /** Takes over a mark; only what differs is sent to the card. */
  update(patch: PatchMark): void;
  dispose(): void;
}

export type Uniforms = ReturnType<typeof makeUniforms>;

let map: DataTexture | undefined;
function colourMap(): DataTexture {
  if (map) return map;
  const data = new Uint8Array(4 * LEVELS);
  for (let level = 0; level < LEVELS; level++) data.set([...mapColour("diverging", level), 255], 4 * level);
  map = new DataTexture(data, LEVELS, 1);
  map.minFilter = map.magFilter = NearestFilter;
  map.needsUpdate = true;
  return map;
}

function makeUniforms() {
  return {
    axes: { value: new Matrix3() },
    target: { value: new Vector3() },
    windowScale: { value: new Vector2() },
    windowOffset: { value: new Vector2() },
    depthScale: { value: 1 },
    mode: { value: 0 as number },
    range: { value: new Vector2() },
    colourMap: { value: colourMap() },
    frontDim: { value: new Vector3() },
    frontLit: { value: new Vector3() },
    backDim: { value: new Vector3() },
    backLit: { value: new Vector3() },
    stripeDim: { value: new Vector3() },
  } satisfies Record<string, IUniform>;
}

/** The triangles of a grid; grids of one size share them. */
const indices = new Map<string, BufferAttribute>();

function gridIndex(rows: number, columns: number): BufferAttribute {
  const id = `${rows} ${columns}`;
  let found = indices.get(id);
  if (!found) {
    const list: number[] = [];
    for (let i = 1; i < rows; i++) {
      for (let j = 1; j < columns; j++) {
        const [a, b] = [(i - 1) * columns + j - 1, i * columns + j - 1];
        // Counter-clockwise in (u, v): the front is where S_u × S_v points.
        list.push(a, b, b + 1, a, b + 1, a + 1);
      }
    }
    found = new BufferAttribute(new Uint32Array(list), 1);
    indices.set(id, found);
  }
  return found;
}

export function createPatchMesh(first: PatchMark): PatchMesh {
  const uniforms = makeUniforms();
  const material = new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    uniforms,
    side: DoubleSide,
  });
  const { rows, columns } = first;
  const count = rows * columns;
  const geometry = new BufferGeometry();
  const attribute = (name: string, size: number) => {
    const made = new BufferAttribute(new Float32Array(size * count), size);
    geometry.setAttribute(name, made);
    return made;
  };
  const position = attribute("position", 3);
  const normal = attribute("normal", 3);
  const value = attribute("value", 1);
  geometry.setIndex(gridIndex(rows, columns));
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  let last: PatchMark | undefined;
  let reach = 0;

  return {
    mesh,
    rows,
    columns,
    uniforms,
    get accent() {
      return last?.accent ?? false;
    },
    get reach() {
      return reach;
    },
    update(patch) {
      if (patch.positions !== last?.positions && copyInto(position, patch.positions))
        reach = reachOf(position);
      if (patch.normals !== last?.normals) copyInto(normal, patch.normals);
      if (patch.values && patch.values !== last?.values) copyInto(value, patch.values);
      uniforms.mode.value = MODES[patch.shading ?? "lit"];
      const [low, high] = patch.range ?? [0, 1];
      uniforms.range.value.set(low, high);
      last = patch;
    },
    dispose() {
      // The shared triangles stay: without an index, disposing of the geometry leaves them alone.
      geometry.setIndex(null);
      geometry.dispose();
      material.dispose();
    },
  };
}

/** Copies numbers into a buffer, and has it sent to the card if any of them differs. */
function copyInto(attribute: BufferAttribute, from: ArrayLike<number>): boolean {
  const to = attribute.array;
  let differs = attribute.version === 0;
  for (let i = 0; i < to.length; i++) {
    const given = from[i]!;
    const next = Math.fround(Number.isFinite(given) ? given : NO_NUMBER);
    if (to[i] === next) continue;
    to[i] = next;
    differs = true;
  }
  if (differs) attribute.needsUpdate = true;
  return differs;
}

function reachOf({ array }: BufferAttribute): number {
  let most = 0;
  for (let i = 0; i < array.length; i += 3) {
    most = Math.max(most, array[i]! ** 2 + array[i + 1]! ** 2 + array[i + 2]! ** 2);
  }
  return Math.sqrt(most);
}
