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
    -0x1.55554bc82e4f0p-3,
    0x1.110ed34deff7fp-7,
    -0x1.9f6fef654f5f4p-13,
    0x1.5dbccc7a55ec6p-19,
};
/// sin r = r + r z P(z), |r| <= pi/2. Error 2^-61.5.
inline constexpr double SinPiCr[8] = {
    -0x1.5555555555555p-3,  0x1.11111111110c8p-7,  -0x1.a01a01a014d6ep-13, 0x1.71de3a52a0a1ap-19,
    -0x1.ae6454d469156p-26, 0x1.6123cd036556ep-33, -0x1.ae43832848363p-41, 0x1.88327d3d634b6p-49,
};
/// the same, |r| <= pi/4. Error 2^-28.0.
inline constexpr double SinU10[3] = {
    -0x1.55554526b46b7p-3,
    0x1.11073ab95de77p-7,
    -0x1.9943c7c600326p-13,
};
/// the same, |r| <= pi/4. Error 2^-57.9.
inline constexpr double SinCr[6] = {
    -0x1.5555555555548p-3, 0x1.111111110f72fp-7,   -0x1.a01a019be8f9ep-13,
    0x1.71de355507fbdp-19, -0x1.ae5e4b65a7965p-26, 0x1.5d8b4b34486f7p-33,
};
/// cos r = 1 - z/2 + z^2 P(z), |r| <= pi/4. Error 2^-33.0.
inline constexpr double CosU10[3] = {
    0x1.55554a16f2cd5p-5,
    -0x1.6c0c3652a1581p-10,
    0x1.99ec4151af554p-16,
};
/// the same. Error 2^-63.9.
inline constexpr double CosCr[6] = {
    0x1.555555555554bp-5,   -0x1.6c16c16c15016p-10, 0x1.a01a019c8f4abp-16,
    -0x1.27e4f7f1b09c6p-22, 0x1.1ee9dbe5be293p-29,  -0x1.8fa690c7b2b0fp-37,
};
/// 2^f = 1 + f P(f), |f| <= 1/2. Error 2^-28.5.
inline constexpr double Exp2U10[6] = {
    0x1.62e4311711bacp-1, 0x1.ebfbe2bfce32dp-3,  0x1.c6ae7531e583fp-5,
    0x1.3b274347f9b47p-7, 0x1.5f6f834d7f290p-10, 0x1.46ad35010aafep-13,
};
/// the same, error relative to 2^f - 1. Error 2^-31.2.
inline constexpr double Expm1U10[7] = {
    0x1.62e42fefd3471p-1,  0x1.ebfbe045349dcp-3,  0x1.c6b08cb2b398dp-5,  0x1.3b2a18e42100ap-7,
    0x1.5d884a650a642p-10, 0x1.444574758b094p-13, 0x1.0064793401715p-16,
};
/// e^r = 1 + r P(r), |r| <= log(2)/2, error relative to e^r - 1. Error 2^-55.8.
inline constexpr double ExpCr[12] = {
    0x1.0000000000000p+0,  0x1.0000000000001p-1,  0x1.5555555555557p-3,  0x1.5555555554b1bp-5,
    0x1.11111111105d0p-7,  0x1.6c16c16fde437p-10, 0x1.a01a01a7e3cb3p-13, 0x1.a019ee895ddfdp-16,
    0x1.71de114ffe964p-19, 0x1.280fbea2b4322p-22, 0x1.af2c359328662p-26, 0x1.b35de1c08be12p-30,
};
/// e^r = 1 + r + r^2 P(r), |r| <= log(2)/2. Error 2^-60.0.
inline constexpr double Exp64[11] = {
    0x1.0000000000000p-1,  0x1.555555555555dp-3,  0x1.555555555556cp-5,  0x1.111111110e547p-7,
    0x1.6c16c16c0a22ap-10, 0x1.a01a01b6bc808p-13, 0x1.a01a01edbefb7p-16, 0x1.71dde597d8c11p-19,
    0x1.27e423d00b7e5p-22, 0x1.af82b82a52a53p-26, 0x1.20c8b34a47a57p-29,
};
/// sinh r = r + r z P(z), |r| <= 3/8. Error 2^-64.9.
inline constexpr double Sinh64[6] = {
    0x1.5555555555555p-3,  0x1.111111111132ep-7,  0x1.a01a019f03b65p-13,
    0x1.71de3e3e45577p-19, 0x1.ae5784ba761f0p-26, 0x1.71115b5d61b90p-33,
};
/// log(1+f) = f - f^2/2 + f^3 P(f), 1+f in [sqrt 1/2, sqrt 2]. Error 2^-29.5.
inline constexpr double LogU10[9] = {
    0x1.555547707c540p-2,  -0x1.000048484f429p-2, 0x1.99a558a429a8ep-3,
    -0x1.553ff4a76455dp-3, 0x1.230f1b625925cp-3,  -0x1.ffd076dba1f48p-4,
    0x1.ed12b328d4f1cp-4,  -0x1.cb00d61d3780fp-4, 0x1.ded1f0e5b8d25p-5,
};
/// atanh s = s + s z P(z), the same range. Error 2^-37.6.
inline constexpr double AtanhPow[4] = {
    0x1.555554fdefc62p-2,
    0x1.999a7a05759afp-3,
    0x1.2438f23a6ae45p-3,
    0x1.e2f37976f6572p-4,
};
/// atanh s = s + s z P(z), the same range. Error 2^-59.5.
inline constexpr double AtanhCr[7] = {
    0x1.5555555555592p-2, 0x1.999999997ff61p-3, 0x1.24924941dbc94p-3, 0x1.c71c52197a30ep-4,
    0x1.74663bc98869bp-4, 0x1.39a207a458ddap-4, 0x1.2f02788345b87p-4,
};
/// atanh s = s (1 + z/3 + z^2/5 + z^3 P(z)). Error 2^-72.8.
inline constexpr double AtanhTail64[7] = {
    0x1.24924924927ccp-3, 0x1.c71c71c65a486p-4, 0x1.745d17d73d543p-4, 0x1.3b13783ff7472p-4,
    0x1.111dcc6efe038p-4, 0x1.de9edc725a494p-5, 0x1.e7dcc98a3c853p-5,
};
/// asin r = r + r z P(z), |r| <= 1/2. Error 2^-27.6.
inline constexpr double AsinU10[5] = {
    0x1.5555c83d2f267p-3, 0x1.3301fc3c47342p-4, 0x1.747c082cbfb50p-5,
    0x1.8c3d5104a5182p-6, 0x1.595c47ce926fcp-5,
};
/// asin r = r + r z P(z), |r| <= 1/2. Error 2^-55.9.
inline constexpr double AsinCr[12] = {
    0x1.5555555555392p-3, 0x1.333333336e570p-4, 0x1.6db6db428fa26p-5,  0x1.f1c72c3356fb4p-6,
    0x1.6e89f4b1af7f1p-6, 0x1.1c6bdbf0deca7p-6, 0x1.c6fe2327ac551p-7,  0x1.8ec0cd9d1569cp-7,
    0x1.abdfffd4e0c37p-8, 0x1.3fea91fdc9fd0p-6, -0x1.09c50b3cda715p-6, 0x1.056918e9875a5p-5,
};
/// atan t = t + t z P(z), |t| <= tan(pi/8). Error 2^-30.5.
inline constexpr double AtanU10[5] = {
    -0x1.5555492f2c294p-2, 0x1.999198fe1bb80p-3,  -0x1.23b5531c597c8p-3,
    0x1.b1eebec07c6b7p-4,  -0x1.f1f9b204df09dp-5,
};
/// atan t = t + t z P(z), |t| <= tan(pi/8). Error 2^-59.4.
inline constexpr double AtanCr[11] = {
    -0x1.555555555553dp-2, 0x1.999999999586ep-3, -0x1.24924922ad7b3p-3, 0x1.c71c70e61a433p-4,
    -0x1.745cf8ddaa65cp-4, 0x1.3b111933bf61bp-4, -0x1.10ebb9655633dp-4, 0x1.df0f5cbad4365p-5,
    -0x1.9cd3114cfca7ep-5, 0x1.37d687eb43207p-5, -0x1.256c6596f4cd1p-6,
};
/// m^(-1/3), m in [1, 2], to start iterating from. Error 2^-14.7.
inline constexpr double InverseCbrtU10[5] = {
    0x1.ab867f7db2f96p+0,  -0x1.2c442f60d9171p+0, 0x1.641a717c4e76ap-1,
    -0x1.c51ebacde76d6p-3, 0x1.d4767c915b0c2p-6,
};
/// m^(-1/3), m in [1, 2], to start iterating from. Error 2^-17.4.
inline constexpr double InverseCbrtCr[6] = {
    0x1.c7f43ffbe2d31p+0,  -0x1.90ea0ccb5c975p+0, 0x1.3e6c5317164fap+0,
    -0x1.3220f2c40aee6p-1, 0x1.3fa832b06285ep-3,  -0x1.16dcc90c0b402p-6,
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
