package nephele.engine.sim;

import nephele.engine.portal.CrossingWord;

/**
 * What the player holds.
 *
 * @param body its index, {@link #NONE} for nothing
 * @param word the portals between the player's eye and it
 * @param ticksUnseen for how long the line of sight along the word has been broken
 */
public record Holding(int body, CrossingWord word, int ticksUnseen) {
    public static final int NONE = -1;
    public static final Holding NOTHING = new Holding(NONE, CrossingWord.EMPTY, 0);

    public boolean isHolding() {
        return body != NONE;
    }

    long hash(long seed) {
        if (!isHolding()) {
            return seed;
        }
        long hash = StateHash.join(StateHash.join(seed, body), ticksUnseen);
        return StateHash.join(hash, word);
    }
}
