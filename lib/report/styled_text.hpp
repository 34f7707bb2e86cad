// Text with styles that a terminal may show.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kinestat {

enum class LineStyle { heading, error, warning, hint };

/// The text as a terminal shows it in that style.
std::string styled(std::string_view text, LineStyle style);

/// Text of which some parts have a style.
class StyledText {
 public:
  StyledText() = default;

  StyledText(std::string plain) : text_(std::move(plain)) {}  // NOLINT: plain text is text

  StyledText& operator+=(const std::string& plain);
  StyledText& operator+=(const StyledText& more);

  void add(std::string_view text, LineStyle style);

  /// Without styles.
  const std::string& plain() const { return text_; }

  /// With them.
  std::string coloured() const;

 private:
  struct Span {
    std::size_t begin = 0;
    std::size_t size = 0;
    LineStyle style = LineStyle::heading;
  };

  std::string text_;
  std::vector<Span> spans_;  // in the order of the text
};

}  // namespace kinestat
