package nephele.engine.scene;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;

/**
 * What can be seen through at one instant: the mirrors of a scene, then its open portals. Ids count the mirrors first, so
 * that a new portal renames none. One object serves frame after frame.
 */
final class Openings {
    private final List<Opening> mirrors;
    private final List<Opening> all = new ArrayList<>();
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
        Vector3d start = from.eye().toVector();
        Vec3 end = to.eye();
        double shortest = start.distance(end.toVector());
        Opening crossed = null;
        for (Opening opening : all) {
            Opening partner = partner(opening);
            if (partner != null) {
                Vector3d unfolded = partner.isometry().point(end.toVector());
                double metres = start.distance(unfolded);
                if (metres < shortest && opening.isPassed(start, unfolded)) {
                    shortest = metres;
                    crossed = opening;
                }
            }
        }
        return crossed;
    }

    private Opening partner(Opening opening) {
        if (opening.portal() != Opening.NO_PORTAL) {
            for (Opening other : all) {
                if (other.leadsBackThrough(opening)) {
                    return other;
                }
            }
        }
        return null;
    }

    /** Share of its size at which an opening is open now: a portal grows when it is made. */
    double openness(Opening opening) {
        return opening.portal() == Opening.NO_PORTAL ? 1 : moment.openness(opening.portal());
    }
}
