#include "studies/transmissions/task/stored_search.hpp"

#include <filesystem>
#include <set>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "core/version.hpp"
#include "format/mechanism_writer.hpp"
#include "io/atomic_file.hpp"
#include "io/stored_chunk.hpp"
#include "studies/transmissions/found_text.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kEnding = ".found";

}  // namespace

StoredSearch::StoredSearch(std::string folder,
                           std::string stem,
                           const MechanismDescription& description,
                           TransmissionRank rank)
    : folder_(std::move(folder)),
      stem_(std::move(stem)),
      plan_(hash_of(fmt::format(
          "{} {} {}", kVersion, static_cast<int>(rank), mechanism_text(description, {})))) {}

std::string StoredSearch::path_of(std::size_t structure) const {
  return fmt::format("{}/{}.structure-{:08}{}", folder_, stem_, structure, kEnding);
}

bool StoredSearch::prepare(Diagnostics& found) {
  shared_.emplace(folder_);
  std::error_code failure;
  std::set<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, failure)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(stem_ + ".structure-") && name.ends_with(kEnding)) {
      paths.insert(entry.path().string());
    }
  }
  if (failure) {
    found.error(
        "E0152",
        {},
        fmt::format("cannot open the folder '{}': {}", printable(folder_), failure.message()),
        "make it first");
    return false;
  }
  for (const std::string& path : paths) {
    RecordFile file(path);
    StoredChunk record;
    if (file.is_open() && file.read_record(plan_, record) == RecordState::foreign) {
      found.error(
          "E0908",
          {},
          fmt::format("'{}' belongs to another search: the file, --set, --by or the version "
                      "have changed since",
                      printable(path)),
          "remove these files, or name another folder");
      return false;
    }
  }
  return true;
}

SearchStore StoredSearch::store() {
  return {.find = [this](std::size_t structure) { return find(structure); },
          .keep = [this](std::size_t structure,
                         const TransmissionSearch& search) { keep(structure, search); }};
}

// What is not there or damaged is searched anew.
std::optional<TransmissionSearch> StoredSearch::find(std::size_t structure) const {
  RecordFile file(path_of(structure));
  StoredChunk record;
  const bool is_there = file.is_open() && file.read_record(plan_, record) == RecordState::whole &&
                        record.index == structure;
  return is_there ? read_found(record.body) : std::nullopt;
}

void StoredSearch::keep(std::size_t structure, const TransmissionSearch& search) {
  const OutputFile file{
      .path = path_of(structure),
      .content = write_record({.index = structure, .note = "", .body = write_found(search)}, plan_),
      .signature = {},
      .survives_crash = false};
  Diagnostics found;
  // Where another process has written it meanwhile all is well.
  if (!write_files(std::span(&file, 1), Overwrite::force, {}, found) && !find(structure)) {
    const std::lock_guard lock(mutex_);
    if (!failures_.has_errors()) {
      failures_ = std::move(found);
    }
  }
}

void StoredSearch::tell(Diagnostics& found) const {
  for (const Diagnostic& one : failures_.items()) {
    found.error(one.code, one.where, one.message, one.hint);
  }
}

}  // namespace kinestat
