#pragma once

/// Marks that the pictures of queries draw beside the characters.

#include <pelt/math.hpp>

#include "base/vec3.hpp"
#include "evaluation/pictures/cast.hpp"

#include <string>

namespace pelt::pictures {

using detail::Vec3d;

/// Tone of lines, dots and skins.
enum class Tone {
  answer,    ///< the result of a query
  question,  ///< the input of the query
  quiet,     ///< everything else
};

std::string dot_at(const Vec3d& place, double radius, Tone tone);
std::string line(const Vec3d& from, const Vec3d& to, double radius, Tone tone);

/// A line that ends in a point.
std::string arrow(const Vec3d& from, const Vec3d& to, double radius, Tone tone);

std::string edges(const Box& box, double radius, Tone tone);

/// Smooth, with a quiet skin.
std::string painted(const Actor& actor, std::size_t skin);

/// The same with another texture: everywhere, or, with the tone of answers, where `marked` is true.
std::string painted(const Actor& actor, const std::string& texture,
                    const std::vector<bool>& marked);

/// A mesh that casts no shadow.
std::string unshadowed(const std::string& mesh);

/// A material that transmits the fraction `through` of the light, from 0 to 1.
std::string glass(const std::array<float, 3>& colour, double through);

/// A matt material of this colour.
std::string paint(const std::array<float, 3>& colour);

}  // namespace pelt::pictures
