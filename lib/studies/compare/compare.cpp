#include "studies/compare/compare.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "studies/compare/compare_place.hpp"

namespace kinestat {

namespace {

constexpr double kLargestFinite = std::numeric_limits<double>::max();

// Whether it says something by itself.
bool is_word(const KeptValue& value) {
  return value.type == ValueType::number || value.type == ValueType::text;
}

// The beginning of a place with so many keys.
std::string_view first_keys(std::string_view place, std::size_t count) {
  std::size_t end = 0;
  for (std::size_t i = 0; i < count && end != std::string_view::npos; ++i) {
    end = place.find('/', end + 1);
  }
  return place.substr(0, end);
}

// Every place above the values of a report.
std::unordered_set<std::string_view> places_above(const ReportValues& report) {
  std::unordered_set<std::string_view> places;
  const char* last = nullptr;
  for (const KeptValue& value : report.items()) {
    std::string_view place = value.parent;
    if (std::exchange(last, place.data()) == place.data()) {
      continue;  // neighbours share it
    }
    while (!place.empty() && places.insert(place).second) {
      place = place.substr(0, place.rfind('/'));
    }
  }
  return places;
}

// The largest magnitude of each kind in each case, in SI. A case, a coupling, … is named by the
// first two keys; neighbours mostly have the same.
class Largest {
 public:
  void add(const ReportValues& report) {
    for (const KeptValue& value : report.items()) {
      if (value.type == ValueType::number) {
        const double si = std::abs(report.unit_of(value).scale.to_si(value.number));
        double& largest = largest_of(value, report);
        largest = std::min(std::max(largest, si), kLargestFinite);
      }
    }
  }

  // In the unit of the value.
  double of(const KeptValue& value, const ReportValues& report) {
    const UnitScale& scale = report.unit_of(value).scale;
    return std::min(scale.from_si(largest_of(value, report)), kLargestFinite);
  }

 private:
  using Kinds = std::map<std::string, double, std::less<>>;

  // Of millions of values in one place it is found once for each unit.
  double& largest_of(const KeptValue& value, const ReportValues& report) {
    Kinds& kinds = kinds_at(value);
    if (std::exchange(last_kinds_, &kinds) != &kinds ||
        std::exchange(last_report_, &report) != &report) {
      of_units_.clear();
    }
    if (of_units_.size() <= value.unit) {
      of_units_.resize(value.unit + 1, nullptr);
    }
    double*& largest = of_units_[value.unit];
    if (largest == nullptr) {
      largest = &kinds[report.unit_of(value).kind];
    }
    return *largest;
  }

  Kinds& kinds_at(const KeptValue& value) {
    if (last_ != nullptr && value.parent.data() == last_parent_) {
      return *last_;
    }
    const std::string place = value.place();
    const std::string_view keys = first_keys(place, 2);
    last_ = &by_keys_[std::string(keys)];
    // Directly below the first key each value is named by its own key.
    last_parent_ = keys.size() <= value.parent.size() ? value.parent.data() : nullptr;
    return *last_;
  }

  std::unordered_map<std::string, Kinds> by_keys_;
  const char* last_parent_ = nullptr;
  Kinds* last_ = nullptr;
  const Kinds* last_kinds_ = nullptr;
  const ReportValues* last_report_ = nullptr;
  std::vector<double*> of_units_;  // of these: of each unit of the report
};

// Looks for one value after the other. Two reports mostly have theirs in one order: what follows
// the value that was found last is tried before all places are indexed.
class Finder {
 public:
  explicit Finder(const ReportValues& report) : report_(report) {}

  // Which of the items stands where the value does in its report.
  std::optional<std::size_t> find(const KeptValue& value) {
    const auto position = is_next(value) ? next_ : report_.position_of(value.parent, value.key);
    next_ = position ? *position + 1 : next_;
    return position;
  }

 private:
  bool is_next(const KeptValue& value) const {
    if (next_ >= report_.items().size()) {
      return false;
    }
    const KeptValue& next = report_.items()[next_];
    return next.key == value.key && next.parent == value.parent;
  }

  const ReportValues& report_;
  std::size_t next_ = 0;
};

class Comparer {
 public:
  Comparer(const ReportValues& a, const ReportValues& b, const Tolerances& tolerances)
      : a_(a), b_(b), tolerances_(tolerances) {
    largest_.add(a);
    largest_.add(b);
  }

  ReportComparison run() {
    Finder in_b(b_);
    std::vector<bool> is_in_a(b_.items().size());
    for (const KeptValue& value : a_.items()) {
      if (const auto other = in_b.find(value)) {
        is_in_a[*other] = true;
        ++result_.value_count;
        compare_values(value, b_.items()[*other]);
      } else {
        add_missing(DifferenceType::only_in_a, value);
      }
    }
    for (std::size_t i = 0; i < is_in_a.size(); ++i) {
      if (!is_in_a[i]) {
        add_missing(DifferenceType::only_in_b, b_.items()[i]);
      }
    }
    for (const ToleranceRule& rule : tolerances_.rules) {
      if (rule.is_place() && !is_met(a_, rule.key) && !is_met(b_, rule.key)) {
        result_.unmet_places.push_back(rule.key);
      }
    }
    return std::move(result_);
  }

 private:
  static bool is_met(const ReportValues& values, std::string_view pattern) {
    return std::ranges::any_of(
        values.items(), [&](const KeptValue& value) { return is_within(value.place(), pattern); });
  }

  void compare_values(const KeptValue& a, const KeptValue& b) {
    const bool are_numbers = a.type == ValueType::number && b.type == ValueType::number;
    if (are_numbers) {
      compare_numbers(a, b);
    } else if (a.type != b.type || a.text != b.text) {
      const bool are_words = is_word(a) && is_word(b);
      add(are_words ? DifferenceType::text : DifferenceType::no_value, a.place(), &a, &b);
    }
  }

  void compare_numbers(const KeptValue& a, const KeptValue& b) {
    const ValueUnit& unit = a_.unit_of(a);
    const ValueUnit& other = b_.unit_of(b);
    if (unit.dimension != other.dimension || unit.assumes != other.assumes) {
      add(DifferenceType::unit, a.place(), &a, &b).other_unit = other.text;
      return;
    }
    KeptValue converted = b;
    if (unit.scale != other.scale) {
      converted.number = std::clamp(
          unit.scale.from_si(other.scale.to_si(b.number)), -kLargestFinite, kLargestFinite);
    }
    place_.assign(a.parent).append("/").append(a.key);
    const NumberPair pair{.place = place_,
                          .a = a.number,
                          .b = converted.number,
                          .unit = unit,
                          .largest = largest_.of(a, a_)};
    const double allowed = allowed_difference(pair, tolerances_);
    if (!are_equal(pair, allowed)) {
      Difference& difference = add(DifferenceType::number, a.place(), &a, &converted);
      difference.amount = std::min(std::abs(pair.a - pair.b), kLargestFinite);
      difference.allowed = std::min(allowed, kLargestFinite);
    }
  }

  Difference& add(DifferenceType type,
                  std::string_view place,
                  const KeptValue* a,
                  const KeptValue* b) {
    Difference difference;
    difference.type = type;
    difference.place = place;
    if (b != nullptr) {
      difference.b = b->value();
      difference.unit = b->type == ValueType::number ? b_.unit_of(*b) : ValueUnit{};
    }
    if (a != nullptr) {
      difference.a = a->value();
      difference.unit = a->type == ValueType::number ? a_.unit_of(*a) : difference.unit;
    }
    result_.differences.push_back(std::move(difference));
    return result_.differences.back();
  }

  void add_missing(DifferenceType type, const KeptValue& value) {
    ++result_.value_count;
    const bool is_in_a = type == DifferenceType::only_in_a;
    const KeptValue* a = is_in_a ? &value : nullptr;
    const KeptValue* b = is_in_a ? nullptr : &value;
    const ReportValues& others = is_in_a ? b_ : a_;
    auto& known = is_in_a ? places_above_b_ : places_above_a_;
    if (!known) {
      known = places_above(others);
    }
    const std::string whole = value.place();
    if (known->contains(whole)) {  // one value here, several below it there
      add(is_word(value) ? DifferenceType::text : DifferenceType::no_value, whole, a, b);
      return;
    }
    // What the other lacks as a whole is one difference, at least two keys below the top.
    std::size_t keys = 2;
    while (known->contains(first_keys(whole, keys))) {
      ++keys;
    }
    const std::string_view place = first_keys(whole, keys);
    const std::string_view above = place.substr(0, place.rfind('/'));
    if (others.find(place) != nullptr || others.find(above) != nullptr) {
      return;  // several values here, one there: said of the one
    }
    const auto [at, is_new] = missing_.emplace(place, result_.differences.size());
    if (is_new) {
      add(type, place, a, b);
    } else {
      ++result_.differences[at->second].count;
    }
  }

  const ReportValues& a_;
  const ReportValues& b_;
  const Tolerances& tolerances_;
  // Needed only if the other report lacks a place.
  std::optional<std::unordered_set<std::string_view>> places_above_a_;
  std::optional<std::unordered_set<std::string_view>> places_above_b_;
  std::string place_;  // of the numbers that are compared
  Largest largest_;
  std::unordered_map<std::string, std::size_t> missing_;  // place, index of its difference
  ReportComparison result_;
};

}  // namespace

std::string_view word_of(DifferenceType type) {
  switch (type) {
    case DifferenceType::number:
      return "number";
    case DifferenceType::text:
      return "text";
    case DifferenceType::no_value:
      return "no value";
    case DifferenceType::unit:
      return "unit";
    case DifferenceType::only_in_a:
      return "only in A";
    case DifferenceType::only_in_b:
      return "only in B";
  }
  return "";
}

ReportComparison compare(const ReportValues& a,
                         const ReportValues& b,
                         const Tolerances& tolerances) {
  return Comparer(a, b, tolerances).run();
}

}  // namespace kinestat
