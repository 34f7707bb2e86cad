#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mechanism/gears/internal/gear_train_check.hpp"
#include "mechanism/gears/internal/planet_spacing.hpp"

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

  // One set stands for all, so that its planets have one count, and share loads in one way.
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
        fmt::format("planets of one body, or in mesh with each other, are arranged around the main "
                    "axis together: write the same '{}', or only one",
                    is_count ? "count" : "load_sharing"));
  }

  double sharing_of(const Value& value) const {
    return context_.evaluator.number(value, QuantityKind::dimensionless).value_or(1.0);
  }

  int number_of(const Value& count) const {
    const auto number = context_.evaluator.number(count, QuantityKind::dimensionless);
    return static_cast<int>(std::lround(number.value_or(1.0)));
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

  void check_assembly(const PlanetSet& set) const {
    const std::vector<long long> sums = assembly_sums(set, train_, numbers_);
    const long long blocking = blocking_sum(set, sums);
    if (blocking == 0) {
      return;
    }
    const std::vector<AssemblyMesh> meshes = assembly_meshes(set, train_, numbers_);
    context_.found.warning(
        "W0306",
        set.counted->count->where,
        fmt::format(
            "{} planets '{}' cannot be equally spaced: {}/{} = {:.6g} is not a whole number",
            set.count,
            set.counted->name.text,
            sum_in_teeth(meshes, blocking),
            set.count,
            static_cast<double>(blocking) / set.count),
        fitting_counts(set, sums));
  }

  // Planets that would touch their neighbours fit no more than others.
  std::string fitting_counts(PlanetSet set, const std::vector<long long>& sums) const {
    std::string list;
    for (int n = 2; n <= kMostCount; ++n) {
      set.count = n;
      if (std::ranges::all_of(sums, [&](long long sum) { return sum % n == 0; }) &&
          find_touching(set, layout_, numbers_).empty()) {
        list += fmt::format("{}{}", list.empty() ? "" : ", ", n);
      }
    }
    return list.empty() ? "no count of planets can with these teeth; change a number of teeth"
                        : fmt::format("with these teeth {} can; or change a number of teeth", list);
  }

  void check_neighbours(const PlanetSet& set) {
    for (const NeighbourPlanets& pair : find_touching(set, layout_, numbers_)) {
      warn_of(pair, set);
    }
  }

  void warn_of(const NeighbourPlanets& pair, const PlanetSet& set) {
    const std::string& first = member(pair.first).name.text;
    const std::string& second = member(pair.second).name.text;
    const FileUnits& units = context_.description.units;
    const auto length = [&](double metres) {
      return fmt::format("{:.6g} {}",
                         units.from_si(QuantityKind::length, metres),
                         units.text(QuantityKind::length));
    };
    const std::string names = pair.first == pair.second
                                  ? fmt::format("'{}'", first)
                                  : fmt::format("'{}' and '{}'", first, second);
    context_.found.warning(
        "W0307",
        set.counted->count->where,
        fmt::format("of {} planets {}, neighbours touch: {} between centres, {} between tips in "
                    "contact",
                    set.count,
                    names,
                    length(pair.distance),
                    length(pair.needed)),
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
