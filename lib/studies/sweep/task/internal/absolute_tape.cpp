#include "studies/sweep/task/internal/absolute_tape.hpp"

#include <algorithm>
#include <vector>

#include "core/tolerance.hpp"
#include "math/elimination/elimination_tape.hpp"
#include "power/absolute_efficiency.hpp"
#include "studies/sweep/task/internal/tape_arithmetic.hpp"

namespace kinestat {

namespace {

int sign_of(double value) {
  return value > 0.0 ? 1 : value < 0.0 ? -1 : 0;
}

class AbsoluteRecorder {
 public:
  AbsoluteRecorder(const TapedFlow& flow, LaneRecorder& recorder)
      : flow_(flow),
        topology_(flow.mechanism.topology),
        power_(*flow.solved.power),
        recorder_(recorder),
        zero_(recorder.constant(0.0)) {}

  std::optional<TapeNumber> run() {
    const auto count = static_cast<std::size_t>(topology_.body_count());
    given_.assign(count, zero_);
    enters_.assign(count, zero_);
    leaves_.assign(count, zero_);
    find_limit();
    for (std::size_t e = 0; e < topology_.couplings.size(); ++e) {
      if (!power_.into_head[e]) {
        return std::nullopt;
      }
      add_coupling(e);
    }
    return share_of_input();
  }

 private:
  // Below it a power is taken for the zero that it is in the recorded state.
  void find_limit() {
    TapeNumber largest = zero_;
    for (const TapedPower& one : flow_.couplings) {
      largest = recorder_.larger(largest, size_on_tape(one.into_head, recorder_));
      largest = recorder_.larger(largest, size_on_tape(one.out_of_tail, recorder_));
    }
    limit_ = recorder_.multiply(largest, recorder_.constant(kSameValue));
  }

  // The number, of which every lane must have the same sign; an exact zero where that is zero.
  TapeNumber with_sign(TapeNumber number, int sign) {
    if (sign == 0) {
      recorder_.demand_at_most(number, limit_);
      return zero_;
    }
    recorder_.demand_at_least(
        sign > 0 ? recorder_.larger(number, zero_) : recorder_.smaller(number, zero_), limit_);
    return number;
  }

  void add_coupling(std::size_t e) {
    const CouplingTopology& coupling = topology_.couplings[e];
    const int head_sign = sign_of(*power_.into_head[e]);
    const int tail_sign = sign_of(*power_.out_of_tail[e]);
    const TapeNumber into_head = with_sign(flow_.couplings[e].into_head, head_sign);
    const TapeNumber out_of_tail = with_sign(flow_.couplings[e].out_of_tail, tail_sign);
    if (head_sign < 0) {
      add(given_, coupling.head, negative(into_head));
    }
    if (tail_sign > 0) {
      add(given_, coupling.tail, out_of_tail);
    }
    if (head_sign != 0 && head_sign == tail_sign) {
      const bool is_forward = head_sign > 0;
      arcs_.push_back({.coupling = CouplingId{static_cast<int>(e)},
                       .from = is_forward ? coupling.tail : coupling.head,
                       .to = is_forward ? coupling.head : coupling.tail,
                       .power = recorder_.smaller(size_on_tape(into_head, recorder_),
                                                  size_on_tape(out_of_tail, recorder_))});
    }
    add_exchange(e, into_head, out_of_tail, head_sign, tail_sign);
  }

  // What enters and leaves its bodies from outside, as exchange_of has it.
  void add_exchange(
      std::size_t e, TapeNumber into_head, TapeNumber out_of_tail, int head_sign, int tail_sign) {
    const CouplingTopology& coupling = topology_.couplings[e];
    const bool is_driven = std::ranges::any_of(
        topology_.actuators,
        [&](const ActuatorTopology& one) { return coupling_of(one) == static_cast<int>(e); });
    const int sign = sign_of(power_.supplied[e]);
    if (!is_driven) {
      return;
    }
    const TapeNumber supplied = with_sign(recorder_.subtract(into_head, out_of_tail), sign);
    if (sign == 0) {
      return;
    }
    if ((head_sign > 0) != (tail_sign > 0)) {
      exchange(e, coupling.tail, negative(out_of_tail), -tail_sign, supplied);
      exchange(e, coupling.head, into_head, head_sign, supplied);
    } else {
      const bool is_at_head = (head_sign > 0) == (sign > 0);
      exchange(e, is_at_head ? coupling.head : coupling.tail, supplied, sign, supplied);
    }
  }

  void exchange(std::size_t e, BodyId body, TapeNumber into, int sign, TapeNumber supplied) {
    if (sign > 0) {
      add(enters_, body, into);
    } else if (sign < 0) {
      const TapeNumber useful = recorder_.divide(to_outputs(e), supplied);
      add(leaves_, body, recorder_.multiply(useful, negative(into)));
    }
  }

  TapeNumber to_outputs(std::size_t e) {
    TapeNumber sum = zero_;
    for (const int output : flow_.solved.which.outputs) {
      const auto i = static_cast<std::size_t>(output);
      if (coupling_of(topology_.actuators[i]) == static_cast<int>(e)) {
        sum = recorder_.add(sum, flow_.actuators[i]);
      }
    }
    return sum;
  }

  std::optional<TapeNumber> share_of_input() {
    const std::optional<std::vector<TapeNumber>> received = received_by_bodies();
    if (!received) {
      return std::nullopt;
    }
    TapeNumber out = zero_;
    for (std::size_t b = 1; b < leaves_.size(); ++b) {  // the ground, at rest, takes nothing
      if (recorder_.value(leaves_[b]) > 0.0) {
        const TapeNumber left = recorder_.multiply((*received)[b], leaves_[b]);
        out = recorder_.add(out, recorder_.divide(left, given_[b]));
      }
    }
    TapeNumber in = zero_;
    for (const int input : flow_.solved.which.inputs) {
      in = recorder_.add(in, flow_.actuators[static_cast<std::size_t>(input)]);
    }
    return recorder_.divide(out, in);
  }

  // What enters stands in a column more, of which the unknown is one.
  std::optional<std::vector<TapeNumber>> received_by_bodies() {
    const int count = topology_.body_count();
    TapedMatrix matrix{.rows = count, .columns = count + 1, .entries = {}};
    std::vector<int> wanted;
    for (int b = 0; b < count; ++b) {
      wanted.push_back(b);
      matrix.entries.push_back({.row = b, .column = b, .value = recorder_.constant(1.0)});
      const TapeNumber enters = enters_[static_cast<std::size_t>(b)];
      if (!recorder_.is_zero(enters)) {
        matrix.entries.push_back({.row = b, .column = count, .value = negative(enters)});
      }
    }
    for (const Transmitted& one : joined_arcs()) {
      const TapeNumber given = given_[static_cast<std::size_t>(one.from.value)];
      matrix.entries.push_back({.row = one.to.value,
                                .column = one.from.value,
                                .value = negative(recorder_.divide(one.power, given))});
    }
    const TapedUnknown entering{.column = count, .value = recorder_.constant(1.0)};
    return record_elimination(matrix, std::span(&entering, 1), wanted, recorder_);
  }

  struct Transmitted {
    CouplingId coupling;
    BodyId from;
    BodyId to;
    TapeNumber power;
  };

  // What reaches the other body, of all arcs between the same two together.
  std::vector<Transmitted> joined_arcs() {
    std::vector<Transmitted> joined;
    for (Transmitted one : arcs_) {
      one.power = recorder_.multiply(one.power, kept_by(one.coupling));
      const auto same = std::ranges::find_if(joined, [&](const Transmitted& other) {
        return other.from == one.from && other.to == one.to;
      });
      if (same == joined.end()) {
        joined.push_back(one);
      } else {
        same->power = recorder_.add(same->power, one.power);
      }
    }
    return joined;
  }

  TapeNumber kept_by(CouplingId coupling) {
    const auto& meshes = flow_.mechanism.lossy_meshes;
    const auto mesh = std::ranges::find(meshes, coupling, &LossyMesh::coupling);
    const TapeNumber whole = recorder_.constant(1.0);
    return mesh == meshes.end()
               ? whole
               : recorder_.subtract(whole,
                                    flow_.shares[static_cast<std::size_t>(mesh - meshes.begin())]);
  }

  int coupling_of(const ActuatorTopology& actuator) const {
    return topology_.freedoms[static_cast<std::size_t>(actuator.freedom)].coupling.value;
  }

  void add(std::vector<TapeNumber>& sums, BodyId body, TapeNumber power) {
    TapeNumber& sum = sums[static_cast<std::size_t>(body.value)];
    sum = recorder_.add(sum, power);
  }

  TapeNumber negative(TapeNumber number) {
    return recorder_.negate_product(number, recorder_.constant(1.0));
  }

  const TapedFlow& flow_;
  const Topology& topology_;
  const PowerFlow& power_;
  LaneRecorder& recorder_;
  TapeNumber zero_;
  TapeNumber limit_;
  std::vector<TapeNumber> given_;  // of bodies
  std::vector<TapeNumber> enters_;
  std::vector<TapeNumber> leaves_;
  std::vector<Transmitted> arcs_;
};

}  // namespace

std::optional<TapeNumber> record_absolute_efficiency(const TapedFlow& flow,
                                                     LaneRecorder& recorder) {
  return AbsoluteRecorder(flow, recorder).run();
}

}  // namespace kinestat
