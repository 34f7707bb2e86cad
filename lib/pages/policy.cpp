#include "pages/policy.hpp"

#include <fmt/format.h>

#include "core/sha256.hpp"
#include "draw/palette.hpp"
#include "pages/embedded.hpp"

namespace kinestat {

namespace {

std::string source_of(std::string_view text) {
  return fmt::format("'sha256-{}'", base64(sha256(text)));
}

}  // namespace

std::string page_style() {
  // Paper is light, whatever the reader prefers on a screen.
  return fmt::format(
      ":root{{{0}}}\n"
      "@media screen and (prefers-color-scheme:dark){{:root:not([data-theme=light]){{{1}}}}}\n"
      "@media screen{{:root[data-theme=dark]{{{1}}}}}\n{2}\n{3}",
      light_variables(),
      dark_variables(),
      ink_rules(),
      find_text(embedded_page(), "style")->text);
}

std::string_view page_script() {
  return find_text(embedded_page(), "script")->text;
}

std::string content_policy(std::string_view style, std::string_view script) {
  return fmt::format(
      "default-src 'none'; style-src {}; script-src {}; img-src data:; base-uri 'none'; "
      "form-action 'none'",
      source_of(style),
      source_of(script));
}

}  // namespace kinestat
