"""kth_step over integers with the common denominator (N-1)*5^k: the best that plain Python
does. Arguments: N K."""
import sys
import time

from fold import folded


def main():
    count, steps = int(sys.argv[1]), int(sys.argv[2])
    x = [40 * i for i in range(count - 1)] + [100 * (count - 1)]
    begun = time.process_time()
    for _ in range(steps):
        inner = [a + 3 * b + c for a, b, c in zip(x, x[1:], x[2:])]
        x = [5 * x[0], *inner, 5 * x[-1]]
    seconds = time.process_time() - begun
    den = (count - 1) * 5**steps
    print(f"{seconds:.6f} {folded((n, den) for n in x)}")


main()
