#pragma once

/// Angles without libm, whose last bits differ between platforms: only + - * / and square roots.

namespace pelt::asset {

inline constexpr double kPi = 3.14159265358979323846;

/// sin x within 3e-16. Precondition: |x| <= pi / 2.
double sine(double x);

/// Sine and cosine of an angle in turns (1 turn = 2 pi), within 1e-15 and exactly periodic where
/// `turns + 1` is exact. Precondition: |turns| < 2^30.
double sine_of_turns(double turns);
double cosine_of_turns(double turns);

/// The angle in [0, pi / 2] whose sine and cosine have the ratio of the arguments, within 1e-15.
/// Precondition: both >= 0, not both 0, and their squares neither overflow nor vanish.
double angle_of(double sine, double cosine);

}  // namespace pelt::asset
