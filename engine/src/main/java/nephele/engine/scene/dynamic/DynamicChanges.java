package nephele.engine.scene.dynamic;

import java.util.Arrays;
import java.util.Objects;
import nephele.engine.portal.Portals;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.FrameState.ObserverSphere;
import nephele.engine.scene.FrameState.Posture;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/** Detects whether any input of the dynamic objects' drawing has changed since the previous call. */
final class DynamicChanges {
    private final double[] poses;
    private final boolean[] moved;
    private final Vector3d centre = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private Portals portals;
    private Posture character;
    private ObserverSphere observer;
    private double seconds;

    DynamicChanges(int bodies) {
        poses = new double[7 * bodies];
        moved = new boolean[bodies];
        Arrays.fill(poses, Double.NaN);
    }

    /** Compares a frame state with the previous one and stores it. Returns true if anything has changed. */
    boolean since(FrameState frameState) {
        boolean changed = isCharacterNew(frameState) | frameState.portals() != portals;
        portals = frameState.portals();
        for (int body = 0; body < moved.length; body++) {
            frameState.centre(body, centre);
            frameState.orientation(body, turn);
            moved[body] = differs(7 * body, centre.x, centre.y, centre.z);
            changed |= moved[body];
            changed |= differs(7 * body + 3, turn.x, turn.y, turn.z);
            changed |= differs(7 * body + 4, turn.y, turn.z, turn.w);
        }
        return changed;
    }

    /** Returns true if a body's position changed between the last two calls of {@link #since}. */
    boolean hasMoved(int body) {
        return moved[body];
    }

    private boolean isCharacterNew(FrameState frameState) {
        boolean isNew = frameState.character() != null && seconds != frameState.seconds()
                || !Objects.equals(frameState.character(), character)
                || !Objects.equals(frameState.observer(), observer);
        observer = frameState.observer();
        character = frameState.character();
        seconds = frameState.seconds();
        return isNew;
    }

    /** Stores three values and returns true if one has changed. */
    private boolean differs(int at, double x, double y, double z) {
        boolean is = poses[at] != x || poses[at + 1] != y || poses[at + 2] != z;
        poses[at] = x;
        poses[at + 1] = y;
        poses[at + 2] = z;
        return is;
    }
}
