//===-- lib/Emit/SharedLibrary.cpp - from an object to a shared library -------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Emit/SharedLibrary.h"
#include "lld/Common/Driver.h"
#include "llvm/ADT/ScopeExit.h"
#include "llvm/ADT/SmallString.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Signals.h"
#include "llvm/Support/raw_ostream.h"

LLD_HAS_DRIVER(elf)

using namespace llvm;

namespace anysl {
namespace {

/// Where systems keep libc and libm. Folders that are not there do no harm.
constexpr const char *libraryFolders[] = {"/lib/x86_64-linux-gnu",
                                          "/usr/lib/x86_64-linux-gnu",
                                          "/lib64",
                                          "/usr/lib64",
                                          "/lib",
                                          "/usr/lib"};

} // namespace

Error linkSharedLibrary(StringRef object, StringRef path, bool strip) {
  SmallString<128> objectPath;
  int descriptor = -1;
  if (std::error_code code = sys::fs::createTemporaryFile("anysl", "o", descriptor, objectPath))
    return createStringError("cannot write a temporary file: " + code.message());
  sys::RemoveFileOnSignal(objectPath);
  auto cleanUp = make_scope_exit([&] {
    sys::fs::remove(objectPath);
    sys::DontRemoveFileOnSignal(objectPath);
  });
  {
    raw_fd_ostream out(descriptor, /*shouldClose=*/true);
    out << object;
    out.close();
    if (out.has_error()) {
      std::error_code code = out.error();
      out.clear_error();
      return createStringError("cannot write '" + objectPath + "': " + code.message());
    }
  }

  std::string output = path.str();
  SmallVector<const char *> args = {
      "ld.lld", "-shared", "-Bsymbolic", "--no-undefined", "--gc-sections", "--hash-style=gnu",
      "-z", "now", "-z", "noexecstack",
      // One small object is linked faster by one thread than threads are started.
      "--threads=1", "--build-id=none"};
  if (strip)
    args.push_back("--strip-all");
  args.append({"-o", output.c_str(), objectPath.c_str(), "--as-needed"});
  SmallVector<std::string> folders;
  for (const char *folder : libraryFolders)
    folders.push_back(std::string("-L") + folder);
  for (const std::string &folder : folders)
    args.push_back(folder.c_str());
  args.append({"-l:libm.so.6", "-l:libc.so.6"});

  std::string messages;
  raw_string_ostream stream(messages);
  lld::Result result = lld::lldMain(args, stream, stream, {{lld::Gnu, &lld::elf::link}});
  if (result.retCode != 0)
    return createStringError("linking the shared library failed: " + StringRef(messages).trim());
  return Error::success();
}

} // namespace anysl
