// SPDX-License-Identifier: MIT
#include "report/fabric_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collide/rigid_body.h"
#include "report/number_text.h"
#include "report/svg.h"

namespace slipstitch {
namespace {

constexpr double kPanel = 230.0, kCaption = 690.0, kTop = 52.0, kBottom = 40.0, kMargin = 12.0;
constexpr double kAzimuth = 0.45, kElevation = 0.45;  // [rad]
constexpr int kChunk = 4;                             // segments of a yarn that are drawn as one

/// Right, up and towards the viewer [m].
Vec3 seen(const Vec3& p) {
  const double x = std::cos(kAzimuth) * p.x() - std::sin(kAzimuth) * p.z();
  const double z = std::sin(kAzimuth) * p.x() + std::cos(kAzimuth) * p.z();
  return {x, std::cos(kElevation) * p.y() - std::sin(kElevation) * z,
          std::sin(kElevation) * p.y() + std::cos(kElevation) * z};
}

struct View {
  double left = 0.0, top = 0.0;  // of the panel [px]
  Vec3 middle = Vec3::Zero();    // seen [m]
  double scale = 1.0;            // [px/m]
  double x(const Vec3& s) const { return left + 0.5 * kPanel + scale * (s.x() - middle.x()); }
  double y(const Vec3& s) const { return top + 0.5 * kPanel - scale * (s.y() - middle.y()); }
  std::string point(const Vec3& s) const { return coordinate1(x(s)) + " " + coordinate1(y(s)); }

 private:
  static std::string coordinate1(double value) { return coordinate(std::round(10.0 * value) / 10.0); }
};

struct Piece {
  double depth = 0.0;
  std::string element;
};

std::vector<Vec3> seen_yarn(const GrowingSet& set, int yarn) {
  const Topology& topology = set.header.topology;
  std::vector<Vec3> points;
  for (int i = topology.yarn_first[static_cast<std::size_t>(yarn)];
       i < topology.yarn_first[static_cast<std::size_t>(yarn) + 1]; ++i)
    points.push_back(seen(set.last.q.segment<3>(3 * topology.visit_node[static_cast<std::size_t>(i)])));
  return points;
}

/// The curve from point `first` to `last` as cubic Beziers (Catmull-Rom).
std::string curve(const std::vector<Vec3>& points, std::size_t first, std::size_t last, const View& view) {
  std::string path = "M" + view.point(points[first]);
  for (std::size_t i = first; i < last; ++i) {
    const Vec3& before = points[i == 0 ? 0 : i - 1];
    const Vec3& after = points[std::min(i + 2, points.size() - 1)];
    const Vec3 a = points[i] + (points[i + 1] - before) / 6.0, b = points[i + 1] - (after - points[i]) / 6.0;
    path += "C" + view.point(a) + " " + view.point(b) + " " + view.point(points[i + 1]);
  }
  return path;
}

void add_yarns(const GrowingSet& set, const View& view, double near, double far, std::vector<Piece>& pieces) {
  const double width = 2.0 * set.header.yarn.radius_m * view.scale;
  for (int yarn = 0; yarn < set.header.topology.num_yarns(); ++yarn) {
    const std::vector<Vec3> points = seen_yarn(set, yarn);
    for (std::size_t first = 0; first + 1 < points.size(); first += kChunk) {
      const std::size_t last = std::min(first + kChunk, points.size() - 1);
      double depth = 0.0;
      for (std::size_t i = first; i <= last; ++i) depth += points[i].z();
      depth /= static_cast<double>(last - first + 1);
      const std::string path = curve(points, first, last, view);
      const int light = 46 + static_cast<int>(std::lround(28.0 * (depth - far) / std::max(near - far, 1e-12)));
      pieces.push_back({depth, "<path d=\"" + path + "\" stroke=\"#12344f\" stroke-width=\"" +
                                   coordinate(1.15 * width) + "\"/><path d=\"" + path + "\" stroke=\"hsl(204,55%," +
                                   std::to_string(light) + "%)\" stroke-width=\"" + coordinate(0.72 * width) +
                                   "\"/>\n"});
    }
  }
}

std::string ball(double x, double y, double r, bool known) {
  const std::string place =
      "<circle cx=\"" + coordinate(x) + "\" cy=\"" + coordinate(y) + "\" r=\"" + coordinate(r) + "\" ";
  return place + (known ? "fill=\"url(#body)\"/>\n" : "fill=\"none\" stroke=\"#aaa\" stroke-dasharray=\"4 3\"/>\n");
}

std::string pill(const View& view, const Vec3& a, const Vec3& b, double r, bool known) {
  const std::string line =
      "<path d=\"M" + view.point(a) + "L" + view.point(b) + "\" stroke-linecap=\"round\" stroke-width=\"";
  return line + coordinate(2.0 * r) + (known ? "\" stroke=\"#c9b8a3\"/>\n" : "\" stroke=\"#eee\"/>\n");
}

/// Where the centre of a sphere is in a set's last frame, which holds those that are dynamic.
Vec3 centre_in(const GrowingSet& set, const RigidBody& body, const Sphere& sphere, int dynamic) {
  const Topology& topology = set.header.topology;
  if (dynamic < 0 || dynamic >= topology.num_bodies) return body.to_space(sphere.centre);
  return set.last.q.segment<3>(topology.x_coord(topology.num_nodes - topology.num_bodies + dynamic));
}

/// Spheres and capsules; planes, boxes and meshes are left out.
void add_bodies(const GrowingSet& set, const PictureBodies& bodies, const View& view, bool known,
                std::vector<Piece>& pieces) {
  const double behind = -std::numeric_limits<double>::infinity();
  int num_dynamic = 0;
  for (const Collider& collider : bodies.colliders) {
    RigidBody body(collider);
    body.move_to(bodies.t);
    if (const auto* sphere = std::get_if<Sphere>(&collider.shape)) {
      const Vec3 centre = seen(centre_in(set, body, *sphere, collider.dynamic ? num_dynamic++ : -1));
      pieces.push_back(
          {known ? centre.z() : behind, ball(view.x(centre), view.y(centre), sphere->radius * view.scale, known)});
    } else if (const auto* capsule = std::get_if<Capsule>(&collider.shape)) {
      const Vec3 a = seen(body.to_space(capsule->a)), b = seen(body.to_space(capsule->b));
      pieces.push_back({known ? 0.5 * (a.z() + b.z()) : behind, pill(view, a, b, capsule->radius * view.scale, known)});
    }
  }
}

struct Extent {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  void add(const Vec3& s) {
    low = low.cwiseMin(s);
    high = high.cwiseMax(s);
  }
};

/// Of the last set, which is the scene itself: what others do beyond it is cut off.
Extent extent_of(const GrowingSet& set) {
  Extent extent;
  for (int yarn = 0; yarn < set.header.topology.num_yarns(); ++yarn)
    for (const Vec3& s : seen_yarn(set, yarn)) extent.add(s);
  return extent;
}

bool in_view(const GrowingSet& set, const View& view) {
  for (int yarn = 0; yarn < set.header.topology.num_yarns(); ++yarn)
    for (const Vec3& s : seen_yarn(set, yarn))
      if (std::abs(view.y(s) - view.top - 0.5 * kPanel) < 0.5 * kPanel) return true;
  return false;
}

void captions(Svg& svg, const GrowingSet& set, const View& view, bool first) {
  svg.text(view.left + kMargin, kTop - 26.0, (first ? "" : "+ ") + set.stage, "start", "#222",
           "font-size=\"14\" font-weight=\"600\"");
  const std::string note =
      set.failure.empty() ? duration_text(set.wall_s) : "stops at " + short_number(set.last.t) + " s";
  svg.text(view.left + kMargin, kTop - 9.0, note, "start", "#777");
  if (!in_view(set, view)) {
    svg.text(view.left + 0.5 * kPanel, kTop + 0.12 * kPanel, "out of the picture", "middle", "#777",
             "font-style=\"italic\"");
  }
}

}  // namespace

std::string growing_picture(const std::string& scene, const std::vector<GrowingSet>& sets,
                            const PictureBodies& bodies) {
  if (sets.empty() || sets.back().last.q.size() == 0) return {};
  const Extent extent = extent_of(sets.back());
  const Vec3 size = extent.high - extent.low;
  View view;
  view.top = kTop;
  view.middle = 0.5 * (extent.low + extent.high);
  view.scale = (kPanel - 2.0 * kMargin) / std::max({1.15 * size.x(), 1.15 * size.y(), 1e-9});
  Svg svg(std::max(kPanel * static_cast<double>(sets.size()), kCaption), kTop + kPanel + kBottom, scene + " under growing sets of effects");
  svg.raw(
      "<defs><radialGradient id=\"body\" cx=\".38\" cy=\".32\" r=\".75\"><stop offset=\"0\" stop-color=\"#f3e7d8\"/>"
      "<stop offset=\"1\" stop-color=\"#a88f73\"/></radialGradient></defs>\n");
  for (std::size_t i = 0; i < sets.size(); ++i) {
    view.left = kPanel * static_cast<double>(i);
    captions(svg, sets[i], view, i == 0);
    std::vector<Piece> pieces;
    add_yarns(sets[i], view, extent.high.z(), extent.low.z(), pieces);
    const bool known = std::any_of(
        sets.begin(), sets.begin() + static_cast<std::ptrdiff_t>(i) + 1,
        [](const GrowingSet& s) { return std::find(s.added.begin(), s.added.end(), "colliders") != s.added.end(); });
    add_bodies(sets[i], bodies, view, known, pieces);
    std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.depth < b.depth; });
    svg.raw("<svg x=\"" + coordinate(view.left) + "\" y=\"" + coordinate(kTop) + "\" width=\"" + coordinate(kPanel) +
            "\" height=\"" + coordinate(kPanel) + "\" viewBox=\"" + coordinate(view.left) + " " + coordinate(kTop) +
            " " + coordinate(kPanel) + " " + coordinate(kPanel) + "\"><g fill=\"none\" stroke-linejoin=\"round\">\n");
    for (const Piece& piece : pieces) svg.raw(piece.element);
    svg.raw("</g></svg>\n");
  }
  const double t = sets.back().last.t;
  svg.text(kMargin, kTop + kPanel + 24.0,
           scene + " at t = " + short_number(t) +
               " s. Each picture adds effects to those before it; below its name, the "
               "wall time of the run.",
           "start", "#777");
  return svg.finish();
}

}  // namespace slipstitch
