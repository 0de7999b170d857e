package nephele.engine.scene.thing;

import nephele.engine.math.Vec3;
import nephele.engine.scene.Moment;
import nephele.engine.scene.View;

/**
 * Which copies of a held body a view shows as its holder's eye sees it: before the eye, or along the portals that it is
 * held through. Any other copy that the view shows, as in a portal that looks back, is the body seen from elsewhere. One
 * object serves view after view.
 */
public final class HeldSight {
    /** A tick's motion, at most; what is seen from elsewhere is never so near to where the eye sees it. */
    private static final double APART_METRES = 0.25;

    private final ThingCopies copies;
    /** Several where a body is cut into pieces that stay together: a portal's back may be its partner's front. */
    private final int[] instances = new int[ThingPlaces.MOST_COPIES];

    private int size;

    public HeldSight(ThingCopies copies) {
        this.copies = copies;
    }

    /** Looks from somewhere; the copies have to be those of {@code moment}. */
    public void find(View view, Moment moment) {
        size = 0;
        // In a mirror it is seen from elsewhere, however near to the mirror it is.
        if (moment.held() == Moment.NOTHING || view.isMirrored()) {
            return;
        }
        for (int i = copies.bodyStart(moment.held()); i < copies.bodyEnd(moment.held()); i++) {
            if (squaredApart(view, moment.heldFromEye(), i) < APART_METRES * APART_METRES) {
                instances[size++] = i;
            }
        }
    }

    public int size() {
        return size;
    }

    int instance(int index) {
        return instances[index];
    }

    boolean contains(int instance) {
        for (int i = 0; i < size; i++) {
            if (instances[i] == instance) {
                return true;
            }
        }
        return false;
    }

    private double squaredApart(View view, Vec3 fromEye, int instance) {
        double x = copies.ball(instance, 0) - view.eyeX();
        double y = copies.ball(instance, 1) - view.eyeY();
        double z = copies.ball(instance, 2) - view.eyeZ();
        double right = view.alongRight(x, y, z) - fromEye.x();
        double up = view.alongUp(x, y, z) - fromEye.y();
        double back = view.alongBack(x, y, z) - fromEye.z();
        return right * right + up * up + back * back;
    }
}
