#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "run/slide.hpp"

namespace slope::couple {
namespace {

constexpr double moved = 0.02;  // m

Domain domain_of(double cell, SurfaceParticles kind) {
  Domain domain;
  domain.upper = {36.0, 16.0};
  domain.cell_size = cell;
  domain.surface_particles = kind;
  return domain;
}

/// The slope W2: toe (10, 5), crest (22.6, 12).
const std::vector<Point> w2{{0, 0}, {36, 0}, {36, 12}, {22.6, 12}, {10, 5}, {0, 5}};
/// Two faces of 1:1 with a bench of 6 m: toes at (8, 3) and (18, 7), crest at (22, 11).
const std::vector<Point> benched{{0, 0}, {36, 0}, {36, 11}, {22, 11}, {18, 7}, {12, 7}, {8, 3}, {0, 3}};

std::vector<Point> mirrored(std::vector<Point> polygon) {
  for (Point& corner : polygon) corner[0] = 36.0 - corner[0];
  return polygon;
}

struct SlopeOf {
  SlopeOf(const std::vector<Point>& polygon, double cell, SurfaceParticles kind)
      : domain(domain_of(cell, kind)), ground(domain, {{0, polygon}}) {
    const InitialParticles initial = fill_regions(domain, {{0, polygon}});
    spacing = initial.spacing;
    soil.x = initial.x;
    soil.y = initial.y;
    soil.volume = initial.volume;
    soil.ux.assign(soil.x.size(), 0.0);
    soil.uy.assign(soil.x.size(), 0.0);
  }
  /// Moves the particles by what a function of the first position says.
  void move(const std::function<Point(double, double)>& displacement) {
    for (std::size_t p = 0; p < soil.x.size(); ++p) {
      const Point u = displacement(soil.x[p], soil.y[p]);
      soil.ux[p] = u[0];
      soil.uy[p] = u[1];
      soil.x[p] += u[0];
      soil.y[p] += u[1];
    }
  }
  [[nodiscard]] Slide slide() const { return find_slide(soil, ground, domain, spacing, moved); }

  Domain domain;
  GroundLine ground;
  double spacing = 0.0;
  solid::Particles soil;
};

TEST(GroundLine, IsTheUpperOutlineOfAllRegions) {
  const Domain domain = domain_of(0.5, SurfaceParticles::lattice);
  const GroundLine ground(domain, {{0, {{0, 0}, {20, 0}, {20, 4}, {0, 4}}}, {0, {{10, 2}, {30, 2}, {30, 8}}}});
  // the second region's upper side, y = 2 + 0.3 (x - 10), comes out of the first at x = 16.667 m
  const std::vector<Point> expected{{0, 4}, {10, 4}, {16.0 + 2.0 / 3.0, 4}, {20, 5}, {30, 8}, {30, 0}, {36, 0}};
  ASSERT_EQ(ground.points().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(ground.points()[i][0], expected[i][0], 1e-12) << i;
    EXPECT_NEAR(ground.points()[i][1], expected[i][1], 1e-12) << i;
  }
}

TEST(GroundLine, HasAHeightEverywhere) {
  const Domain domain = domain_of(0.5, SurfaceParticles::lattice);
  const GroundLine ground(domain, {{0, {{0, 0}, {36, 0}, {36, 12}, {12, 12}, {12, 4}, {0, 2}}}});
  EXPECT_EQ(ground.height(-1.0), 2.0);
  EXPECT_EQ(ground.height(6.0), 3.0);
  EXPECT_EQ(ground.height(12.0), 12.0);
  EXPECT_EQ(ground.height(12.1), 12.0);
  EXPECT_EQ(ground.height(40.0), 12.0);
}

TEST(GroundLine, HasAToeForEachFace) {
  const Domain domain = domain_of(0.5, SurfaceParticles::lattice);
  const GroundLine ground(domain, {{0, benched}});
  EXPECT_EQ(ground.toes(30.0, -1.0), (std::vector<Point>{{18, 7}, {8, 3}}));
  EXPECT_EQ(ground.toes(20.0, -1.0), (std::vector<Point>{{18, 7}, {8, 3}})) << "from within the face";
  EXPECT_EQ(ground.toes(15.0, -1.0), (std::vector<Point>{{8, 3}}));
  EXPECT_TRUE(ground.toes(30.0, 1.0).empty()) << "flat";
  EXPECT_EQ(GroundLine(domain, {{0, mirrored(benched)}}).toes(6.0, 1.0), (std::vector<Point>{{18, 7}, {28, 3}}));
}

TEST(GroundLine, OfAVerticalCutHasItsToeBelow) {
  const Domain domain = domain_of(0.5, SurfaceParticles::lattice);
  const GroundLine ground(domain, {{0, {{0, 0}, {36, 0}, {36, 12}, {12, 12}, {12, 4}, {0, 4}}}});
  EXPECT_EQ(ground.toes(20.0, -1.0), (std::vector<Point>{{12, 4}}));
}

TEST(GroundLine, CountsNoNarrowBenchNoRoughnessAndNoGentleStart) {
  const Domain domain = domain_of(0.5, SurfaceParticles::lattice);
  // surveyed from the crest, which falls at 1:50, over a bench of 0.6 m and a step of 10 cm upwards
  const std::vector<Point> rough{{36, 0},     {36, 12.2}, {26, 12}, {22, 10}, {21.4, 10}, {19, 8.2},
                                 {18.5, 8.3}, {15, 6.5},  {12, 5},  {8, 4.8}, {0, 4.7},   {0, 0}};
  const auto toes = GroundLine(domain, {{0, rough}}).toes(34.0, -1.0);
  ASSERT_FALSE(toes.empty());
  EXPECT_EQ(toes[0], (Point{12, 5}));
}

TEST(GroundLine, OfAGentleSlopeHasItsToeToo) {
  const Domain domain = domain_of(0.5, SurfaceParticles::lattice);
  const std::vector<Point> gentle{{0, 0}, {36, 0}, {36, 6}, {30, 6}, {10, 4.4}, {0, 4.2}};  // 1:12.5, then 1:50
  EXPECT_EQ(GroundLine(domain, {{0, gentle}}).toes(33.0, -1.0), (std::vector<Point>{{10, 4.4}}));
}

TEST(GroundLine, ThatFallsToTheSideHasNoToe) {
  const Domain domain = domain_of(0.5, SurfaceParticles::lattice);
  EXPECT_TRUE(GroundLine(domain, {{0, {{0, 0}, {36, 0}, {36, 12}, {0, 2}}}}).toes(30.0, -1.0).empty());
}

class RunOut : public testing::TestWithParam<SurfaceParticles> {};

TEST_P(RunOut, OfASlopeThatStandsIsZero) {
  SlopeOf slope(w2, 0.5, GetParam());
  slope.move([](double, double y) { return Point{0.001 * y / 12.0, -0.015 * y / 12.0}; });  // settles by 1.5 cm
  const Slide slide = slope.slide();
  EXPECT_EQ(slide.area, 0.0);
  EXPECT_EQ(slide.direction, 0.0);
  EXPECT_EQ(slide.run_out, 0.0);
  EXPECT_FALSE(slide.toe);
  EXPECT_NEAR(slide.largest_horizontal_displacement, 0.001, 1e-4);
}

TEST_P(RunOut, OfAFaceThatMovesAsOneIsItsWay) {
  for (const double cell : {0.25, 0.5, 1.0}) {
    for (const double way : {0.03, 0.3, 1.7, 6.0}) {
      SlopeOf slope(w2, cell, GetParam());
      double area = 0.0;
      slope.move([&](double x, double y) { return y > 5.0 && x < 20.0 ? Point{-way, 0.0} : Point{0.0, 0.0}; });
      for (std::size_t p = 0; p < slope.soil.x.size(); ++p) area += slope.soil.ux[p] < 0.0 ? slope.soil.volume[p] : 0.0;
      const Slide slide = slope.slide();
      EXPECT_EQ(slide.direction, -1.0);
      EXPECT_EQ(slide.toe, (Point{10, 5}));
      EXPECT_NEAR(slide.run_out.value(), way, 1e-9) << cell;
      EXPECT_NEAR(slide.largest_horizontal_displacement, way, 1e-12);
      EXPECT_NEAR(slide.area, area, 1e-9);
      EXPECT_FALSE(slide.reaches_wall);
    }
  }
}

TEST_P(RunOut, ToTheRightIsThatToTheLeft) {
  SlopeOf left(w2, 0.5, GetParam()), right(mirrored(w2), 0.5, GetParam());
  // goes to nothing over 2 m of depth below a slip line of 1:3
  const auto way = [](double x, double y) { return 0.8 * std::clamp(0.5 * (y - 3.0 - 0.3 * (x - 10.0)), 0.0, 1.0); };
  left.move([&](double x, double y) { return Point{-way(x, y), -0.3 * way(x, y)}; });
  right.move([&](double x, double y) { return Point{way(36.0 - x, y), -0.3 * way(36.0 - x, y)}; });
  EXPECT_EQ(right.slide().direction, 1.0);
  EXPECT_EQ(right.slide().toe, (Point{26, 5}));
  EXPECT_NEAR(right.slide().run_out.value(), left.slide().run_out.value(), 1e-9);
  EXPECT_NEAR(right.slide().area, left.slide().area, 1e-9);
  EXPECT_NEAR(left.slide().run_out.value(), 0.8, 0.01);
}

TEST_P(RunOut, OfAVerticalCutIsTheAdvanceOfItsFoot) {
  SlopeOf slope({{0, 0}, {36, 0}, {36, 12}, {12, 12}, {12, 4}, {0, 4}}, 0.5, GetParam());
  slope.move([](double x, double y) { return y > 4.0 && x < 16.0 ? Point{-0.4, -0.2} : Point{0.0, 0.0}; });
  EXPECT_NEAR(slope.slide().run_out.value(), 0.4, 1e-9);
}

TEST_P(RunOut, OfAHeapThatSpreadsIsItsFoot) {
  // a block 8 m high spreads over a flat base, three times as wide and a third as high
  SlopeOf slope({{14, 0}, {22, 0}, {22, 8}, {14, 8}}, 0.5, GetParam());
  slope.move([](double x, double y) { return Point{2.0 * (x - 18.0), -2.0 / 3.0 * y}; });
  const Slide slide = slope.slide();
  EXPECT_NEAR(slide.run_out.value(), 8.0, 0.3) << "the particles' centres";
  EXPECT_NEAR(slide.largest_horizontal_displacement, 8.0, 0.3);
}

TEST_P(RunOut, OfTheUpperFaceCountsFromItsOwnToe) {
  SlopeOf slope(benched, 0.5, GetParam());
  slope.move([](double x, double y) { return x > 18.0 && x < 24.0 && y > 7.0 ? Point{-2.5, -0.1} : Point{0.0, 0.0}; });
  const Slide slide = slope.slide();
  EXPECT_EQ(slide.toe, (Point{18, 7}));
  EXPECT_NEAR(slide.run_out.value(), 2.5, 1e-9);
}

TEST_P(RunOut, OfBothFacesCountsFromTheLowerToe) {
  SlopeOf slope(benched, 0.5, GetParam());
  slope.move([](double x, double y) { return x < 24.0 && y > 3.0 ? Point{-1.5, 0.0} : Point{0.0, 0.0}; });
  EXPECT_EQ(slope.slide().toe, (Point{8, 3}));
  EXPECT_NEAR(slope.slide().run_out.value(), 1.5, 1e-9);
}

TEST_P(RunOut, OfWhatStaysOnTheFaceIsZero) {
  SlopeOf slope(w2, 0.5, GetParam());
  slope.move([](double x, double y) {
    return y > 9.5 && x < 22.0 ? Point{-1.0, -0.55} : Point{0.0, 0.0};  // along the face
  });
  const Slide slide = slope.slide();
  EXPECT_EQ(slide.toe, (Point{10, 5})) << "of the face below";
  EXPECT_EQ(slide.run_out, 0.0);
  EXPECT_GT(slide.area, 1.0);
}

TEST_P(RunOut, CountsNoSplash) {
  for (const int grains : {1, 9}) {
    SlopeOf slope(w2, 0.5, GetParam());
    int thrown = 0;
    slope.move([&](double x, double y) {
      if (y <= 5.0 || x > 20.0) return Point{0.0, 0.0};
      const bool throws = thrown < grains && y > 8.0;
      thrown += throws ? 1 : 0;
      return throws ? Point{-13.0, -2.0} : Point{-0.5, 0.0};
    });
    EXPECT_EQ(thrown, grains);
    EXPECT_NEAR(slope.slide().run_out.value(), 0.5, 1e-9) << grains;
  }
}

TEST_P(RunOut, CountsABodyThatHasComeOff) {
  SlopeOf slope(w2, 0.5, GetParam());
  slope.move([](double x, double y) {
    if (y <= 5.0 || x > 20.0) return Point{0.0, 0.0};
    return y < 8.0 && x < 13.0 ? Point{-4.0, 0.0} : Point{-0.5, 0.0};
  });
  EXPECT_NEAR(slope.slide().run_out.value(), 4.0, 1e-9);
}

TEST_P(RunOut, ReachesAsFarAsTheGroundIsPushedUp) {
  // the ground ahead of the toe rises evenly from nothing at x = 6 m to 0.4 m at the toe: half a spacing, 0.125 m, at
  // x = 7.25 m
  const auto bulge = [](double x) { return 0.1 * std::clamp(x - 6.0, 0.0, 4.0); };
  const auto moves = [&](double forward) {
    SlopeOf slope(w2, 0.5, GetParam());
    slope.move([&](double x, double y) {
      if (y > 5.0 && x < 20.0) return Point{-0.3, 0.0};
      return x < 10.0 ? Point{forward, bulge(x)} : Point{0.0, 0.0};
    });
    return slope.slide().run_out.value();
  };
  EXPECT_NEAR(moves(-0.03), 10.0 - 7.25 + 0.03, 0.01);
  EXPECT_NEAR(moves(0.0), 0.3, 1e-9) << "ground that swells is not pushed";
}

TEST_P(RunOut, IsToldWhereTheSlideComesToTheWall) {
  SlopeOf slope(w2, 0.5, GetParam());
  slope.move([](double x, double y) { return y > 5.0 && x < 20.0 ? Point{-9.9, 0.0} : Point{0.0, 0.0}; });
  EXPECT_TRUE(slope.slide().reaches_wall);
  EXPECT_NEAR(slope.slide().run_out.value(), 9.9, 1e-9);
}

TEST_P(RunOut, WithoutAToeIsNotKnown) {
  SlopeOf slope({{0, 0}, {36, 0}, {36, 12}, {0, 2}}, 0.5, GetParam());
  slope.move([](double, double y) { return y > 3.0 ? Point{-0.5, -0.14} : Point{0.0, 0.0}; });
  EXPECT_FALSE(slope.slide().run_out);
  EXPECT_FALSE(slope.slide().toe);
  EXPECT_NEAR(slope.slide().largest_horizontal_displacement, 0.5, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Particles, RunOut, testing::Values(SurfaceParticles::lattice, SurfaceParticles::clipped),
                         [](const auto& instance) {
                           return instance.param == SurfaceParticles::clipped ? "Clipped" : "Lattice";
                         });

}  // namespace
}  // namespace slope::couple
