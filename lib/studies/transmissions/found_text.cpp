#include "studies/transmissions/found_text.hpp"

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace kinestat {

namespace {

class NumberWriter {
 public:
  template <class Number>
  void one(Number& number) {
    text_ += fmt::format("{} ", number);
  }

  void size(std::size_t& count) { one(count); }

  void end_line() { text_.back() = '\n'; }

  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

class NumberReader {
 public:
  explicit NumberReader(std::string_view text) : text_(text) {}

  template <class Number>
  void one(Number& number) {
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), number);
    const auto length = static_cast<std::size_t>(end - text_.data());
    is_good_ = is_good_ && error == std::errc() && length < text_.size();
    if (is_good_) {
      last_ = text_[length];
      text_.remove_prefix(length + 1);
    }
  }

  // A count that the rest of the text can hold.
  void size(std::size_t& count) {
    one(count);
    is_good_ = is_good_ && count <= text_.size();
    count = is_good_ ? count : 0;
  }

  void end_line() { is_good_ = is_good_ && last_ == '\n'; }

  bool is_good() const { return is_good_; }

  bool is_at_end() const { return text_.empty(); }

 private:
  std::string_view text_;
  char last_ = ' ';
  bool is_good_ = true;
};

template <class Text, class Numbers>
void list(Text& text, Numbers& numbers) {
  std::size_t count = numbers.size();
  text.size(count);
  numbers.resize(count);
  for (auto& one : numbers) {
    text.one(one);
  }
}

template <class Text>
void stages(Text& text, SearchStages& stages) {
  for (std::uint64_t* one : {&stages.structures,
                             &stages.layouts,
                             &stages.labelled_layouts,
                             &stages.not_refuted,
                             &stages.undecided,
                             &stages.with_ladder,
                             &stages.not_buildable,
                             &stages.over_limits,
                             &stages.points,
                             &stages.found,
                             &stages.layouts_found}) {
    text.one(*one);
  }
  text.end_line();
}

template <class Text>
void figures(Text& text, LadderFigures& figures) {
  for (double* one : {&figures.spread,
                      &figures.mean_efficiency,
                      &figures.least_efficiency,
                      &figures.unevenness,
                      &figures.element_torque,
                      &figures.element_slip,
                      &figures.shaft_speed,
                      &figures.planet_speed}) {
    text.one(*one);
  }
  text.one(figures.rotating_clutches);
  std::int64_t hollow =
      figures.hollow_shafts ? static_cast<std::int64_t>(*figures.hollow_shafts) : -1;
  text.one(hollow);
  figures.hollow_shafts =
      hollow < 0 ? std::nullopt : std::optional(static_cast<std::uint64_t>(hollow));
}

template <class Text>
void transmission(Text& text, FoundTransmission& found) {
  text.one(found.structure);
  text.one(found.layout);
  text.one(found.roles.roles);
  text.one(found.roles.double_planet);
  for (double& ratio : found.stationary_ratios) {
    text.one(ratio);
  }
  std::size_t elements = found.elements.size();
  text.size(elements);
  found.elements.resize(elements);
  for (ShaftPair& pair : found.elements) {
    text.one(pair[0]);
    text.one(pair[1]);
  }
  list(text, found.ladder);
  list(text, found.ratios);
  text.one(found.rank);
  text.one(found.points);
  text.one(found.placements);
  figures(text, found.figures);
  text.end_line();
}

}  // namespace

std::string write_found(const TransmissionSearch& search) {
  TransmissionSearch copy = search;
  NumberWriter writer;
  stages(writer, copy.stages);
  for (FoundTransmission& one : copy.found) {
    transmission(writer, one);
  }
  return writer.take();
}

std::optional<TransmissionSearch> read_found(const std::string& text) {
  NumberReader reader(text);
  TransmissionSearch search;
  stages(reader, search.stages);
  while (reader.is_good() && !reader.is_at_end()) {
    transmission(reader, search.found.emplace_back());
  }
  return reader.is_good() ? std::optional(std::move(search)) : std::nullopt;
}

}  // namespace kinestat
