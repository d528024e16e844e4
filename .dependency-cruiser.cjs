// The walls between the rooms, as the table in ARCHITECTURE.md has them. Each room may import itself and what
// is listed; nothing else of the project. `tests/walls.test.ts` shows that a breach fails.

/** room: what it may import beside itself. */
const MAY = {
  math: [],
  words: [],
  // Only types of math.
  data: ["math"],
  scene: ["math", "words"],
  demo: ["scene", "math", "words"],
  demos: ["demo", "scene", "math", "data", "words"],
  exercises: ["demo", "scene", "math", "data", "words"],
  render: ["scene", "math", "words"],
  player: ["demo", "scene", "render", "math", "words"],
  site: ["player", "words", "demos/index.ts", "exercises/index.ts"],
  identities: ["math"],
  build: ["demo", "demos", "exercises", "identities", "scene", "render", "words"],
};

const walls = Object.entries(MAY).map(([room, rooms]) => ({
  name: `walls-of-${room}`,
  comment: `src/${room} may import ${["itself", ...rooms].join(", ")}; ARCHITECTURE.md, "Rooms"`,
  severity: "error",
  from: { path: `^src/${room}/` },
  to: {
    path: "^(src|lessons)/",
    pathNot: [
      `^src/${room}/`,
      ...rooms.map((other) => (other.endsWith(".ts") ? `^src/${other}$` : `^src/${other}/`)),
      ...(room === "build" ? ["^lessons/toc\\.ts$"] : []),
    ],
  },
}));

/** Packages that one place of the project imports, and no other. */
const only = (name, pattern, place, comment) => ({
  name,
  comment,
  severity: "error",
  from: { path: "^(src|lessons)/", pathNot: place },
  to: { path: `node_modules/${pattern}/` },
});

module.exports = {
  forbidden: [
    ...walls,
    {
      name: "pure-rooms-need-nothing",
      comment:
        "mathematics, data, words, scenes, demos, exercises and identities import no package and no part of Node",
      severity: "error",
      from: { path: "^src/(math|data|words|scene|demo|demos|exercises|identities)/" },
      to: {
        dependencyTypes: ["npm", "npm-dev", "npm-peer", "npm-optional", "npm-no-pkg", "npm-unknown", "core"],
      },
    },
    {
      name: "data-takes-types-of-math-only",
      comment: "data is data: it may name the types of the mathematics, not call it",
      severity: "error",
      from: { path: "^src/data/" },
      to: { path: "^src/math/", dependencyTypesNot: ["type-only"] },
    },
    {
      name: "demos-stand-alone",
      comment: "a demo imports no other demo, an exercise no other exercise; what they share moves down",
      severity: "error",
      from: { path: "^src/(demos|exercises)/(?!index\\.ts$)" },
      to: { path: "^src/(demos|exercises)/" },
    },
    {
      name: "svg-tree-knows-no-dom",
      comment: "what writes SVG and TikZ as text stays free of the renderers for browsers",
      severity: "error",
      from: { path: "^src/render/[^/]+\\.ts$" },
      to: { path: "^src/render/(canvas|dom|three)/" },
    },
    {
      name: "node-in-the-build-only",
      comment: "browser code cannot import a part of Node",
      severity: "error",
      from: { path: "^src/", pathNot: "^src/build/" },
      to: { dependencyTypes: ["core"] },
    },
    only(
      "only-render-three",
      "three",
      "^src/render/three/",
      "src/render/three is the only importer of three",
    ),
    only(
      "only-one-panel",
      "lil-gui",
      "^src/player/panel-gui\\.ts$|^src/player/styles\\.ts$",
      "one adapter imports lil-gui",
    ),
    only(
      "only-the-build",
      "(katex|markdown-it|@mdit)",
      "^src/build/",
      "TeX and markdown are set while building",
    ),
    {
      name: "no-circles",
      comment: "two files that need each other are one idea, or one idea too many; types may refer back",
      severity: "error",
      from: {},
      to: { circular: true, viaOnly: { dependencyTypesNot: ["type-only"] } },
    },
    {
      name: "everything-resolves",
      comment: "an import that leads nowhere",
      severity: "error",
      from: {},
      to: { couldNotResolve: true, pathNot: "^virtual:|lil-gui\\.css|^node:" },
    },
  ],
  options: {
    doNotFollow: { path: "node_modules" },
    tsPreCompilationDeps: true,
    tsConfig: { fileName: "tsconfig.base.json" },
    enhancedResolveOptions: {
      exportsFields: ["exports"],
      conditionNames: ["import", "node", "default", "types"],
      extensions: [".ts", ".js", ".mjs", ".cjs", ".css"],
    },
  },
};
