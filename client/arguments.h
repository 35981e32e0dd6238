/// The command line, read.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "client/console.h"
#include "client/outcome.h"

namespace regolab::client {

/// One flat record for all verbs; a verb reads the fields its options fill.
struct Arguments {
  std::string verb;  ///< "run", "article check", ...

  std::string server;  ///< empty = embedded mode
  std::string database = "regolab.db";
  bool json = false;
  ColourChoice colour = ColourChoice::kAuto;

  std::string design;    ///< DESIGN.yaml
  std::string profile;   ///< empty = the design's
  unsigned seeds = 0;    ///< 0 = the design's
  unsigned workers = 0;  ///< 0 = all cores
  bool dry_run = false;

  std::string experiment;  ///< id, unique start of one, name, "last" or empty
  std::uint64_t from_seq = 0;
  double timeout_s = 0;  ///< 0 = none
  bool json_lines = false;
  bool verbose = false;

  bool csv = false;
  std::string output;    ///< file or folder; empty = stdout
  std::string response;  ///< empty = the primary ones
  bool all = false;
  std::vector<int> without;       ///< points a range analysis leaves out
  bool article = false;           ///< the article's own tables instead of an experiment
  std::uint64_t random_seed = 1;  ///< of splits and random starts
  std::string shell = "bash";

  std::vector<std::string> experiments;  ///< to train on
  std::string model;                     ///< id or its start; empty = the newest
  std::string name;                      ///< of a model
  std::vector<std::string> set;          ///< "theta_F=40degree"
  std::vector<std::string> sigma3;       ///< "3 kPa"
  bool curves = false;
  std::string table;                     ///< CSV of materials
  std::string target;                    ///< TARGET.yaml
  bool confirm = false;
  unsigned budget = 40;                  ///< DEM runs
  unsigned candidates = 6;

  std::string bank, kernels;         ///< of `gap`: files
  std::string observations;              ///< OBSERVATIONS.yaml, or a CSV with its map
  std::string map;                       ///< MAP.yaml of a CSV
  bool assume_errors = false;
  std::string diagnosis;                 ///< of `gap show` and `gap report`: an id, its start, or an observation file
  unsigned draws = 8;                    ///< of `gap confirm`, of each model
  std::string time_budget;               ///< of `gap confirm` (empty: an hour) and of `gap diagnose` (empty: no new runs)

  std::string folder;                ///< of `gap blind`: DIR
  std::string key;                   ///< its key's file; empty = beside DIR
  bool own_database = false;         ///< --db was given
  unsigned cases = 96, nulls = 60, specimens = 3;
  bool development = false;          ///< from random_seed instead of entropy
  unsigned only = 0;                 ///< so many cases now; 0 = all
  unsigned jobs = 2;                 ///< solvers at a time
  bool partial = false;

  std::string original_line;  ///< the words after the verb, for "type this again"
};

/// What to do after reading: go on with `arguments`, or print `text` (help, version, a mistake) and leave with `outcome`.
struct Parsed {
  Arguments arguments;
  bool leave = false;
  Outcome outcome;   ///< its text goes to stderr
  std::string text;  ///< goes to stdout
};

Parsed parse(const std::vector<std::string>& words);

/// All verbs, and the long options of each ("" = those of every verb), from the same tree that parses.
struct VerbOptions {
  std::string verb;
  std::vector<std::string> options;
};
std::vector<VerbOptions> known_words();

/// " --db FILE" or " --server ADDR" as needed to type another verb about the same data.
std::string where_flags(const Arguments& arguments);

}  // namespace regolab::client
