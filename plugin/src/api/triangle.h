// Conversion of symmetric matrices from and to arrays of their lower triangle, row by row, as in the C interface.
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace hrt::plugin {

template <int size>
using Square = Eigen::Matrix<double, size, size>;

template <int size, std::size_t numbers>
Square<size> from_triangle(const double (&triangle)[numbers]) {
  static_assert(numbers == size * (size + 1) / 2);
  Square<size> matrix;
  const double* next = triangle;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j <= i; ++j) matrix(i, j) = matrix(j, i) = *next++;
  return matrix;
}

template <int size, std::size_t numbers>
void write_triangle(const Square<size>& matrix, double (&out)[numbers]) {
  static_assert(numbers == size * (size + 1) / 2);
  double* next = out;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j <= i; ++j) *next++ = matrix(i, j);
}

}  // namespace hrt::plugin
