const GAP = 8;

/** Puts a popover below something, or above where there is no room, within the window. */
export function putBeside(popover: HTMLElement, { left, top, bottom }: DOMRect): void {
  const { width, height } = popover.getBoundingClientRect();
  const right = document.documentElement.clientWidth - GAP - width;
  const below = bottom + GAP + height < innerHeight;
  popover.style.left = `${Math.max(GAP, Math.min(left, right))}px`;
  popover.style.top = `${below ? bottom + GAP : Math.max(GAP, top - GAP - height)}px`;
}
