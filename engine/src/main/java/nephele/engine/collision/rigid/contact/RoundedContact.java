package nephele.engine.collision.rigid.contact;

import nephele.engine.collision.Collider;
import nephele.engine.collision.ContactHull;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.math.Vec3;

/**
 * Contacts of spheres and capsules: with each other by the nearest points of their axes (Ericson, Real-Time Collision
 * Detection, 2005, section 5.1.9), with polyhedra by GJK. A capsule flat on a surface has two points. Reused.
 */
final class RoundedContact {
    /** Sine of the greatest angle at which a capsule is flat on a surface. */
    private static final double FLAT_SINE = 0.05;

    /** One minus the cosine of the greatest angle between equal normals. */
    private static final double ALONG = 1e-9;

    private final Separation separation = new Separation();
    private final double[] axesInBox = new double[9];
    private Collider solid;
    private double reach;
    private double radius;
    /** The shape's centre relative to the solid's. */
    private double x;

    private double y;
    private double z;
    /** Vector from the centre to the end of the capsule's axis. */
    private double uX;

    private double uY;
    private double uZ;

    /** Finds the contact of two round shapes. */
    void touch(Poses poses, int a, int b, double reach, Manifold out) {
        out.clear();
        double dX = poses.centre[3 * b] - poses.centre[3 * a];
        double dY = poses.centre[3 * b + 1] - poses.centre[3 * a + 1];
        double dZ = poses.centre[3 * b + 2] - poses.centre[3 * a + 2];
        double[] x = poses.axes;
        int p = Poses.AXES * a + 3;
        int q = Poses.AXES * b + 3;
        double ha = poses.half[3 * a + 1];
        double hb = poses.half[3 * b + 1];
        double dot = x[p] * x[q] + x[p + 1] * x[q + 1] + x[p + 2] * x[q + 2];
        double onA = dX * x[p] + dY * x[p + 1] + dZ * x[p + 2];
        double onB = dX * x[q] + dY * x[q + 1] + dZ * x[q + 2];
        double radii = poses.half[3 * a + 2] + poses.half[3 * b + 2];
        double square = 1 - dot * dot;
        if (ha > 0 && hb > 0 && square < FLAT_SINE * FLAT_SINE) {
            double low = Math.max(-ha, onA - hb);
            double high = Math.min(ha, onA + hb);
            boolean crosses = (high - low) * Math.sqrt(square) > FLAT_SINE * radii;
            if (high - low > 0.1 * Math.min(ha, hb) && !crosses) {
                double turn = dot < 0 ? -1 : 1;
                between(poses, a, b, low, clamp(turn * (low - onA), hb), radii, reach, 0, out);
                between(poses, a, b, high, clamp(turn * (high - onA), hb), radii, reach, 1, out);
                return;
            }
        }
        double s = square > 1e-9 ? clamp((onA - dot * onB) / square, ha) : clamp(onA, ha);
        double t = clamp(dot * s - onB, hb);
        s = clamp(onA + dot * t, ha);
        between(poses, a, b, s, t, radii, reach, 0, out);
    }

    private static double clamp(double v, double limit) {
        return Math.max(-limit, Math.min(limit, v));
    }

    private static void between(
            Poses poses, int a, int b, double s, double t, double radii, double reach, int id, Manifold out) {
        double[] x = poses.axes;
        double[] c = poses.centre;
        int p = Poses.AXES * a + 3;
        int q = Poses.AXES * b + 3;
        double nX = c[3 * a] + s * x[p] - c[3 * b] - t * x[q];
        double nY = c[3 * a + 1] + s * x[p + 1] - c[3 * b + 1] - t * x[q + 1];
        double nZ = c[3 * a + 2] + s * x[p + 2] - c[3 * b + 2] - t * x[q + 2];
        double length = Math.sqrt(nX * nX + nY * nY + nZ * nZ);
        if (length - radii > reach) {
            return;
        }
        if (length < 1e-12) {
            nX = 0;
            nY = 1;
            nZ = 0;
        } else {
            nX /= length;
            nY /= length;
            nZ /= length;
        }
        if (out.count == 0) {
            out.normal(nX, nY, nZ);
            out.code = 0;
        }
        double back = poses.half[3 * a + 2] + (length - radii) / 2;
        out.add(s * x[p] - back * nX, s * x[p + 1] - back * nY, s * x[p + 2] - back * nZ, length - radii, id);
    }

    /** Finds the contact of a round shape and a static solid. */
    void touch(Poses poses, int a, RoundedHull shape, Collider itsSolid, double itsReach, Manifold out) {
        begin(itsSolid, itsReach, out);
        int c = 3 * a;
        separation.measure(shape, poses.centre[c], poses.centre[c + 1], poses.centre[c + 2], solid);
        if (separation.metres() > reach) {
            return;
        }
        Vec3 m = solid.centre();
        x = poses.centre[c] - m.x();
        y = poses.centre[c + 1] - m.y();
        z = poses.centre[c + 2] - m.z();
        collect(poses, a, poses.axes, Poses.AXES * a + 3, out);
    }

    private void begin(Collider itsSolid, double itsReach, Manifold out) {
        out.clear();
        solid = itsSolid;
        reach = itsReach;
    }

    /**
     * Finds the contact of a round shape and a moving box, in the frame of the box, which {@code itsSolid} represents.
     */
    void touchBox(
            Poses poses,
            int a,
            int box,
            RoundedHull inBox,
            RoundedHull upright,
            Collider itsSolid,
            double itsReach,
            Manifold out) {
        begin(itsSolid, itsReach, out);
        double dX = poses.centre[3 * a] - poses.centre[3 * box];
        double dY = poses.centre[3 * a + 1] - poses.centre[3 * box + 1];
        double dZ = poses.centre[3 * a + 2] - poses.centre[3 * box + 2];
        double[] axes = poses.axes;
        for (int i = 0; i < 9; i++) {
            int own = Poses.AXES * a + 3 * (i / 3);
            int its = Poses.AXES * box + 3 * (i % 3);
            axesInBox[i] = axes[own] * axes[its] + axes[own + 1] * axes[its + 1] + axes[own + 2] * axes[its + 2];
        }
        int b = Poses.AXES * box;
        x = dX * axes[b] + dY * axes[b + 1] + dZ * axes[b + 2];
        y = dX * axes[b + 3] + dY * axes[b + 4] + dZ * axes[b + 5];
        z = dX * axes[b + 6] + dY * axes[b + 7] + dZ * axes[b + 8];
        inBox.turn(upright, axesInBox, 0);
        separation.measure(inBox, x, y, z, solid);
        if (separation.metres() > reach) {
            return;
        }
        collect(poses, a, axesInBox, 3, out);
        turnOut(axes, b, out);
    }

    private static void turnOut(double[] axes, int b, Manifold out) {
        double nX = out.nX;
        double nY = out.nY;
        double nZ = out.nZ;
        out.normal(
                nX * axes[b] + nY * axes[b + 3] + nZ * axes[b + 6],
                nX * axes[b + 1] + nY * axes[b + 4] + nZ * axes[b + 7],
                nX * axes[b + 2] + nY * axes[b + 5] + nZ * axes[b + 8]);
        for (int i = 0; i < out.count; i++) {
            double x = out.point[3 * i];
            double y = out.point[3 * i + 1];
            double z = out.point[3 * i + 2];
            for (int k = 0; k < 3; k++) {
                out.point[3 * i + k] = x * axes[b + k] + y * axes[b + 3 + k] + z * axes[b + 6 + k];
            }
        }
    }

    /**
     * Adds the points of the last measurement.
     *
     * @param axes array that has the direction of the capsule's axis from {@code at} on
     */
    private void collect(Poses poses, int a, double[] axes, int at, Manifold out) {
        double halfAxis = poses.half[3 * a + 1];
        radius = poses.half[3 * a + 2];
        uX = axes[at] * halfAxis;
        uY = axes[at + 1] * halfAxis;
        uZ = axes[at + 2] * halfAxis;
        out.normal(
                separation.normal().x(),
                separation.normal().y(),
                separation.normal().z());
        out.code = 1;
        double rise = uX * out.nX + uY * out.nY + uZ * out.nZ;
        if (halfAxis > 0) {
            // A capsule at a steep angle over a face has two ends too: the higher one may come down within the tick.
            boolean lies = Math.abs(rise) <= FLAT_SINE * halfAxis;
            ContactHull hull = solid.contactHull();
            int face = faceAlong(hull, lies ? FLAT_SINE * FLAT_SINE / 2 : ALONG, out);
            if (face >= 0 && flat(hull, face, out)) {
                return;
            }
        }
        double s = separation.metres() <= -radius ? -Math.signum(rise) : halfAxis > 0 ? nearestOnAxis() : 0;
        add(s, separation.metres(), 0, out);
    }

    /** Returns the position on the axis, −1 to 1 in half axes, nearest to the nearest point of the solid. */
    private double nearestOnAxis() {
        double pX = separation.onCollider(0) - solid.centre().x() - x;
        double pY = separation.onCollider(1) - solid.centre().y() - y;
        double pZ = separation.onCollider(2) - solid.centre().z() - z;
        double s = (pX * uX + pY * uY + pZ * uZ) / (uX * uX + uY * uY + uZ * uZ);
        return Math.max(-1, Math.min(1, s));
    }

    private static int faceAlong(ContactHull hull, double tolerance, Manifold out) {
        for (int face = 0; face < hull.faces(); face++) {
            if (alongNormal(hull, face, out) > 1 - tolerance) {
                return face;
            }
        }
        return -1;
    }

    private static double alongNormal(ContactHull hull, int face, Manifold out) {
        return hull.plane(face, 0) * out.nX + hull.plane(face, 1) * out.nY + hull.plane(face, 2) * out.nZ;
    }

    /** Adds both ends of the axis' part over a face, as far as they are near; returns false when there are none. */
    private boolean flat(ContactHull hull, int face, Manifold out) {
        double low = -1;
        double high = 1;
        for (int place = hull.ringStart(face); place < hull.ringStart(face + 1); place++) {
            double sX = hull.side(place, 0);
            double sY = hull.side(place, 1);
            double sZ = hull.side(place, 2);
            double slope = sX * uX + sY * uY + sZ * uZ;
            double room = hull.side(place, 3) - (sX * x + sY * y + sZ * z);
            if (Math.abs(slope) < 1e-12) {
                low = room < 0 ? 2 : low;
            } else if (slope > 0) {
                high = Math.min(high, room / slope);
            } else {
                low = Math.max(low, room / slope);
            }
        }
        if (!(low < high)) {
            return false;
        }
        double nX = hull.plane(face, 0);
        double nY = hull.plane(face, 1);
        double nZ = hull.plane(face, 2);
        double middle = nX * x + nY * y + nZ * z - hull.plane(face, 3) - radius;
        double rise = nX * uX + nY * uY + nZ * uZ;
        // An axis that descends beyond the face's edge touches the edge: the face's normal would lift it without cause.
        boolean onEdge = separation.metres() > -radius && alongNormal(hull, face, out) <= 1 - ALONG;
        if (!onEdge) {
            out.normal(nX, nY, nZ);
        }
        addEnd(low, middle + low * rise, onEdge && rise > 0, 1, out);
        addEnd(high, middle + high * rise, onEdge && rise <= 0, 2, out);
        return out.count > 0;
    }

    private void addEnd(double s, double metres, boolean isOnEdge, int id, Manifold out) {
        double gap = isOnEdge ? separation.metres() : metres;
        if (gap <= reach) {
            add(isOnEdge ? nearestOnAxis() : s, gap, id, out);
        }
    }

    private void add(double s, double metres, int id, Manifold out) {
        double back = radius + metres / 2;
        out.add(s * uX - back * out.nX, s * uY - back * out.nY, s * uZ - back * out.nZ, metres, id);
    }
}
