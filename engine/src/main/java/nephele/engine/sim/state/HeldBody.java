package nephele.engine.sim.state;

import nephele.engine.math.Hash64;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;

/**
 * The body that the player holds, and the line to it.
 *
 * @param body the body's index, {@link #NONE} for none
 * @param word the crossing word from the player's centre to the body's centre
 * @param ticksUnseen the number of ticks for which the line of sight along the crossing word has been broken
 * @param leaving a body that was dropped while it overlapped the player, {@link #NONE} for none: the two do not collide
 *     until it is outside
 */
public record HeldBody(int body, CrossingWord word, int ticksUnseen, int leaving) {
    public static final int NONE = -1;
    public static final HeldBody NOTHING = new HeldBody(NONE, CrossingWord.EMPTY, 0, NONE);

    public HeldBody(int body, CrossingWord word, int ticksUnseen) {
        this(body, word, ticksUnseen, NONE);
    }

    /** Returns the holding after the body is dropped. */
    public HeldBody released() {
        return word.length() == 0 ? new HeldBody(NONE, CrossingWord.EMPTY, 0, body) : NOTHING;
    }

    /** Returns the body that does not collide with the player, or {@link #NONE}. */
    public int passing() {
        return isHolding() ? body : leaving;
    }

    public boolean isHolding() {
        return body != NONE;
    }

    public HeldBody unseenFor(int ticks) {
        return ticks == ticksUnseen ? this : new HeldBody(body, word, ticks);
    }

    /** Returns true if every portal of the crossing word is open. */
    public boolean isOpen(Portals portals) {
        for (int i = 0; i < word.length(); i++) {
            if (!portals.isOpen(word.entry(i))) {
                return false;
            }
        }
        return true;
    }

    /** Maps a point of the player's space to the body's; the crossing word has to be open. */
    public Vector3d pointThere(Vector3d point, Portals portals) {
        for (int i = 0; i < word.length(); i++) {
            portals.transform(word.entry(i)).point(point);
        }
        return point;
    }

    /** Maps a direction of the player's space to the body's. */
    public Vector3d directionThere(Vector3d direction, Portals portals) {
        for (int i = 0; i < word.length(); i++) {
            portals.transform(word.entry(i)).direction(direction);
        }
        return direction;
    }

    /** Maps a point of the body's space to the player's, where it would be without the portals in between. */
    public Vector3d pointHere(Vector3d point, Portals portals) {
        for (int i = word.length() - 1; i >= 0; i--) {
            portals.transform(portals.partner(word.entry(i))).point(point);
        }
        return point;
    }

    long hash(long seed) {
        if (equals(NOTHING)) {
            return seed;
        }
        long hash = Hash64.combine(Hash64.combine(Hash64.combine(seed, body), ticksUnseen), leaving);
        return word.hash(hash);
    }
}
