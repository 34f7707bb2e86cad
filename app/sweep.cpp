#include "run/sweep.hpp"

#include "command.hpp"
#include "options/sweep_options.hpp"
#include "terminal/progress_line.hpp"
#include "terminal/seconds.hpp"
#include "words.hpp"

namespace kinestat::app {

namespace {

struct SweepCommand {
  std::string path;
  SweepOptions options;
  BestChoice top{.count = 0, .criteria = {{}}};
  ProgressChoice progress = ProgressChoice::automatic;
};

void add_sharing(CLI::App& command, SweepOptions& options) {
  add_count(
      command,
      "--jobs",
      [&options](std::uint64_t count) { options.jobs = count; },
      "number of threads; default: one per core. The\n"
      "result does not depend on it");
  with_value(command,
             command.add_option_function<std::string>(
                 "--shard",
                 [&options](const std::string& word) { options.shard = read_shard(word); },
                 "run only the K-th of N parts of the states, for\n"
                 "'kinestat merge'; needs --out"),
             "K/N");
  add_flag(
      command,
      "--resume",
      [&options] { options.resume = true; },
      "continue an interrupted run; needs --out");
}

// "efficiency, smallest abs(ratio - 4)"
BestChoice read_pareto(const std::string& text) {
  std::optional<BestChoice> front = read_front(text);
  if (const std::string guess = guess_of_order(text); !guess.empty()) {
    throw WrongValue("--pareto", text, guess);
  }
  if (!front) {
    throw WrongValue("--pareto",
                     text,
                     "it takes two or three criteria with commas between them, as in "
                     "'efficiency, smallest abs(ratio - 4)'");
  }
  return *std::move(front);
}

// What was given, but for what each share of the sweep has of its own or nobody reads.
std::vector<std::string> words_of_shares(const CLI::App& command) {
  constexpr std::string_view kOwn[] = {
      "--plan", "--jobs", "--shard", "--resume", "--out", "--quiet", "--progress", "--force"};
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (std::ranges::find(kOwn, name) != std::end(kOwn)) {
      continue;
    }
    for (const std::string& value : option->results()) {
      if (!option->get_positional()) {
        words.push_back(name);
      }
      if (option->get_expected_max() > 0) {
        words.push_back(as_written(value));
      }
    }
  }
  return words;
}

void add_choices(CLI::App& command, BestChoice& top, std::optional<BestChoice>& best) {
  add_count(
      command,
      "--top",
      [&top](std::uint64_t count) { top.count = count; },
      "keep only the best N rows; needs --by");
  with_value(command,
             command.add_option("--by",
                                top.criteria.front().by,
                                "the quantity that decides which rows are best, or\n"
                                "a formula: 'abs(ratio - 25)'"),
             "QUANTITY");
  add_choice<RankOrder>(command,
                        "--order",
                        {{std::string(word_of(RankOrder::largest)), RankOrder::largest},
                         {std::string(word_of(RankOrder::smallest)), RankOrder::smallest}},
                        top.criteria.front().order,
                        "which values are best; default: largest");
  with_value(command,
             command.add_option_function<std::string>(
                 "--pareto",
                 [&best](const std::string& text) { best = read_pareto(text); },
                 "keep the rows that no other row equals or beats in\n"
                 "all of two or three criteria: 'efficiency,\n"
                 "smallest abs(ratio - 4)'"),
             "CRITERIA");
}

void add_form(CLI::App& command, SweepCommand& sweep) {
  add_choice<RowFormat>(
      command,
      "--format",
      {{"csv", RowFormat::csv}, {"json", RowFormat::json}, {"npy", RowFormat::npy}},
      sweep.options.format,
      "format of the rows; json is one object per line,\n"
      "npy a NumPy array, which needs --out");
  add_progress(command, sweep.progress);
}

// Options that need each other.
void check_together(CLI::App& command, SweepCommand& sweep) {
  const auto is_given = [&](const char* name) { return command.count(name) > 0; };
  for (const char* name : {"--shard", "--resume"}) {
    if (is_given(name) && sweep.options.folder.empty()) {
      throw LonelyOption(name, "--out", "name the folder for the result, as in --out results");
    }
  }
  if (sweep.options.format == RowFormat::npy && sweep.options.folder.empty() &&
      !is_given("--plan")) {
    throw LonelyOption("--format npy",
                       "--out",
                       "an array begins with the number of its rows, and the words for its numbers "
                       "are in a file beside it: name the folder for both, as in --out results");
  }
  if (is_given("--top") && is_given("--pareto")) {
    throw ForeignOption(
        "--top",
        "--pareto",
        "give --top for the best by one criterion, or --pareto for the front of several");
  }
  if (is_given("--top") != is_given("--by")) {
    throw LonelyOption(is_given("--top") ? "--top" : "--by",
                       is_given("--top") ? "--by" : "--top",
                       "write for example --top 20 --by efficiency");
  }
  if (is_given("--order") && !is_given("--top")) {
    throw LonelyOption("--order",
                       "--top",
                       is_given("--pareto")
                           ? "write for example --pareto 'efficiency, smallest ratio'"
                           : "write for example --top 20 --by ratio --order smallest");
  }
  if (is_given("--top")) {
    sweep.options.best = sweep.top;
  }
  if (is_given("--plan") && sweep.path == "-") {
    throw LonelyOption("--plan",
                       "a file with a name",
                       "its lines read the file on other machines: write standard input to a file");
  }
  if (is_given("--plan")) {
    sweep.options.forecast = {.words = words_of_shares(command), .clock = processor_seconds};
  }
}

Outcome run_sweep(const SweepCommand& sweep) {
  ProgressLine line(sweep.progress);
  const auto show = [&line](const SweepProgress& progress) {
    const auto all = static_cast<double>(std::max<std::uint64_t>(progress.total, 1));
    line.show({.done = progress.states,
               .known = progress.resumed,
               .total = progress.total,
               .things = "states",
               .result = std::to_string(progress.rows) + " rows",
               .share = static_cast<double>(progress.states) / all,
               .known_share = static_cast<double>(progress.resumed) / all});
  };
  Outcome outcome = run_streaming(
      [&](const SweepHooks& hooks) {
        Outcome done = sweep_file(sweep.path, sweep.options, hooks);
        line.finish();
        return done;
      },
      line.is_wanted() ? show : std::function<void(const SweepProgress&)>());
  return outcome;
}

}  // namespace

void add_sweep(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat sweep teeth.yaml > rows.csv\n"
      "  kinestat sweep --top 20 --by ratio --order smallest teeth.yaml\n"
      "  kinestat sweep --pareto 'efficiency, smallest abs(ratio - 4)' teeth.yaml\n"
      "  kinestat sweep --jobs 8 --resume --out results teeth.yaml\n"
      "  kinestat sweep --shard 2/7 --out shards teeth.yaml\n");
  auto sweep = std::make_shared<SweepCommand>();
  add_argument(command,
               "FILE",
               sweep->path,
               "mechanism file with a section sweep; - is standard\n"
               "input")
      .required();
  add_loading(command, sweep->options.load);
  add_curves(command, sweep->options.load);
  add_form(command, *sweep);
  add_result_folder(command,
                    sweep->options.folder,
                    sweep->options.overwrite,
                    "existing folder for <name>.sweep.csv (.jsonl,\n"
                    ".npy) and <name>.sweep.json; without it rows go to\n"
                    "standard output");
  add_sharing(command, sweep->options);
  add_flag(
      command,
      "--plan",
      [] {},
      "show the number of states, about how long they\n"
      "take, and commands for Slurm; runs only a\n"
      "one-second sample");
  add_choices(command, sweep->top, sweep->options.best);
  add_messages(command, sweep->options.diagnostics, sweep->options.is_quiet);
  command.callback([&command, sweep, &job] {
    check_together(command, *sweep);
    job = [sweep] { return run_sweep(*sweep); };
  });
}

}  // namespace kinestat::app
