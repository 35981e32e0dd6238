#include "client/console.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>

namespace regolab::client {
namespace {

bool wants_colour(ColourChoice choice, int fd) {
  if (choice != ColourChoice::kAuto) return choice == ColourChoice::kAlways;
  const char* no_colour = std::getenv("NO_COLOR");
  if (no_colour != nullptr && *no_colour != '\0') return false;
  const char* terminal = std::getenv("TERM");
  if (terminal == nullptr || std::string_view(terminal) == "dumb") return false;
  return isatty(fd) != 0;
}

int columns() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 100;
}

const char* code_of(Ink ink) {
  switch (ink) {
    case Ink::kRed: return "31";
    case Ink::kGreen: return "32";
    case Ink::kYellow: return "33";
    case Ink::kBold: return "1";
    case Ink::kDim: return "2";
  }
  return "0";
}

}  // namespace

Console terminal_console(ColourChoice choice, std::ostream& out) {
  return {.out = out,
          .err = std::cerr,
          .colour_out = wants_colour(choice, STDOUT_FILENO),
          .colour_err = wants_colour(choice, STDERR_FILENO),
          .live = isatty(STDERR_FILENO) != 0,
          .width = columns()};
}

std::string paint(bool on, Ink ink, std::string_view text) {
  if (!on) return std::string(text);
  return std::string("\x1b[") + code_of(ink) + "m" + std::string(text) + "\x1b[0m";
}

}  // namespace regolab::client
