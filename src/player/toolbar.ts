import { element } from "./element.ts";
import { createTool, type Tool, type ToolId } from "./tool.ts";

/** What a button of the toolbar is, and how it looks in the present state. */
export interface ToolSpec {
  readonly id: ToolId;
  readonly run: () => void;
  readonly look: () => {
    readonly name: string;
    readonly icon?: ToolId;
    readonly disabled?: boolean;
    readonly pressed?: boolean;
  };
}

export interface Toolbar {
  readonly root: HTMLElement;
  update(): void;
}

/** A row of buttons, each with an accessible name and a tooltip. */
export function createToolbar(name: string, specs: readonly ToolSpec[]): Toolbar {
  const root = element("div", { class: "tools", role: "group", "aria-label": name });
  const tools = specs.map((spec): readonly [ToolSpec, Tool] => {
    const tool = createTool(spec.id, () => {
      if (!spec.look().disabled) spec.run();
    });
    root.append(tool.root);
    return [spec, tool];
  });
  const update = () => {
    for (const [spec, tool] of tools) tool.update(spec.look());
  };
  update();
  return { root, update };
}
