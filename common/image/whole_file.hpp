#pragma once
/// @file whole_file.hpp
/// A file that appears whole or not at all.

#include <filesystem>
#include <string_view>

namespace sr {

/// Writes `bytes` to a hidden name beside `path` and renames it when it is complete and closed: whoever looks
/// at `path` sees the old file or the new one, also on a full disk or after Ctrl-C. A device or pipe
/// (/dev/stdout) has no old file and is written as it is.
/// @pre    the folder exists
/// @throws std::runtime_error "cannot write figures/x.svg: No space left on device"; nothing is left behind
void write_whole_file(const std::filesystem::path& path, std::string_view bytes);

/// From now on an interrupt (SIGINT, SIGTERM), or writing to a reader that went away (SIGPIPE: `| head`), removes what
/// is half written and ends the program at once with exit code 128 + signal, 130 for Ctrl-C; and a file that grows over
/// its limit is an error, not a signal.
void end_cleanly_on_interrupt();

/// What else the end by such a signal does, from now on: it removes `folder` if that is empty, and an interrupt says
/// `words` on stderr.
void on_interrupt(const std::filesystem::path& folder, std::string_view words);

}  // namespace sr
