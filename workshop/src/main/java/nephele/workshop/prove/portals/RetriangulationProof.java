package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.placement.Gun;
import nephele.engine.portal.placement.Placement;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.PlacementResult.Refusal;
import nephele.engine.portal.placement.PlacementSurfaces;
import nephele.engine.portal.placement.ShotRay;
import nephele.engine.portal.placement.SurfacePolygon;
import nephele.lab.placement.WallPlace;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Cuts the same wall into other triangles, tilts it by up to 0.1°, adds noise, and compares the answers to the same
 * shots.
 *
 * <p>Two kinds of shots are left out and counted, because two walls that differ by what this proof allows may both be
 * right with different answers. Without noise only the cutting differs: a shot is left out if the answer changes its
 * kind or reason when the aperture grows or shrinks by a micrometre, many times the rounding of wall coordinates. With
 * noise each edge is within 10 µm in each direction, and the tilt lengthens 8 m by 12 µm, so that an aperture that is
 * {@link #MARGIN} larger or smaller represents another wall's right answer: a shot is left out if its kind or reason
 * differs, or if its place moves more than noise is allowed to move it (in a narrow corner a nearest point moves many
 * times as far as an edge).
 */
public final class RetriangulationProof implements Proof {
    private static final double MARGIN = 3e-5;
    private static final double MARGIN_WITHOUT_NOISE = 1e-6;
    private static final double MOST_AMPLIFIED = 2 * 5e-5;
    private static final double MOST_METRES = 5e-5;
    private static final double MOST_METRES_WITHOUT_NOISE = 1e-5;
    private static final double TILT_RADIANS = Math.toRadians(0.1);

    private double farthest;
    private double farthestWithoutNoise;
    private int shots;
    private int compared;
    private int comparedWithoutNoise;
    private int placed;

    @Override
    public Claim claim() {
        return new Claim(
                "retriangulations",
                "However a wall is cut into triangles, slivers among them, and with noise of 10 µm, a portal comes to"
                        + " within 50 µm of the same place, 10 µm without noise, or is refused for the same reason.",
                "triangulations",
                10_000,
                2_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        List<String> failures = new ArrayList<>();
        farthest = 0;
        farthestWithoutNoise = 0;
        shots = 0;
        compared = 0;
        comparedWithoutNoise = 0;
        placed = 0;
        for (long unit = from; unit < from + count; unit++) {
            cut(unit, new SplittableRandom(unit), failures);
            progress.unitsDone(unit + 1 - from);
        }
        return ProofResult.of(
                count,
                failures,
                Figure.sum("shots compared", compared, ""),
                Figure.sum("portals among them", placed, ""),
                Figure.sum("shots left out of these", shots - compared, ""),
                Figure.sum("shots compared without noise", comparedWithoutNoise, ""),
                Figure.sum("shots left out of these, without noise", shots - comparedWithoutNoise, ""),
                Figure.greatest("greatest share left out of a batch", 100.0 * (shots - compared) / shots, "%"),
                Figure.greatest("farthest from the same place", farthest, "m"),
                Figure.greatest("farthest without noise", farthestWithoutNoise, "m"));
    }

    private void cut(long unit, SplittableRandom random, List<String> failures) {
        CutWall wall = new CutWall(random);
        WallPlace straight = new WallPlace(
                new Vec3(random.nextDouble(-50, 50), random.nextDouble(-50, 50), random.nextDouble(-50, 50)),
                new Vec3(1, 0, 0),
                new Vec3(0, 1, 0),
                new Vec3(0, 0, 1));
        WallPlace tilted = tilted(
                straight,
                random.nextDouble(-TILT_RADIANS, TILT_RADIANS),
                random.nextDouble(-TILT_RADIANS, TILT_RADIANS));
        List<double[]> triangles = wall.cut(random);
        PlacementSurfaces before = wall.plain(straight);
        PlacementSurfaces clean = CutWall.surfaces(straight, triangles, null);
        PlacementSurfaces noisy = CutWall.surfaces(tilted, triangles, random);
        for (int i = 0; i < 5; i++) {
            double x = random.nextDouble(0, wall.wide());
            double y = random.nextDouble(0, wall.high());
            if (wall.holds(x, y)) {
                Shot shot = new Shot(x, y, random.nextDouble(-2, 2), random.nextDouble(-2, 2), random.nextInt(3));
                shots++;
                compareClean(unit, shot, straight, List.of(before, clean), failures);
                compareNoisy(unit, shot, List.of(straight, tilted), List.of(before, noisy), failures);
            }
        }
    }

    private static WallPlace tilted(WallPlace wall, double aroundX, double aroundY) {
        Vec3 normal = Directions.unit(Math.tan(aroundY), Math.tan(aroundX), 1);
        Vec3 right = new Vec3(0, 1, 0).cross(normal);
        Vec3 unit = Directions.unit(right);
        return new WallPlace(wall.origin(), unit, normal.cross(unit), normal);
    }

    private record Shot(double x, double y, double eyeX, double eyeY, int shape) {
        PlacementResult at(PlacementSurfaces surfaces, WallPlace place, double grownMetres) {
            Aperture aperture = Aperture.of(PortalShape.values()[shape], 1.2 + 2 * grownMetres, 2.1 + 2 * grownMetres);
            Vec3 eye = place.world(x + eyeX, y + eyeY, 4);
            Vec3 target = place.world(x, y, 0);
            Vec3 direction = Directions.unit(target.minus(eye));
            return new Placement(surfaces, new Gun(aperture, 100, 0.75))
                    .place("p", new ShotRay(eye, WallPlace.looking(direction, 0)), List.of(), Obstacles.NONE);
        }
    }

    private void compareClean(
            long unit, Shot shot, WallPlace place, List<PlacementSurfaces> surfaces, List<String> failures) {
        PlacementResult smaller = shot.at(surfaces.get(0), place, -MARGIN_WITHOUT_NOISE);
        PlacementResult larger = shot.at(surfaces.get(0), place, MARGIN_WITHOUT_NOISE);
        if (reason(smaller) != reason(larger)) {
            return;
        }
        comparedWithoutNoise++;
        PlacementResult expected = shot.at(surfaces.get(0), place, 0);
        PlacementResult clean = shot.at(surfaces.get(1), place, 0);
        double off = off(expected, place, clean, place);
        farthestWithoutNoise = Math.max(farthestWithoutNoise, off);
        if (!(off <= MOST_METRES_WITHOUT_NOISE)) {
            failures.add(failure(unit, shot, off, List.of(expected, clean)) + " without noise");
        }
    }

    private void compareNoisy(
            long unit, Shot shot, List<WallPlace> places, List<PlacementSurfaces> surfaces, List<String> failures) {
        WallPlace straight = places.get(0);
        PlacementResult smaller = shot.at(surfaces.get(0), straight, -MARGIN);
        PlacementResult larger = shot.at(surfaces.get(0), straight, MARGIN);
        if (!(off(smaller, straight, larger, straight) <= MOST_AMPLIFIED)) {
            return;
        }
        compared++;
        PlacementResult expected = shot.at(surfaces.get(0), straight, 0);
        PlacementResult noisy = shot.at(surfaces.get(1), places.get(1), 0);
        placed += expected instanceof PlacementResult.Fits ? 1 : 0;
        double off = off(expected, straight, noisy, places.get(1));
        farthest = Math.max(farthest, off);
        if (!(off <= MOST_METRES)) {
            failures.add(failure(unit, shot, off, List.of(expected, noisy)));
        }
    }

    private static String failure(long unit, Shot shot, double off, List<PlacementResult> answers) {
        return "triangulation " + unit + " at " + shot.x() + ", " + shot.y() + ": off by " + off + " m: "
                + reason(answers.get(0)) + " and " + reason(answers.get(1));
    }

    /** Returns the distance of two answers in metres; infinite for answers of different kinds. */
    private static double off(PlacementResult a, WallPlace placeOfA, PlacementResult b, WallPlace placeOfB) {
        if (reason(a) != reason(b)) {
            return Double.POSITIVE_INFINITY;
        } else if (reason(a) != null) {
            return 0;
        }
        Vec3 p = ((PlacementResult.Fits) a).portal().centre();
        Vec3 q = ((PlacementResult.Fits) b).portal().centre();
        double dx = placeOfA.x(p) - placeOfB.x(q);
        double dy = placeOfA.y(p) - placeOfB.y(q);
        return Math.sqrt(dx * dx + dy * dy);
    }

    private static Refusal reason(PlacementResult placed) {
        return placed instanceof PlacementResult.Refused refused ? refused.reason() : null;
    }

    /** A wall of rectangles with holes, which can be cut into triangles in any number of ways. */
    private static final class CutWall {
        private static final double NOISE_METRES = 1e-5;

        private final List<double[]> rectangles = new ArrayList<>();
        private final double[] xs;
        private final double[] ys;

        CutWall(SplittableRandom random) {
            xs = lines(random, 7);
            ys = lines(random, 6);
            for (int cell = 0; cell < 30; cell++) {
                int x = cell % 6;
                int y = cell / 6;
                if (random.nextInt(8) != 0 || rectangles.isEmpty()) {
                    rectangles.add(new double[] {xs[x], ys[y], xs[x + 1], ys[y + 1]});
                }
            }
        }

        private static double[] lines(SplittableRandom random, int count) {
            double[] lines = new double[count];
            double at = 0;
            for (int i = 0; i < count; i++) {
                lines[i] = at;
                at += random.nextDouble(0.4, 0.9);
            }
            return lines;
        }

        double wide() {
            return xs[xs.length - 1];
        }

        double high() {
            return ys[ys.length - 1];
        }

        boolean holds(double x, double y) {
            return rectangles.stream().anyMatch(r -> x > r[0] && x < r[2] && y > r[1] && y < r[3]);
        }

        /** Returns two triangles a rectangle. */
        PlacementSurfaces plain(WallPlace place) {
            List<double[]> triangles = new ArrayList<>();
            rectangles.forEach(r -> halve(r, triangles));
            return surfaces(place, triangles, null);
        }

        private static void halve(double[] r, List<double[]> triangles) {
            triangles.add(new double[] {r[0], r[1], r[2], r[1], r[2], r[3]});
            triangles.add(new double[] {r[0], r[1], r[2], r[3], r[0], r[3]});
        }

        /** Returns random triangles, with T-junctions and slivers. */
        List<double[]> cut(SplittableRandom random) {
            List<double[]> triangles = new ArrayList<>();
            rectangles.forEach(r -> halve(r, triangles));
            int cuts = random.nextInt(10, 60);
            for (int i = 0; i < cuts; i++) {
                double[] t = triangles.remove(random.nextInt(triangles.size()));
                int from = 2 * random.nextInt(3);
                double fraction =
                        random.nextInt(4) == 0 ? Math.exp(random.nextDouble(-11, -3)) : random.nextDouble(0.1, 0.9);
                int to = (from + 2) % 6;
                int opposite = (from + 4) % 6;
                double x = t[from] + fraction * (t[to] - t[from]);
                double y = t[from + 1] + fraction * (t[to + 1] - t[from + 1]);
                triangles.add(new double[] {t[from], t[from + 1], x, y, t[opposite], t[opposite + 1]});
                triangles.add(new double[] {x, y, t[to], t[to + 1], t[opposite], t[opposite + 1]});
            }
            return triangles;
        }

        /** @param noise moves each corner of each triangle independently; {@code null} for none */
        static PlacementSurfaces surfaces(WallPlace place, List<double[]> triangles, SplittableRandom noise) {
            List<SurfacePolygon> sheets = new ArrayList<>();
            for (double[] t : triangles) {
                List<Vec3> corners = new ArrayList<>();
                for (int i = 0; i < 6; i += 2) {
                    corners.add(place.world(t[i] + off(noise), t[i + 1] + off(noise), off(noise)));
                }
                sheets.add(SurfacePolygon.of(corners, true));
            }
            return PlacementSurfaces.of(List.of(), sheets);
        }

        private static double off(SplittableRandom noise) {
            return noise == null ? 0 : noise.nextDouble(-NOISE_METRES, NOISE_METRES);
        }
    }
}
