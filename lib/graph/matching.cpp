#include "graph/matching.hpp"

namespace kinestat {

namespace {

class Matcher {
 public:
  Matcher(const Offers& offers, int offer_count)
      : offers_(offers), demand_of_(static_cast<std::size_t>(offer_count)) {}

  std::vector<std::optional<int>> run() {
    for (std::size_t d = 0; d < offers_.size(); ++d) {
      if (!serve_directly(d)) {
        serve_by_exchange(d);
      }
    }
    std::vector<std::optional<int>> offer_of(offers_.size());
    for (std::size_t o = 0; o < demand_of_.size(); ++o) {
      if (demand_of_[o]) {
        offer_of[*demand_of_[o]] = static_cast<int>(o);
      }
    }
    return offer_of;
  }

 private:
  bool serve_directly(std::size_t demand) {
    for (const int o : offers_[demand]) {
      std::optional<std::size_t>& taken = demand_of_[static_cast<std::size_t>(o)];
      if (!taken) {
        taken = demand;
        return true;
      }
    }
    return false;
  }

  // Breadth first: which offer is reached from which demand, until one is free; then the demands on
  // the way take over the offers one after the other.
  void serve_by_exchange(std::size_t demand) {
    std::vector<std::optional<std::size_t>> reached_from(demand_of_.size());
    std::vector<std::size_t> waiting = {demand};
    for (std::size_t next = 0; next < waiting.size(); ++next) {
      for (const int o : offers_[waiting[next]]) {
        const auto offer = static_cast<std::size_t>(o);
        if (reached_from[offer]) {
          continue;
        }
        reached_from[offer] = waiting[next];
        if (!demand_of_[offer]) {
          take_over(offer, demand, reached_from);
          return;
        }
        waiting.push_back(*demand_of_[offer]);
      }
    }
  }

  void take_over(std::size_t offer,
                 std::size_t last,
                 const std::vector<std::optional<std::size_t>>& reached_from) {
    while (true) {
      const std::size_t demand = *reached_from[offer];
      std::size_t given_up = offer;
      for (const int o : offers_[demand]) {
        if (demand_of_[static_cast<std::size_t>(o)] == demand) {
          given_up = static_cast<std::size_t>(o);
        }
      }
      demand_of_[offer] = demand;
      if (demand == last) {
        return;
      }
      offer = given_up;
    }
  }

  const Offers& offers_;
  std::vector<std::optional<std::size_t>> demand_of_;  ///< of each offer
};

}  // namespace

std::vector<std::optional<int>> find_matching(const Offers& offers, int offer_count) {
  return Matcher(offers, offer_count).run();
}

}  // namespace kinestat
