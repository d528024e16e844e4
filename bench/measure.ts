/** One way to do a job: `run` does it `operations` times and returns a number that depends on every result. */
export type Contender = { readonly name: string; readonly operations: number; readonly run: () => number };

/** Time per operation in nanoseconds, by contender. */
export type Times = Readonly<Record<string, number>>;

let sink = 0;

/**
 * Times contenders against each other: in every round each runs once, so that whatever slows the machine down
 * slows all of them; the medians of the rounds are compared.
 */
export function measure(contenders: readonly Contender[], rounds = 41): Times {
  for (const { run } of contenders) {
    // Until the compiler has made up its mind.
    const start = performance.now();
    for (let k = 0; k < 3 || (k < 500 && performance.now() - start < 200); k++) sink += run();
  }
  const samples = contenders.map((): number[] => []);
  for (let round = 0; round < rounds; round++) {
    // Back and forth, since a contender finds warm what the one before it has touched.
    const order = round % 2 === 0 ? [...contenders.keys()] : [...contenders.keys()].reverse();
    order.forEach((i) => {
      const { run, operations } = contenders[i]!;
      const start = performance.now();
      sink += run();
      samples[i]!.push(((performance.now() - start) * 1e6) / operations);
    });
  }
  return Object.fromEntries(contenders.map(({ name }, i) => [name, median(samples[i]!)]));
}

/** The sum of all results, to be printed: work whose result nobody reads could be left out by the compiler. */
export function checksum(): number {
  return sink;
}

function median(values: readonly number[]): number {
  return [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)]!;
}
