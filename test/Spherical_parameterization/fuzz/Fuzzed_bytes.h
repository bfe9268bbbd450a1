#ifndef CGAL_SPHERICAL_PARAMETERIZATION_FUZZ_FUZZED_BYTES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_FUZZ_FUZZED_BYTES_H

#include "standard_library.h"

// Makes decisions and numbers from bytes, one after the other, and from zeros after the last one. The same bytes mean the
// same on every machine.
class Fuzzed_bytes
{
public:
  Fuzzed_bytes(const std::uint8_t* data, std::size_t size)
    : m_begin(data)
    , m_end(data + size)
  {}

  std::size_t size() const { return static_cast<std::size_t>(m_end - m_begin); }

  std::uint8_t byte() { return m_begin == m_end ? std::uint8_t(0) : *m_begin++; }

  // one of 0, ..., n - 1, where n is at most 65536
  std::size_t below(std::size_t n)
  {
    std::size_t result = byte();
    if(n > 256)
      result = 256 * result + byte();
    return result % n;
  }

  // any number: finite, infinite or none
  double number()
  {
    std::uint64_t bits = 0;
    for(int k = 0; k < 8; ++k)
      bits = bits << 8 | byte();
    double result = 0.;
    static_assert(sizeof(result) == sizeof(bits), "A double has 64 bits.");
    std::memcpy(&result, &bits, sizeof(bits));
    return result;
  }

  // an integer of few digits
  double small_integer() { return static_cast<double>(byte()) - 128.; }

  // one of those that are the first or the last of their kind
  double special_number()
  {
    using Limits = std::numeric_limits<double>;
    static const double values[] = {0.,
                                    -0.,
                                    1.,
                                    -1.,
                                    0.5,
                                    1. + Limits::epsilon(),
                                    1e-150,
                                    1e150,
                                    1e-200,
                                    -1e200,
                                    Limits::denorm_min(),
                                    -Limits::denorm_min(),
                                    (Limits::min)(),
                                    (Limits::max)(),
                                    Limits::lowest(),
                                    Limits::infinity(),
                                    -Limits::infinity(),
                                    Limits::quiet_NaN()};
    return values[below(sizeof(values) / sizeof(*values))];
  }

  // all that is left
  std::string rest()
  {
    const std::string result(m_begin, m_end);
    m_begin = m_end;
    return result;
  }

private:
  const std::uint8_t* m_begin;
  const std::uint8_t* m_end;
};

#endif // CGAL_SPHERICAL_PARAMETERIZATION_FUZZ_FUZZED_BYTES_H
