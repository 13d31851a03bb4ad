import { describe, expect, it } from "vitest";
import { fromHash, toHash } from "../../src/shell/address";
import type { ViewState } from "../../src/logic/store";

const state = {
  time: 1.25, field: "su", map: "cividis", rangeMode: "fixed", fixed: [-2.5, 8], log: false, mesh: true, layers: true, water: false, outline: false, slip: true, surfaces: false, names: true,
  camera: { x: 4, y: 1.5, scale: 120 }, profileX: 27.5,
} as ViewState;

describe("the address", () => {
  it("holds what the reader looks at", () => {
    const { time, field, map, rangeMode, fixed, log, mesh, layers, water, outline, slip, surfaces, names, camera, profileX } = state;
    expect(fromHash(toHash(state), ["su"], [0, 4])).toEqual({ time, field, map, rangeMode, fixed, log, mesh, layers, water, outline, slip, surfaces, names, camera, profileX });
  });
  it("changes nothing where it cannot be understood", () => {
    expect(fromHash("", ["su"], [0, 4])).toEqual({});
    expect(fromHash("#t=now&field=__proto__&range=all&camera=1_2&fixed=a_b", ["su"], [0, 4])).toEqual({});
    expect(fromHash("#range=fixed", ["su"], [0, 4])).toEqual({});
    expect(fromHash("#t=99", ["su"], [0, 4])).toEqual({ time: 4 });
  });
});
