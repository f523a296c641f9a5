#pragma once

#include <gtest/gtest.h>

#include <string>

namespace pelt::test {

/// Whether `part` is in `text`. Failures show both.
inline ::testing::AssertionResult contains(const std::string& text, const std::string& part) {
  const bool is_there = text.find(part) != std::string::npos;
  return (is_there ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
         << '"' << part << "\" is " << (is_there ? "" : "not ") << "in:\n"
         << text;
}

}  // namespace pelt::test
