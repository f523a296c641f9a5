#pragma once

#include <span>

namespace pelt::tools::output {

/// The median, or the lower of the two middle values if their number is even; 0 for no values.
double median(std::span<const double> values);

/// 0 for no values.
double mean(std::span<const double> values);

/// The least value such that at least the fraction `p` of the values is not larger; 0 for no
/// values. Precondition: 0 < p <= 1.
double percentile(std::span<const double> values, double p);

}  // namespace pelt::tools::output
