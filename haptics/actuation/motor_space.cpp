#include "haptics/actuation/motor_space.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace fulcrum {
namespace {

constexpr double kRankThreshold = 1e-9;  // of the largest pivot
constexpr double kForceFirst = 1e4;      // what force counts beside torque, where both cannot be
constexpr double kRidge = 1e-14;         // of the trace, where a force or torque cannot be had
constexpr double kOwn = 0.5;             // of a spare direction: what live motors must have of it

using EffortSquare = Eigen::Matrix<double, kMaxMotors, kMaxMotors>;

// The whole Q, one reflection after the other: what qr.householderQ() gives for so few columns. That takes
// three times as long to compile, with the products of blocks that it has for many.
template <class Columns>
EffortSquare q_of(const Eigen::ColPivHouseholderQR<Columns>& qr) {
  EffortSquare Q = EffortSquare::Identity();
  Effort workspace;
  for (Eigen::Index k = qr.matrixQR().cols() - 1; k >= 0; --k) {
    const Eigen::Index rows = Q.rows() - k;
    const Eigen::Block<const Columns, Eigen::Dynamic, 1> essential(qr.matrixQR(), k + 1, k, rows - 1, 1);
    Q.bottomRightCorner(rows, rows).applyHouseholderOnTheLeft(essential, qr.hCoeffs()[k], workspace.data());
  }
  return Q;
}

}  // namespace

MotorSpace::MotorSpace(const Actuators& actuators)
    : rows_(actuators.rows()),
      live_((actuators.limits().array() > 0).cast<double>()),
      wrenches_(WrenchMatrix::Zero()),
      inverse_(Eigen::Matrix<double, kMaxMotors, 6>::Zero()),
      spare_(Spare::Zero()) {}

void MotorSpace::factorise(const WrenchMatrix& wrenches, double lever) noexcept {
  if (rows_ == 6)
    factorise_rows<6>(wrenches, lever);
  else
    factorise_rows<3>(wrenches, lever);
}

template <int kRows>
void MotorSpace::factorise_rows(const WrenchMatrix& wrenches, double lever) noexcept {
  using Rows = Eigen::Matrix<double, kRows, kMaxMotors>;
  using Columns = Eigen::Matrix<double, kMaxMotors, kRows>;
  using Square = Eigen::Matrix<double, kRows, kRows>;
  constexpr auto kMotors = static_cast<int>(kMaxMotors);

  wrenches_.topRows<kRows>() = wrenches.topRows<kRows>();
  Rows scaled = wrenches.topRows<kRows>() * live_.asDiagonal();
  if constexpr (kRows == 6) scaled.template bottomRows<3>() /= lever;
  // G^T P = Q R: Q's first columns span the efforts that are felt, the others those that are not.
  Eigen::ColPivHouseholderQR<Columns> qr(scaled.transpose());
  qr.setThreshold(kRankThreshold);
  const auto rank = static_cast<int>(qr.rank());
  const EffortSquare Q = q_of(qr);
  complete_ = rank == kRows;

  spare_.setZero();
  for (int column = rank, kept = 0; column < kMotors && kept < kMaxSpare; ++column) {
    const Effort direction = Q.col(column).cwiseProduct(live_);  // the others' share is felt as little
    if (direction.norm() > kOwn) spare_.col(kept++) = direction;
  }

  Columns inverse;
  if (complete_) {  // tau = Q1 R^-T P^T w
    Square solved = Square::Identity();
    qr.matrixQR().template topRows<kRows>().template triangularView<Eigen::Upper>().transpose().solveInPlace(
        solved);
    inverse = Q.template leftCols<kRows>() * solved * qr.colsPermutation().transpose();
  } else {
    scaled.template topRows<3>() *= kForceFirst;
    Square normal = scaled * scaled.transpose();
    normal.diagonal().array() += kRidge * normal.trace() + 1e-300;
    inverse = normal.ldlt().solve(scaled).transpose();
    inverse.template leftCols<3>() *= kForceFirst;
  }
  if constexpr (kRows == 6) inverse.template rightCols<3>() /= lever;
  inverse_.leftCols<kRows>() = inverse;
}

Effort MotorSpace::smallest(const Wrench& F_H_D) const noexcept {
  return inverse_.leftCols<3>() * F_H_D.force + inverse_.rightCols<3>() * F_H_D.torque;
}

Wrench MotorSpace::wrench(const Effort& effort) const noexcept {
  return {wrenches_.topRows<3>() * effort, wrenches_.bottomRows<3>() * effort};
}

}  // namespace fulcrum
