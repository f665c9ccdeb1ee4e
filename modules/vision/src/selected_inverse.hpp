#pragma once

#include <optional>

#include <Eigen/SparseCore>

namespace hybridfusion {

/// Entries of the inverse of a sparse symmetric positive definite matrix where they are wanted,
/// without the others: with the memory of its Cholesky factor (Takahashi et al. 1973; Erisman and
/// Tinney 1975, "On computing certain elements of the inverse of a sparse matrix").
/// @param lower  Its lower triangle with a full diagonal; scaled so that the diagonal is about 1.
/// @returns      The inverse where `lower` has entries; nothing for a matrix that is singular.
[[nodiscard]] std::optional<Eigen::SparseMatrix<double>> selected_inverse(
    const Eigen::SparseMatrix<double>& lower);

}  // namespace hybridfusion
