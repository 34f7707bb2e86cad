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
                    "folder for <name>.sweep.csv (.jsonl, .npy) and\n"
                    "<name>.sweep.json; it must exist. Without it\n"
                    "rows go to standard output");
  add_messages(command, merge->options.diagnostics, merge->options.is_quiet);
  run_when_chosen(command, job, [merge] {
    return run_streaming(
        [&](const SweepHooks& hooks) { return merge_files(merge->paths, merge->options, hooks); },
        {});
  });
}

}  // namespace kinestat::app
