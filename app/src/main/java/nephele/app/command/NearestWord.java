package nephele.app.command;

import java.util.Comparator;
import java.util.Optional;
import java.util.stream.Stream;

/** Finds the known word that a mistyped one probably means. */
final class NearestWord {
    private static final int FARTHEST_TYPING_ERROR = 2;

    private NearestWord() {}

    /** Returns the nearest known word within two typing errors. */
    static Optional<String> to(String typed, Stream<String> known) {
        return known.min(Comparator.comparingInt(word -> editDistance(word, typed)))
                .filter(word -> editDistance(word, typed) <= FARTHEST_TYPING_ERROR);
    }

    /** Returns a question that ends a message about an unknown word; empty if no known word is near. */
    static String proposal(String typed, Stream<String> known) {
        return to(typed, known).map(word -> "; did you mean `" + word + "`?").orElse("");
    }

    /** Returns the edit distance of Levenshtein (1966): the least number of letters to insert, remove or replace. */
    static int editDistance(String a, String b) {
        int[] previous = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            previous[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int[] current = new int[b.length() + 1];
            current[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int change = previous[j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                current[j] = Math.min(change, 1 + Math.min(previous[j], current[j - 1]));
            }
            previous = current;
        }
        return previous[b.length()];
    }
}
