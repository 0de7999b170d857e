package nephele.app.command;

import java.util.Comparator;
import java.util.stream.Collectors;

/** What `nephele --help` prints. */
final class Overview {
    private static final int NAME_WIDTH = 10;
    private static final int FARTHEST_TYPING_ERROR = 2;

    private Overview() {}

    static String text() {
        var lines = Commands.ALL.stream()
                .map(entry -> "  " + padded(entry.name()) + entry.summary() + "\n")
                .collect(Collectors.joining());
        return "Usage: nephele COMMAND [ARGUMENT...]\n\n" + lines
                + "\n`nephele COMMAND --help` tells more. Exit codes: 0 done, 1 the input has errors,"
                + " 2 wrong usage, 3 the environment lacks something.\n";
    }

    static String unknown(String word) {
        var nearest = Commands.ALL.stream()
                .map(CommandEntry::name)
                .min(Comparator.comparingInt(name -> editDistance(name, word)))
                .filter(name -> editDistance(name, word) <= FARTHEST_TYPING_ERROR)
                .map(name -> "; did you mean `" + name + "`?")
                .orElse("");
        return "unknown command `" + word + "`" + nearest + "\n`nephele --help` lists the commands.";
    }

    /** Levenshtein (1966): the least number of letters to insert, drop or change. */
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

    private static String padded(String name) {
        return name + " ".repeat(Math.max(1, NAME_WIDTH - name.length()));
    }
}
