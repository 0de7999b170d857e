package nephele.engine.collision.rigid;

import nephele.engine.collision.Collider;
import nephele.engine.collision.ContactHull;
import nephele.engine.collision.RoundedHull;
import nephele.engine.collision.Separation;
import nephele.engine.math.Vec3;

/**
 * Contacts of spheres and capsules: with each other by the nearest points of their axes (Ericson, Real-Time Collision
 * Detection, 2005, section 5.1.9), with polyhedra by GJK. A capsule that lies flat on something has two points. Reused.
 */
final class RoundPair {
    /** Sine of the angle up to which a capsule lies flat. */
    private static final double FLAT = 0.05;

    /** One minus the cosine up to which two normals are one. */
    private static final double ALONG = 1e-9;

    private final Separation separation = new Separation();
    private final double[] axesInBox = new double[9];

    /** Two round shapes. */
    void touch(Poses poses, int a, int b, double reach, Manifold out) {
        out.clear();
        double dX = poses.centre[3 * b] - poses.centre[3 * a];
        double dY = poses.centre[3 * b + 1] - poses.centre[3 * a + 1];
        double dZ = poses.centre[3 * b + 2] - poses.centre[3 * a + 2];
        double[] x = poses.axes;
        int p = 9 * a + 3;
        int q = 9 * b + 3;
        double ha = poses.half[3 * a + 1];
        double hb = poses.half[3 * b + 1];
        double dot = x[p] * x[q] + x[p + 1] * x[q + 1] + x[p + 2] * x[q + 2];
        double onA = dX * x[p] + dY * x[p + 1] + dZ * x[p + 2];
        double onB = dX * x[q] + dY * x[q + 1] + dZ * x[q + 2];
        double radii = poses.half[3 * a + 2] + poses.half[3 * b + 2];
        double square = 1 - dot * dot;
        if (ha > 0 && hb > 0 && square < FLAT * FLAT) {
            double low = Math.max(-ha, onA - hb);
            double high = Math.min(ha, onA + hb);
            if (high - low > 0.1 * Math.min(ha, hb)) {
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
        int p = 9 * a + 3;
        int q = 9 * b + 3;
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

    /** A round shape and a static solid. */
    void touch(Poses poses, int a, RoundedHull shape, Collider solid, double reach, Manifold out) {
        out.clear();
        int c = 3 * a;
        separation.measure(shape, poses.centre[c], poses.centre[c + 1], poses.centre[c + 2], solid);
        if (separation.metres() > reach) {
            return;
        }
        Vec3 m = solid.centre();
        double x = poses.centre[c] - m.x();
        double y = poses.centre[c + 1] - m.y();
        double z = poses.centre[c + 2] - m.z();
        collect(poses.half[3 * a + 1], poses.half[3 * a + 2], poses.axes, 9 * a + 3, x, y, z, solid, reach, out);
    }

    /** A round shape and a moving box: measured in the frame of the box, for which {@code solid} stands. */
    void touchBox(
            Poses poses,
            int a,
            int box,
            RoundedHull inBox,
            RoundedHull upright,
            Collider solid,
            double reach,
            Manifold out) {
        out.clear();
        double dX = poses.centre[3 * a] - poses.centre[3 * box];
        double dY = poses.centre[3 * a + 1] - poses.centre[3 * box + 1];
        double dZ = poses.centre[3 * a + 2] - poses.centre[3 * box + 2];
        double[] axes = poses.axes;
        for (int i = 0; i < 9; i++) {
            int own = 9 * a + 3 * (i / 3);
            int its = 9 * box + 3 * (i % 3);
            axesInBox[i] = axes[own] * axes[its] + axes[own + 1] * axes[its + 1] + axes[own + 2] * axes[its + 2];
        }
        int b = 9 * box;
        double x = dX * axes[b] + dY * axes[b + 1] + dZ * axes[b + 2];
        double y = dX * axes[b + 3] + dY * axes[b + 4] + dZ * axes[b + 5];
        double z = dX * axes[b + 6] + dY * axes[b + 7] + dZ * axes[b + 8];
        inBox.turn(upright, axesInBox, 0);
        separation.measure(inBox, x, y, z, solid);
        if (separation.metres() > reach) {
            return;
        }
        collect(poses.half[3 * a + 1], poses.half[3 * a + 2], axesInBox, 3, x, y, z, solid, reach, out);
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

    /** The points of the last measurement; x, y, z is the shape's centre relative to the solid's. */
    private void collect(
            double halfAxis,
            double radius,
            double[] axes,
            int at,
            double x,
            double y,
            double z,
            Collider solid,
            double reach,
            Manifold out) {
        double nX = separation.normalX();
        double nY = separation.normalY();
        double nZ = separation.normalZ();
        out.normal(nX, nY, nZ);
        out.code = 1;
        double uX = axes[at] * halfAxis;
        double uY = axes[at + 1] * halfAxis;
        double uZ = axes[at + 2] * halfAxis;
        double rise = uX * nX + uY * nY + uZ * nZ;
        if (halfAxis > 0) {
            // However it stands over a face: the end that is higher now may come down within the tick.
            boolean lies = Math.abs(rise) <= FLAT * halfAxis;
            int face = faceAlong(solid.contactHull(), lies ? FLAT * FLAT / 2 : ALONG, nX, nY, nZ);
            if (face >= 0) {
                flat(solid.contactHull(), face, radius, uX, uY, uZ, x, y, z, reach, out);
                if (out.count > 0) {
                    return;
                }
            }
        }
        double s = 0;
        if (separation.metres() <= -radius) {
            s = -Math.signum(rise);
        } else if (halfAxis > 0) {
            s = nearestOnAxis(uX, uY, uZ, x, y, z, solid);
        }
        double back = radius + separation.metres() / 2;
        out.add(s * uX - back * nX, s * uY - back * nY, s * uZ - back * nZ, separation.metres(), 0);
    }

    /** Which share of the half axis, −1 to 1, is nearest to the nearest point of the solid. */
    private double nearestOnAxis(double uX, double uY, double uZ, double x, double y, double z, Collider solid) {
        double pX = separation.onCollider(0) - solid.centre().x() - x;
        double pY = separation.onCollider(1) - solid.centre().y() - y;
        double pZ = separation.onCollider(2) - solid.centre().z() - z;
        double s = (pX * uX + pY * uY + pZ * uZ) / (uX * uX + uY * uY + uZ * uZ);
        return Math.max(-1, Math.min(1, s));
    }

    private static int faceAlong(ContactHull hull, double tolerance, double nX, double nY, double nZ) {
        for (int face = 0; face < hull.faces(); face++) {
            if (hull.plane(face, 0) * nX + hull.plane(face, 1) * nY + hull.plane(face, 2) * nZ > 1 - tolerance) {
                return face;
            }
        }
        return -1;
    }

    /** Both ends of what of the axis lies over a face. */
    private static void flat(
            ContactHull hull,
            int face,
            double radius,
            double uX,
            double uY,
            double uZ,
            double x,
            double y,
            double z,
            double reach,
            Manifold out) {
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
            return;
        }
        double nX = hull.plane(face, 0);
        double nY = hull.plane(face, 1);
        double nZ = hull.plane(face, 2);
        out.normal(nX, nY, nZ);
        for (int end = 0; end < 2; end++) {
            double s = end == 0 ? low : high;
            double metres = nX * (x + s * uX) + nY * (y + s * uY) + nZ * (z + s * uZ) - hull.plane(face, 3) - radius;
            double back = radius + metres / 2;
            if (metres <= reach) {
                out.add(s * uX - back * nX, s * uY - back * nY, s * uZ - back * nZ, metres, 1 + end);
            }
        }
    }
}
