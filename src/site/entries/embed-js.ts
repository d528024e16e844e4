import { demos } from "../../demos/index.ts";
import { defineCurveDemo } from "../../player/index.ts";

// Any page that loads this module can hold <curve-demo demo="…">.
defineCurveDemo(demos);
