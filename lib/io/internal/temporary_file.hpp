// A file beside its target that takes the target's place when it is complete.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace kinestat {

/// How the names of temporaries begin and end; of those that need not survive a crash, which are
/// pieces of long results, the beginning goes on so.
inline constexpr std::string_view kTemporaryPrefix = ".kinestat-";
inline constexpr std::string_view kPiecePrefix = ".kinestat-piece-";
inline constexpr std::string_view kTemporaryEnding = ".tmp";

/// The folder in which a path lies.
std::string folder_of(const std::string& path);

/// Syncs a folder, so that the names in it survive a crash; 0, or the error of the system.
int sync_folder(const std::string& folder);

/// What stood at the target when it was looked at.
enum class Present { nothing, file };

/// Is removed when it goes out of scope. Functions with a result answer 0 or the system's error.
class TemporaryFile {
 public:
  /// It is made in the folder `scratch`, or beside the target if that is empty.
  TemporaryFile(std::string target,
                Present present,
                std::string scratch = {},
                bool survives_crash = true)
      : target_(std::move(target)),
        present_(present),
        scratch_(std::move(scratch)),
        survives_crash_(survives_crash) {}

  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile(TemporaryFile&& other) noexcept;
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  ~TemporaryFile();

  const std::string& target() const { return target_; }

  bool survives_crash() const { return survives_crash_; }

  /// Creates it under a name that nobody can foresee, writes the content and then piece after piece
  /// until `next_piece`, which may be empty, answers false, and syncs if it is to survive
  /// a crash.
  int write(std::string_view content, const std::function<bool(std::string&)>& next_piece = {});

  /// Takes the target's place. A file that was there is kept under the temporary's name until the
  /// end; one that has appeared meanwhile is an error.
  int take_place();

  /// Undoes take_place.
  void give_back();

 private:
  enum class Place { nowhere, beside, exchanged, moved, moved_for_good };

  int create();

  std::string target_;
  Present present_ = Present::nothing;
  std::string scratch_;
  bool survives_crash_ = true;
  std::string path_;
  Place place_ = Place::nowhere;
};

}  // namespace kinestat
