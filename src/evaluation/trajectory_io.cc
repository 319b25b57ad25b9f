// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/trajectory_io.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "core/text.h"
#include "evaluation/trajectory_columns.h"

namespace yorb {
namespace {

constexpr size_t kTumColumns = 8, kKittiColumns = 12, kSquareColumns = 16;  // KITTI's with 0 0 0 1 below
constexpr double kFarthest = 1e12;                     // metres; beyond it squares lose their meaning
constexpr double kLeastQuaternion = 1e-6;              // norm
constexpr double kRotationSlack = 1e-2;                // of R * R^T against the identity
constexpr int64_t kLatest_ns = 3200000000000000000;    // about a hundred years, so that sums stay whole
constexpr double kRadius = 0.01, kUsualRadius = 1e-3;  // norm of a cut quaternion, and of whole ones, against 1

using Fields = std::vector<std::string_view>;

/// How the rows of a file are read.
struct Layout {
  TrajectoryFormat format = TrajectoryFormat::kTum;
  TrajectoryColumns columns;
  size_t first_row = 0;  ///< 1 after a header line
};

bool IsHeader(const Fields& fields) {
  if (fields.empty() || fields[0].empty()) return false;
  std::string_view first = fields[0];
  while (!first.empty() && (first.front() == '"' || first.front() == '\'')) first.remove_prefix(1);
  const bool is_letter = !first.empty() && ((first.front() | 0x20) >= 'a' && (first.front() | 0x20) <= 'z');
  return is_letter && !ParseDouble(fields[0]);
}

std::string Count(size_t count) { return std::to_string(count) + (count == 1 ? " column" : " columns"); }

/// By which format a row like this one is read; empty where none is known.
std::string HintOf(const Fields& fields) {
  const bool is_nanoseconds =
      ParseInteger(fields[0]).has_value() && StampDecimalsBySize(ParseDouble(fields[0]).value_or(0)) == 9;
  if (fields.size() > kTumColumns && is_nanoseconds)
    return "EuRoC's CSV is read with --format euroc, of the reference alone with --reference-format euroc";
  if (fields.size() == kKittiColumns || fields.size() == kSquareColumns)
    return "matrices of 3x4 (KITTI's) or 4x4 numbers a row are read with --format kitti";
  if (fields.size() == 4) return "a matrix over four lines belongs in one, of 12 or 16 numbers, for --format kitti";
  if (fields.size() == kTumColumns)
    return "TUM's format is read with --format left out, a EuRoC reference beside it with --reference-format euroc";
  return "";
}

TrajectoryColumns EurocColumns(size_t count) {
  TrajectoryColumns columns;
  columns.quaternion_xyzw = {5, 6, 7, 4};
  columns.count = count;
  columns.stamp_decimals = 9;
  return columns;
}

/// What the `#` lines say about so many columns; nothing where none of them is a header.
std::optional<TrajectoryColumns> ColumnsFromComments(const TextFile& file, size_t count) {
  for (const std::string& comment : file.comments) {
    const std::string_view text = Trim(std::string_view(comment).substr(
        comment.find_first_not_of('#') == std::string::npos ? comment.size() : comment.find_first_not_of('#')));
    const auto columns = ColumnsFromHeader(SplitColumns(text));
    if (columns && columns->count == count) return columns;
  }
  return std::nullopt;
}

Result<Layout> AutoLayout(const TextFile& file) {
  Layout layout;
  Fields fields = SplitColumns(file.lines[0].text);
  if (IsHeader(fields)) {
    const auto columns = ColumnsFromHeader(fields);
    if (!columns) {
      return BadInput(file.Where(file.lines[0]) +
                      ": neither numbers nor a header that names timestamp, tx, ty, tz, qx, qy, qz and qw once each");
    }
    layout.columns = *columns;
    layout.first_row = 1;
    return layout;
  }
  if (const auto columns = ColumnsFromComments(file, fields.size())) {
    layout.columns = *columns;
    return layout;
  }
  layout.columns.stamp_decimals = -1;
  if (fields.size() == 8) {
    const bool has_commas = file.lines[0].text.find(',') != std::string::npos;
    const double stamp = ParseDouble(fields[0]).value_or(0);
    if (!has_commas || StampDecimalsBySize(stamp) == 0) return layout;
    return BadInput(
        file.Where(file.lines[0]) +
        ": commas and nanoseconds without a header, which may be TUM's order or EuRoC's; give --format tum or euroc");
  }
  const std::string hint = HintOf(fields), unknown = fields.size() < kTumColumns ? "a cut line, or another" : "another";
  return BadInput(file.Where(file.lines[0]) + ": " + Count(fields.size()) +
                  " where TUM's format has 8 (timestamp tx ty tz qx qy qz qw); " +
                  (hint.empty() ? unknown + " format: see --format" : hint));
}

/// EuRoC's columns, of which the first row says how many there are.
Result<TrajectoryColumns> EurocLayout(const Fields& fields, const std::string& where) {
  if (fields.size() < kTumColumns)
    return BadInput(where + ": " + Count(fields.size()) + " where EuRoC's CSV has 8 or more");
  if (ParseInteger(fields[0])) return EurocColumns(fields.size());
  const std::string hint = HintOf(fields);
  return BadInput(where + ": '" + std::string(fields[0].substr(0, 40)) +
                  "' is no whole number of nanoseconds, as EuRoC's are; " +
                  (hint.empty() ? "for other formats see --format" : hint));
}

Result<Layout> FindLayout(const TextFile& file, TrajectoryFormat format) {
  if (format == TrajectoryFormat::kAuto) return AutoLayout(file);
  Layout layout;
  layout.format = format;
  layout.first_row = IsHeader(SplitColumns(file.lines[0].text)) ? 1 : 0;
  if (layout.first_row == file.lines.size()) return layout;
  const TextLine& line = file.lines[layout.first_row];
  const Fields fields = SplitColumns(line.text);
  if (format == TrajectoryFormat::kEuroc) {
    const auto columns = EurocLayout(fields, file.Where(line));
    if (!columns) return columns.error();
    layout.columns = *columns;
    return layout;
  }
  layout.columns.stamp_decimals = -1;
  if (format == TrajectoryFormat::kKitti)
    layout.columns.count = fields.size() == kSquareColumns ? kSquareColumns : kKittiColumns;
  const std::string hint = HintOf(fields);
  if (fields.size() == layout.columns.count || hint.empty()) return layout;
  const char* name = format == TrajectoryFormat::kKitti ? "KITTI's" : "TUM's";
  return BadInput(file.Where(line) + ": " + Count(fields.size()) + " where " + name + " format has " +
                  std::to_string(layout.columns.count) + "; " + hint);
}

/// The numbers of a row; bad input where one is none.
Result<std::vector<double>> ReadNumbers(const Fields& fields, const std::string& where) {
  std::vector<double> numbers;
  numbers.reserve(fields.size());
  for (const std::string_view field : fields) {
    const auto number = ParseDouble(field);
    if (!number)
      return BadInput(where + ": '" + std::string(field.substr(0, 40)) + "' is not a number; mend or remove the line");
    numbers.push_back(*number);
  }
  return numbers;
}

/// Why numbers are no pose; empty when they are one.
std::string WhyNoPose(const Eigen::Vector3d& position, const Eigen::Quaterniond& rotation) {
  if (!position.allFinite() || !rotation.coeffs().allFinite()) return "nan or inf";
  if (position.cwiseAbs().maxCoeff() > kFarthest) return "a position beyond 1e12 m";
  if (!(rotation.coeffs().cwiseAbs().maxCoeff() >= kLeastQuaternion)) return "a zero quaternion";
  return rotation.coeffs().cwiseAbs().maxCoeff() > kFarthest ? "a quaternion beyond 1e12" : "";
}

Result<Rigid3> PoseFromColumns(const std::vector<double>& numbers, const TrajectoryColumns& columns,
                               const std::string& where) {
  const auto& p = columns.position;
  const auto& q = columns.quaternion_xyzw;
  const Eigen::Vector3d position(numbers[p[0]], numbers[p[1]], numbers[p[2]]);
  const Eigen::Quaterniond rotation(numbers[q[3]], numbers[q[0]], numbers[q[1]], numbers[q[2]]);
  const std::string why = WhyNoPose(position, rotation);
  if (!why.empty()) return BadInput(where + ": " + why + "; mend or remove the line");
  return Rigid3(rotation, position);
}

Result<Rigid3> PoseFromMatrix(const std::vector<double>& numbers, const std::string& where) {
  const Eigen::Matrix<double, 3, 4> matrix =
      Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(numbers.data());
  const Eigen::Matrix3d rotation = matrix.leftCols<3>();
  std::string why = WhyNoPose(matrix.col(3), Eigen::Quaterniond::Identity());
  constexpr std::array<double, 4> kLastRow = {0, 0, 0, 1};
  if (numbers.size() == kSquareColumns && !std::equal(kLastRow.begin(), kLastRow.end(), numbers.begin() + 12))
    why = "a 4x4 matrix whose last row is not 0 0 0 1 (is it written column by column?)";
  if (!why.empty()) return BadInput(where + ": " + why + "; mend or remove the line");
  const double slack = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(slack < kRotationSlack) || rotation.determinant() < 0) {
    return BadInput(where + ": the first three columns of the 3x4 matrix are no rotation");
  }
  return Rigid3(rotation, matrix.col(3));
}

bool EndsWithNewline(const std::string& path) {
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  if (!stream || stream.tellg() == 0) return true;
  stream.seekg(-1, std::ios::end);
  return stream.get() == '\n';
}

double Radius(const std::vector<double>& numbers, const TrajectoryColumns& columns) {
  double sum = 0;
  for (const size_t index : columns.quaternion_xyzw) sum += numbers[index] * numbers[index];
  return std::abs(std::sqrt(sum) - 1);
}

/// Adds the rows of one file to a trajectory.
class RowReader {
 public:
  RowReader(const TextFile& file, Layout layout, ReadTrajectory& result)
      : file_(file), layout_(layout), result_(result) {}

  Status ReadAll() {
    for (size_t row = layout_.first_row; row < file_.lines.size(); ++row) {
      if (const Status status = ReadRow(row); !status) return status;
    }
    if (num_repeated_ > 0) {
      result_.warnings.push_back(
          file_.path + ", line " + std::to_string(repeated_line_) + ": the same time stamp as the line before" +
          (num_repeated_ > 1 ? " (" + std::to_string(num_repeated_) + " such lines)" : "") + "; the last pose counts");
    }
    return Status::Ok();
  }

 private:
  Status ReadRow(size_t row) {
    const TextLine& line = file_.lines[row];
    const std::string where = file_.Where(line);
    const Fields fields = SplitColumns(line.text);
    if (fields.size() != layout_.columns.count) {
      const bool is_last = row + 1 == file_.lines.size();
      return BadInput(where + ": " + Count(fields.size()) + " where " + std::to_string(layout_.columns.count) +
                      " are expected" + (is_last ? ": the file seems to be cut short" : "; mend or remove the line"));
    }
    const auto numbers = ReadNumbers(fields, where);
    if (!numbers) return numbers.error();
    const bool is_kitti = layout_.format == TrajectoryFormat::kKitti;
    const auto pose = is_kitti ? PoseFromMatrix(*numbers, where) : PoseFromColumns(*numbers, layout_.columns, where);
    if (!pose) return pose.error();
    if (is_kitti) return Add(Timestamp{static_cast<int64_t>(row - layout_.first_row) * 1000000000}, *pose, line);
    if (IsCut(row, *numbers))
      return BadInput(where + ": the last line is cut short (its quaternion is not of unit length)");
    last_radius_ = Radius(*numbers, layout_.columns);
    const auto stamp = ReadStamp(fields[layout_.columns.stamp], (*numbers)[layout_.columns.stamp]);
    if (!stamp)
      return BadInput(where + ": '" + std::string(fields[layout_.columns.stamp].substr(0, 40)) +
                      "' is no time stamp in seconds");
    return Add(*stamp, *pose, line);
  }

  /// A last line without its end whose quaternion alone is not of unit length lost some of its last digits.
  bool IsCut(size_t row, const std::vector<double>& numbers) const {
    return row + 1 == file_.lines.size() && !result_.poses.empty() && last_radius_ < kUsualRadius &&
           Radius(numbers, layout_.columns) > kRadius && !EndsWithNewline(file_.path);
  }

  std::optional<Timestamp> ReadStamp(std::string_view text, double number) {
    int& decimals = layout_.columns.stamp_decimals;
    if (decimals < 0) {  // the first stamp speaks for the whole file
      decimals = StampDecimalsBySize(number);
      const char* unit = decimals == 9 ? "nano" : decimals == 6 ? "micro" : "milli";
      if (decimals > 0) result_.warnings.push_back(file_.path + ": the time stamps are read as " + unit + "seconds");
    }
    const auto stamp = ParseScaledStamp(text, decimals);
    return stamp && std::abs(stamp->ns) <= kLatest_ns ? stamp : std::nullopt;
  }

  Status Add(Timestamp stamp, const Rigid3& pose, const TextLine& line) {
    if (!result_.poses.empty()) {
      StampedPose& before = result_.poses.back();
      if (stamp < before.timestamp) {
        return BadInput(file_.Where(line) + ": the time stamp goes back from " + ToString(before.timestamp) + " to " +
                        ToString(stamp) + "; are there two runs in one file?");
      }
      if (stamp == before.timestamp) {
        if (num_repeated_++ == 0) repeated_line_ = line.number;
        before.world_from_cam = pose;
        return Status::Ok();
      }
    }
    result_.poses.push_back({stamp, pose});
    return Status::Ok();
  }

  const TextFile& file_;
  Layout layout_;
  ReadTrajectory& result_;
  double last_radius_ = 1;
  size_t num_repeated_ = 0;
  int repeated_line_ = 0;
};

}  // namespace

Result<ReadTrajectory> ReadTrajectoryFile(const std::string& path, TrajectoryFormat format) {
  const auto file = ReadTextFile(path);
  if (!file) return file.error();
  ReadTrajectory result;
  result.path = path;
  const Error empty = BadInput(path + " holds no poses: an empty trajectory cannot be evaluated");
  if (file->lines.empty()) return empty;
  const auto layout = FindLayout(*file, format);
  if (!layout) return layout.error();
  result.has_stamps = layout->format != TrajectoryFormat::kKitti;
  if (const Status status = RowReader(*file, *layout, result).ReadAll(); !status) return status.error();
  if (result.poses.empty()) return empty;
  return result;
}

}  // namespace yorb
