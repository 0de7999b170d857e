package nephele.engine.cloud.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.OpticalDepth;
import nephele.engine.level.Cloud;
import nephele.engine.level.Cloud.FillBox;
import nephele.engine.level.Cloud.Puff;
import nephele.engine.level.Cloud.PuffFill;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A fill is a heap in each block: as dense with few puffs as with many, flat below, and the same for the same seed. */
class PuffFillingTest {
    private static final FillBox BOX = new FillBox(new Vec3(10, 20, 30), new Vec3(200, 120, 160));

    private static ExtinctionField field(List<Puff> puffs) {
        return new PuffsField(puffs, Vec3.ZERO, 1);
    }

    @Test
    void aSeedDecidesEveryPuff() {
        var fill = new PuffFill(List.of(BOX), 50, 4);
        assertEquals(PuffFilling.of(fill), PuffFilling.of(fill));
        assertNotEquals(PuffFilling.of(fill), PuffFilling.of(new PuffFill(List.of(BOX), 50, 5)));
    }

    @Test
    void listedPuffsAndTheFillAddUp() {
        var listed = new Puff(Vec3.ZERO, 3);
        var fill = new PuffFill(List.of(BOX), 20, 1);
        List<Puff> all = PuffFilling.all(new Cloud.Density.Puffs(List.of(listed), fill));
        assertEquals(21, all.size());
        assertEquals(listed, all.get(0));
        assertEquals(PuffFilling.of(fill), all.subList(1, 21));
        assertEquals(List.of(listed), PuffFilling.all(new Cloud.Density.Puffs(List.of(listed), null)));
        assertEquals(List.of(), PuffFilling.of(new PuffFill(List.of(), 20, 1)));
        assertEquals(List.of(), PuffFilling.of(new PuffFill(List.of(BOX), 0, 1)));
    }

    @Test
    void aBlockHasItsShareOfThePuffs() {
        var small = new FillBox(new Vec3(500, 0, 0), new Vec3(100, 60, 80));
        List<Puff> puffs = PuffFilling.of(new PuffFill(List.of(BOX, small), 900, 2));
        assertEquals(900, puffs.size());
        assertEquals(100, puffs.stream().filter(puff -> puff.centre().x() > 300).count());
    }

    @ParameterizedTest
    @ValueSource(ints = {20, 100, 1000})
    void puffsKeepToTheirBlock(int count) {
        for (Puff puff : PuffFilling.of(new PuffFill(List.of(BOX), count, 3))) {
            Vec3 from = puff.centre().minus(BOX.centre());
            double r = puff.radiusMetres();
            assertTrue(Math.abs(from.x()) <= 100 - r + 1e-9 && Math.abs(from.z()) <= 80 - r + 1e-9, puff.toString());
            assertTrue(from.y() >= -60 + 0.6 * r - 1e-9 && from.y() <= 60 - r + 1e-9, puff.toString());
        }
    }

    /** The heap of |x|³ + |y|³ + |z|³ below 1 takes 71 % of its block; puffs are moved inwards by their radius. */
    @ParameterizedTest
    @ValueSource(ints = {20, 100, 1000, 5000})
    void theMeanDensityIsOneWhateverTheirNumber(int count) {
        List<Puff> puffs = PuffFilling.of(new PuffFill(List.of(BOX), count, 3));
        double integral = puffs.stream()
                .mapToDouble(puff -> Math.pow(2 * Math.PI, 1.5) * Math.pow(puff.radiusMetres() / 2, 3))
                .sum();
        assertEquals(0.71 * 200 * 120 * 160, integral, 0.05 * 200 * 120 * 160);
    }

    @Test
    void theMiddleIsDenserThanTheRimAndTheBaseIsFlat() {
        ExtinctionField heap = field(PuffFilling.of(new PuffFill(List.of(BOX), 400, 6)));
        double middle = across(heap, 10, 30);
        assertTrue(middle > 1.3 * across(heap, 10 + 70, 30 + 55), "thick in the middle");
        double lowest = Double.MAX_VALUE;
        double highest = -Double.MAX_VALUE;
        for (int k = -2; k <= 2; k++) {
            for (int i = -2; i <= 2; i++) {
                double base = base(heap, 10 + 22 * i, 30 + 18 * k);
                lowest = Math.min(lowest, base);
                highest = Math.max(highest, base);
            }
        }
        assertTrue(highest - lowest < 20, "base from " + lowest + " to " + highest);
    }

    private static double across(ExtinctionField field, double x, double z) {
        return OpticalDepth.along(field, new Ray(x, -200, z, 0, 1, 0), 0, 500);
    }

    private static double base(ExtinctionField field, double x, double z) {
        double y = -80;
        while (field.perMetre(x, y, z) < 0.3) {
            y += 0.25;
        }
        return y;
    }
}
