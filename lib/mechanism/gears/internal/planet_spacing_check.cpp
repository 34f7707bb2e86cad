#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "mechanism/gears/internal/gear_train_check.hpp"
#include "mechanism/gears/internal/planet_assembly.hpp"
#include "mechanism/gears/internal/planet_set.hpp"

namespace kinestat {

namespace {

constexpr int kMostCount = 64;  // that the file may say

class PlanetSpacingCheck {
 public:
  PlanetSpacingCheck(const SectionContext& context,
                     const GearNumbers& numbers,
                     const GearLayout& layout)
      : context_(context),
        gears_(*context.description.gears),
        numbers_(numbers),
        train_(layout.train),
        layout_(layout) {}

  void run() {
    for (const PlanetSet& set : bind_planet_sets(gears_, train_, context_.evaluator)) {
      if (check_counts(set) && set.count > 1) {
        check_assembly(set);
        check_neighbours(set);
      }
    }
  }

 private:
  const GearMember& member(int index) const {
    return gears_.members[static_cast<std::size_t>(index)];
  }

  int axis_of(int member) const { return train_.axis_of[static_cast<std::size_t>(member)]; }

  long long teeth(int member) const {
    return std::llround(numbers_.teeth[static_cast<std::size_t>(member)]);
  }

  // One set stands for all, so that its planets have one count.
  bool check_counts(const PlanetSet& set) {
    for (const int p : set.planets) {
      for (const int m : train_.axes[static_cast<std::size_t>(p)].members) {
        if (member(m).count && number_of(*member(m).count) != set.count) {
          refuse_unlike(*set.counted, member(m), &GearMember::count);
          return false;
        }
        if (member(m).load_sharing && sharing_of(*member(m).load_sharing) != set.load_sharing) {
          refuse_unlike(*set.shared, member(m), &GearMember::load_sharing);
          return false;
        }
      }
    }
    return true;
  }

  void refuse_unlike(const GearMember& first,
                     const GearMember& second,
                     std::optional<Value> GearMember::*key) {
    const bool is_count = key == &GearMember::count;
    const auto text_of = [&](const GearMember& one) {
      return is_count ? fmt::format("{}", number_of(*(one.*key)))
                      : fmt::format("{:.6g}", sharing_of(*(one.*key)));
    };
    context_.found.error(
        "E0314",
        (second.*key)->where,
        fmt::format("planets '{}' and '{}' belong to one set, but their {} are {} and {}",
                    first.name.text,
                    second.name.text,
                    is_count ? "counts" : "load_sharing",
                    text_of(first),
                    text_of(second)),
        fmt::format("planets of one body or in mesh with each other stand round the main axis "
                    "together: write the same '{}', or only one",
                    is_count ? "count" : "load_sharing"));
  }

  double sharing_of(const Value& value) const {
    return context_.evaluator.number(value, QuantityKind::dimensionless).value_or(1.0);
  }

  int number_of(const Value& count) const {
    const auto number = context_.evaluator.number(count, QuantityKind::dimensionless);
    return static_cast<int>(std::lround(number.value_or(1.0)));
  }

  std::vector<AssemblyMesh> meshes_of(const PlanetSet& set) const {
    std::vector<AssemblyMesh> result;
    const auto place = [&](int member) {
      const auto at = std::ranges::find(set.planets, axis_of(member));
      return at == set.planets.end() ? -1 : static_cast<int>(at - set.planets.begin());
    };
    for (std::size_t m = 0; m < gears_.meshes.size(); ++m) {
      int planet = train_.first[m];
      int mate = train_.second[m];
      if (place(planet) < 0) {
        std::swap(planet, mate);
      }
      if (place(planet) >= 0) {
        result.push_back({.planet = place(planet),
                          .teeth = teeth(planet),
                          .mate = place(mate),
                          .mate_teeth = teeth(mate)});
      }
    }
    return result;
  }

  // "24 + 60" of a sun and a ring, else the number itself.
  static std::string sum_in_teeth(const std::vector<AssemblyMesh>& meshes, long long teeth) {
    const bool is_plain = meshes.size() == 2 && meshes[0].mate < 0 && meshes[1].mate < 0 &&
                          meshes[0].teeth == meshes[1].teeth;
    return is_plain
               ? fmt::format(
                     "({} + {})", std::abs(meshes[0].mate_teeth), std::abs(meshes[1].mate_teeth))
               : fmt::format("{}", teeth);
  }

  // More planets in a chain than any transmission has would outgrow whole numbers.
  void check_assembly(const PlanetSet& set) const {
    constexpr std::size_t kMostPlanets = 3;
    const std::size_t planets = set.planets.size();
    if (planets > kMostPlanets) {
      return;
    }
    const std::vector<AssemblyMesh> meshes = meshes_of(set);
    const std::vector<long long> sums = assembly_teeth(meshes, static_cast<int>(planets));
    const auto blocking =
        std::ranges::find_if(sums, [&](long long sum) { return sum % set.count != 0; });
    if (blocking == sums.end()) {
      return;
    }
    context_.found.warning(
        "W0306",
        set.counted->count->where,
        fmt::format("{} planets '{}' cannot stand at equal angles: {}/{} = {:.6g} is not whole",
                    set.count,
                    set.counted->name.text,
                    sum_in_teeth(meshes, *blocking),
                    set.count,
                    static_cast<double>(*blocking) / set.count),
        fitting_counts(sums));
  }

  static std::string fitting_counts(const std::vector<long long>& sums) {
    std::string list;
    for (int n = 2; n <= kMostCount; ++n) {
      if (std::ranges::all_of(sums, [&](long long sum) { return sum % n == 0; })) {
        list += fmt::format("{}{}", list.empty() ? "" : ", ", n);
      }
    }
    return list.empty() ? "no count of planets can with these teeth; change a number of teeth"
                        : fmt::format("with these teeth {} can; or change a number of teeth", list);
  }

  // The radius of the tip circle of a member, with the module of one of its meshes.
  double tip_radius(int member) const {
    for (std::size_t m = 0; m < gears_.meshes.size(); ++m) {
      if (train_.first[m] == member || train_.second[m] == member) {
        const auto sum = static_cast<double>(teeth(train_.first[m]) + teeth(train_.second[m]));
        const double module =
            numbers_.module[m].value_or(2.0 * layout_.meshes[m].distance / std::abs(sum));
        return 0.5 * module * (static_cast<double>(teeth(member)) + 2.0);
      }
    }
    return 0.0;
  }

  void check_neighbours(const PlanetSet& set) {
    for (const int p : set.planets) {
      for (const int m : train_.axes[static_cast<std::size_t>(p)].members) {
        check_pair(m, m, set);
      }
    }
    for (std::size_t m = 0; m < gears_.meshes.size(); ++m) {
      const int a = train_.first[m];
      const int b = train_.second[m];
      const bool is_in_set = std::ranges::find(set.planets, axis_of(a)) != set.planets.end();
      if (is_in_set && axis_of(b) >= 0) {
        check_pair(a, b, set);
      }
    }
  }

  // A planet against another of the next sets on either side, or against its own like.
  void check_pair(int a, int b, const PlanetSet& set) {
    const Vec3& centre_a = layout_.centres[static_cast<std::size_t>(axis_of(a))];
    const Vec3& centre_b = layout_.centres[static_cast<std::size_t>(axis_of(b))];
    const double angle = 2.0 * std::numbers::pi / set.count;
    double distance = std::numeric_limits<double>::infinity();
    for (const double turn : {angle, -angle}) {
      const Vec3 next = Eigen::AngleAxisd(turn, Vec3::UnitZ()) * centre_b;
      distance = std::min(distance, (next - centre_a).norm());
    }
    const double needed = tip_radius(a) + tip_radius(b);
    if (distance > needed) {
      return;
    }
    const FileUnits& units = context_.description.units;
    const auto length = [&](double metres) {
      return fmt::format("{:.6g} {}",
                         units.from_si(QuantityKind::length, metres),
                         units.text(QuantityKind::length));
    };
    const std::string names =
        a == b ? fmt::format("'{}'", member(a).name.text)
               : fmt::format("'{}' and '{}'", member(a).name.text, member(b).name.text);
    context_.found.warning(
        "W0307",
        set.counted->count->where,
        fmt::format("of {} planets {}, neighbours touch: {} between centres, {} between tips in "
                    "contact",
                    set.count,
                    names,
                    length(distance),
                    length(needed)),
        "lower 'count', or give the planets fewer teeth and the gears on the main axis more");
  }

  const SectionContext& context_;
  const GearsDescription& gears_;
  const GearNumbers& numbers_;
  const GearTrain& train_;
  const GearLayout& layout_;
};

}  // namespace

void check_planet_spacing(const SectionContext& context,
                          const GearNumbers& numbers,
                          const GearLayout& layout) {
  PlanetSpacingCheck(context, numbers, layout).run();
}

}  // namespace kinestat
