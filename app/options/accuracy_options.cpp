#include "options/accuracy_options.hpp"

#include "options/sweep_options.hpp"

namespace kinestat::app {

void add_accuracy(CLI::App& command, AccuracyRequest& request) {
  using enum Accuracy;
  add_choice<Accuracy>(command,
                       "--accuracy",
                       {{"auto", automatic}, {"fast", fast}, {"high", high}, {"exact", exact}},
                       request.accuracy,
                       "how errors are bounded and made smaller;\n"
                       "'kinestat help accuracy' says at what price");
  add_count(
      command,
      "--digits",
      [&request](std::uint64_t count) {
        if (count > kMostAskedDigits) {
          throw WrongValue(
              "--digits", std::to_string(count), "it is 1 to 15, as values are written as doubles");
        }
        request.digits = static_cast<int>(count);
      },
      "decimal digits of a value that must be right\n"
      "with auto, 1 to 15; without it 9");
}

}  // namespace kinestat::app
