#include "mechanism/gears/planet_question.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "description/gear_expansion.hpp"
#include "description/number_range.hpp"
#include "mechanism/bind/slot_number.hpp"
#include "mechanism/gears/internal/planet_spacing.hpp"

namespace kinestat {

/// The description stays where it is, as the train points into it.
struct PlanetQuestion::Train {
  MechanismDescription description;
  GearTrain train;
  PlanetSet set;
};

namespace {

// A number of the section that parameters may move.
struct SlotNumber {
  SlotExpression value;
  QuantityKind kind = QuantityKind::dimensionless;
  NumberRange range;
};

class SlotNumbers {
 public:
  SlotNumbers(const FileUnits& units, const SlotOf& slot_of) : units_(units), slot_of_(slot_of) {}

  std::size_t add(const Value& value, QuantityKind kind, const NumberRange& range) {
    numbers_.push_back(
        {.value = SlotExpression(value.expression, slot_of_), .kind = kind, .range = range});
    return numbers_.size() - 1;
  }

  std::vector<int> slots() const {
    std::vector<int> all;
    for (const SlotNumber& one : numbers_) {
      all.insert(all.end(), one.value.slots().begin(), one.value.slots().end());
    }
    return all;
  }

  // Empty where it has no value, or one that bind refuses.
  std::optional<double> number(std::size_t i,
                               const Slots& slots,
                               std::vector<Quantity>& scratch) const {
    const SlotNumber& one = numbers_[i];
    const auto value = slot_number(one.value, one.kind, units_, slots, scratch);
    return value && one.range.holds(*value) ? value : std::nullopt;
  }

 private:
  FileUnits units_;
  SlotOf slot_of_;
  std::vector<SlotNumber> numbers_;
};

// A number of GearNumbers and where its value comes from.
struct NumberSource {
  std::size_t index = 0;   // of the member, mesh or axis
  std::size_t number = 0;  // of SlotNumbers
};

class PlanetAnswer {
 public:
  PlanetAnswer(const MechanismDescription& description,
               const GearTrain& train,
               const PlanetSet& set,
               bool is_of_assembly,
               const SlotOf& slot_of)
      : gears_(*description.gears),
        train_(train),
        set_(set),
        is_of_assembly_(is_of_assembly),
        numbers_(description.units, slot_of) {
    count_ = numbers_.add(*set.counted->count, QuantityKind::dimensionless, kPlanets);
    for (std::size_t m = 0; m < gears_.members.size(); ++m) {
      if (!is_of_assembly || is_in_mesh_of_set(static_cast<int>(m))) {
        teeth_.push_back(
            {.index = m,
             .number = numbers_.add(gears_.members[m].teeth, QuantityKind::dimensionless, kTeeth)});
      }
    }
    if (!is_of_assembly) {
      add_lengths();
    }
  }

  std::vector<int> slots() const { return numbers_.slots(); }

  std::optional<bool> holds(const Slots& slots, std::vector<Quantity>& scratch) const {
    const std::optional<double> count = numbers_.number(count_, slots, scratch);
    const std::optional<GearNumbers> numbers = find_numbers(slots, scratch);
    if (!count || !numbers) {
      return std::nullopt;
    }
    PlanetSet set = set_;
    set.count = static_cast<int>(std::lround(*count));
    if (set.count == 1) {
      return true;
    }
    if (is_of_assembly_) {
      return blocking_sum(set, assembly_sums(set, train_, *numbers)) == 0;
    }
    const std::optional<GearLayout> layout =
        rings_fit(train_, *numbers) ? find_layout<double>(train_, *numbers) : std::nullopt;
    return layout ? std::optional(find_touching(set, *layout, *numbers).empty()) : std::nullopt;
  }

 private:
  bool is_in_mesh_of_set(int member) const {
    const auto is_planet = [&](int one) {
      return std::ranges::find(set_.planets, train_.axis_of[static_cast<std::size_t>(one)]) !=
             set_.planets.end();
    };
    for (std::size_t m = 0; m < train_.first.size(); ++m) {
      const bool is_member = train_.first[m] == member || train_.second[m] == member;
      if (is_member && (is_planet(train_.first[m]) || is_planet(train_.second[m]))) {
        return true;
      }
    }
    return false;
  }

  void add_lengths() {
    for (std::size_t m = 0; m < gears_.meshes.size(); ++m) {
      const std::optional<Value>& module =
          gears_.meshes[m].module ? gears_.meshes[m].module : gears_.module;
      if (module) {
        modules_.push_back(
            {.index = m, .number = numbers_.add(*module, QuantityKind::length, kAboveZero)});
      }
    }
    for (std::size_t a = 0; a < train_.axes.size(); ++a) {
      if (const Value* distance = train_.axes[a].distance) {
        distances_.push_back(
            {.index = a, .number = numbers_.add(*distance, QuantityKind::length, kAboveZero)});
      }
    }
  }

  std::optional<GearNumbers> find_numbers(const Slots& slots,
                                          std::vector<Quantity>& scratch) const {
    GearNumbers result;
    result.teeth.resize(gears_.members.size());
    result.module.resize(gears_.meshes.size());
    result.at.resize(gears_.meshes.size());
    result.distance.resize(train_.axes.size());
    for (const NumberSource& one : teeth_) {
      const auto teeth = numbers_.number(one.number, slots, scratch);
      if (!teeth) {
        return std::nullopt;
      }
      result.teeth[one.index] = gears_.members[one.index].internal ? -*teeth : *teeth;
    }
    const auto fill = [&](const std::vector<NumberSource>& sources,
                          std::vector<std::optional<double>>& lengths) {
      return std::ranges::all_of(sources, [&](const NumberSource& one) {
        lengths[one.index] = numbers_.number(one.number, slots, scratch);
        return lengths[one.index].has_value();
      });
    };
    return fill(modules_, result.module) && fill(distances_, result.distance)
               ? std::optional(std::move(result))
               : std::nullopt;
  }

  const GearsDescription& gears_;
  const GearTrain& train_;
  PlanetSet set_;
  bool is_of_assembly_;
  SlotNumbers numbers_;
  std::size_t count_ = 0;
  std::vector<NumberSource> teeth_;
  std::vector<NumberSource> modules_;
  std::vector<NumberSource> distances_;
};

// Of a member or a body; -1: the main axis, empty: there is none of that name.
std::optional<int> axis_named(std::string_view name,
                              const GearsDescription& gears,
                              const GearTrain& train) {
  for (std::size_t m = 0; m < gears.members.size(); ++m) {
    if (gears.members[m].name.text == name) {
      return train.axis_of[m];
    }
  }
  const auto of_body = [&](const GearMember& one) { return one.body.text == name; };
  return std::ranges::any_of(gears.members, of_body) ? std::optional(train.axis_on(name))
                                                     : std::nullopt;
}

}  // namespace

std::variant<PlanetQuestion, PlanetQuestion::Fault> PlanetQuestion::make(
    std::string_view word, std::string_view of, const MechanismDescription& description) {
  const std::string call = fmt::format("{}({})", word, of);
  if (!description.gears) {
    return Fault{
        .message = fmt::format(
            "'{}' needs planets of the section 'gears', which the file does not have", call),
        .hint =
            "write the train in 'gears', or the condition in numbers of teeth, "
            "mod(Ns + Nr, 3) == 0"};
  }
  auto asked = std::make_shared<Train>(Train{.description = description, .train = {}, .set = {}});
  asked->train = find_gear_train(asked->description);
  const GearsDescription& gears = *asked->description.gears;
  const std::optional<int> axis = axis_named(of, gears, asked->train);
  if (!axis) {
    return Fault{.message = fmt::format("'{}' names '{}', which is not a gear member", call, of),
                 .hint = "name a planet among the members of 'gears', or its body"};
  }
  Diagnostics ignored;
  Evaluator evaluator = make_evaluator(asked->description, ignored);
  for (PlanetSet& set : bind_planet_sets(gears, asked->train, evaluator)) {
    if (std::ranges::find(set.planets, *axis) != set.planets.end() && set.counted != nullptr) {
      asked->set = std::move(set);
      PlanetQuestion question;
      question.is_of_assembly_ = word == kAssembles;
      question.train_ = std::move(asked);
      return question;
    }
  }
  return Fault{.message = *axis < 0
                              ? fmt::format("'{}' names '{}', which is not a planet", call, of)
                              : fmt::format("'{}' names '{}', which has no 'count'", call, of),
               .hint = *axis < 0 ? "name a planet among the members of 'gears', or its body"
                                 : "add how many planets there are, 'count: 3'"};
}

SlotAnswer PlanetQuestion::with_slots(const SlotOf& slot_of) const {
  const auto answer = std::make_shared<const PlanetAnswer>(
      train_->description, train_->train, train_->set, is_of_assembly_, slot_of);
  return {.slots = answer->slots(),
          .holds = [answer, kept = train_](const Slots& slots, std::vector<Quantity>& scratch) {
            return answer->holds(slots, scratch);
          }};
}

}  // namespace kinestat
