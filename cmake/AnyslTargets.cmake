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

# anysl_add_library(Name SOURCES... LINK libraries...): a static library of the tree that uses LLVM.
function(anysl_add_library name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  add_library(${name} STATIC ${ARG_UNPARSED_ARGUMENTS})
  anysl_use_llvm(${name})
  target_link_libraries(${name} PUBLIC ${ARG_LINK})
endfunction()

# anysl_add_tool(name SOURCES... LINK libraries...): a program in bin/ that uses LLVM.
function(anysl_add_tool name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
  anysl_use_llvm(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
  install(TARGETS ${name} RUNTIME)
endfunction()
