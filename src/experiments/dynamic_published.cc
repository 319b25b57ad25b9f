// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/dynamic_published.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace yorb {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

constexpr std::array kSequences = {"walking_xyz", "walking_halfsphere", "walking_rpy",   "walking_static",
                                   "sitting_xyz", "sitting_halfsphere", "sitting_static"};

struct PublishedRow {
  const char* system;
  std::array<double, kSequences.size()> rmse_m;
};

constexpr std::array kRows = {
    PublishedRow{"ORB-SLAM2", {.721, .467, .784, .387, .0092, .0192, .0087}},
    PublishedRow{"DS-SLAM", {.0247, .0303, .4442, .0081, kNone, kNone, .0065}},
    PublishedRow{"DynaSLAM", {.0164, .0296, .0354, .0068, .0127, .0186, kNone}},
    PublishedRow{"CFP-SLAM, boxes only", {.0165, .0310, .0456, .0073, .0174, .0281, .0064}},
    PublishedRow{"CFP-SLAM", {.0141, .0237, .0368, .0066, .0090, .0147, .0053}},
    PublishedRow{"NGD-SLAM", {.015, .024, .034, .007, kNone, kNone, kNone}},
    PublishedRow{"DFS-SLAM", {.013, .018, .027, .006, kNone, kNone, kNone}},
};

}  // namespace

std::vector<PublishedFigure> PublishedErrors(const std::string& sequence) {
  std::vector<PublishedFigure> figures;
  for (size_t k = 0; k < kSequences.size(); ++k) {
    const std::string name = kSequences[k];
    if (sequence != "rgbd_dataset_freiburg3_" + name && sequence != "fr3_" + name) continue;
    for (const PublishedRow& row : kRows) {
      if (std::isfinite(row.rmse_m[k])) figures.push_back({row.system, row.rmse_m[k], ""});
    }
  }
  return figures;
}

std::vector<PublishedFigure> PublishedTimes() {
  return {{"ORB-SLAM2", 20, "CPU, about"},
          {"DS-SLAM", 59, "GPU"},
          {"DynaSLAM", 450, "GPU, 450 to 600"},
          {"CFP-SLAM", 43, "GPU"},
          {"NGD-SLAM", 16.7, "CPU, a tracked frame; detector beside it"}};
}

std::vector<PublishedReduction> PublishedReductions() {
  return {{"walking", 92.08, 97.14, 85.38}, {"sitting", 28.19, 37.40, 18.37}};
}

}  // namespace yorb
