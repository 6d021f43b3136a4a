#pragma once

#include <string>
#include <string_view>

namespace ganglion::studio {

/// Writes JSON straight into a text, member by member, in the order of the calls.
class JsonText {
 public:
  JsonText& begin_object() { return open('{'); }
  JsonText& end_object() { return close('}'); }
  JsonText& begin_list() { return open('['); }
  JsonText& end_list() { return close(']'); }
  JsonText& key(std::string_view name);
  JsonText& value(std::string_view text);
  JsonText& value(const char* text) { return value(std::string_view(text)); }
  JsonText& value(const std::string& text) { return value(std::string_view(text)); }
  JsonText& value(bool flag);
  JsonText& value(int number);
  /// null for what JSON cannot say: NaN and infinities.
  JsonText& value(double number);
  JsonText& null() { return raw("null"); }
  /// JSON made elsewhere.
  JsonText& raw(std::string_view json);
  template <class T>
  JsonText& member(std::string_view name, const T& what) {
    return key(name).value(what);
  }

  std::string take() noexcept { return std::move(text_); }

 private:
  JsonText& open(char bracket);
  JsonText& close(char bracket);
  void separate();
  void write_string(std::string_view text);

  std::string text_;
  bool first_ = true;
};

}  // namespace ganglion::studio
