// What a value of the file is called in messages.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

#include <fmt/format.h>

namespace kinestat {

/// A name such as "'trace' of 'motion'", put together only where a message has it: every value of a
/// file has one, and few are told. What it is made of must live as long.
class Title {
 public:
  using Part = std::variant<std::string_view, std::size_t, const Title*>;

  Title() = default;

  template <std::convertible_to<std::string_view> Text>
  Title(const Text& text) : parts_{std::string_view(text)} {}

  /// The parts fill {0}, {1} and {2} of the pattern.
  Title(std::string_view pattern, Part first, Part second = {}, Part third = {})
      : pattern_(pattern), parts_{first, second, third} {}

  bool empty() const;

  std::string text() const;

 private:
  std::string_view pattern_ = {};  ///< empty: the first part alone
  std::array<Part, 3> parts_ = {};
};

}  // namespace kinestat

template <>
struct fmt::formatter<kinestat::Title> : fmt::formatter<std::string_view> {
  template <class Context>
  auto format(const kinestat::Title& title, Context& context) const {
    return fmt::formatter<std::string_view>::format(title.text(), context);
  }
};
