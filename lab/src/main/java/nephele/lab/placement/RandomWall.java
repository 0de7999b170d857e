package nephele.lab.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.Brush;
import nephele.engine.math.TriangleSoup;
import nephele.engine.math.Vec3;
import nephele.engine.portal.placement.PlacementSurfaces;
import nephele.engine.portal.placement.SurfacePolygon;

/**
 * A random surface: a mesh of triangles with holes, or adjoining and overlapping boxes, some of which do not admit
 * portals. Columns may stand on it.
 *
 * @param faces that admit portals; they may overlap
 * @param pieces the area on which portals are allowed, disjoint
 * @param columns footprints of the columns
 * @param soup triangles of the mesh, {@code null} for boxes
 */
public record RandomWall(
        WallPlace place,
        PlacementSurfaces surfaces,
        List<double[]> faces,
        List<double[]> pieces,
        List<double[]> columns,
        TriangleSoup soup) {
    /** Returns a mesh or boxes, with at least one piece that admits portals. */
    public static RandomWall of(SplittableRandom random) {
        RandomWall wall;
        do {
            WallPlace place = WallPlace.random(random);
            wall = random.nextBoolean() ? mesh(place, random) : boxes(place, random);
        } while (wall.pieces().isEmpty());
        return wall;
    }

    private static RandomWall mesh(WallPlace place, SplittableRandom random) {
        int wide = random.nextInt(1, 6);
        int high = random.nextInt(1, 6);
        double[] xs = lines(wide + 1, random.nextDouble(1, 6));
        double[] ys = lines(high + 1, random.nextDouble(1, 5));
        double[] grid = new double[2 * (wide + 1) * (high + 1)];
        for (int i = 0; i < grid.length / 2; i++) {
            int column = i % (wide + 1);
            int row = i / (wide + 1);
            grid[2 * i] = xs[column] + inner(column, wide) * random.nextDouble(-0.22, 0.22) * xs[wide] / wide;
            grid[2 * i + 1] = ys[row] + inner(row, high) * random.nextDouble(-0.22, 0.22) * ys[high] / high;
        }
        double holes = random.nextInt(3) * 0.1;
        List<int[]> triangles = new ArrayList<>();
        for (int cell = 0; cell < wide * high; cell++) {
            int low = cell / wide * (wide + 1) + cell % wide;
            int[] c = {low, low + 1, low + wide + 2, low + wide + 1};
            int turn = random.nextInt(2);
            add(triangles, grid, new int[] {c[turn], c[turn + 1], c[turn + 2]}, random.nextDouble() >= holes);
            add(triangles, grid, new int[] {c[turn], c[turn + 2], c[(turn + 3) % 4]}, random.nextDouble() >= holes);
        }
        return ofTriangles(place, grid, triangles, random);
    }

    private static int inner(int line, int last) {
        return line == 0 || line == last ? 0 : 1;
    }

    private static double[] lines(int count, double length) {
        double[] lines = new double[count];
        for (int i = 0; i < count; i++) {
            lines[i] = length * i / (count - 1);
        }
        return lines;
    }

    private static void add(List<int[]> triangles, double[] grid, int[] triangle, boolean there) {
        if (there && area(corners(grid, triangle)) > 1e-3) {
            triangles.add(triangle);
        }
    }

    private static double[] corners(double[] grid, int[] triangle) {
        double[] corners = new double[6];
        for (int i = 0; i < 3; i++) {
            corners[2 * i] = grid[2 * triangle[i]];
            corners[2 * i + 1] = grid[2 * triangle[i] + 1];
        }
        return corners;
    }

    private static double area(double[] c) {
        return ((c[2] - c[0]) * (c[5] - c[1]) - (c[4] - c[0]) * (c[3] - c[1])) / 2;
    }

    private static RandomWall ofTriangles(
            WallPlace place, double[] grid, List<int[]> triangles, SplittableRandom random) {
        double[] positions = new double[grid.length / 2 * 3];
        for (int i = 0; i < grid.length / 2; i++) {
            Vec3 p = place.world(grid[2 * i], grid[2 * i + 1], 0);
            positions[3 * i] = p.x();
            positions[3 * i + 1] = p.y();
            positions[3 * i + 2] = p.z();
        }
        TriangleSoup soup = new TriangleSoup(
                positions,
                triangles.stream().flatMapToInt(java.util.Arrays::stream).toArray());
        List<double[]> pieces =
                triangles.stream().map(triangle -> corners(grid, triangle)).toList();
        List<double[]> columns = columns(random);
        List<Brush> solids = new ArrayList<>();
        columns.forEach(column -> solids.add(place.prism(column, 0, 1, false)));
        return new RandomWall(
                place, PlacementSurfaces.of(solids, SurfacePolygon.of(soup, true)), pieces, pieces, columns, soup);
    }

    /** Returns boxes with rectangular faces between shared lines, so that they adjoin and overlap. */
    private static RandomWall boxes(WallPlace place, SplittableRandom random) {
        double[] xs = sorted(random, 6);
        double[] ys = sorted(random, 5);
        boolean[] allowed = new boolean[25];
        boolean[] barred = new boolean[25];
        List<Brush> solids = new ArrayList<>();
        List<double[]> faces = new ArrayList<>();
        int boxes = random.nextInt(1, 8);
        for (int i = 0; i < boxes; i++) {
            int x0 = random.nextInt(4);
            int y0 = random.nextInt(3);
            int x1 = random.nextInt(x0 + 1, 6);
            int y1 = random.nextInt(y0 + 1, 5);
            boolean portalable = i == 0 || random.nextInt(4) != 0;
            double[] face = rectangle(xs[x0], ys[y0], xs[x1], ys[y1]);
            solids.add(place.prism(face, -1, 0, portalable));
            if (portalable) {
                faces.add(face);
            }
            for (int cell = 0; cell < 20; cell++) {
                boolean in = cell % 5 >= x0 && cell % 5 < x1 && cell / 5 >= y0 && cell / 5 < y1;
                allowed[cell] |= in && portalable;
                barred[cell] |= in && !portalable;
            }
        }
        List<double[]> pieces = new ArrayList<>();
        for (int cell = 0; cell < 20; cell++) {
            if (allowed[cell] && !barred[cell]) {
                int x = cell % 5;
                int y = cell / 5;
                pieces.add(rectangle(xs[x], ys[y], xs[x + 1], ys[y + 1]));
            }
        }
        List<double[]> columns = columns(random);
        columns.forEach(column -> solids.add(place.prism(column, -0.2, 1, false)));
        return new RandomWall(place, PlacementSurfaces.of(solids, List.of()), faces, pieces, columns, null);
    }

    private static double[] sorted(SplittableRandom random, int count) {
        double[] lines = new double[count];
        double at = random.nextDouble(-3, 0);
        for (int i = 0; i < count; i++) {
            at += random.nextDouble(0.1, 1.6);
            lines[i] = at;
        }
        return lines;
    }

    private static double[] rectangle(double x0, double y0, double x1, double y1) {
        return new double[] {x0, y0, x1, y0, x1, y1, x0, y1};
    }

    /** Returns the footprints of boxes, some of them rotated. */
    private static List<double[]> columns(SplittableRandom random) {
        List<double[]> columns = new ArrayList<>();
        for (int i = random.nextInt(4); i > 1; i--) {
            double x = random.nextDouble(-1, 5);
            double y = random.nextDouble(-1, 5);
            double angle = random.nextInt(2) == 0 ? 0 : random.nextDouble(1.5);
            double a = random.nextDouble(0.05, 0.5);
            double b = random.nextDouble(0.05, 0.5);
            double cos = Math.cos(angle);
            double sin = Math.sin(angle);
            double[] column = rectangle(-a, -b, a, b);
            for (int k = 0; k < 8; k += 2) {
                double u = column[k];
                double v = column[k + 1];
                column[k] = x + u * cos - v * sin;
                column[k + 1] = y + u * sin + v * cos;
            }
            columns.add(column);
        }
        return columns;
    }

    /** Returns the pieces of the faces that are connected with a point through faces. */
    List<double[]> connected(double x, double y) {
        List<double[]> reached = new ArrayList<>();
        List<double[]> left = new ArrayList<>(faces);
        left.removeIf(face -> ClippedAreas.contains(face, x, y) && reached.add(face));
        boolean grows = true;
        while (grows) {
            List<double[]> edge = List.copyOf(reached);
            grows = left.removeIf(face -> edge.stream().anyMatch(other -> touch(face, other)) && reached.add(face));
        }
        return pieces.stream()
                .filter(piece -> reached.stream().anyMatch(face -> holdsMiddle(face, piece)))
                .toList();
    }

    private static boolean touch(double[] a, double[] b) {
        for (int i = 0; i < a.length; i += 2) {
            if (ClippedAreas.contains(b, a[i], a[i + 1])) {
                return true;
            }
        }
        for (int i = 0; i < b.length; i += 2) {
            if (ClippedAreas.contains(a, b[i], b[i + 1])) {
                return true;
            }
        }
        return ClippedAreas.overlap(a, b) > 0;
    }

    private static boolean holdsMiddle(double[] face, double[] piece) {
        double x = (piece[0] + piece[2] + piece[4]) / 3;
        double y = (piece[1] + piece[3] + piece[5]) / 3;
        return ClippedAreas.contains(face, x, y);
    }
}
