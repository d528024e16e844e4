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
  const last = [...links.values()].at(-1);
  let here: HTMLAnchorElement | undefined;
  let atEnd = false;
  let marked: HTMLAnchorElement | undefined;
  const mark = () => {
    const link = atEnd ? last : here;
    if (link === marked) return;
    marked?.removeAttribute("aria-current");
    link?.setAttribute("aria-current", "true");
    if (link) reveal(link, nav);
    marked = link;
  };
  // A line a quarter down the window: the section that crosses it is the one being read.
  const reading = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        if (isIntersecting) here = links.get(target);
        else if (here === links.get(target)) here = undefined;
      }
      mark();
    },
    { rootMargin: "-25% 0px -75% 0px" },
  );
  for (const section of links.keys()) reading.observe(section);
  // Where the page ends, the last section may never come so far up.
  const end = new IntersectionObserver((entries) => {
    atEnd = entries.at(-1)!.isIntersecting && scrollY > 0;
    mark();
  });
  const foot = document.querySelector(".foot");
  if (foot) end.observe(foot);
}

/** Scrolls the contents, and only them, so far that the marked entry is seen. */
function reveal(link: HTMLElement, nav: HTMLElement): void {
  const box = nav.getBoundingClientRect();
  const { top, bottom } = link.getBoundingClientRect();
  if (top < box.top) nav.scrollTop -= box.top - top + 40;
  else if (bottom > box.bottom) nav.scrollTop += bottom - box.bottom + 40;
}
