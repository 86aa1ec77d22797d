"""The numbers of test/tools/anysl-shade/random.sl are in [0, 1), spread evenly, and differ from point to point."""
import sys

mean, second = [], []
with open(sys.argv[1]) as file:
    for line in file:
        i, j, _, a, b, _, _, taken = line.split()
        assert int(taken) == int(i) % 3 + 1, line
        assert 0 <= float(a) < 1 and 0 <= float(b) < 1, line
        mean.append(float(a))
        second.append(float(b))
assert len(second) == 6000
assert len(set(second)) > 5990
average = sum(second) / len(second)
assert abs(average - 0.5) < 4 * (1 / 12 / 6000) ** 0.5, average
