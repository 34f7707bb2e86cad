// What is told of a sweep beside its rows: of a shard before them, of a result in a file of its
// own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "studies/sweep/best_choice.hpp"
#include "studies/sweep/report/sweep_rows.hpp"
#include "studies/sweep/state_sampler.hpp"
#include "studies/sweep/sweep_counts.hpp"

namespace kinestat {

/// A share of the chunks of a sweep: the k-th of n.
struct ShardNumber {
  std::uint64_t number = 1;
  std::uint64_t count = 1;

  friend bool operator==(const ShardNumber&, const ShardNumber&) = default;

  /// "2/7"
  std::string text() const;

  /// The chunks of the shard: from the first up to, not including, the end.
  std::uint64_t first_chunk(std::uint64_t chunks) const;
  std::uint64_t end_chunk(std::uint64_t chunks) const;
};

/// All that shards of one sweep have in common, and what a result says of it.
struct SweepMetadata {
  std::string version;  ///< of the program
  std::string plan;     ///< a hash of all that decides the rows
  std::string stem;     ///< of the names of the files of the result
  std::string name;     ///< of the mechanism
  RowFormat format = RowFormat::csv;
  std::vector<std::string> titles;        ///< of the columns
  std::vector<std::string> cases;         ///< the labels of those that are run
  std::string dtype;                      ///< of the rows of an array; empty for text
  std::vector<std::string> requirements;  ///< as typed
  std::vector<std::string> keep;          ///< likewise
  std::uint64_t states = 0;
  std::uint64_t chunks = 0;
  std::optional<BestChoice> best;      ///< empty: all rows are kept
  std::optional<SampleChoice> sample;  ///< empty: all combinations

  /// The name of the result without its folder: "teeth.sweep.csv", ".jsonl" or ".npy".
  std::string result_name() const;

  /// What stands before that many rows: a line with the titles, nothing, or the header of an array.
  std::string heading(std::uint64_t rows) const;

  /// How the result begins, whatever rows it has.
  std::string signature() const;
};

/// The first line of a shard, with its line end.
std::string write_shard_header(const SweepMetadata& metadata, const ShardNumber& shard);

/// How every such line begins.
std::string_view shard_signature();

struct ShardHeader {
  SweepMetadata metadata;
  ShardNumber shard;
};

/// Empty for any other text.
std::optional<ShardHeader> read_shard_header(const std::string& line);

/// The file beside the rows: what was varied, required and counted.
std::string write_sweep_summary(const SweepMetadata& metadata, const SweepCounts& counts);

/// How every such file begins.
std::string_view summary_signature();

/// The plan of a file beside rows; empty for any other text.
std::optional<std::string> read_plan_of_summary(const std::string& text);

/// The counts for people, on a line each.
std::string sweep_text(const SweepMetadata& metadata, const SweepCounts& counts);

}  // namespace kinestat
