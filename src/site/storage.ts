/**
 * The only place that touches the browser's storage. Inside sandboxed and cross-site frames every access
 * throws; then a memory takes its place and lasts as long as the page.
 */
const PREFIX = "straklatte.";
const memory = new Map<string, string>();

/** The remembered value, or null. Never throws. */
export function recall(key: string): string | null {
  try {
    return localStorage.getItem(PREFIX + key) ?? memory.get(key) ?? null;
  } catch {
    return memory.get(key) ?? null;
  }
}

/** Remembers a value, or forgets it where null is given. Never throws. */
export function remember(key: string, value: string | null): void {
  if (value === null) memory.delete(key);
  else memory.set(key, value);
  try {
    if (value === null) localStorage.removeItem(PREFIX + key);
    else localStorage.setItem(PREFIX + key, value);
  } catch {
    // Refused or full: the memory has it.
  }
}
