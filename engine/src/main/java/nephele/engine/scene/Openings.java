package nephele.engine.scene;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;

/**
 * All openings at one instant: the mirrors of a scene, then its open portals. Ids count the mirrors first, so that a
 * new portal changes no mirror's id. One object serves all frames.
 */
final class Openings {
    private final List<Opening> mirrors;
    private final List<Opening> all = new ArrayList<>();
    private final Vector3d start = new Vector3d();
    private final Vector3d unfolded = new Vector3d();
    private Portals portals;
    private FrameState frameState;

    /**
     * Makes the set with mirrors only.
     *
     * @param mirrors in the order of their ids, from 0
     */
    Openings(List<Opening> mirrors) {
        this.mirrors = List.copyOf(mirrors);
    }

    /** Updates the portals to a frame state. */
    void at(FrameState now) {
        frameState = now;
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
     * Returns the portal through which an eye has moved on a straight path from one view to another, or {@code null}:
     * of the portals that such a path passes, the one with the shortest path, if that is shorter than the path through
     * none.
     */
    Opening crossed(View from, View to) {
        start.set(from.eyeX(), from.eyeY(), from.eyeZ());
        double shortest = start.distance(to.eyeX(), to.eyeY(), to.eyeZ());
        Opening crossed = null;
        for (int i = mirrors.size(); i < all.size(); i++) {
            Opening portal = all.get(i);
            PortalTransform back = portals.transform(portals.partner(portal.portal()));
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

    /** Returns the scale at which an opening is open now, 0 to 1: a new portal grows. */
    double openness(Opening opening) {
        return opening.portal() == Opening.NO_PORTAL ? 1 : frameState.openness(opening.portal());
    }
}
