// Heights of free surfaces at common places, so that two of them can be subtracted.

/** Height of the polyline x, y, x, y, ... (x ascending) at x; level beyond its ends. */
export function heightAt(line: ArrayLike<number>, x: number): number {
  let after = 0;
  while (after + 1 < line.length && line[after]! <= x) after += 2;
  if (after === 0) return line[1]!;
  const [x0, y0] = [line[after - 2]!, line[after - 1]!];
  if (after + 1 >= line.length) return y0;
  return y0 + ((line[after + 1]! - y0) * (x - x0)) / (line[after]! - x0);
}

/** Its heights at places; null beyond its ends. */
export function heightsAt(line: ArrayLike<number>, places: readonly number[]): (number | null)[] {
  const [first, last] = [line[0] ?? NaN, line[line.length - 2] ?? NaN];
  return places.map((x) => (x >= first && x <= last ? heightAt(line, x) : null));
}

/** All places of the polylines, ascending, each once. */
export function places(lines: readonly Float32Array[]): number[] {
  const all = new Set<number>();
  for (const line of lines) for (let k = 0; k < line.length; k += 2) if (Number.isFinite(line[k]!)) all.add(line[k]!);
  return [...all].sort((a, b) => a - b);
}
