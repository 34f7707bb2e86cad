// SHA-256 of a text, as content security policies name it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace kinestat {

/// The digest of FIPS 180-4.
std::array<std::uint8_t, 32> sha256(std::string_view text);

/// RFC 4648, with padding.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace kinestat
