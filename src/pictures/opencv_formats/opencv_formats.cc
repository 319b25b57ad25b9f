// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// The module behind pictures/other_formats.h: OpenCV's own readers of pictures and videos.
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "pictures/other_formats.h"

namespace yorb {
namespace {

class OpenCvVideo : public VideoStream {
 public:
  explicit OpenCvVideo(const cv::VideoCapture& capture) : capture_(capture) {}

  std::optional<Picture> Next() override {
    cv::Mat bgr;
    if (!capture_.read(bgr) || bgr.empty()) return std::nullopt;
    return Picture{bgr.clone(), capture_.get(cv::CAP_PROP_POS_MSEC), capture_.get(cv::CAP_PROP_FPS)};
  }

  double StatedCount() const override { return capture_.get(cv::CAP_PROP_FRAME_COUNT); }

 private:
  cv::VideoCapture capture_;
};

class OpenCvFormats : public OtherFormats {
 public:
  cv::Mat Decode(const std::string& bytes) const override {
    const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
    try {
      return cv::imdecode(raw, cv::IMREAD_UNCHANGED);
    } catch (const cv::Exception&) {
      return {};
    }
  }

  std::unique_ptr<VideoStream> OpenVideo(const std::string& path) const override {
    cv::VideoCapture capture;
    try {
      if (!capture.open(path)) return nullptr;
    } catch (const cv::Exception&) {
      return nullptr;
    }
    return std::make_unique<OpenCvVideo>(capture);
  }
};

}  // namespace
}  // namespace yorb

extern "C" const yorb::OtherFormats* YorbOtherFormats() {
  static const yorb::OpenCvFormats formats;
  return &formats;
}
