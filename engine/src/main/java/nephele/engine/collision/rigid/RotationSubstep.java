package nephele.engine.collision.rigid;

import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.collision.rigid.solver.SolverState;

/**
 * Decides how finely a step is divided when bodies rotate: contacts are linear in the motion, but the path of a point
 * of a rotating body is curved. Reused.
 */
final class RotationSubstep {
    /**
     * Deviation from a straight path, of a point of a body in contact, above which contacts are found anew in between.
     */
    private static final double BEND_METRES = 3e-6;

    static final int MOST_PARTS = 32;
    /** Limit of parts times awake bodies: finer parts are for few bodies. */
    private static final int MOST_BODY_STEPS = 64;

    /** Angle of rotation in a step below which the deviation is ignored. */
    private static final double LEAST_RADIANS = 1e-3;

    private final Poses poses;
    private final SolverState motions;
    private final double[] local = new double[3];

    RotationSubstep(Poses poses, SolverState motions) {
        this.poses = poses;
        this.motions = motions;
    }

    /** Returns the number of parts of a step with this greatest deviation. */
    int parts(double bendMetres, int awake) {
        double wanted = Math.ceil(Math.sqrt(bendMetres / BEND_METRES));
        return (int) Math.max(1, Math.min(wanted, Math.min(MOST_PARTS, MOST_BODY_STEPS / Math.max(1, awake))));
    }

    /** Returns the greatest deviation of a body's points from a straight path by its rotation: r ω² t² / 2. */
    double metres(int body, double seconds) {
        if (poses.kind[body] == BodyTable.SPHERE) {
            return 0;
        }
        double spin = turnIntoBody(body);
        if (spin * seconds < LEAST_RADIANS) {
            return 0;
        }
        // Rotation of a capsule about its axis does not move its surface.
        boolean box = poses.kind[body] == BodyTable.BOX;
        double hX = box ? poses.half[3 * body] : 0;
        double hY = poses.half[3 * body + 1];
        double hZ = box ? poses.half[3 * body + 2] : 0;
        double sX = local[1] * hZ + local[2] * hY;
        double sY = local[2] * hX + local[0] * hZ;
        double sZ = local[0] * hY + local[1] * hX;
        double speed = Math.sqrt(sX * sX + sY * sY + sZ * sZ);
        return Math.min(spin * speed * seconds * seconds / 2, 2 * speed / spin);
    }

    /** Writes the speeds of rotation about each of the body's axes; returns the whole speed of rotation. */
    private double turnIntoBody(int body) {
        int w = 6 * body + 3;
        double[] v = motions.velocity;
        double[] x = poses.axes;
        double square = 0;
        for (int i = 0; i < 3; i++) {
            int at = 9 * body + 3 * i;
            local[i] = Math.abs(v[w] * x[at] + v[w + 1] * x[at + 1] + v[w + 2] * x[at + 2]);
            square += local[i] * local[i];
        }
        return Math.sqrt(square);
    }
}
