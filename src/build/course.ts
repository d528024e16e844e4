import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { Part } from "../../lessons/toc.ts";
import { LANGS } from "../words/words.ts";
import { checkLinks, checkTwins, missingTwins } from "./check-lessons.ts";
import { compileLesson, type Lesson, type LessonSource, type Workbench } from "./compile-lesson.ts";
import { choices, type Problem } from "./problem.ts";

/** All lessons that exist, in the order of the course, and everything that is wrong with them. */
export interface Course {
  readonly lessons: readonly Lesson[];
  readonly problems: readonly Problem[];
}

/** The markdown files of the lessons, by folder. */
export function readLessonFiles(root: string): LessonSource[] {
  const folder = join(root, "lessons");
  const ids = readdirSync(folder, { withFileTypes: true }).filter((entry) => entry.isDirectory());
  return ids.flatMap(({ name: id }) =>
    LANGS.filter((lang) => existsSync(join(folder, id, `${lang}.md`))).map((lang) => {
      const file = `lessons/${id}/${lang}.md`;
      return { id, lang, file, source: readFileSync(join(root, file), "utf8") };
    }),
  );
}

/** Compiled lessons, so that a saved file costs only itself. Dropped as soon as a demo or a rule changes. */
const compiled = new Map<string, { source: string; result: ReturnType<typeof compileLesson> }>();

function compile(source: LessonSource, bench: Workbench): ReturnType<typeof compileLesson> {
  const before = compiled.get(source.file);
  if (before?.source === source.source) return before.result;
  const result = compileLesson(source, bench);
  compiled.set(source.file, { source: source.source, result });
  return result;
}

/** Compiles all lessons and checks them against each other. */
export function makeCourse(files: readonly LessonSource[], parts: readonly Part[], bench: Workbench): Course {
  const order = parts.flatMap((part) => part.lessons);
  const results = files.map((file) => compile(file, bench));
  const lessons = results
    .flatMap(({ lesson }) => (lesson ? [lesson] : []))
    .sort((a, b) => order.indexOf(a.id) - order.indexOf(b.id));
  const problems = results.flatMap((result) => result.problems);
  for (const { id, file } of files) {
    if (!order.includes(id)) {
      const message = `the lesson "${id}" has no place in lessons/toc.ts`;
      problems.push({ file, line: 1, message, remedy: choices(id, order) });
    }
  }
  const twins = [...new Set(lessons.map(({ id }) => id))].flatMap((id) => {
    const [de, en] = LANGS.map((lang) => lessons.find((one) => one.id === id && one.lang === lang));
    return de && en ? checkTwins(de, en) : [];
  });
  // What was mistyped in one language only makes the twins differ; that is told once.
  const told = new Set(problems.map(({ file, line }) => `${file}:${line}`));
  const other = twins.filter(({ file, line }) => !told.has(`${file}:${line}`));
  return {
    lessons,
    problems: [...problems, ...missingTwins(files), ...checkLinks(lessons, order), ...other],
  };
}
