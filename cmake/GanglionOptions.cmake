# How every target of the project is compiled. Linked PRIVATE, so none of it reaches a consumer.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
set(CMAKE_CXX_FLAGS_RELEASE "-O2")  # keeps assert-like checks: a robot prefers a stop with a place to a wrong turn

# Arithmetic that may be reordered gives other bits, and takes NaN for a number: a robot would drive on a dead sensor.
option(GANGLION_UNSAFE_MATH "For the self-test of ./dev digest only" OFF)
if(NOT GANGLION_UNSAFE_MATH)
  foreach(flags IN ITEMS CMAKE_CXX_FLAGS CMAKE_CXX_FLAGS_RELEASE CMAKE_CXX_FLAGS_DEBUG CMAKE_CXX_FLAGS_RELWITHDEBINFO)
    if("${${flags}}" MATCHES "-ffast-math|-Ofast|-funsafe-math-optimizations|-ffinite-math-only|-fassociative-math")
      message(FATAL_ERROR "${flags} has ${CMAKE_MATCH_0}: with it NaN counts as a number and runs do not repeat. Leave it out.")
    endif()
  endforeach()
endif()

set(GANGLION_SANITIZE "" CACHE STRING "Sanitizers for every target, as in -fsanitize=")

# Most of the time of a compiler goes into headers, not into our sources. The preset `plain` switches both off. Tests are
# compiled one by one, since their little helpers share names from folder to folder (`step`, `nimrod`, `kNaN`).
option(GANGLION_UNITY "Compile the sources of a target together, a handful at a time" ON)
option(GANGLION_PRECOMPILE "Compile the headers that nearly all sources share only once" ON)
set(CMAKE_UNITY_BUILD ${GANGLION_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 12)

find_program(GANGLION_CCACHE ccache)
if(GANGLION_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${GANGLION_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${GANGLION_CCACHE})
endif()

add_library(ganglion_options INTERFACE)
target_compile_options(ganglion_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual -Wconversion
  -Wno-sign-conversion -Wno-missing-field-initializers
  -ffp-contract=off  # the same bits with and without fused multiply-add
  # g++ 12 makes a rotation, a*x - b*y beside b*x + a*y, into one fused instruction whatever the option above says.
  $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
if(GANGLION_SANITIZE)
  add_compile_options(-fsanitize=${GANGLION_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  add_link_options(-fsanitize=${GANGLION_SANITIZE})
endif()
