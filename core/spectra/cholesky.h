#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace airlight {

// Solves A x = b for a symmetric positive A by Cholesky factors in A's lower half.
class Cholesky {
 public:
  Cholesky(std::vector<double> a, std::size_t n) : l_(std::move(a)), n_(n) {
    for (std::size_t j = 0; j < n_; ++j) {
      for (std::size_t i = j; i < n_; ++i) {
        double sum = at(i, j);
        for (std::size_t k = 0; k < j; ++k) {
          sum -= at(i, k) * at(j, k);
        }
        at(i, j) = i == j ? std::sqrt(sum) : sum / at(j, j);
      }
    }
  }

  std::vector<double> solve(std::vector<double> b) const {
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        b[i] -= at(i, k) * b[k];
      }
      b[i] /= at(i, i);
    }
    for (std::size_t i = n_; i-- > 0;) {
      for (std::size_t k = i + 1; k < n_; ++k) {
        b[i] -= at(k, i) * b[k];
      }
      b[i] /= at(i, i);
    }
    return b;
  }

 private:
  double& at(std::size_t i, std::size_t j) { return l_[i * n_ + j]; }
  double at(std::size_t i, std::size_t j) const { return l_[i * n_ + j]; }

  std::vector<double> l_;
  std::size_t n_;
};

}  // namespace airlight
