package nephele.engine.bake;

import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.LightMapChart;
import nephele.engine.scene.light.bake.LightMapLayout;
import nephele.engine.scene.light.bake.Occluders;

/** The charts that go on where another one in the same plane ends, with nothing between. */
final class CoplanarCharts {
    private static final double COPLANAR = 1e-6;

    /** A place at the edge of a chart is no farther outside of the chart that goes on there. */
    private static final double EDGE_METRES = 3e-3;

    /** The height over the plane at which nothing may be between two places on it. */
    private static final double LIFT_METRES = 1e-3;

    private final LightMapLayout layout;
    private final Occluders occluders;
    /** The charts in the plane of each chart whose bounds meet the reach of its texels. */
    private final int[][] near;

    CoplanarCharts(LightMapLayout layout, Occluders occluders) {
        this.layout = layout;
        this.occluders = occluders;
        int count = layout.charts().size();
        near = new int[count][0];
        double[] distances = new double[count];
        Vec3[] centres = new Vec3[count];
        double[] radii = new double[count];
        for (int i = 0; i < count; i++) {
            LightMapChart chart = layout.charts().get(i);
            distances[i] = Vec3.of(chart.normal()).dot(chart.outline().get(0));
            centres[i] = Vec3.of(chart.pointAt((chart.columns() - 1) / 2.0, (chart.rows() - 1) / 2.0));
            // Texels reach half of their width beyond the chart.
            radii[i] = Math.hypot(chart.widthMetres(), chart.heightMetres()) / 2 * (1 + 1.0 / 2);
        }
        Integer[] sorted = IntStream.range(0, count).boxed().toArray(Integer[]::new);
        Arrays.sort(sorted, Comparator.comparingDouble(i -> distances[i]));
        for (int first = 0; first < count; first++) {
            int i = sorted[first];
            for (int second = first + 1; second < count; second++) {
                int j = sorted[second];
                if (distances[j] - distances[i] > COPLANAR) {
                    break;
                }
                Vec3 between = centres[i].minus(centres[j]);
                double reach = radii[i] + radii[j];
                if (between.dot(between) < reach * reach && isParallel(i, j)) {
                    near[i] = with(near[i], j);
                    near[j] = with(near[j], i);
                }
            }
        }
    }

    private boolean isParallel(int one, int other) {
        return layout.charts().get(one).normal().dot(layout.charts().get(other).normal()) > 1 - COPLANAR;
    }

    private static int[] with(int[] some, int more) {
        int[] all = Arrays.copyOf(some, some.length + 1);
        all[some.length] = more;
        return all;
    }

    /**
     * Returns a place beyond a chart, a little inside the chart that is there; {@code null} if there is none, or something
     * is between.
     *
     * @param from the place on the chart from which it must be seen
     */
    Vec3 beyond(int chart, Vec3 from, Vec3 place) {
        for (int other : near[chart]) {
            LightMapChart there = layout.charts().get(other);
            if (there.metresOutside(place) <= COPLANAR) {
                Vec3 to = Vec3.of(there.inside(there.columnOf(place), there.rowOf(place)));
                return isOpen(from, to, Vec3.of(there.normal()), layout.brushOf()[other]) ? to : null;
            }
        }
        return null;
    }

    /** What is done with each pair of places. */
    interface Pair {
        /**
         * @param at texel of the chart
         * @param other the chart that goes on there
         * @param column position on it, as {@code row}
         */
        void join(int at, int other, double column, double row);
    }

    /** Calls for each texel at the edge of a chart with the places beside it on charts that go on there. */
    void forEdges(int index, Pair pair) {
        if (near[index].length == 0) {
            return;
        }
        LightMapChart chart = layout.charts().get(index);
        for (int at = 0; at < chart.columns() * chart.rows(); at++) {
            int column = at % chart.columns();
            int row = at / chart.columns();
            if (column == 0 || row == 0 || column == chart.columns() - 1 || row == chart.rows() - 1) {
                Vec3 place = Vec3.of(chart.inside(column, row));
                for (int other : near[index]) {
                    LightMapChart there = layout.charts().get(other);
                    if (there.metresOutside(place) <= EDGE_METRES) {
                        Vec3 to = Vec3.of(there.inside(there.columnOf(place), there.rowOf(place)));
                        if (isOpen(place, to, Vec3.of(there.normal()), layout.brushOf()[other])) {
                            pair.join(at, other, there.columnOf(place), there.rowOf(place));
                        }
                    }
                }
            }
        }
    }

    private boolean isOpen(Vec3 from, Vec3 to, Vec3 normal, int brush) {
        Vec3 lifted = from.addScaled(LIFT_METRES, normal);
        Vec3 along = to.minus(from);
        double[] o = {lifted.x(), lifted.y(), lifted.z()};
        double[] d = {along.x(), along.y(), along.z()};
        Vec3 above = to.addScaled(Receivers.ABOVE_METRES, normal);
        double[] end = {above.x(), above.y(), above.z()};
        return !occluders.isInside(end, brush) && !occluders.oneMeetsAllSegments(o, new double[][] {d});
    }
}
