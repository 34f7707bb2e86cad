// Style and script of a page, and the policy that lets nothing else take effect.
#pragma once

#include <string>
#include <string_view>

namespace kinestat {

/// The only style of a page: the palette of the pictures, light and dark, and its own rules.
std::string page_style();

/// The only script.
std::string_view page_script();

/// The content security policy: nothing is loaded from anywhere; of style and script only those
/// with these texts count.
std::string content_policy(std::string_view style, std::string_view script);

}  // namespace kinestat
