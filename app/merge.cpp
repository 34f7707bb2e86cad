#include "run/merge.hpp"

#include "command.hpp"
#include "options/sweep_options.hpp"

namespace kinestat::app {

namespace {

struct MergeCommand {
  std::vector<std::string> paths;
  MergeOptions options;
};

}  // namespace

void add_merge(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat merge shards/teeth.sweep-*.shard > rows.csv\n"
      "  kinestat merge --out results shards/teeth.sweep-*.shard\n");
  auto merge = std::make_shared<MergeCommand>();
  add_argument(command, "SHARD", merge->paths, "all shards of one sweep, in any order").required();
  add_result_folder(command,
                    merge->options.folder,
                    merge->options.overwrite,
                    "existing folder for <name>.sweep.csv (.jsonl,\n"
                    ".npy) and <name>.sweep.json; without it rows go to\n"
                    "standard output");
  add_messages(command, merge->options.diagnostics, merge->options.is_quiet);
  run_when_chosen(command, job, [merge] {
    return run_streaming(
        [&](const SweepHooks& hooks) { return merge_files(merge->paths, merge->options, hooks); },
        {});
  });
}

}  // namespace kinestat::app
