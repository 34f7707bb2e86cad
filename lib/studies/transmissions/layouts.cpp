#include "studies/transmissions/layouts.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace kinestat {

namespace {

std::uint64_t binomial(int n, int k) {
  std::uint64_t result = 1;
  for (int i = 1; i <= k; ++i) {
    result = result * static_cast<std::uint64_t>(n - k + i) / static_cast<std::uint64_t>(i);
  }
  return result;
}

class LayoutSearch {
 public:
  LayoutSearch(const GenericTrain& train, int elements, int least_gears, int free_shafts)
      : train_(train),
        elements_(elements),
        least_gears_(least_gears),
        states_(binomial(elements, train.engaged())) {
    for (const VertexMap& automorphism : train.structure().automorphisms) {
      maps_.push_back(train.class_map(automorphism));
    }
    for (int f = 0; f < free_shafts; ++f) {
      free_classes_.push_back(classes_at(static_cast<Shaft>(train.structure().shafts - 1 - f)));
    }
    extend(0, 0, 0, 0);
  }

  std::vector<TransmissionLayout> take() { return std::move(found_); }

 private:
  ClassMask classes_at(Shaft shaft) const {
    ClassMask mask = 0;
    for (std::size_t c = 0; c < train_.classes().size(); ++c) {
      for (const ShaftPair& pair : train_.classes()[c]) {
        mask |= pair[0] == shaft || pair[1] == shaft ? ClassMask{1} << c : 0;
      }
    }
    return mask;
  }

  // Adds classes from `first` on, as long as enough states are gears.
  void extend(ClassMask chosen, int count, std::size_t first, std::uint64_t not_gears) {
    if (count == elements_) {
      finish(chosen);
      return;
    }
    const std::size_t classes = train_.classes().size();
    for (std::size_t c = first; c + static_cast<std::size_t>(elements_ - count) <= classes; ++c) {
      const std::uint64_t failed = not_gears + not_gears_with(chosen, ClassMask{1} << c);
      if (failed + static_cast<std::uint64_t>(least_gears_) <= states_) {
        extend(chosen | ClassMask{1} << c, count + 1, c + 1, failed);
      }
    }
  }

  // How many states of a new class with chosen ones are no gears.
  std::uint64_t not_gears_with(ClassMask chosen, ClassMask added) const {
    std::uint64_t count = 0;
    for_each_subset(chosen, train_.engaged() - 1, added, [&](ClassMask engaged) {
      count += train_.states()[train_.state_of(engaged)].is_gear ? 0 : 1;
    });
    return count;
  }

  template <class Visit>
  static void for_each_subset(ClassMask from, int size, ClassMask with, const Visit& visit) {
    if (size == 0) {
      visit(with);
      return;
    }
    for (ClassMask rest = from; std::popcount(rest) >= size;) {
      const ClassMask lowest = rest & -rest;
      rest ^= lowest;
      for_each_subset(rest, size - 1, with | lowest, visit);
    }
  }

  void finish(ClassMask classes) {
    TransmissionLayout layout{.classes = classes, .gears = {}, .automorphisms = {}};
    if (!keep_least(layout)) {
      return;
    }
    for (const ClassMask at_free : free_classes_) {
      if (std::popcount(classes & at_free) < 3) {
        return;
      }
    }
    for_each_subset(classes, train_.engaged(), 0, [&](ClassMask engaged) {
      const std::size_t state = train_.state_of(engaged);
      if (train_.states()[state].is_gear) {
        layout.gears.push_back(
            {.state = static_cast<std::uint32_t>(state), .elements = places_in(classes, engaged)});
      }
    });
    if (has_use(layout)) {
      found_.push_back(std::move(layout));
    }
  }

  // Whether no automorphism makes a lesser mask of it; notes those that keep it.
  bool keep_least(TransmissionLayout& layout) const {
    for (std::size_t i = 0; i < maps_.size(); ++i) {
      ClassMask image = 0;
      for (ClassMask rest = layout.classes; rest != 0; rest &= rest - 1) {
        image |= ClassMask{1} << maps_[i][static_cast<std::size_t>(std::countr_zero(rest))];
      }
      if (image < layout.classes) {
        return false;
      }
      if (image == layout.classes) {
        layout.automorphisms.push_back(i);
      }
    }
    return true;
  }

  static std::uint8_t places_in(ClassMask classes, ClassMask engaged) {
    std::uint8_t places = 0;
    for (int place = 0; classes != 0; ++place, classes &= classes - 1) {
      places |= static_cast<std::uint8_t>((engaged & classes & -classes) != 0 ? 1U << place : 0U);
    }
    return places;
  }

  bool has_use(TransmissionLayout& layout) const {
    std::vector<std::uint32_t> ratios;
    for (const LayoutGear& gear : layout.gears) {
      ratios.push_back(train_.states()[gear.state].ratio);
    }
    std::ranges::sort(ratios);
    layout.distinct_gears =
        static_cast<int>(std::unique(ratios.begin(), ratios.end()) - ratios.begin());
    return layout.distinct_gears >= least_gears_ && !layout.gears.empty() &&
           all_have_use(train_, elements_, layout.gears);
  }

  const GenericTrain& train_;
  int elements_;
  int least_gears_;
  std::uint64_t states_;
  std::vector<std::vector<std::uint8_t>> maps_;
  std::vector<ClassMask> free_classes_;
  std::vector<TransmissionLayout> found_;
};

}  // namespace

bool all_have_use(const GenericTrain& train, int elements, std::span<const LayoutGear> gears) {
  unsigned in_some = 0;
  unsigned in_all = ~0U;
  unsigned sets_in_use = 0;
  const auto& first = train.states()[gears.front().state].change;
  for (const LayoutGear& gear : gears) {
    in_some |= gear.elements;
    in_all &= gear.elements;
    const auto& change = train.states()[gear.state].change;
    for (std::size_t s = 0; s < change.size(); ++s) {
      sets_in_use |= change[s] != first[s] ? 1U << s : 0U;
    }
  }
  return in_all == 0 && in_some == (1U << elements) - 1 &&
         sets_in_use == (1U << train.structure().set_count()) - 1;
}

std::vector<TransmissionLayout> find_layouts(const GenericTrain& train,
                                             int elements,
                                             int least_gears,
                                             int free_shafts) {
  return LayoutSearch(train, elements, least_gears, free_shafts).take();
}

std::vector<ElementPlacement> placements_of(const GenericTrain& train,
                                            const TransmissionLayout& layout) {
  std::vector<ElementPlacement> found = {{}};
  for (ClassMask rest = layout.classes; rest != 0; rest &= rest - 1) {
    std::vector<ElementPlacement> longer;
    for (const ElementPlacement& one : found) {
      for (const ShaftPair& pair :
           train.classes()[static_cast<std::size_t>(std::countr_zero(rest))]) {
        longer.push_back(one);
        longer.back().push_back(pair);
      }
    }
    found = std::move(longer);
  }
  const auto is_least = [&](const ElementPlacement& placement) {
    ElementPlacement sorted = placement;
    std::ranges::sort(sorted);
    return std::ranges::none_of(layout.automorphisms, [&](std::size_t which) {
      const VertexMap& map = train.structure().automorphisms[which];
      ElementPlacement image;
      for (const ShaftPair& pair : placement) {
        const auto [a, b] = std::minmax({map[pair[0]], map[pair[1]]});
        image.push_back({a, b});
      }
      std::ranges::sort(image);
      return image < sorted;
    });
  };
  std::erase_if(found, [&](const ElementPlacement& one) { return !is_least(one); });
  return found;
}

}  // namespace kinestat
