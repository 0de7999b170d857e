package nephele.engine.sim;

import nephele.engine.portal.Crossing;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Takes the player through portals: where its centre goes, it goes. The working set of one simulation. */
final class Passing {
    /** After so many crossings the rest of a tick is dropped, gravity included; the velocity stays. */
    static final int MOST_HOPS = 8;

    private static final Vector3dc NO_ACCELERATION = new Vector3d();

    private final Mover mover;
    private final Crossing crossing = new Crossing();
    private final Vector3d start = new Vector3d();
    private final Vector3d way = new Vector3d();
    private Portals portals = Portals.NONE;
    private CrossingWord word = CrossingWord.EMPTY;
    private int hops;
    private boolean dropped;

    Passing(Mover mover) {
        this.mover = mover;
    }

    /** A tick begins. */
    void begin(Portals open, Vector3dc place) {
        portals = open;
        start.set(place);
        word = CrossingWord.EMPTY;
        hops = 0;
        dropped = false;
    }

    /** The portals gone through in this tick. */
    CrossingWord word() {
        return word;
    }

    /** Whether the tick's rest was dropped. */
    boolean hasDropped() {
        return dropped;
    }

    boolean hasPortals() {
        return portals.size() > 0;
    }

    /** When the centre's arc first enters a portal; {@code seconds} when it does not before. */
    double timeToEntry(PlayerMotion player, Vector3dc acceleration, double seconds) {
        boolean enters = crossing.find(portals, player.place, player.velocity, acceleration, seconds);
        if (enters && hops == MOST_HOPS) {
            dropped = true;
        }
        return enters ? crossing.seconds() : seconds;
    }

    /** Goes through the portal found last, from the very place of its entry. */
    void enter(PlayerMotion player) {
        player.place.set(crossing.place());
        pass(player);
        start.set(player.place);
    }

    /** Goes through every portal that the straight way from where the player was seen last leads into. */
    void follow(PlayerMotion player) {
        if (!hasPortals()) {
            return;
        }
        player.place.sub(start, way);
        while (!dropped && crossing.find(portals, start, way, NO_ACCELERATION, 1)) {
            if (hops == MOST_HOPS) {
                player.place.set(start);
                dropped = true;
                return;
            }
            portals.passage(crossing.portal()).point(start.set(crossing.place()));
            portals.passage(crossing.portal()).direction(way.mul(1 - crossing.seconds()));
            pass(player);
        }
        start.set(player.place);
    }

    private void pass(PlayerMotion player) {
        int entered = crossing.portal();
        player.enter(portals.passage(entered));
        word = word.then(entered, portals);
        hops++;
        mover.arrive();
    }
}
