/// Damaged copies of a text, for readers that must never crash: the same ones on every run.
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace regolab::testing_support {

/// A small generator (splitmix64) so that mutations do not depend on the standard library.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t n) { return n == 0 ? 0 : next() % n; }

 private:
  std::uint64_t state_;
};

/// One to four damages: a byte changed, a piece cut out, doubled or moved, a token put in, the end cut off.
inline std::string mutated(std::string text, Dice& dice) {
  constexpr std::string_view kTokens[] = {"[",   "]",    "{",     "}",  ":",     "- ",  "\n",    "&a ",
                                          "*a",  "!!x ", "'",     "\"", "#",     "|",   "---\n", "? ",
                                          "nan", ".inf", "1e999", "-1", "0",     "N/m", " kPa",  "\xC3",
                                          "\0",  "%",    "<<: ",  "~",  "K_N: ", ", ",  "\t",    "micro: "};
  for (std::size_t damages = 1 + dice.below(4); damages > 0; --damages) {
    const std::size_t at = dice.below(text.size() + 1);
    const std::size_t length = dice.below(std::min<std::size_t>(text.size() - at, 40) + 1);
    switch (dice.below(6)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(dice.below(256));
        break;
      case 1: text.erase(at, length); break;
      case 2: text.insert(at, text.substr(at, length)); break;
      case 3: text.insert(at, kTokens[dice.below(std::size(kTokens))]); break;
      case 4: text.insert(dice.below(text.size() + 1), text.substr(at, length)); break;
      default:
        if (dice.below(4) == 0) text.resize(at);
    }
  }
  return text;
}

}  // namespace regolab::testing_support
