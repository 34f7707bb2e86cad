#include "run/merge.hpp"

#include <algorithm>
#include <cerrno>
#include <exception>
#include <map>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "core/version.hpp"
#include "io/stored_chunk.hpp"
#include "studies/sweep/task/sweep_result.hpp"

namespace kinestat {

namespace {

// A shard that was read from its beginning to its end.
struct WholeShard {
  std::string path;
  ShardHeader header;
  SweepCounts counts;
};

class ShardCheck {
 public:
  explicit ShardCheck(Diagnostics& found) : found_(found) {}

  std::optional<WholeShard> read(const std::string& path) {
    path_ = path;
    errno = 0;
    RecordFile file(path);
    if (!file.is_open()) {
      found_.error(
          "E0151",
          {},
          fmt::format(
              "cannot read '{}': {}", printable(path), std::generic_category().message(errno)));
      return std::nullopt;
    }
    const std::optional<std::string> line = file.read_line();
    const std::optional<ShardHeader> header = line ? read_shard_header(*line) : std::nullopt;
    if (!header) {
      refuse("is not a shard of a sweep, or its first line is damaged",
             "give the files that 'kinestat sweep --shard' has written");
      return std::nullopt;
    }
    if (header->metadata.version != kVersion) {
      refuse(fmt::format("was written by version {}, and this is {}",
                         printable(header->metadata.version),
                         kVersion));
      return std::nullopt;
    }
    WholeShard shard{.path = path, .header = *header, .counts = {}};
    return read_pieces(file, shard) ? std::optional(std::move(shard)) : std::nullopt;
  }

 private:
  bool read_pieces(RecordFile& file, WholeShard& shard) {
    const SweepMetadata& metadata = shard.header.metadata;
    StoredChunk record;
    for (std::uint64_t c = shard.header.shard.first_chunk(metadata.chunks);
         c < shard.header.shard.end_chunk(metadata.chunks);
         ++c) {
      const RecordState state = file.read_record(metadata.plan, record);
      const auto counts = state == RecordState::whole ? read_counts(record.note) : std::nullopt;
      if (state == RecordState::end || state == RecordState::truncated) {
        return refuse(fmt::format("is cut off in chunk {}", c));
      }
      if (!counts || record.index != c) {
        return refuse(fmt::format("is damaged in chunk {}", c));
      }
      shard.counts.add(*counts);
    }
    const std::optional<std::string> end = file.read_line();
    if (!end) {
      return refuse("is cut off before its last line");
    }
    return (*end == kShardEnd && file.read_record(metadata.plan, record) == RecordState::end) ||
           refuse("is damaged at its end");
  }

  bool refuse(const std::string& why,
              const char* hint = "run this shard again, with --shard as before") {
    found_.error("E0906", {}, fmt::format("'{}' {}", printable(path_), why), hint);
    return false;
  }

  Diagnostics& found_;
  std::string path_;
};

// All are of the plan of the first.
bool check_plans(const std::vector<WholeShard>& shards, Diagnostics& found) {
  bool is_good = true;
  for (const WholeShard& shard : shards) {
    const WholeShard& first = shards.front();
    const bool has_plan = shard.header.metadata.plan == first.header.metadata.plan;
    if (!has_plan || shard.header.shard.count != first.header.shard.count) {
      found.error(
          "E0906",
          {},
          has_plan ? fmt::format("'{}' is shard {}, and '{}' is shard {}",
                                 printable(shard.path),
                                 shard.header.shard.text(),
                                 printable(first.path),
                                 first.header.shard.text())
                   : fmt::format("'{}' is of another sweep than '{}': the file, --set or the "
                                 "options differ",
                                 printable(shard.path),
                                 printable(first.path)),
          "give the shards of one sweep, made with the same file, options and count of shards");
      is_good = false;
    }
  }
  return is_good;
}

// Every shard is there once.
bool check_complete(const std::vector<WholeShard>& shards, Diagnostics& found) {
  const std::uint64_t count = shards.front().header.shard.count;
  bool is_good = true;
  std::map<std::uint64_t, std::string> paths;
  for (const WholeShard& shard : shards) {
    const auto [at, is_new] = paths.emplace(shard.header.shard.number, shard.path);
    if (!is_new) {
      found.error("E0907",
                  {},
                  fmt::format("shard {} is there twice: '{}' and '{}'",
                              shard.header.shard.text(),
                              printable(at->second),
                              printable(shard.path)),
                  "leave one of the two out");
      is_good = false;
    }
  }
  std::vector<std::string> missing;
  for (std::uint64_t k = 1; k <= count && missing.size() < 100; ++k) {
    if (!paths.contains(k)) {
      missing.push_back(ShardNumber{.number = k, .count = count}.text());
    }
  }
  if (!missing.empty()) {
    found.error("E0907",
                {},
                fmt::format("shard{} {} {} missing",
                            missing.size() == 1 ? "" : "s",
                            plain_list(missing),
                            missing.size() == 1 ? "is" : "are"),
                fmt::format("run kinestat sweep with --shard {}, and merge all", missing.front()));
    is_good = false;
  }
  return is_good;
}

// Whether they can go where the options have it.
bool check_target(const std::vector<WholeShard>& shards,
                  const MergeOptions& options,
                  Diagnostics& found) {
  if (options.folder.empty() && shards.front().header.metadata.format == RowFormat::npy) {
    found.error("E0101",
                {},
                "the shards hold an array (--format npy), and that needs --out",
                "the words for its numbers are in a file beside it: name the folder for both, as "
                "in --out results");
    return false;
  }
  return options.folder.empty() ||
         keeps_words(shards.front().header.metadata, options.folder, options.overwrite, found);
}

// Empty iff an error was added.
std::vector<WholeShard> read_shards(const std::vector<std::string>& paths, Diagnostics& found) {
  std::vector<WholeShard> shards;
  ShardCheck check(found);
  for (const std::string& path : paths) {
    if (auto shard = check.read(path)) {
      shards.push_back(*std::move(shard));
    }
  }
  if (found.has_errors() || !check_plans(shards, found) || !check_complete(shards, found)) {
    return {};
  }
  std::ranges::sort(shards, {}, [](const WholeShard& shard) { return shard.header.shard.number; });
  return shards;
}

bool write_rows(const NextPiece& pieces, const SweepHooks& hooks, Diagnostics& found) {
  std::string piece;
  while (pieces(piece)) {
    if (!hooks.write(piece)) {
      found.error("E0152", {}, "standard output cannot be written");
      return false;
    }
  }
  return true;
}

void merge_into(const std::vector<std::string>& paths,
                const MergeOptions& options,
                const SweepHooks& hooks,
                Outcome& outcome) {
  Diagnostics found;
  std::string summary;
  if (options.folder.empty() || check_output_folder(options.folder, found)) {
    const std::vector<WholeShard> shards = read_shards(paths, found);
    std::vector<PieceFile> files;
    SweepCounts counts;
    for (const WholeShard& shard : shards) {
      const ShardHeader& header = shard.header;
      files.push_back({.path = shard.path,
                       .is_shard = true,
                       .pieces = header.shard.end_chunk(header.metadata.chunks) -
                                 header.shard.first_chunk(header.metadata.chunks)});
      counts.add(shard.counts);
    }
    if (!shards.empty() && check_target(shards, options, found)) {
      const SweepMetadata& metadata = shards.front().header.metadata;
      const bool is_written =
          options.folder.empty()
              ? write_rows(result_pieces(metadata, files, counts), hooks, found)
              : write_files(result_files(metadata, options.folder, "", files, counts),
                            options.overwrite,
                            paths,
                            found);
      summary = is_written && !options.is_quiet ? sweep_text(metadata, counts) : "";
    }
  }
  add_diagnostics({}, found, Strictness::normal, outcome);
  tell(summary, outcome);
}

}  // namespace

Outcome merge_files(const std::vector<std::string>& paths,
                    const MergeOptions& options,
                    const SweepHooks& hooks) {
  Outcome outcome;
  outcome.form = options.diagnostics;
  try {
    merge_into(paths, options, hooks, outcome);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& bug) {
    add_bug("", bug.what(), outcome);
  }
  return outcome;
}

}  // namespace kinestat
