package nephele.lab.trade.subject;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Passage;
import nephele.engine.portal.Portal;

/**
 * How the student report goes through a portal: who is near it is moved in front of the other one and
 * looks along its normal. Kept to be measured.
 */
final class SourceTeleport {
    /** The report does not say how near; this is a body's radius and an arm. */
    static final double NEAR_METRES = 0.5;

    private SourceTeleport() {}

    /** Whether the rule moves an eye that is there. */
    static boolean isDue(Portal entry, Vec3 eye) {
        double height = entry.inFront(eye.x(), eye.y(), eye.z());
        return height >= 0
                && height <= NEAR_METRES
                && entry.aperture()
                        .contains(entry.across(eye.x(), eye.y(), eye.z()), entry.upward(eye.x(), eye.y(), eye.z()));
    }

    /** As far before the other portal, at its middle, looking along its normal. */
    static Gaze alongNormal(Portal exit) {
        return new Gaze(exit.world(0, 0, NEAR_METRES), ahead(exit));
    }

    /** The same move, but the view keeps its angles to the portal: the least repair. */
    static Gaze keepingView(Passage passage, Portal exit, Gaze before) {
        return new Gaze(exit.world(0, 0, NEAR_METRES), passage.basis(before.view()));
    }

    private static Basis ahead(Portal exit) {
        Vec3 n = exit.normal();
        Vec3 back = n.negated();
        Vec3 r = exit.frame().right();
        return new Basis(r.negated(), exit.frame().up(), back);
    }
}
