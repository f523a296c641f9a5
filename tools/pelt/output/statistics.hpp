#pragma once

#include <span>

namespace pelt::tools::output {

/// The middle value, the lower of the two where their number is even; 0 of none.
double median(std::span<const double> values);

/// 0 of none.
double mean(std::span<const double> values);

/// The least value that at least the share `p` of the values does not exceed; 0 of none.
/// Precondition: 0 < p <= 1.
double percentile(std::span<const double> values, double p);

}  // namespace pelt::tools::output
