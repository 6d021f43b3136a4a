#include "ganglion/exhibit/role.h"

#include <gtest/gtest.h>

#include <set>

namespace ganglion {
namespace {

TEST(Role, IsFoundByItsName) {
  EXPECT_EQ(role_named("given_up"), Role::GivenUp);
  EXPECT_EQ(role_named("GivenUp"), std::nullopt);
  for (const RoleLook& look : role_looks()) EXPECT_EQ(role_named(look.name), look.role) << look.name;
}

TEST(Role, HasWordsOfItsOwnInBothLanguages) {
  std::set<std::string_view> english, spanish;
  for (const RoleLook& look : role_looks()) {
    EXPECT_TRUE(english.insert(look.word.in(Language::English)).second) << look.name;
    EXPECT_TRUE(spanish.insert(look.word.in(Language::Spanish)).second) << look.name;
  }
}

TEST(Role, ThatNoTableKnowsIsDrawnPlain) { EXPECT_EQ(look_of(static_cast<Role>(200)).role, Role::Plain); }

}  // namespace
}  // namespace ganglion
