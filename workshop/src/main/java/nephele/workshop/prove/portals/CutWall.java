package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Vec3;
import nephele.engine.portal.placement.PlacementSurfaces;
import nephele.engine.portal.placement.SurfacePolygon;
import nephele.lab.placement.WallPlace;

/** A wall of rectangles with holes, which can be cut into triangles in any number of ways. */
final class CutWall {
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
