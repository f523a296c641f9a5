#pragma once

#include "query/scratch.hpp"

#include <vector>

namespace pelt::detail {

/// Sorts contacts in ascending order. Overwrites `buffer`.
void sort_contacts(Stack<Contact>& contacts, Stack<Contact>& buffer);

/// Appends the contacts in `scratch.found` to `contacts`, in ascending order.
void append_sorted(Scratch& scratch, std::vector<Contact>& contacts);

}  // namespace pelt::detail
