package nephele.workshop.prove.proof;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** The figures of two batches are joined alike in either order. */
class FigureTest {
    private static void assertJoined(double expected, Figure one, Figure other) {
        assertEquals(expected, one.joined(other).value());
        assertEquals(expected, other.joined(one).value());
    }

    @Test
    void theGreatestAndTheLeastAreKeptWithWhereTheyWere() {
        assertJoined(7, Figure.greatest("a", 2, "in a"), Figure.greatest("a", 7, "in b"));
        assertJoined(2, Figure.least("a", 2, "in a"), Figure.least("a", 7, "in b"));
        assertJoined(9, Figure.sum("a", 2, ""), Figure.sum("a", 7, ""));
        assertEquals(
                "in b",
                Figure.least("a", 7, "in a")
                        .joined(Figure.least("a", 2, "in b"))
                        .unit());
    }

    @Test
    void whatIsNoNumberIsNotLost() {
        assertJoined(Double.NaN, Figure.greatest("a", 2, ""), Figure.greatest("a", Double.NaN, ""));
        assertJoined(Double.NaN, Figure.least("a", 2, ""), Figure.least("a", Double.NaN, ""));
        assertJoined(Double.NaN, Figure.sum("a", 2, ""), Figure.sum("a", Double.NaN, ""));
    }
}
