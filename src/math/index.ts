// The public face of the mathematics: ES modules, pure functions, no dependencies.
export * from "./bernstein.ts";
export * from "./bezier.ts";
export * from "./de-casteljau.ts";
export * from "./elevate-degree.ts";
export * from "./point.ts";
export * from "./split-bezier.ts";
