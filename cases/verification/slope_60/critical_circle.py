#!/usr/bin/env python3
"""Stability number S_u / (F gamma H) of a slope with phi_u = 0 by the worst slip circle: checks Taylor (1937).

usage: critical_circle.py [BETA DEPTH]...   slope angle [degrees], depth factor (firm base at DEPTH H below the crest)
"""
import sys

import numpy as np

N_SLICES = 1000


def stability_number(circle, beta, depth):
    """Driving moment over R^2 times the arc's angle, for gamma = H = S_u = 1. Origin at the toe, soil to the right."""
    xc, yc, radius = circle
    if yc - radius < 1.0 - depth or radius <= 0.0:
        return 0.0
    run = 1.0 / np.tan(beta)
    dx = 2.0 * radius / N_SLICES
    x = xc - radius + dx * (np.arange(N_SLICES) + 0.5)
    surface = np.clip(x / run, 0.0, 1.0)
    height = surface - (yc - np.sqrt(np.maximum(radius**2 - (x - xc) ** 2, 0.0)))
    first = last = int(np.argmax(height))
    if height[first] <= 0.0:
        return 0.0
    while first > 0 and height[first - 1] > 0.0:
        first -= 1
    while last < N_SLICES - 1 and height[last + 1] > 0.0:
        last += 1
    inside = slice(first, last + 1)
    moment = np.sum(height[inside] * (x[inside] - xc)) * dx
    ends = np.clip((np.array([x[first] - dx / 2, x[last] + dx / 2]) - xc) / radius, -1.0, 1.0)
    return moment / (radius**2 * np.diff(np.arcsin(ends))[0])


def worst_circle(beta, depth, seed=1):
    """Random search, then a walk with shrinking steps."""
    random = np.random.default_rng(seed)
    best, where = 0.0, None
    for _ in range(4000):
        xc, yc = random.uniform(-1.0, 1.0 / np.tan(beta) + 1.0), random.uniform(0.5, 6.0)
        radius = np.hypot(xc, yc) if random.random() < 0.4 else random.uniform(0.5, 1.0) * (yc + depth - 1.0)
        if (number := stability_number((xc, yc, radius), beta, depth)) > best:
            best, where = number, np.array([xc, yc, radius])
    step = 0.3
    for k in range(3000):
        trial = where + step * random.normal(size=3)
        if (number := stability_number(trial, beta, depth)) > best:
            best, where = number, trial
        elif k % 60 == 59:
            step *= 0.8
    return best, where


def main(arguments):
    values = [float(a) for a in arguments] or [60.0, 1.0, 26.565, 2.0]
    for beta, depth in zip(values[::2], values[1::2]):
        number, (xc, yc, radius) = max((worst_circle(np.radians(beta), depth, seed) for seed in range(4)),
                                       key=lambda found: found[0])
        print(f"{beta:7.3f} degrees, D = {depth:g}: N = {number:.4f}, centre ({xc:.2f}, {yc:.2f}) H from the toe, "
              f"radius {radius:.2f} H")


if __name__ == "__main__":
    main(sys.argv[1:])
