#pragma once

/// What pictures of queries draw beside the characters.

#include <pelt/shapes.hpp>

#include "base/vec3.hpp"
#include "evaluation/pictures/cast.hpp"

#include <string>

namespace pelt::pictures {

using detail::Vec3d;

/// Of lines, dots and skins.
enum class Tone {
  answer,    ///< what a query has found
  question,  ///< what it was asked
  quiet,     ///< what is there besides
};

std::string dot_at(const Vec3d& place, double radius, Tone tone);
std::string line(const Vec3d& from, const Vec3d& to, double radius, Tone tone);

/// A line that ends in a point.
std::string arrow(const Vec3d& from, const Vec3d& to, double radius, Tone tone);

std::string edges(const Box& box, double radius, Tone tone);

/// Smooth, in a quiet skin.
std::string painted(const Actor& actor, std::size_t skin);

/// The same in another texture, all over or where `marked` says so in the tone of answers.
std::string painted(const Actor& actor, const std::string& texture,
                    const std::vector<bool>& marked);

/// That lets all light pass.
std::string unshadowed(const std::string& mesh);

/// So much of the light goes through, from 0 to 1.
std::string glass(const std::array<float, 3>& colour, double through);

/// Of that colour, matt.
std::string paint(const std::array<float, 3>& colour);

}  // namespace pelt::pictures
