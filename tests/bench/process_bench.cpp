// Times the whole program against an empty C++ process, run alternately.

#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <spawn.h>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include "bench_program.hpp"
#include "long_chain.hpp"
#include "ratio_table.hpp"

extern char** environ;

namespace kinestat::bench {

namespace {

constexpr double kTarget = 10.0;
constexpr int kChainLength = 1000;

struct Times {
  double elapsed = 0.0;    ///< from before the start to after the end [s]
  double processor = 0.0;  ///< user and system time of the process [s]
};

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Runs a program with its standard output discarded.
class Program {
 public:
  explicit Program(std::vector<std::string> words) : words_(std::move(words)) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 1, "/dev/null", O_WRONLY, 0);
    for (std::string& word : words_) {
      argv_.push_back(word.data());
    }
    argv_.push_back(nullptr);
  }

  ~Program() { posix_spawn_file_actions_destroy(&actions_); }

  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  Times run() {
    const auto start = std::chrono::steady_clock::now();
    pid_t id = 0;
    int status = 0;
    rusage usage{};
    const bool has_run =
        posix_spawn(&id, argv_[0], &actions_, nullptr, argv_.data(), environ) == 0 &&
        wait4(id, &status, 0, &usage) == id;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (!has_run || status != 0) {
      throw std::runtime_error("this program failed: " + words_[0]);
    }
    return {.elapsed = elapsed.count(),
            .processor = seconds(usage.ru_utime) + seconds(usage.ru_stime)};
  }

 private:
  std::vector<std::string> words_;
  std::vector<char*> argv_;
  posix_spawn_file_actions_t actions_{};
};

/// A file that lives as long as the object.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text)
      : path_(std::filesystem::temp_directory_path() / "kinestat_bench_XXXXXX") {
    const int file = mkstemp(path_.data());
    const bool is_written =
        file >= 0 && write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    close(file);
    if (!is_written) {
      throw std::runtime_error("cannot write " + path_);
    }
  }

  ~TemporaryFile() { unlink(path_.c_str()); }

  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// One row of the table: what is timed, and what its elapsed time must not exceed.
struct Job {
  std::string name;
  std::vector<std::string> words;
  std::optional<double> target;
};

/// Adds the two ratios of one command line to the table.
void measure(Job job, int rounds, std::vector<Ratio>& table) {
  Program empty({KINESTAT_EMPTY});
  Program program(std::move(job.words));
  std::vector<double> elapsed;
  std::vector<double> processor;
  for (int i = 0; i < 5; ++i) {
    empty.run();
    program.run();
  }
  for (int i = 0; i < rounds; ++i) {
    const Times unit = empty.run();
    const Times time = program.run();
    elapsed.push_back(time.elapsed / unit.elapsed);
    processor.push_back(time.processor / unit.processor);
  }
  table.push_back(make_ratio(job.name + ", elapsed", std::move(elapsed), job.target));
  table.push_back(make_ratio(job.name + ", processor", std::move(processor), {}));
}

std::string run(const Options& options) {
  const std::string program = KINESTAT_PROGRAM;
  const std::string file = KINESTAT_MECHANISM;
  const TemporaryFile chain(long_chain(kChainLength));
  const std::vector<Job> jobs = {
      {"analyze --quiet", {program, "analyze", "--quiet", file}, kTarget},
      {"analyze", {program, "analyze", file}, kTarget},
      {"analyze --format json", {program, "analyze", "--format", "json", file}, kTarget},
      {"check of 1000 couplings", {program, "check", chain.path()}, {}},
      {"--version", {program, "--version"}, kTarget}};
  std::vector<Ratio> table;
  for (const Job& job : jobs) {
    measure(job, options.rounds, table);
  }
  return write_ratios(table, "empty C++ processes", options.form);
}

}  // namespace

}  // namespace kinestat::bench

int main(int argc, char** argv) {
  return kinestat::bench::run_program("process_bench", argc, argv, kinestat::bench::run);
}
