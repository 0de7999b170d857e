package nephele.engine.model;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.MessageText;
import nephele.engine.asset.TextFile;

/**
 * Splits a text file into lines of words; errors name file and line. Lines end in LF, CRLF or CR; {@code #} begins a
 * comment.
 */
public final class ModelText {
    /** The corners of a polygon, the keyword before them, and a continuation mark. */
    private static final int MOST_WORDS = 2 + MeshLimits.MAX_CORNERS;

    private static final int LONGEST_WORD = 256;
    private static final int MOST_QUOTED = 64;

    private final String file;
    private final byte[] bytes;
    private final boolean[] separates = new boolean[256];
    private int at;
    private int line;

    /** @param separators characters that separate words in addition to white space */
    public ModelText(String file, byte[] bytes, String separators) {
        this.file = file;
        this.bytes = bytes;
        for (char c : (" \t\f" + separators).toCharArray()) {
            separates[c] = true;
        }
        this.at = start(file, bytes);
        if (bytes.length > MeshLimits.MAX_TEXT_BYTES) {
            throw new ModelFileException(
                    file,
                    0,
                    "is larger than " + (MeshLimits.MAX_TEXT_BYTES >> 20) + " MiB",
                    "make the mesh coarser or keep it as .glb");
        }
    }

    private static int start(String file, byte[] bytes) {
        try {
            return TextFile.textStart(bytes);
        } catch (TextFile.NotUtf8 noText) {
            throw new ModelFileException(file, noText.line(), "it can't be read", noText.getMessage());
        }
    }

    public int line() {
        return line;
    }

    public boolean hasNext() {
        return at < bytes.length;
    }

    /** Returns the words of the next line that is not only a comment; none if it is blank, or at the end. */
    public List<String> nextLine() {
        List<String> words = new ArrayList<>(4);
        boolean comment;
        do {
            comment = readLine(() -> words.add(word(words.size())));
        } while (comment && words.isEmpty() && hasNext());
        return words;
    }

    /**
     * Parses the next line as numbers, without allocating an object for each, and returns their count.
     *
     * @param row receives the first numbers
     */
    public int nextNumbers(float[] row) {
        int[] count = new int[1];
        boolean comment;
        do {
            comment = readLine(() -> {
                float number = nextNumber(count[0]);
                if (count[0] < row.length) {
                    row[count[0]] = number;
                }
                count[0]++;
            });
        } while (comment && count[0] == 0 && hasNext());
        return count[0];
    }

    /** Reads a line and returns true if it ends in a comment. */
    private boolean readLine(Runnable word) {
        line++;
        boolean comment = false;
        while (at < bytes.length && !endsLine(bytes[at])) {
            if (bytes[at] == '#') {
                comment = true;
                skipToEnd();
            } else if (separates(bytes[at])) {
                at++;
            } else {
                word.run();
            }
        }
        skipEnd();
        return comment;
    }

    public ModelFileException error(String reason, String remedy) {
        return wrongAt(line, reason, remedy);
    }

    public ModelFileException wrongAt(int where, String reason, String remedy) {
        return new ModelFileException(file, where, reason, remedy);
    }

    /** Parses a number in the range of coordinates. */
    public float coordinate(String word) {
        float value = number(word);
        if (!isCoordinate(value)) {
            throw notACoordinate(line, value);
        }
        return value;
    }

    public static boolean isCoordinate(float value) {
        return Math.abs(value) <= MeshLimits.MAX_COORDINATE_UNITS;
    }

    public ModelFileException notACoordinate(int where, float value) {
        return wrongAt(where, MessageText.number(value) + " is no coordinate", "keep within a million units");
    }

    float number(String word) {
        try {
            return Float.parseFloat(decimal(word));
        } catch (NumberFormatException notANumber) {
            throw error(quoted(word) + " is not a number", "write it as 1.5 or -2e-3");
        }
    }

    /** Returns the word unless only Java accepts it as a number, such as 1f, 0x1p3 or NaN. */
    public static String decimal(String word) {
        for (int i = 0; i < word.length(); i++) {
            if ("0123456789+-.eE".indexOf(word.charAt(i)) < 0) {
                throw new NumberFormatException(word);
            }
        }
        return word;
    }

    /** Parses an integer in the range of int. */
    public int whole(String word) {
        try {
            return Integer.parseInt(word);
        } catch (NumberFormatException notWhole) {
            throw error(quoted(word) + " is not a whole number", "write it as 12, without a point");
        }
    }

    /** Returns a word of a file for a message, in quotation marks; only its beginning if it is long. */
    public static String quoted(String word) {
        boolean isLong = word.codePointCount(0, word.length()) > MOST_QUOTED;
        String start = isLong ? word.substring(0, word.offsetByCodePoints(0, MOST_QUOTED)) + "…" : word;
        return '"' + MessageText.printable(start) + '"';
    }

    private float nextNumber(int before) {
        int end = at;
        while (end < bytes.length && !endsLine(bytes[end]) && !separates(bytes[end]) && bytes[end] != '#') {
            end++;
        }
        float number = before < MOST_WORDS ? PlainDecimal.read(bytes, at, end) : Float.NaN;
        if (Float.isNaN(number)) {
            return number(word(before));
        }
        at = end;
        return number;
    }

    private String word(int before) {
        int start = at;
        while (at < bytes.length && !endsLine(bytes[at]) && !separates(bytes[at]) && bytes[at] != '#') {
            at++;
        }
        if (before >= MOST_WORDS) {
            throw tooManyWords();
        }
        int length = Math.min(at - start, LONGEST_WORD + 1);
        String word = new String(bytes, start, length, StandardCharsets.UTF_8);
        if (length > LONGEST_WORD) {
            throw error(quoted(word) + " is longer than any number", "check that the file is a mesh in text form");
        }
        return word;
    }

    /** Returns the words unless there are too many. */
    public List<String> atMost(List<String> words) {
        if (words.size() > MOST_WORDS) {
            throw tooManyWords();
        }
        return words;
    }

    private ModelFileException tooManyWords() {
        return error(
                "has more than " + MeshLimits.MAX_CORNERS + " corners or numbers in a line",
                "cut the polygon into smaller ones");
    }

    private boolean separates(byte c) {
        return separates[c & 0xff];
    }

    private static boolean endsLine(byte c) {
        return c == '\n' || c == '\r';
    }

    private void skipToEnd() {
        while (at < bytes.length && !endsLine(bytes[at])) {
            at++;
        }
    }

    private void skipEnd() {
        if (at < bytes.length && bytes[at] == '\r') {
            at++;
            if (at < bytes.length && bytes[at] == '\n') {
                at++;
            }
        } else if (at < bytes.length) {
            at++;
        }
    }
}
