// Which frames of a run become pictures.

import { expect, it } from "vitest";
import type { Run } from "../../src/data/run";
import { momentsOf } from "../../src/sections/moments";

const runOf = (times: number[]) => ({ meta: { times, finished: true, events: null } }) as unknown as Run;

it("shows no frame twice, however few there are", () => {
  const two = momentsOf(runOf([0, 0.05]), (time) => (time < 0.025 ? 0 : 1));
  expect(two.map(({ time }) => time)).toEqual([0, 0.05]);
  expect(momentsOf(runOf([0]), () => 0)).toHaveLength(1);
  const many = momentsOf(runOf([0, 1, 2, 3, 4]), Math.round);
  expect(many.map(({ time }) => time)).toEqual([0, 1, 2, 3, 4]);
});
