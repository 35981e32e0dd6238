/// The report of a diagnosis: self-contained, safe, and complete.
#include "client/views/gap_html.h"

#include <gmock/gmock.h>

#include "client/views/gap_text.h"

namespace regolab::client {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

pb::FittedFeature feature(const std::string& id, double measured, double base, double repaired) {
  pb::FittedFeature f;
  f.set_id(id), f.set_label(id), f.set_group("stress 5 kPa"), f.set_unit("kPa"), f.set_sigma3_pa(5000);
  f.set_measured(measured), f.set_measured_error(0.5), f.set_base(base), f.set_base_error(0.4), f.set_repaired(repaired), f.set_repaired_error(0.3);
  return f;
}

GapReport sample() {
  GapReport report;
  pb::Diagnosis& d = *report.stored.mutable_diagnosis();
  d.set_case_name("quarry"), d.set_verdict("EFFECT"), d.add_classes("cohesion"), d.set_repaired("cohesion"), d.set_id("abcdef0123456789");
  auto& model = *d.add_models();
  model.set_model("cohesion"), model.set_cause("cohesion"), model.set_probability(0.93);
  for (const auto& [stem, m] : std::map<std::string, double>{{"sigma1_early_5", 10}, {"sigma1_rising_5", 14}, {"sigma1_middle_5", 16}, {"sigma1_ratio_5", 15}}) {
    *d.add_fits() = feature(stem, m, m - 4, m - 0.5);
  }
  *d.add_fits() = feature("volumetric_strain_0.10_5", 0.01, 0.02, 0.012);
  auto& curve = *report.stored.add_curves();
  curve.set_id("sigma1_at_sigma3_5kPa");
  for (int k = 0; k <= 20; ++k) curve.add_x_si(0.01 * k), curve.add_y_si(5000 + 500 * k);
  auto& s = *d.mutable_shrinkage();
  s.set_model("cohesion"), s.set_s(0.74), s.set_q05(0.61), s.set_q95(0.83), s.set_emulator_s(0.8), s.set_draws(8), s.set_base_gap(3.2), s.set_repaired_gap(0.8);
  s.add_heldout("stress 5 kPa");
  *s.add_features() = feature("sigma1_ratio_5", 15, 11, 14.4);
  auto& next = *d.add_next_tests();
  next.set_test("stress at 0.3 kPa"), next.set_eig_nats(0.41), next.set_eig_error(0.02), next.set_hours(2), next.add_splits("cohesion | loading_rate");
  report.blind_record = "96 cases: 0.89 right\n60 nulls: 1 false alarm";
  return report;
}

TEST(GapReport, NeedsNoScriptAndNothingFromElsewhere) {
  const std::string html = diagnosis_html(sample());
  for (const char* foreign : {"<script", "http:", "https:", "src=", "@import", "url(", "<link", "javascript", "<iframe", "<object"}) EXPECT_THAT(html, Not(HasSubstr(foreign))) << foreign;
  EXPECT_THAT(html, HasSubstr("<!doctype html>"));
  EXPECT_THAT(html, HasSubstr("prefers-color-scheme:dark"));
  EXPECT_THAT(html, HasSubstr("@media print"));
}

TEST(GapReport, HasACardForEachOfItsParts) {
  const std::string html = diagnosis_html(sample());
  EXPECT_THAT(html, HasSubstr("<p class=figure>74 %</p>"));
  EXPECT_THAT(html, HasSubstr("by 74 % (shrinkage 61 to 83 %) with cohesion, in 8 new runs of each model on stress 5 kPa, which the fit had not seen; the emulator promised 80 %"));
  EXPECT_THAT(html, HasSubstr("What would settle it"));
  EXPECT_THAT(html, HasSubstr("<td>stress at 0.3 kPa</td><td class=n>0.41 ± 0.02</td><td class=n>2</td><td>cohesion | loading_rate</td>"));
  EXPECT_THAT(html, HasSubstr("<pre>96 cases: 0.89 right\n60 nulls: 1 false alarm</pre>"));
  GapReport bare = sample();
  bare.stored.mutable_diagnosis()->clear_next_tests(), bare.blind_record.clear();
  bare.stored.mutable_diagnosis()->clear_shrinkage();
  const std::string without = diagnosis_html(bare);
  EXPECT_THAT(without, Not(HasSubstr("What would settle it")));
  EXPECT_THAT(without, Not(HasSubstr("blind record")));
  EXPECT_THAT(without, HasSubstr("Not measured yet"));
}

TEST(GapReport, DrawsMeasuredAndBothModelsForEachStress) {
  const std::string html = curves_html(sample().stored);
  std::size_t panels = 0;
  for (std::size_t at = html.find("<svg"); at != std::string::npos; at = html.find("<svg", at + 1)) ++panels;
  EXPECT_EQ(panels, 2U) << "stress and volume";
  for (const char* part : {"class=\"l b\"", "class=\"l r\"", "class=\"f b\"", "class=\"c\"", "class=\"md\"", "class=\"d r\"", "5 kPa (held out), sigma1 / sigma3"}) EXPECT_THAT(html, HasSubstr(part));
  EXPECT_THAT(html, Not(HasSubstr("nan")));
  EXPECT_THAT(html, Not(HasSubstr("inf")));
  pb::StoredDiagnosis no_stress;
  EXPECT_EQ(curves_html(no_stress), "");
}

TEST(GapReport, TextOfOthersIsTextAndNoMarkup) {
  GapReport report = sample();
  const std::string hostile = "<img src=x onerror='alert(1)'>\"&";
  pb::Diagnosis& d = *report.stored.mutable_diagnosis();
  d.set_case_name(hostile), d.add_warnings(hostile), d.add_classes(hostile), d.set_repaired(hostile);
  d.mutable_models(0)->set_model(hostile);
  d.mutable_fits(0)->set_label(hostile);
  auto& where = *d.add_where();
  where.set_group(hostile), where.set_text(hostile), where.set_p_adjusted(0.01);
  d.mutable_shrinkage()->set_model(hostile), d.mutable_shrinkage()->add_warnings(hostile), d.mutable_shrinkage()->mutable_features(0)->set_label(hostile);
  auto& measured = *report.stored.mutable_measured()->add_features();
  measured.set_label(hostile), measured.set_group(hostile), measured.set_unit(hostile);
  d.mutable_next_tests(0)->set_test(hostile), d.mutable_next_tests(0)->add_splits(hostile);
  report.blind_record = hostile;
  const std::string html = diagnosis_html(report);
  EXPECT_THAT(html, Not(HasSubstr("<img")));
  EXPECT_THAT(html, Not(HasSubstr("onerror='")));
  EXPECT_THAT(html, HasSubstr("&lt;img src=x onerror=&#39;alert(1)&#39;&gt;&quot;&amp;"));
}

TEST(ShrinkageText, SaysWhyThereIsNoFigureAndWhenAGapGrows) {
  pb::Diagnosis d = sample().stored.diagnosis();
  d.mutable_shrinkage()->clear_s();
  d.mutable_shrinkage()->set_undefined("within noise");
  EXPECT_EQ(shrinkage_line(d), "not printed: within noise");
  d.mutable_shrinkage()->set_s(-0.31);
  EXPECT_THAT(shrinkage_line(d), HasSubstr("not: it grows by 31 %"));
  d.clear_shrinkage();
  EXPECT_THAT(shrinkage_line(d), HasSubstr("regolab gap confirm"));
  d.clear_repaired();
  EXPECT_THAT(shrinkage_line(d), HasSubstr("not asked"));
}

}  // namespace
}  // namespace regolab::client
