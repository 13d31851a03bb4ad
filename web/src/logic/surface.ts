// Heights of free surfaces at common places, so that two of them can be subtracted.

/** Height of the polyline x, y, x, y, ... (x ascending) at each place; null outside it. */
export function heightsAt(line: Float32Array, places: readonly number[]): (number | null)[] {
  const n = line.length / 2;
  let k = 0;
  return places.map((x) => {
    if (n === 0 || x < line[0]! || x > line[2 * (n - 1)]!) return null;
    while (k + 1 < n - 1 && line[2 * (k + 1)]! < x) k++;
    if (n === 1) return line[1]!;
    const [x0, y0, x1, y1] = [line[2 * k]!, line[2 * k + 1]!, line[2 * k + 2]!, line[2 * k + 3]!];
    return x1 > x0 ? y0 + ((y1 - y0) * (x - x0)) / (x1 - x0) : y1;
  });
}

/** All places of the polylines, ascending, each once. */
export function places(lines: readonly Float32Array[]): number[] {
  const all = new Set<number>();
  for (const line of lines) for (let k = 0; k < line.length; k += 2) if (Number.isFinite(line[k]!)) all.add(line[k]!);
  return [...all].sort((a, b) => a - b);
}
