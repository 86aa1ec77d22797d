# What the targets of this project have in common.

add_library(anysl_options INTERFACE)
target_include_directories(anysl_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/include
                                                   ${PROJECT_BINARY_DIR}/include)
target_compile_options(anysl_options INTERFACE -Wall -Wextra -Wno-unused-parameter)
target_compile_definitions(anysl_options INTERFACE ANYSL_VERSION="${PROJECT_VERSION}")
if(ANYSL_SANITIZE)
  target_compile_options(anysl_options INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer
                                                 -fno-sanitize=vptr,function)
  target_link_options(anysl_options INTERFACE -fsanitize=address,undefined)
endif()
if(ANYSL_FUZZ)
  target_compile_options(anysl_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# What code against LLVM needs besides: LLVM's headers, no RTTI, the shared libLLVM.
add_library(anysl_llvm INTERFACE)
target_link_libraries(anysl_llvm INTERFACE anysl_options LLVM)

function(anysl_use_llvm target)
  target_include_directories(${target} SYSTEM PRIVATE ${LLVM_INCLUDE_DIRS})
  target_compile_options(${target} PRIVATE -fno-rtti -fno-exceptions)
  separate_arguments(definitions UNIX_COMMAND "${LLVM_DEFINITIONS}")
  target_compile_definitions(${target} PRIVATE ${definitions})
  target_link_libraries(${target} PUBLIC anysl_llvm)
endfunction()

# Reading LLVM's headers takes longer than the rest of most files. Each file includes what it needs all the same:
# it has to compile with CMAKE_DISABLE_PRECOMPILE_HEADERS as well.
set(ANYSL_PRECOMPILED_HEADERS
    <llvm/ADT/DenseMap.h> <llvm/ADT/MapVector.h> <llvm/ADT/STLExtras.h> <llvm/ADT/SetVector.h> <llvm/ADT/StringExtras.h>
    <llvm/ADT/StringMap.h> <llvm/ADT/StringSwitch.h> <llvm/IR/IRBuilder.h> <llvm/IR/InstIterator.h> <llvm/IR/IntrinsicInst.h>
    <llvm/IR/Module.h> <llvm/IR/PassManager.h> <llvm/Support/FormatVariadic.h> <llvm/Support/JSON.h>
    <llvm/Support/Path.h> <llvm/Support/SourceMgr.h> <llvm/Support/raw_ostream.h>
    <algorithm> <functional> <map> <memory> <optional> <set> <string> <vector>)

# anysl_add_library(Name SOURCES... LINK libraries... [EXCEPTIONS]): a static library of the tree that uses LLVM.
function(anysl_add_library name)
  cmake_parse_arguments(ARG "EXCEPTIONS" "" "LINK" ${ARGN})
  add_library(${name} STATIC ${ARG_UNPARSED_ARGUMENTS})
  anysl_use_llvm(${name})
  target_link_libraries(${name} PUBLIC ${ARG_LINK})
  if(ARG_EXCEPTIONS)  # and headers of its own, then
    target_compile_options(${name} PRIVATE -fexceptions)
  elseif(name STREQUAL AnyslSupport)
    target_precompile_headers(${name} PRIVATE ${ANYSL_PRECOMPILED_HEADERS})
  else()
    target_precompile_headers(${name} REUSE_FROM AnyslSupport)
  endif()
endfunction()

# anysl_add_tool(name SOURCES... LINK libraries...): a program in bin/ that uses LLVM.
function(anysl_add_tool name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
  anysl_use_llvm(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
  install(TARGETS ${name} RUNTIME)
endfunction()
