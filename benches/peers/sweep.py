#!/usr/bin/env python3
"""The sweep of theorem 7.2 in plain Python, for comparison with `cordon sweep`: as sweep.c, one start
after the other. Arguments LENGTH P Q K; prints drone updates and violations."""

import sys
from itertools import combinations

N = 5
LENGTH, P, Q, K = map(int, sys.argv[1:])


def sweep():
    violations = updates = 0
    for inner in combinations(range(1, LENGTH), N - 2):
        x = (0, *inner, LENGTH)
        mirror = tuple(LENGTH - y for y in reversed(x))
        if mirror < x:
            continue
        own, first, last = Q - 2 * P, 0, LENGTH
        for k in range(K + 1):
            if k > 0:
                inner = [P * x[i - 1] + own * x[i] + P * x[i + 1] for i in range(1, N - 1)]
                first, last = Q * first, Q * last
                x = (first, *inner, last)
                updates += N
            if any(x[i] >= x[i + 1] for i in range(N - 1)):
                violations += 1
    return updates, violations


print("{} drone updates, {} violations".format(*sweep()))
