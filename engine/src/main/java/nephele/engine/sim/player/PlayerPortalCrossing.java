package nephele.engine.sim.player;

import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.PortalCrossing;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Moves the player through portals when its centre crosses them. The working set of one simulation. */
public final class PlayerPortalCrossing {
    /**
     * The greatest number of crossings in a tick. The rest of the tick is then dropped, gravity included; the velocity
     * stays.
     */
    public static final int MOST_HOPS = 8;

    private static final Vector3dc NO_ACCELERATION = new Vector3d();

    private final CharacterMover mover;
    private final PortalCrossing crossing = new PortalCrossing();
    private final Vector3d start = new Vector3d();
    private final Vector3d path = new Vector3d();
    private Portals portals = Portals.NONE;
    private CrossingWord word = CrossingWord.EMPTY;
    private int hops;
    private boolean dropped;

    PlayerPortalCrossing(CharacterMover mover) {
        this.mover = mover;
    }

    /** Starts a tick. */
    void begin(Portals open, Vector3dc place) {
        portals = open;
        start.set(place);
        word = CrossingWord.EMPTY;
        hops = 0;
        dropped = false;
    }

    /** Returns the crossing word of this tick. */
    CrossingWord word() {
        return word;
    }

    /** Returns true if the rest of the tick was dropped. */
    boolean hasDropped() {
        return dropped;
    }

    boolean hasPortals() {
        return portals.size() > 0;
    }

    /** Returns the time at which the centre's arc first enters a portal; {@code seconds} if it enters none before. */
    double timeToEntry(PlayerMotion player, Vector3dc acceleration, double seconds) {
        boolean enters = crossing.find(portals, player.place, player.velocity, acceleration, seconds);
        if (enters && hops == MOST_HOPS) {
            dropped = true;
        }
        return enters ? crossing.seconds() : seconds;
    }

    /** Moves the player through the portal found last, from the exact point of entry. */
    void enter(PlayerMotion player) {
        player.place.set(crossing.place());
        pass(player);
        start.set(player.place);
    }

    /** Moves the player through every portal that the straight segment from its last tracked place enters. */
    void follow(PlayerMotion player) {
        if (!hasPortals()) {
            return;
        }
        player.place.sub(start, path);
        while (!dropped && crossing.find(portals, start, path, NO_ACCELERATION, 1)) {
            if (hops == MOST_HOPS) {
                player.place.set(start);
                dropped = true;
                return;
            }
            portals.transform(crossing.portal()).point(start.set(crossing.place()));
            portals.transform(crossing.portal()).direction(path.mul(1 - crossing.seconds()));
            pass(player);
        }
        start.set(player.place);
    }

    private void pass(PlayerMotion player) {
        int entered = crossing.portal();
        player.enter(portals.transform(entered));
        word = word.then(entered, portals);
        hops++;
        mover.resetAfterPortal();
    }
}
