/** A camera on its way around an object: a natural cubic spline through six places. */
export const camera = [
  '<path class="p-view" d="M14 126L43.7 130.5L41 112.9Z"/>',
  '<path class="p-view" d="M50 92L77.1 104.9L79.6 87.4Z"/>',
  '<path class="p-view" d="M82 50L97.7 75.5L109.4 62.2Z"/>',
  '<path class="p-view" d="M130 30L127.2 59.9L144.6 56.2Z"/>',
  '<path class="p-view" d="M182 42L160.2 62.6L175.7 71.3Z"/>',
  '<path class="p-thin" d="M130 110L146 118L162 110V94L146 86L130 94ZM130 94L146 102L162 94M146 102V118"/>',
  '<path class="p-curve" d="M14 126C26.7 115.7 39.4 105.3 50 92C60.6 78.7 69.1 62.4 82 50C94.9 37.6 112.2 29 130 30C147.8 31 165.9 41.4 182 42C198.1 42.6 212 33.3 226 24"/>',
  '<circle class="p-handle" cx="14" cy="126" r="3.4"/>',
  '<circle class="p-handle" cx="50" cy="92" r="3.4"/>',
  '<circle class="p-handle" cx="82" cy="50" r="3.4"/>',
  '<circle class="p-handle" cx="130" cy="30" r="3.4"/>',
  '<circle class="p-handle" cx="182" cy="42" r="3.4"/>',
  '<circle class="p-handle" cx="226" cy="24" r="3.4"/>',
].join("");
