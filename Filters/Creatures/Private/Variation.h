// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Variation_h
#define marrow_Variation_h

#include <cmath>
#include <cstdint>
#include <random>

namespace marrow
{
/// A seeded stream of deviations from what is neutral. The draws do not depend on the amount, so a
/// growing amount deforms one and the same individual. The same numbers on every machine, which the
/// distributions of the standard library do not promise.
class Variation
{
public:
  Variation(unsigned int seed, unsigned int stream, double amount)
    : Random(static_cast<std::uint64_t>(seed) * 1000003u + stream)
    , Amount(amount)
  {
  }

  /// Uniform in [-limit, limit] times the amount.
  double Symmetric(double limit) { return this->Amount * limit * (2.0 * this->Draw() - 1.0); }
  /// Uniform in [0, limit] times the amount.
  double OneSided(double limit) { return this->Amount * limit * this->Draw(); }
  /// A factor between 1 / maximum and maximum, at an amount of 1.
  double Factor(double maximum) { return std::pow(maximum, this->Symmetric(1.0)); }

private:
  double Draw() { return static_cast<double>(this->Random() >> 11) * 0x1.0p-53; }

  std::mt19937_64 Random;
  double Amount;
};
}

#endif
