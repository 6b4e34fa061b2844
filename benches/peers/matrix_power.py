"""A jump of a dense own protocol against FLINT's matrix power. Needs python-flint.

    python3 benches/peers/matrix_power.py target/release/cordon

Twenty agents, every coefficient p/10 with p random from -9 to 9, k = 10,000. FLINT raises the integer
matrix and then multiplies the start; Cordon's time is that of the whole program: reading the file, the
jump, lowest terms, printing. Both give the same fractions, or the script fails.
"""

import random
import resource
import subprocess
import sys
import tempfile
import time
from fractions import Fraction

from flint import fmpz_mat

N, K = 20, 10_000
random.seed(1)
entries = [[random.randint(-9, 9) for _ in range(N)] for _ in range(N)]
rules = "\n".join(
    f'{i} = "' + " + ".join(f"({a})/10*x{j}" for j, a in enumerate(row)) + '"'
    for i, row in enumerate(entries)
)
text = f'title = "dense"\nagents = {N}\nclaims = ["x0 >= 0"]\n[rules]\n{rules}\n'

begun = time.process_time()
power = fmpz_mat(entries) ** K
moved = power * fmpz_mat([[i] for i in range(N)])
flint = time.process_time() - begun

with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
    file.write(text)
    file.flush()
    start = ",".join(map(str, range(N)))
    command = [sys.argv[1], "trace", "--protocol", file.name, "--start", start, "--at", str(K)]
    command += ["--format", "csv", "--numbers", "fraction"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    out = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
cordon = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

sys.set_int_max_str_digits(0)
found = [Fraction(x) for x in out.splitlines()[1].split(",")[2:]]
assert found == [Fraction(int(moved[i, 0]), 10**K) for i in range(N)], "not the same"
print(f"FLINT {flint:.3f} s, Cordon {cordon:.3f} s of CPU: {cordon / flint:.2f} times")
