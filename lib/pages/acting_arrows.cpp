#include "pages/acting_arrows.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "pages/html.hpp"

namespace kinestat {

namespace {

// Of places so many digits are less than a tenth of a pixel, of values what is shown.
constexpr int kPlaceDigits = 5;
constexpr int kValueDigits = 5;

std::string_view group_of(ArrowKind kind) {
  switch (kind) {
    case ArrowKind::reaction:
      return "coupling";
    case ArrowKind::load:
      return "load";
    default:
      return "drive";
  }
}

void add_numbers(const Vec3& vector,
                 std::span<const int> components,
                 double scale,
                 int digits,
                 std::vector<std::string>& to) {
  for (const int i : components) {
    to.push_back(fmt::format("{:.{}g}", scale * vector[i], digits));
  }
}

std::string json_list(const std::vector<std::string>& items) {
  return fmt::format("[{}]", fmt::join(items, ","));
}

class ArrowWriter {
 public:
  explicit ArrowWriter(const Analysis& analysis)
      : is_planar_(analysis.mechanism.space == Space::planar), units_(analysis.description.units) {}

  std::string json(const ActingArrow& arrow) const {
    const QuantityKind kind = arrow.is_axial ? QuantityKind::moment : QuantityKind::force;
    const double scale = units_.from_si(kind, 1.0);
    const std::optional<Vec3> place = common_place(arrow);
    std::vector<std::string> steps;
    for (const std::optional<PlacedVector>& one : arrow.at) {
      std::vector<std::string> numbers;
      if (one) {
        add_numbers(one->vector, vector_axes(arrow), scale, kValueDigits, numbers);
      }
      if (one && !place) {
        add_numbers(one->at, place_axes(), 1.0, kPlaceDigits, numbers);
      }
      steps.push_back(one ? json_list(numbers) : "null");
    }
    std::vector<std::string> fixed;
    if (place) {
      add_numbers(*place, place_axes(), 1.0, kPlaceDigits, fixed);
    }
    return fmt::format(R"({{"name":{},"group":"{}","unit":{},"axial":{},{}"at":{}}})",
                       script_string(arrow.name),
                       group_of(arrow.kind),
                       script_string(units_.text(kind)),
                       arrow.is_axial,
                       place ? fmt::format(R"("place":{},)", json_list(fixed)) : "",
                       json_list(steps));
  }

 private:
  std::span<const int> place_axes() const {
    static constexpr std::array<int, 3> kAxes = {0, 1, 2};
    return std::span(kAxes).first(is_planar_ ? 2 : 3);
  }

  // In the plane couples act about z.
  std::span<const int> vector_axes(const ActingArrow& arrow) const {
    static constexpr std::array<int, 1> kNormal = {2};
    return is_planar_ && arrow.is_axial ? std::span<const int>(kNormal) : place_axes();
  }

  static std::optional<Vec3> common_place(const ActingArrow& arrow) {
    std::optional<Vec3> place;
    for (const std::optional<PlacedVector>& one : arrow.at) {
      if (one && place && one->at != *place) {
        return std::nullopt;
      }
      place = one ? one->at : place;
    }
    return place;
  }

  bool is_planar_;
  const FileUnits& units_;
};

std::string doubts_json(const std::vector<std::string>& doubts) {
  std::vector<std::string> words;
  std::vector<std::size_t> steps;
  for (const std::string& doubt : doubts) {
    const auto known = std::ranges::find(words, doubt);
    const auto at = static_cast<std::size_t>(known - words.begin());
    if (!doubt.empty() && known == words.end()) {
      words.push_back(doubt);
    }
    steps.push_back(doubt.empty() ? 0 : at + 1);
  }
  if (words.empty()) {
    return "";
  }
  std::ranges::transform(words, words.begin(), script_string);
  return fmt::format(R"(,"doubts":[{},[{}]])", json_list(words), fmt::join(steps, ","));
}

// Zero all the time, as the couple of a load that is a force.
bool is_idle(const ActingArrow& arrow) {
  return arrow.kind == ArrowKind::load &&
         std::ranges::all_of(arrow.at, [](const std::optional<PlacedVector>& one) {
           return !one || one->vector.isZero(0.0);
         });
}

}  // namespace

std::string acting_json(const DrawnActions& acting, const Analysis& analysis) {
  const ArrowWriter writer(analysis);
  std::vector<std::string> arrows;
  for (const ActingArrow& arrow : acting.arrows) {
    if (!is_idle(arrow)) {
      arrows.push_back(writer.json(arrow));
    }
  }
  return arrows.empty()
             ? ""
             : fmt::format(
                   R"("acting":[{}]{})", fmt::join(arrows, ",\n"), doubts_json(acting.doubts));
}

}  // namespace kinestat
