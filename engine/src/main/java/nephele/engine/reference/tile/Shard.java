package nephele.engine.reference.tile;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/**
 * One of several equal shares of a picture: every {@code of}-th tile.
 *
 * @param number 1 to {@code of}
 */
public record Shard(int number, int of) {
    /** A picture that is not divided. */
    public static final Shard WHOLE = new Shard(1, 1);

    public static final int MOST = 100_000;

    private static final Pattern WRITTEN = Pattern.compile("([1-9][0-9]{0,5})/([1-9][0-9]{0,5})");

    /** @throws IllegalArgumentException if there is no such share */
    public Shard {
        if (number < 1 || number > of || of > MOST) {
            throw new IllegalArgumentException(noShare(number + "/" + of));
        }
    }

    /**
     * Reads a share written as {@code i/n}.
     *
     * @throws IllegalArgumentException if the text is none
     */
    public static Shard parse(String text) {
        Matcher numbers = WRITTEN.matcher(text);
        if (!numbers.matches()) {
            throw new IllegalArgumentException(noShare(text));
        }
        return new Shard(Integer.parseInt(numbers.group(1)), Integer.parseInt(numbers.group(2)));
    }

    private static String noShare(String text) {
        return "'" + text + "' is no share: write i/n with i from 1 to n, as 2/8 for the second of eight; n is at most "
                + MOST;
    }

    /** Returns the tiles of this share, in order. */
    public IntStream tiles(PixelTiles all) {
        return IntStream.iterate(number - 1, tile -> tile < all.count(), tile -> tile + of);
    }

    @Override
    public String toString() {
        return number + "/" + of;
    }
}
