import type { Label } from "../scene/label.ts";
import type { XY } from "../scene/marks.ts";
import type { Words } from "../words/words.ts";

/** Either a value or, in both languages, what is wrong with the text or object that was given. */
export type Read<T> =
  | { readonly ok: true; readonly value: T }
  | { readonly ok: false; readonly problem: Words };

export function good<T>(value: T): Read<T> {
  return { ok: true, value };
}

export function bad<T>(de: string, en: string): Read<T> {
  return { ok: false, problem: { de, en } };
}

/** The state of a demo: a value for each of its parameters. */
export type State = Readonly<Record<string, unknown>>;

/** What a figure offers for grabbing: one point of a view, and what its new place would mean. */
export interface Handle<T> {
  /** `<param>` for a scalar or vector, `<param>.<index>` for one of many. */
  readonly id: string;
  readonly view: string;
  readonly at: XY;
  readonly label: Label;
  readonly index?: number;
  /** Whether the label is written into the picture as well; it is spoken in any case. */
  readonly lettered?: boolean;
  /** The value of the parameter with this handle moved to the given point. */
  put(to: XY): T;
  /** The value after one arrow key: `direction` in world axes, `factor` 1, 5 (Shift) or ¼ (Alt). */
  nudge(direction: XY, factor: number): T;
  // In a window into space, points and directions have three coordinates.
}

/** One entry of the panel: a number to type or slide, a switch, or a choice. */
export type Field<T> =
  | {
      readonly kind: "number";
      readonly id: string;
      /** Fields of one point, row or entry stand together under its name. */
      readonly group?: Label;
      readonly label: Label;
      readonly value: number;
      readonly min: number;
      readonly max: number;
      readonly step: number;
      put(value: number): T;
    }
  | {
      readonly kind: "boolean";
      readonly id: string;
      readonly label: Label;
      readonly value: boolean;
      put(value: boolean): T;
    }
  | {
      readonly kind: "choice";
      readonly id: string;
      readonly label: Label;
      readonly value: string;
      readonly options: readonly { readonly id: string; readonly label: Words }[];
      put(value: string): T;
    };

/** Something a button can do to a value: add a point, take the last one away. */
export interface Action<T> {
  readonly id: string;
  readonly label: Words;
  /** null while the action is not possible. */
  readonly value: T | null;
}

/** What a handle or an anchor needs to know of the figure: the state and the views' windows. */
export interface Surroundings {
  readonly state: State;
  readonly views: Readonly<
    Record<string, { readonly x: readonly [number, number]; readonly y: readonly [number, number] }>
  >;
}

/**
 * A typed parameter: the one declaration from which control, handle, keyboard, URL, attribute, validation
 * and documentation are derived. Each kind is one file of `params/`.
 */
export interface Param<T> {
  readonly type:
    | "number"
    | "boolean"
    | "choice"
    | "points"
    | "vector"
    | "list"
    | "grid"
    | "net"
    | "stroke"
    | "camera";
  readonly label: Words;
  readonly initial: T;
  /** The parameter that play moves, and how many seconds one passage takes. */
  readonly animate?: { readonly from: number; readonly to: number; readonly seconds: number };
  /** What the figure shows as its main slider, directly under the picture. */
  readonly primary?: boolean;
  /** The view in which a pencil draws this parameter. */
  readonly drawnIn?: string;
  /** Reads the notation of the URL (see the contract). Never throws. */
  read(text: string): Read<T>;
  /** Writes the notation of the URL; `read(write(v))` gives v back, for every valid v. */
  write(value: T): string;
  /** Checks an object that came from outside: property, message, attribute, stored data. Never throws. */
  accept(value: unknown): Read<T>;
  /** The value rounded to the declared precision, as dragging leaves it. */
  round(value: T): T;
  /** The value between two others, for gliding (0 gives `a`, 1 gives `b`); what cannot glide jumps. */
  between(a: T, b: T, share: number): T;
  handles(id: string, value: T, around: Surroundings): readonly Handle<T>[];
  fields(id: string, value: T, around: Surroundings): readonly Field<T>[];
  actions(value: T): readonly Action<T>[];
  /** One line for the lecturers' table: the notation and the range. */
  notation(): Words;
}

/** Parameters with whatever type of value. */
export type Params = Readonly<Record<string, Param<unknown>>>;

/** The value type of a parameter. */
export type ValueOf<P> = P extends { readonly initial: infer T } ? T : never;

/** The state that belongs to a set of parameters. */
export type StateOf<P extends Params> = { readonly [K in keyof P]: ValueOf<P[K]> };
