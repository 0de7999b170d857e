package nephele.engine.bake;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.TestLevel;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.LightMapLayout;
import org.junit.jupiter.api.Test;

/** The filter of baked light takes noise, not light. */
class NoiseFilterTest {
    /** The noise is mostly darker than its mean and sometimes much brighter, as that of light which few rays find. */
    @Test
    void rareBrightTexelsAreSpreadNotLost() {
        StaticShapes statics = PlacedLevel.of(
                        new TestLevel().box("", Vec3.ZERO, new Vec3(10, 10, 10)).level(), TestAssets.NONE)
                .statics();
        Receivers receivers = new Receivers(LightMapLayout.of(statics.solids()), statics);
        float[] values = new float[Gathered.VALUES * receivers.count()];
        float[] errors = new float[receivers.count()];
        SplittableRandom random = new SplittableRandom(1);
        for (int receiver = 0; receiver < receivers.count(); receiver++) {
            double value = 1 - 0.4 * (1 + Math.log(1 - random.nextDouble()));
            Arrays.fill(values, Gathered.VALUES * receiver, Gathered.VALUES * (receiver + 1), (float) value);
            errors[receiver] = 0.4f;
        }
        float[] filtered = new NoiseFilter(receivers, Gathered.VALUES, values, errors).filtered();
        assertEquals(mean(values), mean(filtered), 0.005);
        assertTrue(spread(filtered) < 0.65 * spread(values), "spread " + spread(filtered) + " of " + spread(values));
    }

    private static double mean(float[] values) {
        double sum = 0;
        for (float value : values) {
            sum += value;
        }
        return sum / values.length;
    }

    private static double spread(float[] values) {
        double mean = mean(values);
        double sum = 0;
        for (float value : values) {
            sum += (value - mean) * (value - mean);
        }
        return Math.sqrt(sum / values.length);
    }
}
