#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace ganglion {

/// A test with a folder of its own, empty at first and gone afterwards.
class FolderTest : public ::testing::Test {
 protected:
  FolderTest() : folder_(std::filesystem::temp_directory_path() / name()) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~FolderTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;

 private:
  static std::string name() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    return "ganglion_" + std::string(test->test_suite_name()) + test->name() + std::to_string(::getpid());
  }
};

}  // namespace ganglion
