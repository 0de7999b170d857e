package nephele.engine.cloud.drawn;

import java.util.stream.IntStream;
import nephele.engine.cloud.field.NoiseField;
import nephele.engine.cloud.field.ProfiledNoise;
import nephele.engine.math.Aabb;

/** The bodies of a cloud in plan: how deep columns are inside of them, −1 to 1 as unsigned 16 bits, x fastest. */
public record PlanCells(short[] depths) {
    /** Columns along each side of a box. */
    public static final int ACROSS = 512;

    static PlanCells of(NoiseField field, Aabb box) {
        var noise = (ProfiledNoise) field.density();
        short[] depths = new short[ACROSS * ACROSS];
        double x = (box.maxX() - box.minX()) / ACROSS;
        double z = (box.maxZ() - box.minZ()) / ACROSS;
        IntStream.range(0, ACROSS).parallel().forEach(row -> {
            for (int column = 0; column < ACROSS; column++) {
                double depth = noise.bodyDepth(
                        box.minX() + (column + 0.5) * x - field.origin().x(),
                        box.minZ() + (row + 0.5) * z - field.origin().z());
                double stored = Math.max(0, Math.min(1, (depth + 1) / 2));
                depths[row * ACROSS + column] = (short) Math.round(65535 * stored);
            }
        });
        return new PlanCells(depths);
    }
}
