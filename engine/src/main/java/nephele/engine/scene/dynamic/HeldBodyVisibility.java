package nephele.engine.scene.dynamic;

import nephele.engine.math.Vec3;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.View;

/**
 * The copies of a held body that a view shows as its holder's eye sees it: in front of the eye, or along the portals
 * through which the body is held. Any other visible copy, as in a portal that looks back, is the body seen from
 * elsewhere. One object serves all views.
 */
public final class HeldBodyVisibility {
    /**
     * The tolerance on the expected position: at least a tick's motion, and less than the distance of any copy that is
     * seen from elsewhere.
     */
    private static final double APART_METRES = 0.25;

    private final DynamicInstances copies;
    /** Several if a body is cut into adjacent pieces, as where a portal's partner is directly behind it. */
    private final int[] instances = new int[PortalCopies.MOST_COPIES];

    private int size;
    private boolean isGunBeforeEye;

    public HeldBodyVisibility(DynamicInstances copies) {
        this.copies = copies;
    }

    /** Finds the copies for a view; the copies must have been updated to {@code frameState}. */
    public void find(View view, FrameState frameState) {
        size = 0;
        isGunBeforeEye = frameState.gun() != null;
        // A mirror always shows the body from elsewhere, however near it is to the mirror.
        if (frameState.held() == FrameState.NOTHING || view.isMirrored()) {
            return;
        }
        for (int i = copies.bodyStart(frameState.held()); i < copies.bodyEnd(frameState.held()); i++) {
            if (squaredApart(view, frameState.heldFromEye(), i) < APART_METRES * APART_METRES) {
                instances[size++] = i;
            }
        }
    }

    public int size() {
        return size;
    }

    /** Returns true if the frame shows a gun, with a hand and a forearm of its own. */
    boolean isGunBeforeEye() {
        return isGunBeforeEye;
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
