/**
 * The one inline line of every page: sets the theme before the first paint, so that a dark page never
 * flashes. A `theme` in the query comes first; the reader's stored choice counts only where the page stands
 * by itself, since storage may throw inside a frame and a slide should not follow the course's setting.
 */
export const BOOT =
  '(d=>{try{let t=new URLSearchParams(location.search).get("theme");' +
  'if(!t&&self===top)t=localStorage.getItem("straklatte.theme");' +
  'if(t==="light"||t==="dark")d.dataset.theme=t}catch{}d.classList.add("js")})(document.documentElement)';
