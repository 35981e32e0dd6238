#include "client/arguments.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>

#include "client/address.h"
#include "input/suggestion.h"

namespace regolab::client {
namespace {

constexpr const char* kExamples =
    "Orthogonal-array studies of lunar-soil simulants with the discrete element method.\n\n"
    "Examples:\n"
    "  regolab run client/examples/article-l32.yaml --profile quick   the article's study, from design to range analysis\n"
    "  regolab run study.yaml --dry-run                               what it would do, and what is stored already\n"
    "  regolab range last --response repose_angle                     range analysis and ANOVA of one response\n"
    "  regolab results last --csv -o study.csv                        every number, for R, pandas or a spreadsheet\n"
    "  regolab submit study.yaml --server lab-host:7070               the same against a scheduler that runs elsewhere\n"
    "Data goes to stdout, messages to stderr. Exit codes: 0 done, 1 internal, 2 usage, 3 invalid input, 4 no scheduler,\n"
    "5 some trials have no numbers, 6 timeout, 130 interrupted.\n";

/// The CLI11 tree and the record its options fill. Neither copied nor moved: options point into it.
struct Tree {
  CLI::App app{kExamples, "regolab"};
  Arguments arguments;
  std::string colour = "auto";
  bool version = false;
  CLI::Option* database = nullptr;
  CLI::Option* server = nullptr;

  Tree() {
    app.require_subcommand(0, 1);
    app.fallthrough();
    app.set_help_flag("-h,--help", "this text; `regolab VERB --help` for one verb");
    server =
        app.add_option("--server", arguments.server, "a running scheduler, HOST:PORT or unix:/path (or set REGOLAB_SERVER)")
            ->type_name("ADDR");
    database = app.add_option("--db", arguments.database, "database to work on without a running scheduler [./regolab.db]")
                   ->type_name("FILE");
    app.add_flag("--json", arguments.json, "one JSON document on stdout instead of text");
    app.add_option("--color", colour, "auto, always or never")
        ->check(CLI::IsMember({"auto", "always", "never"}))
        ->type_name("WHEN");
    app.add_flag("--version", version, "what `regolab version` says");
    add_study_verbs();
    add_experiment_verbs();
    add_surrogate_verbs();
    add_gap_verbs();
    add_article_verbs();
  }

  CLI::App* verb(CLI::App& parent, const std::string& name, const std::string& what) {
    CLI::App* sub = parent.add_subcommand(name, what);
    sub->fallthrough();
    std::string full = name;
    for (const CLI::App* above = &parent; above != &app; above = above->get_parent()) full = above->get_name() + " " + full;
    sub->final_callback([this, full] { arguments.verb = full; });
    return sub;
  }

  void design_of(CLI::App* sub) {
    sub->add_option("DESIGN", arguments.design, "design.yaml: factors, fixed parameters, array, seeds, tests")->required();
    sub->add_option("--profile", arguments.profile, "accuracy, louder than the file: quick, standard or article")
        ->type_name("NAME");
    sub->add_option("--seeds", arguments.seeds, "seeds per row, louder than the file")
        ->check(CLI::Range(1, 10000))
        ->type_name("K");
  }

  void workers_of(CLI::App* sub) {
    sub->add_option("--workers", arguments.workers, "worker processes, without --server [all cores]")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    sub->add_option("--timeout", arguments.timeout_s, "leave with exit code 6 after so many seconds; nothing is lost")
        ->check(CLI::PositiveNumber)
        ->type_name("S");
    sub->add_flag("-v,--verbose", arguments.verbose, "a line for every finished stage");
  }

  void experiment_of(CLI::App* sub) {
    sub->add_option("ID", arguments.experiment, "experiment: its id, the start of it, its name, or `last` [last]");
  }

  void output_of(CLI::App* sub) {
    sub->add_option("-o,--output", arguments.output, "write there instead of stdout")->type_name("FILE");
  }

  void add_study_verbs() {
    auto* run = verb(app, "run", "run a study to its range analysis; running it again goes on where it stopped");
    design_of(run);
    workers_of(run);
    run->add_flag("--dry-run", arguments.dry_run, "check the design and show what would be done");
    auto* submit = verb(app, "submit", "hand in a study and leave");
    design_of(submit);
    auto* watch = verb(app, "watch", "follow an experiment until it ends; Ctrl-C only stops watching");
    experiment_of(watch);
    workers_of(watch);
    watch->add_option("--from-seq", arguments.from_seq, "first event wanted")->type_name("SEQ");
    watch->add_flag("--json-lines", arguments.json_lines, "every event as a line of JSON");
    auto* design = app.add_subcommand("design", "look at a design before it runs");
    design->require_subcommand(1);
    design->fallthrough();
    design_of(verb(*design, "show", "check a design; array, strength, balance, error degrees of freedom, jobs"));
    design_of(verb(app, "validate", "the same as `design show`"));
  }

  void add_experiment_verbs() {
    experiment_of(verb(app, "status", "all experiments, or one in detail"));
    experiment_of(verb(app, "cancel", "stop an experiment; what is done stays"));
    experiment_of(verb(app, "retry", "failed, cancelled and quarantined jobs once more"));
    auto* results = verb(app, "results", "one line per row and seed");
    experiment_of(results);
    results->add_flag("--csv", arguments.csv, "every response with every digit, as CSV");
    results->add_flag("--all", arguments.all, "secondary responses in the table too");
    output_of(results);
    auto* range = verb(app, "range", "range analysis, ANOVA and fragility");
    experiment_of(range);
    range->add_option("--response", arguments.response, "one response, or `all` [the article's]")->type_name("NAME");
    range->add_option("--without", arguments.without, "leave this point out; may be repeated")->type_name("POINT")->allow_extra_args(false);
    range->add_flag("--article", arguments.article, "of the article's own tables");
    range->add_flag("--csv", arguments.csv, "a line per response, factor and level, as CSV");
    auto* export_verb = verb(app, "export", "every stage with its specification, numbers and curves, as files");
    experiment_of(export_verb);
    export_verb->add_option("-o,--output", arguments.output, "a folder that does not exist yet")
        ->type_name("DIR")
        ->required();
  }

  void add_surrogate_verbs() {
    const auto model_of = [this](CLI::App* sub) {
      sub->add_option("--model", arguments.model, "a model's id, or its start [the newest here, else the program's own]")->type_name("ID");
    };
    auto* train = verb(app, "train", "fit a surrogate to experiments; tells how well it predicts points it has not seen");
    train->add_option("ID", arguments.experiments, "experiments whose points are learned together")->required();
    train->add_option("--name", arguments.name, "of the model [the first experiment's]")->type_name("NAME");
    train->add_option("-o,--output", arguments.output, "the model as a file, too")->type_name("FILE");
    model_of(verb(app, "models", "trained models: inputs, ranges, how well they predict"));
    auto* predict = verb(app, "predict", "properties of a material without a DEM run, with 90 % bands");
    predict->add_option("--set", arguments.set, "a parameter with its unit: --set theta_F=40degree --set N_E=2 ...")->type_name("NAME=VALUE");
    predict->add_option("--table", arguments.table, "many materials: CSV with columns as in a design's table")->type_name("FILE");
    predict->add_option("--sigma3", arguments.sigma3, "sigma1 at this confining stress too, anywhere between those of the data")->type_name("STRESS");
    predict->add_flag("--curves", arguments.curves, "stress-strain curves under each --sigma3");
    predict->add_flag("--csv", arguments.csv, "as CSV");
    output_of(predict);
    model_of(predict);
    auto* invert = verb(app, "invert", "materials that should measure what a target file asks for");
    invert->add_option("TARGET", arguments.target, "target.yaml: targets with tolerances, fixed and free parameters")->required();
    invert->add_option("--candidates", arguments.candidates, "how many to show")->check(CLI::Range(1, 64))->type_name("N");
    invert->add_flag("--confirm", arguments.confirm, "run the best in DEM, learn from it, and repeat until the targets are met or the budget is spent");
    invert->add_option("--budget", arguments.budget, "DEM runs (settling and each test count one) of --confirm")->check(CLI::Range(2, 100000))->type_name("RUNS");
    invert->add_option("--seeds", arguments.seeds, "seeds of a confirmation [4]")->check(CLI::Range(1, 1000))->type_name("K");
    workers_of(invert);
    model_of(invert);
  }

  void measurements_of(CLI::App* sub) {
    sub->add_option("OBSERVATIONS", arguments.observations, "observations.yaml, or a CSV with --map; at most 16 MiB")->required();
    sub->add_option("--map", arguments.map, "what the columns of a CSV are")->type_name("MAP");
    sub->add_flag("--assume-errors", arguments.assume_errors, "where no standard error is given, a stated default, marked in every report");
  }

  /// A file of measurements, and what it is compared with.
  void question_of(CLI::App* sub) {
    measurements_of(sub);
    bank_of(sub);
    sub->add_option("--seed", arguments.random_seed, "of the sampler [1]")->type_name("N");
  }

  void add_gap_verbs() {
    auto* gap = app.add_subcommand("gap", "measurements of a real material beside our own runs");
    gap->require_subcommand(1);
    gap->fallthrough();
    auto* import = verb(*gap, "import", "read and check what was measured: features, errors, what takes no part and why");
    measurements_of(import);
    import->add_option("-o,--output", arguments.output, "the observations in normal form, as YAML")->type_name("FILE");
    auto* bank = verb(*gap, "bank", "what our own runs gave, as the same features: a row for each point and seed");
    bank->add_option("ID", arguments.experiments, "experiments whose points stand in one table")->required();
    output_of(bank);
    auto* emulate = verb(*gap, "emulate", "fit a bank's emulators, so that a diagnosis need not; minutes");
    emulate->add_option("BANK", arguments.bank, "bank.csv")->required();
    output_of(emulate);
    auto* locate = verb(*gap, "locate", "only where the simulation is wrong: each group of measurements beside what the others foretell");
    question_of(locate);
    auto* diagnose = verb(*gap, "diagnose", "where the simulation is wrong, which effect explains it, or none of these; killed, it goes on where it was");
    question_of(diagnose);
    diagnose->add_option("--report", arguments.output, "also as one HTML file")->type_name("FILE");
    diagnose->add_option("--budget", arguments.time_budget, "go on with `gap confirm`, as far as this time allows")->type_name("TIME");
    auto* confirm = verb(*gap, "confirm", "how far the gap shrinks: new DEM runs, measured on stress levels that the fit has not seen");
    question_of(confirm);
    confirm->add_option("--draws", arguments.draws, "runs of each model, drawn from its posterior [8]")->check(CLI::Range(4, 12))->type_name("N");
    confirm->add_option("--budget", arguments.time_budget, "as many draws as fit into this time, four at least [1h]")->type_name("TIME");
    confirm->add_option("--report", arguments.output, "also as one HTML file")->type_name("FILE");
    workers_of(confirm);
    verb(*gap, "ls", "diagnoses in the store");
    auto* show = verb(*gap, "show", "a diagnosis in the store");
    show->add_option("ID", arguments.diagnosis, "its id, the start of it, or the observation file")->required();
    auto* report = verb(*gap, "report", "a diagnosis in the store as one HTML file that needs no script and no network");
    report->add_option("ID", arguments.diagnosis, "its id, the start of it, or the observation file")->required();
    report->add_option("-o,--output", arguments.output, "the file")->type_name("FILE")->required();
    question_of(verb(*gap, "next", "which test would tell most about which cause it is, per hour; a diagnosis comes first"));
    add_blind_verbs(*gap);
  }

  void bank_of(CLI::App* sub) {
    sub->add_option("--bank", arguments.bank, "another bank than the program's own")->type_name("FILE");
    sub->add_option("--kernels", arguments.kernels, "of that bank, as `gap emulate` wrote them")->type_name("FILE");
  }

  void add_blind_verbs(CLI::App& gap) {
    auto* blind = gap.add_subcommand("blind", "check the diagnosis on cases whose truth is withheld: make, solve, reveal");
    blind->require_subcommand(1);
    blind->fallthrough();
    const auto folder_of = [this](CLI::App* sub) { sub->add_option("DIR", arguments.folder, "folder of the set")->required(); };
    const auto key_of = [this](CLI::App* sub) { sub->add_option("--key", arguments.key, "file with the key of the truths, outside DIR [DIR.key]")->type_name("FILE"); };
    const auto only_of = [this](CLI::App* sub) { sub->add_option("--only", arguments.only, "so many cases now; call again for more")->check(CLI::Range(1, 100000))->type_name("N"); };
    auto* make = verb(*blind, "make", "draw truths, commit to them, run them in DEM, write what was measured; goes on where it stopped");
    folder_of(make), key_of(make), only_of(make), workers_of(make);
    make->add_option("--cases", arguments.cases, "main cases: effects, nulls, unknowns, pairs [96]")->check(CLI::Range(0, 100000))->type_name("N");
    make->add_option("--nulls", arguments.nulls, "extra nulls [60]")->check(CLI::Range(0, 100000))->type_name("N");
    make->add_option("--specimens", arguments.specimens, "of each case [3]")->check(CLI::Range(1, 100))->type_name("K");
    make->add_option("--seed", arguments.random_seed, "a DEVELOPMENT set from this number, marked so everywhere, never a record")
        ->each([this](const std::string&) { arguments.development = true; })
        ->type_name("N");
    auto* solve = verb(*blind, "solve", "answer each case from its observation file alone, in a process that can read nothing else");
    folder_of(solve), only_of(solve), bank_of(solve);
    solve->add_option("--jobs", arguments.jobs, "solvers at a time [2]")->check(CLI::Range(1, 256))->type_name("N");
    auto* reveal = verb(*blind, "reveal", "open the truths, check every commitment, score the answers, write the record");
    folder_of(reveal), key_of(reveal), bank_of(reveal);
    reveal->add_flag("--partial", arguments.partial, "although some cases have no answer; those stay sealed");
  }

  void add_article_verbs() {
    auto* article = app.add_subcommand("article", "the article's own tables");
    article->require_subcommand(1);
    article->fallthrough();
    auto* check = verb(*article, "check", "recompute Tables 4, 6, 8 and 10 from 3, 5, 7 and 9");
    check->add_flag("--all", arguments.all, "every entry, not only those that disagree");
    experiment_of(verb(*article, "compare", "our results beside the article's"));
    auto* functions = verb(*article, "functions", "train the prediction functions BP-ANN-1, -2, -3; R beside Table 12");
    functions->add_option("ID", arguments.experiment,
                          "train on this experiment: its id, the start of it, its name, or `last` [the article's tables]");
    functions->add_flag("--article", arguments.article, "train on the article's own tables, said aloud");
    functions->add_option("--seed", arguments.random_seed, "of the 70/15/15 split and the random starts [1]")
        ->check([](const std::string& word) {  // CLI11 itself would wrap a negative number around
          return word.starts_with('-') ? "a whole number from 0 is wanted, not " + word : std::string();
        })
        ->type_name("N");
    auto* effects = app.add_subcommand("effects", "candidate effects that the base model leaves out");
    effects->require_subcommand(1);
    effects->fallthrough();
    verb(*effects, "ls", "name, parameter, prior range, stages it acts in, law, what it moves, source, version");
    verb(app, "version", "versions of program and physics");
    auto* completion = verb(app, "completion", "a completion script for bash: source <(regolab completion)");
    completion->add_option("SHELL", arguments.shell, "bash")->check(CLI::IsMember({"bash"}));
  }
};

std::vector<std::string> names_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) names.push_back(sub->get_name());
  return names;
}

std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// Does the option take the next word as its value?
bool takes_value(const CLI::App& app, const std::string& word) {
  const CLI::Option* option = app.get_option_no_throw(word);
  return option != nullptr && option->get_items_expected_max() > 0 && word.find('=') == std::string::npos;
}

/// A word that no verb or option is, with the nearest one that is; empty when every word is known.
std::string unknown_word(const Tree& tree, const std::vector<std::string>& words) {
  const CLI::App* at = &tree.app;
  std::string help = "regolab --help";
  const auto remedy = [&](const std::string& typed, const std::vector<std::string>& known) {
    const std::string_view near = closest(typed, std::vector<std::string_view>(known.begin(), known.end()));
    return near.empty() ? fmt::format("see `{}`", help) : fmt::format("did you mean `{}`?", near);
  };
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word.starts_with("--")) {
      const std::string name = word.substr(0, word.find('='));
      if (at->get_option_no_throw(name) == nullptr && tree.app.get_option_no_throw(name) == nullptr) {
        auto known = options_of(*at);
        for (auto& more : options_of(tree.app)) known.push_back(more);
        return fmt::format("unknown option `{}` (`{}` has no such option) {}", name, at->get_name(), remedy(name, known));
      }
      if (takes_value(*at, word) || takes_value(tree.app, word)) ++i;
      continue;
    }
    const auto verbs = names_of(*at);
    if (verbs.empty()) continue;
    const CLI::App* next = nullptr;
    for (const CLI::App* sub : at->get_subcommands([](const CLI::App*) { return true; })) {
      if (sub->get_name() == word) next = sub;
    }
    if (next == nullptr) {
      const std::string what = at == &tree.app ? "verb" : at->get_name() + " verb";
      return fmt::format("unknown {} `{}` (known: {}) {}", what, word, fmt::join(verbs, ", "), remedy(word, verbs));
    }
    at = next;
    help = at == &tree.app ? help : "regolab " + at->get_name() + " --help";
  }
  return {};
}

Parsed mistake(std::string text) {
  Parsed parsed;
  parsed.leave = true;
  parsed.outcome = failed(Exit::kUsage, std::move(text));
  return parsed;
}

/// CLI11's own words for a bad value, in our order: problem (why) remedy.
std::string worded(const CLI::ParseError& error, const std::string& verb) {
  std::string what = error.what();
  for (char& c : what) {
    if (c == '\n') c = ' ';
  }
  return fmt::format("{} (the command line) see `regolab {}--help`", what, verb.empty() ? "" : verb + " ");
}

}  // namespace

Parsed parse(const std::vector<std::string>& words) {
  Tree tree;
  Parsed parsed;
  try {
    tree.app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    parsed.leave = true;
    parsed.text = tree.app.help();
    return parsed;
  } catch (const CLI::ParseError& error) {
    const std::string unknown = unknown_word(tree, words);
    const auto subs = tree.app.get_subcommands();
    return mistake(unknown.empty() ? worded(error, subs.empty() ? "" : subs.front()->get_name()) : unknown);
  }
  Arguments& arguments = tree.arguments;
  if (tree.version) arguments.verb = "version";
  if (arguments.verb.empty()) {
    parsed = mistake("");
    parsed.text = tree.app.help();
    return parsed;
  }
  if (tree.server->count() > 0 && tree.database->count() > 0) {
    return mistake("--server and --db together (a running scheduler has a database of its own) leave one of them out");
  }
  const char* from_environment = std::getenv("REGOLAB_SERVER");
  if (arguments.server.empty() && tree.database->count() == 0 && from_environment != nullptr)
    arguments.server = from_environment;
  if (!arguments.server.empty()) {
    if (auto address = check_address(arguments.server); !address.ok()) return mistake(address.text);
    if (arguments.workers > 0)
      return mistake("--workers with --server (workers are started on the machines of that scheduler) leave it out");
  }
  if (arguments.csv && arguments.json)
    return mistake("--csv and --json together (one form at a time) leave one of them out");
  if (arguments.article && !arguments.experiment.empty())
    return mistake("--article with an experiment (one table at a time) leave one of them out");
  arguments.own_database = tree.database->count() > 0;
  if (arguments.database.empty()) return mistake("--db is empty (a file name is wanted) write --db FILE");
  arguments.colour = tree.colour == "always"  ? ColourChoice::kAlways
                     : tree.colour == "never" ? ColourChoice::kNever
                                              : ColourChoice::kAuto;
  for (const std::string& word : words) arguments.original_line += " " + word;
  parsed.arguments = arguments;
  return parsed;
}

std::vector<VerbOptions> known_words() {
  const Tree tree;
  std::vector<VerbOptions> words{{"", options_of(tree.app)}};
  for (const CLI::App* sub : tree.app.get_subcommands([](const CLI::App*) { return true; })) {
    words.push_back({sub->get_name(), options_of(*sub)});
    for (const std::string& inner : names_of(*sub)) words.back().options.push_back(inner);
  }
  return words;
}

std::string where_flags(const Arguments& arguments) {
  if (!arguments.server.empty()) return " --server " + arguments.server;
  return arguments.database == Arguments{}.database ? "" : " --db " + arguments.database;
}

}  // namespace regolab::client
