#include "interface/last_messages.hpp"

#include <kinestat.h>
#include <utility>

#include <fmt/format.h>

#include "math/numbers/big_float.hpp"
#include "report/diagnostics/diagnostic_text.hpp"

namespace kinestat {

CallMessages& last_messages() {
  static thread_local CallMessages messages;
  static thread_local const BigFloatMemory memory;  // of a thread that ends before the process
  return messages;
}

void refuse_argument(std::string message, std::string hint, Diagnostics& found) {
  found.error("E0103", {}, std::move(message), std::move(hint));
}

bool is_given(const void* argument, std::string_view what, Diagnostics& found) {
  if (argument == nullptr) {
    refuse_argument(fmt::format("{} is null", what), "give one; 'kinestat.h' says what", found);
  }
  return argument != nullptr;
}

}  // namespace kinestat

size_t kinestat_message_count(void) {
  return kinestat::last_messages().found.items().size();
}

int kinestat_message_at(size_t index, kinestat_message* message) {
  const kinestat::CallMessages& last = kinestat::last_messages();
  if (message == nullptr || index >= last.found.items().size()) {
    return 0;
  }
  const kinestat::Diagnostic& one = last.found.items()[index];
  message->is_error = one.severity == kinestat::Severity::error ? 1 : 0;
  message->code = one.code.data();  // a literal
  message->text = one.message.c_str();
  message->hint = one.hint.c_str();
  message->file = last.source.path.c_str();
  message->line = one.where.line;
  message->column = one.where.column;
  message->length = one.where.length;
  return 1;
}

const char* kinestat_message_text(void) {
  kinestat::CallMessages& last = kinestat::last_messages();
  try {
    last.text = kinestat::diagnostics_text(last.source, last.found).plain();
  } catch (const std::bad_alloc&) {
    return "";
  }
  return last.text.c_str();
}
