#!/usr/bin/env python3
#===-- tools/verify-math/generate-coefficients.py - polynomials of the math tiers -----------------===#
#
# Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
#===-----------------------------------------------------------------------------------------------===#
"""Writes runtimes/math/Coefficients.h: minimax polynomials for each function and tier.

Each is found by Remez's exchange algorithm in 60-digit arithmetic (mpmath), then rounded to the
format it is evaluated in one coefficient at a time, the lowest degree first, fitting the others again
after each (Brisebarre and Chevillard, "Efficient polynomial L-infinity approximations", 2007, do the
same by lattice reduction). The error left after that stands beside each polynomial.

usage: generate-coefficients.py [--only NAME] > runtimes/math/Coefficients.h
"""

import sys
from mpmath import mp, mpf, ldexp, cos, pi, sin, tan, log, exp, atan, asin, sqrt, lu_solve, matrix, floor

mp.dps = 70


def roundTo(value, bits):
    """The nearest number with that many significant bits."""
    if value == 0:
        return value
    m, e = mp.frexp(value)
    return mp.ldexp(mp.nint(mp.ldexp(m, bits)), e - bits)


def remez(f, weight, a, b, terms):
    """Coefficients that minimise max |weight·(f − Σ c_i x^i)| on [a, b], and that maximum."""
    count = 24 * (terms + 1)
    grid = [(a + b) / 2 - (b - a) / 2 * cos(pi * i / count) for i in range(count + 1)]
    # A weight may vanish inside, where the first coefficients are already fixed: no error there.
    table = [(x, f(x), abs(weight(x))) for x in grid if x == a or x == b or abs(x) > (b - a) / 1000]
    limit = TINY * max(row[2] for row in table)
    table = [row for row in table if row[2] > limit]
    start = [min(len(table) - 1, round(i * (len(table) - 1) / terms)) for i in range(terms + 1)] if terms else []
    points = [table[i] for i in start]
    best = None
    for _ in range(40):
        c = []
        if terms:
            A, rhs = matrix(terms + 1, terms + 1), matrix(terms + 1, 1)
            for i, (x, y, w) in enumerate(points):
                for j in range(terms):
                    A[i, j] = x ** j
                A[i, terms] = (-1) ** i / w
                rhs[i] = y
            c = list(lu_solve(A, rhs))
        level = abs(c.pop()) if c else 0
        error = [w * (y - mp.polyval(c[::-1], x)) for x, y, w in table]
        top = max(abs(e) for e in error)
        if best is None or top < best[1]:
            best = (c, top)
        if not terms or top <= level * mpf('1.01'):
            break
        # One extremum in each run of equal signs. Of too many, drop the weakest, with a neighbour where
        # it stands between two of equal sign.
        runs = []
        for row, e in zip(table, error):
            if runs and (runs[-1][1] > 0) == (e > 0):
                if abs(e) > abs(runs[-1][1]):
                    runs[-1] = (row, e)
            else:
                runs.append((row, e))
        while len(runs) > terms + 1:
            i = min(range(len(runs)), key=lambda i: abs(runs[i][1]))
            if i in (0, len(runs) - 1) or len(runs) == terms + 2:
                runs.pop(0 if abs(runs[0][1]) < abs(runs[-1][1]) else -1)
            else:
                runs[i - 1:i + 2] = [max(runs[i - 1], runs[i + 1], key=lambda run: abs(run[1]))]
        if len(runs) < terms + 1:
            break
        points = [row for row, _ in runs]
    return best


def polynomial(f, weight, a, b, terms, bits, first=()):
    """`terms` coefficients, each of `bits` bits, `first` being given; f, weight of x. Returns them and the error."""
    fixed = list(first)
    for k in range(len(fixed), terms + 1):
        rest = lambda x: (f(x) - mp.polyval(fixed[::-1], x)) / x ** k
        c, error = remez(rest, lambda x: weight(x) * x ** k, a, b, terms - k)
        if c:
            fixed.append(roundTo(c[0], bits))
    return fixed, error


TINY = mpf(10) ** -12
CBRT_H = mpf(0.1035)  # |1 - m r^3| for the r that cbrtInFloat starts from
SERIES = mpf(10) ** -24


def evenPart(f):
    """(f(r)/r − 1)/z with z = r², for an odd f with f'(0) = 1."""
    return lambda z: (f(sqrt(z)) / sqrt(z) - 1) / z


def relativeOdd(f):
    return lambda z: z / (f(sqrt(z)) / sqrt(z))


def table():
    """name, format, number of coefficients, function, weight, interval, meaning[, coefficients that are given]"""
    z2, z4 = (pi / 2) ** 2, (pi / 4) ** 2
    sinP, sinW = evenPart(sin), relativeOdd(sin)
    cosP = lambda z: (cos(sqrt(z)) - 1 + z / 2) / z ** 2
    cosW = lambda z: z ** 2 / cos(sqrt(z))
    tanP, tanW = evenPart(tan), relativeOdd(tan)
    half = mpf(1) / 2
    near = lambda f: abs(f) < SERIES
    exp2P = lambda f: log(2) if near(f) else (mpf(2) ** f - 1) / f
    exp2W = lambda f: f / mpf(2) ** f
    expP1 = lambda r: mpf(1) if near(r) else mp.expm1(r) / r
    expm1W1 = lambda r: 1 if near(r) else r / mp.expm1(r)
    # relative error of 2^f − 1, for the hyperbolic functions near 0
    expm1W = lambda f: 1 / log(2) if near(f) else f / (mpf(2) ** f - 1)
    l = log(2) / 2
    expP = lambda r: 1 / mpf(2) + r / 6 if near(r) else (exp(r) - 1 - r) / r ** 2
    expW = lambda r: r ** 2 / exp(r)
    # log(1+f) = f − f²/2 + f³·P
    lo, hi = sqrt(half) - 1, sqrt(mpf(2)) - 1
    def logP(f):
        if abs(f) < mpf(10) ** -16:
            return mpf(1) / 3 - f / 4
        return (log(1 + f) - f + f * f / 2) / f ** 3
    logW = lambda f: TINY if near(f) else f ** 3 / log(1 + f)
    # log(1+f) = 2 atanh(s), s = f/(2+f)
    smax = (hi / (2 + hi)) ** 2
    atanhP = lambda z: (mp.atanh(sqrt(z)) / sqrt(z) - 1) / z
    atanhW = lambda z: z / (mp.atanh(sqrt(z)) / sqrt(z))
    atanhTail = lambda z: (mp.atanh(sqrt(z)) / sqrt(z) - 1 - z / 3 - z ** 2 / 5) / z ** 3
    atanhTailW = lambda z: z ** 3
    quarter = mpf(1) / 4
    asinP, asinW = evenPart(asin), relativeOdd(asin)
    at8 = tan(pi / 8) ** 2
    atanP, atanW = evenPart(atan), relativeOdd(atan)
    sinhP, sinhW = evenPart(mp.sinh), relativeOdd(mp.sinh)
    tanhP, tanhW = evenPart(mp.tanh), relativeOdd(mp.tanh)
    icbrt, icbrtW = lambda m: m ** (-mpf(1) / 3), lambda m: m ** (mpf(1) / 3)
    Z = mpf(10) ** -14
    D, F = 'double', 'float'
    out = []
    add = lambda *row: out.append(row)
    for q, n in (('U10', 4), ('Cr', 8)):
        add(f'SinPi{q}', D, n, sinP, sinW, Z, z2, 'sin r = r + r z P(z), |r| <= pi/2')
    add('SinU10', D, 3, sinP, sinW, Z, z4, 'the same, |r| <= pi/4')
    add('SinCr', D, 6, sinP, sinW, Z, z4, 'the same, |r| <= pi/4')
    add('CosU10', D, 3, cosP, cosW, Z, z4, 'cos r = 1 - z/2 + z^2 P(z), |r| <= pi/4')
    add('CosCr', D, 6, cosP, cosW, Z, z4, 'the same')
    add('Exp2U10', D, 6, exp2P, exp2W, -half, half, '2^f = 1 + f P(f), |f| <= 1/2')
    for q, n in (('', 7), ('U35', 6), ('Cr', 10)):
        add(f'Exp2Pow{q}', D, n, lambda f: mpf(2) ** f, lambda f: mpf(2) ** -f, -half, half, '2^f = P(f), the first coefficient 1', [mpf(1)])
    add('Expm1U10', D, 7, exp2P, expm1W, -half, half, 'the same, error relative to 2^f - 1')
    add('ExpCr', D, 11, expP1, expm1W1, -l, l, 'e^r = 1 + r P(r), |r| <= log(2)/2, error relative to e^r - 1')
    add('Exp64', D, 11, expP, expW, -l, l, 'e^r = 1 + r + r^2 P(r), |r| <= log(2)/2')
    add('Sinh64', D, 6, sinhP, sinhW, Z, mpf(0.375) ** 2, 'sinh r = r + r z P(z), |r| <= 3/8')
    add('LogU10', D, 9, logP, logW, lo, hi, 'log(1+f) = f - f^2/2 + f^3 P(f), 1+f in [sqrt 1/2, sqrt 2]')
    log2P = lambda z: 2 / log(2) * mp.atanh(sqrt(z)) / sqrt(z)
    for q, n in (('', 5), ('U35', 4), ('Cr', 7)):
        add(f'Log2Pow{q}', D, n, log2P, lambda z: 1 / log2P(z), Z, smax, 'log2 (1+f) = s P(z), s = f/(2+f), the same range')
    add('AtanhCr', D, 7, atanhP, atanhW, Z, smax, 'atanh s = s + s z P(z), the same range')
    add('AtanhTail64', D, 7, atanhTail, atanhTailW, mpf(10) ** -8, smax, 'atanh s = s (1 + z/3 + z^2/5 + z^3 P(z))')
    add('AsinCr', D, 12, asinP, asinW, Z, quarter, 'asin r = r + r z P(z), |r| <= 1/2')
    for q, n in (('U10', 5), ('Cr', 11)):
        add(f'Atan{q}', D, n, atanP, atanW, Z, at8, 'atan t = t + t z P(z), |t| <= tan(pi/8)')
    for q, n in (('U10', 5), ('Cr', 6)):
        add(f'InverseCbrt{q}', D, n, icbrt, icbrtW, mpf(1), mpf(2), 'm^(-1/3), m in [1, 2], to start iterating from')
    # In float, with fused multiply-adds: u35 and fast.
    exp1P = lambda r: mpf(1) if near(r) else mp.expm1(r) / r
    log1P = lambda base: lambda f: (1 - f / 2 if near(f) else log(1 + f) / f) / log(base)
    log1W = lambda base: lambda f: log(base) * (mpf(1) if near(f) else f / log(1 + f))
    add('CbrtStep', F, 3, lambda h: (1 - h) ** (-mpf(1) / 3), lambda h: (1 - h) ** (mpf(1) / 3), -CBRT_H, CBRT_H, '(1-h)^(-1/3) = P(h), |h| <= 0.1035, the first coefficient 1', [mpf(1)])
    for q, sinN, tanN, expN, exp2N, expm1N, logN, asinN, atanN in (
            ('U35', 4, 6, 4, 6, 6, 9, 5, 8), ('Fast', 2, 3, 2, 3, 4, 5, 2, 4)):
        add(f'SinPi{q}', F, sinN, sinP, sinW, Z, z2 * mpf(1.01), 'sin r = r + r z P(z), |r| <= pi/2')
        add(f'Tan{q}', F, tanN, tanP, tanW, Z, z4 * mpf(1.01), 'tan r = r + r z P(z), |r| <= pi/4')
        add(f'Exp{q}', F, expN, expP, expW, -l, l, 'e^r = 1 + r + r^2 P(r), |r| <= log(2)/2')
        add(f'Exp2{q}', F, exp2N, exp2P, exp2W, -half, half, '2^f = 1 + f P(f), |f| <= 1/2')
        add(f'Expm1{q}', F, expm1N, exp1P, expm1W1, -l, l, 'e^r = 1 + r P(r), error relative to e^r - 1')
        add(f'Expm1Twice{q}', F, expm1N, lambda r: 2 * exp1P(2 * r), lambda r: expm1W1(2 * r) / 2, -l / 2, l / 2, 'e^2r = 1 + r P(r), error relative to e^2r - 1')
        for base, name in ((mp.e, 'Log'), (2, 'Log2'), (10, 'Log10')):
            add(f'{name}{q}', F, logN, log1P(base), log1W(base), lo, hi, f'{name.lower()}(1+f) = f P(f), 1+f in [sqrt 1/2, sqrt 2]')
        add(f'Asin{q}', F, asinN, asinP, asinW, Z, quarter, 'asin r = r + r z P(z), |r| <= 1/2')
        add(f'Atan{q}', F, atanN, atanP, atanW, Z, mpf(1), 'atan t = t + t z P(z), |t| <= 1')
    # In float, without: u10.
    add('ExpFloat', F, 5, expP, expW, -l, l, 'e^r = 1 + r + r^2 P(r), |r| <= log(2)/2')
    exp2P2 = lambda f: expP(f * log(2)) * log(2) ** 2
    add('Exp2Float', F, 5, exp2P2, lambda f: f * f / mpf(2) ** f, -half, half, '2^f = 1 + f log 2 + f^2 P(f), |f| <= 1/2')
    add('AsinFloat', F, 5, asinP, asinW, Z, quarter, 'asin r = r + r z P(z), |r| <= 1/2')
    add('AtanFloat', F, 6, atanP, atanW, Z, mpf(0.65) ** 2, 'atan t = t + t z P(z), |t| <= 0.65')
    add('LogFloat', F, 8, logP, logW, lo, hi, 'log(1+f) = f - f^2/2 + f^3 P(f)')
    return out


def main():
    only = sys.argv[2] if len(sys.argv) > 2 else None
    print('''//===-- runtimes/math/Coefficients.h - minimax polynomials of the math tiers ------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Written by tools/verify-math/generate-coefficients.py; change that and run it again.
// Coefficients stand lowest degree first; the error is that of the approximation, relative to the
// function's value, without the roundings of its evaluation.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_COEFFICIENTS_H
#define ANYSL_RUNTIMES_MATH_COEFFICIENTS_H

#include "runtimes/math/Core.h"

namespace anysl::tier {
''')
    for name, kind, terms, f, w, a, b, meaning, *first in table():
        if only and only != name:
            continue
        c, error = polynomial(f, w, a, b, terms, 53 if kind == 'double' else 24, *first)
        print(f'/// {meaning}. Error 2^{float(log(error, 2)):.1f}.')
        print(f'inline constexpr {kind} {name}[{terms}] = {{')
        suffix = '' if kind == 'double' else 'f'
        for i in range(0, terms, 3):
            print('    ' + ', '.join(float(x).hex() + suffix for x in c[i:i + 3]) + ',')
        print('};')
        sys.stdout.flush()
    print('''
/// 1/pi without the bits that give multiples of 2 when multiplied by a float of exponent 16 j to
/// 16 j + 15, in three parts; products of a float with the first two are exact.''')
    for part in range(3):
        print(f'inline constexpr double InversePi{part}[8] = {{')
        rows = []
        for j in range(8):
            unit = mpf(2) ** (24 - 16 * j)
            t = mp.fmod(1 / pi, unit)
            for p in range(part):
                t -= mp.floor(t / unit * mpf(2) ** (29 * (p + 1))) * unit / mpf(2) ** (29 * (p + 1))
            if part < 2:
                t = mp.floor(t / unit * mpf(2) ** (29 * (part + 1))) * unit / mpf(2) ** (29 * (part + 1))
            rows.append(float(t).hex())
        for i in range(0, 8, 3):
            print('    ' + ', '.join(rows[i:i + 3]) + ',')
        print('};')
    print('''
/// 1/pi for floats of exponent 2 j + 1 and 2 j + 2, without multiples of what gives multiples of 2, in two
/// parts; products of a float with the first are exact.''')
    rows = []
    for j in range(64):
        unit = mpf(2) ** (23 - 2 * j)
        t = 1 / pi - unit * mp.nint(1 / pi / unit)
        high = mp.nint(t / unit * 2 ** 29) * unit / 2 ** 29
        rows.append((float(high).hex(), float(t - high).hex()))
    for part, name in enumerate(('High', 'Low')):
        print(f'inline constexpr double InversePi{name}[64] = {{')
        for i in range(0, 64, 4):
            print('    ' + ', '.join(row[part] for row in rows[i:i + 4]) + ',')
        print('};')
    print('''
/// 1/pi for floats of exponent j + 1, without multiples of what gives multiples of 2.
inline constexpr double InversePiRounded[128] = {''')
    rows = []
    for j in range(128):
        unit = mpf(2) ** (23 - j)
        rows.append(float(1 / pi - unit * mp.nint(1 / pi / unit)).hex())
    for i in range(0, 128, 4):
        print('    ' + ', '.join(rows[i:i + 4]) + ',')
    print('};')
    print('''
/// atan t = t + t z P(z), |t| <= 1/32: its series, whose next term is below 2^-73.
inline constexpr double AtanSeries[6] = {''')
    print('    ' + ', '.join(float(mpf((-1) ** (k + 1)) / (2 * k + 3)).hex() for k in range(6)) + ',')
    print('''};
/// The arc tangents of 0/16 to 16/16, each as the sum of two doubles.''')
    rows = [(float(atan(mpf(k) / 16)), atan(mpf(k) / 16)) for k in range(17)]
    for part, name in enumerate(('High', 'Low')):
        print(f'inline constexpr double AtanSixteenths{name}[17] = {{')
        for i in range(0, 17, 4):
            print('    ' + ', '.join((float(exact - high) if part else high).hex() for high, exact in rows[i:i + 4]) + ',')
        print('};')
    print('''
/// 2/pi from 64 zero bits before its point on, 32 bits a word.
inline constexpr UInt32 TwoOverPiBits[42] = {''')
    mp.dps = 420
    bits = int(mp.floor(ldexp(2 / +pi, 40 * 32)))
    mp.dps = 70
    words = [0, 0] + [(bits >> (32 * (39 - i))) & 0xffffffff for i in range(40)]
    for i in range(0, 42, 7):
        print('    ' + ', '.join(f'0x{w:08x}' for w in words[i:i + 7]) + ',')
    print('};')
    print('''
} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_COEFFICIENTS_H''')


if __name__ == '__main__':
    main()
