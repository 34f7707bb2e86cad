// kinestat.h for C++17 and later: objects that free themselves, errors as exceptions.
#ifndef KINESTAT_HPP
#define KINESTAT_HPP

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "kinestat.h"

namespace kinestat {

/// A call that failed. `what` is the text that the program would print, with the line of the file
/// and the place marked in it; `status` and the messages are those of kinestat.h.
class CallError : public std::runtime_error {
 public:
  struct Message {
    bool is_error = false;
    std::string code;
    std::string text;
    std::string hint;
    std::string file;
    int line = 0;
    int column = 0;
    int length = 0;
  };

  explicit CallError(int status)
      : std::runtime_error(text_of(status)), status_(status), messages_(last_messages()) {}

  int status() const { return status_; }

  const std::vector<Message>& messages() const { return messages_; }

  /// The messages of the last call of this thread, including warnings of a successful one.
  static std::vector<Message> last_messages() {
    std::vector<Message> result;
    kinestat_message one;
    for (std::size_t i = 0; kinestat_message_at(i, &one) != 0; ++i) {
      result.push_back({one.is_error != 0,
                        one.code,
                        one.text,
                        one.hint,
                        one.file,
                        one.line,
                        one.column,
                        one.length});
    }
    return result;
  }

 private:
  static std::string text_of(int status) {
    const std::string text = kinestat_message_text();
    return text.empty() ? "kinestat: status " + std::to_string(status) : text;
  }

  int status_;
  std::vector<Message> messages_;
};

inline void check_status(int status) {
  if (status != KINESTAT_DONE) {
    throw CallError(status);
  }
}

/// What `kinestat analyze` reports of a mechanism.
class Report {
 public:
  Report(kinestat_report* handle, int status) : handle_(handle), status_(status) {}

  /// KINESTAT_DONE, KINESTAT_CHECK_FAILED or KINESTAT_NO_ANSWER.
  int status() const { return status_; }

  std::string json() const { return kinestat_json(handle_.get()); }

  /// The number at a JSON Pointer, in the unit of the file: "/cases/M1/ratio". NaN if it has no
  /// value.
  double number(const std::string& pointer) const {
    double result = 0.0;
    check_status(kinestat_number(handle_.get(), pointer.c_str(), &result));
    return result;
  }

 private:
  struct Free {
    void operator()(kinestat_report* handle) const { kinestat_free_report(handle); }
  };

  std::unique_ptr<kinestat_report, Free> handle_;
  int status_;
};

/// The recorded solution of a case.
class Tape {
 public:
  explicit Tape(kinestat_tape* handle, std::size_t inputs) : handle_(handle), inputs_(inputs) {}

  std::size_t input_count() const { return inputs_; }

  std::size_t output_count() const { return kinestat_output_count(handle_.get()); }

  std::string output_name(std::size_t i) const { return kinestat_output_name(handle_.get(), i); }

  std::string output_unit(std::size_t i) const { return kinestat_output_unit(handle_.get(), i); }

  std::string input_unit(std::size_t i) const { return kinestat_input_unit(handle_.get(), i); }

  /// Inputs and outputs state by state. NaN is an output without a value.
  std::vector<double> play(const std::vector<double>& inputs,
                           std::vector<std::string>* statuses = nullptr) {
    const std::size_t states = inputs.size() / inputs_;
    if (states * inputs_ != inputs.size()) {
      throw std::invalid_argument("kinestat: the last state lacks inputs");
    }
    std::vector<double> outputs(states * output_count());
    std::vector<const char*> words(states);
    check_status(kinestat_play(handle_.get(), inputs.data(), states, outputs.data(), words.data()));
    if (statuses != nullptr) {
      statuses->assign(words.begin(), words.end());
    }
    return outputs;
  }

  bool is_played() const { return kinestat_is_played(handle_.get()) != 0; }

 private:
  struct Free {
    void operator()(kinestat_tape* handle) const { kinestat_free_tape(handle); }
  };

  std::unique_ptr<kinestat_tape, Free> handle_;
  std::size_t inputs_;
};

/// A mechanism file with the values of its parameters.
class MechanismFile {
 public:
  static MechanismFile read(const std::string& path) {
    kinestat_mechanism* handle = nullptr;
    check_status(kinestat_read_file(path.c_str(), &handle));
    return MechanismFile(handle);
  }

  static MechanismFile parse(const std::string& text, const std::string& name = "<text>") {
    kinestat_mechanism* handle = nullptr;
    check_status(kinestat_read_text(text.data(), text.size(), name.c_str(), &handle));
    return MechanismFile(handle);
  }

  /// "24", "20 deg", "2*N1".
  void set(const std::string& parameter, const std::string& value) {
    check_status(kinestat_set(handle_.get(), parameter.c_str(), value.c_str()));
  }

  std::vector<std::string> names(kinestat_names which) const {
    std::vector<std::string> result;
    while (const char* name = kinestat_name(handle_.get(), which, result.size())) {
      result.emplace_back(name);
    }
    return result;
  }

  /// Throws if there is no report.
  Report analyze() const {
    kinestat_report* report = nullptr;
    const int status = kinestat_analyze(handle_.get(), &report);
    if (report == nullptr) {
      throw CallError(status);
    }
    return Report(report, status);
  }

  /// An empty label: the only case; no outputs: the default outputs of a sweep.
  Tape record(const std::vector<std::string>& inputs,
              const std::vector<std::string>& outputs = {},
              const std::string& label = {}) const {
    const std::vector<const char*> in = pointers(inputs);
    const std::vector<const char*> out = pointers(outputs);
    kinestat_tape* tape = nullptr;
    check_status(kinestat_record(handle_.get(),
                                 label.empty() ? nullptr : label.c_str(),
                                 in.data(),
                                 in.size(),
                                 out.data(),
                                 out.size(),
                                 &tape));
    return Tape(tape, inputs.size());
  }

 private:
  explicit MechanismFile(kinestat_mechanism* handle) : handle_(handle) {}

  static std::vector<const char*> pointers(const std::vector<std::string>& list) {
    std::vector<const char*> result;
    for (const std::string& one : list) {
      result.push_back(one.c_str());
    }
    return result;
  }

  struct Free {
    void operator()(kinestat_mechanism* handle) const { kinestat_free_mechanism(handle); }
  };

  std::unique_ptr<kinestat_mechanism, Free> handle_;
};

}  // namespace kinestat

#endif  // KINESTAT_HPP
