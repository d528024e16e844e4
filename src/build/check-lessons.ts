import { LANGS } from "../words/words.ts";
import type { Lesson } from "./compile-lesson.ts";
import type { Bone } from "./markdown/env.ts";
import { choices, type Problem } from "./problem.ts";

/** Every link between lessons, and the lessons they build on, must lead somewhere. */
export function checkLinks(lessons: readonly Lesson[], ids: readonly string[]): Problem[] {
  const problems: Problem[] = [];
  for (const lesson of lessons) {
    const report = (line: number, message: string, remedy: string) =>
      problems.push({ file: lesson.file, line, message, remedy });
    for (const { line, lesson: id, anchor } of lesson.links) {
      const target = id === null ? lesson : lessons.find((one) => one.id === id && one.lang === lesson.lang);
      if (!target) {
        report(line, `no lesson "${id}"`, choices(id!, [...new Set(lessons.map((one) => one.id))]));
      } else if (anchor !== null && !target.anchors.some((one) => one.id === anchor)) {
        const all = target.anchors.map((one) => one.id);
        report(line, `no anchor "${anchor}" in ${target.file}`, choices(anchor, all));
      }
    }
    for (const { value, line } of lesson.front.prerequisites) {
      if (!ids.includes(value)) report(line, `no lesson "${value}" in lessons/toc.ts`, choices(value, ids));
    }
  }
  return problems;
}

/** The two languages of a lesson must have the same skeleton; the first place where they differ is told. */
export function checkTwins(de: Lesson, en: Lesson): Problem[] {
  const problems: Problem[] = [];
  const count = Math.max(de.skeleton.length, en.skeleton.length);
  for (let i = 0; i < count; i++) {
    const [a, b] = [de.skeleton[i], en.skeleton[i]];
    if (a?.sign === b?.sign) continue;
    problems.push(difference(de, en, a, b));
    break;
  }
  if (problems.length === 0) problems.push(...stateLinkDifferences(de, en), ...frontDifferences(de, en));
  return problems;
}

function difference(de: Lesson, en: Lesson, a: Bone | undefined, b: Bone | undefined): Problem {
  const [mine, other] = a ? [de, en] : [en, de];
  const [here, there] = a ? [a, b] : [b!, a];
  const found = there ? `${other.file}:${there.line} has: ${there.sign}` : `${other.file} ends before`;
  return {
    file: mine.file,
    line: here.line,
    message: `the languages differ. Here: ${here.sign}. At the same place ${found}`,
    remedy:
      "give both languages the same headings (ids), demos (ids, states), formulas and blocks in one order",
  };
}

/** Word order may move a link within its section, so each section is compared as a set. */
function stateLinkDifferences(de: Lesson, en: Lesson): Problem[] {
  const [a, b] = [linksBySection(de), linksBySection(en)];
  const problems: Problem[] = [];
  for (const [mine, other, lesson, twin] of [
    [a, b, de, en],
    [b, a, en, de],
  ] as const) {
    for (const [sign, lines] of mine) {
      if (lines.length <= (other.get(sign)?.length ?? 0)) continue;
      problems.push({
        file: lesson.file,
        line: lines.at(-1)!,
        message: `the state link ${sign} has no twin in ${twin.file}`,
        remedy: "let the same section of both languages link to the same states",
      });
    }
  }
  return problems;
}

function linksBySection(lesson: Lesson): Map<string, number[]> {
  const found = new Map<string, number[]>();
  for (const { line, figure, query } of lesson.stateLinks) {
    const section = lesson.headings.filter((heading) => heading.line <= line).at(-1);
    const sign = `demo:${figure}?${query} (section #${section?.id ?? "top"})`;
    found.set(sign, [...(found.get(sign) ?? []), line]);
  }
  return found;
}

function frontDifferences(de: Lesson, en: Lesson): Problem[] {
  const sign = ({ front }: Lesson) =>
    JSON.stringify({
      minutes: front.minutes,
      goals: front.goals.length,
      prerequisites: front.prerequisites.map(({ value }) => value),
      addition: front.addition,
    });
  if (sign(de) === sign(en)) return [];
  return [
    {
      file: en.file,
      line: 1,
      message: `the front matter differs from ${de.file}: ${sign(en)} against ${sign(de)}`,
      remedy: "give both languages the same minutes, prerequisites, addition and number of goals",
    },
  ];
}

/** A lesson needs a file for each language. */
export function missingTwins(files: readonly { readonly id: string; readonly lang: string }[]): Problem[] {
  const ids = [...new Set(files.map(({ id }) => id))];
  return ids.flatMap((id) => {
    const langs = LANGS.filter((lang) => !files.some((file) => file.id === id && file.lang === lang));
    return langs.map((lang) => ({
      file: `lessons/${id}/${lang}.md`,
      line: 1,
      message: `the lesson "${id}" has no ${lang}.md`,
      remedy: "write the lesson in both languages",
    }));
  });
}
