package nephele.engine.scene.light.bake;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleConsumer;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import nephele.engine.level.placed.StaticShapes;
import org.joml.Vector3d;

/** Casts the rays of the sky visibility. The result does not depend on the number of threads. */
public final class SkyVisibilityBake {
    /** Rays of a texel; the spiral's error is below 0.005 if the visible sky has one straight border. */
    static final int RAYS = 512;

    /** The least number of rays of a texel under a limited budget. */
    private static final int LEAST_RAYS = 16;

    /** The height of rays' origins above their face: below the thickness of any object, above the cut's rounding. */
    private static final double LIFT_METRES = 1e-3;

    /** The difference to the vicinity above which a texel becomes a blend with a mean; at twice that it is the mean. */
    private static final double LEAST_RELIEF = 0.03;

    /** The vicinity, in texels along each side. */
    private static final double[] NEAR_TEXELS = {-0.18, 0.18};

    /** The centres of six parts of equal weight under a texel's tent function. */
    private static final double[] AROUND_TEXELS = tent(6);

    private final LightMapLayout layout;
    private final Occluders solids;
    private final Occluders.Sight sight;
    private final int stride;
    private final double[] spiral = spiral(RAYS);

    private SkyVisibilityBake(LightMapLayout layout, Occluders solids, Occluders.Sight sight, int stride) {
        this.layout = layout;
        this.solids = solids;
        this.sight = sight;
        this.stride = stride;
    }

    /** Uses all rays, or fewer if the budget is limited. */
    private static SkyVisibilityBake of(LightMapLayout layout, StaticShapes statics, boolean isRationed) {
        Occluders solids = new Occluders(statics);
        int stride = isRationed ? stride(layout, solids) : 1;
        return new SkyVisibilityBake(layout, solids, solids::isOccluded, stride);
    }

    private static int stride(LightMapLayout layout, Occluders solids) {
        int[] end = new int[layout.charts().size()];
        int texels = 0;
        for (int i = 0; i < end.length; i++) {
            LightMapChart chart = layout.charts().get(i);
            texels += chart.columns() * chart.rows();
            end[i] = texels;
        }
        int total = texels;
        IntUnaryOperator divisor = stride -> {
            BakeBudget ration = new BakeBudget(solids);
            SkyVisibilityBake sample = new SkyVisibilityBake(layout, solids, ration, stride);
            return ration.divisor(total, total, texel -> sample.texelOfAll(texel, end));
        };
        // With half of the rays the means are omitted, which may be most of the work.
        int stride = divisor.applyAsInt(1) == 1 ? 1 : 2 * divisor.applyAsInt(2);
        return Math.min(stride, RAYS / LEAST_RAYS);
    }

    /**
     * Computes a texel by its index among the texels of all charts.
     *
     * @param end index after each chart's last texel
     */
    private void texelOfAll(int texel, int[] end) {
        int found = Arrays.binarySearch(end, texel + 1);
        int index = found < 0 ? -found - 1 : found;
        LightMapChart chart = layout.charts().get(index);
        int at = texel - end[index] + chart.columns() * chart.rows();
        texel(chart, at % chart.columns(), at / chart.columns(), layout.brushOf()[index]);
    }

    private static double[] tent(int parts) {
        double[] middles = new double[parts];
        for (int i = 0; i < parts; i++) {
            double u = (i + 0.5) / parts;
            middles[i] = u < 0.5 ? Math.sqrt(2 * u) - 1 : 1 - Math.sqrt(2 * (1 - u));
        }
        return middles;
    }

    static short[] texels(LightMapLayout layout, StaticShapes statics, boolean isRationed, DoubleConsumer progress) {
        SkyVisibilityBake bake = SkyVisibilityBake.of(layout, statics, isRationed);
        short[] texels = new short[layout.width() * layout.height()];
        AtomicInteger done = new AtomicInteger();
        int charts = layout.charts().size();
        IntStream.range(0, charts).parallel().forEach(chart -> {
            bake.chart(chart, texels);
            progress.accept((double) done.incrementAndGet() / charts);
        });
        return texels;
    }

    private void chart(int index, short[] texels) {
        LightMapChart chart = layout.charts().get(index);
        double[] visible = new double[chart.columns() * chart.rows()];
        for (int row = 0; row < chart.rows(); row++) {
            for (int column = 0; column < chart.columns(); column++) {
                visible[row * chart.columns() + column] = texel(chart, column, row, layout.brushOf()[index]);
            }
        }
        fill(visible, chart.columns());
        for (int row = 0; row < chart.rows(); row++) {
            for (int column = 0; column < chart.columns(); column++) {
                int at = (layout.rowOf()[index] + row) * layout.width() + layout.columnOf()[index] + column;
                texels[at] = (short) Math.round(visible[row * chart.columns() + column] * 65535);
            }
        }
    }

    /**
     * Returns the visibility at the texel's centre if it varies little nearby. Beside a low kerb it varies: there the
     * result is the mean over the tent of the bilinear interpolation, so that the mean brightness of the face is right.
     * A limited budget has no means. NaN inside a solid.
     */
    private double texel(LightMapChart chart, int column, int row, int brush) {
        double here = visibility(chart, chart.inside(column, row), brush, 0, stride);
        if (Double.isNaN(here) || stride > 1) {
            return here;
        }
        double near = mean(chart, column, row, brush, NEAR_TEXELS);
        double relief = (Math.abs(near - here) - LEAST_RELIEF) / LEAST_RELIEF;
        if (Double.isNaN(relief) || relief <= 0) {
            return here;
        }
        double around = mean(chart, column, row, brush, AROUND_TEXELS);
        return here + Math.min(relief, 1) * (around - here);
    }

    /** Returns the mean of several points, NaN if all of them are inside a solid. */
    private double mean(LightMapChart chart, int column, int row, int brush, double[] offsets) {
        double sum = 0;
        double weights = 0;
        int count = offsets.length * offsets.length;
        // Each point casts a share of the rays only; together they cast more than the centre.
        int step = count < 16 ? 4 : 16;
        for (int i = 0; i < count; i++) {
            double x = column + offsets[i % offsets.length];
            double y = row + offsets[i / offsets.length];
            if (x > 0 && x < chart.columns() - 1 && y > 0 && y < chart.rows() - 1) {
                double visible = visibility(chart, chart.inside(x, y), brush, i, step);
                sum += Double.isNaN(visible) ? 0 : visible;
                weights += Double.isNaN(visible) ? 0 : 1;
            }
        }
        return sum / weights;
    }

    /** Casts every {@code step}-th ray from {@code first} on. NaN inside a solid. */
    private double visibility(LightMapChart chart, Vector3d p, int brush, int first, int step) {
        p.fma(LIFT_METRES, chart.normal());
        double[] origin = {p.x, p.y, p.z};
        if (solids.isInside(origin, brush)) {
            return Double.NaN;
        }
        double[] direction = new double[3];
        Vector3d s = chart.across();
        Vector3d t = chart.up();
        Vector3d n = chart.normal();
        int free = 0;
        for (int i = 3 * (first % step); i < spiral.length; i += 3 * step) {
            direction[0] = spiral[i] * s.x + spiral[i + 1] * t.x + spiral[i + 2] * n.x;
            direction[1] = spiral[i] * s.y + spiral[i + 1] * t.y + spiral[i + 2] * n.y;
            direction[2] = spiral[i] * s.z + spiral[i + 1] * t.z + spiral[i + 2] * n.z;
            free += sight.isOccluded(origin, direction, brush) ? 0 : 1;
        }
        return (double) step * free / RAYS;
    }

    /**
     * Returns directions of equal cosine weight: a sunflower spiral on the unit disc (Vogel 1979), lifted to the
     * hemisphere (Malley's method). Every texel uses the same ones, so the error varies smoothly and is not noise.
     */
    static double[] spiral(int rays) {
        double goldenAngle = Math.PI * (3 - Math.sqrt(5));
        double[] directions = new double[3 * rays];
        for (int i = 0; i < rays; i++) {
            double r2 = (i + 0.5) / rays;
            double angle = i * goldenAngle + 0.5;
            directions[3 * i] = Math.sqrt(r2) * StrictMath.cos(angle);
            directions[3 * i + 1] = Math.sqrt(r2) * StrictMath.sin(angle);
            directions[3 * i + 2] = Math.sqrt(1 - r2);
        }
        return directions;
    }

    /** Replaces every NaN, ring by ring, by the mean of its neighbours that are numbers; all by 0 if there is none. */
    private static void fill(double[] values, int columns) {
        double[] before = values.clone();
        boolean isChanged = true;
        while (isChanged) {
            isChanged = false;
            for (int i = 0; i < values.length; i++) {
                double mean = Double.isNaN(before[i]) ? neighbourMean(before, columns, i) : Double.NaN;
                if (!Double.isNaN(mean)) {
                    values[i] = mean;
                    isChanged = true;
                }
            }
            System.arraycopy(values, 0, before, 0, values.length);
        }
        for (int i = 0; i < values.length; i++) {
            values[i] = Double.isNaN(values[i]) ? 0 : values[i];
        }
    }

    private static double neighbourMean(double[] values, int columns, int at) {
        int column = at % columns;
        double sum = 0;
        int count = 0;
        for (int i = at - columns; i <= at + columns; i += columns) {
            for (int dx = -1; dx <= 1; dx++) {
                boolean isIn = i >= 0 && i < values.length && column + dx >= 0 && column + dx < columns;
                if (isIn && !Double.isNaN(values[i + dx])) {
                    sum += values[i + dx];
                    count++;
                }
            }
        }
        return count == 0 ? Double.NaN : sum / count;
    }
}
