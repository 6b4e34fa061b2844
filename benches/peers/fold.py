"""The hash on which all peers agree: positions as elements of the field of 2^61 - 1 elements,
folded. It does not depend on how a fraction is reduced."""

PRIME = 2**61 - 1


def folded(fractions):
    h = 0
    for numerator, denominator in fractions:
        residue = numerator * pow(denominator % PRIME, -1, PRIME) % PRIME
        h = (h * 1000003 + residue) % PRIME
    return f"{h:015x}"
