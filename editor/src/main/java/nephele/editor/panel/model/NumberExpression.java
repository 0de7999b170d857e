package nephele.editor.panel.model;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.OptionalDouble;

/** Reads a number or a sum, such as {@code 128/3} or {@code (2 + 0,5) * 4}; a comma counts as the decimal point. */
public final class NumberExpression {
    private final String text;
    private int at;

    private NumberExpression(String text) {
        this.text = text;
    }

    /** Returns the value of a text; empty if it is no finite number. */
    public static OptionalDouble evaluate(String text) {
        var parser = new NumberExpression(text.replaceAll("\\s", "").replace(',', '.'));
        try {
            double value = parser.sum(0);
            boolean isDone = parser.at == parser.text.length();
            return isDone && Double.isFinite(value) ? OptionalDouble.of(value) : OptionalDouble.empty();
        } catch (NumberFormatException wrong) {
            return OptionalDouble.empty();
        }
    }

    /** Returns a number as a field shows it: no exponent, no needless zeros, nine digits at most. */
    public static String text(double value) {
        if (!Double.isFinite(value)) {
            return "";
        }
        String plain = new BigDecimal(value)
                .round(new MathContext(9))
                .stripTrailingZeros()
                .toPlainString();
        return value == 0 ? "0" : plain;
    }

    private boolean takes(char wanted) {
        boolean isNext = at < text.length() && text.charAt(at) == wanted;
        if (isNext) {
            at++;
        }
        return isNext;
    }

    private double sum(int depth) {
        double value = product(depth);
        while (true) {
            if (takes('+')) {
                value += product(depth);
            } else if (takes('-')) {
                value -= product(depth);
            } else {
                return value;
            }
        }
    }

    private double product(int depth) {
        double value = factor(depth);
        while (true) {
            if (takes('*')) {
                value *= factor(depth);
            } else if (takes('/')) {
                value /= factor(depth);
            } else {
                return value;
            }
        }
    }

    private double factor(int depth) {
        if (depth > 100) {
            throw new NumberFormatException("too deep");
        }
        if (takes('-')) {
            return -factor(depth + 1);
        }
        if (takes('(')) {
            double value = sum(depth + 1);
            if (!takes(')')) {
                throw new NumberFormatException("no closing bracket");
            }
            return value;
        }
        int start = at;
        while (at < text.length() && isNumberPart(start)) {
            at++;
        }
        return Double.parseDouble(text.substring(start, at));
    }

    private boolean isNumberPart(int start) {
        char c = text.charAt(at);
        boolean isSignOfExponent =
                (c == '-' || c == '+') && at > start && Character.toLowerCase(text.charAt(at - 1)) == 'e';
        return Character.isDigit(c) || c == '.' || c == 'e' || c == 'E' || isSignOfExponent;
    }
}
