package nephele.engine.render.pass.edge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The areas of Reshetov's shapes. */
class LineAreaTest {
    /** A step of one pixel: the line goes from half a pixel on one side to half a pixel on the other one. */
    @ParameterizedTest
    @CsvSource({"0, 0, 0.125", "0, 1, 0.25", "1, 0, 0", "0, 3, 0.375", "1, 2, 0.125", "2, 1, 0", "3, 0, 0"})
    void stepsGiveTheTrapezoidBeyondTheLine(int before, int after, double area) {
        assertEquals(area, LineArea.beyond(before, after, 1, -1), 1e-12);
        assertEquals(area, LineArea.beyond(after, before, -1, 1), 1e-12);
    }

    @Test
    void anEdgeWithoutCrossingsStaysSharp() {
        for (int size = 0; size < 20; size++) {
            assertEquals(0, LineArea.beyond(size, 19 - size, 0, 0));
        }
    }

    /** All pixels of a shape together take the triangle's area, and no pixel more than half. */
    @Test
    void areasAddUp() {
        for (int size = 1; size <= 33; size++) {
            double sum = 0;
            for (int before = 0; before < size; before++) {
                double area = LineArea.beyond(before, size - 1 - before, 1, 0);
                assertTrue(area >= 0 && area <= 0.5);
                sum += area;
            }
            assertEquals(size / 8.0, sum, 1e-9);
        }
    }
}
