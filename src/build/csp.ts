import { createHash } from "node:crypto";

/** Inline text of a page that its policy must allow by name. */
export interface InlineParts {
  readonly scripts: readonly string[];
  readonly styles?: readonly string[];
}

/**
 * The content security policy of every page of the build. Nothing is loaded from elsewhere, no text becomes
 * a script; KaTeX and the figures need style attributes, hence `style-src-attr`.
 */
export function contentSecurityPolicy({ scripts, styles = [] }: InlineParts): string {
  return [
    "default-src 'none'",
    `script-src 'self' ${scripts.map(hashSource).join(" ")}`,
    `style-src 'self' ${styles.map(hashSource).join(" ")}`,
    "style-src-attr 'unsafe-inline'",
    "img-src 'self' data: blob:",
    "font-src 'self' data:",
    "connect-src 'self'",
    "media-src 'self' blob:",
    "worker-src 'self' blob:",
    "manifest-src 'self'",
    "frame-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
    "object-src 'none'",
    "require-trusted-types-for 'script'",
    "trusted-types straklatte",
  ]
    .map((directive) => directive.trim())
    .join("; ");
}

function hashSource(text: string): string {
  return `'sha256-${createHash("sha256").update(text, "utf8").digest("base64")}'`;
}
