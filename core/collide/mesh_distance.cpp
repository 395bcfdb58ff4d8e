// SPDX-License-Identifier: MIT
#include "collide/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "collide/closest_point.h"

namespace slipstitch {
namespace {

std::array<Vec3, 3> corners(const TriangleMesh& mesh, int triangle) {
  const auto& t = mesh.triangles[static_cast<std::size_t>(triangle)];
  const auto at = [&](int i) { return mesh.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])]; };
  return {at(0), at(1), at(2)};
}

std::array<int, 2> ascending(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// What Eigen's BVMinimize asks for: squared distances.
struct Closest {
  using Scalar = double;
  const TriangleMesh& mesh;
  const Vec3& p;
  double best = std::numeric_limits<double>::infinity();
  int triangle = -1;
  TrianglePoint where{};

  double minimumOnVolume(const Eigen::AlignedBox3d& box) const { return box.squaredExteriorDistance(p); }
  double minimumOnObject(int candidate) {
    const TrianglePoint at = closest_on_triangle(p, corners(mesh, candidate));
    const double d = (p - at.point).squaredNorm();
    if (d < best) {
      best = d;
      triangle = candidate;
      where = at;
    }
    return d;
  }
};

}  // namespace

MeshDistance::MeshDistance(const TriangleMesh& mesh) : mesh_(mesh), vertex_normal_(mesh.vertices.size(), Vec3::Zero()) {
  std::map<std::array<int, 2>, Vec3> edges;
  std::vector<int> triangles;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
    const auto x = corners(mesh, i);
    const auto& t = mesh.triangles[static_cast<std::size_t>(i)];
    const Vec3 n = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
    face_normal_.push_back(n);
    Eigen::AlignedBox3d box;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
      vertex_normal_[static_cast<std::size_t>(t[k])] += angle_between(x[next] - x[k], x[last] - x[k]) * n;
      edges.try_emplace(ascending(t[k], t[next]), Vec3::Zero()).first->second += n;
      box.extend(x[k]);
    }
    triangles.push_back(i);
    boxes.push_back(box);
  }
  edge_normal_.assign(edges.begin(), edges.end());
  tree_.init(triangles.begin(), triangles.end(), boxes.begin(), boxes.end());
}

Vec3 MeshDistance::edge_normal(int a, int b) const {
  const auto key = ascending(a, b);
  return std::lower_bound(edge_normal_.begin(), edge_normal_.end(), key,
                          [](const auto& entry, const auto& k) { return entry.first < k; })
      ->second;
}

Distance MeshDistance::operator()(const Vec3& p) const {
  Closest closest{mesh_, p};
  Eigen::BVMinimize(tree_, closest);
  const auto triangle = static_cast<std::size_t>(closest.triangle);
  const auto& [a, b, c] = mesh_.triangles[triangle];
  const Vec3 d = p - closest.where.point;
  const double length = d.norm();
  Vec3 pseudo = face_normal_[triangle];
  Mat3 round = Mat3::Zero();  // of the distance to an edge or a corner, times that distance
  const auto at_corner = [&](int v) {
    pseudo = vertex_normal_[static_cast<std::size_t>(v)];
    round = Mat3::Identity();
  };
  const auto at_edge = [&](int v, int w) {
    pseudo = edge_normal(v, w);
    const Vec3 along =
        (mesh_.vertices[static_cast<std::size_t>(w)] - mesh_.vertices[static_cast<std::size_t>(v)]).normalized();
    round = Mat3::Identity() - along * along.transpose();
  };
  switch (closest.where.feature) {
    case Feature::a:
      at_corner(a);
      break;
    case Feature::b:
      at_corner(b);
      break;
    case Feature::c:
      at_corner(c);
      break;
    case Feature::ab:
      at_edge(a, b);
      break;
    case Feature::bc:
      at_edge(b, c);
      break;
    case Feature::ca:
      at_edge(c, a);
      break;
    case Feature::face:
      break;
  }
  const double sign = d.dot(pseudo) < 0.0 ? -1.0 : 1.0;
  if (!(length > 0.0)) return {0.0, pseudo.normalized(), Mat3::Zero()};
  Distance result{sign * length, sign / length * d, Mat3::Zero()};
  if (closest.where.feature != Feature::face) {
    result.curvature = (round - result.normal * result.normal.transpose()) / result.phi;
  }
  return result;
}

}  // namespace slipstitch
