import { Camera, Scene, WebGLRenderer } from "three";
import { readColour } from "../facet-colour.ts";
import type { Palette, Token } from "../palette.ts";
import type { FacetsPrimitive } from "../primitives.ts";
import { createPatchMesh, type PatchMesh, type Uniforms } from "./patch-mesh.ts";

/** Paints surfaces into the drawing surfaces of figures. */
export interface ThreePainter {
  painterFor(
    context: CanvasRenderingContext2D,
    palette: Palette,
    scale: number,
  ): (surfaces: FacetsPrimitive) => void;
  forget(context: CanvasRenderingContext2D): void;
}

/** What is kept of a figure on the card: its patches by the key of their marks. */
interface Kept {
  readonly scene: Scene;
  readonly meshes: Map<string, PatchMesh>;
}

/**
 * The one painter of a page, with the one WebGL context. Every picture is drawn to its canvas and copied from there to
 * the figure's own. `changed` hears of the painter once it can paint, of null when the context is lost, of the painter
 * again when it is back, and of nothing where there is no WebGL.
 */
export function createThreePainter(changed: (painter: ThreePainter | null) => void): void {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 1;
  const gl = canvas.getContext("webgl2", { antialias: false, alpha: true, depth: true });
  if (!gl) return;
  const renderer = new WebGLRenderer({ canvas, context: gl, alpha: true });
  renderer.setClearColor(0, 0);
  renderer.autoClear = false;
  const camera = new Camera();
  const figures = new Map<CanvasRenderingContext2D, Kept>();
  const fineness = isSoftware(gl) ? 1 : FINE;
  let [width, height] = [1, 1];

  const paint = (
    context: CanvasRenderingContext2D,
    palette: Palette,
    scale: number,
    { patches, space }: FacetsPrimitive,
  ) => {
    const { box } = space.plane;
    const [left, top] = [Math.floor(box.left * scale), Math.floor(box.top * scale)];
    const w = Math.ceil((box.left + box.width) * scale) - left;
    const h = Math.ceil((box.top + box.height) * scale) - top;
    const [fineW, fineH] = [w * fineness, h * fineness];
    if (fineW > width || fineH > height) {
      [width, height] = [Math.max(fineW, width), Math.max(fineH, height)];
      renderer.setSize(width, height, false);
    }
    const kept = keep(figures, context);
    const seen = new Set<string>();
    for (const patch of patches) {
      seen.add(patch.key);
      meshOf(kept, patch).update(patch);
    }
    for (const [key, entry] of kept.meshes) {
      if (seen.has(key)) continue;
      kept.scene.remove(entry.mesh);
      entry.dispose();
      kept.meshes.delete(key);
    }
    // One measure of depth for all patches, or they would not hide each other.
    const reach = Math.max(...[...kept.meshes.values()].map((entry) => entry.reach));
    for (const { uniforms, accent } of kept.meshes.values()) {
      setWindow(uniforms, space, scale, { left, top, w, h });
      setColours(uniforms, palette, accent);
      uniforms.depthScale.value = 1 / (1e-9 + reach + Math.hypot(...space.target));
    }
    renderer.setViewport(0, 0, fineW, fineH);
    renderer.setScissor(0, 0, fineW, fineH);
    renderer.setScissorTest(true);
    renderer.clear();
    renderer.render(kept.scene, camera);
    context.save();
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(canvas, 0, height - fineH, fineW, fineH, left, top, w, h);
    context.restore();
  };

  const painter: ThreePainter = {
    painterFor: (context, palette, scale) => (surfaces) => paint(context, palette, scale, surfaces),
    forget(context) {
      for (const entry of figures.get(context)?.meshes.values() ?? []) entry.dispose();
      figures.delete(context);
    },
  };
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    changed(null);
  });
  canvas.addEventListener("webglcontextrestored", () => changed(painter));
  changed(painter);
}

/** Edges are smoothed by drawing so many times finer and copying smaller: stripes are smoothed as well as outlines. */
const FINE = 2;

/** Whether the processor does the work of a graphics card; then every pixel counts, and smooth motion comes first. */
function isSoftware(gl: WebGL2RenderingContext): boolean {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

function keep(figures: Map<CanvasRenderingContext2D, Kept>, context: CanvasRenderingContext2D): Kept {
  let kept = figures.get(context);
  if (!kept) {
    kept = { scene: new Scene(), meshes: new Map() };
    figures.set(context, kept);
  }
  return kept;
}

/** The mesh of a patch; one whose grid has changed its size is made anew. */
function meshOf({ scene, meshes }: Kept, patch: FacetsPrimitive["patches"][number]): PatchMesh {
  const old = meshes.get(patch.key);
  if (old && old.rows === patch.rows && old.columns === patch.columns) return old;
  if (old) {
    scene.remove(old.mesh);
    old.dispose();
  }
  const made = createPatchMesh(patch);
  meshes.set(patch.key, made);
  scene.add(made.mesh);
  return made;
}

function setWindow(
  uniforms: Uniforms,
  space: FacetsPrimitive["space"],
  scale: number,
  { left, top, w, h }: { left: number; top: number; w: number; h: number },
): void {
  const { axes, plane, target } = space;
  const { right, up, eye } = axes;
  uniforms.axes.value.set(right[0]!, right[1]!, right[2]!, up[0]!, up[1]!, up[2]!, eye[0]!, eye[1]!, eye[2]!);
  uniforms.target.value.set(target[0]!, target[1]!, target[2]!);
  // Where the target stands in the piece of canvas that is copied: from −1 to 1, upwards.
  const [x, y] = plane.toPixel([0, 0]);
  uniforms.windowOffset.value.set(((x * scale - left) / w) * 2 - 1, 1 - ((y * scale - top) / h) * 2);
  uniforms.windowScale.value.set((2 * plane.scale[0]! * scale) / w, (2 * plane.scale[1]! * scale) / h);
}

type ColourName = "frontDim" | "frontLit" | "backDim" | "backLit" | "stripeDim";

const COLOURS: Readonly<Record<ColourName, Token>> = {
  frontDim: "front-dim",
  frontLit: "front-lit",
  backDim: "back-dim",
  backLit: "back-lit",
  stripeDim: "curve",
};
const ACCENT: Readonly<Record<ColourName, Token>> = {
  ...COLOURS,
  frontDim: "back-dim",
  frontLit: "back-lit",
  backDim: "front-dim",
  backLit: "front-lit",
};

function setColours(uniforms: Uniforms, palette: Palette, accent: boolean): void {
  const tokens = accent ? ACCENT : COLOURS;
  for (const name of Object.keys(tokens) as ColourName[]) {
    const [r, g, b] = readColour(palette[tokens[name]]);
    uniforms[name].value.set(r / 255, g / 255, b / 255);
  }
}
