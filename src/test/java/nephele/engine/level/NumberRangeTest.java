package nephele.engine.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.json.NumberText;
import nephele.engine.level.json.WrittenField;
import nephele.engine.level.json.WrittenRecord;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** What {@link Range} states is what its readers get. */
class NumberRangeTest {
    private record Ranges(
            @Written @Range(min = 1, max = 2) double interval,
            @Written @Range(min = 1, max = 2, shape = Range.Shape.OR_ZERO) double orZero,
            @Written(absent = "1") @Range(min = 1, max = 2, shape = Range.Shape.EITHER_SIGN) double eitherSign,
            @Written(absent = "[0, 1, 0]") @Range(min = 1, max = 2, shape = Range.Shape.DIRECTION) Vec3 direction) {}

    private record NoRange(@Written double metres) {}

    private static NumberRange range(String name) {
        return WrittenRecord.of(Ranges.class).fields().stream()
                .filter(field -> field.name().equals(name))
                .map(WrittenField::range)
                .findFirst()
                .orElseThrow();
    }

    private static String text(String name) {
        return range(name).text("from %s to %s", " or ", NumberText::of);
    }

    @Test
    void aNumberWithoutARangeIsNoComponent() {
        String told = assertThrows(IllegalStateException.class, () -> WrittenRecord.of(NoRange.class))
                .getMessage();
        assertTrue(told.contains("NoRange.metres does not say its range"), told);
    }

    @Test
    void aShapeHoldsItsLimitsAndNothingBeyond() {
        assertEquals("from 1 to 2", text("interval"));
        assertFalse(range("interval").contains(0));
        assertEquals("0 or from 1 to 2", text("orZero"));
        assertTrue(range("orZero").contains(-0.0));
        assertFalse(range("orZero").contains(Double.MIN_VALUE));
        assertEquals("from -2 to -1 or from 1 to 2", text("eitherSign"));
        assertTrue(range("eitherSign").contains(-1));
        assertFalse(range("eitherSign").contains(Math.nextDown(1)));
        for (String name : new String[] {"interval", "orZero", "eitherSign", "direction"}) {
            assertFalse(range(name).contains(Math.nextUp(2)), name);
            assertFalse(range(name).contains(Double.NaN), name);
        }
    }

    @Test
    void aDirectionHasOneComponentFarFromZero() {
        assertTrue(range("direction").reaches(new Vec3(0, -1, 0)));
        assertFalse(range("direction").reaches(new Vec3(Math.nextDown(1), 0, -0.5)));
        assertTrue(range("interval").reaches(Vec3.ZERO));
    }

    @Test
    void theNearestNumberIsInTheNearerPart() {
        assertEquals(0, range("orZero").nearest(0.4));
        assertEquals(1, range("orZero").nearest(0.6));
        assertEquals(-1, range("eitherSign").nearest(-0.1));
        assertEquals(2, range("interval").nearest(9));
    }
}
