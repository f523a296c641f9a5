#pragma once

#include "tools/pelt/methods/anytime_method.hpp"

#include <array>

namespace pelt::methods {

std::unique_ptr<AnytimeMethod> make_anytime_contacts();
std::unique_ptr<AnytimeMethod> make_anytime_resolution();
std::unique_ptr<AnytimeMethod> make_anytime_first_contact();
std::unique_ptr<AnytimeMethod> make_anytime_paper();

/// The orders of a CollisionSearch.
inline constexpr AnytimeMethodKind kAnytimeContacts = {"contacts", "order contacts",
                                                       make_anytime_contacts};
inline constexpr AnytimeMethodKind kAnytimeResolution = {"resolution", "order resolution",
                                                         make_anytime_resolution};
inline constexpr AnytimeMethodKind kAnytimeFirstContact = {"first_contact", "order first_contact",
                                                           make_anytime_first_contact};

/// The paper's sphere tree, refitted on demand, one level after the other.
inline constexpr AnytimeMethodKind kAnytimePaper = {
    "paper", "sphere tree of the paper, breadth first", make_anytime_paper};

/// The methods of the command `pelt`.
inline constexpr std::array kCommandAnytimeMethods = {kAnytimeContacts, kAnytimeResolution,
                                                      kAnytimeFirstContact, kAnytimePaper};

}  // namespace pelt::methods
