"""kth_step over fractions.Fraction: what a Python user writes first. Arguments: N K."""
import sys
import time
from fractions import Fraction

from fold import folded


def main():
    count, steps = int(sys.argv[1]), int(sys.argv[2])
    x = [Fraction(40 * i, count - 1) for i in range(count - 1)] + [Fraction(100)]
    eps = Fraction(1, 5)
    begun = time.process_time()
    for _ in range(steps):
        inner = [eps * x[i - 1] + (1 - 2 * eps) * x[i] + eps * x[i + 1] for i in range(1, count - 1)]
        x = [x[0], *inner, x[-1]]
    seconds = time.process_time() - begun
    print(f"{seconds:.6f} {folded((f.numerator, f.denominator) for f in x)}")


main()
