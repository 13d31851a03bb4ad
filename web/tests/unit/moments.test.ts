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

it("shows where stages begin and when it floods", () => {
  const events = { slides: [{ begins: 3 }], flood: { first_time_below: 4 },
    stages: [{ name: "daily", start: 0, end: 2 }, { name: "flood", start: 2, end: 6 }] };
  const run = { index: 0, meta: { times: [0, 1, 2, 3, 4, 5, 6], finished: true, events } } as unknown as Run;
  expect(momentsOf(run, Math.round).map(({ time, text }) => `${time} ${text}`)).toEqual(
    ["0 start", "2 stage flood begins", "3 first slide begins", "4 it floods", "6 end"]);
});
