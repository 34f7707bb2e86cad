// Files that are written whole or not at all.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "core/diagnostic.hpp"

namespace kinestat {

/// The next piece of a file that is too large to be held at once; false at its end.
using NextPiece = std::function<bool(std::string& piece)>;

/// A file to be written.
struct OutputFile {
  std::string path;
  std::string content;
  std::string signature;  ///< how a file of this kind begins, by which our own one is recognised
  NextPiece next_piece = {};  ///< what follows the content, if anything
  std::string scratch = {};   ///< folder for the temporary, on the same disk; empty: that of `path`
  bool survives_crash = true;  ///< of the system; if not, it may then hold anything, but is sooner
                               ///< written: for what tells by itself whether it is whole
};

enum class Overwrite {
  own_only,  ///< a present file is replaced only if it begins with a signature that is not empty
  force      ///< any present file is replaced, but no folder, device or pipe
};

/// The paths of what a command reads, which it never replaces; "-" is none.
using InputPaths = std::span<const std::string>;

/// Writes all files or none. Each is written, and synced if it is to survive a crash, as a
/// temporary in the folder of its target, with the mode that the umask leaves; then all take their
/// places. When anything fails, the temporaries are removed and what was there before is there
/// again. A symbolic link at the target is replaced, not followed. E0152 when the system refuses,
/// E0153 for a foreign file and for one of the inputs; false iff an error was added. A process that
/// writes near its file size limit must ignore SIGXFSZ.
bool write_files(std::span<const OutputFile> files,
                 Overwrite overwrite,
                 InputPaths inputs,
                 Diagnostics& found);

/// Asks, before anything is computed, whether the files may take their places (E0152, E0153).
bool check_places(std::span<const OutputFile> files,
                  Overwrite overwrite,
                  InputPaths inputs,
                  Diagnostics& found);

/// Asks, before anything is computed, whether files can be written into a folder: it exists, is a
/// folder and may be written to (E0152). The empty path is the working folder.
bool check_output_folder(const std::string& folder, Diagnostics& found);

}  // namespace kinestat
