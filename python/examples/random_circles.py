#!/usr/bin/python3
"""How probable is it that a slope with a random undrained strength fails, by slip circles alone?

    python3 python/examples/random_circles.py [--samples 2000] [--cov 0.5]

The slope of tests/batch/reference_test.cpp: 2:1, 10 m high, on as much clay, c_u lognormal with a mean of 0.25 gamma H
and a separable Markov correlation. Of each sample of the field the lowest factor of safety of many circles is found, by
moments about their centres. A circle cannot follow weak soil, so the true P is no smaller. The script shares no code
with the solver: `terp study` must give as much, or more (docs/probability.md).
"""
import argparse

import numpy as np
import scipy.sparse

HEIGHT, WEIGHT = 10.0, 2000.0 * 9.81  # H [m], gamma [N/m3]
STEP = 0.5                            # of the grid of the field, and width of a slice [m]
NX, NY = 121, 41                      # nodes of the field, over 60 m x 20 m


def ground(x):
    return np.interp(x, [20.0, 40.0], [20.0, 10.0])


def arc(xc, yc, radius):
    """Slices of the soil above a circle: x of their middles, height, length of the arc; None where it cuts no slope."""
    x = np.arange(0.5 * STEP, 60.0, STEP)
    within = np.abs(x - xc) < radius
    y = np.full_like(x, np.inf)
    y[within] = yc - np.sqrt(radius**2 - (x[within] - xc) ** 2)
    slices = np.nonzero(y < ground(x))[0]
    if len(slices) < 8 or np.any(np.diff(slices) != 1) or slices[0] == 0 or slices[-1] == len(x) - 1:
        return None
    x, y = x[slices], y[slices]
    return x, y, STEP / np.sqrt(np.maximum(1.0 - ((x - xc) / radius) ** 2, 1e-3))


def circles():
    """Rows of resisting moment per strength at the nodes, over the driving moment: shape [n_circles, n_nodes]."""
    rows, columns, values = [], [], []
    n = 0
    for xc in np.arange(20.0, 46.0, 2.0):
        for yc in np.arange(20.5, 45.0, 2.0):
            for lowest in np.arange(0.5, 10.1, 0.5):
                found = arc(xc, yc, yc - lowest)
                if found is None:
                    continue
                x, y, length = found
                driving = np.sum(WEIGHT * (ground(x) - y) * STEP * (xc - x))  # it turns towards larger x
                if driving <= 0.0:
                    continue
                node = np.rint(x / STEP - 0.01).astype(int) * NY + np.rint(y / STEP).astype(int)
                rows += [n] * len(x)
                columns += list(node)
                values += list(length * (yc - lowest) / driving)
                n += 1
    return scipy.sparse.csr_matrix((values, (rows, columns)), shape=(n, NX * NY))


def fields(generator, theta, cov, n):
    """Lognormal strengths [Pa], shape [n, n_nodes]: two chains give the separable Markov correlation exactly."""
    r = np.exp(-2.0 * STEP / theta)
    z = generator.standard_normal((n, NX, NY))
    for i in range(1, NX):
        z[:, i] = r * z[:, i - 1] + np.sqrt(1.0 - r * r) * z[:, i]
    for j in range(1, NY):
        z[:, :, j] = r * z[:, :, j - 1] + np.sqrt(1.0 - r * r) * z[:, :, j]
    sigma = np.sqrt(np.log(1.0 + cov**2))
    return 0.25 * WEIGHT * HEIGHT * np.exp(sigma * z - 0.5 * sigma**2).reshape(n, -1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--samples", type=int, default=2000)
    parser.add_argument("--cov", type=float, default=0.5)
    options = parser.parse_args()
    factors = circles()
    uniform = (factors @ np.ones(NX * NY)).min()
    print(f"{factors.shape[0]} circles; the slope fails below c_u = {1.0 / (uniform * WEIGHT * HEIGHT):.4f} gamma H")
    generator = np.random.default_rng(1)
    for theta in (5.0, 10.0, 20.0, 40.0, 1e6):
        failed = 0
        for first in range(0, options.samples, 250):
            n = min(250, options.samples - first)
            failed += np.sum((factors @ fields(generator, theta, options.cov, n).T).min(axis=0) < 1.0)
        p = failed / options.samples
        print(f"theta / H = {theta / HEIGHT:g}: P = {p:.4f} +- {np.sqrt(p * (1.0 - p) / options.samples):.4f}")


if __name__ == "__main__":
    main()
