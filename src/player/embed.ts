import type { Demo } from "../demo/define.ts";
import { checkValues } from "../demo/state.ts";
import type { CurveDemo } from "./curve-demo.ts";
import type { Change } from "./store.ts";

/** What an embed tells the page around it. */
export interface Embed {
  ready(): void;
  changed(change: Change): void;
  failed(message: string): void;
}

const PREFIX = "curve-demo/";
/** More messages a second than any slide needs are not answered. */
const MAX_PER_SECOND = 240;

/** Connects an embedded figure with the page around it, by the messages of the contract. */
export function connectEmbed(host: CurveDemo, demo: Demo): Embed {
  const parent = window.parent === window ? null : window.parent;
  const say = (message: Readonly<Record<string, unknown>>) => parent?.postMessage(message, "*");
  const fail = (message: string) => say({ type: `${PREFIX}error`, message });
  const height = () => document.documentElement.scrollHeight;

  let second = 0;
  let count = 0;
  const tooMany = (now: number) => {
    if (now - second > 1000) {
      second = now;
      count = 0;
    }
    count += 1;
    return count > MAX_PER_SECOND;
  };

  const answer = (data: Readonly<Record<string, unknown>>) => {
    switch (data.type) {
      case `${PREFIX}set`: {
        if (typeof data.state !== "object" || data.state === null || Array.isArray(data.state)) {
          return fail("curve-demo/set: state must be an object of parameters, for instance { t: 0.5 }");
        }
        const { problems } = checkValues(demo, data.state as Readonly<Record<string, unknown>>);
        if (problems.length > 0) {
          return fail(
            problems
              .map((one) => `curve-demo/set: ${one.param} = ${one.given}: ${one.problem.en}`)
              .join("; "),
          );
        }
        return host.setState(data.state as Readonly<Record<string, unknown>>);
      }
      case `${PREFIX}get`: {
        if (data.id !== undefined && typeof data.id !== "string" && typeof data.id !== "number") {
          return fail("curve-demo/get: id must be a string or a number");
        }
        return say({
          type: `${PREFIX}state`,
          demo: demo.id,
          state: host.state,
          ...(data.id === undefined ? {} : { id: data.id }),
        });
      }
      case `${PREFIX}play`: {
        if (typeof data.on !== "boolean") return fail("curve-demo/play: on must be true or false");
        return host.play(data.on);
      }
      default:
        return fail(
          `unknown message ${String(data.type).slice(0, 60)}: known are curve-demo/set, /get and /play`,
        );
    }
  };

  window.addEventListener("message", (event) => {
    if (!parent || event.source !== parent) return;
    const data: unknown = event.data;
    if (typeof data !== "object" || data === null || !("type" in data)) return;
    if (typeof data.type !== "string" || !data.type.startsWith(PREFIX)) return;
    if (tooMany(event.timeStamp)) return fail("too many messages");
    answer(data as Readonly<Record<string, unknown>>);
  });

  let seen = 0;
  new ResizeObserver(() => {
    if (height() === seen) return;
    seen = height();
    say({ type: `${PREFIX}resize`, height: seen });
  }).observe(document.documentElement);

  return {
    ready: () => say({ type: `${PREFIX}ready`, demo: demo.id, state: host.state, height: height() }),
    failed: fail,
    changed(change) {
      say({ type: `${PREFIX}state`, demo: demo.id, state: host.state });
      if (change.committed) rememberInUrl(host, demo);
    },
  };
}

/** The state stays in the address, so that a deck that reloads its frames loses nothing. */
function rememberInUrl(host: CurveDemo, demo: Demo): void {
  const kept = location.search
    .slice(1)
    .split("&")
    .filter(
      (entry) =>
        entry !== "" && entry.split("=")[0] !== "state" && !Object.hasOwn(demo.params, decodeName(entry)),
    );
  const query = [...kept, host.embedQuery].filter((part) => part !== "").join("&");
  try {
    history.replaceState(
      history.state,
      "",
      `${location.pathname}${query ? `?${query}` : ""}${location.hash}`,
    );
  } catch {
    // Some hosts refuse; the figure works without.
  }
}

function decodeName(entry: string): string {
  try {
    return decodeURIComponent(entry.split("=")[0]!);
  } catch {
    return entry;
  }
}
