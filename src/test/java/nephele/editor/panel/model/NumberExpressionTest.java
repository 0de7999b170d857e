package nephele.editor.panel.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class NumberExpressionTest {
    private static double value(String text) {
        return NumberExpression.evaluate(text).orElseThrow();
    }

    @Test
    void sumsAreEvaluated() {
        assertEquals(128.0 / 3, value("128/3"));
        assertEquals(14, value("2 + 3*4"));
        assertEquals(20, value("(2+3) * 4"));
        assertEquals(-1.5, value("-1,5"));
        assertEquals(0.02, value("2e-2"));
        assertEquals(1, value("3-1-1"));
    }

    @Test
    void otherTextIsNoNumber() {
        for (String text : new String[] {"", "two", "1/0", "(1", "1)", "1..2", "+", "NaN", "(".repeat(5000)}) {
            assertTrue(NumberExpression.evaluate(text).isEmpty(), text);
        }
    }

    @Test
    void numbersAreShownShort() {
        assertEquals("0.1", NumberExpression.text(0.1));
        assertEquals("42.6666667", NumberExpression.text(128.0 / 3));
        assertEquals("100000", NumberExpression.text(1e5));
        assertEquals("0", NumberExpression.text(-0.0));
    }
}
