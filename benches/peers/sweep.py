#!/usr/bin/env python3
"""The sweep of theorem 7.2 in plain Python, for comparison with `cargo bench --bench sweep`.

Every strictly ordered integer start of N = 5 drones on a segment of 36 grid units, eps = 1/3,
steps k = 0 .. 30, integers over the common denominator: the same work as the benchmark's row
`7.2 N=5 eps=1/3 k<=30, 64 bits`, starts that are mirror images of others left out alike.
Prints the number of starts, violations and drone updates, and the rate.
"""

import time
from itertools import combinations

N, LENGTH, STEPS = 5, 36, 30
P, Q = 1, 3


def sweep():
    starts = violations = updates = 0
    for inner in combinations(range(1, LENGTH), N - 2):
        x = (0, *inner, LENGTH)
        mirror = tuple(LENGTH - y for y in reversed(x))
        if mirror < x:
            continue
        starts += 1
        own, first, last = Q - 2 * P, 0, LENGTH
        for k in range(STEPS + 1):
            if k > 0:
                inner = [P * x[i - 1] + own * x[i] + P * x[i + 1] for i in range(1, N - 1)]
                first, last = Q * first, Q * last
                x = (first, *inner, last)
                updates += N
            if any(x[i] >= x[i + 1] for i in range(N - 1)):
                violations += 1
    return starts, violations, updates


def main():
    began = time.perf_counter()
    starts, violations, updates = sweep()
    seconds = time.perf_counter() - began
    print(
        f"{starts} starts, {violations} violations, {updates} drone updates "
        f"in {seconds:.3f} s: {updates / seconds / 1e6:.2f} million a second"
    )


main()
