//===-- runtimes/math/Coefficients.h - minimax polynomials of the math tiers ------------------===//
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

/// sin r = r + r z P(z), |r| <= pi/2. Error 2^-27.3.
inline constexpr double SinPiU10[4] = {
    -0x1.55554bca70812p-3,
    0x1.110ed3b2a9144p-7,
    -0x1.9f70031630a0cp-13,
    0x1.5dbdf9a262598p-19,
};
/// sin r = r + r z P(z), |r| <= pi/2. Error 2^-61.5.
inline constexpr double SinPiCr[8] = {
    -0x1.5555555555555p-3,  0x1.11111111110c8p-7,  -0x1.a01a01a014d6ep-13, 0x1.71de3a52a0a15p-19,
    -0x1.ae6454d468a3fp-26, 0x1.6123cd034ad99p-33, -0x1.ae4383340a1fcp-41, 0x1.883283974fb34p-49,
};
/// the same, |r| <= pi/4. Error 2^-28.0.
inline constexpr double SinU10[3] = {
    -0x1.55554526b46b7p-3,
    0x1.11073ab95de77p-7,
    -0x1.9943c7c600326p-13,
};
/// the same, |r| <= pi/4. Error 2^-57.9.
inline constexpr double SinCr[6] = {
    -0x1.5555555555548p-3, 0x1.111111110f72fp-7,   -0x1.a01a019be90b4p-13,
    0x1.71de3555361a5p-19, -0x1.ae5e4bab3de70p-26, 0x1.5d8b6a30f4eefp-33,
};
/// cos r = 1 - z/2 + z^2 P(z), |r| <= pi/4. Error 2^-33.0.
inline constexpr double CosU10[3] = {
    0x1.55554a10964c9p-5,
    -0x1.6c0c332514b19p-10,
    0x1.99eb76f4c848fp-16,
};
/// the same. Error 2^-63.9.
inline constexpr double CosCr[6] = {
    0x1.555555555554bp-5,   -0x1.6c16c16c15015p-10, 0x1.a01a019c8f195p-16,
    -0x1.27e4f7f17d1fdp-22, 0x1.1ee9dbb9657e7p-29,  -0x1.8fa675ab81138p-37,
};
/// 2^f = 1 + f P(f), |f| <= 1/2. Error 2^-28.9.
inline constexpr double Exp2U10[6] = {
    0x1.62e430aea4decp-1, 0x1.ebfbdc2da67c7p-3,  0x1.c6aee931eb9f1p-5,
    0x1.3b2d57d6830fdp-7, 0x1.5f3e0bf705dcap-10, 0x1.41f45bfaf6771p-13,
};
/// 2^f = P(f), the first coefficient 1. Error 2^-28.9.
inline constexpr double Exp2Pow[7] = {
    0x1.0000000000000p+0, 0x1.62e430aea4decp-1,  0x1.ebfbdc2da67c7p-3,  0x1.c6aee931eb9f1p-5,
    0x1.3b2d57d6830fdp-7, 0x1.5f3e0bf705dcap-10, 0x1.41f45bfaf6771p-13,
};
/// 2^f = P(f), the first coefficient 1. Error 2^-23.4.
inline constexpr double Exp2PowU35[6] = {
    0x1.0000000000000p+0, 0x1.62e4291690c06p-1, 0x1.ebf9bb2ebd8b5p-3,
    0x1.c6b764fd8a5b3p-5, 0x1.3cea980567933p-7, 0x1.5bb2183c53390p-10,
};
/// 2^f = P(f), the first coefficient 1. Error 2^-45.9.
inline constexpr double Exp2PowCr[10] = {
    0x1.0000000000000p+0,  0x1.62e42fefa37d2p-1,  0x1.ebfbdff81be29p-3,  0x1.c6b08d70c8332p-5,
    0x1.3b2ab7240d97ap-7,  0x1.5d87fd93fc71dp-10, 0x1.430897fc6dfbbp-13, 0x1.ffce2ec3d8679p-17,
    0x1.63e68bb22f13bp-20, 0x1.b3def0818b075p-24,
};
/// the same, error relative to 2^f - 1. Error 2^-32.0.
inline constexpr double Expm1U10[7] = {
    0x1.62e42fefd377ep-1,  0x1.ebfbe0452e01dp-3,  0x1.c6b08cb17936cp-5,  0x1.3b2a1c30de5bbp-7,
    0x1.5d88beae3f826p-10, 0x1.443f6e244fb1cp-13, 0x1.ffc9e0eba31f3p-17,
};
/// e^r = 1 + r P(r), |r| <= log(2)/2, error relative to e^r - 1. Error 2^-55.6.
inline constexpr double ExpCr[11] = {
    0x1.0000000000000p+0,  0x1.0000000000005p-1,  0x1.555555555554fp-3,  0x1.5555555552269p-5,
    0x1.1111111114d12p-7,  0x1.6c16c17ecb85cp-10, 0x1.a01a01878768bp-13, 0x1.a019a7c11447cp-16,
    0x1.71de64d68e0efp-19, 0x1.28a185a321bc8p-22, 0x1.ae9ce9ba4633bp-26,
};
/// e^r = 1 + r + r^2 P(r), |r| <= log(2)/2. Error 2^-63.8.
inline constexpr double Exp64[11] = {
    0x1.0000000000000p-1,  0x1.555555555555ap-3,  0x1.5555555555531p-5,  0x1.111111110f16bp-7,
    0x1.6c16c16c26fccp-10, 0x1.a01a01b1e1fabp-13, 0x1.a01a0151ce5fdp-16, 0x1.71ddf38f8bfe9p-19,
    0x1.27e58f68fc74bp-22, 0x1.af66ac0ca8190p-26, 0x1.1e623d27497b2p-29,
};
/// sinh r = r + r z P(z), |r| <= 3/8. Error 2^-64.9.
inline constexpr double Sinh64[6] = {
    0x1.5555555555555p-3,  0x1.111111111132ep-7,  0x1.a01a019f03b65p-13,
    0x1.71de3e3e45577p-19, 0x1.ae5784ba761f0p-26, 0x1.711158e0eb91cp-33,
};
/// log(1+f) = f - f^2/2 + f^3 P(f), 1+f in [sqrt 1/2, sqrt 2]. Error 2^-30.3.
inline constexpr double LogU10[9] = {
    0x1.555547686080ep-2,  -0x1.00000645b89d9p-2, 0x1.99a4b5d35b253p-3,
    -0x1.555c5bca15326p-3, 0x1.233771aaf1915p-3,  -0x1.fc20869e32a63p-4,
    0x1.e6ee3e1875bf2p-4,  -0x1.de4287362f6d6p-4, 0x1.146382d6e4292p-4,
};
/// log2 (1+f) = s P(z), s = f/(2+f), the same range. Error 2^-37.8.
inline constexpr double Log2Pow[5] = {
    0x1.71547652bf303p+1, 0x1.ec709d109d830p-1, 0x1.277780edecb7dp-1,
    0x1.a58d2e60ebec5p-2, 0x1.5ced8d5cd8d18p-2,
};
/// log2 (1+f) = s P(z), s = f/(2+f), the same range. Error 2^-30.4.
inline constexpr double Log2PowU35[4] = {
    0x1.7154764e43889p+1,
    0x1.ec70e74948966p-1,
    0x1.2746a623b97d4p-1,
    0x1.ba2fa7c8eacbdp-2,
};
/// log2 (1+f) = s P(z), s = f/(2+f), the same range. Error 2^-52.3.
inline constexpr double Log2PowCr[7] = {
    0x1.71547652b82ffp+1, 0x1.ec709dc39cd18p-1, 0x1.2776c516726b3p-1, 0x1.a61756a95ec24p-2,
    0x1.484fa0f7e5498p-2, 0x1.0bb8edbe882bfp-2, 0x1.f16bf2f86b91cp-3,
};
/// atanh s = s + s z P(z), the same range. Error 2^-59.5.
inline constexpr double AtanhCr[7] = {
    0x1.5555555555592p-2, 0x1.999999997ff61p-3, 0x1.24924941dbc94p-3, 0x1.c71c52198b8e9p-4,
    0x1.74663bc408467p-4, 0x1.39a2081d04936p-4, 0x1.2f027704fedd5p-4,
};
/// atanh s = s (1 + z/3 + z^2/5 + z^3 P(z)). Error 2^-72.8.
inline constexpr double AtanhTail64[7] = {
    0x1.24924924927ccp-3, 0x1.c71c71c65a486p-4, 0x1.745d17d73ca71p-4, 0x1.3b13784084830p-4,
    0x1.111dcc469d25ap-4, 0x1.de9ee631486a2p-5, 0x1.e7dc5d1a81566p-5,
};
/// asin r = r + r z P(z), |r| <= 1/2. Error 2^-55.9.
inline constexpr double AsinCr[12] = {
    0x1.5555555555391p-3, 0x1.333333336e6c1p-4, 0x1.6db6db4284e80p-5,  0x1.f1c72c3616317p-6,
    0x1.6e89f47d48f8bp-6, 0x1.1c6bde70b3273p-6, 0x1.c6fdf9d3d8db8p-7,  0x1.8ec1bacb4fb25p-7,
    0x1.abd8a9130f3f1p-8, 0x1.3fef5f6be4010p-6, -0x1.09cc849afdc91p-6, 0x1.056bb5745ec94p-5,
};
/// atan t = t + t z P(z), |t| <= tan(pi/8). Error 2^-30.5.
inline constexpr double AtanU10[5] = {
    -0x1.5555492816b8bp-2, 0x1.999195e75bb6cp-3,  -0x1.23b51b48316b9p-3,
    0x1.b1ebc06fdfbf8p-4,  -0x1.f1ebd835a93d2p-5,
};
/// atan t = t + t z P(z), |t| <= tan(pi/8). Error 2^-59.4.
inline constexpr double AtanCr[11] = {
    -0x1.555555555553dp-2, 0x1.999999999586ep-3, -0x1.24924922ad7b3p-3, 0x1.c71c70e619a4ap-4,
    -0x1.745cf8dd7e9dbp-4, 0x1.3b11192ee1198p-4, -0x1.10ebb91bc406dp-4, 0x1.df0f57b2f8130p-5,
    -0x1.9cd2f7a14609bp-5, 0x1.37d640e00785dp-5, -0x1.256bc08064a41p-6,
};
/// m^(-1/3), m in [1, 2], to start iterating from. Error 2^-14.7.
inline constexpr double InverseCbrtU10[5] = {
    0x1.ab85748cebce7p+0,  -0x1.2c411eb6504ffp+0, 0x1.6413ce1fc4400p-1,
    -0x1.c512524e141f3p-3, 0x1.d465a32a1ddc7p-6,
};
/// m^(-1/3), m in [1, 2], to start iterating from. Error 2^-17.4.
inline constexpr double InverseCbrtCr[6] = {
    0x1.c7f3a567104e5p+0,  -0x1.90e80316d7264p+0, 0x1.3e69992e51c07p+0,
    -0x1.321d526b2afbep-1, 0x1.3fa35eb6db5f7p-3,  -0x1.16d79d744079ap-6,
};
/// (1-h)^(-1/3) = P(h), |h| <= 0.1035, the first coefficient 1. Error 2^-14.3.
inline constexpr float CbrtStep[3] = {
    0x1.0000000000000p+0f,
    0x1.56c0b00000000p-2f,
    0x1.c9f7fc0000000p-3f,
};
/// sin r = r + r z P(z), |r| <= pi/2. Error 2^-27.2.
inline constexpr float SinPiU35[4] = {
    -0x1.55554c0000000p-3f,
    0x1.110ed40000000p-7f,
    -0x1.9f6f200000000p-13f,
    0x1.5da7f00000000p-19f,
};
/// tan r = r + r z P(z), |r| <= pi/4. Error 2^-25.6.
inline constexpr float TanU35[6] = {
    0x1.5554d60000000p-2f, 0x1.112f900000000p-3f, 0x1.b54dc80000000p-5f,
    0x1.9202320000000p-6f, 0x1.82442c0000000p-9f, 0x1.36ef3e0000000p-7f,
};
/// e^r = 1 + r + r^2 P(r), |r| <= log(2)/2. Error 2^-23.2.
inline constexpr float ExpU35[4] = {
    0x1.fffdfc0000000p-2f,
    0x1.5557ac0000000p-3f,
    0x1.572a300000000p-5f,
    0x1.1064d80000000p-7f,
};
/// 2^f = 1 + f P(f), |f| <= 1/2. Error 2^-28.3.
inline constexpr float Exp2U35[6] = {
    0x1.62e4300000000p-1f, 0x1.ebfbdc0000000p-3f,  0x1.c6af7c0000000p-5f,
    0x1.3b2de00000000p-7f, 0x1.5f08360000000p-10f, 0x1.416b8a0000000p-13f,
};
/// e^r = 1 + r P(r), error relative to e^r - 1. Error 2^-26.1.
inline constexpr float Expm1U35[6] = {
    0x1.0000000000000p+0f, 0x1.fffffe0000000p-2f, 0x1.5554b40000000p-3f,
    0x1.5556f60000000p-5f, 0x1.12254a0000000p-7f, 0x1.6b985a0000000p-10f,
};
/// e^2r = 1 + r P(r), error relative to e^2r - 1. Error 2^-26.1.
inline constexpr float Expm1TwiceU35[6] = {
    0x1.0000000000000p+1f, 0x1.fffffe0000000p+0f, 0x1.5554b40000000p+0f,
    0x1.5556f60000000p-1f, 0x1.12254a0000000p-2f, 0x1.6b985a0000000p-4f,
};
/// log(1+f) = f P(f), 1+f in [sqrt 1/2, sqrt 2]. Error 2^-25.0.
inline constexpr float LogU35[9] = {
    0x1.0000000000000p+0f,  -0x1.fffffa0000000p-2f, 0x1.5556f00000000p-2f,
    -0x1.0004a80000000p-2f, 0x1.98d3940000000p-3f,  -0x1.535c260000000p-3f,
    0x1.317d980000000p-3f,  -0x1.2505d60000000p-3f, 0x1.65e7ce0000000p-4f,
};
/// log2(1+f) = f P(f), 1+f in [sqrt 1/2, sqrt 2]. Error 2^-25.1.
inline constexpr float Log2U35[9] = {
    0x1.7154760000000p+0f,  -0x1.7154720000000p-1f, 0x1.ec73660000000p-2f,
    -0x1.715b7c0000000p-2f, 0x1.26dd420000000p-2f,  -0x1.e980cc0000000p-3f,
    0x1.b94ede0000000p-3f,  -0x1.a780b60000000p-3f, 0x1.01b8360000000p-3f,
};
/// log10(1+f) = f P(f), 1+f in [sqrt 1/2, sqrt 2]. Error 2^-24.4.
inline constexpr float Log10U35[9] = {
    0x1.bcb7b00000000p-2f,  -0x1.bcb7b20000000p-3f, 0x1.287d7e0000000p-3f,
    -0x1.bcbca00000000p-4f, 0x1.62b10c0000000p-4f,  -0x1.26dfca0000000p-4f,
    0x1.0d7f280000000p-4f,  -0x1.fe42940000000p-5f, 0x1.21773c0000000p-5f,
};
/// asin r = r + r z P(z), |r| <= 1/2. Error 2^-27.6.
inline constexpr float AsinU35[5] = {
    0x1.5555c80000000p-3f, 0x1.3302020000000p-4f, 0x1.747bec0000000p-5f,
    0x1.8c3c680000000p-6f, 0x1.595dea0000000p-5f,
};
/// atan t = t + t z P(z), |t| <= 1. Error 2^-25.8.
inline constexpr float AtanU35[8] = {
    -0x1.5554dc0000000p-2f, 0x1.9978ea0000000p-3f, -0x1.230a7a0000000p-3f, 0x1.b4ddd60000000p-4f,
    -0x1.354f620000000p-4f, 0x1.61ecc80000000p-5f, -0x1.0c17f20000000p-6f, 0x1.7eac420000000p-9f,
};
/// sin r = r + r z P(z), |r| <= pi/2. Error 2^-12.8.
inline constexpr float SinPiFast[2] = {
    -0x1.5435d20000000p-3f,
    0x1.f556c20000000p-8f,
};
/// tan r = r + r z P(z), |r| <= pi/4. Error 2^-14.2.
inline constexpr float TanFast[3] = {
    0x1.570fba0000000p-2f,
    0x1.e1fdca0000000p-4f,
    0x1.7bb8ce0000000p-4f,
};
/// e^r = 1 + r + r^2 P(r), |r| <= log(2)/2. Error 2^-13.0.
inline constexpr float ExpFast[2] = {
    0x1.0204b40000000p-1f,
    0x1.5541ac0000000p-3f,
};
/// 2^f = 1 + f P(f), |f| <= 1/2. Error 2^-13.3.
inline constexpr float Exp2Fast[3] = {
    0x1.62f5fe0000000p-1f,
    0x1.f00c720000000p-3f,
    0x1.c2a1b00000000p-5f,
};
/// e^r = 1 + r P(r), error relative to e^r - 1. Error 2^-16.0.
inline constexpr float Expm1Fast[4] = {
    0x1.fffe0c0000000p-1f,
    0x1.0001960000000p-1f,
    0x1.5762480000000p-3f,
    0x1.555d3c0000000p-5f,
};
/// e^2r = 1 + r P(r), error relative to e^2r - 1. Error 2^-16.0.
inline constexpr float Expm1TwiceFast[4] = {
    0x1.fffe0c0000000p+0f,
    0x1.0001960000000p+1f,
    0x1.5762480000000p+0f,
    0x1.555d3c0000000p-1f,
};
/// log(1+f) = f P(f), 1+f in [sqrt 1/2, sqrt 2]. Error 2^-14.3.
inline constexpr float LogFast[5] = {
    0x1.fffb900000000p-1f,  -0x1.ff70000000000p-2f, 0x1.58767e0000000p-2f,
    -0x1.15726a0000000p-2f, 0x1.69a0600000000p-3f,
};
/// log2(1+f) = f P(f), 1+f in [sqrt 1/2, sqrt 2]. Error 2^-14.3.
inline constexpr float Log2Fast[5] = {
    0x1.7151440000000p+0f,  -0x1.70ec9c0000000p-1f, 0x1.f0f3280000000p-2f,
    -0x1.9044fe0000000p-2f, 0x1.04e30c0000000p-2f,
};
/// log10(1+f) = f P(f), 1+f in [sqrt 1/2, sqrt 2]. Error 2^-14.3.
inline constexpr float Log10Fast[5] = {
    0x1.bcb3d60000000p-2f,  -0x1.bc3a9a0000000p-3f, 0x1.2b32ae0000000p-3f,
    -0x1.e1f9e60000000p-4f, 0x1.3a17240000000p-4f,
};
/// asin r = r + r z P(z), |r| <= 1/2. Error 2^-14.7.
inline constexpr float AsinFast[2] = {
    0x1.5209ac0000000p-3f,
    0x1.82411c0000000p-4f,
};
/// atan t = t + t z P(z), |t| <= 1. Error 2^-14.8.
inline constexpr float AtanFast[4] = {
    -0x1.541a7c0000000p-2f,
    0x1.7e9c280000000p-3f,
    -0x1.81778a0000000p-4f,
    0x1.970fd60000000p-6f,
};
/// e^r = 1 + r + r^2 P(r), |r| <= log(2)/2. Error 2^-28.2.
inline constexpr float ExpFloat[5] = {
    0x1.fffffc0000000p-2f, 0x1.5554940000000p-3f,  0x1.5558be0000000p-5f,
    0x1.12385a0000000p-7f, 0x1.6a3d320000000p-10f,
};
/// 2^f = 1 + f log 2 + f^2 P(f), |f| <= 1/2. Error 2^-28.3.
inline constexpr float Exp2Float[5] = {
    0x1.ebfbdc0000000p-3f,  0x1.c6af8a0000000p-5f,  0x1.3b2dec0000000p-7f,
    0x1.5f03020000000p-10f, 0x1.415e360000000p-13f,
};
/// asin r = r + r z P(z), |r| <= 1/2. Error 2^-27.6.
inline constexpr float AsinFloat[5] = {
    0x1.5555c80000000p-3f, 0x1.3302020000000p-4f, 0x1.747bec0000000p-5f,
    0x1.8c3c680000000p-6f, 0x1.595dea0000000p-5f,
};
/// atan t = t + t z P(z), |t| <= 0.65. Error 2^-27.2.
inline constexpr float AtanFloat[6] = {
    -0x1.5555160000000p-2f, 0x1.9981d40000000p-3f,  -0x1.2311a00000000p-3f,
    0x1.b032620000000p-4f,  -0x1.175ada0000000p-4f, 0x1.a37c960000000p-6f,
};
/// log(1+f) = f - f^2/2 + f^3 P(f). Error 2^-27.4.
inline constexpr float LogFloat[8] = {
    0x1.5555540000000p-2f, -0x1.0002260000000p-2f, 0x1.99a01a0000000p-3f, -0x1.5472820000000p-3f,
    0x1.22d9500000000p-3f, -0x1.0d82de0000000p-3f, 0x1.055f4a0000000p-3f, -0x1.38c9a40000000p-4f,
};

/// 1/pi without the bits that give multiples of 2 when multiplied by a float of exponent 16 j to
/// 16 j + 15, in three parts; products of a float with the first two are exact.
inline constexpr double InversePi0[8] = {
    0x1.4000000000000p-2,  0x1.45f3000000000p-2,  0x1.f306dc8000000p-10, 0x1.6e4e441000000p-25,
    0x1.1054a7c000000p-43, 0x1.29fc275000000p-57, 0x1.3abe8f8000000p-76, 0x1.d1f534d000000p-89,
};
inline constexpr double InversePi1[8] = {
    0x1.7cc1b70000000p-8,  0x1.b727220000000p-24, 0x1.c882a53000000p-38,  0x1.4a7f09c000000p-55,
    0x1.84eafa3000000p-70, 0x1.f47d4d2000000p-87, 0x1.4d37702000000p-103, 0x1.b81b6c5000000p-118,
};
inline constexpr double InversePi2[8] = {
    0x1.391054a7f09d6p-35, 0x1.529fc2757d1f5p-53,  0x1.f09d5f47d4d37p-67,  0x1.5f47d4d377037p-83,
    0x1.d4d377036d8a5p-99, 0x1.77036d8a5664fp-115, 0x1.6d8a5664f10e4p-131, 0x1.5993c439041fep-149,
};

/// 1/pi for floats of exponent 2 j + 1 and 2 j + 2, without multiples of what gives multiples of 2,
/// in two parts; products of a float with the first are exact.
inline constexpr double InversePiHigh[64] = {
    0x1.4000000000000p-2,    0x1.4400000000000p-2,    0x1.4600000000000p-2,
    0x1.4600000000000p-2,    0x1.45f0000000000p-2,    0x1.45f4000000000p-2,
    0x1.45f3000000000p-2,    0x1.45f3000000000p-2,    0x1.45f3000000000p-2,
    0x1.45f3080000000p-2,    0x1.45f3070000000p-2,    0x1.45f306c000000p-2,
    -0x1.7419f24000000p-3,   -0x1.d067c92000000p-5,   0x1.7cc1b74000000p-8,
    -0x1.067c91c000000p-9,   -0x1.9f246c0000000p-15,  -0x1.9f246c8000000p-15,
    -0x1.9f246c6000000p-15,  0x1.836e4e4000000p-17,   -0x1.f246c6e000000p-19,
    0x1.b727220000000p-24,   0x1.b727220000000p-24,   -0x1.236377c000000p-26,
    0x1.b939106000000p-27,   -0x1.1b1bbea000000p-29,  -0x1.b1bbeb0000000p-33,
    -0x1.b1bbeae000000p-33,  0x1.391054a000000p-35,   0x1.c882a54000000p-38,
    -0x1.bbead60000000p-41,  -0x1.bbead60000000p-41,  0x1.1054a80000000p-43,
    0x1.054a7f0000000p-47,   0x1.054a7f0000000p-47,   0x1.529fc20000000p-53,
    0x1.529fc28000000p-53,   0x1.529fc28000000p-53,   0x1.4a7f09e000000p-55,
    0x1.29fc276000000p-57,   0x1.4fe13ac000000p-60,   -0x1.603d8a8000000p-61,
    -0x1.80f62a0000000p-63,  0x1.fc2757e000000p-65,   -0x1.ec54180000000p-72,
    -0x1.ec54170000000p-72,  -0x1.ec54170000000p-72,  0x1.3abe900000000p-76,
    0x1.3abe8fc000000p-76,   -0x1.8a82e0a000000p-77,  0x1.d5f47d4000000p-79,
    -0x1.505c158000000p-82,  0x1.5f47d4e000000p-83,   0x1.7d1f534000000p-85,
    0x1.f47d4d4000000p-87,   -0x1.7056590000000p-92,  -0x1.7056590000000p-92,
    0x1.1f534de000000p-93,   0x1.f534de0000000p-97,   0x1.f534ddc000000p-97,
    -0x1.5964480000000p-102, -0x1.5964480000000p-102, 0x1.4d37704000000p-103,
    0x1.34ddc0e000000p-105,
};
inline constexpr double InversePiLow[64] = {
    0x1.7cc1b727220a9p-8,    0x1.f306dc9c882a5p-10,   -0x1.9f246c6efab58p-15,
    -0x1.9f246c6efab58p-15,  0x1.836e4e44152a0p-17,   -0x1.f246c6efab581p-19,
    0x1.b727220a94fe1p-24,   0x1.b727220a94fe1p-24,   0x1.b727220a94fe1p-24,
    -0x1.236377d5ac07bp-26,  -0x1.1b1bbead603d9p-29,  0x1.c9c882a53f84fp-30,
    -0x1.b1bbead603d8bp-33,  0x1.391054a7f09d6p-35,   -0x1.8ddf56b01ec54p-36,
    0x1.c882a53f84eb0p-38,   -0x1.bbead603d8a83p-41,  0x1.1054a7f09d5f4p-43,
    -0x1.df56b01ec5417p-44,  0x1.054a7f09d5f48p-47,   -0x1.f56b01ec54170p-48,
    0x1.529fc2757d1f5p-53,   0x1.529fc2757d1f5p-53,   -0x1.5ac07b1505c16p-54,
    -0x1.6b01ec5417056p-56,  -0x1.ac07b1505c159p-58,  0x1.4fe13abe8fa9ap-60,
    0x1.3f84eafa3ea6ap-62,   0x1.fc2757d1f534ep-65,   -0x1.ec54170565912p-72,
    -0x1.ec54170565912p-72,  -0x1.ec54170565912p-72,  -0x1.ec54170565912p-72,
    0x1.3abe8fa9a6ee0p-76,   0x1.3abe8fa9a6ee0p-76,   0x1.d5f47d4d37703p-79,
    -0x1.505c1596447e5p-82,  -0x1.505c1596447e5p-82,  -0x1.4170565911f92p-84,
    -0x1.05c1596447e49p-86,  -0x1.70565911f924fp-92,  -0x1.70565911f924fp-92,
    -0x1.70565911f924fp-92,  -0x1.c1596447e493bp-94,  0x1.f534ddc0db629p-97,
    -0x1.596447e493ad5p-102, -0x1.596447e493ad5p-102, -0x1.596447e493ad5p-102,
    -0x1.65911f924eb53p-104, -0x1.96447e493ad4dp-106, 0x1.a6ee06db14acdp-108,
    -0x1.6447e493ad4cep-110, -0x1.911f924eb5336p-112, 0x1.bb81b6c52b328p-114,
    -0x1.11f924eb53362p-116, -0x1.1f924eb53361ep-120, -0x1.1f924eb53361ep-120,
    -0x1.f924eb53361dep-124, -0x1.f924eb53361dep-124, 0x1.b6c52b3278872p-130,
    0x1.b6c52b3278872p-130,  0x1.b6c52b3278872p-130,  -0x1.24eb53361de38p-132,
    -0x1.275a99b0ef1bfp-135,
};

/// 1/pi for floats of exponent j + 1, without multiples of what gives multiples of 2.
inline constexpr double InversePiRounded[128] = {
    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,
    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,
    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,
    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,
    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,
    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,
    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,
    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,    0x1.45f306dc9c883p-2,
    -0x1.7419f246c6efbp-3,   0x1.17cc1b727220bp-4,    -0x1.d067c91b1bbebp-5,
    0x1.7cc1b727220a9p-8,    0x1.7cc1b727220a9p-8,    0x1.7cc1b727220a9p-8,
    -0x1.067c91b1bbeadp-9,   0x1.f306dc9c882a5p-10,   -0x1.9f246c6efab58p-15,
    -0x1.9f246c6efab58p-15,  -0x1.9f246c6efab58p-15,  -0x1.9f246c6efab58p-15,
    -0x1.9f246c6efab58p-15,  0x1.836e4e44152a0p-17,   0x1.836e4e44152a0p-17,
    -0x1.f246c6efab581p-19,  -0x1.f246c6efab581p-19,  0x1.b727220a94fe1p-24,
    0x1.b727220a94fe1p-24,   0x1.b727220a94fe1p-24,   0x1.b727220a94fe1p-24,
    0x1.b727220a94fe1p-24,   -0x1.236377d5ac07bp-26,  -0x1.236377d5ac07bp-26,
    0x1.b9391054a7f0ap-27,   -0x1.1b1bbead603d9p-29,  -0x1.1b1bbead603d9p-29,
    0x1.c9c882a53f84fp-30,   -0x1.b1bbead603d8bp-33,  -0x1.b1bbead603d8bp-33,
    -0x1.b1bbead603d8bp-33,  0x1.391054a7f09d6p-35,   0x1.391054a7f09d6p-35,
    -0x1.8ddf56b01ec54p-36,  0x1.c882a53f84eb0p-38,   0x1.c882a53f84eb0p-38,
    -0x1.bbead603d8a83p-41,  -0x1.bbead603d8a83p-41,  -0x1.bbead603d8a83p-41,
    0x1.1054a7f09d5f4p-43,   0x1.1054a7f09d5f4p-43,   -0x1.df56b01ec5417p-44,
    0x1.054a7f09d5f48p-47,   0x1.054a7f09d5f48p-47,   0x1.054a7f09d5f48p-47,
    -0x1.f56b01ec54170p-48,  0x1.529fc2757d1f5p-53,   0x1.529fc2757d1f5p-53,
    0x1.529fc2757d1f5p-53,   0x1.529fc2757d1f5p-53,   0x1.529fc2757d1f5p-53,
    -0x1.5ac07b1505c16p-54,  0x1.4a7f09d5f47d5p-55,   -0x1.6b01ec5417056p-56,
    0x1.29fc2757d1f53p-57,   -0x1.ac07b1505c159p-58,  0x1.4fe13abe8fa9ap-60,
    0x1.4fe13abe8fa9ap-60,   -0x1.603d8a82e0acbp-61,  0x1.3f84eafa3ea6ap-62,
    -0x1.80f62a0b82b2dp-63,  0x1.fc2757d1f534ep-65,   0x1.fc2757d1f534ep-65,
    -0x1.ec54170565912p-72,  -0x1.ec54170565912p-72,  -0x1.ec54170565912p-72,
    -0x1.ec54170565912p-72,  -0x1.ec54170565912p-72,  -0x1.ec54170565912p-72,
    -0x1.ec54170565912p-72,  0x1.3abe8fa9a6ee0p-76,   0x1.3abe8fa9a6ee0p-76,
    0x1.3abe8fa9a6ee0p-76,   0x1.3abe8fa9a6ee0p-76,   -0x1.8a82e0acb223fp-77,
    0x1.d5f47d4d37703p-79,   0x1.d5f47d4d37703p-79,   -0x1.505c1596447e5p-82,
    -0x1.505c1596447e5p-82,  -0x1.505c1596447e5p-82,  0x1.5f47d4d377037p-83,
    -0x1.4170565911f92p-84,  0x1.7d1f534ddc0dbp-85,   -0x1.05c1596447e49p-86,
    0x1.f47d4d377036ep-87,   -0x1.70565911f924fp-92,  -0x1.70565911f924fp-92,
    -0x1.70565911f924fp-92,  -0x1.70565911f924fp-92,  -0x1.70565911f924fp-92,
    0x1.1f534ddc0db63p-93,   -0x1.c1596447e493bp-94,  0x1.f534ddc0db629p-97,
    0x1.f534ddc0db629p-97,   0x1.f534ddc0db629p-97,   -0x1.596447e493ad5p-102,
    -0x1.596447e493ad5p-102, -0x1.596447e493ad5p-102, -0x1.596447e493ad5p-102,
    -0x1.596447e493ad5p-102, 0x1.4d377036d8a56p-103,  -0x1.65911f924eb53p-104,
    0x1.34ddc0db6295ap-105,  -0x1.96447e493ad4dp-106,
};

/// atan t = t + t z P(z), |t| <= 1/32: its series, whose next term is below 2^-73.
inline constexpr double AtanSeries[6] = {
    -0x1.5555555555555p-2, 0x1.999999999999ap-3,  -0x1.2492492492492p-3,
    0x1.c71c71c71c71cp-4,  -0x1.745d1745d1746p-4, 0x1.3b13b13b13b14p-4,
};
/// The arc tangents of 0/16 to 16/16, each as the sum of two doubles.
inline constexpr double AtanSixteenthsHigh[17] = {
    0x0.0p+0,
    0x1.ff55bb72cfdeap-5,
    0x1.fd5ba9aac2f6ep-4,
    0x1.7b97b4bce5b02p-3,
    0x1.f5b75f92c80ddp-3,
    0x1.362773707ebccp-2,
    0x1.6f61941e4def1p-2,
    0x1.a64eec3cc23fdp-2,
    0x1.dac670561bb4fp-2,
    0x1.0657e94db30d0p-1,
    0x1.1e00babdefeb4p-1,
    0x1.345f01cce37bbp-1,
    0x1.4978fa3269ee1p-1,
    0x1.5d58987169b18p-1,
    0x1.700a7c5784634p-1,
    0x1.819d0b7158a4dp-1,
    0x1.921fb54442d18p-1,
};
inline constexpr double AtanSixteenthsLow[17] = {
    0x0.0p+0,
    -0x1.c934d86d23f1dp-60,
    -0x1.cd37686760c17p-59,
    0x1.347b0b4f881cap-58,
    0x1.8ab6e3cf7afbdp-57,
    -0x1.963a544b672d8p-57,
    -0x1.c63aae6f6e918p-56,
    -0x1.24dec1b50b7ffp-56,
    0x1.a2b7f222f65e2p-56,
    -0x1.d5b495f6349e6p-56,
    -0x1.928df287a668fp-58,
    0x1.1021137c71102p-55,
    0x1.2419a87f2a458p-56,
    0x1.0028e4bc5e7cap-57,
    -0x1.8c34d25aadef6p-56,
    -0x1.bf76229d3b917p-56,
    0x1.1a62633145c07p-55,
};

/// 2/pi from 64 zero bits before its point on, 32 bits a word.
inline constexpr UInt32 TwoOverPiBits[42] = {
    0x00000000, 0x00000000, 0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599,
    0x3c439041, 0xfe5163ab, 0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c,
    0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484, 0xe99c7026, 0xb45f7e41, 0x3991d639,
    0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f, 0xef2f118b, 0x5a0a6d1f,
    0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b, 0x3d0739f7,
    0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab, 0xf0cfbc20, 0x9af4361d,
};

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_COEFFICIENTS_H
