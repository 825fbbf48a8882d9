# What nearly every file includes, compiled once for each way of compiling: half of the time that a
# build takes is spent on reading these. Each file still includes what it uses, and compiles without:
# see CMAKE_DISABLE_PRECOMPILE_HEADERS.
# A launcher such as ccache finds less again behind precompiled headers than they save.
if(CMAKE_CXX_COMPILER_LAUNCHER AND NOT DEFINED CMAKE_DISABLE_PRECOMPILE_HEADERS)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

set(precompiled_standard
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numeric>
  <optional> <span> <stdexcept> <string> <string_view> <thread> <utility> <vector>
  <glm/glm.hpp>)

# sir_precompile(NAME [TEST] LIBRARIES ... HEADERS ...)
# An empty library whose headers others take by `target_precompile_headers(OTHER REUSE_FROM NAME)`.
function(sir_precompile name)
  cmake_parse_arguments(ARG "" "" "LIBRARIES;HEADERS" ${ARGN})
  file(WRITE ${CMAKE_BINARY_DIR}/${name}.cpp "")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE sir_options glm::glm Threads::Threads ${ARG_LIBRARIES})
  target_compile_definitions(${name} PRIVATE GLM_FORCE_CTOR_INIT)
  target_precompile_headers(${name} PRIVATE ${precompiled_standard} ${ARG_HEADERS})
endfunction()
