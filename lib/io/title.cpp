#include "io/title.hpp"

#include <type_traits>

namespace kinestat {

namespace {

std::string text_of(const Title::Part& part) {
  return std::visit(
      [](const auto& one) {
        if constexpr (std::is_same_v<decltype(one), const std::size_t&>) {
          return std::to_string(one);
        } else if constexpr (std::is_same_v<decltype(one), const Title* const&>) {
          return one->text();
        } else {
          return std::string(one);
        }
      },
      part);
}

}  // namespace

bool Title::empty() const {
  const auto* text = std::get_if<std::string_view>(&parts_.front());
  return pattern_.empty() && text != nullptr && text->empty();
}

std::string Title::text() const {
  return pattern_.empty() ? text_of(parts_[0])
                          : fmt::format(fmt::runtime(pattern_),
                                        text_of(parts_[0]),
                                        text_of(parts_[1]),
                                        text_of(parts_[2]));
}

}  // namespace kinestat
