import { type Bar, cubicBars, degreeBars, patchBars, splineBars } from "./bars.ts";
import { checksum } from "./measure.ts";
import type { Peers } from "./peers.ts";

/** Runs the benchmark and prints every ratio with its bar; true if all bars hold. */
export function report(peers: Peers, print: (line: string) => void): boolean {
  const bars: Bar[] = [...cubicBars(peers), ...degreeBars(peers), ...patchBars(peers), ...splineBars()];
  const held = bars.map(({ what, ratio, demand, bound }) => {
    const number = ratio.toFixed(ratio < 10 ? 2 : 0).padStart(8);
    if (demand === "no bar") {
      print(`       ${number}  (for comparison)  ${what}`);
      return true;
    }
    const holds = demand === "at least" ? ratio >= bound : ratio <= bound;
    print(`${holds ? "holds " : "MISSED"} ${number}  (${demand} ${bound})  ${what}`);
    return holds;
  });
  print(`(checksum ${checksum().toPrecision(6)}: all results were read)`);
  return held.every(Boolean);
}
