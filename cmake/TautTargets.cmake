# taut_add_layer(name SOURCES ... LINK ...): one static library per layer.
# taut_add_test(name SOURCES ... LINK ... [RANKS n] [LABEL quick|full|long]).

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_FLAGS_RELEASE "-O2")
set(CMAKE_CXX_FLAGS_DEBUG "-O0 -g")

option(TAUT_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)
if(TAUT_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # Sloppiness: ccache cannot otherwise cache a build with a precompiled header.
  set(launcher ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      ${CCACHE_PROGRAM})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
  set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
  # Makes the precompiled header a reproducible input of the cache.
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
endif()

add_library(taut_warnings INTERFACE)
target_compile_options(taut_warnings INTERFACE -Wall -Wextra -Wpedantic)

# The one precompiled header of everything that includes deal.II.
function(taut_precompiled_header target)
  if(NOT TARGET taut_pch)
    add_library(taut_pch OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cc)
    # The same warnings as its users: -Wpedantic changes predefined macros.
    target_link_libraries(taut_pch PUBLIC taut::dealii PRIVATE taut_warnings)
    target_include_directories(taut_pch PUBLIC ${PROJECT_SOURCE_DIR}/include)
    target_precompile_headers(taut_pch PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
  endif()
  target_precompile_headers(${target} REUSE_FROM taut_pch)
  # Reading the precompiled header and instantiating deal.II's templates costs a
  # source file more than its own code: compiled six at a time it costs a third.
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 6)
endfunction()

function(taut_add_layer name)
  cmake_parse_arguments(ARG "PRECOMPILED" "" "SOURCES;LINK" ${ARGN})
  if(ARG_SOURCES)
    add_library(taut_${name} STATIC ${ARG_SOURCES})
    target_include_directories(taut_${name} PUBLIC ${PROJECT_SOURCE_DIR}/include)
    target_link_libraries(taut_${name} PUBLIC ${ARG_LINK} PRIVATE taut_warnings)
    if(ARG_PRECOMPILED)
      taut_precompiled_header(taut_${name})
    endif()
  else()
    add_library(taut_${name} INTERFACE)
    target_include_directories(taut_${name} INTERFACE ${PROJECT_SOURCE_DIR}/include)
    target_link_libraries(taut_${name} INTERFACE ${ARG_LINK})
  endif()
  add_library(taut::${name} ALIAS taut_${name})
endfunction()
