#include "ganglion/base/denied.h"

#include <gtest/gtest.h>

#include <new>
#include <system_error>

namespace ganglion {
namespace {

template <class Thrown>
Error after(const Thrown& thrown) {
  try {
    throw thrown;
  } catch (...) {
    return denied();
  }
}

TEST(Denied, SaysWhatTheSystemDenied) {
  EXPECT_TRUE(after(std::bad_alloc()).what.en.starts_with("out of memory"));
  const Error threads = after(std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again)));
  EXPECT_NE(threads.what.en.find("Resource temporarily unavailable"), std::string::npos);
  EXPECT_NE(threads.what.es.find("hilos"), std::string::npos);
  EXPECT_EQ(threads.code, ErrorCode::TooLarge);
}

TEST(Denied, CallsAllElseAFault) {
  EXPECT_NE(after(std::runtime_error("odd")).what.en.find("please report it: odd"), std::string::npos);
}

}  // namespace
}  // namespace ganglion
