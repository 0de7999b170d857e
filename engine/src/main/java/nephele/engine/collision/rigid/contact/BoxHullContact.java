package nephele.engine.collision.rigid.contact;

import nephele.engine.collision.ContactHull;
import nephele.engine.collision.rigid.body.Poses;
import nephele.engine.math.Vec3;

/**
 * Contact of a box and a static convex solid of any shape: faces of both and all pairs of edges as separating axes
 * (Gottschalk, Lin and Manocha 1996), then face clipped against face, or one or two points between edges. Reused.
 */
final class BoxHullContact {
    /** Difference along an edge's normal below which two corners are both on the edge. */
    private static final double EDGE_METRES = 1e-7;

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
    private int hullCorner;
    /** Ends of the solid's edge, in metres from its corner. */
    private double hullFrom;

    private double hullTo;
    /** Distance of the crossing from the middle of the box's edge, metres. */
    private double onBox;

    BoxHullContact(FaceClip clip) {
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
        tolerance = FaceClip.tolerance(poses.leastHalf(box));
        out.clear();
        int faces = hull.faces();
        if (!hullFacesWithin(reach) || !boxFacesWithin(reach)) {
            return;
        }
        int face = bestFace(faces);
        if (!edgesWithin(reach)) {
            return;
        }
        if (edgeGap > faceGap[face] + FaceClip.edgeMargin(poses.leastHalf(box))) {
            edgePoints(reach, out);
            return;
        }
        double leastGap = faceGap[face] - poses.leastHalf(box) / 2;
        for (int attempt = 0; attempt < 3 && faceGap[face] > leastGap; attempt++) {
            if (face < faces ? onHullFace(face, reach, out) : onBoxFace(face - faces, reach, out)) {
                return;
            }
            faceGap[face] = Double.NEGATIVE_INFINITY;
            face = bestFace(faces);
        }
    }

    private double axis(int i, int component) {
        return poses.axes[Poses.AXES * box + 3 * i + component];
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

    /**
     * Finds the separations of the box's faces: two for each axis, the negative side first; false beyond {@code reach}.
     */
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

    /** Sets the solid's interval along an axis and returns the coordinate of the box's centre along it. */
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
                if (square < FaceClip.PARALLEL_SINE_SQUARED) {
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

    /** Adds the corners of the box's face that is most opposed to a direction. */
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

    /** @param side axis times two, plus one if the box is below the solid along it */
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

    /**
     * Adds the crossing of the box's deepest edge with the solid's, and that of its parallel neighbour if it is near
     * too: a face that rests on an edge then gets both ends of the overlap as contact points.
     */
    private void edgePoints(double reach, Manifold out) {
        out.normal(edgeX, edgeY, edgeZ);
        out.code = 166 + (3 * edgeOfHull + edgeOfBox) % 90;
        int first = (edgeOfBox + 1) % 3;
        int second = (edgeOfBox + 2) % 3;
        double rise1 = rise(first);
        double rise2 = rise(second);
        double h1 = rise1 > 0 ? -poses.half[3 * box + first] : poses.half[3 * box + first];
        double h2 = rise2 > 0 ? -poses.half[3 * box + second] : poses.half[3 * box + second];
        findHullEdge();
        addCrossing(first, h1, second, h2, edgeGap, out);
        boolean isFirst = Math.abs(rise1) < Math.abs(rise2);
        double gap = edgeGap + 2 * Math.min(Math.abs(rise1), Math.abs(rise2));
        if (gap < reach && findCrossing(first, isFirst ? -h1 : h1, second, isFirst ? h2 : -h2)) {
            addCrossing(first, isFirst ? -h1 : h1, second, isFirst ? h2 : -h2, gap, out);
        }
    }

    /** Returns the signed extent of half of the box along the normal, by one of its axes. */
    private double rise(int axis) {
        return poses.half[3 * box + axis] * (axis(axis, 0) * edgeX + axis(axis, 1) * edgeY + axis(axis, 2) * edgeZ);
    }

    /** Finds the corners of the solid farthest along the normal: its edge. */
    private void findHullEdge() {
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < hull.corners(); i++) {
            double dot = along(i);
            if (dot > most) {
                most = dot;
                hullCorner = i;
            }
        }
        hullFrom = 0;
        hullTo = 0;
        for (int i = 0; i < hull.corners(); i++) {
            if (along(i) > most - EDGE_METRES) {
                double at = 0;
                for (int c = 0; c < 3; c++) {
                    at += (hull.corner(i, c) - hull.corner(hullCorner, c)) * hull.edge(edgeOfHull, c);
                }
                hullFrom = Math.min(hullFrom, at);
                hullTo = Math.max(hullTo, at);
            }
        }
    }

    private double along(int corner) {
        return hull.corner(corner, 0) * edgeX + hull.corner(corner, 1) * edgeY + hull.corner(corner, 2) * edgeZ;
    }

    private void addCrossing(int first, double h1, int second, double h2, double gap, Manifold out) {
        findCrossing(first, h1, second, h2);
        double limit = poses.half[3 * box + edgeOfBox];
        double s = Math.max(-limit, Math.min(limit, onBox));
        double half = gap / 2;
        out.add(
                h1 * axis(first, 0) + h2 * axis(second, 0) + s * axis(edgeOfBox, 0) - half * edgeX,
                h1 * axis(first, 1) + h2 * axis(second, 1) + s * axis(edgeOfBox, 1) - half * edgeY,
                h1 * axis(first, 2) + h2 * axis(second, 2) + s * axis(edgeOfBox, 2) - half * edgeZ,
                gap,
                (h1 > 0 ? 1 : 0) + (h2 > 0 ? 2 : 0));
    }

    /** Finds the position on the box's edge, from its middle, of the crossing; returns true if it is on both edges. */
    private boolean findCrossing(int first, double h1, int second, double h2) {
        double dot = 0;
        double wBox = 0;
        double wHull = 0;
        for (int c = 0; c < 3; c++) {
            double to = c == 0 ? x : c == 1 ? y : z;
            double w = hull.corner(hullCorner, c) - to - h1 * axis(first, c) - h2 * axis(second, c);
            dot += axis(edgeOfBox, c) * hull.edge(edgeOfHull, c);
            wBox += w * axis(edgeOfBox, c);
            wHull += w * hull.edge(edgeOfHull, c);
        }
        onBox = (wBox - dot * wHull) / (1 - dot * dot);
        double onHull = dot * onBox - wHull;
        return Math.abs(onBox) < poses.half[3 * box + edgeOfBox] && onHull > hullFrom && onHull < hullTo;
    }
}
