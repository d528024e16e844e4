/**
 * What is wider than its box (a formula, lines of code, a table) can be scrolled by keys as well: then the box
 * takes the focus, and says what it is. The others stay out of the way of the Tab key.
 */
export function scrollBoxes(boxes: Iterable<HTMLElement>): void {
  const seen = new Set<HTMLElement>();
  const look = (box: HTMLElement) => {
    if (box.scrollWidth > box.clientWidth + 1) {
      box.tabIndex = 0;
      box.setAttribute("role", "group");
      box.setAttribute("aria-label", box.dataset.label ?? "");
    } else {
      box.removeAttribute("tabindex");
      box.removeAttribute("role");
      box.removeAttribute("aria-label");
    }
  };
  // Only what is on the screen is measured: measuring the rest would lay it out.
  const near = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      const box = target as HTMLElement;
      if (!isIntersecting) seen.delete(box);
      else {
        seen.add(box);
        look(box);
      }
    }
  });
  for (const box of boxes) near.observe(box);
  addEventListener("resize", () => seen.forEach(look));
}
