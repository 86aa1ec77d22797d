//===-- lib/STC/Reader.cpp - reads STC files ----------------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Reader.h"
#include "lib/STC/Verifier.h"
#include "lib/STC/Writer.h"
#include "lib/Support/Diagnostics.h"
#include "llvm/AsmParser/Parser.h"
#include "llvm/Bitcode/BitcodeReader.h"
#include "llvm/IR/DiagnosticHandler.h"
#include "llvm/IR/DiagnosticInfo.h"
#include "llvm/IR/LLVMContext.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/SourceMgr.h"
#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace llvm;

namespace anysl::stc {
namespace {

/// Keeps LLVM's readers from printing: what they would warn of (debug information that they drop)
/// the verifier reports itself.
class SilentHandler : public DiagnosticHandler {
public:
  bool handleDiagnostics(const DiagnosticInfo &) override { return true; }
};

struct ParseError {
  FilePosition position;
  std::string message;
};

/// Parses either form. `error` is set if nothing is returned.
std::unique_ptr<Module> parse(MemoryBufferRef buffer, LLVMContext &context, ParseError &error) {
  auto handler = context.getDiagnosticHandler();
  context.setDiagnosticHandler(std::make_unique<SilentHandler>());
  std::unique_ptr<Module> module;
  if (isBitcode(buffer.getBuffer())) {
    if (auto parsed = parseBitcodeFile(buffer, context))
      module = std::move(*parsed);
    else
      error = {{buffer.getBufferIdentifier().str()},
               "damaged bitcode: " + toString(parsed.takeError())};
  } else {
    SMDiagnostic diagnostic;
    module = parseAssembly(buffer, diagnostic, context);
    if (!module)
      error = {{buffer.getBufferIdentifier().str(), unsigned(std::max(diagnostic.getLineNo(), 0)),
                unsigned(diagnostic.getColumnNo() + 1)},
               "neither bitcode nor LLVM's text form: " + diagnostic.getMessage().str()};
  }
  context.setDiagnosticHandler(std::move(handler));
  return module;
}

/// What became of parsing in a child process.
enum class Trial { Good, Refused, Crashed };

/// In the child: parses and verifies, tells the parent what is wrong, and ends.
[[noreturn]] void tryInChild(MemoryBufferRef buffer, int answer) {
  // Whatever happens happens silently, and neither for long nor with all of the memory.
  int null = open("/dev/null", O_WRONLY);
  dup2(null, STDOUT_FILENO);
  dup2(null, STDERR_FILENO);
  for (int number : {SIGSEGV, SIGBUS, SIGABRT, SIGILL, SIGFPE, SIGTRAP, SIGALRM})
    signal(number, SIG_DFL);
  rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
#if !__has_feature(address_sanitizer)
  rlimit memory{rlim_t(4) << 30, rlim_t(4) << 30};
  setrlimit(RLIMIT_AS, &memory);
#endif
  alarm(20);

  LLVMContext context;
  ParseError error;
  std::unique_ptr<Module> module = parse(buffer, context, error);
  if (module) {
    verify(*module);
    _exit(0);
  }
  raw_fd_ostream out(answer, /*shouldClose=*/true);
  out << error.position.line << ' ' << error.position.column << ' ' << error.message;
  out.close();
  out.clear_error();
  _exit(1);
}

/// Reads all that comes through a pipe, and closes it.
std::string readAll(int pipe) {
  std::string text;
  char piece[256];
  for (;;) {
    ssize_t count = read(pipe, piece, sizeof piece);
    if (count > 0)
      text.append(piece, size_t(count));
    else if (count == 0 || errno != EINTR)
      break;
  }
  close(pipe);
  return text;
}

/// Parses and verifies in a child process. `error` is set if the contents are refused there.
Trial tryParsing(MemoryBufferRef buffer, ParseError &error) {
  int ends[2];
  if (pipe(ends) != 0)
    return Trial::Good; // No pipe or process to be had: the check is lost, not the file.
  pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    tryInChild(buffer, ends[1]);
  }
  close(ends[1]);
  std::string answer = readAll(ends[0]);
  if (child < 0)
    return Trial::Good;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    ;
  if (!WIFEXITED(status))
    return Trial::Crashed;
  if (WEXITSTATUS(status) == 0)
    return Trial::Good;
  StringRef rest = answer;
  error.position.file = buffer.getBufferIdentifier().str();
  if (rest.consumeInteger(10, error.position.line) || !rest.consume_front(" ") ||
      rest.consumeInteger(10, error.position.column) || !rest.consume_front(" "))
    return Trial::Crashed;
  error.message = rest.str();
  return Trial::Refused;
}

} // namespace

bool isBitcode(StringRef contents) {
  auto *begin = reinterpret_cast<const unsigned char *>(contents.begin());
  return llvm::isBitcode(begin, begin + contents.size());
}

std::optional<StcModule> readBuffer(DiagnosticEngine &diags, LLVMContext &context,
                                    MemoryBufferRef buffer) {
  StringRef path = buffer.getBufferIdentifier();
  auto refuse = [&](FilePosition position, const Twine &message) {
    diags.error(position ? position : FilePosition{path.str()}, message);
    return std::nullopt;
  };
  if (buffer.getBufferSize() == 0)
    return refuse({}, "the file is empty");
  Checksum checksum = checkChecksum(buffer.getBuffer());
  if (checksum == Checksum::Wrong)
    return refuse({}, "damaged bitcode: the contents do not match their checksum");
  ParseError error;
  if (checksum == Checksum::None)
    switch (tryParsing(buffer, error)) {
    case Trial::Good:
      break;
    case Trial::Refused:
      return refuse(error.position, error.message);
    case Trial::Crashed:
      return refuse({}, "damaged bitcode: LLVM cannot read it");
    }
  std::unique_ptr<Module> module = parse(buffer, context, error);
  if (!module)
    return refuse(error.position, error.message);
  std::vector<Problem> problems = verify(*module);
  if (!problems.empty()) {
    std::string more = problems.size() == 1 ? ""
                       : problems.size() == 2
                           ? " (and 1 more problem)"
                           : " (and " + std::to_string(problems.size() - 1) + " more problems)";
    return refuse(problems[0].position, problems[0].message + more);
  }
  StcModule result;
  result.producer = readProducer(*module);
  result.shaders = cantFail(readShaders(*module));
  result.path = path.str();
  result.module = std::move(module);
  return result;
}

std::optional<StcModule> readFile(DiagnosticEngine &diags, LLVMContext &context, StringRef path) {
  auto buffer = MemoryBuffer::getFileOrSTDIN(path);
  if (!buffer) {
    diags.error(FilePosition{path.str()}, "cannot read the file: " + buffer.getError().message());
    return std::nullopt;
  }
  return readBuffer(diags, context, (*buffer)->getMemBufferRef());
}

} // namespace anysl::stc
