package nephele.engine.level;

import nephele.engine.asset.AssetId;

/** Kinds of text in a file, with their lengths in characters. */
public enum TextRule {
    /** One line for people. */
    NAME(0, 200),
    /** Several lines for people. */
    PROSE(0, 10_000),
    /** Names a record, or refers to one. */
    ID(1, 128),
    /** A file, after {@link AssetId}. */
    ASSET(1, AssetId.MAX_CHARACTERS),
    /** A hash in hexadecimal digits. */
    SHA256(64, 64);

    private final int shortest;
    private final int longest;

    TextRule(int shortest, int longest) {
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
