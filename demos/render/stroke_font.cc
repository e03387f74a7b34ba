#include "render/stroke_font.h"

#include <algorithm>
#include <map>
#include <string>

namespace dgd_demos {
namespace {

using Eigen::Vector2d;

// Each glyph on a grid: strokes separated by ';', points as two digits xy, base line at y = 2, small letters up to 6,
// capitals up to 8, descenders down to 0. '~' marks a curve that the points pull towards themselves.
const std::map<char, std::string_view>& Glyphs() {
  static const std::map<char, std::string_view> glyphs = {
      {' ', ""},
      {'0', "~28 08 02 42 48 28"},
      {'1', "06 28 22"},
      {'2', "~06 08 48 45 23 02;02 42"},
      {'3', "~07 08 48 45 25;~25 45 42 02 03"},
      {'4', "32 38 04 44"},
      {'5', "48 08 05;~05 16 46 42 02 03"},
      {'6', "~48 08 02 42 46 06 04"},
      {'7', "08 48 12"},
      {'8', "~25 05 08 48 45 25;~25 05 02 42 45 25"},
      {'9', "~02 42 48 08 04 44 46"},
      {'A', "02 28 42;14 34"},
      {'B', "22 02 08 28;~28 48 45 25;05 25;~25 45 42 22"},
      {'C', "~47 48 08 02 42 43"},
      {'D', "12 02 08 18;~18 48 42 12"},
      {'E', "48 08 02 42;05 35"},
      {'F', "48 08 02;05 35"},
      {'G', "~47 48 08 02 42 45;45 25"},
      {'H', "02 08;42 48;05 45"},
      {'I', "02 08"},
      {'J', "38 34;~34 32 02 04"},
      {'K', "02 08;48 04;15 42"},
      {'L', "08 02 42"},
      {'M', "02 08 24 48 42"},
      {'N', "02 08 42 48"},
      {'O', "~28 08 02 42 48 28"},
      {'P', "02 08 28;~28 48 44 24;24 04"},
      {'Q', "~28 08 02 42 48 28;24 42"},
      {'R', "02 08 28;~28 48 44 24;04 24 42"},
      {'S', "~47 48 08 05 25;~25 45 42 02 03"},
      {'T', "08 48;28 22"},
      {'U', "08 04;~04 02 42 44;44 48"},
      {'V', "08 22 48"},
      {'W', "08 12 27 32 48"},
      {'X', "02 48;08 42"},
      {'Y', "08 25 48;25 22"},
      {'Z', "08 48 02 42"},
      {'a', "~26 06 02 42 46 26;46 42"},
      {'b', "08 02;~26 06 02 42 46 26"},
      {'c', "~45 46 06 02 42 43"},
      {'d', "48 42;~26 06 02 42 46 26"},
      {'e', "04 44;~44 46 06 02 42 43"},
      {'f', "~38 18 15;15 12;06 36"},
      {'g', "46 42;~42 40 00 01;~26 06 02 42 46 26"},
      {'h', "02 08;~04 06 46 44;44 42"},
      {'i', "02 06;08"},
      {'j', "16 12;~12 10 00;18"},
      {'k', "02 08;36 03;14 32"},
      {'l', "02 08"},
      {'m', "02 06;~04 06 26 24;24 22;~24 26 46 44;44 42"},
      {'n', "02 06;~04 06 46 44;44 42"},
      {'o', "~26 06 02 42 46 26"},
      {'p', "06 00;~26 06 02 42 46 26"},
      {'q', "46 40;~26 06 02 42 46 26"},
      {'r', "02 06;~04 06 36"},
      {'s', "~45 46 06 04 24;~24 44 42 02 03"},
      {'t', "18 14;~14 12 32;06 36"},
      {'u', "06 04;~04 02 42 44;46 42"},
      {'v', "06 22 46"},
      {'w', "06 12 25 32 46"},
      {'x', "02 46;06 42"},
      {'y', "06 22;46 10"},
      {'z', "06 46 02 42"},
      {'.', "02"},
      {',', "12 01"},
      {':', "02;05"},
      {';', "12 01;15"},
      {'-', "04 34"},
      {'+', "04 44;22 26"},
      {'=', "03 33;05 35"},
      {'_', "02 42"},
      {'/', "01 38"},
      {'(', "~18 05 12"},
      {')', "~08 15 02"},
      {'%', "02 48;~18 08 06 26 28 18;~34 24 22 42 44 34"},
      {'<', "36 04 32"},
      {'>', "06 34 02"},
  };
  return glyphs;
}
constexpr std::string_view kUnknownGlyph = "02 08 48 42 02";

constexpr double kBaseLine = 2;
constexpr double kCapitalHeight = 6;
constexpr double kLetterGap = 1.7;  // Grid units between letters; a blank is one letter gap and this wide:
constexpr double kBlankWidth = 1.2;

// Cuts the corners of a polyline (Chaikin): its limit is a smooth curve from the first point to the last.
Stroke CutCorners(const Stroke& polyline) {
  Stroke smooth = {polyline.front()};
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    const bool is_first = i == 0, is_last = i + 2 == polyline.size();
    const Vector2d &a = polyline[i], &b = polyline[i + 1];
    if (!is_first) smooth.push_back(0.75 * a + 0.25 * b);
    if (!is_last) smooth.push_back(0.25 * a + 0.75 * b);
  }
  smooth.push_back(polyline.back());
  return smooth;
}

Stroke ParseStroke(std::string_view text) {
  constexpr int kSmoothing = 3;
  const bool is_curve = text.front() == '~';
  if (is_curve) text.remove_prefix(1);
  Stroke stroke;
  for (std::size_t i = 0; i < text.size(); i += 3) stroke.emplace_back(text[i] - '0', text[i + 1] - '0');
  for (int i = 0; is_curve && i < kSmoothing; ++i) stroke = CutCorners(stroke);
  return stroke;
}

std::vector<Stroke> ParseGlyph(std::string_view text) {
  std::vector<Stroke> strokes;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    strokes.push_back(ParseStroke(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return strokes;
}

}  // namespace

TextStrokes StrokesOf(std::string_view text) {
  TextStrokes result{{}, 0};
  double pen = 0;  // Grid units.
  for (const char letter : text) {
    const auto glyph = Glyphs().find(letter);
    double width = letter == ' ' ? kBlankWidth : 0;
    for (Stroke stroke : ParseGlyph(glyph == Glyphs().end() ? kUnknownGlyph : glyph->second)) {
      for (Vector2d& point : stroke) {
        width = std::max(width, point.x());
        point = (point + Vector2d(pen, -kBaseLine)) / kCapitalHeight;
      }
      result.strokes.push_back(std::move(stroke));
    }
    pen += width + kLetterGap;
  }
  result.width = std::max(0.0, pen - kLetterGap) / kCapitalHeight;
  return result;
}

}  // namespace dgd_demos
