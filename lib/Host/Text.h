//===-- lib/Host/Text.h - text made while shading -----------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_HOST_TEXT_H
#define ANYSL_LIB_HOST_TEXT_H

#include <anysl/abi.h>
#include <string>
#include <string_view>

namespace anysl::host {

/// The services that every host has: where its own are null, `services` gets those of libanysl.
void completeTextServices(AnyslServices &services);

/// Appends what a format says of its value number `index`: the text behind the directive before it,
/// and the value. A value without a directive is left out; type 0 stands for the rest of the format
/// behind its first `index` directives. A value that is not what the directive names has its own
/// form. Numbers of a triple or matrix are separated by blanks, and shown whatever the locale with
/// a point.
void appendFormatted(std::string &text, std::string_view format, uint32_t index, uint32_t type,
                     const AnyslCell *value);

/// The one copy of a text, which is never freed.
const char *intern(std::string_view text);

/// Whether a POSIX basic regular expression is found in a text; false if it is malformed.
bool matches(const char *pattern, const char *text);

} // namespace anysl::host

#endif
