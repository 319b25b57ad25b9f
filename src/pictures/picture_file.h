// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Room: pictures. Picture files and videos to pixels, and back.
// Takes: paths, bytes, pixels. Gives: pixels as stored, or the fault of a file; bytes to be written; the names of
// pictures in folders. Owns: the module for other formats, once it is loaded. Runs on: whichever thread calls; a Video
// is its owner's. May not: know cameras, depth units or recordings.
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "core/result.h"

namespace yorb {

/// A picture as its file stores it, or the reason why it cannot be read whole.
struct StoredPicture {
  cv::Mat pixels;       ///< any type; empty where there is a fault
  std::string fault;    ///< "is cut short" and the like; empty where all is well
  int orientation = 1;  ///< of EXIF, which is not applied: 1 (upright) to 8
};

/// Reads and decodes a picture file. Decoders fill what is missing of a cut JPEG with grey and call it a success, so
/// the end of JPEG and PNG files is looked for first.
StoredPicture ReadPictureFile(const std::string& path);

/// Why the bytes are no whole picture of their kind, as far as it shows without decoding; empty for formats that are
/// not looked into.
std::string FaultOfPictureBytes(const std::string& bytes);

/// The content of a picture file, as its name asks: a JPEG for .jpg and .jpeg, otherwise a PNG. Failure, naming the
/// path, where there is no such file of a picture of this type.
Result<std::string> EncodePictureFor(const std::string& path, const cv::Mat& picture, int jpeg_quality = 95);

/// A picture as features and detectors want it.
struct ColourAndGrey {
  cv::Mat colour;  ///< CV_8UC3, BGR; empty for a grey source
  cv::Mat grey;    ///< CV_8UC1
};

/// How many bits the values of a 16-bit picture take, transparency apart: 8, 10, 12, 14 or 16, as sensors have them.
int UsedBits(const cv::Mat& stored);

/// 8-bit or 16-bit grey, colour, or colour with transparency; of 16-bit pictures so many bits are scaled to 8, or as
/// many as the picture itself uses. Bad input for anything else.
Result<ColourAndGrey> ToColourAndGrey(const cv::Mat& stored, const std::string& path, std::optional<int> bits = {});

/// Bad input unless this is depth: 16-bit or 32-bit float with one channel, of the size of the colour picture.
Status CheckDepth(const cv::Mat& stored, const cv::Size& colour_size, const std::string& path);

/// "640x480".
std::string SizeText(const cv::Size& size);

}  // namespace yorb
