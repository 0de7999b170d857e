package nephele.engine.bake;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.reference.GatherRays;
import nephele.engine.scene.light.TerrainSky;
import nephele.engine.scene.light.bake.LightMapChart;
import nephele.engine.scene.light.bake.LightMapLayout;
import nephele.engine.scene.light.bake.Occluders;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The points at which light is baked, numbered: the texels of all charts, then the vertices of all models, then the
 * points of all terrains. A texel is a mean under the tent of its bilinear interpolation, where the tent leaves the chart
 * also on the chart that goes on in the same plane, so that no seam shows; a vertex and a point of a terrain are single
 * places.
 */
final class Receivers {
    /** Most corners of an interpolation. */
    static final int CORNERS = 4;

    /** The places of a texel, along each of its sides. */
    private static final int SIDE = 4;

    /** The height at which a place of a texel is in what stands on its face, but not in what ends in the same plane. */
    static final double ABOVE_METRES = 1e-5;

    /** The height of the places of vertices and terrains: below the thickness of any object, above a curve's sagitta. */
    private static final double LIFT_METRES = 1e-3;

    /** The distance of a vertex's place from the vertex: on the border it would be inside adjacent objects. */
    private static final double INSET_METRES = 2e-3;

    private static final double LARGEST_INSET = 0.25;

    /** The middles of parts of equal weight under a tent of the width of two texels. */
    private static final double[] TENT = {-0.5, -0.1339746, 0.1339746, 0.5};

    private final LightMapLayout layout;
    private final StaticShapes statics;
    private final Occluders occluders;
    private final CoplanarCharts coplanar;
    private final int[] firstOfChart;
    private final int[] firstOfModel;
    private final int[] firstOfGround;
    /** A corner of a triangle at each vertex, as triangle × 3 + corner; −1 if it is in none. */
    private final int[][] cornerAt;

    private final int count;
    /** The receiver whose light each receiver has: itself unless it is inside something. */
    private final int[] standIn;

    /**
     * Numbers the receivers.
     *
     * @param statics the static geometry, models split
     */
    Receivers(LightMapLayout layout, StaticShapes statics) {
        this.layout = layout;
        this.statics = statics;
        occluders = new Occluders(statics);
        coplanar = new CoplanarCharts(layout, occluders);
        int next = 0;
        firstOfChart = new int[layout.charts().size()];
        for (int i = 0; i < firstOfChart.length; i++) {
            firstOfChart[i] = next;
            LightMapChart chart = layout.charts().get(i);
            next += chart.columns() * chart.rows();
        }
        List<PlacedModel> models = statics.models().all();
        firstOfModel = new int[models.size() + 1];
        cornerAt = new int[models.size()][];
        for (int i = 0; i < cornerAt.length; i++) {
            firstOfModel[i] = next;
            cornerAt[i] = corners(models.get(i).triangles());
            next += cornerAt[i].length;
        }
        firstOfModel[cornerAt.length] = next;
        firstOfGround = new int[statics.ground().size()];
        for (int i = 0; i < firstOfGround.length; i++) {
            firstOfGround[i] = next;
            HeightField field = statics.ground().get(i).field();
            next += TerrainSky.points(field.cellColumns()) * TerrainSky.points(field.cellRows());
        }
        count = next;
        standIn = IntStream.range(0, count).toArray();
    }

    private static int[] corners(WorldTriangles mesh) {
        int[] corners = new int[mesh.positions().length / 3];
        Arrays.fill(corners, -1);
        for (int i = 3 * mesh.count() - 1; i >= 0; i--) {
            corners[mesh.vertices()[i]] = i;
        }
        return corners;
    }

    int count() {
        return count;
    }

    /** Gives each receiver that is not free the light of the nearest free one on the same chart, model or terrain. */
    void standIn(boolean[] isFree) {
        for (int i = 0; i < firstOfChart.length; i++) {
            LightMapChart chart = layout.charts().get(i);
            spread(isFree, firstOfChart[i], chart.columns(), chart.rows());
        }
        for (int i = 0; i < cornerAt.length; i++) {
            spread(isFree, firstOfModel[i], statics.models().all().get(i).triangles());
        }
        for (int i = 0; i < firstOfGround.length; i++) {
            HeightField field = statics.ground().get(i).field();
            int columns = TerrainSky.points(field.cellColumns());
            spread(isFree, firstOfGround[i], columns, TerrainSky.points(field.cellRows()));
        }
    }

    private void spread(boolean[] isFree, int first, int columns, int rows) {
        int[] queue = new int[columns * rows];
        boolean[] isKnown = new boolean[queue.length];
        int end = 0;
        for (int i = 0; i < queue.length; i++) {
            isKnown[i] = isFree[first + i];
            if (isKnown[i]) {
                queue[end++] = i;
            }
        }
        for (int begin = 0; begin < end && end < queue.length; begin++) {
            int column = queue[begin] % columns;
            int row = queue[begin] / columns;
            for (int y = Math.max(0, row - 1); y <= Math.min(row + 1, rows - 1); y++) {
                for (int x = Math.max(0, column - 1); x <= Math.min(column + 1, columns - 1); x++) {
                    int at = y * columns + x;
                    if (!isKnown[at]) {
                        isKnown[at] = true;
                        standIn[first + at] = standIn[first + queue[begin]];
                        queue[end++] = at;
                    }
                }
            }
        }
    }

    private void spread(boolean[] isFree, int first, WorldTriangles mesh) {
        boolean isChanged = true;
        boolean[] isKnown = Arrays.copyOfRange(isFree, first, first + mesh.positions().length / 3);
        while (isChanged) {
            isChanged = false;
            for (int i = 0; i < mesh.vertices().length; i++) {
                int vertex = mesh.vertices()[i];
                int other = mesh.vertices()[i - i % 3 + (i + 1) % 3];
                if (!isKnown[vertex] && isKnown[other]) {
                    standIn[first + vertex] = standIn[first + other];
                    isKnown[vertex] = true;
                    isChanged = true;
                }
            }
        }
    }

    /**
     * Returns values in which each texel at the edge of a chart is the mean of itself and of what charts that go on there
     * have beside it.
     *
     * @param stride values of a receiver
     */
    float[] joined(float[] values, int stride) {
        float[] joined = values.clone();
        IntStream.range(0, firstOfChart.length).parallel().forEach(index -> {
            int[] corners = new int[CORNERS];
            double[] weights = new double[CORNERS];
            int[] counts = new int
                    [layout.charts().get(index).columns()
                            * layout.charts().get(index).rows()];
            coplanar.forEdges(index, (at, other, column, row) -> {
                LightMapChart there = layout.charts().get(other);
                bilinear(column, row, there.columns(), there.rows(), firstOfChart[other], corners, weights);
                int to = stride * (firstOfChart[index] + at);
                counts[at]++;
                for (int value = 0; value < stride; value++) {
                    double beside = 0;
                    for (int i = 0; i < CORNERS; i++) {
                        beside += weights[i] * values[stride * standIn[corners[i]] + value];
                    }
                    joined[to + value] += (float) ((beside - joined[to + value]) / (counts[at] + 1));
                }
            });
        });
        return joined;
    }

    /** Returns the receiver whose light a receiver has. */
    int standsFor(int receiver) {
        return standIn[receiver];
    }

    LightMapLayout layout() {
        return layout;
    }

    StaticShapes statics() {
        return statics;
    }

    int texels() {
        return firstOfModel[0];
    }

    int firstOfChart(int chart) {
        return firstOfChart[chart];
    }

    int vertices() {
        return firstOfModel[firstOfModel.length - 1] - firstOfModel[0];
    }

    int firstOfGround(int terrain) {
        return firstOfGround[terrain];
    }

    /** The free places of one receiver and the normal of its surface; none of them is inside a solid. */
    record Spot(List<Vec3> places, Vector3d normal) {}

    /** Returns where a receiver is on its surface. */
    Vec3 place(int receiver) {
        if (receiver < texels()) {
            int index = before(firstOfChart, receiver);
            LightMapChart chart = layout.charts().get(index);
            int at = receiver - firstOfChart[index];
            return Vec3.of(chart.inside(at % chart.columns(), at / chart.columns()));
        }
        if (receiver < texels() + vertices()) {
            int index = before(firstOfModel, receiver);
            double[] positions = statics.models().all().get(index).triangles().positions();
            int at = 3 * (receiver - firstOfModel[index]);
            return new Vec3(positions[at], positions[at + 1], positions[at + 2]);
        }
        int terrain = before(firstOfGround, receiver);
        HeightField field = statics.ground().get(terrain).field();
        int columns = TerrainSky.points(field.cellColumns());
        int rows = TerrainSky.points(field.cellRows());
        int point = receiver - firstOfGround[terrain];
        double x = field.x(0) + field.cellX() * field.cellColumns() * (point % columns) / (columns - 1);
        double z = field.z(0) + field.cellZ() * field.cellRows() * (point / columns) / (rows - 1);
        return new Vec3(x, HeightFieldSurface.y(field, x, z), z);
    }

    /** Returns the places from which a receiver's rays leave; none if it is inside something. */
    Spot spot(int receiver) {
        if (receiver < texels()) {
            return spotOfTexel(receiver);
        }
        if (receiver < texels() + vertices()) {
            return spotOfVertex(receiver);
        }
        Vec3 ground = place(receiver);
        HeightField field =
                statics.ground().get(before(firstOfGround, receiver)).field();
        Vec3 normal = HeightFieldSurface.normal(field, ground.x(), ground.z());
        return new Spot(free(ground.addScaled(LIFT_METRES, normal), -1), normal.toVector());
    }

    private Spot spotOfTexel(int receiver) {
        int index = before(firstOfChart, receiver);
        LightMapChart chart = layout.charts().get(index);
        int at = receiver - firstOfChart[index];
        Vec3 normal = Vec3.of(chart.normal());
        List<Vec3> places = new ArrayList<>();
        for (int i = 0; i < SIDE * SIDE; i++) {
            double column = at % chart.columns() + TENT[i % SIDE];
            double row = at / chart.columns() + TENT[i / SIDE];
            double insideColumn = mirrored(column, chart.columns() - 1);
            double insideRow = mirrored(row, chart.rows() - 1);
            Vec3 inside = Vec3.of(chart.inside(insideColumn, insideRow));
            boolean isOutside = column != insideColumn || row != insideRow;
            Vec3 beyond = isOutside ? coplanar.beyond(index, inside, Vec3.of(chart.pointAt(column, row))) : null;
            if (beyond != null || isFree(inside.addScaled(ABOVE_METRES, normal), layout.brushOf()[index])) {
                places.add(beyond == null ? inside : beyond);
            }
        }
        return new Spot(places, chart.normal());
    }

    private static double mirrored(double at, double most) {
        double positive = Math.abs(at);
        return positive > most ? 2 * most - positive : positive;
    }

    private Spot spotOfVertex(int receiver) {
        int index = before(firstOfModel, receiver);
        PlacedModel model = statics.models().all().get(index);
        int corner = cornerAt[index][receiver - firstOfModel[index]];
        if (corner < 0) {
            return new Spot(List.of(), new Vector3d(0, 1, 0));
        }
        WorldTriangles mesh = model.triangles();
        Vec3 p = mesh.corner(corner / 3, corner % 3);
        Vec3 a = mesh.corner(corner / 3, (corner + 1) % 3);
        Vec3 b = mesh.corner(corner / 3, (corner + 2) % 3);
        Vec3 inward = a.plus(b).scaled(0.5).minus(p);
        double length = inward.toVector().length();
        Vec3 normal = mesh.normal(corner / 3, corner % 3);
        Vec3 place = p.addScaled(Math.min(LARGEST_INSET, INSET_METRES / length), inward)
                .addScaled(LIFT_METRES, normal);
        return new Spot(free(place, occluders.itemOfModel(index)), normal.toVector());
    }

    private List<Vec3> free(Vec3 place, int except) {
        return isFree(place, except) ? List.of(place) : List.of();
    }

    private boolean isFree(Vec3 place, int except) {
        return !occluders.isInside(new double[] {place.x(), place.y(), place.z()}, except);
    }

    private static int before(int[] firsts, int receiver) {
        int found = Arrays.binarySearch(firsts, receiver);
        int at = found < 0 ? -found - 2 : found;
        while (at + 1 < firsts.length && firsts[at + 1] == firsts[at]) {
            at++;
        }
        return at;
    }

    /**
     * Finds the receivers between which the light at a ray's end is interpolated.
     *
     * @param corners receives {@link #CORNERS} receivers
     * @param weights receives theirs, which add up to 1
     */
    void around(GatherRays.End end, GatherRays ray, int[] corners, double[] weights) {
        switch (end) {
            case SOLID -> aroundTexel(ray, corners, weights);
            case MODEL -> aroundVertices(ray, corners, weights);
            case GROUND -> aroundGround(ray, corners, weights);
            default -> throw new IllegalArgumentException("no light is baked on " + end);
        }
        for (int i = 0; i < CORNERS; i++) {
            corners[i] = standIn[corners[i]];
        }
    }

    private void aroundTexel(GatherRays ray, int[] corners, double[] weights) {
        int index = chart(ray.index(), ray.part(), ray.place());
        if (index < 0) {
            Arrays.fill(weights, 0);
            Arrays.fill(corners, 0);
            return;
        }
        LightMapChart chart = layout.charts().get(index);
        bilinear(
                chart.columnOf(ray.place()),
                chart.rowOf(ray.place()),
                chart.columns(),
                chart.rows(),
                firstOfChart[index],
                corners,
                weights);
    }

    /** Returns the chart on a face that holds a place, or is nearest to it; −1 if the whole face is covered. */
    private int chart(int solid, int face, Vec3 place) {
        int[] parts = layout.chartOf().get(solid).get(face);
        int nearest = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int chart : parts) {
            if (chart >= 0) {
                double distance =
                        parts.length == 1 ? 0 : layout.charts().get(chart).metresOutside(place);
                if (distance < least) {
                    least = distance;
                    nearest = chart;
                }
                if (distance <= 0) {
                    return chart;
                }
            }
        }
        return nearest;
    }

    private static void bilinear(
            double column, double row, int columns, int rows, int first, int[] corners, double[] weights) {
        int x = Math.max(0, Math.min((int) column, columns - 2));
        int y = Math.max(0, Math.min((int) row, rows - 2));
        double fx = Math.max(0, Math.min(column - x, 1));
        double fy = Math.max(0, Math.min(row - y, 1));
        for (int i = 0; i < CORNERS; i++) {
            corners[i] = first + (y + (i >> 1)) * columns + x + (i & 1);
            weights[i] = ((i & 1) == 0 ? 1 - fx : fx) * (i >> 1 == 0 ? 1 - fy : fy);
        }
    }

    private void aroundVertices(GatherRays ray, int[] corners, double[] weights) {
        WorldTriangles mesh = statics.models().all().get(ray.index()).triangles();
        int triangle = ray.part();
        Vec3 a = mesh.corner(triangle, 0);
        Vector3d ab = mesh.corner(triangle, 1).minus(a).toVector();
        Vector3d ac = mesh.corner(triangle, 2).minus(a).toVector();
        Vector3d ap = ray.place().minus(a).toVector();
        Vector3dc n = ab.cross(ac, new Vector3d());
        double area = n.lengthSquared();
        double second = ap.cross(ac, new Vector3d()).dot(n) / area;
        double third = ab.cross(ap, new Vector3d()).dot(n) / area;
        weights[1] = Math.max(0, Math.min(second, 1));
        weights[2] = Math.max(0, Math.min(third, 1 - weights[1]));
        weights[0] = 1 - weights[1] - weights[2];
        weights[3] = 0;
        for (int i = 0; i < CORNERS; i++) {
            corners[i] = firstOfModel[ray.index()] + mesh.vertices()[3 * triangle + i % 3];
        }
    }

    private void aroundGround(GatherRays ray, int[] corners, double[] weights) {
        HeightField field = statics.ground().get(ray.index()).field();
        int columns = TerrainSky.points(field.cellColumns());
        int rows = TerrainSky.points(field.cellRows());
        double column = (ray.place().x() - field.x(0)) / (field.cellX() * field.cellColumns()) * (columns - 1);
        double row = (ray.place().z() - field.z(0)) / (field.cellZ() * field.cellRows()) * (rows - 1);
        bilinear(column, row, columns, rows, firstOfGround[ray.index()], corners, weights);
    }
}
