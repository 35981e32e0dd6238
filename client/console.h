/// Where a verb writes: data to `out`, messages and progress to `err`. Tests hand in string streams.
#pragma once
#include <ostream>
#include <string>
#include <string_view>

namespace regolab::client {

struct Console {
  std::ostream& out;
  std::ostream& err;
  bool colour_out = false;
  bool colour_err = false;
  bool live = false;  ///< err is a terminal: one progress line is rewritten in place
  int width = 100;    ///< columns of the terminal
};

enum class ColourChoice { kAuto, kAlways, kNever };

/// What this process's stdout and stderr are; `out` writes to stdout. NO_COLOR and TERM=dumb count as kNever under kAuto.
Console terminal_console(ColourChoice choice, std::ostream& out);

enum class Ink { kRed, kGreen, kYellow, kBold, kDim };

/// Colour is never the only sign: the text says the same without it.
std::string paint(bool on, Ink ink, std::string_view text);

}  // namespace regolab::client
