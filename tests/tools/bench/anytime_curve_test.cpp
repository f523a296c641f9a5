#include "tools/pelt/bench/anytime_curve.hpp"

#include <gtest/gtest.h>

namespace pelt::tools::bench {
namespace {

/// Lists contacts from `first` to the end at an even rate; time grows as `us` for all work.
AnytimeCurve even_curve(double first, double us) {
  AnytimeCurve curve;
  for (std::size_t i = 0; i <= kAnytimeSlices; ++i) {
    const double share = static_cast<double>(i) / kAnytimeSlices;
    curve.points[i] = {share <= first ? 0 : (share - first) / (1 - first), 1 - share, 2 - share};
  }
  for (std::size_t i = 0; i < kTimedShares.size(); ++i) curve.times_us[i] = us * kTimedShares[i];
  return curve;
}

TEST(AnytimeCurve, AreaIsOneHalfForAnEvenRateAndLessForALateStart) {
  EXPECT_NEAR(area_over_work(even_curve(0, 10)), 0.5, 1e-9);
  EXPECT_NEAR(area_over_work(even_curve(0.5, 10)), 0.25, 1e-9);
  AnytimeCurve at_once = even_curve(0, 10);
  for (std::size_t i = 1; i <= kAnytimeSlices; ++i) at_once.points[i].listed = 1;
  EXPECT_NEAR(area_over_work(at_once), 1, 1 / double{kAnytimeSlices});
}

TEST(AnytimeCurve, AreaOverTimeEndsAtTheGivenTime) {
  const AnytimeCurve curve = even_curve(0, 10);
  EXPECT_NEAR(area_over_time(curve, 10), 0.5, 1e-9);
  EXPECT_NEAR(area_over_time(curve, 5), 0.25, 1e-9) << "half of the contacts in 5 us";
  EXPECT_NEAR(area_over_time(curve, 20), 0.75, 1e-9) << "nothing changes after the end";
}

TEST(AnytimeCurve, InterpolatesBetweenMeasuredTimes) {
  AnytimeCurve curve = even_curve(0, 10);
  curve.times_us[1] = 2;  // 1 % of the work
  EXPECT_NEAR(curve.time_us(0.005), 1, 1e-9);
  EXPECT_NEAR(curve.time_us(0.75), 7.5, 1e-9);
  EXPECT_NEAR(curve.time_us(1), 10, 1e-9);
  EXPECT_NEAR(curve.at_time(7.5).listed, 0.75, 1e-9);
  EXPECT_NEAR(curve.at_time(7.5).undecided, 0.25, 1e-9);
  EXPECT_NEAR(curve.at_time(7.5).resolution, 1.25, 1e-9);
  EXPECT_EQ(curve.at_time(100).listed, 1);
}

/// Rounding must not take away what is known.
TEST(AnytimeCurve, KeepsWhatIsKnownBetweenMeasuredTimes) {
  AnytimeCurve curve = even_curve(0, 0.7);
  for (AnytimePoint& point : curve.points) point = {1, 0.3, 0.1};
  for (int i = 0; i < 1000; ++i) {
    const AnytimePoint point = curve.at_time(0.0007 * i);
    EXPECT_EQ(point.listed, 1);
    EXPECT_EQ(point.undecided, 0.3);
    EXPECT_EQ(point.resolution, 0.1);
  }
}

TEST(AnytimeCurve, KnowsNothingBeforeTheStart) {
  AnytimeCurve curve = even_curve(0, 10);
  curve.times_us[0] = 0.05;
  EXPECT_EQ(curve.at_time(0.01).listed, 0);
  EXPECT_EQ(curve.at_time(0.01).undecided, 1);
}

}  // namespace
}  // namespace pelt::tools::bench
