// What other programs and books call the things of a mechanism file.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace kinestat {

/// The candidate that is meant by a word: a synonym of it ("joints" for couplings, "hinge" for
/// revolute), else the one that a typist most likely meant (nearest_name). Empty if there is none.
std::string meant_name(std::string_view word, std::span<const std::string> candidates);

/// "did you mean 'revolute'?" or empty, from meant_name.
std::string did_you_mean_word(std::string_view word, std::span<const std::string> candidates);

}  // namespace kinestat
