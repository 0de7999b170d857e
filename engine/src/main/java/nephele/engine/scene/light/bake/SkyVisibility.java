package nephele.engine.scene.light.bake;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.IdentityDiff;

/**
 * The sky visibility of the static geometry: at each point the cosine-weighted fraction of unoccluded directions in the
 * hemisphere above it. 1 on an open plane, ½ at the foot of an infinite wall, 0 in a closed room.
 *
 * @param statics the baked static geometry, models split
 * @param texels of the solids' faces, row by row from the lowest, 0–65535 for 0–1
 * @param ofModels likewise for every vertex of every model in order
 */
public record SkyVisibility(LightMapLayout layout, StaticShapes statics, short[] texels, short[] ofModels) {
    /** The greatest edge of flat models, which are split; a texel of 0.25 m costs less than a vertex. */
    public static final double MODEL_EDGE_METRES = 0.5;

    /** Stands for a vertex that was not baked. */
    public static final int NEW = -1;

    /** The value 1. */
    private static final short ALL = (short) 0xffff;

    /** Returns the visibility before any bake: 1 everywhere. */
    public static SkyVisibility open() {
        return even(StaticShapes.of(List.of()), true);
    }

    /** Returns the visibility of a level for which none is baked, because no sky shines or only terrain is lit. */
    public static SkyVisibility even(StaticShapes statics, boolean isOpen) {
        LightMapLayout layout = LightMapLayout.of(statics.solids());
        short[] texels = new short[layout.width() * layout.height()];
        short[] ofModels = new short[statics.models().vertexCount()];
        Arrays.fill(texels, isOpen ? ALL : 0);
        Arrays.fill(ofModels, isOpen ? ALL : 0);
        return new SkyVisibility(layout, statics, texels, ofModels);
    }

    /**
     * Bakes with the full ray budget.
     *
     * @param progress receives the completed fraction, 0–1, from any thread
     */
    public static SkyVisibility bake(StaticShapes statics, DoubleConsumer progress) {
        return bake(LightMapLayout.of(statics.solids()), statics, false, progress);
    }

    /**
     * Bakes for a layout.
     *
     * @param isRationed whether the ray budget is limited, as for levels that are baked while they are loaded
     */
    static SkyVisibility bake(
            LightMapLayout layout, StaticShapes statics, boolean isRationed, DoubleConsumer progress) {
        double ofModels = statics.models().isEmpty() ? 0 : 0.5;
        short[] texels =
                SkyVisibilityBake.texels(layout, statics, isRationed, done -> progress.accept(done * (1 - ofModels)));
        short[] values =
                ModelVisibility.values(statics, isRationed, done -> progress.accept(1 - ofModels + done * ofModels));
        return new SkyVisibility(layout, statics, texels, values);
    }

    /** Returns true if it was baked for solids of these shapes, so that the charts belong to the same indices. */
    public boolean isOf(List<Brush> solids) {
        List<Brush> baked = statics.solids();
        return solids == baked
                || solids.size() == baked.size()
                        && IntStream.range(0, solids.size()).allMatch(i -> solids.get(i)
                                .shape()
                                .equals(baked.get(i).shape()));
    }

    /** Returns the values for an edited level: vertices of {@link #vertices} keep theirs, others get 1. */
    public short[] ofModels(PlacedModels models) {
        int[] vertices = vertices(models);
        if (vertices == null) {
            return ofModels;
        }
        short[] values = new short[vertices.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = vertices[i] == NEW ? ALL : ofModels[vertices[i]];
        }
        return values;
    }

    /**
     * Returns for every vertex of the models of an edited level its number here, {@link #NEW} if no model had the same id
     * and number of vertices; {@code null} if all are the same.
     */
    public int[] vertices(PlacedModels models) {
        List<PlacedModel> baked = statics.models().all();
        if (IdentityDiff.list(baked, models.all()) == baked) {
            return null;
        }
        int[] numbers = new int[models.vertexCount()];
        Arrays.fill(numbers, NEW);
        int at = 0;
        for (PlacedModel model : models.all()) {
            int from = 0;
            for (PlacedModel old : baked) {
                int count = old.triangles().positions().length / 3;
                boolean isSame = old.authored().id().equals(model.authored().id())
                        && old.triangles().positions().length
                                == model.triangles().positions().length;
                for (int i = 0; isSame && i < count; i++) {
                    numbers[at + i] = from + i;
                }
                from += count;
            }
            at += model.triangles().positions().length / 3;
        }
        return numbers;
    }

    /** Returns the column and the row of the texel with the greatest visibility. */
    public int[] brightest() {
        int best = 0;
        for (int i = 1; i < texels.length; i++) {
            best = (texels[i] & 0xffff) > (texels[best] & 0xffff) ? i : best;
        }
        return new int[] {best % layout.width(), best / layout.width()};
    }

    /** Interpolates bilinearly as the shader does; coordinates are texels from the map's lower left corner. */
    public double at(double column, double rowFromBelow) {
        double x = Math.min(Math.max(column - 0.5, 0), layout.width() - 1);
        double y = Math.min(Math.max(rowFromBelow - 0.5, 0), layout.height() - 1);
        int x0 = Math.min((int) x, Math.max(layout.width() - 2, 0));
        int y0 = Math.min((int) y, Math.max(layout.height() - 2, 0));
        double fx = x - x0;
        double fy = y - y0;
        double low = texel(x0, y0) * (1 - fx) + texel(x0 + 1, y0) * fx;
        double high = texel(x0, y0 + 1) * (1 - fx) + texel(x0 + 1, y0 + 1) * fx;
        return low * (1 - fy) + high * fy;
    }

    private double texel(int x, int y) {
        int row = Math.min(y, layout.height() - 1);
        int column = Math.min(x, layout.width() - 1);
        return (texels[row * layout.width() + column] & 0xffff) / 65535.0;
    }
}
