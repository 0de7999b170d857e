package nephele.engine.scene.impostor;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.stream.IntStream;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.RayTriangleIntersection;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.SpatialIndex;

/**
 * The share of the sky that the parts of a kind see past each other, on level ground.
 *
 * @param ofCorner 0 to 1, for each corner of each triangle
 * @param fit of a + b y + c y² + d (x² + z²), in radii from the kind's centre: what impostors have
 */
public record KindSky(float[] ofCorner, float[] fit) {
    private static final int RAYS = 16;
    private static final double LIFT = 2e-3;
    private static final int FIT_TEXELS = 16;

    public static KindSky of(KindShape shape) {
        WorldTriangles mesh = shape.triangles();
        double[] corners = mesh.corners();
        SpatialIndex index = SpatialIndex.of(shape.boxes());
        int[] vertices = mesh.vertices();
        // The first corner of each vertex stands for all of them.
        int[] firstOf = new int[mesh.positions().length / 3];
        Arrays.fill(firstOf, -1);
        for (int i = vertices.length - 1; i >= 0; i--) {
            firstOf[vertices[i]] = i;
        }
        float[] ofVertex = new float[firstOf.length];
        IntStream.range(0, firstOf.length)
                .parallel()
                .filter(v -> firstOf[v] >= 0)
                .forEach(v -> {
                    int triangle = firstOf[v] / 3;
                    Vec3 n = mesh.normal(triangle, firstOf[v] % 3);
                    Vec3 middle = mesh.corner(triangle, 0)
                            .plus(mesh.corner(triangle, 1))
                            .plus(mesh.corner(triangle, 2))
                            .scaled(1.0 / 3);
                    Vec3 from = mesh.corner(triangle, firstOf[v] % 3)
                            .scaled(0.9)
                            .addScaled(0.1, middle)
                            .addScaled(LIFT * shape.radius(), n);
                    ofVertex[v] = seen(from, n, index, corners);
                });
        float[] ofCorner = new float[vertices.length];
        for (int i = 0; i < vertices.length; i++) {
            ofCorner[i] = ofVertex[vertices[i]];
        }
        return new KindSky(ofCorner, fit(shape, ofCorner));
    }

    /** Returns for each triangle how many samples of all views show it: what is hidden must not darken an impostor. */
    private static long[] shown(KindShape shape) {
        AtomicLongArray shown = new AtomicLongArray(shape.triangles().count());
        IntStream.range(0, ImpostorAtlas.SIDE * ImpostorAtlas.SIDE).parallel().forEach(view -> new ViewRaster(
                        shape, AtlasView.at(view % ImpostorAtlas.SIDE, view / ImpostorAtlas.SIDE, shape), FIT_TEXELS)
                .countInto(shown));
        return IntStream.range(0, shown.length()).mapToLong(shown::get).toArray();
    }

    private static float seen(Vec3 from, Vec3 n, SpatialIndex index, double[] corners) {
        Vec3 s = Directions.perpendicular(n);
        Vec3 t = n.cross(s);
        int open = 0;
        for (int i = 0; i < RAYS; i++) {
            double flat = Math.sqrt((i + 0.5) / RAYS);
            double angle = i * Math.PI * (3 - Math.sqrt(5));
            Vec3 d = n.scaled(Math.sqrt(1 - flat * flat))
                    .addScaled(flat * Math.cos(angle), s)
                    .addScaled(flat * Math.sin(angle), t);
            boolean isOpen = d.y() > 0
                    && !index.anyHit(
                            new Ray(from.x(), from.y(), from.z(), d.x(), d.y(), d.z()),
                            Double.MAX_VALUE,
                            (ray, triangle, limit) -> {
                                double at = RayTriangleIntersection.hitParameter(ray, corners, 9 * triangle);
                                return at >= 0 ? at : Double.POSITIVE_INFINITY;
                            });
            open += isOpen ? 1 : 0;
        }
        return (float) open / RAYS;
    }

    /** Returns the least squares of four functions. */
    private static float[] fit(KindShape shape, float[] ofCorner) {
        double[][] sums = new double[4][5];
        long[] shown = shown(shape);
        for (int i = 0; i < ofCorner.length; i++) {
            Vec3 p =
                    shape.triangles().corner(i / 3, i % 3).minus(shape.centre()).scaled(1 / shape.radius());
            double[] f = {1, p.y(), p.y() * p.y(), p.x() * p.x() + p.z() * p.z(), ofCorner[i]};
            for (int row = 0; row < 4; row++) {
                for (int column = 0; column < 5; column++) {
                    sums[row][column] += shown[i / 3] * f[row] * f[column];
                }
            }
        }
        return solved(sums, ofCorner.length);
    }

    /** Eliminates with a ridge, so that flat kinds have a solution too. */
    private static float[] solved(double[][] sums, int count) {
        for (int i = 0; i < 4; i++) {
            sums[i][i] += 1e-6 * Math.max(1, count);
        }
        for (int pivot = 0; pivot < 4; pivot++) {
            for (int row = 0; row < 4; row++) {
                double factor = row == pivot ? 0 : sums[row][pivot] / sums[pivot][pivot];
                for (int column = pivot; column < 5; column++) {
                    sums[row][column] -= factor * sums[pivot][column];
                }
            }
        }
        float[] fit = new float[4];
        for (int i = 0; i < 4; i++) {
            fit[i] = (float) (sums[i][4] / sums[i][i]);
        }
        return fit;
    }
}
