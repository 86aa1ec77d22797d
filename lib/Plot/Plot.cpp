//===-- lib/Plot/Plot.cpp - error against time, as a picture ----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Plot/Plot.h"
#include "lib/Plot/Style.h"
#include "lib/Plot/Svg.h"
#include <algorithm>
#include <cmath>
#include <tuple>

namespace anysl::plot {
namespace {

constexpr double width = 980, height = 520;
constexpr double left = 76, right = 700, top = 40, bottom = 456; ///< of the plot's area
constexpr double zeroColumn = 60;                                ///< for x = 0, where there is one
constexpr double radius = 8, letter = 6.3, lineHeight = 15;

/// One logarithmic axis, from values to places.
class Axis {
public:
  Axis(std::vector<double> values, double from, double to) : from(from), to(to) {
    std::erase_if(values, [](double value) { return !(value > 0) || !std::isfinite(value); });
    auto [low, high] = std::minmax_element(values.begin(), values.end());
    double a = values.empty() ? 0 : std::log10(*low), b = values.empty() ? 1 : std::log10(*high);
    double margin = std::max(0.06 * (b - a), 0.1);
    first = a - margin;
    last = b + margin;
  }
  double place(double value) const {
    return from + (std::log10(value) - first) / (last - first) * (to - from);
  }
  /// Round values on the axis: powers of ten, with 2 and 5 times them where these are few.
  std::vector<double> ticks() const {
    std::vector<double> result;
    for (int power = int(std::floor(first)); power <= int(std::ceil(last)); ++power)
      for (int digit : {1, 2, 5}) {
        double value = digit * std::pow(10, power), log = std::log10(value);
        if (log >= first && log <= last && (digit == 1 || last - first < 2.5))
          result.push_back(value);
      }
    return result;
  }

private:
  double from, to, first, last;
};

struct Box {
  double x0, y0, x1, y1;
  bool meets(const Box &other) const {
    return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
  }
};

std::string outline(unsigned shape, double x, double y, double r, const std::string &rest) {
  switch (shape) {
  case 0:
    return format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" ", x, y, r) + rest + "/>";
  case 1:
    return format("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" ", x - r * 0.9,
                  y - r * 0.9, r * 1.8, r * 1.8) +
           rest + "/>";
  default:
    return format("<path d=\"M%.1f %.1fL%.1f %.1fL%.1f %.1fL%.1f %.1fZ\" ", x, y - r * 1.2,
                  x + r * 1.2, y, x, y + r * 1.2, x - r * 1.2, y) +
           rest + "/>";
  }
}

class Drawing {
public:
  explicit Drawing(const Plot &plot)
      : plot(plot), front(paretoFront(plot.points)),
        hasZero(std::any_of(plot.points.begin(), plot.points.end(),
                            [](const Point &point) { return point.x == 0; })),
        x(valuesAndGuides(), hasZero ? left + zeroColumn : left, right),
        y(values(&Point::y), bottom, top) {}

  std::string draw(bool standalone) {
    text = format("<svg class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %g %g\" "
                  "role=\"img\">\n",
                  width, height);
    if (standalone)
      text += std::string("<style>") + plotStyle + "</style>\n" +
              format("<rect class=\"back\" width=\"%g\" height=\"%g\"/>\n", width, height);
    text += textAt(left, 24, "class=\"title\"", plot.title);
    drawAxes();
    drawGuides();
    drawFront();
    drawLegend();
    drawPoints();
    drawLabels();
    return text + "</svg>\n";
  }

private:
  std::vector<double> values(double Point::*member) const {
    std::vector<double> result;
    for (const Point &point : plot.points)
      if (std::isfinite(point.x) && std::isfinite(point.y))
        result.push_back(point.*member);
    return result;
  }
  std::vector<double> valuesAndGuides() const {
    std::vector<double> result = values(&Point::x);
    for (const auto &[value, name] : plot.guides)
      result.push_back(value);
    return result;
  }
  bool isShown(const Point &point) const {
    return std::isfinite(point.x) && std::isfinite(point.y) && point.y > 0 && point.x >= 0;
  }
  double px(const Point &point) const {
    return point.x > 0 ? x.place(point.x) : left + zeroColumn / 2;
  }
  double py(const Point &point) const { return y.place(point.y); }

  void drawAxes() {
    for (double tick : x.ticks()) {
      double at = x.place(tick);
      text += format("<path class=\"grid\" d=\"M%.1f %gV%g\"/>\n", at, top, bottom);
      text += textAt(at, bottom + 18, "class=\"tick\" text-anchor=\"middle\"", tickText(tick));
    }
    if (hasZero) {
      text += format("<path class=\"axis\" d=\"M%g %gV%g\" stroke-dasharray=\"2 3\"/>\n",
                     left + zeroColumn, top, bottom);
      text += textAt(left + zeroColumn / 2, bottom + 18, "class=\"tick\" text-anchor=\"middle\"",
                     "exact");
    }
    for (double tick : y.ticks()) {
      double at = y.place(tick);
      text += format("<path class=\"grid\" d=\"M%g %.1fH%g\"/>\n", left, at, right);
      text += textAt(left - 8, at + 4, "class=\"tick\" text-anchor=\"end\"", tickText(tick));
    }
    text += format("<path class=\"axis\" d=\"M%g %gV%gH%g\"/>\n", left, top, bottom, right);
    double middle = (top + bottom) / 2;
    std::string turned = format("text-anchor=\"middle\" transform=\"rotate(-90 20 %g)\"", middle);
    text += textAt((left + right) / 2, bottom + 42, "class=\"name\" text-anchor=\"middle\"",
                   plot.xLabel);
    text += textAt(20, middle, ("class=\"name\" " + turned).c_str(), plot.yLabel);
    text += textAt(left, bottom + 42, "class=\"tick\"", "\u2190 more exact");
    text +=
        textAt(20, bottom, format("class=\"tick\" transform=\"rotate(-90 20 %g)\"", bottom).c_str(),
               "\u2190 faster");
  }

  void drawGuides() {
    for (const auto &[value, name] : plot.guides) {
      if (!(value > 0) || !std::isfinite(value))
        continue;
      double at = x.place(value);
      text += format("<path class=\"guide\" d=\"M%.1f %gV%g\"/>\n", at, top, bottom);
      text += textAt(at + 5, top + 10, "class=\"guide-label\"", name);
      double size = letter * double(name.size());
      taken.push_back({at + 5, top, at + 5 + size, top + 14});
    }
  }

  static std::string tickText(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%g", value);
    return buffer;
  }

  /// What is within reach is above and to the right of the front.
  void drawFront() {
    if (front.size() < 2)
      return;
    std::string path;
    for (size_t i = 0; i < front.size(); ++i) {
      const Point &point = plot.points[front[i]];
      if (!i)
        path = format("M%.1f %.1f", px(point), py(point));
      else
        path += format("H%.1fV%.1f", px(point), py(point));
    }
    text += "<path class=\"front\" d=\"" + path + "\"/>\n";
  }

  void drawLegend() {
    double at = top + 6, column = right + 24;
    auto line = [&](const std::string &drawn, const std::string &name) {
      text += drawn + textAt(column + 18, at + 4, "class=\"key\"", name);
      at += 21;
    };
    for (size_t i = 0; i < plot.series.size(); ++i)
      if (!plot.series[i].empty())
        line(outline(0, column + 5, at, 6, format("class=\"key-dot s%zu\"", i)), plot.series[i]);
    at += 6;
    for (size_t i = 0; i < plot.shapes.size() && plot.shapes.size() > 1; ++i)
      line(outline(unsigned(i), column + 5, at, 6, "class=\"key-shape\""), plot.shapes[i]);
    if (!plot.markMeaning.empty())
      line(outline(0, column + 5, at, 8, "class=\"key-shape\"") +
               textAt(column + 5, at + 3.2, "class=\"mark key-mark\" text-anchor=\"middle\"", "8"),
           plot.markMeaning);
    line(format("<path class=\"front\" d=\"M%g %gh14\"/>", column - 2, at),
         "Pareto front: the best trades");
    panelTop = at + 8;
    text += panel() + textAt(column + 8, panelTop + 22, "class=\"hint\"",
                             "Point at a mark to see its numbers.");
  }

  std::string panel() const {
    return format("<rect class=\"panel\" x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\" rx=\"4\"/>\n",
                  right + 18, panelTop, width - right - 24, height - panelTop - 8);
  }

  void drawPoints() {
    // Points of the front lie on top.
    std::vector<size_t> order;
    for (bool onFront : {false, true})
      for (size_t i = 0; i < plot.points.size(); ++i)
        if (isOnFront(i) == onFront)
          order.push_back(i);
    for (size_t i : order) {
      const Point &point = plot.points[i];
      if (!isShown(point))
        continue;
      double cx = px(point), cy = py(point);
      text += format("<g class=\"point%s\">", isOnFront(i) ? " on-front" : "") +
              outline(point.shape, cx, cy, radius, format("class=\"dot s%u\"", point.series)) +
              textAt(cx, cy + 3.2, "class=\"mark\" text-anchor=\"middle\"", point.mark) +
              "<g class=\"tip\">" + panel();
      double at = panelTop + 22;
      text += textAt(right + 30, at, "class=\"tip-title\"", point.name);
      for (const auto &[name, value] : point.details) {
        at += lineHeight + 2;
        text += textAt(right + 30, at, "class=\"tip-name\"", name) +
                textAt(width - 16, at, "class=\"tip-value\" text-anchor=\"end\"", value);
      }
      text += "</g></g>\n";
      taken.push_back({cx - radius, cy - radius, cx + radius, cy + radius});
    }
  }

  bool isOnFront(size_t i) const { return std::find(front.begin(), front.end(), i) != front.end(); }

  /// The front's labels first, then whatever else finds room.
  void drawLabels() {
    std::vector<size_t> order = front;
    for (size_t i = 0; i < plot.points.size(); ++i)
      if (!isOnFront(i))
        order.push_back(i);
    for (size_t i : order) {
      const Point &point = plot.points[i];
      if (!isShown(point) || point.label.empty())
        continue;
      bool important = isOnFront(i);
      double size = letter * double(point.label.size()), cx = px(point), cy = py(point);
      // From near to far, so that a label of the front always ends up somewhere.
      for (double away = 1; away <= (important ? 6 : 1); ++away) {
        double d = radius + 4 + (away - 1) * 12;
        Box places[] = {{cx + d, cy - 7, cx + d + size, cy + 7},
                        {cx - d - size, cy - 7, cx - d, cy + 7},
                        {cx - size / 2, cy - d - 13, cx + size / 2, cy - d},
                        {cx - size / 2, cy + d, cx + size / 2, cy + d + 13},
                        {cx + d * 0.7, cy - d - 10, cx + d * 0.7 + size, cy - d + 3},
                        {cx + d * 0.7, cy + d - 3, cx + d * 0.7 + size, cy + d + 10},
                        {cx - d * 0.7 - size, cy + d - 3, cx - d * 0.7, cy + d + 10},
                        {cx - d * 0.7 - size, cy - d - 10, cx - d * 0.7, cy - d + 3}};
        auto fits = [&](const Box &box) {
          return box.x0 > left + 2 && box.x1 < right + 14 && box.y0 > top - 10 &&
                 box.y1 < bottom - 2 &&
                 std::none_of(
                     taken.begin(), taken.end(),
                     [&](const Box &other) { return box.meets(other); });
        };
        const Box *place = std::find_if(std::begin(places), std::end(places), fits);
        if (place == std::end(places))
          continue;
        taken.push_back(*place);
        if (away > 1)
          text += format("<path class=\"leader\" d=\"M%.1f %.1fL%.1f %.1f\"/>\n", cx, cy,
                         std::clamp(cx, place->x0, place->x1),
                         std::clamp(cy, place->y0 + 2, place->y1 - 2));
        text += textAt(place->x0, place->y1 - 3.5,
                       important ? "class=\"label front-label\"" : "class=\"label\"", point.label);
        break;
      }
    }
  }

  const Plot &plot;
  std::vector<size_t> front;
  bool hasZero;
  Axis x, y;
  double panelTop = 0;
  std::vector<Box> taken;
  std::string text;
};

} // namespace

std::vector<size_t> paretoFront(const std::vector<Point> &points) {
  std::vector<size_t> order;
  for (size_t i = 0; i < points.size(); ++i)
    if (std::isfinite(points[i].x) && std::isfinite(points[i].y))
      order.push_back(i);
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return std::tuple(points[a].x, points[a].y, a) < std::tuple(points[b].x, points[b].y, b);
  });
  std::vector<size_t> front;
  for (size_t i : order)
    if (front.empty() || points[i].y < points[front.back()].y)
      front.push_back(i);
  return front;
}

std::string svg(const Plot &plot, bool standalone) { return Drawing(plot).draw(standalone); }

std::string escaped(const std::string &text) {
  std::string result;
  for (char c : text)
    switch (c) {
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '&':
      result += "&amp;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  return result;
}

std::string shortNumber(double value) { return format("%.3g", value); }

std::string page(const std::string &title, const std::string &body) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(title) + "</title>\n<style>" + plotStyle + pageStyle +
         "</style>\n</head>\n<body>\n" + body + "</body>\n</html>\n";
}

std::string table(const std::vector<std::string> &names,
                  const std::vector<std::vector<std::string>> &rows,
                  const std::vector<size_t> &highlighted) {
  std::string text = "<div class=\"scroll\"><table>\n<thead><tr>";
  for (const std::string &name : names)
    text += "<th>" + name + "</th>";
  text += "</tr></thead>\n<tbody>\n";
  for (size_t i = 0; i < rows.size(); ++i) {
    bool stands = std::find(highlighted.begin(), highlighted.end(), i) != highlighted.end();
    text += stands ? "<tr class=\"chosen\">" : "<tr>";
    for (const std::string &cell : rows[i])
      text += "<td>" + cell + "</td>";
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

} // namespace anysl::plot
