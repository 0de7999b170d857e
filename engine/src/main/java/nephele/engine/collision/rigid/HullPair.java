package nephele.engine.collision.rigid;

import nephele.engine.collision.ContactHull;
import nephele.engine.math.Vec3;

/**
 * Contact of a box and a static convex solid of any shape: faces of both and all pairs of edges as separating axes
 * (Gottschalk, Lin and Manocha 1996), then face against face clipped, or one point between two edges. Reused.
 */
final class HullPair {
    private static final double PARALLEL_SQUARE = 1e-6;

    private final FaceClip clip;
    private final double[] faceGap = new double[512];
    private Poses poses;
    private int box;
    private ContactHull hull;
    /** The box's centre relative to the solid's. */
    private double x;

    private double y;
    private double z;
    private double tolerance;
    private double edgeGap;
    private double edgeX;
    private double edgeY;
    private double edgeZ;
    private int edgeOfBox;
    private int edgeOfHull;
    private double least;
    private double greatest;

    HullPair(FaceClip clip) {
        this.clip = clip;
    }

    /** Fills {@code out}, relative to the box's centre, with the points nearer than {@code reach}. */
    void touch(Poses where, int itsBox, ContactHull solid, Vec3 solidCentre, double reach, Manifold out) {
        poses = where;
        box = itsBox;
        hull = solid;
        x = poses.centre[3 * box] - solidCentre.x();
        y = poses.centre[3 * box + 1] - solidCentre.y();
        z = poses.centre[3 * box + 2] - solidCentre.z();
        tolerance = Math.min(1e-3, 0.02 * poses.leastHalf(box));
        out.clear();
        int faces = hull.faces();
        if (!hullFacesWithin(reach) || !boxFacesWithin(reach)) {
            return;
        }
        int face = bestFace(faces);
        if (!edgesWithin(reach)) {
            return;
        }
        if (edgeGap > faceGap[face] + tolerance) {
            edgePoint(out);
            return;
        }
        for (int attempt = 0; attempt < 3 && faceGap[face] > Double.NEGATIVE_INFINITY; attempt++) {
            if (face < faces ? onHullFace(face, reach, out) : onBoxFace(face - faces, reach, out)) {
                return;
            }
            faceGap[face] = Double.NEGATIVE_INFINITY;
            face = bestFace(faces);
        }
    }

    private double axis(int i, int component) {
        return poses.axes[9 * box + 3 * i + component];
    }

    private double radius(double nX, double nY, double nZ) {
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            sum += poses.half[3 * box + i] * Math.abs(nX * axis(i, 0) + nY * axis(i, 1) + nZ * axis(i, 2));
        }
        return sum;
    }

    private boolean hullFacesWithin(double reach) {
        for (int face = 0; face < hull.faces(); face++) {
            double nX = hull.plane(face, 0);
            double nY = hull.plane(face, 1);
            double nZ = hull.plane(face, 2);
            double gap = nX * x + nY * y + nZ * z - hull.plane(face, 3) - radius(nX, nY, nZ);
            faceGap[face] = gap;
            if (gap > reach) {
                return false;
            }
        }
        return true;
    }

    /** Faces of the box that look at the solid: two a axis, the negative side first. */
    private boolean boxFacesWithin(double reach) {
        for (int i = 0; i < 3; i++) {
            double middle = project(axis(i, 0), axis(i, 1), axis(i, 2));
            double h = poses.half[3 * box + i];
            int at = hull.faces() + 2 * i;
            faceGap[at] = middle - h - greatest;
            faceGap[at + 1] = least - middle - h;
            if (Math.max(faceGap[at], faceGap[at + 1]) > reach) {
                return false;
            }
        }
        return true;
    }

    /** Sets the solid's range along an axis and returns the place of the box's centre on it. */
    private double project(double nX, double nY, double nZ) {
        least = Double.POSITIVE_INFINITY;
        greatest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < hull.corners(); i++) {
            double dot = nX * hull.corner(i, 0) + nY * hull.corner(i, 1) + nZ * hull.corner(i, 2);
            least = Math.min(least, dot);
            greatest = Math.max(greatest, dot);
        }
        return nX * x + nY * y + nZ * z;
    }

    private int bestFace(int faces) {
        int best = 0;
        for (int i = 1; i < faces + 6; i++) {
            best = faceGap[i] > faceGap[best] + (i < faces ? tolerance / 8 : tolerance) ? i : best;
        }
        return best;
    }

    private boolean edgesWithin(double reach) {
        edgeGap = Double.NEGATIVE_INFINITY;
        for (int e = 0; e < hull.edges(); e++) {
            for (int i = 0; i < 3; i++) {
                double nX = axis(i, 1) * hull.edge(e, 2) - axis(i, 2) * hull.edge(e, 1);
                double nY = axis(i, 2) * hull.edge(e, 0) - axis(i, 0) * hull.edge(e, 2);
                double nZ = axis(i, 0) * hull.edge(e, 1) - axis(i, 1) * hull.edge(e, 0);
                double square = nX * nX + nY * nY + nZ * nZ;
                if (square < PARALLEL_SQUARE) {
                    continue;
                }
                double length = Math.sqrt(square);
                nX /= length;
                nY /= length;
                nZ /= length;
                double middle = project(nX, nY, nZ);
                double r = radius(nX, nY, nZ);
                double above = middle - r - greatest;
                double below = least - middle - r;
                double gap = Math.max(above, below);
                if (gap > reach) {
                    return false;
                }
                if (gap > edgeGap + tolerance / 8) {
                    keepEdge(gap, above > below ? 1 : -1, e, i, nX, nY, nZ);
                }
            }
        }
        return true;
    }

    private void keepEdge(double gap, int sign, int ofHull, int ofBox, double nX, double nY, double nZ) {
        edgeGap = gap;
        edgeX = sign * nX;
        edgeY = sign * nY;
        edgeZ = sign * nZ;
        edgeOfHull = ofHull;
        edgeOfBox = ofBox;
    }

    private boolean onHullFace(int face, double reach, Manifold out) {
        double nX = hull.plane(face, 0);
        double nY = hull.plane(face, 1);
        double nZ = hull.plane(face, 2);
        clip.start(tolerance);
        addBoxFace(nX, nY, nZ);
        double back = nX * x + nY * y + nZ * z;
        for (int place = hull.ringStart(face); place < hull.ringStart(face + 1); place++) {
            double sX = hull.side(place, 0);
            double sY = hull.side(place, 1);
            double sZ = hull.side(place, 2);
            double distance = hull.side(place, 3) - (sX * x + sY * y + sZ * z);
            clip.side(sX, sY, sZ, distance, place);
        }
        if (clip.isSliver()) {
            return false;
        }
        out.code = 32 + (face & 0x7f);
        out.normal(nX, nY, nZ);
        clip.keep(nX, nY, nZ, hull.plane(face, 3) - back, reach, out);
        return true;
    }

    /** The corners of the box's face that looks most against a direction. */
    private void addBoxFace(double nX, double nY, double nZ) {
        int j = 0;
        double most = -1;
        for (int i = 0; i < 3; i++) {
            double dot = Math.abs(axis(i, 0) * nX + axis(i, 1) * nY + axis(i, 2) * nZ);
            if (dot > most + 1e-9) {
                most = dot;
                j = i;
            }
        }
        double sign = axis(j, 0) * nX + axis(j, 1) * nY + axis(j, 2) * nZ > 0 ? -1 : 1;
        int u = (j + 1) % 3;
        int v = (j + 2) % 3;
        double h = sign * poses.half[3 * box + j];
        int id = sign > 0 ? 0 : 4;
        for (int k = 0; k < 4; k++) {
            double su = k == 0 || k == 3 ? poses.half[3 * box + u] : -poses.half[3 * box + u];
            double sv = k < 2 ? poses.half[3 * box + v] : -poses.half[3 * box + v];
            clip.corner(
                    h * axis(j, 0) + su * axis(u, 0) + sv * axis(v, 0),
                    h * axis(j, 1) + su * axis(u, 1) + sv * axis(v, 1),
                    h * axis(j, 2) + su * axis(u, 2) + sv * axis(v, 2),
                    id + k);
        }
    }

    /** @param side axis times two, plus one where the box lies below the solid along it */
    private boolean onBoxFace(int side, double reach, Manifold out) {
        int i = side / 2;
        double sign = side % 2 == 0 ? -1 : 1;
        // From the box to the solid.
        double nX = sign * axis(i, 0);
        double nY = sign * axis(i, 1);
        double nZ = sign * axis(i, 2);
        clip.start(tolerance);
        addHullFace(nX, nY, nZ);
        for (int k = 1; k < 3; k++) {
            int other = (i + k) % 3;
            double h = poses.half[3 * box + other];
            clip.side(axis(other, 0), axis(other, 1), axis(other, 2), h, 2 * k);
            clip.side(-axis(other, 0), -axis(other, 1), -axis(other, 2), h, 2 * k + 1);
        }
        if (clip.isSliver()) {
            return false;
        }
        out.code = 160 + side;
        out.normal(-nX, -nY, -nZ);
        clip.keep(nX, nY, nZ, poses.half[3 * box + i], reach, out);
        return true;
    }

    private void addHullFace(double nX, double nY, double nZ) {
        int best = 0;
        double most = Double.POSITIVE_INFINITY;
        for (int face = 0; face < hull.faces(); face++) {
            double dot = hull.plane(face, 0) * nX + hull.plane(face, 1) * nY + hull.plane(face, 2) * nZ;
            if (dot < most - 1e-9) {
                most = dot;
                best = face;
            }
        }
        for (int place = hull.ringStart(best); place < hull.ringStart(best + 1); place++) {
            int corner = hull.ring(place);
            clip.corner(hull.corner(corner, 0) - x, hull.corner(corner, 1) - y, hull.corner(corner, 2) - z, corner);
        }
    }

    /** The middle of the box's edge that lies deepest; exact along the normal, which is what counts. */
    private void edgePoint(Manifold out) {
        double pX = 0;
        double pY = 0;
        double pZ = 0;
        for (int k = 1; k < 3; k++) {
            int other = (edgeOfBox + k) % 3;
            double h = poses.half[3 * box + other];
            h = axis(other, 0) * edgeX + axis(other, 1) * edgeY + axis(other, 2) * edgeZ > 0 ? -h : h;
            pX += h * axis(other, 0);
            pY += h * axis(other, 1);
            pZ += h * axis(other, 2);
        }
        double s = alongBoxEdge(pX, pY, pZ);
        double half = edgeGap / 2;
        out.normal(edgeX, edgeY, edgeZ);
        out.code = 166 + (3 * edgeOfHull + edgeOfBox) % 90;
        out.add(
                pX + s * axis(edgeOfBox, 0) - half * edgeX,
                pY + s * axis(edgeOfBox, 1) - half * edgeY,
                pZ + s * axis(edgeOfBox, 2) - half * edgeZ,
                edgeGap,
                0);
    }

    /** Where on the box's edge, from its middle, the solid's nearest edge crosses. */
    private double alongBoxEdge(double pX, double pY, double pZ) {
        int corner = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < hull.corners(); i++) {
            double dot = hull.corner(i, 0) * edgeX + hull.corner(i, 1) * edgeY + hull.corner(i, 2) * edgeZ;
            if (dot > most) {
                most = dot;
                corner = i;
            }
        }
        double wX = hull.corner(corner, 0) - x - pX;
        double wY = hull.corner(corner, 1) - y - pY;
        double wZ = hull.corner(corner, 2) - z - pZ;
        double dot = 0;
        double onBox = 0;
        double onHull = 0;
        for (int c = 0; c < 3; c++) {
            double w = c == 0 ? wX : c == 1 ? wY : wZ;
            dot += axis(edgeOfBox, c) * hull.edge(edgeOfHull, c);
            onBox += w * axis(edgeOfBox, c);
            onHull += w * hull.edge(edgeOfHull, c);
        }
        double limit = poses.half[3 * box + edgeOfBox];
        return Math.max(-limit, Math.min(limit, (onBox - dot * onHull) / (1 - dot * dot)));
    }
}
