#include "io/stored_chunk.hpp"

#include <vector>

#include <fmt/format.h>

// Compiled here, for this source alone.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include "core/spelling.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kWord = "chunk";

std::string digits_of(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

// What the hash covers: everything but itself.
std::string record_hash(const StoredChunk& record, std::string_view plan) {
  const std::string head = fmt::format("{} {} {}\n", plan, record.index, record.note);
  XXH3_state_t state;
  XXH3_64bits_reset(&state);
  XXH3_64bits_update(&state, head.data(), head.size());
  XXH3_64bits_update(&state, record.body.data(), record.body.size());
  return digits_of(XXH3_64bits_digest(&state));
}

// The words of a line up to the last wanted one, which takes the rest.
std::vector<std::string> split(const std::string& line, std::size_t count) {
  std::vector<std::string> words;
  std::size_t begin = 0;
  while (words.size() + 1 < count) {
    const std::size_t end = line.find(' ', begin);
    if (end == std::string::npos) {
      break;
    }
    words.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  words.push_back(line.substr(begin));
  return words;
}

}  // namespace

std::string hash_of(std::string_view text) {
  return digits_of(XXH3_64bits(text.data(), text.size()));
}

std::string write_record(const StoredChunk& record, std::string_view plan) {
  std::string text = fmt::format("{} {} {} {} {} {}\n",
                                 kWord,
                                 plan,
                                 record.index,
                                 record.body.size(),
                                 record_hash(record, plan),
                                 record.note);
  text += record.body;
  return text;
}

RecordFile::RecordFile(const std::string& path) : file_(path, std::ios::binary) {
  if (file_.is_open()) {
    file_.seekg(0, std::ios::end);
    const auto end = file_.tellg();
    size_ = end < 0 ? 0 : static_cast<std::uint64_t>(end);
    file_.seekg(0);
  }
}

std::uint64_t RecordFile::bytes_left() {
  const auto at = file_.tellg();
  return at < 0 ? 0 : size_ - static_cast<std::uint64_t>(at);
}

std::optional<std::string> RecordFile::read_line() {
  constexpr std::size_t kLongest = std::size_t{1} << 20U;
  std::string line;
  for (int c = file_.get(); c != std::char_traits<char>::eof(); c = file_.get()) {
    if (c == '\n') {
      return line;
    }
    line += static_cast<char>(c);
    if (line.size() > kLongest) {
      break;
    }
  }
  return std::nullopt;
}

RecordState RecordFile::read_record(std::string_view plan, StoredChunk& record) {
  if (file_.peek() == std::char_traits<char>::eof()) {
    return RecordState::end;
  }
  const std::optional<std::string> line = read_line();
  if (!line) {
    return RecordState::truncated;
  }
  constexpr std::size_t kWordCount = 6;
  const std::vector<std::string> words = split(*line, kWordCount);
  const bool has_form = words.size() == kWordCount && words[0] == kWord;
  const auto index = has_form ? number_from<std::uint64_t>(words[2]) : std::nullopt;
  const auto size = has_form ? number_from<std::uint64_t>(words[3]) : std::nullopt;
  if (!index || !size) {
    return RecordState::damaged;
  }
  if (words[1] != plan) {
    return RecordState::foreign;
  }
  if (*size > bytes_left()) {
    return RecordState::truncated;
  }
  record.index = *index;
  record.note = words[5];
  record.body.resize(*size);
  file_.read(record.body.data(), static_cast<std::streamsize>(*size));
  return record_hash(record, plan) == words[4] ? RecordState::whole : RecordState::damaged;
}

}  // namespace kinestat
