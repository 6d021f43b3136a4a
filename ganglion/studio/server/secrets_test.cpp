#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <functional>

#include "ganglion/studio/server/guard.h"

namespace ganglion::studio {
namespace {

/// Tells how far into a text somebody read, without a clock: the pages of its end are taken out of memory, and
/// whoever reads them brings them back (as zeros). A comparison that stops at the first difference does not.
class ReadWatch {
 public:
  explicit ReadWatch(std::string& text) {
    const auto size = static_cast<std::uintptr_t>(::getpagesize());
    const auto end = reinterpret_cast<std::uintptr_t>(text.data() + text.size());
    last_ = reinterpret_cast<char*>((end / size - 1) * size);  // the last page that is the text's alone
    EXPECT_GE(last_, text.data() + size) << "the text must be longer";
    EXPECT_EQ(::madvise(last_, size, MADV_DONTNEED), 0);
    EXPECT_FALSE(was_read());
  }
  bool was_read() const {
    unsigned char resident = 0;
    EXPECT_EQ(::mincore(last_, static_cast<std::size_t>(::getpagesize()), &resident), 0);
    return (resident & 1) != 0;
  }

 private:
  char* last_ = nullptr;
};

std::string long_secret(char first) {
  std::string text(std::size_t{1} << 20, 'x');
  text[0] = first;
  return text;
}

GuardConfig long_guard() { return {{"h:1"}, long_secret('t'), long_secret('s'), "ganglion_1"}; }

/// Which secret `of` is compared to the end with a wrong one of the same length by this request.
void expect_compared_whole(std::string GuardConfig::*of, const RequestHead& head) {
  GuardConfig config = long_guard();
  const ReadWatch watch(config.*of);
  EXPECT_EQ(judge(config, head).status, 401u);
  EXPECT_TRUE(watch.was_read()) << "the comparison stopped at the first difference: its time tells how long the "
                                   "common beginning is";
}

TEST(Secrets, AreComparedWhole) {
  EXPECT_TRUE(same_secret("abc", "abc"));
  EXPECT_FALSE(same_secret("abc", "abd"));
  EXPECT_FALSE(same_secret("ab", "abc"));
  EXPECT_FALSE(same_secret("abcd", "abc"));
  EXPECT_FALSE(same_secret("", "abc"));
  EXPECT_EQ(random_secret().size(), 64u);
  EXPECT_NE(random_secret(), random_secret());
}

TEST(Secrets, AreReadToTheEndHoweverEarlyAGuessDiffers) {
  const std::string wrong = long_secret('?');
  for (const std::size_t size : {wrong.size(), wrong.size() - 1, std::size_t{3}, std::size_t{0}}) {
    std::string secret = long_secret('t');
    const ReadWatch watch(secret);
    EXPECT_FALSE(same_secret(std::string_view(wrong).substr(0, size), secret));
    EXPECT_TRUE(watch.was_read()) << size;
  }
}

TEST(Secrets, AreReadToTheEndWhereverTheyAreShown) {
  const std::string wrong = long_secret('?');
  const std::string bearer = "Bearer " + wrong, cookie = "ganglion_1=" + wrong, target = "/?token=" + wrong;
  expect_compared_whole(&GuardConfig::token, {.method = "GET", .target = "/", .host = "h:1", .authorization = bearer});
  expect_compared_whole(&GuardConfig::session, {.method = "GET", .target = "/", .host = "h:1", .cookies = cookie});
  expect_compared_whole(&GuardConfig::token, {.method = "GET", .target = target, .host = "h:1"});
}

TEST(Secrets, LeadNowhereElseWhenTheyAreExchanged) {
  const GuardConfig config{{"h:1"}, "t", "s", "ganglion_1"};
  const auto location = [&](std::string_view target) {
    return judge(config, {.method = "GET", .target = target, .host = "h:1"}).location;
  };
  EXPECT_EQ(location("/a?x=1&token=t&y=2"), "/a?x=1&y=2");
  EXPECT_EQ(location("//evil.example/?token=t"), "/evil.example/");
  EXPECT_EQ(location("/\\evil.example/?token=t"), "/evil.example/");
  EXPECT_EQ(location("/\\/\\//evil.example/?token=t"), "/evil.example/");
}

}  // namespace
}  // namespace ganglion::studio
