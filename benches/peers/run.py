"""Runs Cordon and its peers on the same work, checks that all finished vectors have the same
hash, and prints the tables in Markdown. Called by run.sh, which builds what is installed.

The work: exact positions after k protocol steps, eps = 1/5, drone i of N at 40i/(N-1) and the
last at 100. CPU seconds of the computation alone, the best of several runs (one, where a run
takes seconds); the second table has whole processes by the clock, start-up and output included."""
import contextlib
import io
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
BUILD = sys.argv[1]
LIMIT = float(os.environ.get("PEERS_LIMIT", "60"))
WORK = [(20, 1000), (20, 10_000), (100, 1000), (100, 10_000), (100, 100_000)]

AT = os.path.join(BUILD, "at")
FLINT = os.path.join(BUILD, "flint")
MULTIPLY = os.path.join(BUILD, "multiply")

# Name, command with {n} and {k}, and how its cost grows: (of N, of k), to skip what would not end.
PEERS = [
    ("Cordon, jump", [AT, "{n}", "{k}", "jump"]),
    ("Cordon, jump over num-bigint", [AT, "{n}", "{k}", "num-bigint"]),
    ("Cordon, step by step", [AT, "{n}", "{k}", "step"]),
    ("FLINT integers, step by step", [FLINT, "{n}", "{k}", "step"]),
    ("FLINT integer matrix power", [FLINT, "{n}", "{k}", "matrix"]),
    ("FLINT rational powering", [FLINT, "{n}", "{k}", "rational"]),
    ("Python integers, common denominator", [sys.executable, os.path.join(HERE, "integers.py"), "{n}", "{k}"]),
    ("Python Fraction", [sys.executable, os.path.join(HERE, "fraction.py"), "{n}", "{k}"]),
    ("SBCL rationals", ["sbcl", "--script", os.path.join(HERE, "rationals.lisp"), "{n}", "{k}"]),
]


def installed(command):
    return shutil.which(command[0]) is not None


def once(command):
    """Seconds and hash, or None where the time limit is exceeded."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT + 5)
    except subprocess.TimeoutExpired:
        return None
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit code {done.returncode}: {done.stderr.strip()}")
    seconds, digest = done.stdout.split()[:2]
    return float(seconds), digest


def best(command):
    found = once(command)
    rounds = 0 if found is None else min(9, int(2 / max(found[0], 0.05)))
    for _ in range(rounds):
        again = once(command)
        if again is None:
            break
        if again[1] != found[1]:
            sys.exit(f"{' '.join(command)}: two runs, two results")
        found = min(found, again)
    return found


def cell(seconds, reference):
    if seconds is None:
        return f"over {LIMIT:.0f}"
    shown = f"{seconds:.2g}" if seconds < 10 else f"{seconds:.0f}"
    if seconds < 0.01:
        shown = f"{seconds:.5f}".rstrip("0")
    return shown if reference is None else f"{shown} ({seconds / reference:.2g}x)"


def exact_table():
    rows, digests = {}, {}
    for n, k in WORK:
        for name, template in PEERS:
            command = [part.format(n=n, k=k) for part in template]
            if not installed(command):
                continue
            column = rows.setdefault(name, {})
            # A peer that did not end on less work will not end on more.
            if any(column.get(w, 0) is None and w[0] <= n and w[1] <= k for w in WORK):
                column[n, k] = None
                continue
            found = best(command)
            column[n, k] = found and found[0]
            if found:
                digests.setdefault((n, k), {})[name] = found[1]
            print(f"N = {n}, k = {k}, {name}: {found}", file=sys.stderr)
    for work, by_name in digests.items():
        if len(set(by_name.values())) != 1:
            sys.exit(f"{work}: the finished vectors differ: {by_name}")
    print("| exact `kth_step`, CPU seconds (ratio to Cordon's default) | "
          + " | ".join(f"N = {n}, k = {k:,}" for n, k in WORK) + " |")
    print("|---|" + "---|" * len(WORK))
    for name, column in rows.items():
        cells = [cell(column[w], rows["Cordon, jump"][w]) for w in WORK]
        print(f"| {name} | " + " | ".join(cells) + " |")
    finished = sum(len(d) for d in digests.values())
    print(f"\nAll {finished} finished vectors have identical hashes (one for each column).")
    return rows


def multiplication(rows):
    if not installed([MULTIPLY]):
        return
    n, k = WORK[-1]
    bits = int(subprocess.run([AT, str(n), str(k), "jump"], capture_output=True, text=True, check=True)
               .stdout.split()[2])
    unit = min(float(subprocess.run([MULTIPLY, str(bits)], capture_output=True, text=True, check=True).stdout)
               for _ in range(3))
    print(f"\nOne GMP multiplication of two integers as long as the answer of N = {n}, k = {k:,} "
          f"({bits / 1e6:.0f} Mbit, numerators and denominators) takes {unit:.2g} s:")
    jump, less = rows["Cordon, jump"][n, k], rows["Cordon, jump"][n, k // 10]
    print(f"Cordon, jump: {jump / unit:.2g} such multiplications; from k = {k // 10:,} to {k:,} its time grows {jump / less:.2g} times.")


# Bits of both factors.
PRODUCTS = [500_000, 1_000_000, 2_500_000, 5_000_000, 10_000_000, 20_000_000, 43_000_000]


def products():
    """Milliseconds of one product, the least of three processes, those of the programs in turn."""
    programs = [("Cordon", "product"), ("FLINT's `fft_small`", "fft_small"), ("GMP", "multiply")]
    programs = [(name, path) for name, path in programs if installed([os.path.join(BUILD, path)])]
    least = {}
    for bits in PRODUCTS:
        for _ in range(3):
            for name, path in programs:
                done = subprocess.run([os.path.join(BUILD, path), str(bits)], capture_output=True, text=True, check=True)
                least[name, bits] = min(least.get((name, bits), float("inf")), float(done.stdout))
    print("| one product, milliseconds (ratio to Cordon's) | "
          + " | ".join(f"{bits / 1e6:g} Mbit" for bits in PRODUCTS) + " |")
    print("|---|" + "---|" * len(PRODUCTS))
    for name, _ in programs:
        cells = [f"{least[name, bits] * 1e3:.3g} ({least[name, bits] / least['Cordon', bits]:.2g}x)" for bits in PRODUCTS]
        print(f"| {name} | " + " | ".join(cells) + " |")


def whole_processes():
    cordon = os.path.join(BUILD, "cordon")
    scenario = os.path.join(HERE, "..", "..", "scenarios", "paper.toml")
    line = ["--drones", "20", "--spread-to", "40", "--max", "100", "--eps", "1/5"]
    runs = [
        ("`cordon trace scenarios/paper.toml`", [cordon, "trace", scenario]),
        ("`cordon trace --at 1000`, N = 20", [cordon, "trace", *line, "--at", "1000"]),
        ("Python integers, N = 20, k = 1,000", [sys.executable, os.path.join(HERE, "integers.py"), "20", "1000"]),
    ]
    print("\n| whole process | milliseconds |")
    print("|---|---|")
    for name, command in runs:
        if not installed(command):
            continue
        fastest = float("inf")
        for _ in range(20):
            begun = time.perf_counter()
            subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
            fastest = min(fastest, time.perf_counter() - begun)
        print(f"| {name} | {fastest * 1e3:.1f} |")


def cpu_seconds(command):
    """User and system time of a whole process; the least of three runs."""
    def spent():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    found = []
    for _ in range(3):
        before = spent()
        subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
        found.append(spent() - before)
    return min(found)


def co_simulation(n=1000, seconds=100):
    """A swarm flown, its run written as CSV: Cordon, whose positions are exact and whose collisions
    are found between samples, beside a plain loop over doubles that only computes."""
    swarm = os.path.join(BUILD, "swarm")
    if not installed([swarm]):
        return
    with tempfile.TemporaryDirectory() as folder:
        scenario, ours, theirs = (os.path.join(folder, name) for name in ("s.toml", "ours.csv", "theirs.csv"))
        with open(scenario, "w") as file:
            start = ", ".join(f'"{40 * i}/{n - 1}"' for i in range(n - 1))
            file.write(f"start = [{start}, 100]\nmin = 0\nmax = 100\nweight = 0.2\nperiod = 4\ntau = 0.05\n")
        cosim = [os.path.join(BUILD, "cordon"), "cosim", scenario, "--duration", str(seconds)]
        rows = [
            ("`cordon cosim`, CSV", cpu_seconds(cosim + ["--out", ours])),
            ("`cordon cosim`, summary alone", cpu_seconds(cosim)),
            ("plain C loop, CSV by `printf`", cpu_seconds([swarm, str(n), str(seconds), theirs])),
            ("plain C loop, last row alone", cpu_seconds([swarm, str(n), str(seconds)])),
        ]
        last = []
        for path in (ours, theirs):
            with open(path) as file:
                last.append([float(x) for x in file.readlines()[-1].split(",")])
    if len(last[0]) != len(last[1]) or any(abs(a - b) > 1e-9 for a, b in zip(*last)):
        sys.exit("co-simulation: the last rows differ by more than 1e-9 m")
    print(f"\n| {n:,} drones flown for {seconds} s, CPU seconds of the process | seconds | to the C loop with CSV |")
    print("|---|---|---|")
    for name, spent in rows:
        print(f"| {name} | {spent:.2f} | {spent / rows[2][1]:.2g} |")


# Weight p/q and last step k of the sweeps. In the first, 32 bits hold every number; in the second
# 53 do up to step 28, and 64 all.
RATES = [(1, 2, 20), (1, 3, 30)]

# A name, a command, the length of the segment (on 36 units Python ends; on 360 the rest has
# something to do), and whether it runs the second sweep too.
SWEEPS = [
    ("Cordon", [os.path.join(BUILD, "cordon"), "sweep", "7.2", "--drones", "5", "--eps", "{p}/{q}", "--grid", "{length}",
                "--steps", "{k}", "--threads", "1"], 360, True),
    ("C, 32 bits, vectors of AVX2", [os.path.join(BUILD, "sweep32-avx2"), "{length}", "{p}", "{q}", "{k}"], 360, False),
    ("C, 32 bits, vectors of x86-64", [os.path.join(BUILD, "sweep32"), "{length}", "{p}", "{q}", "{k}"], 360, False),
    ("C, 64 bits, vectors of AVX2", [os.path.join(BUILD, "sweep-avx2"), "{length}", "{p}", "{q}", "{k}"], 360, True),
    ("C, 64 bits, vectors of x86-64", [os.path.join(BUILD, "sweep"), "{length}", "{p}", "{q}", "{k}"], 360, True),
    ("Python integers", [sys.executable, os.path.join(HERE, "sweep.py"), "{length}", "{p}", "{q}", "{k}"], 36, True),
]


def sweeps():
    """Drone updates a second and core: theorem 7.2, N = 5, whole processes by user time. Of two starts that
    are mirror images all of them run one; those that are run are counted. All do the same number."""
    print("| sweep of 7.2, N = 5, 10^9 updates a second and core | "
          + " | ".join(f"eps = {p}/{q}, k <= {k}" for p, q, k in RATES) + " |")
    print("|---|" + "---|" * len(RATES))
    counted = {}
    for name, template, length, both in SWEEPS:
        cells = []
        for p, q, k in RATES if both else RATES[:1]:
            command = [part.format(length=length, p=p, q=q, k=k) for part in template]
            if not installed(command):
                break
            rate = 0
            for _ in range(5):
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                done = subprocess.run(command, capture_output=True, text=True, check=True)
                seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
                updates = int(re.search(r"(\d+) drone updates", done.stdout + done.stderr)[1])
                if counted.setdefault((length, k), updates) != updates:
                    sys.exit(f"{name}: {updates} drone updates, others {counted[length, k]}")
                rate = max(rate, updates / seconds)
            cells.append(f"{rate / 1e9:.3g}")
        if cells:
            print(f"| {name} | " + " | ".join(cells + [""] * (len(RATES) - len(cells))) + " |")


def write_to_readme(name, text):
    """Puts a table in the place of what is between its two marks in the README."""
    path = os.path.join(HERE, "..", "..", "README.md")
    with open(path) as file:
        readme = file.read()
    begin, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->\n"
    if readme.count(begin) != 1 or readme.count(end) != 1:
        sys.exit(f"README.md: the marks of the table `{name}`: expected each once")
    before, rest = readme.split(begin)
    with open(path, "w") as file:
        file.write(before + begin + text.strip() + "\n" + end + rest.split(end)[1])


TABLES = {
    "exact": lambda: multiplication(exact_table()),
    "products": products,
    "processes": whole_processes,
    "co-simulation": co_simulation,
    "sweeps": sweeps,
}

if __name__ == "__main__":
    # All tables, or those that are named; `--readme` writes them there too.
    named = [name for name in sys.argv[2:] if name != "--readme"] or list(TABLES)
    for name in named:
        if name not in TABLES:
            sys.exit(f"table `{name}`: expected one of {', '.join(TABLES)}")
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            TABLES[name]()
        print(printed.getvalue().strip() + "\n", flush=True)
        if "--readme" in sys.argv[2:] and printed.getvalue().strip():
            write_to_readme(name, printed.getvalue())
