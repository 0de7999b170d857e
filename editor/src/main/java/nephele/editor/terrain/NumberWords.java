package nephele.editor.terrain;

import java.util.Locale;

/** Numbers in messages: two decimals at most. */
public final class NumberWords {
    private NumberWords() {}

    /** Returns a number without zeros at its end. */
    public static String of(double number) {
        String text = String.format(Locale.ROOT, "%.2f", number + 0.0);
        return text.replaceAll("\\.?0+$", "");
    }
}
