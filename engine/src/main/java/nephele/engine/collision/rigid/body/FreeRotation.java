package nephele.engine.collision.rigid.body;

/**
 * Free rotation over time. With equal moments of inertia the angular velocity is constant and the rotation exact. With
 * unequal ones, the energy is split into that of a ball with the greatest moment, an exact rotation that commutes with
 * the others, and rotations about the axes of the least and the middle moment by the excess of their reciprocals over
 * the ball's (after Touma and Wisdom 1994, "Lie-Poisson integrators for rigid body dynamics"), raised to fourth order
 * by Yoshida (1990). The moments of a solid obey the triangle inequality, so that the rotation about the middle axis is
 * slow however thin a body is. Angular momentum is conserved to rounding, energy within a narrow band for ever.
 */
public final class FreeRotation {
    private static final double STEP_RADIANS = 0.04;
    private static final int MOST_STEPS = 256;
    /** Weight of the rotation about the axis of the least moment in the limit {@link #STEP_RADIANS}. */
    private static final double FAST_FRACTION = 0.1;

    private static final double NEGLIGIBLE_FRACTION = 1e-9;
    /** Yoshida's outer and middle weights: 1 / (2 − ∛2), and 1 minus twice that. */
    private static final double OUTER = 1.3512071919596578;

    private static final double MIDDLE = 1 - 2 * OUTER;

    private final double[] q = new double[4];
    /** Angular momentum in the body's axes. */
    private final double[] momentum = new double[3];

    private final double[] turned = new double[3];
    /** The axes of the least and the middle moment of inertia. */
    private int least;

    private int middle;

    /** Rotates the body with numbers from {@code at} on ({@link Bodies#STRIDE}). */
    public void turn(double[] motion, int at, double seconds, BodyTable table, int body) {
        double iX = table.inverseInertia(body, 0);
        double iY = table.inverseInertia(body, 1);
        double iZ = table.inverseInertia(body, 2);
        int w = at + Bodies.SPIN;
        double speed = Math.sqrt(motion[w] * motion[w] + motion[w + 1] * motion[w + 1] + motion[w + 2] * motion[w + 2]);
        if (speed == 0) {
            return;
        }
        if (iX == iY && iY == iZ) {
            turnBy(motion, at, motion[w] * seconds, motion[w + 1] * seconds, motion[w + 2] * seconds);
            return;
        }
        sortAxes(iX, iY, iZ);
        System.arraycopy(motion, at + Bodies.ORIENTATION, q, 0, 4);
        toBody(motion, w, iX, iY, iZ);
        double ball = Math.min(iX, Math.min(iY, iZ));
        double fast = table.inverseInertia(body, least) - ball;
        double slow = table.inverseInertia(body, middle) - ball;
        double all = Math.sqrt(momentum[0] * momentum[0] + momentum[1] * momentum[1] + momentum[2] * momentum[2]);
        int steps = steps(seconds, fast, slow, all, ball);
        // The ball's rotation about the momentum, which is constant in world axes.
        rotate(momentum[0], momentum[1], momentum[2], 1, turned);
        turnBy(motion, at, turned[0] * ball * seconds, turned[1] * ball * seconds, turned[2] * ball * seconds);
        System.arraycopy(motion, at + Bodies.ORIENTATION, q, 0, 4);
        double h = seconds / steps;
        for (int i = 0; i < steps; i++) {
            splitStep(OUTER * h, fast, slow);
            splitStep(MIDDLE * h, fast, slow);
            splitStep(OUTER * h, fast, slow);
        }
        fromBody(motion, at, iX, iY, iZ);
    }

    private void sortAxes(double iX, double iY, double iZ) {
        least = iX >= iY && iX >= iZ ? 0 : iY >= iZ ? 1 : 2;
        int greatest = iX <= iY && iX <= iZ && least != 0 ? 0 : iY <= iZ && least != 1 ? 1 : 2;
        greatest = greatest == least ? (least + 1) % 3 : greatest;
        middle = 3 - least - greatest;
    }

    /**
     * Returns the number of steps that the slow rotation needs beside the fast one; 1 if it changes almost no energy.
     */
    private int steps(double seconds, double fast, double slow, double all, double ball) {
        double slowRate = slow * all;
        double change = slowRate * all * seconds;
        if (fast * change * change < NEGLIGIBLE_FRACTION * ball * all * all) {
            return 1;
        }
        double fastRate = fast * Math.min(all, Math.abs(momentum[least]) + change);
        double rate = Math.max(Math.sqrt(slowRate * (slowRate + fastRate)), FAST_FRACTION * fastRate);
        return (int) Math.max(1, Math.min(MOST_STEPS, Math.ceil(rate * seconds / STEP_RADIANS)));
    }

    /** Rotates an orientation by a rotation vector in world axes. */
    public static void turnBy(double[] motion, int at, double x, double y, double z) {
        double angle = Math.sqrt(x * x + y * y + z * z);
        double half = angle / 2;
        double s = angle < 1e-9 ? 0.5 : sine(half) / angle;
        double c = cosine(half);
        int o = at + Bodies.ORIENTATION;
        double qx = motion[o];
        double qy = motion[o + 1];
        double qz = motion[o + 2];
        double qw = motion[o + 3];
        double ax = s * x;
        double ay = s * y;
        double az = s * z;
        double rx = c * qx + ax * qw + ay * qz - az * qy;
        double ry = c * qy + ay * qw + az * qx - ax * qz;
        double rz = c * qz + az * qw + ax * qy - ay * qx;
        double rw = c * qw - ax * qx - ay * qy - az * qz;
        double length = Math.sqrt(rx * rx + ry * ry + rz * rz + rw * rw);
        motion[o] = rx / length;
        motion[o + 1] = ry / length;
        motion[o + 2] = rz / length;
        motion[o + 3] = rw / length;
    }

    private void splitStep(double h, double fast, double slow) {
        about(middle, h / 2, slow);
        about(least, h, fast);
        about(middle, h / 2, slow);
    }

    /** Applies the flow of one axis alone: the body rotates about it, and its momentum in body axes the other way. */
    private void about(int axis, double h, double inverse) {
        double angle = momentum[axis] * inverse * h;
        double s = sine(angle / 2);
        double c = cosine(angle / 2);
        int j = (axis + 1) % 3;
        int k = (axis + 2) % 3;
        double cos = c * c - s * s;
        double sin = 2 * s * c;
        double mj = momentum[j];
        momentum[j] = cos * mj + sin * momentum[k];
        momentum[k] = cos * momentum[k] - sin * mj;
        double qi = q[axis];
        double qj = q[j];
        q[axis] = c * qi + s * q[3];
        q[3] = c * q[3] - s * qi;
        q[j] = c * qj + s * q[k];
        q[k] = c * q[k] - s * qj;
    }

    private void toBody(double[] motion, int w, double iX, double iY, double iZ) {
        rotate(motion[w], motion[w + 1], motion[w + 2], -1, momentum);
        momentum[0] /= iX;
        momentum[1] /= iY;
        momentum[2] /= iZ;
    }

    private void fromBody(double[] motion, int at, double iX, double iY, double iZ) {
        double length = Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        for (int i = 0; i < 4; i++) {
            q[i] /= length;
            motion[at + Bodies.ORIENTATION + i] = q[i];
        }
        rotate(momentum[0] * iX, momentum[1] * iY, momentum[2] * iZ, 1, turned);
        System.arraycopy(turned, 0, motion, at + Bodies.SPIN, 3);
    }

    /** Writes v rotated by q (sign 1) or by its inverse (−1). */
    private void rotate(double x, double y, double z, int sign, double[] out) {
        double qx = sign * q[0];
        double qy = sign * q[1];
        double qz = sign * q[2];
        double tx = 2 * (qy * z - qz * y);
        double ty = 2 * (qz * x - qx * z);
        double tz = 2 * (qx * y - qy * x);
        out[0] = x + q[3] * tx + qy * tz - qz * ty;
        out[1] = y + q[3] * ty + qz * tx - qx * tz;
        out[2] = z + q[3] * tz + qx * ty - qy * tx;
    }

    /** Returns the sine, by a Taylor series up to 0.5, where its terms reach the last bit. */
    private static double sine(double a) {
        if (Math.abs(a) > 0.5) {
            return StrictMath.sin(a);
        }
        double s = a * a;
        return a * (1 - s / 6 * (1 - s / 20 * (1 - s / 42 * (1 - s / 72 * (1 - s / 110 * (1 - s / 156))))));
    }

    private static double cosine(double a) {
        if (Math.abs(a) > 0.5) {
            return StrictMath.cos(a);
        }
        double s = a * a;
        return 1 - s / 2 * (1 - s / 12 * (1 - s / 30 * (1 - s / 56 * (1 - s / 90 * (1 - s / 132 * (1 - s / 182))))));
    }
}
