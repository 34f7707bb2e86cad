// What the last call of a thread had to say.
#pragma once

#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "core/diagnostic.hpp"
#include "core/exit_status.hpp"
#include "core/source.hpp"
#include "files/outcome.hpp"

namespace kinestat {

/// Of one call.
struct CallMessages {
  SourceFile source;  ///< in which their places are
  Diagnostics found;
  std::string text;  ///< as the program prints them, once it was asked for
};

/// Those of this thread.
CallMessages& last_messages();

/// Complains of an argument.
void refuse_argument(std::string message, std::string hint, Diagnostics& found);

/// Complains of an argument that is null; `what` begins the message: "the path".
bool is_given(const void* argument, std::string_view what, Diagnostics& found);

/// Runs what a call does, which adds its messages; the status of these, and of what it throws.
template <class Call>
int answer_call(Call call) noexcept {
  CallMessages& messages = last_messages();
  try {
    messages = {};
    call(messages);
    return static_cast<int>(status_of(messages.found, Strictness::normal));
  } catch (const std::bad_alloc&) {
    return static_cast<int>(ExitStatus::environment);  // words would need memory, too
  } catch (const std::exception& bug) {
    try {
      add_bug(bug.what(), messages.found);
    } catch (const std::bad_alloc&) {
      return static_cast<int>(ExitStatus::environment);
    }
    return static_cast<int>(ExitStatus::bug);
  }
}

}  // namespace kinestat
