# One test program per area; the sources were gathered by ganglion_add_library.
set(CMAKE_UNITY_BUILD OFF)
find_package(GTest REQUIRED)
include(GoogleTest)
# What nearly all tests include is compiled once. Of the tests only: a source of the project itself that forgets an
# include must not find it by chance.
file(WRITE ${PROJECT_BINARY_DIR}/test_headers.cpp "")
add_library(ganglion_test_headers STATIC ${PROJECT_BINARY_DIR}/test_headers.cpp)
target_link_libraries(ganglion_test_headers PRIVATE ganglion_base ganglion_options GTest::gtest)
target_precompile_headers(ganglion_test_headers PRIVATE <cmath> <filesystem> <fstream> <functional> <map> <memory>
                          <optional> <span> <string> <vector> <gtest/gtest.h> <fmt/format.h>
                          "${PROJECT_SOURCE_DIR}/ganglion/base/result.h")
get_property(areas GLOBAL PROPERTY GANGLION_AREAS)
list(REMOVE_DUPLICATES areas)
foreach(area IN LISTS areas)
  get_property(sources GLOBAL PROPERTY GANGLION_TESTS_${area})
  get_property(links GLOBAL PROPERTY GANGLION_TEST_LINKS_${area})
  list(REMOVE_DUPLICATES links)
  add_executable(test_${area} ${sources})
  target_link_libraries(test_${area} PRIVATE ${links} ganglion_options GTest::gtest_main)
  target_precompile_headers(test_${area} REUSE_FROM ganglion_test_headers)
  target_compile_definitions(test_${area} PRIVATE GANGLION_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                                  GANGLION_BINARY_DIR="${PROJECT_BINARY_DIR}")
  gtest_discover_tests(test_${area} TEST_PREFIX "${area}/" PROPERTIES LABELS ${area} DISCOVERY_TIMEOUT 60)
endforeach()
