//===-- runtimes/packet/context.cpp - what it shares with others over a batch -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/standard/hooks.h>
#include <anysl/standard/notes.h>
#include <anysl/standard/params.h>
#include <anysl/standard/queries.h>
#include <anysl/standard/random.h>
#include <anysl/standard/shaders.h>
#include <anysl/standard/spaces.h>
#include <anysl/standard/text.h>

const AnyslLayout anysl_runtime_layout = ANYSL_LAYOUT_SOA;
