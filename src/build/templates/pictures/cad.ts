/** A fastback: its line from tail to lamp is one chain of three Bézier arcs, joined without a kink. */
export const cad = [
  '<path class="p-fill" d="M14 82C46 76 78 50 118 50C152 50 160 72 190 78C212 82.4 228 88 229 102C229.2 106 227 109 222 109.4L204.5 110A19.5 19.5 0 0 0 165.5 110H74.5A19.5 19.5 0 0 0 35.5 110H22C14 110 11 94 14 82Z"/>',
  '<path class="p-thin" d="M229 102C229.2 106 227 109 222 109.4L204.5 110A19.5 19.5 0 0 0 165.5 110H74.5A19.5 19.5 0 0 0 35.5 110H22C14 110 11 94 14 82"/>',
  '<path class="p-faint" d="M80 73.5C92 60 104 56.5 119 56.5C138 56.5 146 66 158 76.5C132 77.5 106 76.5 80 73.5ZM124 56.8L126 77M20 88C70 84 150 86 224 92"/>',
  '<circle class="p-thin" cx="55" cy="111.5" r="15"/>',
  '<circle class="p-faint" cx="55" cy="111.5" r="9"/>',
  '<circle class="p-thin" cx="185" cy="111.5" r="15"/>',
  '<circle class="p-faint" cx="185" cy="111.5" r="9"/>',
  '<path class="p-net" d="M14 82L46 76L78 50L118 50L152 50L160 72L190 78"/>',
  '<path class="p-curve" d="M14 82C46 76 78 50 118 50C152 50 160 72 190 78C212 82.4 228 88 229 102"/>',
  '<circle class="p-handle" cx="46" cy="76" r="3.4"/>',
  '<circle class="p-handle" cx="78" cy="50" r="3.4"/>',
  '<circle class="p-handle" cx="152" cy="50" r="3.4"/>',
  '<circle class="p-handle" cx="160" cy="72" r="3.4"/>',
  '<circle class="p-knot" cx="14" cy="82" r="2.6"/>',
  '<circle class="p-knot" cx="118" cy="50" r="2.6"/>',
  '<circle class="p-knot" cx="190" cy="78" r="2.6"/>',
].join("");
