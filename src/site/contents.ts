/**
 * Marks the section that is being read in the contents, and closes the sheet of contents once it has served.
 */
export function contents(nav: HTMLElement, main: HTMLElement): void {
  nav.addEventListener("click", (event) => {
    if (event.target instanceof Element && event.target.closest("a") && nav.matches(":popover-open")) {
      nav.hidePopover();
    }
  });

  const links = new Map<Element, HTMLAnchorElement>();
  for (const link of nav.querySelectorAll<HTMLAnchorElement>('.sections a[href^="#"]')) {
    const heading = document.getElementById(decodeURIComponent(link.hash.slice(1)));
    const section = heading?.closest("section");
    if (section && main.contains(section)) links.set(section, link);
  }
  // A line a quarter down the window: the section that crosses it is the one being read.
  const reading = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        const link = links.get(target);
        if (isIntersecting) link?.setAttribute("aria-current", "true");
        else link?.removeAttribute("aria-current");
        if (isIntersecting && link) reveal(link, nav);
      }
    },
    { rootMargin: "-25% 0px -75% 0px" },
  );
  for (const section of links.keys()) reading.observe(section);
}

/** Scrolls the contents, and only them, so far that the marked entry is seen. */
function reveal(link: HTMLElement, nav: HTMLElement): void {
  const box = nav.getBoundingClientRect();
  const { top, bottom } = link.getBoundingClientRect();
  if (top < box.top) nav.scrollTop -= box.top - top + 40;
  else if (bottom > box.bottom) nav.scrollTop += bottom - box.bottom + 40;
}
