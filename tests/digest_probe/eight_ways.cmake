cmake_minimum_required(VERSION 3.25)
# SOURCE: the project; WORK: a folder to build in; JOBS: how many compilers at once. Builds digest_probe with two compilers, with
# and without optimisation, for the plainest amd64 processor and for one with AVX2 and fused multiply-add, runs all eight,
# and stops where one prints something else. The first is the preset `plain`, source by source, which ./dev lint compiles
# as well; in the others the sources of a target are compiled together, so that this is seen to change no bit either.
# SELF_TEST=ON adds a ninth build that may contract and reorder arithmetic, which must be told from the others: a comparison
# that cannot fail would prove nothing. QUICK=ON leaves out four of the eight: what is left has each compiler with and
# without optimisation, and both at their boldest. The release build's own digests are held by tests/golden.
set(compilers g++ clang++-16)
set(levels -O0 -O2)
set(processors x86-64 x86-64-v3)

file(READ /proc/cpuinfo processor LIMIT 8192)
foreach(feature avx2 fma bmi2)
  if(NOT processor MATCHES " ${feature}[ \n]")
    message(FATAL_ERROR "this processor has no ${feature}: the builds for x86-64-v3 cannot be compared here")
  endif()
endforeach()

# build_and_run(NAME COMPILER FLAGS): leaves what the probe printed in WORK/NAME.txt.
function(build_and_run name compiler flags)
  set(folder ${WORK}/${name})
  set(configure "-S;${SOURCE};-B;${folder};-G;Ninja;-DCMAKE_CXX_COMPILER=${compiler};-DCMAKE_BUILD_TYPE=None;-DCMAKE_CXX_FLAGS=${flags};-DGANGLION_STUDIO=OFF")
  if(name STREQUAL plain)
    set(folder ${SOURCE}/build/plain)
    set(configure "--preset;plain;-DGANGLION_STUDIO=ON")
  endif()
  foreach(step
      "${CMAKE_COMMAND};${configure};-DGANGLION_TESTS=OFF;-DGANGLION_DIGEST_PROBE=ON"
      "${CMAKE_COMMAND};--build;${folder};--target;digest_probe;-j;${JOBS}")
    execute_process(COMMAND ${step} WORKING_DIRECTORY ${SOURCE} RESULT_VARIABLE failed OUTPUT_VARIABLE said
                    ERROR_VARIABLE said)
    if(failed)
      message(FATAL_ERROR "${name}: ${said}")
    endif()
  endforeach()
  execute_process(COMMAND ${folder}/bin/digest_probe ${SOURCE}/experiments OUTPUT_FILE ${WORK}/${name}.txt
                  RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${name}: the probe ended with ${failed}")
  endif()
endfunction()

# differences(ONE OTHER RESULT): the lines of OTHER that are not in ONE.
function(differences one other result)
  file(STRINGS ${WORK}/${one}.txt expected)
  file(STRINGS ${WORK}/${other}.txt lines)
  list(LENGTH expected count)
  list(LENGTH lines other_count)
  if(NOT count EQUAL other_count)
    set(${result} "${count} lines against ${other_count}" PARENT_SCOPE)
    return()
  endif()
  list(REMOVE_ITEM lines ${expected})
  string(REPLACE ";" "\n" lines "${lines}")
  set(${result} "${lines}" PARENT_SCOPE)
endfunction()

file(MAKE_DIRECTORY ${WORK})
set(left_out g++-O0_x86-64-v3 g++-O2_x86-64 clang++-16-O0_x86-64-v3 clang++-16-O2_x86-64)
set(builds 0)
set(first "")
set(worst "")
foreach(compiler IN LISTS compilers)
  foreach(level IN LISTS levels)
    foreach(processor IN LISTS processors)
      set(name ${compiler}${level}_${processor})
      if(QUICK AND name IN_LIST left_out)
        continue()
      endif()
      math(EXPR builds "${builds} + 1")
      if(first STREQUAL "")
        set(name plain)  # g++ -O0, x86-64: as in CMakePresets.json
      endif()
      build_and_run(${name} ${compiler} "${level} -march=${processor}")
      if(first STREQUAL "")
        set(first ${name})
      endif()
      differences(${first} ${name} found)
      file(SHA256 ${WORK}/${name}.txt sum)
      string(SUBSTRING ${sum} 0 16 sum)
      message(STATUS "${name}: ${sum}")
      if(NOT found STREQUAL "")
        string(APPEND worst "${name} differs from ${first} in:\n${found}\n")
      endif()
    endforeach()
  endforeach()
endforeach()

if(NOT worst STREQUAL "")
  message(FATAL_ERROR "${worst}")
endif()
file(STRINGS ${WORK}/${first}.txt lines)
list(LENGTH lines count)
message(STATUS "${builds} builds, the same ${count} digests")

if(SELF_TEST)
  build_and_run(unsafe g++ "-O2 -march=x86-64-v3 -ffast-math;-DGANGLION_UNSAFE_MATH=ON")
  differences(${first} unsafe found)
  if(found STREQUAL "")
    message(FATAL_ERROR "-ffast-math changed no digest: the comparison is blind")
  endif()
  message(STATUS "-ffast-math is found out")
endif()
