// A file of the library with something changed, through one command, in this process.
//
// The bytes choose the file, the command and what is changed. With KINESTAT_FUZZ_SHOW in the
// environment the file is printed before it is judged.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/codes.hpp"
#include "core/utf8.hpp"
#include "fuzz/changed_tree.hpp"
#include "fuzz/choices.hpp"
#include "fuzz/diagnostic_invariants.hpp"
#include "fuzz/report_oracles.hpp"
#include "fuzz/require.hpp"
#include "run/analyse.hpp"
#include "run/duty.hpp"
#include "run/embedded.hpp"
#include "run/graph.hpp"
#include "run/html_report.hpp"
#include "run/inputs.hpp"
#include "run/mobility.hpp"
#include "run/motion.hpp"
#include "run/plot.hpp"
#include "run/sensitivity.hpp"
#include "run/shift.hpp"
#include "run/simulation.hpp"
#include "run/sweep.hpp"
#include "run/synthesis.hpp"
#include "run/tolerance.hpp"

namespace kinestat::fuzz {

namespace {

constexpr std::size_t kMostChanges = 4;

// Searches of seconds to minutes; what they search is in the smaller ones.
bool is_slow(std::string_view name) {
  return name.ends_with("_search") || name == "sweeps/year_train" || name.ends_with("_class");
}

std::vector<std::string_view> read_seeds() {
  std::vector<std::string_view> seeds;
  for (const EmbeddedText& text : embedded_library()) {
    if (!is_slow(text.name)) {
      seeds.push_back(text.text);
    }
  }
  for (const auto& more : {embedded_starters(), embedded_couplings()}) {
    for (const EmbeddedText& text : more) {
      seeds.push_back(text.text);
    }
  }
  return seeds;
}

// A file in memory, under a path.
class File {
 public:
  File(std::string text, bool has_state)
      : text_(std::move(text)), has_state_(has_state), descriptor_(memfd_create("file", 0)) {
    require(descriptor_ >= 0 && write(descriptor_, text_.data(), text_.size()) ==
                                    static_cast<ssize_t>(text_.size()),
            "a file in memory can be written");
  }

  File(const File&) = delete;
  File& operator=(const File&) = delete;

  ~File() { close(descriptor_); }

  const std::string& text() const { return text_; }

  std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

  /// Whether its sweep has one state, which is the file as it is.
  bool has_state() const { return has_state_; }

 private:
  std::string text_;
  bool has_state_;
  int descriptor_;
};

Json parsed(const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  require(!json.is_discarded(), "JSON is well-formed", text.substr(0, 1000));
  return json;
}

void check_messages(const File& file, const std::string& lines) {
  const LineLengths lengths(file.text());
  std::istringstream said(lines);
  for (std::string line; std::getline(said, line);) {
    if (!line.starts_with('{')) {
      continue;  // what people like to know beside the answer
    }
    const Json log = parsed(line);
    for (const Json& one : log.at("diagnostics")) {
      const auto code = one.at("code").get<std::string>();
      require(find_code(code) != nullptr, "the code is known", one.dump());
      const auto message = one.at("message").get<std::string>();
      require(!message.empty() && printable(message) == message,
              "a message is one line of printable text",
              message);
      if (one.at("file") == file.path()) {
        require(lengths.holds({.line = one.at("line").get<int>(),
                               .column = one.at("column").get<int>(),
                               .length = one.value("length", 1)}),
                "the place lies in the text",
                one.dump());
      }
    }
  }
}

struct Said {
  std::string out;
  ExitStatus status;
};

Said judged(const File& file, const Outcome& outcome) {
  const std::string err = standard_error(outcome, {});
  require(outcome.status != ExitStatus::bug, "there is no bug", err);
  require(outcome.status != ExitStatus::environment, "there is no lack of memory or files", err);
  require(outcome.status == ExitStatus::done || !err.empty(), "a failure has a message");
  check_messages(file, err);
  return {standard_output(outcome, {}), outcome.status};
}

AnalyseOptions options_of(StreamFormat format, Accuracy accuracy = Accuracy::automatic) {
  AnalyseOptions options;
  options.format = format;
  options.diagnostics = DiagnosticsForm::json;
  options.accuracy.accuracy = accuracy;
  return options;
}

constexpr std::array<StreamFormat, 3> kFormats = {
    StreamFormat::table, StreamFormat::json, StreamFormat::csv};

// The report of a command, null without one.
Json report_of(const File& file, const Outcome& outcome) {
  const Said said = judged(file, outcome);
  return said.out.empty() ? Json() : parsed(said.out);
}

Json analysed(const File& file, Accuracy accuracy = Accuracy::automatic) {
  return report_of(file, analyse_files({file.path()}, options_of(StreamFormat::json, accuracy)));
}

std::string swept(const File& file) {
  SweepOptions options;
  options.format = RowFormat::json;
  options.jobs = 1;
  options.diagnostics = DiagnosticsForm::json;
  options.is_quiet = true;
  std::string rows;
  SweepHooks hooks;
  hooks.write = [&](std::string_view more) {
    rows += more;
    return true;
  };
  judged(file, sweep_file(file.path(), options, hooks));
  return rows;
}

using Paths = const std::vector<std::string>&;

// Those whose answer is a report, in any form.
void run_report(const File& file, Choices& choices) {
  using Command = Outcome (*)(Paths, const AnalyseOptions&);
  static constexpr std::array<Command, 12> kCommands = {
      check_files,
      analyse_files,
      mobility_of_files,
      [](Paths paths, const AnalyseOptions& o) { return graph_files(paths, Matrices::all, "", o); },
      [](Paths paths, const AnalyseOptions& o) { return inputs_files(paths, {}, o); },
      [](Paths paths, const AnalyseOptions& o) { return shift_of_files(paths, {}, o); },
      [](Paths paths, const AnalyseOptions& o) { return duty_of_files(paths, "", o); },
      [](Paths paths, const AnalyseOptions& o) { return motion_of_files(paths, {}, o); },
      [](Paths paths, const AnalyseOptions& o) { return simulate_files(paths, {}, o); },
      [](Paths paths, const AnalyseOptions& o) { return sensitivity_files(paths, {}, o); },
      [](Paths paths, const AnalyseOptions& o) { return tolerance_of_files(paths, {}, o); },
      [](Paths paths, const AnalyseOptions& o) {
        SynthesisOptions synthesis;
        TransmissionOptions transmissions;
        synthesis.jobs = transmissions.jobs = 1;
        return synthesize_files(paths, o, synthesis, transmissions);
      }};
  const StreamFormat format = choices.of(kFormats);
  const Said said = judged(file, choices.of(kCommands)({file.path()}, options_of(format)));
  if (format == StreamFormat::json && said.out.starts_with('{')) {
    parsed(said.out);
  }
}

void run_page(const File& file, Choices&) {
  judged(file, html_report_of_files({file.path()}, {}, options_of(StreamFormat::table)));
}

void run_picture(const File& file, Choices& choices) {
  static const std::vector<std::string> kNames = picture_names();
  PlotChoice choice;
  choice.picture = choices.of(kNames);
  double time = 0.0;
  judged(file, plot_file(file.path(), choice, options_of(StreamFormat::table), [&time] {
           return time += 1.0;
         }));
}

void compare_accuracies(const File& file, Choices&) {
  const Json automatic = analysed(file);
  for (const Accuracy accuracy : {Accuracy::fast, Accuracy::high, Accuracy::exact}) {
    check_accuracies(automatic, analysed(file, accuracy), accuracy == Accuracy::fast);
  }
}

void compare_forms(const File& file, Choices&) {
  const Json report = analysed(file);
  if (!report.contains("mobility")) {
    return;  // none, or that of a synthesis
  }
  check_table(report,
              judged(file, analyse_files({file.path()}, options_of(StreamFormat::csv))).out);
  check_text(report,
             judged(file, analyse_files({file.path()}, options_of(StreamFormat::table))).out);
}

void compare_motion(const File& file, Choices&) {
  check_first_row(
      analysed(file),
      report_of(file, motion_of_files({file.path()}, {}, options_of(StreamFormat::json))));
}

void compare_sweep(const File& file, Choices&) {
  const std::string rows = swept(file);
  if (rows.empty() || !file.has_state()) {
    return;
  }
  const Json report = analysed(file);
  std::istringstream lines(rows);
  for (std::string line; std::getline(lines, line);) {
    check_sweep_row(report, parsed(line));
  }
}

struct Judgement {
  void (*judge)(const File& file, Choices& choices);
  bool asks_for_sweep = false;
};

constexpr std::array<Judgement, 8> kJudgements = {{{run_report},
                                                   {run_report},
                                                   {compare_accuracies},
                                                   {compare_forms},
                                                   {compare_motion},
                                                   {compare_sweep, true},
                                                   {run_page},
                                                   {run_picture}}};

void judge(Choices choices) {
  static const std::vector<std::string_view> kSeeds = read_seeds();
  const std::string seed(choices.of(kSeeds));
  const Judgement& judgement = choices.of(kJudgements);
  Choices its = choices;
  choices.below(1U << 16U);  // two bytes for the judgement
  Diagnostics found;
  std::optional<YamlNode> root = read_yaml({.path = "seed", .text = seed}, {}, found);
  require(root.has_value(), "a file of the library is YAML");
  // Values of one drawing only.
  std::erase_if(root->entries, [](const YamlEntry& one) { return one.key == "published"; });
  for (std::size_t i = 0; i < kMostChanges && !choices.are_used_up(); ++i) {
    change(*root, choices);
  }
  const bool has_state = judgement.asks_for_sweep && add_sweep(*root, choices);
  const File file(written(*root), has_state);
  if (std::getenv("KINESTAT_FUZZ_SHOW") != nullptr) {
    std::fwrite(file.text().data(), 1, file.text().size(), stderr);
  }
  judgement.judge(file, its);
}

}  // namespace

}  // namespace kinestat::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kinestat::fuzz::judge(kinestat::fuzz::Choices({data, size}));
  return 0;
}
