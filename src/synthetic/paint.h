// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "core/random.h"

namespace yorb {

// Pictures made by rule, for the surfaces of a room. Each is CV_8UC3 (BGR) of the size asked for, whose sides are
// powers of two; the same random numbers give the same picture. Surfaces repeat without a seam; things fill their
// picture.

/// B, G, R in 0..255.
using Paint = cv::Scalar;

/// A colour from hue (0..360), saturation and value (0..1).
Paint Hsv(double hue, double saturation, double value);

/// Smooth noise of mean 0 and about unit deviation (CV_32FC1) with blobs of `cell` pixels, that repeats without a seam.
cv::Mat CloudNoise(cv::Size size, cv::Size cell, Random& random);

// paint_surfaces.cc
cv::Mat PaintPlaster(cv::Size size, const Paint& colour, Random& random);
cv::Mat PaintWallpaper(cv::Size size, const Paint& colour, Random& random);
cv::Mat PaintBricks(cv::Size size, Random& random);
cv::Mat PaintFloorboards(cv::Size size, Random& random);
cv::Mat PaintWood(cv::Size size, const Paint& colour, Random& random);  ///< the grain runs along x
cv::Mat PaintCeilingTiles(cv::Size size, Random& random);
cv::Mat PaintCloth(cv::Size size, const Paint& colour, Random& random);  ///< plain, striped, checked or dotted
cv::Mat PaintMetal(cv::Size size, const Paint& colour, Random& random);
cv::Mat PaintLeaf(cv::Size size, Random& random);

// paint_pictures.cc
cv::Mat PaintLandscape(cv::Size size, Random& random);
cv::Mat PaintPoster(cv::Size size, Random& random);  ///< shapes, rows of marks and a headline
cv::Mat PaintMap(cv::Size size, Random& random);
cv::Mat PaintAbstract(cv::Size size, Random& random);

// paint_things.cc
cv::Mat PaintRug(cv::Size size, Random& random);
cv::Mat PaintBookSpines(cv::Size size, int columns, int rows, Random& random);  ///< an atlas, one book a field
cv::Mat PaintPage(cv::Size size, Random& random);                               ///< printed paper
cv::Mat PaintScreen(cv::Size size, Random& random);
cv::Mat PaintKeyboard(cv::Size size, Random& random);
cv::Mat PaintDoor(cv::Size size, const Paint& colour, Random& random);
cv::Mat PaintDrawers(cv::Size size, const Paint& colour, int columns, int rows, Random& random);
cv::Mat PaintWindow(cv::Size size, Random& random);
cv::Mat PaintHead(cv::Size size, const Paint& skin, const Paint& hair,
                  Random& random);  ///< x round the head, face in the middle
cv::Mat PaintPackage(cv::Size size, Random& random);

// What several of the painters use.
void Speckle(cv::Mat& picture, double deviation, Random& random);  ///< adds grain to every pixel
void Modulate(cv::Mat& picture, const cv::Mat& factor);            ///< multiplies by a CV_32FC1 picture
void DrawMarks(cv::Mat& picture, const cv::Rect& where, int line_height, const Paint& colour,
               Random& random);  ///< looks like text
std::string RandomWord(size_t length, Random& random);
void DrawWord(cv::Mat& picture, const std::string& word, const cv::Rect& where,
              const Paint& colour);  ///< as large as fits

}  // namespace yorb
