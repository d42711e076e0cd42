// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_VectorUnits_h
#define marrow_VectorUnits_h

/// For loops over lanes that are compiled once for every width of vector registers; which of them runs
/// is decided by the processor at run time. The loops do the same operations in the same precision,
/// and are compiled without contraction, so the bits are the same.
///
/// A loop is written as an inline function `marrow_ALWAYS_INLINE`, and called by functions that are
/// marked `marrow_TARGET("avx2")` and `marrow_TARGET("avx512f")` where marrow_HAS_TARGETS is defined.
#if defined(__GNUC__) && defined(__x86_64__)
#define marrow_HAS_TARGETS
#define marrow_TARGET(name) __attribute__((target(name)))
#endif
#if defined(__GNUC__)
#define marrow_ALWAYS_INLINE inline __attribute__((always_inline))
#else
#define marrow_ALWAYS_INLINE inline
#endif

namespace marrow
{
enum class VectorUnits
{
  Baseline, ///< what every processor of the architecture has
  AVX2,
  AVX512
};

/// Whether this processor can run them.
inline bool HasVectorUnits(VectorUnits units)
{
#ifdef marrow_HAS_TARGETS
  switch (units)
  {
    case VectorUnits::AVX2:
      return __builtin_cpu_supports("avx2");
    case VectorUnits::AVX512:
      return __builtin_cpu_supports("avx512f");
    case VectorUnits::Baseline:
      break;
  }
#endif
  return units == VectorUnits::Baseline;
}

inline VectorUnits WidestVectorUnits()
{
  return HasVectorUnits(VectorUnits::AVX512)
    ? VectorUnits::AVX512
    : (HasVectorUnits(VectorUnits::AVX2) ? VectorUnits::AVX2 : VectorUnits::Baseline);
}
}

#endif
