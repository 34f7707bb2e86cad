#include "mechanism/internal/planet_spacing_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "mechanism/internal/planet_assembly.hpp"

namespace kinestat {

namespace {

constexpr int kMostCount = 64;  // that the file may say

// Planets that mesh with each other, by index; the first stands on +y.
using Chain = std::vector<int>;

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
    for (const Chain& chain : chains()) {
      const GearMember* counted = find_counted(chain);
      const int count = counted == nullptr ? 1 : count_of(*counted);
      if (count > 1) {
        check_assembly(chain, *counted, count);
        check_neighbours(chain, *counted, count);
      }
    }
  }

 private:
  std::vector<Chain> chains() const {
    std::vector<Chain> result;
    for (std::size_t p = 0; p < train_.planets.size(); ++p) {
      if (train_.planets[p].neighbour < 0) {
        result.emplace_back();
      }
      result.back().push_back(static_cast<int>(p));
    }
    return result;
  }

  const GearMember& member(int index) const {
    return gears_.members[static_cast<std::size_t>(index)];
  }

  int planet_of(int member) const { return train_.planet_of[static_cast<std::size_t>(member)]; }

  // The first member of the chain that says how many there are.
  const GearMember* find_counted(const Chain& chain) const {
    for (const int p : chain) {
      for (const int m : train_.planets[static_cast<std::size_t>(p)].members) {
        if (member(m).count) {
          return &member(m);
        }
      }
    }
    return nullptr;
  }

  int count_of(const GearMember& counted) const {
    const auto count = context_.evaluator.number(*counted.count, QuantityKind::dimensionless);
    return static_cast<int>(std::lround(count.value_or(1.0)));
  }

  long long teeth(int member) const {
    return std::llround(numbers_.teeth[static_cast<std::size_t>(member)]);
  }

  std::vector<AssemblyMesh> meshes_of(const Chain& chain) const {
    std::vector<AssemblyMesh> result;
    const auto place = [&](int member) {
      const auto at = std::ranges::find(chain, planet_of(member));
      return at == chain.end() ? -1 : static_cast<int>(at - chain.begin());
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
  void check_assembly(const Chain& chain, const GearMember& counted, int count) const {
    constexpr std::size_t kMostPlanets = 3;
    if (chain.size() > kMostPlanets) {
      return;
    }
    const std::vector<AssemblyMesh> meshes = meshes_of(chain);
    const std::vector<long long> sums = assembly_teeth(meshes, static_cast<int>(chain.size()));
    const auto blocking =
        std::ranges::find_if(sums, [&](long long sum) { return sum % count != 0; });
    if (blocking == sums.end()) {
      return;
    }
    context_.found.warning(
        "W0306",
        counted.count->where,
        fmt::format("{} planets '{}' cannot stand at equal angles: {}/{} = {:.6g} is not whole",
                    count,
                    counted.name.text,
                    sum_in_teeth(meshes, *blocking),
                    count,
                    static_cast<double>(*blocking) / count),
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

  void check_neighbours(const Chain& chain, const GearMember& counted, int count) {
    for (const int p : chain) {
      for (const int m : train_.planets[static_cast<std::size_t>(p)].members) {
        check_pair(m, m, counted, count);
      }
    }
    for (std::size_t m = 0; m < gears_.meshes.size(); ++m) {
      const int a = train_.first[m];
      const int b = train_.second[m];
      const bool is_in_chain = std::ranges::find(chain, planet_of(a)) != chain.end();
      if (is_in_chain && planet_of(b) >= 0) {
        check_pair(a, b, counted, count);
      }
    }
  }

  // A planet against another of the next sets on either side, or against its own like.
  void check_pair(int a, int b, const GearMember& counted, int count) {
    const Vec3& centre_a = layout_.centres[static_cast<std::size_t>(planet_of(a))];
    const Vec3& centre_b = layout_.centres[static_cast<std::size_t>(planet_of(b))];
    const double angle = 2.0 * std::numbers::pi / count;
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
        counted.count->where,
        fmt::format("of {} planets {}, neighbours touch: {} between centres, {} between tips in "
                    "contact",
                    count,
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
