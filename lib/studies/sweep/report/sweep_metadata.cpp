#include "studies/sweep/report/sweep_metadata.hpp"

#include <algorithm>
#include <exception>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "core/version.hpp"
#include "report/csv.hpp"
#include "report/json_archive.hpp"
#include "report/json_values.hpp"
#include "report/npy.hpp"
#include "studies/sweep/report/sweep_record.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kShardSignature = "{\"kinestat\":{\"sweep_shard\":1,";
constexpr std::string_view kSummarySignature = "{\n  \"kinestat\": {\n    \"sweep\": 1,";

std::string_view extension_of(RowFormat format) {
  return format == RowFormat::json ? "jsonl" : word_of(format);
}

std::optional<RowFormat> format_of(std::string_view word) {
  for (const RowFormat format : {RowFormat::csv, RowFormat::json, RowFormat::npy}) {
    if (word == word_of(format)) {
      return format;
    }
  }
  return std::nullopt;
}

// There are no quantities.
const FileUnits& no_units() {
  static const FileUnits units;
  return units;
}

Json best_json(const std::optional<BestChoice>& best) {
  if (!best) {
    return nullptr;
  }
  Json json;
  json["count"] = best->count;
  for (const Criterion& one : best->criteria) {
    json["criteria"].push_back(
        Json::parse(json_text(criterion_record(), one, no_units(), JsonLayout::line)));
  }
  return json;
}

Json sample_json(const std::optional<SampleChoice>& sample) {
  return sample ? Json::parse(json_text(sample_record(), *sample, no_units(), JsonLayout::line))
                : Json(nullptr);
}

std::optional<SampleChoice> sample_of(const Json& json) {
  if (json.is_null()) {
    return std::nullopt;
  }
  const auto method = std::ranges::find(kSampleMethods, json.at("method").get<std::string>());
  return SampleChoice{.count = json.at("count").get<std::uint64_t>(),
                      .method = static_cast<SampleMethod>(method - kSampleMethods.begin()),
                      .seed = json.at("seed").get<std::uint64_t>()};
}

std::optional<BestChoice> best_of(const Json& json) {
  if (json.is_null()) {
    return std::nullopt;
  }
  BestChoice best{.count = json.at("count").get<std::uint64_t>(), .criteria = {}};
  for (const Json& one : json.at("criteria")) {
    best.criteria.push_back(
        {.by = one.at("by").get<std::string>(),
         .order = one.at("order").get<std::string>() == word_of(RankOrder::largest)
                      ? RankOrder::largest
                      : RankOrder::smallest});
  }
  return best;
}

SweepMetadata metadata_of(const Json& json) {
  SweepMetadata metadata;
  metadata.version = json.at("kinestat").at("version").get<std::string>();
  metadata.plan = json.at("plan").get<std::string>();
  metadata.stem = json.at("stem").get<std::string>();
  metadata.name = json.at("name").get<std::string>();
  metadata.format = format_of(json.at("format").get<std::string>()).value_or(RowFormat::csv);
  metadata.titles = json.at("columns").get<std::vector<std::string>>();
  metadata.cases = json.at("cases").get<std::vector<std::string>>();
  metadata.dtype = json.at("dtype").get<std::string>();
  metadata.requirements = json.at("require").get<std::vector<std::string>>();
  metadata.keep = json.at("keep").get<std::vector<std::string>>();
  metadata.states = json.at("states").get<std::uint64_t>();
  metadata.chunks = json.at("chunks").get<std::uint64_t>();
  metadata.best = best_of(json.at("best"));
  metadata.sample = sample_of(json.at("sample"));
  return metadata;
}

}  // namespace

std::string ShardNumber::text() const {
  return fmt::format("{}/{}", number, count);
}

// Without overflow: at most 65536 chunks times as many shards as anybody types.
std::uint64_t ShardNumber::first_chunk(std::uint64_t chunks) const {
  return (number - 1) * chunks / count;
}

std::uint64_t ShardNumber::end_chunk(std::uint64_t chunks) const {
  return number * chunks / count;
}

std::string SweepMetadata::result_name() const {
  return fmt::format("{}.sweep.{}", stem, extension_of(format));
}

std::string SweepMetadata::heading(std::uint64_t rows) const {
  switch (format) {
    case RowFormat::csv:
      return csv_line(titles);
    case RowFormat::json:
      return {};
    case RowFormat::npy:
      return npy_header(dtype, rows);
  }
  return {};
}

std::string SweepMetadata::signature() const {
  switch (format) {
    case RowFormat::csv:
      return csv_line(titles);
    case RowFormat::json:
      return json_row_keys(titles).front();
    case RowFormat::npy:
      return npy_signature(dtype);
  }
  return {};
}

std::string_view shard_signature() {
  return kShardSignature;
}

std::string_view summary_signature() {
  return kSummarySignature;
}

std::string write_shard_header(const SweepMetadata& metadata, const ShardNumber& shard) {
  Json json;
  json["kinestat"]["sweep_shard"] = 1;
  json["kinestat"]["version"] = metadata.version;
  json["plan"] = metadata.plan;
  json["shard"] = {shard.number, shard.count};
  json["stem"] = metadata.stem;
  json["name"] = metadata.name;
  json["format"] = word_of(metadata.format);
  json["columns"] = metadata.titles;
  json["cases"] = metadata.cases;
  json["dtype"] = metadata.dtype;
  json["require"] = metadata.requirements;
  json["keep"] = metadata.keep;
  json["states"] = metadata.states;
  json["chunks"] = metadata.chunks;
  json["best"] = best_json(metadata.best);
  json["sample"] = sample_json(metadata.sample);
  return json.dump() + "\n";
}

std::optional<ShardHeader> read_shard_header(const std::string& line) {
  if (!line.starts_with(kShardSignature)) {
    return std::nullopt;
  }
  try {
    const Json json = Json::parse(line);
    ShardHeader result{.metadata = metadata_of(json), .shard = {}};
    result.shard.number = json.at("shard").at(0).get<std::uint64_t>();
    result.shard.count = json.at("shard").at(1).get<std::uint64_t>();
    const bool is_right = result.shard.number >= 1 && result.shard.number <= result.shard.count;
    return is_right ? std::optional(std::move(result)) : std::nullopt;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::string write_sweep_summary(const SweepMetadata& metadata, const SweepCounts& counts) {
  const SweepSummaryView view{.metadata = metadata, .counts = counts};
  return json_text(sweep_summary_record(), view, no_units(), JsonLayout::indented);
}

std::optional<std::string> read_plan_of_summary(const std::string& text) {
  if (!text.starts_with(kSummarySignature)) {
    return std::nullopt;
  }
  try {
    return Json::parse(text).at("plan").get<std::string>();
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::string sweep_text(const SweepMetadata& metadata, const SweepCounts& counts) {
  std::string text = fmt::format("{}: {} states, {} analysed, {} rows",
                                 metadata.stem,
                                 counts.states,
                                 counts.analysed(),
                                 counts.rows);
  text += metadata.keep.empty() ? "\n" : fmt::format(", {} kept\n", counts.kept());
  for (std::size_t i = 0; i < counts.excluded.size() && i < metadata.requirements.size(); ++i) {
    text += fmt::format(
        "  excluded by '{}': {}\n", printable(metadata.requirements[i]), counts.excluded[i]);
  }
  for (std::size_t i = 0; i < counts.dropped.size() && i < metadata.keep.size(); ++i) {
    text +=
        fmt::format("  dropped by '{}': {} rows\n", printable(metadata.keep[i]), counts.dropped[i]);
  }
  if (counts.unranked > 0) {
    std::vector<std::string> criteria;
    for (const Criterion& one : metadata.best->criteria) {
      criteria.push_back(one.by);
    }
    text += fmt::format(
        "  without a value of {}: {} rows\n", printable(plain_list(criteria)), counts.unranked);
  }
  for (const auto& [status, count] : counts.statuses) {
    text += fmt::format("  {}: {}\n", status, count);
  }
  return text;
}

}  // namespace kinestat
