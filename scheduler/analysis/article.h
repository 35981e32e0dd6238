/// The article's own tables: recomputed from its data, and beside a study of ours.
/// Liu et al., Aerospace 2025, 12, 330; data as printed in scheduler/analysis/article/, part of the program.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "vocab/result.h"
#include "vocab/result_table.h"

namespace regolab::analysis {

/// Tables 2, 3, 5, 7 and 9 as one result table: 32 points, seed 0, SI values; K_N of test 5 restored to 5e4 N/m.
/// Responses: contacts_per_particle, bulk_density, void_ratio, repose_angle, sigma1_at_sigma3_{1.25,2.5,5,10}kPa.
ResultTable article_results();

struct CheckEntry {
  std::string table;  ///< "Table 4"
  std::string entry;  ///< "contacts, theta_F"
  std::string unit;
  double printed = 0;
  double recomputed = 0;
  bool agrees = false;      ///< within the rounding of what is printed
  std::string explanation;  ///< empty when it agrees
};

struct ArticleCheck {
  std::vector<CheckEntry> entries;
  std::vector<std::string> findings;
};

/// Tables 4, 6, 8, 10 entry by entry from Tables 3, 5, 7, 9, and Table 5's void ratios from its densities.
ArticleCheck check_article();

struct CompareCell {
  int test = 0;  ///< the article's number
  double article = 0;
  std::optional<double> ours;                 ///< mean over seeds
  std::optional<double> ours_standard_error;  ///< of that mean, from two seeds or more
  std::string missing;                        ///< why there is no number of ours
};

struct CompareResponse {
  std::string response;
  std::string unit;  ///< door unit of every number here
  int tests_compared = 0;
  double correlation = 0;                            ///< Pearson's, over the tests compared
  double mean_error = 0;                             ///< ours - article
  double mean_absolute_relative_error = 0;           ///< mean of |ours - article| / article
  std::vector<CompareCell> cells;                    // [32]
  std::vector<std::string> leading_factors_article;  ///< the two largest R
  std::vector<std::string> leading_factors_ours;
};

struct ArticleComparison {
  std::vector<CompareResponse> responses;
  std::vector<std::string> notes;
};

/// Rows are matched by their parameter values, not by number. Errors: kFailedPrecondition when a point is none of the
/// article's 32 tests or a parameter is not in the table.
Result<ArticleComparison> compare_article(const ResultTable& table);

}  // namespace regolab::analysis
