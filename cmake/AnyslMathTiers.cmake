# ANYSL_MATH_TIERS: the names in runtimes/math/Tiers.def. The tier u10 is defined by TierU10.h; that middle part of
# the file's name is ANYSL_MATH_HEADER_u10.
set(ANYSL_MATH_TIERS)
set(tier_table ${PROJECT_SOURCE_DIR}/runtimes/math/Tiers.def)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${tier_table})
file(STRINGS ${tier_table} tier_lines REGEX "^MATH_TIER\\(")
foreach(line ${tier_lines})
  string(REGEX REPLACE "^MATH_TIER\\(([a-z0-9]+),.*" "\\1" tier "${line}")
  string(SUBSTRING ${tier} 0 1 first)
  string(SUBSTRING ${tier} 1 -1 rest)
  string(TOUPPER ${first} first)
  list(APPEND ANYSL_MATH_TIERS ${tier})
  set(ANYSL_MATH_HEADER_${tier} ${first}${rest})
endforeach()
