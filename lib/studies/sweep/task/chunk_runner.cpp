#include "studies/sweep/task/chunk_runner.hpp"

#include <algorithm>
#include <bit>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "math/numbers/number_threads.hpp"
#include "studies/sweep/best_rows.hpp"
#include "studies/sweep/report/sweep_row_writer.hpp"
#include "studies/sweep/task/state_solver.hpp"

namespace kinestat {

namespace {

bool is_stopped(const SweepHooks& hooks) {
  return hooks.stop != nullptr && hooks.stop->load(std::memory_order_relaxed);
}

// The rows of one chunk after the other; each worker has its own.
class ChunkSolver {
 public:
  ChunkSolver(const SweepTask& task, const SweepHooks& hooks)
      : task_(task),
        hooks_(hooks),
        states_(task),
        judge_(task.plan, task.columns, task.choice),
        text_(task.plan, task.cases, task.columns, task.metadata.format) {}

  // Empty if the run is stopped meanwhile.
  std::optional<ChunkResult> solve(std::uint64_t chunk) {
    return solve_first(task_.plan.chunk_size(), chunk);
  }

  // So many states of a chunk.
  std::optional<ChunkResult> solve_first(std::uint64_t count, std::uint64_t chunk) {
    const std::uint64_t begin = chunk * task_.plan.chunk_size();
    const std::uint64_t end = std::min(begin + count, task_.plan.state_count());
    ChunkResult result{.chunk = chunk, .body = {}, .counts = {}};
    result.counts.dropped.resize(task_.choice.keep.size(), 0);
    const std::optional<BestChoice>& choice = task_.metadata.best;
    BestRows best(choice.value_or(BestChoice{}));
    StateWalk walk(task_.plan, begin, end);
    for (auto states = states_.solve_next(walk); !states.empty();
         states = states_.solve_next(walk)) {
      if (is_stopped(hooks_)) {
        return std::nullopt;
      }
      for (const SolvedState& state : states) {
        add_state(state, best, result);
      }
    }
    result.counts.states = end - begin;
    result.counts.excluded.assign(walk.excluded().begin(), walk.excluded().end());
    if (choice) {
      result.body = write_rows(best.take());
    }
    return result;
  }

 private:
  void add_state(const SolvedState& state, BestRows& best, ChunkResult& result) {
    text_.enter(state.places);
    judge_.enter(state.places);
    for (const SweepRow& row : state.rows) {
      ++result.counts.rows;
      count(row.status, result.counts);
      if (const auto failing = judge_.failing_condition(row)) {
        ++result.counts.dropped[*failing];
        continue;
      }
      if (task_.choice.ranks.empty()) {
        text_.append(row, result.body);
        continue;
      }
      const std::optional<RankKeys> keys = judge_.rank();
      if (!keys) {
        ++result.counts.unranked;
        continue;
      }
      const std::uint64_t number = state.number * task_.cases.size() + row.which;
      if (best.accepts(*keys, number)) {
        RankedRow ranked{.keys = *keys, .number = number, .text = {}};
        text_.append(row, ranked.text);
        best.add(std::move(ranked));
      }
    }
  }

  static void count(std::string_view status, SweepCounts& counts) {
    const auto at = counts.statuses.find(status);
    if (at == counts.statuses.end()) {
      counts.statuses.emplace(status, 1);
    } else {
      ++at->second;
    }
  }

  const SweepTask& task_;
  const SweepHooks& hooks_;
  StateSolver states_;
  RowJudge judge_;
  SweepRowWriter text_;
};

// Hands out chunks, takes results and keeps their order.
class Workshop {
 public:
  Workshop(const SweepTask& task,
           const std::vector<std::uint64_t>& chunks,
           std::size_t jobs,
           const ChunkSink& sink,
           const SweepHooks& hooks,
           SweepProgress progress)
      : task_(task),
        chunks_(chunks),
        window_(4 * jobs + 4),
        sink_(sink),
        hooks_(hooks),
        progress_(progress) {}

  // What every thread does.
  void work() {
    try {
      ChunkSolver solver(task_, hooks_);
      while (const std::optional<std::size_t> place = next_place()) {
        std::optional<ChunkResult> result = solver.solve(chunks_[*place]);
        if (!result) {
          end(RunEnd::stopped);
          return;
        }
        deliver(*place, *std::move(result));
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = failure_ ? failure_ : std::current_exception();
      end_with_lock(RunEnd::refused);
    }
  }

  RunEnd result() const {
    if (failure_) {
      std::rethrow_exception(failure_);
    }
    return end_;
  }

 private:
  // Empty where nothing is left. A result that would have to wait for many others is not begun.
  std::optional<std::size_t> next_place() {
    std::unique_lock lock(mutex_);
    has_room_.wait(lock, [this] {
      return is_over_ || sink_.order == ChunkSink::Order::any || next_ < delivered_ + window_;
    });
    if (!is_over_ && is_stopped(hooks_) && next_ < chunks_.size()) {
      end_with_lock(RunEnd::stopped);
    }
    return is_over_ || next_ == chunks_.size() ? std::nullopt : std::optional(next_++);
  }

  void deliver(std::size_t place, ChunkResult result) {
    const SweepCounts counts = result.counts;
    if (sink_.order == ChunkSink::Order::any && !sink_.take(std::move(result))) {
      end(RunEnd::refused);
      return;
    }
    const std::lock_guard lock(mutex_);
    if (sink_.order == ChunkSink::Order::ascending) {
      waiting_.emplace(place, std::move(result));
      deliver_waiting();
    }
    progress_.states += counts.states;
    progress_.rows += counts.rows;
    if (hooks_.progress) {
      hooks_.progress(progress_);
    }
  }

  void deliver_waiting() {
    while (!is_over_ && waiting_.contains(delivered_)) {
      ChunkResult result = std::move(waiting_.extract(delivered_).mapped());
      ++delivered_;
      if (!sink_.take(std::move(result))) {
        end_with_lock(RunEnd::refused);
      }
    }
    has_room_.notify_all();
  }

  void end(RunEnd why) {
    const std::lock_guard lock(mutex_);
    end_with_lock(why);
  }

  void end_with_lock(RunEnd why) {
    end_ = is_over_ ? end_ : why;
    is_over_ = true;
    has_room_.notify_all();
  }

  const SweepTask& task_;
  const std::vector<std::uint64_t>& chunks_;
  std::size_t window_;
  const ChunkSink& sink_;
  const SweepHooks& hooks_;
  SweepProgress progress_;
  std::mutex mutex_;
  std::condition_variable has_room_;
  std::size_t next_ = 0;       ///< place of the chunk that is handed out next
  std::size_t delivered_ = 0;  ///< how many were delivered in order
  std::map<std::size_t, ChunkResult> waiting_;
  bool is_over_ = false;
  RunEnd end_ = RunEnd::complete;
  std::exception_ptr failure_;
};

// The bits of a number below 2^count the other way round: 0, 1, 2, … come to lie evenly.
std::uint64_t reversed_bits(std::uint64_t number, int count) {
  std::uint64_t reversed = 0;
  for (int i = 0; i < count; ++i) {
    reversed = reversed << 1U | (number >> static_cast<unsigned>(i) & 1U);
  }
  return reversed;
}

}  // namespace

StateSample sample_states(const SweepTask& task,
                          double seconds,
                          const std::function<double()>& clock) {
  constexpr std::uint64_t kFewestStates = 16;
  constexpr double kShort = 0.005;      // seconds: the clock and the beginning of a chunk are noise
  constexpr double kTicks = 1'000'000;  // a second of a clock has
  const std::uint64_t chunks = task.plan.chunk_count();
  const auto bits = static_cast<int>(std::bit_width(chunks));
  const SweepHooks hooks;
  ChunkSolver solver(task, hooks);
  StateSample sample;
  std::uint64_t count = kFewestStates;
  for (std::uint64_t i = 0; i >> static_cast<unsigned>(bits) == 0 && sample.seconds < seconds;
       ++i) {
    const std::uint64_t chunk = reversed_bits(i, bits);
    if (chunk >= chunks) {
      continue;
    }
    const double begin = clock();
    const std::optional<ChunkResult> result = solver.solve_first(count, chunk);
    const double took = std::max(clock() - begin, 1.0 / kTicks);
    sample.seconds += took;
    sample.counts.add(result->counts);
    sample.bytes += result->body.size();
    count = took < kShort ? std::min(2 * count, task.plan.chunk_size()) : count;
  }
  return sample;
}

RunEnd run_chunks(const SweepTask& task,
                  const std::vector<std::uint64_t>& chunks,
                  std::uint64_t jobs,
                  const ChunkSink& sink,
                  const SweepHooks& hooks,
                  SweepProgress progress) {
  const auto most = std::max<std::uint64_t>(1, chunks.size());
  const auto threads = static_cast<std::size_t>(std::clamp<std::uint64_t>(jobs, 1, most));
  Workshop workshop(task, chunks, threads, sink, hooks, progress);
  work_on_threads(threads, [&workshop] { workshop.work(); });
  return workshop.result();
}

}  // namespace kinestat
