package nephele.engine.sim;

import nephele.engine.math.BitHash;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;

/**
 * What the player holds.
 *
 * @param body its index, {@link #NONE} for nothing
 * @param word the portals between the player's centre and its own
 * @param ticksUnseen for how long the line of sight along the word has been broken
 * @param leaving what was let go of within the player and is not out yet: until then they do not meet
 */
public record Holding(int body, CrossingWord word, int ticksUnseen, int leaving) {
    public static final int NONE = -1;
    public static final Holding NOTHING = new Holding(NONE, CrossingWord.EMPTY, 0, NONE);

    Holding(int body, CrossingWord word, int ticksUnseen) {
        this(body, word, ticksUnseen, NONE);
    }

    /** The body is let go of. */
    Holding released() {
        return word.length() == 0 ? new Holding(NONE, CrossingWord.EMPTY, 0, body) : NOTHING;
    }

    /** The body that the player does not meet, or {@link #NONE}. */
    int passing() {
        return isHolding() ? body : leaving;
    }

    public boolean isHolding() {
        return body != NONE;
    }

    Holding unseenFor(int ticks) {
        return ticks == ticksUnseen ? this : new Holding(body, word, ticks);
    }

    /** Whether every portal of the word still leads somewhere. */
    boolean isOpen(Portals portals) {
        for (int i = 0; i < word.length(); i++) {
            if (!portals.isOpen(word.entry(i))) {
                return false;
            }
        }
        return true;
    }

    /** Moves a point of the player's space to the body's; the word has to be open. */
    Vector3d pointThere(Vector3d point, Portals portals) {
        for (int i = 0; i < word.length(); i++) {
            portals.passage(word.entry(i)).point(point);
        }
        return point;
    }

    /** Turns a direction of the player's space to the body's. */
    Vector3d directionThere(Vector3d direction, Portals portals) {
        for (int i = 0; i < word.length(); i++) {
            portals.passage(word.entry(i)).direction(direction);
        }
        return direction;
    }

    /** Moves a point of the body's space to the player's: where it would be if no portals were between. */
    Vector3d pointHere(Vector3d point, Portals portals) {
        for (int i = word.length() - 1; i >= 0; i--) {
            portals.passage(portals.partner(word.entry(i))).point(point);
        }
        return point;
    }

    long hash(long seed) {
        if (equals(NOTHING)) {
            return seed;
        }
        long hash = BitHash.join(BitHash.join(BitHash.join(seed, body), ticksUnseen), leaving);
        return word.hash(hash);
    }
}
