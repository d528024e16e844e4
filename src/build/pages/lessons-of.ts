import type { Part } from "../../../lessons/toc.ts";
import type { Lang } from "../../words/words.ts";
import type { Lesson } from "../compile-lesson.ts";
import type { Course } from "../course.ts";

/** The lessons of a part that exist, in order. */
export function lessonsOf(part: Part, { lessons }: Course, lang: Lang): Lesson[] {
  return part.lessons.flatMap((id) => lessons.filter((one) => one.id === id && one.lang === lang));
}

/** A lesson's place among all lessons of the course, from 1, written or not. */
export function numberOf(id: string, parts: readonly Part[]): number {
  return parts.flatMap((part) => part.lessons).indexOf(id) + 1;
}
