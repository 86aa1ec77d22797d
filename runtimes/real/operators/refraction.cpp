//===-- runtimes/real/operators/refraction.cpp - light at the boundary of two media -----------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Everything hangs on k = 1 - eta^2 (1 - c^2), the square of the cosine inside, with c = I.N. Near
// the critical angle k is close to 0, its root and so the reflected share change without bound, and
// its sign decides between refraction and total reflection; there a rounding error of one part in
// 2^24 in c is an error of half a percent in the share. So k is computed as 1 - eta^2 + (eta c)^2
// with twice the digits of a real: each product and sum carries its rounding error along, which
// fusedMultiplyAdd and Knuth's two-sum give exactly.
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/domain.h>
#include <anysl/runtime.h>

using namespace anysl;

namespace {

/// A number without derivatives.
using Value = decltype(valueOf(anysl_float()));

/// high + low += x, with what the sum rounds away going into low.
void accumulate(Value &high, Value &low, Value x) {
  Value sum = high + x;
  Value part = sum - high;
  low = low + ((high - (sum - part)) + (x - part));
  high = sum;
}

/// high + low += a b.
void accumulateProduct(Value &high, Value &low, Value a, Value b) {
  Value product = a * b;
  accumulate(high, low, product);
  low = low + fusedMultiplyAdd(a, b, -product);
}

/// The values of c = I.N, and of k.
void boundaryValues(const anysl_vector &I, const anysl_vector &N, Value eta, Value &c, Value &k) {
  Value cLow(0);
  c = Value(0);
  accumulateProduct(c, cLow, valueOf(I.x), valueOf(N.x));
  accumulateProduct(c, cLow, valueOf(I.y), valueOf(N.y));
  accumulateProduct(c, cLow, valueOf(I.z), valueOf(N.z));
  // Where the products cancel, the carried error is no longer small beside their sum.
  Value sum = c + cLow;
  cLow = cLow - (sum - c);
  c = sum;

  Value t = eta * c, tLow = fusedMultiplyAdd(eta, c, -t) + eta * cLow;
  Value kLow(0);
  k = Value(1);
  accumulateProduct(k, kLow, -eta, eta);
  accumulateProduct(k, kLow, t, t);
  k = k + (kLow + 2 * t * tLow);
}

/// c = I.N, and k. Negative k means that no light passes. An infinite eta gives NaN, and means the
/// same.
void boundary(const anysl_vector &I, const anysl_vector &N, const anysl_float &eta, anysl_float &c,
              anysl_float &k) {
  Value cValue, kValue;
  boundaryValues(I, N, valueOf(eta), cValue, kValue);
  // Derivatives are as exact by the plain formula.
  c = withValue(cValue, dot(I, N));
  anysl_float t = eta * c;
  k = withValue(kValue, t * t - eta * eta);
}

/// eta I - (eta c + sqrt(k)) N, or the zero vector.
void refracted(anysl_vector *result, const anysl_vector &I, const anysl_vector &N, anysl_float eta,
               anysl_float c, anysl_float k) {
  auto passes = k >= 0;
  anysl_float alongN = eta * c + squareRoot(k), zero(0);
  auto component = [=](const anysl_float &i, const anysl_float &n) {
    return select(passes, eta * i - alongN * n, zero);
  };
  *result = each(component, I, N);
}

} // namespace

void anysl_refract(anysl_vector *result, const anysl_vector *I, const anysl_vector *N,
                   const anysl_float *eta) {
  anysl_float c, k;
  boundary(*I, *N, *eta, c, k);
  refracted(result, *I, *N, *eta, c, k);
}

/// Fresnel's equations. A quotient of zeros is 0, so eta = 1 reflects nothing even at grazing
/// incidence.
void anysl_fresnel(const anysl_vector *I, const anysl_vector *N, const anysl_float *eta,
                   anysl_float *Kr, anysl_float *Kt, anysl_vector *R, anysl_vector *T) {
  // The sign of eta has no meaning. The least eta keeps a medium of none (eta = 0) reflecting all
  // at grazing.
  anysl_float least(1e-30), n = select(absOf(*eta) > least, absOf(*eta), least);
  n = select(isNaN(*eta), *eta, n);
  anysl_float c, k;
  boundary(*I, *N, n, c, k);
  anysl_float outside = absOf(c), inside = squareRoot(k);
  anysl_float perpendicular = divide(n * outside - inside, n * outside + inside);
  anysl_float parallel = divide(outside - n * inside, outside + n * inside);
  anysl_float share = anysl_float(0.5) * (perpendicular * perpendicular + parallel * parallel);
  share = select(k >= 0, share, anysl_float(1));
  anysl_vector reflected = *I - *N * (2 * c), through;
  refracted(&through, *I, *N, n, c, k);
  *Kr = share;
  *Kt = 1 - share;
  *R = reflected;
  *T = through;
}
