#include <algorithm>
#include <string>
#include <vector>

#include "command.hpp"
#include "options/sweep_options.hpp"
#include "run/synthesis.hpp"
#include "terminal/progress_line.hpp"
#include "usage_error.hpp"

namespace kinestat::app {

namespace {

struct SynthesizeCommand {
  FileOptions files;
  SynthesisOptions options;
  TransmissionOptions transmissions;
  ProgressChoice progress = ProgressChoice::automatic;
};

void add_written_mechanisms(CLI::App& command, SynthesizeCommand& options) {
  with_value(command,
             command.add_option("--write-mechanism",
                                options.files.analyse.output.folder,
                                "existing folder for mechanism files: one for every\n"
                                "usable linkage, <name>.linkage_0.yaml and so on,\n"
                                "or for every listed transmission,\n"
                                "<name>.ladder_0.transmission_0.yaml"),
             "FOLDER");
  add_flag(
      command,
      "--all-linkages",
      [&options] { options.options.written = WrittenLinkages::all; },
      "also write linkages with a defect or outside the\n"
      "limits; needs --write-mechanism");
  add_flag(
      command,
      "--force",
      [&options] { options.files.analyse.output.overwrite = Overwrite::force; },
      "replace files that this program did not write;\n"
      "needs --write-mechanism");
}

void add_digits(CLI::App& command, SynthesisOptions& options) {
  add_count(
      command,
      "--digits",
      [&options](std::uint64_t count) {
        if (count < kLeastDigits) {
          throw WrongValue("--digits",
                           std::to_string(count),
                           "it is 17 to 100; without it numbers have 16 digits");
        }
        if (count > kMostDigits) {
          throw WrongValue(
              "--digits", std::to_string(count), "it is 17 to 100, for example --digits 40");
        }
        options.digits = static_cast<int>(count);
      },
      "decimal digits of the typed positions to use, 17\n"
      "to 100, where 16 leave too few of the dyads");
}

void add_rank(CLI::App& command, TransmissionOptions& options) {
  Choices<TransmissionRank> ranks;
  for (std::size_t i = 0; i < kTransmissionOrders.size(); ++i) {
    ranks.emplace_back(kTransmissionOrders[i], static_cast<TransmissionRank>(i));
  }
  add_choice<TransmissionRank>(command,
                               "--by",
                               ranks,
                               options.rank,
                               "what transmissions are ranked by, instead of\n"
                               "'rank' in the file");
}

void add_stored_search(CLI::App& command, TransmissionOptions& options) {
  with_value(command,
             command.add_option("--work",
                                options.work,
                                "existing folder in which a search for\n"
                                "transmissions keeps finished work: the same\n"
                                "command continues after an interruption and\n"
                                "combines shards"),
             "FOLDER");
  with_value(command,
             command.add_option_function<std::string>(
                 "--shard",
                 [&options](const std::string& word) {
                   const ShardNumber shard = read_shard(word);
                   options.share = {.place = shard.number - 1, .count = shard.count};
                 },
                 "search only the K-th of N parts of the structures;\n"
                 "needs --work"),
             "K/N");
}

// What says how to write needs a place to write to.
void check_together(const CLI::App& command, const SynthesizeCommand& options) {
  for (const char* name : {"--all-linkages", "--force"}) {
    if (command.count(name) > 0 && options.files.analyse.output.folder.empty()) {
      throw LonelyOption(name,
                         "--write-mechanism",
                         "name the folder for the files, as in --write-mechanism linkages");
    }
  }
  if (options.transmissions.share && options.transmissions.work.empty()) {
    throw LonelyOption(
        "--shard",
        "--work",
        "name the folder in which all shards keep what they find, as in --work found");
  }
}

Outcome run_synthesis(const SynthesizeCommand& options) {
  ProgressLine line(options.progress);
  TransmissionOptions transmissions = options.transmissions;
  if (line.is_wanted()) {
    transmissions.progress = [&line](const SearchProgress& progress) {
      line.show({.done = progress.structures,
                 .known = progress.known,
                 .total = progress.total,
                 .things = "structures",
                 .result = std::to_string(progress.found) + " transmissions",
                 .share = progress.share,
                 .known_share = progress.known_share});
    };
  }
  Outcome outcome =
      synthesize_files(options.files.paths, options.files.analyse, options.options, transmissions);
  line.finish();
  return outcome;
}

}  // namespace

void add_synthesize(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat new synthesis task.yaml\n"
      "  kinestat synthesize task.yaml\n"
      "  kinestat synthesize --format json task.yaml\n"
      "  kinestat synthesize --write-mechanism linkages task.yaml\n"
      "  kinestat synthesize --digits 40 close_positions.yaml\n"
      "  kinestat synthesize --top 5 --by steps gears.yaml\n");
  auto options = std::make_shared<SynthesizeCommand>();
  add_files(command, options->files);
  add_format(command, options->files);
  add_written_mechanisms(command, *options);
  add_flag(
      command,
      "--verify",
      [options] { options->options.verifies = true; },
      "move every linkage as a mechanism and report\n"
      "whether it does what its verdict says, or solve\n"
      "every listed transmission gear by gear; those\n"
      "written are always verified");
  add_digits(command, options->options);
  add_count(
      command,
      "--jobs",
      [options](std::uint64_t count) {
        options->options.jobs = count;
        options->transmissions.jobs = count;
      },
      "number of threads for a search; default: one per\n"
      "core. The result does not depend on it");
  add_count(
      command,
      "--top",
      [options](std::uint64_t count) { options->transmissions.top = count; },
      "number of transmission ladders to list, best\n"
      "first; default 20");
  add_rank(command, options->transmissions);
  add_stored_search(command, options->transmissions);
  add_progress(command, options->progress);
  add_strict(command, options->files);
  add_quiet(command, options->files);
  command.callback([options, &command, &job] {
    check_together(command, *options);
    job = [options] { return run_synthesis(*options); };
  });
}

}  // namespace kinestat::app
