// An open file of the operating system, closed when it goes out of scope.
#pragma once

#include <unistd.h>

namespace kinestat {

/// Owns a file descriptor; a negative one stands for a failed open.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}

  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&&) = delete;
  Descriptor& operator=(Descriptor&&) = delete;

  ~Descriptor() { close(); }

  bool is_open() const { return value_ >= 0; }

  int value() const { return value_; }

  /// Closes early, to hear about errors that come only then.
  bool close() {
    const int closing = value_;
    value_ = -1;
    return closing < 0 || ::close(closing) == 0;
  }

 private:
  int value_ = -1;
};

}  // namespace kinestat
