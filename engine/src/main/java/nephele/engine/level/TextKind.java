package nephele.engine.level;

import nephele.engine.asset.AssetId;

/** Kinds of text in a file, with their limits of length in characters. */
public enum TextKind {
    /** One line of text for readers. */
    NAME(0, 200),
    /** Several lines of text for readers. */
    PROSE(0, 10_000),
    /** The name of a record, or a reference to one. */
    ID(1, 128),
    /** A file name, as {@link AssetId} defines it. */
    ASSET(1, AssetId.MAX_CHARACTERS),
    /** A hash in hexadecimal digits. */
    SHA256(64, 64);

    private final int shortest;
    private final int longest;

    TextKind(int shortest, int longest) {
        this.shortest = shortest;
        this.longest = longest;
    }

    public int shortest() {
        return shortest;
    }

    public int longest() {
        return longest;
    }
}
