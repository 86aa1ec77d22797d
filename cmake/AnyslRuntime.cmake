# How C++ becomes bitcode for the linker of shaders.
#
# Runtime code is its own freestanding program: it sees <anysl/...> and clang's own headers, is compiled
# without running a pass (so that a later module can still override an operator that an earlier one calls),
# and never contracts a * b + c by itself (so that every width and instruction set gives the same number).

find_program(ANYSL_LLVM_LINK NAMES llvm-link-19 llvm-link HINTS ${LLVM_TOOLS_BINARY_DIR} REQUIRED)

set(ANYSL_BITCODE_DIR ${CMAKE_BINARY_DIR}/lib/anysl)
set(ANYSL_BITCODE_INSTALL_DIR ${CMAKE_INSTALL_LIBDIR}/anysl)
set(ANYSL_BITCODE_FLAGS
    -std=c++20 -O1 -Xclang -disable-llvm-passes -ffp-contract=off -fno-math-errno
    -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-stack-protector -fno-unwind-tables
    -fno-asynchronous-unwind-tables -fPIC -DANYSL_IS_BITCODE
    # Conditions of numbers with derivatives are calls, which clang would rather see joined by &&.
    -Wall -Wextra -Wmissing-prototypes -Wno-bitwise-instead-of-logical -Werror)
set(ANYSL_BITCODE_FREESTANDING -nostdinc++ -nostdlibinc)
set(ANYSL_RUNTIME_INCLUDES ${PROJECT_SOURCE_DIR}/include ${ANYSL_INCLUDE_DIR})
set(ANYSL_REAL_SOURCE_DIR ${PROJECT_SOURCE_DIR}/runtimes/real)

# Everything that this file's functions build.
if(NOT TARGET anysl-runtimes)
  add_custom_target(anysl-runtimes ALL)
endif()

# anysl_add_bitcode(PATH SOURCES files... [HOSTED files...] [INCLUDES folders...] [FLAGS flags...])
#
# Compiles the sources and links them into the one module lib/anysl/PATH, e.g. "real/float.bc". HOSTED are sources
# that call a library of the system and so see its headers.
function(anysl_add_bitcode path)
  cmake_parse_arguments(ARG "" "" "SOURCES;HOSTED;INCLUDES;FLAGS" ${ARGN})
  set(output ${ANYSL_BITCODE_DIR}/${path})
  string(REGEX REPLACE "[/.]" "-" target "bitcode-${path}")
  set(includes)
  foreach(folder ${ARG_INCLUDES} ${ANYSL_RUNTIME_INCLUDES})
    list(APPEND includes -I ${folder})
  endforeach()

  set(modules)
  foreach(source ${ARG_SOURCES} ${ARG_HOSTED})
    set(headers ${ANYSL_BITCODE_FREESTANDING})
    if(source IN_LIST ARG_HOSTED)
      set(headers)
    endif()
    get_filename_component(source ${source} ABSOLUTE)
    get_filename_component(stem ${source} NAME_WE)
    set(module ${CMAKE_CURRENT_BINARY_DIR}/${target}/${stem}.bc)
    add_custom_command(
      OUTPUT ${module}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_CURRENT_BINARY_DIR}/${target}
      COMMAND ${ANYSL_CLANG} ${ANYSL_BITCODE_FLAGS} ${headers} ${ARG_FLAGS} ${includes}
              -MD -MF ${module}.d -MT ${module} -emit-llvm -c ${source} -o ${module}
      DEPENDS ${source} DEPFILE ${module}.d
      COMMENT "Compiling ${path} (${stem})" VERBATIM)
    list(APPEND modules ${module})
  endforeach()

  get_filename_component(folder ${output} DIRECTORY)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND ${ANYSL_LLVM_LINK} ${modules} -o ${output}
    DEPENDS ${modules}
    COMMENT "Linking ${path}" VERBATIM)
  add_custom_target(${target} DEPENDS ${output})
  add_dependencies(anysl-runtimes ${target})
  get_filename_component(subfolder ${path} DIRECTORY)
  install(FILES ${output} DESTINATION ${ANYSL_BITCODE_INSTALL_DIR}/${subfolder})
endfunction()

# anysl_add_runtime(NAME SOURCES files... REALS reals... [FLAGS flags...])
#
# An interface runtime, compiled once for each real number type: lib/anysl/runtime/NAME.REAL.bc.
function(anysl_add_runtime name)
  cmake_parse_arguments(ARG "" "" "SOURCES;REALS;FLAGS" ${ARGN})
  foreach(real ${ARG_REALS})
    anysl_add_bitcode(runtime/${name}.${real}.bc SOURCES ${ARG_SOURCES} FLAGS ${ARG_FLAGS}
                      INCLUDES ${ANYSL_REAL_SOURCE_DIR}/${real} ${CMAKE_CURRENT_SOURCE_DIR})
  endforeach()
endfunction()
