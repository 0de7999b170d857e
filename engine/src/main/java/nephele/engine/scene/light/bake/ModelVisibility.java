package nephele.engine.scene.light.bake;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * The sky visibility of models at their vertices. The hemisphere is that over the vertex's normal, so that a curved
 * surface is as smooth in the sky's light as in the sun's. If there are too many vertices, omitted ones get the value
 * of the one before. The result does not depend on the number of threads.
 */
final class ModelVisibility {
    /** The ray budget of all models; a vertex gets its share, at least {@link #LEAST_RAYS}, at most a texel's rays. */
    private static final int ALL_RAYS = 1 << 23;

    private static final int LEAST_RAYS = 16;

    /**
     * The height of the rays' origins above the surface: below the thickness of any object, above the depth of a
     * curve's triangles below the curve near a vertex.
     */
    private static final double LIFT_METRES = 1e-3;

    /**
     * The distance of the rays' origin from the vertex into one of its triangles: on the border it would be inside
     * adjacent objects.
     */
    private static final double INSET_METRES = 2e-3;

    private static final double LARGEST_INSET = 0.25;

    private final StaticShapes statics;
    private final Occluders occluders;
    private final Occluders.Sight sight;
    private final double[] spiral;
    private final int vertexStep;

    private ModelVisibility(
            StaticShapes statics, Occluders occluders, Occluders.Sight sight, int rays, int vertexStep) {
        this.statics = statics;
        this.occluders = occluders;
        this.sight = sight;
        this.vertexStep = vertexStep;
        spiral = SkyVisibilityBake.spiral(rays);
    }

    /** Uses the full share of rays, or fewer if the budget is limited. */
    private static ModelVisibility of(StaticShapes statics, boolean isRationed) {
        Occluders occluders = new Occluders(statics);
        int vertices = Math.max(statics.models().vertexCount(), 1);
        int rays = Math.min(Math.max(LEAST_RAYS, ALL_RAYS / vertices), SkyVisibilityBake.RAYS);
        int divisor = isRationed ? divisor(statics, occluders, rays) : 1;
        int left = Math.max(LEAST_RAYS, rays / divisor);
        int vertexStep = Math.max(1, divisor * left / rays);
        return new ModelVisibility(statics, occluders, occluders::isOccluded, left, vertexStep);
    }

    private static int divisor(StaticShapes statics, Occluders occluders, int rays) {
        List<PlacedModel> models = statics.models().all();
        int[] end = new int[models.size()];
        int triangles = 0;
        for (int i = 0; i < end.length; i++) {
            triangles += models.get(i).triangles().count();
            end[i] = triangles;
        }
        BakeBudget ration = new BakeBudget(occluders);
        ModelVisibility sample = new ModelVisibility(statics, occluders, ration, rays, 1);
        return ration.divisor(triangles, statics.models().vertexCount(), triangle -> {
            int found = Arrays.binarySearch(end, triangle + 1);
            int model = found < 0 ? -found - 1 : found;
            WorldTriangles mesh = models.get(model).triangles();
            sample.visibility(mesh, triangle - end[model] + mesh.count(), 0, occluders.itemOfModel(model));
        });
    }

    /** Returns a value, 0–65535 for 0–1, for every vertex of every model in order. */
    static short[] values(StaticShapes statics, boolean isRationed, DoubleConsumer progress) {
        ModelVisibility bake = ModelVisibility.of(statics, isRationed);
        int count = statics.models().all().size();
        short[][] byModel = new short[count][];
        AtomicInteger done = new AtomicInteger();
        IntStream.range(0, count).parallel().forEach(i -> {
            byModel[i] = bake.model(statics.models().all().get(i), bake.occluders.itemOfModel(i));
            progress.accept((double) done.incrementAndGet() / count);
        });
        short[] all = new short
                [Arrays.stream(byModel).mapToInt(values -> values.length).sum()];
        int at = 0;
        for (short[] values : byModel) {
            System.arraycopy(values, 0, all, at, values.length);
            at += values.length;
        }
        return all;
    }

    private short[] model(PlacedModel model, int item) {
        WorldTriangles mesh = model.triangles();
        double[] visible = new double[mesh.positions().length / 3];
        boolean[] known = new boolean[visible.length];
        int met = 0;
        double last = 0;
        for (int i = 0; i < 3 * mesh.count(); i++) {
            int vertex = mesh.vertices()[i];
            if (!known[vertex]) {
                known[vertex] = true;
                last = met++ % vertexStep == 0 ? visibility(mesh, i / 3, i % 3, item) : last;
                visible[vertex] = last;
            }
        }
        fillFromNeighbours(mesh, visible);
        short[] values = new short[visible.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = (short) Math.round(visible[i] * 65535);
        }
        return values;
    }

    /** Returns the visible fraction, NaN inside a solid. */
    private double visibility(WorldTriangles mesh, int triangle, int corner, int item) {
        Vec3 n = mesh.normal(triangle, corner);
        double[] origin = inside(mesh, triangle, corner);
        origin[0] += LIFT_METRES * n.x();
        origin[1] += LIFT_METRES * n.y();
        origin[2] += LIFT_METRES * n.z();
        if (occluders.isInside(origin, item)) {
            return Double.NaN;
        }
        Vec3 s = Directions.perpendicular(n);
        Vec3 t = n.cross(s);
        double[] d = new double[3];
        int free = 0;
        for (int i = 0; i < spiral.length; i += 3) {
            d[0] = spiral[i] * s.x() + spiral[i + 1] * t.x() + spiral[i + 2] * n.x();
            d[1] = spiral[i] * s.y() + spiral[i + 1] * t.y() + spiral[i + 2] * n.y();
            d[2] = spiral[i] * s.z() + spiral[i + 1] * t.z() + spiral[i + 2] * n.z();
            free += sight.isOccluded(origin, d, item) ? 0 : 1;
        }
        return 3.0 * free / spiral.length;
    }

    private static double[] inside(WorldTriangles mesh, int triangle, int corner) {
        Vec3 p = mesh.corner(triangle, corner);
        Vec3 a = mesh.corner(triangle, (corner + 1) % 3);
        Vec3 b = mesh.corner(triangle, (corner + 2) % 3);
        Vec3 inward = new Vec3((a.x() + b.x()) / 2 - p.x(), (a.y() + b.y()) / 2 - p.y(), (a.z() + b.z()) / 2 - p.z());
        double fraction = Math.min(LARGEST_INSET, INSET_METRES / inward.length());
        return new double[] {p.x() + fraction * inward.x(), p.y() + fraction * inward.y(), p.z() + fraction * inward.z()
        };
    }

    /**
     * Gives a vertex inside a solid the mean of the other vertices of its triangles: it is hidden, but light is
     * interpolated towards it.
     */
    private static void fillFromNeighbours(WorldTriangles mesh, double[] visible) {
        double[] sums = new double[visible.length];
        int[] counts = new int[visible.length];
        for (int i = 0; i < mesh.vertices().length; i++) {
            for (int other = 1; other < 3; other++) {
                double value = visible[mesh.vertices()[i - i % 3 + (i + other) % 3]];
                sums[mesh.vertices()[i]] += Double.isNaN(value) ? 0 : value;
                counts[mesh.vertices()[i]] += Double.isNaN(value) ? 0 : 1;
            }
        }
        for (int i = 0; i < visible.length; i++) {
            if (Double.isNaN(visible[i])) {
                visible[i] = counts[i] == 0 ? 0 : sums[i] / counts[i];
            }
        }
    }
}
