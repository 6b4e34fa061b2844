#!/usr/bin/env python3
"""A second checker of certificates, written from proofs/checker/FORMAT.md alone.

It shares no code and no language with the first. What it has of the protocol it writes out itself, so that it also says
whether the clauses that the first reads off the spec are those of the paper. Usage: check.py FILE...; a line a file.
"""
import json
import re
import sys
from fractions import Fraction

SCHEMA = "cordon-certificate/2"
MAX_BYTES, MAX_NUMBER, MAX_DEPTH, MAX_NAME, MAX_DRONES, MAX_WORK = 4 << 20, 2100, 32, 40, 10_000, 1 << 28
CODES, IO_ERROR = {"valid": 0, "unreadable": 2, "invalid": 4}, 74
POSITIVE, NONNEGATIVE, ZERO = ">", ">=", "="


class Unreadable(Exception):
    pass


class Invalid(Exception):
    def __init__(self, rule, why):
        super().__init__(f"rule {rule}: {why}")
        self.rule = rule


def needs(rule):
    def need(ok, why):
        if not ok:
            raise Invalid(rule, why)
    return need


work = [0]


def charge(n):
    work[0] += n
    if work[0] > MAX_WORK:
        raise Invalid("work", "more than a file is allowed")


# ---- Reading: a schema is a type name, [item], {"*": item} or a struct of fields ("field?" is optional).
CLAUSE = {"name": "text", "for?": [{"name": "text", "sort": "sort"}], "given?": [{"name": "text", "holds": "text"}], "goal": "text"}
DEFINITION = {
    "name": "text", "of": ["text"], "from": "text", "base?": ["text"], "step": "text", "scale?": "text",
}
SYSTEM = {"protocol": "text", "steps": "text", "weight?": "text"}
STATEMENT = {
    "functions?": {"*": {"of": "u64", "to": "sort"}}, "system?": SYSTEM, "constants?": {"*": "sort"}, "definitions?": [DEFINITION], "assumptions?": [CLAUSE],
    "conclusions": [CLAUSE],
}
POSITIVITY = {
    "use?": [{"name": "text", "lemma": "text", "with?": {"*": "text"}, "given?": {"*": "text"}}], "times?": ["text"], "sum": "text",
}
RULES = {
    "positivity": POSITIVITY,
    "absurd": POSITIVITY,
    "cases": {"on": "text", "variable": "text", "equal": "proof", "beyond": "proof"},
    "split": {"name": "text", "on": "text", "above": "proof", "equal": "proof", "below": "proof"},
    "induction": {"on": "text", "variable": "text", "hypothesis": "text", "earlier": "text", "base": "proof", "step": "proof"},
}
PROOFS = {"lemmas?": [{"clause": CLAUSE, "proof": "proof"}], "conclusions": {"*": "proof"}}
NUMBERS, FACTORS = ["number"], {"*": "number"}
LINEAR = {"state": ["text"], "parameters?": {"*": "range"}, "modes": {"*": {"*": "text"}}}
KINDS = {
    "theorem": {"statement": STATEMENT, "proof": PROOFS},
    "contraction": {"drones": "u32", "eps": "number", "rate": "number", "vector": NUMBERS},
    "growth": {"drones": "u32", "eps": "number", "vector": NUMBERS},
    "refutation": {
        "theorem": "text", "form": "text", "weights?": "text", "min": "number", "max": "number", "eps": "number", "start": NUMBERS,
        "step": "u32", "violation": {"step": "u64", "subject": "text", "at?": "u64"}, "activation?": [["u64"]],
        "delay?": [[{"drone": "u64", "sees": "u64", "age": "u64"}]],
    },
    "counterexample": {
        "system": LINEAR, "assumptions?": ["text"], "start": NUMBERS, "with?": FACTORS, "steps": [{"by": "text", "with?": FACTORS}], "claim": "text",
    },
    "ellipsoid": {
        "system": LINEAR, "nodes": {"*": {"centre": NUMBERS, "matrix": [NUMBERS]}}, "start": ["text"], "points": [NUMBERS],
        "edges": [{"from": "text", "by": "text", "to": "text", "decay": "number", "time?": "number"}], "claims": ["text"],
    },
}


def number(text):
    if not isinstance(text, str) or len(text) > MAX_NUMBER or not re.fullmatch(r"-?[0-9]+(/[0-9]+)?", text, re.A):
        raise Unreadable(f"{text!r:.60} is no number")
    charge((len(text) // 64) ** 2)
    top, _, bottom = text.partition("/")
    if bottom and int(bottom) == 0 or str(Fraction(int(top), int(bottom or 1))) != text:
        raise Unreadable(f"{text!r:.60} is not in lowest terms")
    return Fraction(int(top), int(bottom or 1))


def read(value, schema):
    """The value in that schema: structs as dictionaries without the marks of optional fields."""
    def need(ok):
        if not ok:
            raise Unreadable(f"expected {schema!s:.60}, not {value!r:.60}")
    if schema == "number":
        return number(value)
    if schema in ("text", "sort"):
        need(isinstance(value, str) and (schema == "text" or value in ("integer", "real")))
    elif schema in ("u32", "u64"):
        need(type(value) is int and 0 <= value < 2 ** int(schema[1:]))
    elif schema == "range":
        need(isinstance(value, list) and len(value) == 2)
        return [number(v) for v in value]
    elif schema == "proof" or schema is KINDS:
        rules = RULES if schema == "proof" else KINDS
        need(isinstance(value, dict) and len(value) == 1 and next(iter(value)) in rules)
        (rule, body), = value.items()
        return rule, read(body, rules[rule])
    elif isinstance(schema, list):
        need(isinstance(value, list))
        return [read(v, schema[0]) for v in value]
    else:
        need(isinstance(value, dict))
        if "*" in schema:
            need(all(map(str.isprintable, value)))
            return {key: read(v, schema["*"]) for key, v in value.items()}
        fields = {key.rstrip("?"): key for key in schema}
        need(set(value) <= set(fields))
        need(all(name in value or key.endswith("?") for name, key in fields.items()))
        return {name: read(value[name], schema[fields[name]]) for name in value}
    return value


def parse(text):
    depth = deepest = 0
    for bracket in re.sub(r'"(\\.|[^"\\])*"', "", text, flags=re.S):
        depth += (bracket in "[{") - (bracket in "]}")
        deepest = max(deepest, depth)
    if deepest > 127:
        raise Unreadable("nested too deep")

    def pairs(all_pairs):
        if len({key for key, _ in all_pairs}) < len(all_pairs):
            raise Unreadable("a key is there twice")
        return dict(all_pairs)

    def refuse(word):
        raise Unreadable(f"{word} is no integer")
    page = json.loads(text, object_pairs_hook=pairs, parse_float=refuse, parse_constant=refuse)
    text.encode()
    return read(page, {"schema": "text", "certificate": KINDS})


# ---- Polynomials: {monomial: coefficient}; a monomial is a sorted tuple of atoms, an atom ("var", name), ("fact", name)
# or ("app", name, terms), a term being a sorted tuple of the items of a polynomial.
def size(atoms):
    return sum(1 + sum(1 + size(m) for term in a[2] for m, _ in term) if a[0] == "app" else 1 for a in atoms)


def add(p, q, factor=1):
    out = dict(p)
    for m, c in q.items():
        charge(128 * (2 + size(m)))
        total = out.get(m, 0) + factor * c
        if total:
            out[m] = total
        else:
            out.pop(m, None)
    return out


def mul(p, q):
    out = {}
    for m, c in p.items():
        for n, d in q.items():
            key = tuple(sorted(m + n))
            charge(128 * (2 + size(key)))
            out[key] = out.get(key, 0) + c * d
    return {m: c for m, c in out.items() if c}


def const(c):
    return {(): Fraction(c)} if c else {}


def atom(a):
    return {(a,): Fraction(1)}


def var(name):
    return atom(("var", name))


def key(p):
    return tuple(sorted(p.items()))


def app(name, *terms):
    return atom(("app", name, tuple(key(t) for t in terms)))


def sub(p, value):
    """With `value(atom)`, where not None, in the place of each atom, inside terms too."""
    out = {}
    for m, c in p.items():
        product = const(c)
        for a in m:
            new = value(a)
            if new is None:
                new = app(a[1], *[sub(dict(t), value) for t in a[2]]) if a[0] == "app" else atom(a)
            product = mul(product, new)
        out = add(out, product)
    return out


def atoms(p):
    for m in p:
        for a in m:
            yield a
            if a[0] == "app":
                for t in a[2]:
                    yield from atoms(dict(t))


def has(p, name):
    return ("var", name) in atoms(p)


TOKEN = re.compile(r" *(\[ *[A-Za-z0-9.\-]+ *\]|[0-9][0-9/]*|[A-Za-z][A-Za-z0-9]*|>=|<=|[-+*(),><=])", re.A)


class Kernel:
    def __init__(self):
        self.constants, self.functions, self.lemmas = {}, {}, {}

    # -- expressions
    def sort(self, name, variables):
        return variables.get(name) or self.constants.get(name)

    def integer(self, p, variables):
        def whole(a):
            return self.sort(a[1], variables) == "integer" if a[0] == "var" else a[0] == "app" and self.functions[a[1]][1] == "integer"
        return all(c.denominator == 1 and all(whole(a) for a in m) for m, c in p.items())

    def poly(self, text, variables, facts=False):
        def bad(why):
            raise Invalid("expression", f"{text!r:.60}: {why}")
        tokens, at = [], 0
        while text[at:].strip(" "):
            found = TOKEN.match(text, at)
            if not found:
                bad(f"unexpected {text[at:at + 10]!r}")
            tokens.append(found[1])
            at = found.end()
        tokens.append("")

        def take(wanted):
            if tokens[0] == wanted:
                return tokens.pop(0)

        def total(depth):
            if depth > MAX_DEPTH:
                bad("too many brackets")
            out, sign = {}, -1 if take("-") else 1
            while True:
                out = add(out, product(depth), sign)
                sign = -1 if take("-") else 1 if take("+") else 0
                if not sign:
                    return out

        def product(depth):
            out = factor(depth)
            while take("*"):
                out = mul(out, factor(depth))
            return out

        def factor(depth):
            token = tokens.pop(0) if tokens[0] else bad("it ends too early")
            charge(128)
            if token == "(":
                inside = total(depth + 1)
                return inside if take(")") else bad("expected )")
            if token[0] == "[" and facts:
                return atom(("fact", token[1:-1].strip(" ")))
            if token[0].isdigit():
                try:
                    return const(number(token))
                except Unreadable as e:
                    bad(e)
            if not token[0].isalpha():
                bad(f"unexpected {token}")
            if len(token) > MAX_NAME:
                bad("too long a name")
            if not take("("):
                return var(token) if self.sort(token, variables) else bad(f"{token} is no variable")
            terms = [total(depth + 1)]
            while take(","):
                terms.append(total(depth + 1))
            if not take(")") or self.functions.get(token, (0,))[0] != len(terms):
                bad(f"{token} is no such function")
            if not all(self.integer(t, variables) for t in terms):
                bad("a term is no integer")
            return app(token, *terms)
        out = total(0)
        return out if tokens == [""] else bad(f"unexpected {tokens[0]}")

    def literal(self, text, variables):
        for sign, relation, turn in ((">=", NONNEGATIVE, 1), ("<=", NONNEGATIVE, -1), (">", POSITIVE, 1), ("<", POSITIVE, -1), ("=", ZERO, 1)):
            left, found, right = text.partition(sign)
            if found:
                return mul(const(turn), add(self.poly(left, variables), self.poly(right, variables), -1)), relation
        raise Invalid("expression", f"{text!r:.60}: expected a relation")

    # -- names and clauses: (variables, given, goal)
    def fresh(self, name, variables=()):
        if not re.fullmatch("[A-Za-z][A-Za-z0-9]*", name, re.A) or name in variables or name in self.constants or name in self.functions:
            raise Invalid("name", f"{name!r:.40} is no name, or taken")
        return name

    def learn(self, name, clause):
        if name in self.lemmas:
            raise Invalid("name", f"{name!r:.40} is there twice")
        self.lemmas[name] = clause

    def clause(self, written):
        variables, given = {}, {}
        for v in written.get("for", []):
            variables[self.fresh(v["name"], variables)] = v["sort"]
        for g in written.get("given", []):
            put(given, g["name"], self.literal(g["holds"], variables))
        return variables, given, self.literal(written["goal"], variables)

    def facts(self, given):
        return {**{n: c[2] for n, c in self.lemmas.items() if not c[0] and not c[1]}, **given}

    def define(self, d):
        need = needs("definition")
        name, of, base = self.fresh(d["name"]), {}, d.get("base", [])
        for argument in d.get("of", []):
            of[self.fresh(argument, of)] = "integer"
        need(of, "recursion without an argument")
        last, start = list(of)[-1], self.poly(d["from"], {})
        need(self.integer(start, {}), "`from` is no integer")
        given = {"from": (add(var(last), start, -1), NONNEGATIVE)}
        parameters = {v: s for v, s in of.items() if v != last}

        def value(at):
            return app(name, *map(var, parameters), at)
        factor = self.poly(d.get("scale", "1"), of)
        if "scale" in d:
            given["scale"] = factor, POSITIVE
        first = [add(value(add(start, const(j))), self.poly(b, parameters), -1) for j, b in enumerate(base)]
        self.functions[name] = len(of), "real"
        step, here = self.poly(d["step"], of), var(last)
        known = [next(iter(value(add(here, const(j)))))[0] for j in range(len(base))]
        need(all(a in known for a in atoms(step) if a[:2] == ("app", name)), "`step` reads other arguments")
        for j, p in enumerate(first):
            self.learn(f"{name}.{j}", (parameters, {}, (p, ZERO)))
        self.learn(f"{name}.step", (of, given, (add(mul(factor, value(add(here, const(len(base))))), step, -1), ZERO)))

    # -- the rules
    def prove(self, clause, proof, hypotheses={}, fixed=frozenset()):
        variables, given, goal = clause
        charge(128 * sum(1 + sum(1 + size(m) for m in p) for p, _ in [*given.values(), goal]))
        rule, body = proof
        getattr(self, rule)(variables, given, goal, body, hypotheses, fixed)

    def absurd(self, variables, given, goal, body, hypotheses, fixed):
        self.positivity(variables, given, (const(-1), NONNEGATIVE), body, hypotheses, fixed)

    def positivity(self, variables, given, goal, body, hypotheses, fixed):
        facts = self.facts(given)
        for use in body.get("use", []):
            lemma = hypotheses.get(use["lemma"]) or self.lemmas.get(use["lemma"])
            if lemma is None:
                raise Invalid("instance", f"no lemma {use['lemma']!r:.40}")
            terms, sums = use.get("with", {}), use.get("given", {})
            if not (set(terms) <= set(lemma[0]) and set(sums) <= set(lemma[1])):
                raise Invalid("instance", "no such variable or literal")
            terms = {v: self.poly(terms.get(v, "0"), variables) for v in lemma[0]}
            if any(s == "integer" and not self.integer(terms[v], variables) for v, s in lemma[0].items()):
                raise Invalid("instance", "an integer is needed")

            def at(literal):
                return sub(literal[0], lambda a: terms.get(a[1]) if a[0] == "var" else None), literal[1]
            for n, literal in lemma[1].items():
                self.sum(at(literal), [], sums.get(n, "0"), facts, variables)
            put(facts, use["name"], at(lemma[2]))
        self.sum(goal, body.get("times", []), body["sum"], facts, variables)

    def sum(self, goal, times, text, facts, variables):
        need = needs("positivity")
        left = goal[0]
        for n in times:
            need(n in facts and facts[n][1] == POSITIVE, f"{n!r:.40} is no positive fact")
            left = mul(left, facts[n][0])
        total, strict = self.poly(text, variables, True), False
        for m, c in total.items():
            names = [a[1] for a in m if a[0] == "fact"]
            need(all(n in facts for n in names), f"no such fact among {names}")
            relations = [facts[n][1] for n in names]
            if ZERO not in relations:
                need(goal[1] != ZERO, "a product without a zero fact, the goal being an equation")
                need(len(names) == len(m) and c > 0, "a product that may be below 0")
                strict |= NONNEGATIVE not in relations
        need(goal[1] != POSITIVE or strict, "no product above 0")
        right = sub(total, lambda a: facts[a[1]][0] if a[0] == "fact" else None)
        need(left == right, "the sides differ")

    def bounds(self, variables, given, on, v, fixed):
        literal, out = given.get(on), [None, None]
        if literal and literal[1] == NONNEGATIVE and variables.get(v) == "integer" and v not in fixed:
            for j, bound in enumerate((add(var(v), literal[0], -1), add(literal[0], var(v)))):
                out[j] = bound if self.integer(bound, variables) and not has(bound, v) else None
        return out

    def cases(self, variables, given, goal, body, hypotheses, fixed):
        v, on = body["variable"], body["on"]
        below, above = self.bounds(variables, given, on, v, fixed)
        bound = above if below is None else below
        if bound is None:
            raise Invalid("cases", f"{on!r:.40} does not bound {v!r:.40}")
        equal = at_value((variables, given, goal), v, bound)
        beyond = {**given, on: (add(given[on][0], const(1), -1), NONNEGATIVE)}
        self.prove(({u: s for u, s in variables.items() if u != v}, *equal), body["equal"], hypotheses, fixed)
        self.prove((variables, beyond, goal), body["beyond"], hypotheses, fixed)

    def split(self, variables, given, goal, body, hypotheses, fixed):
        p = self.poly(body["on"], variables)
        step, relation = (1, NONNEGATIVE) if self.integer(p, variables) else (0, POSITIVE)
        literals = (add(p, const(-step)), relation), (p, ZERO), (add(mul(const(-1), p), const(-step)), relation)
        for branch, literal in zip(("above", "equal", "below"), literals):
            more = dict(given)
            put(more, body["name"], literal)
            self.prove((variables, more, goal), body[branch], hypotheses, fixed)

    def induction(self, variables, given, goal, body, hypotheses, fixed):
        v, on = body["variable"], body["on"]
        bound = self.bounds(variables, given, on, v, fixed)[0]
        if bound is None or any(has(bound, u) for u in variables if u not in fixed):
            raise Invalid("induction", f"{on!r:.40} does not bound {v!r:.40} below, or not alike for all")
        earlier, clause = self.fresh(body["earlier"], variables), (variables, given, goal)
        rest = {u: s for u, s in variables.items() if u != v}
        moved, target = at_value(clause, v, add(var(v), const(1)))
        before, then = at_value(clause, v, var(earlier))
        put(before, earlier, (add(var(v), var(earlier), -1), NONNEGATIVE))
        name = body["hypothesis"]
        if name in hypotheses or name in self.lemmas:
            raise Invalid("induction", f"{name!r:.40} is there twice")
        general = {u: s for u, s in rest.items() if u not in fixed}
        inner = {**hypotheses, name: ({**general, earlier: "integer"}, before, then)}
        self.prove((rest, *at_value(clause, v, bound)), body["base"], hypotheses, fixed)
        self.prove((variables, {**moved, on: given[on]}, target), body["step"], inner, fixed | {v})


def put(facts, name, literal):
    if name in facts:
        raise Invalid("name", f"the fact {name!r:.40} is there twice")
    facts[name] = literal


def at_value(clause, v, p):
    """Literals given and goal with p in the place of v."""
    def at(literal):
        return sub(literal[0], lambda a: p if a == ("var", v) else None), literal[1]
    return {n: at(literal) for n, literal in clause[1].items()}, at(clause[2])


# ---- The system: FORMAT.md's table of clauses, read by the expression reader.
def install(kernel, s):
    protocol, steps = s["protocol"], s["steps"]

    def learn(name, given, goal, eps):
        variables = {"k": "integer", "i": "integer"} if "i" in given else {"k": "integer"}
        given = {n: kernel.literal(holds, variables) for n, holds in given.items()}
        goal, relation = kernel.literal(goal, variables)
        kernel.learn(name, (variables, given, (sub(goal, lambda a: eps if a == ("var", "eps") else None), relation)))

    def function(name, arity, sort="real"):
        kernel.functions[kernel.fresh(name)] = arity, sort
    for name in ("last", "eps"):
        kernel.constants[kernel.fresh(name)] = "integer" if name == "last" else "real"
    kernel.learn("n", ({}, {}, kernel.literal("last - 2 >= 0", {})))
    kernel.learn("last", ({}, {}, kernel.literal("last > 0", {})))
    weight = kernel.poly(s.get("weight", "eps"), {"k": "integer", "i": "integer"})
    if (protocol, steps) not in {("coverage", "full"), ("coverage", "activation"), ("coverage", "delay"), ("consensus", "full"), ("projection", "full")}:
        raise Invalid("system", "no such protocol")
    for name in ("min", "max"):
        kernel.constants[kernel.fresh(name)] = "real"
    function("x", 2)
    average = "eps*{} + (1 - 2*eps)*x(k,i) + eps*{}"
    near = average.format("x(k,i-1)", "x(k,i+1)")
    first, inner, last = "min", near, "max"
    if steps == "activation":
        function("active", 2, "integer")
        first, inner, last = (f"active(k,{i})*({p}) + (1 - active(k,{i}))*x(k,{i})" for i, p in (("0", "min"), ("i", near), ("last", "max")))
    if steps == "delay":
        function("seen", 3, "integer")
        inner = average.format("x(seen(k,i,i-1),i-1)", "x(seen(k,i,i+1),i+1)")
    if protocol == "consensus":
        first, inner, last = "x(k,0) + eps*(x(k,1) - x(k,0))", near, "x(k,last) + eps*(x(k,last-1) - x(k,last))"

    def by_class(name, f, *values):
        for c, i, p in zip(("first", "inner", "last"), ("0", "i", "last"), values):
            given = {"k": "k >= 0", "i": "i - 1 >= 0", "n": "last - 1 - i >= 0"} if c == "inner" else {"k": "k >= 0"}
            own = sub(weight, lambda a: kernel.poly(i, {"i": "integer"}) if a == ("var", "i") else None)
            learn(f"{name}.{c}", given, f"{f},{i}) = {p}", own)
    if protocol == "projection":
        for name, arity in (("own", 2), ("prec", 2), ("foll", 2), ("moves", 1)):
            function(name, arity)

        def ticks(f, i, p):
            return f"moves(k)*({p}) + (1 - moves(k))*{f}(k,{i})"
        mine = "eps*prec(k,i) + (1 - 2*eps)*own(k,i) + eps*foll(k,i)"
        by_class("own", "own(k+1", ticks("own", "0", "min"), ticks("own", "i", mine), ticks("own", "last", "max"))
        by_class("prec", "prec(k+1", "prec(k,0)", "own(k+1,i-1)", "own(k+1,last-1)")
        by_class("foll", "foll(k+1", "own(k+1,1)", "own(k+1,i+1)", "foll(k,last)")
        by_class("own.start", "own(0", "x(0,0)", "x(0,i)", "x(0,last)")
        by_class("prec.start", "prec(0", "min", "x(0,i-1)", "x(0,last-1)")
        by_class("foll.start", "foll(0", "x(0,1)", "x(0,i+1)", "max")
        first, inner, last = ticks("x", "0", first), ticks("x", "i", inner), ticks("x", "last", last)
    by_class("step", "x(k+1", first, inner, last)


def theorem(t):
    kernel, s, proof = Kernel(), t["statement"], t["proof"]
    for name, f in sorted(s.get("functions", {}).items()):
        kernel.functions[kernel.fresh(name)] = f["of"], f["to"]
    if "system" in s:
        install(kernel, s["system"])
    for name, sort in sorted(s.get("constants", {}).items()):
        kernel.constants[kernel.fresh(name)] = sort
    for d in s.get("definitions", []):
        kernel.define(d)
    for a in s.get("assumptions", []):
        kernel.learn(a["name"], kernel.clause(a))
    lemmas = [(lemma["clause"], lemma["proof"]) for lemma in proof.get("lemmas", [])]
    for written, given in [*lemmas, *((c, proof["conclusions"].get(c["name"])) for c in s["conclusions"])]:
        clause = kernel.clause(written)
        if given is None:
            raise Invalid("conclusion", "not proved")
        kernel.prove(clause, given)
        kernel.learn(written["name"], clause)
    if len(proof["conclusions"]) != len(s["conclusions"]) or not s["conclusions"]:
        raise Invalid("conclusion", "a proof of nothing that the statement says")


# ---- One N and one eps: |A| w against w, A = tridiag(eps, 1-2eps, eps).
def vector(rule, c, holds):
    n, eps, w = c["drones"], c["eps"], c["vector"]
    if not 3 <= n <= MAX_DRONES or len(w) != n - 2 or any(v <= 0 for v in w):
        raise Invalid(rule, "drones and vector do not fit, or the vector is not above 0")
    bits = max(v.numerator.bit_length() + v.denominator.bit_length() for v in [eps, c.get("rate", eps), *w])
    charge(n * 10 * (128 + (bits // 32) ** 2 // 2))
    padded = [0, *w, 0]
    for i in range(1, n - 1):
        if not holds(abs(1 - 2 * eps) * padded[i] + abs(eps) * (padded[i - 1] + padded[i + 1]), padded[i]):
            raise Invalid(rule, f"drone {i}")


def contraction(c):
    if not 0 <= c["rate"] < 1:
        vector("contraction", c, lambda aw, v: True)
        raise Invalid("contraction", "the rate is not in [0, 1)")
    vector("contraction", c, lambda aw, v: aw <= c["rate"] * v)


def growth(c):
    # eps s_i s_{i+1} and 1-2eps have one sign for s constant or alternating: of every eps.
    vector("growth", c, lambda aw, v: aw >= v)


# ---- A user's linear system.
class Linear:
    def __init__(self, written):
        self.ranges, self.state = written.get("parameters", {}), reals(written["state"])
        self.names = reals([*written["state"], *self.ranges])
        self.modes = {}
        for mode, rows in written["modes"].items():
            if not set(rows) <= set(self.state.constants):
                raise Invalid("system", f"mode {mode!r:.40}: no such variable")
            self.modes[mode] = {v: is_affine(self.names.poly(t, {}), self.state) for v, t in rows.items()}
        if not self.modes or not written["state"] or any(low > high for low, high in self.ranges.values()):
            raise Invalid("system", "no variables, no modes, or an empty range")

    def literal(self, text):
        p, relation = self.state.literal(text, {})
        return is_affine(p, self.state), relation

    def rows(self, mode):
        if mode not in self.modes:
            raise Invalid("system", f"no mode {mode!r:.40}")
        return self.modes[mode]

    def vertices(self, forms):
        out = [forms]
        for name, ends in sorted(self.ranges.items()):
            if any(has(f, name) for f in forms):
                charge(128 * len(out))
                out = [[at_names(f, {name: const(e)}) for f in fs] for fs in out for e in sorted(set(ends))]
        return out


def reals(names):
    kernel = Kernel()
    for name in names:
        kernel.constants[kernel.fresh(name)] = "real"
    return kernel


def is_affine(p, variables):
    for m in p:
        if len(set(m)) < len(m) or sum(a[1] in variables.constants for a in m) > 1:
            raise Invalid("system", "not affine")
    return p


def at_names(p, values):
    return sub(p, lambda a: values.get(a[1]) if a[0] == "var" else None)


def counterexample(c):
    need = needs("counterexample")

    def holds(literal):
        p, relation = literal
        value = at_names(p, state).get((), 0)
        return value > 0 or value == 0 and relation != POSITIVE if relation != ZERO else value == 0
    system, names, constants = Linear(c["system"]), c["system"]["state"], c.get("with", {})
    assumed, claim = [system.literal(t) for t in c.get("assumptions", [])], system.literal(c["claim"])
    need(len(c["start"]) == len(names), "a number a variable")
    state = {v: const(x) for v, x in zip(names, c["start"])}
    need(all(map(holds, assumed)), "the start does not meet what is assumed")
    for values in [constants, *(step.get("with", {}) for step in c["steps"])]:
        need(all(n in system.ranges and system.ranges[n][0] <= x <= system.ranges[n][1] for n, x in values.items()), "out of range")
    for step in c["steps"]:
        chosen = step.get("with", {})
        need(sorted([*constants, *chosen]) == sorted(system.ranges), "each parameter needs one value")
        now = {**state, **{n: const(x) for n, x in {**constants, **chosen}.items()}}
        state = {**state, **{v: at_names(p, now) for v, p in system.rows(step["by"]).items()}}
    need(not holds(claim), "the claim holds")


def definite(m, strictly):
    """Whether x'mx >= 0 (> 0) for every x but 0, by elimination."""
    m = [list(row) for row in m]
    for k, pivot_row in enumerate(m):
        pivot = pivot_row[k]
        if pivot < 0 or pivot == 0 and (strictly or any(pivot_row[k + 1:])):
            return False
        for row in m[k + 1:]:
            if row[k]:
                charge(256 * (len(m) - k))
                factor = row[k] / pivot
                row[k:] = [x - factor * y for x, y in zip(row[k:], pivot_row[k:])]
    return True


# ---- Ellipsoids (x-c)' Q^-1 (x-c) <= 1 that runs in continuous time do not leave.
def ellipsoid(c):
    need = needs("ellipsoid")
    system, state, nodes = Linear(c["system"]), c["system"]["state"], {}
    size = len(state)
    need(size <= 200, "variables")
    for name, node in c["nodes"].items():
        low = node["matrix"]
        need([len(r) for r in low] == list(range(1, size + 1)) and len(node["centre"]) == size, "shapes")
        q = [[low[max(i, j)][min(i, j)] for j in range(size)] for i in range(size)]
        need(definite(q, True), "not positive definite")
        nodes[name] = node["centre"], q
    names = [*c["start"], *(e[k] for e in c["edges"] for k in ("from", "to"))]
    need(c["start"] and c["points"] and c["claims"] and all(n in nodes for n in names), "start, points, claims, nodes")

    def bordered(m, column, corner):
        return [[*row, x] for row, x in zip(m, column)] + [[*column, corner]]
    for name in c["start"]:
        centre, q = nodes[name]
        for point in c["points"]:
            need(len(point) == size and definite(bordered(q, [a - b for a, b in zip(point, centre)], Fraction(1)), False), "a point of the start")

    def parts(p):
        return p.get((), Fraction(0)), [p.get((("var", n),), Fraction(0)) for n in state]

    def dot(a, b):
        charge(256 * sum(1 for x in a if x))
        return sum((x * y for x, y in zip(a, b) if x), Fraction(0))
    for e in c["edges"]:
        need(e["time"] > 0 if "time" in e else e["from"] == e["to"], "time")
        (c0, q0), (c1, q1) = nodes[e["from"]], nodes[e["to"]]
        rate, rows = 1 / e["time"] if "time" in e else Fraction(0), system.rows(e["by"])
        for forms in system.vertices([rows.get(n, {}) for n in state]):
            b, a = zip(*map(parts, forms))
            for centre, q in [(c0, q0), (c1, q1)][:2 if "time" in e else 1]:
                aq = [[dot(a[i], q[j]) for j in range(size)] for i in range(size)]
                left = [[rate * (q1[i][j] - q0[i][j]) - aq[i][j] - aq[j][i] - e["decay"] * q[i][j] for j in range(size)] for i in range(size)]
                column = [rate * (c1[i] - c0[i]) - b[i] - dot(a[i], centre) for i in range(size)]
                need(definite(bordered(left, column, e["decay"]), False), "a run may leave")
    for text in c["claims"]:
        p, relation = system.literal(text)
        need(relation != ZERO, "an equation")
        constant, row = parts(p)

        def reached(x):
            return x > 0 or x == 0 and relation != POSITIVE
        at = {}
        for name, (centre, q) in nodes.items():
            g = constant + dot(row, centre)
            at[name] = g, g * g - dot(row, [dot(line, row) for line in q])
            need(all(map(reached, at[name])), "a claim at a node")
        for e in c["edges"]:
            if "time" in e:
                (g0, f0), (g1, f1) = at[e["from"]], at[e["to"]]
                # f0 + b s + a s^2 for s in [0, 1], at its lowest.
                a = (g1 - g0) ** 2
                b = f1 - f0 - a
                need(not -2 * a < b < 0 or reached(f0 - b * b / (4 * a)), "a claim on the way")


# ---- One run, and the conclusions of the theorems in their finite forms: None, or what is violated and where.
def signs(values):
    return [i for i, v in enumerate(values) if v < 0]


def first_increase(errors):
    depths = [min(j, len(errors) - 1 - j) for j, e in enumerate(errors) if e]
    return min(depths) if depths else None


def conclusion(theorem, form, eps, e, c, x):
    """On placements k, k+1, ...: e the errors times N-1, c the sums, x the positions."""
    n, off, first = len(x[0]), any(e[0]), e[0]
    if theorem == "7.2":
        bad = signs([-1 if not a < b else 0 for a, b in zip(x[0], x[0][1:])])
        return (0, "pair", bad[0]) if bad else None
    if theorem == "7.3":
        return (0, "drone", signs(first)[0]) if signs(first) else None
    if theorem == "7.4i":
        return (0, "sum", None) if sum(first) < 0 else None
    if theorem == "7.4ii":
        return (0, "sum", None) if off != (sum(first) != 0) else None
    if theorem == "7.5i":
        return (1, "sum", None) if c[1] < c[0] else None
    if theorem == "7.5ii":
        return (1, "sum", None) if not off and c[1] != c[0] else None
    if theorem == "7.6i":
        bad = [h for h in range(1, len(x)) if (c[h] != c[0] if form == "paper" else any(e[h]))]
        return (bad[0], "sum", None) if not off and bad else None
    if theorem == "7.6ii":
        return (0, "sum", None) if off and all(d == c[0] for d in c) else None
    if theorem == "7.7" and form == "paper":
        j = next((j for j, v in enumerate(first) if v), 0)
        applies = off and j >= 3 and first[j] > 0 and c[1] == c[0]
        return (len(x) - 1, "sum", None) if applies and all(b <= a for a, b in zip(c[1:], c[2:])) else None
    if theorem == "7.7":
        h = first_increase(first)
        right = off and all(d == c[0] if i < h else d > c[0] for i, d in enumerate(c[:h + 1]))
        return (h, "sum", None) if off and not right else None
    energy = [sum(v * v for v in row) for row in e[:2]]
    if off and energy[1] >= energy[0]:
        return 1, "energy", None
    if off and form == "sharp" and 0 < eps <= Fraction(1, 2):
        w, square = [i * (n - 1 - i) for i in range(n)], (n - 1) ** 2
        most = max(abs(first[j]) / Fraction(w[j]) for j in range(1, n - 1))
        bad = [i for i in range(1, n - 1) if square * abs(e[1][i]) > (square - 8 * eps) * most * w[i]]
        return (1, "drone", bad[0]) if bad else None
    return None


# The weights and starts of the theorems: paper, sharp.
WEIGHTS = {
    "7.2": ("third", "halfone"), "7.3": ("below", "half"), "7.4i": ("below", "half"), "7.4ii": ("below", "half"), "7.5i": ("below", "half"),
    "7.5ii": ("unit", "any"), "7.6i": ("third", "any"), "7.6ii": ("third", "positive"), "7.7": ("unit", "positive"), "7.8": ("unit", "critical"),
}
STARTS = {
    "7.2": ("ordered", "ordered"), "7.5ii": ("segment", "any"), "7.6i": ("segment", "any"), "7.7": ("bounded", "bounded"), "7.8": ("segment", "any"),
}


def refutation(c):
    need = needs("refutation")
    need(c["theorem"] in WEIGHTS and c["form"] in ("paper", "sharp"), "no such theorem or form")
    sharp = c["form"] == "sharp"
    ranges, starts = WEIGHTS[c["theorem"]][sharp], STARTS.get(c["theorem"], ("segment", "bounded"))[sharp]
    x, theorem, form, eps, low, high = [c["start"]], c["theorem"], c["form"], c["eps"], c["min"], c["max"]
    n, active, delay = len(x[0]), c.get("activation"), c.get("delay")
    need((active is None and delay is None) or theorem not in ("7.6ii", "7.7", "7.8"), "other steps decide nothing about it")
    need(3 <= n <= MAX_DRONES and c["step"] <= MAX_DRONES and low < high, "sizes")
    inner = max(n - 2, 1)
    span = {"7.5i": 1, "7.5ii": 1, "7.8": 1, "7.6i": 0, "7.6ii": 0, "7.7": 0}.get(theorem, 0)
    if theorem in ("7.6i", "7.6ii"):
        span = inner if form == "paper" else -(-inner // 2)
    if theorem == "7.7":
        span = inner + 1 if form == "paper" else (n - 1) // 2
    steps, long = c["step"] + span, sum(v.numerator.bit_length() + v.denominator.bit_length() for v in [eps, low, high, *x[0]])
    charge((n if ranges == "critical" else 1) * (128 + ((n if ranges == "critical" else 0) * long // 64) ** 2 // 2))
    charge(steps * n * (128 + (steps * long // 512) ** 2 // 2))
    need("weights" not in c or c["weights"] == "any", "`weights`: expected `any`")
    if "weights" not in c:
        half, one = Fraction(1, 2), Fraction(1)
        if ranges == "critical":
            minor, before, ok = one, Fraction(0), eps > 0
            for _ in range(n - 2):
                minor, before = 2 * (1 - eps) * minor - eps * eps * before, minor
                ok = ok and minor > 0
        else:
            ok = {
                "any": True, "unit": 0 <= eps <= 1, "third": 0 <= eps < Fraction(1, 3), "below": 0 <= eps < half, "half": 0 <= eps <= half,
                "halfone": 0 <= eps <= (one if n == 3 else half), "positive": 0 < eps <= half,
            }[ranges]
        need(ok, "the weight is not in the range")

    def error(row):
        return [(n - 1) * low + i * (high - low) - (n - 1) * v for i, v in enumerate(row)]
    ordered, errors = all(a < b for a, b in zip(x[0], x[0][1:])), error(x[0])
    need(x[0][0] == low and x[0][-1] == high, "the ends are not in place")
    need(ordered or starts not in ("ordered", "segment"), "the start is not ordered")
    room = (n - 1) * low + high - low
    need(starts != "segment" or all((n - 1) * v < room for v in x[0][1:-1]), "beyond the first subsegment")
    need(starts != "bounded" or not signs(errors), "beyond a target")
    lists = [s for s in (active, delay) if s is not None]
    need(len(lists) < 2 and all(len(s) == steps for s in lists), "one schedule at most, a list a step")
    for t in range(steps):
        now, seen = x[t], {}
        if active is not None:
            need(active[t] == sorted(set(active[t])) and all(i < n for i in active[t]), "ascending drones are expected")
        if delay is not None:
            keys = [(d["drone"], d["sees"]) for d in delay[t]]
            need(keys == sorted(set(keys)) and all(max(k) < n for k in keys), "ascending pairs are expected")
            need(all(1 <= d["age"] <= t for d in delay[t]), "ages from 1 to t are expected")
            seen = {k: x[t - d["age"]][k[1]] for k, d in zip(keys, delay[t])}
        new = [low, *now[1:-1], high]
        for i in range(1, n - 1):
            a, b = (seen.get((i, j), now[j]) for j in (i - 1, i + 1))
            new[i] = eps * a + (1 - 2 * eps) * now[i] + eps * b
        x.append(new if active is None else [new[i] if i in active[t] else now[i] for i in range(n)])
    tail, v = x[c["step"]:], c["violation"]
    found = conclusion(theorem, form, eps, [error(row) for row in tail], [sum(row) for row in tail], tail)
    need(found == (v["step"], v["subject"], v.get("at")), f"the conclusion answers {found}")


def check(data):
    """The verdict, the rule that fails where one does, and why."""
    work[0] = 0
    try:
        if len(data) > MAX_BYTES:
            raise Unreadable("too large")
        page = parse(data.decode())
        if page["schema"] != SCHEMA:
            raise Unreadable("another schema")
        kind, body = page["certificate"]
        globals()[kind](body)
    except (Unreadable, ValueError, RecursionError) as e:
        return "unreadable", "-", str(e)
    except Invalid as e:
        return "invalid", e.rule, str(e)
    return ("valid",)


def main(paths):
    sys.setrecursionlimit(20_000)
    sys.set_int_max_str_digits(0)
    if not paths or any(path.startswith("-") for path in paths):
        print("usage: check.py FILE...", file=sys.stderr)
        return 2
    worst = 0
    for path in paths:
        try:
            with open(path, "rb") as file:
                verdict = check(file.read(MAX_BYTES + 1))
        except OSError as e:
            print(f"error: cannot read `{path}`: {e.strerror}", file=sys.stderr)
            worst = IO_ERROR
            continue
        worst = max(worst, CODES[verdict[0]])
        print(f"{path}: {': '.join(verdict)}")
    return worst


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
