package nephele.engine.scene.light.bake;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.math.Plane;

/**
 * The layout of all face fragments of a level in one light map. It depends on the solids alone, so a baked map is valid
 * for every run.
 *
 * @param chartOf for each brush and face the indices into {@code charts}, −1 for a covered fragment
 * @param columnOf left texel of each chart in the map, {@code rowOf} its lowest
 * @param brushOf brush of each chart
 * @param width texels, {@code height} likewise
 */
public record LightMapLayout(
        FaceFragments fragments,
        List<LightMapChart> charts,
        List<List<int[]>> chartOf,
        int[] columnOf,
        int[] rowOf,
        int[] brushOf,
        int width,
        int height,
        double texelMetres) {
    /** The side of a texel, metres, unless the level is too large. */
    public static final double TEXEL_METRES = 0.25;

    /** At 16 bits per texel half a mebibyte; beyond it texels grow. */
    static final int MAX_TEXELS = 1 << 18;

    private static final int LEAST_SIDE_TEXELS = 1024;
    private static final double GROWTH = 1.25;

    /** Lays faces out within {@link #MAX_TEXELS}, or if these are too few for any size of texel, within a few more. */
    public static LightMapLayout of(List<Brush> brushes) {
        return of(brushes, MAX_TEXELS);
    }

    static LightMapLayout of(List<Brush> brushes, int wanted) {
        return of(brushes, wanted, TEXEL_METRES);
    }

    /** Lays faces out with texels of another size, unless the level is too large for them. */
    public static LightMapLayout withTexels(List<Brush> brushes, double texelMetres) {
        double finer = TEXEL_METRES / texelMetres;
        return of(brushes, (int) Math.max(MAX_TEXELS, MAX_TEXELS * finer * finer), texelMetres);
    }

    private static LightMapLayout of(List<Brush> brushes, int wanted, double leastMetres) {
        FaceFragments fragments = FaceFragments.of(brushes);
        long fewest = texels(brushes, fragments, Double.POSITIVE_INFINITY);
        long most = Math.max(wanted, fewest + fewest / 4);
        int side = LEAST_SIDE_TEXELS;
        while ((long) side * side < 4 * most) {
            side *= 2;
        }
        double texel = leastMetres;
        while (true) {
            if (texels(brushes, fragments, texel) <= most) {
                LightMapLayout layout = tryAt(brushes, fragments, texel, side);
                if (layout.height <= side && layout.width <= side) {
                    return layout;
                }
            }
            texel *= GROWTH;
        }
    }

    private static long texels(List<Brush> brushes, FaceFragments fragments, double texelMetres) {
        long texels = 1;
        for (int b = 0; b < brushes.size(); b++) {
            List<List<FaceFragment>> faces = fragments.byBrush().get(b);
            for (int f = 0; f < faces.size(); f++) {
                Plane plane = brushes.get(b).shape().faces().get(f).plane();
                for (FaceFragment part : faces.get(f)) {
                    if (!part.isCovered()) {
                        LightMapChart chart = LightMapChart.over(part.outline(), plane, texelMetres);
                        texels += (long) chart.columns() * chart.rows();
                    }
                }
            }
        }
        return texels;
    }

    private static LightMapLayout tryAt(List<Brush> brushes, FaceFragments fragments, double texelMetres, int side) {
        List<LightMapChart> charts = new ArrayList<>();
        List<Integer> brushOf = new ArrayList<>();
        List<List<int[]>> chartOf = new ArrayList<>();
        for (int b = 0; b < brushes.size(); b++) {
            List<int[]> ofBrush = new ArrayList<>();
            List<List<FaceFragment>> faces = fragments.byBrush().get(b);
            for (int f = 0; f < faces.size(); f++) {
                Plane plane = brushes.get(b).shape().faces().get(f).plane();
                List<FaceFragment> parts = faces.get(f);
                int[] ofFace = new int[parts.size()];
                for (int i = 0; i < ofFace.length; i++) {
                    ofFace[i] = parts.get(i).isCovered() ? -1 : charts.size();
                    if (!parts.get(i).isCovered()) {
                        charts.add(LightMapChart.over(parts.get(i).outline(), plane, texelMetres));
                        brushOf.add(b);
                    }
                }
                ofBrush.add(ofFace);
            }
            chartOf.add(ofBrush);
        }
        int[] brush = brushOf.stream().mapToInt(Integer::intValue).toArray();
        return packed(fragments, charts, chartOf, brush, texelMetres, side);
    }

    /** Packs charts into shelves: by descending height, side by side until a row is full. */
    private static LightMapLayout packed(
            FaceFragments fragments,
            List<LightMapChart> charts,
            List<List<int[]>> chartOf,
            int[] brushOf,
            double texelMetres,
            int side) {
        long area = 1;
        int widest = 2;
        for (LightMapChart chart : charts) {
            area += (long) chart.columns() * chart.rows();
            widest = Math.max(widest, chart.columns());
        }
        int width = (widest + 16) & ~15;
        while (width < side && (long) width * width < area) {
            width += 16;
        }
        int[] column = new int[charts.size()];
        int[] row = new int[charts.size()];
        int height = shelve(charts, column, row, width);
        return new LightMapLayout(fragments, charts, chartOf, column, row, brushOf, width, height, texelMetres);
    }

    /** Assigns positions. The texel at (0, 0) stays free for covered fragments. */
    private static int shelve(List<LightMapChart> charts, int[] column, int[] row, int width) {
        List<Integer> byHeight = new ArrayList<>();
        for (int i = 0; i < charts.size(); i++) {
            byHeight.add(i);
        }
        byHeight.sort(Comparator.comparingInt(i -> -charts.get(i).rows()));
        int x = 1;
        int y = 0;
        int shelf = 1;
        for (int i : byHeight) {
            LightMapChart chart = charts.get(i);
            if (x + chart.columns() > width) {
                y += shelf;
                x = 0;
                shelf = 0;
            }
            column[i] = x;
            row[i] = y;
            x += chart.columns();
            shelf = Math.max(shelf, chart.rows());
        }
        return y + shelf;
    }
}
