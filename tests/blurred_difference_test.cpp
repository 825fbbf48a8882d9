// The blurred difference against the plain one, and against a convolution in two dimensions.
#include "quant/blurred_difference.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "quant/ciede2000.h"
#include "tests/random_planes.h"

namespace sir::quant {
namespace {

using test::random_planes;

Planes even(ImageSize size, Rgb8 colour) {
  Planes image(size);
  for (std::size_t i = 0; i < size.pixels(); ++i) image.set(i, colour);
  return image;
}

Planes checkerboard(ImageSize size, Rgb8 a, Rgb8 b) {
  Planes image(size);
  for (int j = 0, i = 0; j < size.height; ++j)
    for (int k = 0; k < size.width; ++k, ++i)
      image.set(static_cast<std::size_t>(i), (j + k) % 2 ? a : b);
  return image;
}

double plain_mean(const Planes& reference, const Planes& shown) {
  const auto map = difference_map(reference, shown);
  return std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
}

/// The weighted mean of the light of all pixels around, and its code.
double convolved(const Planes& image, std::size_t channel, int column, int row, double sigma) {
  const int reach = static_cast<int>(std::ceil(4 * sigma));
  double sum = 0, weights = 0;
  for (int j = 0; j < image.size.height; ++j)
    for (int i = 0; i < image.size.width; ++i) {
      const int x = i - column, y = j - row;
      if (std::abs(x) > reach || std::abs(y) > reach) continue;
      const double weight = std::exp(-(x * x + y * y) / (2 * sigma * sigma));
      const double coded =
          image.channel[channel][static_cast<std::size_t>(j * image.size.width + i)] / 255.0;
      sum += weight * (coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4));
      weights += weight;
    }
  const double light = sum / weights;
  return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

double by_definition(const Planes& reference, const Planes& shown, double sigma) {
  double sum = 0;
  for (int row = 0; row < reference.size.height; ++row)
    for (int column = 0; column < reference.size.width; ++column) {
      const auto colour = [&](const Planes& image) {
        return lab_of(Rgb{convolved(image, 0, column, row, sigma),
                          convolved(image, 1, column, row, sigma),
                          convolved(image, 2, column, row, sigma)});
      };
      sum += ciede2000(colour(reference), colour(shown));
    }
  return sum / static_cast<double>(reference.size.pixels());
}

TEST(BlurredDifference, OfEvenImagesIsThatOfTheirColours) {
  const Rgb8 a{200, 30, 90}, b{190, 44, 80};
  const double plain = ciede2000(lab_of(a), lab_of(b));
  for (const ImageSize size : {ImageSize{1, 1}, {3, 2}, {1, 40}, {33, 17}})
    for (const double sigma : {0.0, 0.3, 1.0, 6.0})
      EXPECT_NEAR(blurred_difference(even(size, a), even(size, b), sigma), plain, 1e-9);
}

TEST(BlurredDifference, OfAnImageAndItselfIsNothing) {
  const Planes image = random_planes({23, 31}, 1);
  EXPECT_EQ(blurred_difference(image, image), 0);
}

TEST(BlurredDifference, WithoutBlurIsThePlainOne) {
  const Planes a = random_planes({40, 30}, 2), b = random_planes({40, 30}, 3);
  EXPECT_NEAR(blurred_difference(a, b, 0), plain_mean(a, b), 1e-9);
}

// Half black and half white is seen as half the light, which is byte 188; 128 is the mean of the
// bytes and far darker. What is left is the image's border, where not as many pixels mix.
TEST(BlurredDifference, MixesLight) {
  const ImageSize size{128, 128};
  const Planes mixed = checkerboard(size, {0, 0, 0}, {255, 255, 255});
  EXPECT_GT(plain_mean(even(size, {188, 188, 188}), mixed), 30);
  EXPECT_LT(blurred_difference(even(size, {188, 188, 188}), mixed), 0.4);
  EXPECT_GT(blurred_difference(even(size, {128, 128, 128}), mixed), 15);
}

TEST(BlurredDifference, EqualsAConvolutionInTwoDimensions) {
  unsigned seed = 10;
  for (const ImageSize size : {ImageSize{13, 9}, {4, 17}, {1, 6}, {30, 21}})
    for (const double sigma : {0.4, 1.0, 2.5}) {
      const Planes a = random_planes(size, ++seed), b = random_planes(size, ++seed);
      EXPECT_NEAR(blurred_difference(a, b, sigma), by_definition(a, b, sigma), 1e-6)
          << size.width << "x" << size.height << ", " << sigma;
    }
}

TEST(BlurredDifference, RefusesWhatHasNoMeaning) {
  const Planes image = random_planes({4, 4}, 4);
  EXPECT_THROW(blurred_difference(image, random_planes({4, 5}, 5)), std::invalid_argument);
  EXPECT_THROW(blurred_difference(Planes(), Planes()), std::invalid_argument);
  for (const double sigma :
       {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(blurred_difference(image, image, sigma), std::invalid_argument);
}

}  // namespace
}  // namespace sir::quant
