package nephele.engine.scene;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.portal.Passage;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;

/**
 * What can be seen through at one instant: the mirrors of a scene, then its open portals. Ids count the mirrors first, so
 * that a new portal renames none. One object serves frame after frame.
 */
final class Openings {
    private final List<Opening> mirrors;
    private final List<Opening> all = new ArrayList<>();
    private final Vector3d start = new Vector3d();
    private final Vector3d unfolded = new Vector3d();
    private Portals portals;
    private Moment moment;

    /** @param mirrors in the order of their ids, from 0 on */
    Openings(List<Opening> mirrors) {
        this.mirrors = List.copyOf(mirrors);
    }

    /** Takes the portals as they are now. */
    void at(Moment now) {
        moment = now;
        if (portals == now.portals()) {
            return;
        }
        portals = now.portals();
        all.clear();
        all.addAll(mirrors);
        for (int i = 0; i < portals.size(); i++) {
            if (portals.isOpen(i)) {
                all.add(Opening.ofPortal(mirrors.size() + i, portals, i));
            }
        }
    }

    int size() {
        return all.size();
    }

    Opening get(int index) {
        return all.get(index);
    }

    /**
     * The portal that an eye has gone through on a straight way from one view to another, or {@code null}: of those that it
     * can have gone through the one that makes the way shortest, if that is shorter than the way without.
     */
    Opening crossed(View from, View to) {
        start.set(from.eyeX(), from.eyeY(), from.eyeZ());
        double shortest = start.distance(to.eyeX(), to.eyeY(), to.eyeZ());
        Opening crossed = null;
        for (int i = mirrors.size(); i < all.size(); i++) {
            Opening portal = all.get(i);
            Passage back = portals.passage(portals.partner(portal.portal()));
            if (back != null) {
                back.point(unfolded.set(to.eyeX(), to.eyeY(), to.eyeZ()));
                double metres = start.distance(unfolded);
                if (metres < shortest && portal.isPassed(start, unfolded)) {
                    shortest = metres;
                    crossed = portal;
                }
            }
        }
        return crossed;
    }

    /** Share of its size at which an opening is open now: a portal grows when it is made. */
    double openness(Opening opening) {
        return opening.portal() == Opening.NO_PORTAL ? 1 : moment.openness(opening.portal());
    }
}
