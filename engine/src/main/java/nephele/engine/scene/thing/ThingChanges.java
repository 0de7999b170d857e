package nephele.engine.scene.thing;

import java.util.Arrays;
import java.util.Objects;
import nephele.engine.portal.Portals;
import nephele.engine.scene.Moment;
import nephele.engine.scene.Moment.Posture;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/** Tells whether anything that things are drawn by differs from what it was when last asked. */
final class ThingChanges {
    private final double[] poses;
    private final boolean[] moved;
    private final Vector3d centre = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private Portals portals;
    private Posture figure;
    private double seconds;

    ThingChanges(int bodies) {
        poses = new double[7 * bodies];
        moved = new boolean[bodies];
        Arrays.fill(poses, Double.NaN);
    }

    /** Compares a moment with the one before, and remembers it. */
    boolean since(Moment moment) {
        boolean changed = isFigureNew(moment) | moment.portals() != portals;
        portals = moment.portals();
        for (int body = 0; body < moved.length; body++) {
            moment.centre(body, centre);
            moment.orientation(body, turn);
            moved[body] = differs(7 * body, centre.x, centre.y, centre.z);
            changed |= moved[body];
            changed |= differs(7 * body + 3, turn.x, turn.y, turn.z);
            changed |= differs(7 * body + 4, turn.y, turn.z, turn.w);
        }
        return changed;
    }

    /** Whether a body was elsewhere when asked the time before the last. */
    boolean hasMoved(int body) {
        return moved[body];
    }

    private boolean isFigureNew(Moment moment) {
        boolean isNew =
                moment.figure() != null && seconds != moment.seconds() || !Objects.equals(moment.figure(), figure);
        figure = moment.figure();
        seconds = moment.seconds();
        return isNew;
    }

    /** Remembers three values and tells whether they are new. */
    private boolean differs(int at, double x, double y, double z) {
        boolean is = poses[at] != x || poses[at + 1] != y || poses[at + 2] != z;
        poses[at] = x;
        poses[at + 1] = y;
        poses[at + 2] = z;
        return is;
    }
}
