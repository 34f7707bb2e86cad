#include "terminal/page_opener.hpp"

#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <unistd.h>

namespace kinestat::app {

std::string open_page(const std::string& path) {
  std::string program = "xdg-open";
  std::error_code problem;
  std::string page = std::filesystem::absolute(path, problem).string();
  if (problem) {
    return problem.message();
  }
  char* words[] = {program.data(), page.data(), nullptr};
  posix_spawn_file_actions_t silent;
  posix_spawn_file_actions_init(&silent);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&silent, stream, "/dev/null", O_RDWR, 0);
  }
  pid_t process = 0;
  const int error = posix_spawnp(&process, program.c_str(), &silent, nullptr, words, environ);
  posix_spawn_file_actions_destroy(&silent);
  return error == 0 ? std::string() : std::strerror(error);
}

bool writes_to_terminal() {
  return ::isatty(STDOUT_FILENO) == 1;
}

}  // namespace kinestat::app
