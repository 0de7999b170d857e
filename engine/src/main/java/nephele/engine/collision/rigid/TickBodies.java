package nephele.engine.collision.rigid;

import java.util.Arrays;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyPortalState;
import nephele.engine.portal.Portals;

/** The mutable bodies of one tick, from which the next {@link Bodies} are made. */
final class TickBodies {
    double[] motion = new double[0];
    float[] rest = new float[0];
    int count;
    /** Masks of the portals on which each body is active; {@code null} without portals. */
    long[] active;
    /** The crossings, in the layout of {@link BodyPortalState}; {@code null} while there are none. */
    private byte[] entered;
    /** Number of portals that each body had gone through before this part of the tick. */
    private int[] enteredBefore = new int[0];
    /** True if a body was frozen in this tick. */
    boolean hasFrozen;
    /** Number of bodies that reached the limit of portals of a tick. */
    int cutShort;

    private static final double LARGEST = 1e12;

    /** Begins a tick. */
    void load(Bodies before) {
        entered = null;
        cutShort = 0;
        loadMotion(before);
    }

    /** Begins a later part of a tick: the crossings so far are kept. */
    void loadPart(Bodies before) {
        entered = before.transforms().copyEntered();
        loadMotion(before);
    }

    private void loadMotion(Bodies before) {
        motion = before.motion().clone();
        rest = before.rest().clone();
        count = rest.length;
        active = null;
        hasFrozen = false;
        for (int body = 0; body < count; body++) {
            if (!isFinite(body)) {
                freeze(body, before);
            }
        }
        if (entered != null) {
            enteredBefore = new int[count];
            for (int body = 0; body < count; body++) {
                enteredBefore[body] = crossings(body);
            }
        } else if (enteredBefore.length != 0) {
            enteredBefore = new int[0];
        }
    }

    boolean isAwake(int body) {
        return rest[body] >= 0;
    }

    boolean isFinite(int body) {
        double sum = 0;
        for (int i = Bodies.STRIDE * body; i < Bodies.STRIDE * (body + 1); i++) {
            sum += Math.abs(motion[i]);
        }
        return sum < LARGEST;
    }

    /** Freezes a body at its last finite pose, for good: its present state is not usable. */
    void freeze(int body, Bodies before) {
        int at = Bodies.STRIDE * body;
        System.arraycopy(before.motion(), at, motion, at, Bodies.VELOCITY);
        for (int i = 0; i < Bodies.VELOCITY; i++) {
            motion[at + i] = Math.abs(motion[at + i]) < LARGEST ? motion[at + i] : i == 6 ? 1 : 0;
        }
        halt(body);
        rest[body] = Bodies.FROZEN;
        hasFrozen = true;
    }

    void halt(int body) {
        int at = Bodies.STRIDE * body;
        for (int i = Bodies.VELOCITY; i < Bodies.STRIDE; i++) {
            motion[at + i] = 0;
        }
    }

    void wake(int body) {
        if (rest[body] == Bodies.ASLEEP) {
            rest[body] = 0;
        }
    }

    long active(int body) {
        return active == null ? 0 : active[body];
    }

    /** Stores that a body went through a portal; returns false when the limit is exceeded. */
    boolean enter(int body, int portal) {
        if (entered == null) {
            entered = new byte[BodyPortalState.MOST * count];
            Arrays.fill(entered, (byte) Portals.CLOSED);
        }
        for (int i = 0; i < BodyPortalState.MOST; i++) {
            if (entered[BodyPortalState.MOST * body + i] == Portals.CLOSED) {
                entered[BodyPortalState.MOST * body + i] = (byte) portal;
                return true;
            }
        }
        return false;
    }

    /** Returns true if a body went through a portal in this part of the tick. */
    boolean hasCrossed(int body) {
        return crossings(body) > firstCrossing(body);
    }

    /** Returns the place of a body's first crossing in this part of the tick. */
    int firstCrossing(int body) {
        return enteredBefore.length == 0 ? 0 : enteredBefore[body];
    }

    int crossings(int body) {
        int count = 0;
        while (entered != null && count < BodyPortalState.MOST && crossing(body, count) != Portals.CLOSED) {
            count++;
        }
        return count;
    }

    int crossing(int body, int place) {
        return entered[BodyPortalState.MOST * body + place];
    }

    BodyPortalState transforms(Portals portals) {
        return active == null ? BodyPortalState.NONE : new BodyPortalState(portals, active, entered);
    }
}
