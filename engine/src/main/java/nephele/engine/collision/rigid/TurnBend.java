package nephele.engine.collision.rigid;

/**
 * Says how finely a step has to be cut where bodies turn: contacts are linear in the motion, and the way of a point of a
 * turning body is not. Reused.
 */
final class TurnBend {
    /** If the way of a point of a body that touches something bends by more, contacts are found anew in between. */
    private static final double BEND_METRES = 3e-6;

    static final int MOST_PARTS = 32;
    /** Finer parts are for few bodies: this many steps of a body in all. */
    private static final int MOST_BODY_STEPS = 64;

    /** Turns below this matter to nothing. */
    private static final double LEAST_RADIANS = 1e-3;

    private final Poses poses;
    private final Motions motions;
    private final double[] local = new double[3];

    TurnBend(Poses poses, Motions motions) {
        this.poses = poses;
        this.motions = motions;
    }

    /** Into how many parts a step is to be cut where the greatest bend is this. */
    int parts(double bendMetres, int awake) {
        double wanted = Math.ceil(Math.sqrt(bendMetres / BEND_METRES));
        return (int) Math.max(1, Math.min(wanted, Math.min(MOST_PARTS, MOST_BODY_STEPS / Math.max(1, awake))));
    }

    /** How far, at most, the way of a point of a body bends off a straight line by the body's turn: r ω² t² / 2. */
    double metres(int body, double seconds) {
        if (poses.kind[body] == BodyTable.SPHERE) {
            return 0;
        }
        double spin = turnIntoBody(body);
        if (spin * seconds < LEAST_RADIANS) {
            return 0;
        }
        // A capsule's surface stays what it is about the axis, however round it is.
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

    /** Writes how fast the body turns about each of its own axes; returns how fast in all. */
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
